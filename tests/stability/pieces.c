/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Pieces, worlds and bodies of the families' scenes. */
#include "pieces.h"

double grid_floor(double units)
{
    return floor(units * GRID) / GRID;
}

static double grid_nearest(double units)
{
    return floor(units * GRID + 0.5) / GRID;
}

tuff_vec2 grid_point(double x, double y)
{
    return random_point_at(grid_nearest(x), grid_nearest(y));
}

tuff_terrain convex_piece(const random_shape *shape, tuff_vec2 at)
{
    return (tuff_terrain){ at, 0, shape->bounding_radius, &shape->polygon, 1 };
}

tuff_world plain_world(const tuff_terrain *pieces, uint16_t count, uint8_t order)
{
    return (tuff_world){ pieces, count, NULL, NULL, 0, order };
}

tuff_body body_at(tuff_vec2 position)
{
    return (tuff_body){ position, { 0, 0 }, NULL };
}

void body_fall(tuff_body *body, tuff_vec2 gravity)
{
    body->velocity = (tuff_vec2){ body->velocity.x + gravity.x, body->velocity.y + gravity.y };
    body->position = (tuff_vec2){ body->position.x + body->velocity.x, body->position.y + body->velocity.y };
}

double units_apart(tuff_vec2 a, tuff_vec2 b)
{
    return hypot(units_of(a.x) - units_of(b.x), units_of(a.y) - units_of(b.y));
}

double body_speed(const tuff_body *body)
{
    return hypot(units_of(body->velocity.x), units_of(body->velocity.y));
}

double percent(unsigned long part, unsigned long whole)
{
    return whole ? 100.0 * (double)part / (double)whole : 0;
}
