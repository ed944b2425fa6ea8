/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   From tuff's numbers to Box2D's. */
#include "handed.h"

yardstick_vec yard_vec(tuff_vec2 v)
{
    return (yardstick_vec){ units_of(v.x), units_of(v.y) };
}

yardstick_state yard_state(const tuff_body *body)
{
    return (yardstick_state){ yard_vec(body->position), yard_vec(body->velocity) };
}

static void corners_of(const tuff_polygon *polygon, yardstick_vec *corners)
{
    for (int i = 0; i < polygon->count; i++) corners[i] = yard_vec(polygon->vertices[i]);
}

bool yard_add_piece(yardstick *yard, const tuff_terrain *piece)
{
    yardstick_vec corners[TUFF_MAX_VERTICES];
    for (int i = 0; i < piece->part_count; i++) {
        corners_of(&piece->parts[i], corners);
        if (!yardstick_add_polygon(yard, yard_vec(piece->position), corners, piece->parts[i].count, 0.0)) return false;
    }
    return true;
}

int yard_add_hull(yardstick *yard, yardstick_state state, const tuff_polygon *hull, yardstick_material material)
{
    yardstick_vec corners[TUFF_MAX_VERTICES];
    corners_of(hull, corners);
    return yardstick_add_hull(yard, state, corners, hull->count, material);
}

box2d_polygon *box2d_of(const tuff_polygon *polygon)
{
    box2d_vec corners[TUFF_MAX_VERTICES];
    for (int i = 0; i < polygon->count; i++) corners[i] = twin_vec(polygon->vertices[i]);
    return box2d_polygon_new(corners, polygon->count);
}
