/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Mega Drive with SGDK: speeds as fix16, Q10.6; fix32 is Q22.10. */
#include <genesis.h>
#include "resources.h"
#include "belt.h"

static tuff_real thrust_of(u16 keys, u16 plus, u16 minus)
{
    const fix16 thrust = FIX16(0.0625);
    return tuff_from_q10_6(((keys & plus) ? thrust : 0) - ((keys & minus) ? thrust : 0));
}

int main(bool hardReset)
{
    SPR_init();
    Sprite *sprite = SPR_addSprite(&ship_sprite, 0, 0, TILE_ATTR(PAL0, TRUE, FALSE, FALSE));
    while (TRUE) {
        u16 keys = JOY_readJoypad(JOY_1);
        fly(thrust_of(keys, BUTTON_RIGHT, BUTTON_LEFT), thrust_of(keys, BUTTON_DOWN, BUTTON_UP));
        SPR_setPosition(sprite, F32_toInt(tuff_to_q22_10(ship.position.x)), F32_toInt(tuff_to_q22_10(ship.position.y)));
        SPR_update();
        SYS_doVBlankProcess();
    }
    return hardReset;
}
