/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Which pieces are near a point? */
#include "inner.h"

typedef struct nearby { tuff_search search; tuff_world *world; uint16_t needed; } nearby;

static bool note(tuff_search *search, uint16_t piece)
{
    nearby *found = (nearby *)search;
    const tuff_terrain *terrain = &search->world->terrain[piece];
    if (!tuff_is_piece(terrain)) return true;
    if (!tuff_circles_touch(search->center, search->radius, terrain->position, terrain->bounding_radius)) return true;
    if (found->world->nearby != NULL && found->needed < found->world->nearby_capacity) found->world->nearby[found->needed] = piece;
    ++found->needed;
    return true;
}

uint16_t tuff_nearby_terrain(tuff_world *world, tuff_vec2 center, tuff_real radius)
{
    nearby found;
    TUFF_ASSERT(world != NULL);
    if (world == NULL || world->terrain == NULL || !tuff_position_ok(center)) return 0;
    if (!(radius >= TUFF_WHOLE(0)) || !tuff_number_ok(radius)) return 0;
    found.search.world = found.world = world;
    found.search.visit = note;
    found.search.center = tuff_vec2_flush(center);
    found.search.radius = radius;
    found.needed = 0;
    tuff_walk_box(&found.search, false);
    return found.needed;
}
