/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The palette: the scene's colors, and mixtures for marks that let through what is below. What is below is taken to be space, or the rock
   that a lit facet lies on. */
#include "hardware.h"
#include "paint.h"

static uint8_t below(uint8_t color)
{
    switch (color) {
    case SCENE_COLOR_ROCK_LIT:
    case SCENE_COLOR_CONCAVE_LIT:
    case SCENE_COLOR_VOLATILE_LIT:
    case SCENE_COLOR_FLOATER_LIT: return (uint8_t)(color - 1);
    default: return SCENE_COLOR_SPACE;
    }
}

static uint32_t mixed(uint32_t under, uint32_t over, unsigned parts)
{
    uint32_t color = 0;
    for (unsigned shift = 0; shift < 24; shift += 8) {
        color |= ((under >> shift & 255) * (SCENE_SOLID - parts) + (over >> shift & 255) * parts) / SCENE_SOLID << shift;
    }
    return color;
}

void paint_colors(void)
{
    for (unsigned color = 0; color < SCENE_COLORS; color++) {
        uint32_t under = scene_palette[below((uint8_t)color)];
        COLORS[color] = screen_color(scene_palette[color]);
        for (unsigned k = 1; k <= PAINT_MIXTURES; k++) {
            COLORS[color + k * SCENE_COLORS] = screen_color(mixed(under, scene_palette[color], 3 * k));
        }
    }
}
