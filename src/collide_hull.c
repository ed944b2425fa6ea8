/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The collide calls for hulls, or circles where the hull is NULL; with and without a report. */
#include "inner.h"

uint16_t tuff_terrain_collide_report(const tuff_world *world, tuff_body *body, tuff_real radius, const tuff_polygon *hull,
                                     tuff_touches *touches)
{
    tuff_unit2 scratch[TUFF_MAX_VERTICES];
    tuff_mover mover;
    bool usable = tuff_is_hull(hull) ? tuff_hull_mover(&mover, radius, hull, scratch) : tuff_circle_mover(&mover, radius);
    if (!usable && touches != NULL) touches->count = 0;
    return usable ? tuff_collide(world, body, &mover, touches) : 0;
}

uint16_t tuff_terrain_collide(const tuff_world *world, tuff_body *body, tuff_real radius, const tuff_polygon *hull)
{
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
    return tuff_floater_collide_report(body, radius, floaters, count, hull, TUFF_ORDER_ITERATION, NULL);
}
