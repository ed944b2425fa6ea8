/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   How many steps a motion needs so that no body jumps over a piece, and how thick shapes are. The derivation is in world.h. */
#include "inner.h"

/* The longest step that is safe. */
static tuff_real safe_step(tuff_real radius, tuff_real thickness)
{
    tuff_real inward = thickness / 2 - TUFF_STEP_MARGIN;
    return radius + (inward > 0 ? inward : 0);
}

uint16_t tuff_substeps(tuff_vec2 motion, tuff_real radius, tuff_real thickness)
{
    uint16_t too_few = 0;
    uint16_t bit;
    bool known = tuff_in_range(radius, TUFF_MAX_BOUNDING_RADIUS) && tuff_in_range(thickness, 2 * TUFF_MAX_BOUNDING_RADIUS);
    TUFF_ASSERT(known && tuff_position_ok(motion));
    if (!known || !tuff_position_ok(motion)) return 1;
    tuff_real step = safe_step(tuff_flush(radius), tuff_flush(thickness));
    tuff_vec2 way = tuff_vec2_flush(motion);
    if (tuff_steps_cover(way, step, 1)) return 1;
    /* The largest number that is too few, bit by bit: no division, no square root. */
    for (bit = 0x8000; bit != 0; bit = (uint16_t)(bit >> 1)) {
        uint16_t more = (uint16_t)(too_few | bit);
        if (!tuff_steps_cover(way, step, more)) too_few = more;
    }
    return (uint16_t)(too_few < 65535u ? too_few + 1u : too_few);
}

/* The mean of the vertices, which is inside: within 32 * 1024 units before it is divided. */
static tuff_vec2 middle_of(const tuff_polygon *polygon)
{
    tuff_area x = 0;
    tuff_area y = 0;
    tuff_vec2 middle;
    uint8_t i;
    for (i = 0; i < polygon->count; ++i) {
        tuff_vec2 v = tuff_vec2_flush(polygon->vertices[i]);
        x += v.x;
        y += v.y;
    }
    middle.x = (tuff_real)(x / polygon->count);
    middle.y = (tuff_real)(y / polygon->count);
    return tuff_vec2_flush(middle);
}

tuff_real tuff_polygon_thickness(const tuff_polygon *polygon)
{
    tuff_wide least = -1;
    uint8_t i;
    TUFF_ASSERT(tuff_is_hull(polygon));
    if (!tuff_is_hull(polygon)) return 0;
    tuff_vec2 middle = middle_of(polygon);
    for (i = 0; i < polygon->count; ++i) {
        tuff_vec2 from = polygon->vertices[i];
        tuff_vec2 right = tuff_right_of(from, polygon->vertices[tuff_next_index(i, polygon->count)]);
        tuff_unit2 normal = { TUFF_UNIT_ONE, 0 };
        if (tuff_normalize(right, &normal) == 0) continue;
        tuff_wide beyond = tuff_reach(normal, tuff_vec2_gap(middle, from));
        if (beyond < 0) beyond = -beyond;
        if (least < 0 || beyond < least) least = beyond;
    }
    return least > 0 ? tuff_narrow(least + least) : 0;
}
