/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Game Boy Advance with libtonc: positions as its FIXED, Q24.8. */
#include <tonc.h>
#include "belt.h"

int main(void)
{
    const FIXED thrust = float2fx(0.0625f);
    irq_init(NULL);
    irq_add(II_VBLANK, NULL);
    REG_DISPCNT = DCNT_MODE0 | DCNT_OBJ;
    while (1) {
        VBlankIntrWait();
        key_poll();
        fly(tuff_from_q24_8(key_tri_horz() * thrust), tuff_from_q24_8(key_tri_vert() * thrust));
        obj_set_pos(&oam_mem[0], fx2int(tuff_to_q24_8(ship.position.x)), fx2int(tuff_to_q24_8(ship.position.y)));
    }
}
