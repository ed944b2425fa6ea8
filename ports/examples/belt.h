/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What all the examples share: three rocks that tools/shapes made of a picture, and a step of the ship among them. A game puts its own
   shapes here; what differs from console to console is in the folders. */
#ifndef BELT_H
#define BELT_H

#include <tuff/tuff.h>
#include "rocks/small.h"

static const tuff_terrain belt[] = {
    SMALL_ROCKS_0_AT(TUFF_WHOLE(60), TUFF_WHOLE(40)),
    SMALL_ROCKS_1_AT(TUFF_WHOLE(150), TUFF_WHOLE(70)),
    SMALL_ROCKS_2_AT(TUFF_WHOLE(90), TUFF_WHOLE(120))
};
static const tuff_world world = { belt, 3, NULL, NULL, 0, TUFF_ORDER_ITERATION };
static tuff_body ship = { { TUFF_WHOLE(20), TUFF_WHOLE(20) }, { 0, 0 }, NULL };

static inline void fly(tuff_real thrust_x, tuff_real thrust_y)
{
    ship.velocity.x += thrust_x;
    ship.velocity.y += thrust_y;
    ship.position.x += ship.velocity.x;
    ship.position.y += ship.velocity.y;
    tuff_terrain_collide_circle(&world, &ship, TUFF_WHOLE(6));
}

#endif
