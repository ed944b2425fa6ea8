/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Nintendo DS with BlocksDS: numbers as libnds has them, Q20.12. */
#include <nds.h>
#include "belt.h"

static tuff_real thrust_of(uint32_t keys, uint32_t plus, uint32_t minus)
{
    const int32_t thrust = inttof32(1) / 16;
    return tuff_from_q20_12(((keys & plus) ? thrust : 0) - ((keys & minus) ? thrust : 0));
}

int main(void)
{
    oamInit(&oamMain, SpriteMapping_1D_32, false);
    while (1) {
        swiWaitForVBlank();
        oamUpdate(&oamMain);
        scanKeys();
        fly(thrust_of(keysHeld(), KEY_RIGHT, KEY_LEFT), thrust_of(keysHeld(), KEY_DOWN, KEY_UP));
        oamSetXY(&oamMain, 0, f32toint(tuff_to_q20_12(ship.position.x)), f32toint(tuff_to_q20_12(ship.position.y)));
    }
}
