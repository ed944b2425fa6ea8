/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Fill the index from the terrain array. */
#include "inner.h"

uint16_t tuff_world_index(tuff_world *world)
{
    uint16_t left_out = 0;
    uint16_t i;
    if (world == NULL || world->terrain == NULL || world->chunks == NULL) return 0;
    tuff_chunks_clear(world->chunks);
    for (i = 0; i < world->terrain_count; ++i) {
        if (!tuff_chunks_insert(world->chunks, i, world->terrain[i].position, world->terrain[i].bounding_radius)) ++left_out;
    }
    return left_out;
}
