/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The collide calls for circles: they link no hull code. */
#include "inner.h"

uint16_t tuff_terrain_collide_circle(const tuff_world *world, tuff_body *body, tuff_real radius)
{
    tuff_collision call;
    tuff_shape shape;
    if (!tuff_circle_shape(&shape, radius)) return 0;
    call.shape = &shape;
    tuff_collide(&call, world, body, NULL);
    return call.pushes;
}

uint16_t tuff_floater_collide_circle(tuff_body *body, tuff_real radius, const tuff_terrain *floaters, uint16_t count)
{
    tuff_world world = { floaters, count, NULL, NULL, 0, TUFF_ORDER_ITERATION };
    return tuff_terrain_collide_circle(&world, body, radius);
}
