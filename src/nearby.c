/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Which pieces are near a point? */
#include "inner.h"

uint16_t tuff_nearby_terrain(tuff_world *world, tuff_vec2 center, tuff_real radius)
{
    uint16_t needed = 0;
    uint16_t piece;
    tuff_walk walk;
    TUFF_ASSERT(world != NULL);
    if (world == NULL || world->terrain == NULL || !tuff_position_ok(center)) return 0;
    if (!(radius >= TUFF_WHOLE(0)) || !tuff_number_ok(radius)) return 0;
    tuff_walk_box(&walk, world, center, radius, false);
    while ((piece = tuff_walk_next(&walk)) != TUFF_NO_PIECE) {
        const tuff_terrain *terrain = &world->terrain[piece];
        if (!tuff_is_piece(terrain)) continue;
        if (!tuff_circles_touch(tuff_vec2_flush(center), radius, terrain->position, terrain->bounding_radius)) continue;
        if (world->nearby != NULL && needed < world->nearby_capacity) world->nearby[needed] = piece;
        ++needed;
    }
    return needed;
}
