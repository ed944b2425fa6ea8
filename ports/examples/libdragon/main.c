/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Nintendo 64 with libdragon: the float build; the stick gives about -85 .. 85, y upwards. */
#include <libdragon.h>
#include "belt.h"

int main(void)
{
    display_init(RESOLUTION_320x240, DEPTH_16_BPP, 2, GAMMA_NONE, FILTERS_RESAMPLE);
    joypad_init();
    while (1) {
        joypad_poll();
        joypad_inputs_t pad = joypad_get_inputs(JOYPAD_PORT_1);
        fly((float)pad.stick_x / 1024.0f, (float)-pad.stick_y / 1024.0f);
        surface_t *screen = display_get();
        graphics_fill_screen(screen, 0);
        graphics_draw_box(screen, (int)ship.position.x - 6, (int)ship.position.y - 6, 12, 12, 0xFFFFFFFFu);
        display_show(screen);
    }
}
