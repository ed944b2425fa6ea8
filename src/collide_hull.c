/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The collide calls for hulls, or circles where the hull is NULL; with and without a report. */
#include "inner.h"

uint16_t tuff_terrain_collide_report(const tuff_world *world, tuff_body *body, tuff_real radius, const tuff_polygon *hull,
                                     tuff_touches *touches)
{
    tuff_unit2 scratch[TUFF_MAX_VERTICES];
    tuff_collision call;
    tuff_mover mover;
    bool usable = tuff_is_hull(hull) ? tuff_hull_mover(&mover, radius, hull, scratch) : tuff_circle_shape(&mover.shape, radius);
    if (touches != NULL) touches->count = 0;
    if (!usable) return 0;
    call.shape = &mover.shape;
    tuff_collide(&call, world, body, touches);
    return call.pushes;
}

uint16_t tuff_terrain_collide(const tuff_world *world, tuff_body *body, tuff_real radius, const tuff_polygon *hull)
{
    if (hull == NULL) return tuff_terrain_collide_circle(world, body, radius);
    return tuff_terrain_collide_report(world, body, radius, hull, NULL);
}

uint16_t tuff_floater_collide_report(tuff_body *body, tuff_real radius, const tuff_terrain *floaters, uint16_t count,
                                     const tuff_polygon *hull, uint8_t order, tuff_touches *touches)
{
    tuff_world world = { floaters, count, NULL, NULL, 0, order };
    return tuff_terrain_collide_report(&world, body, radius, hull, touches);
}

uint16_t tuff_floater_collide(tuff_body *body, tuff_real radius, const tuff_terrain *floaters, uint16_t count,
                              const tuff_polygon *hull)
{
    tuff_world world = { floaters, count, NULL, NULL, 0, TUFF_ORDER_ITERATION };
    return tuff_terrain_collide(&world, body, radius, hull);
}
