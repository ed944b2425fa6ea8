/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Beams through the world: is anything in between? */
#include "inner.h"

/* Do both ends lie beyond the same side of the square about the bounding circle? */
static bool clear_of_bounds(const tuff_beam *beam, tuff_real bounding_radius)
{
    const tuff_far reach = (tuff_far)bounding_radius;
    return (beam->a.x > reach && beam->b.x > reach) || (beam->a.x < -reach && beam->b.x < -reach) ||
           (beam->a.y > reach && beam->b.y > reach) || (beam->a.y < -reach && beam->b.y < -reach);
}

bool tuff_beam_touches_piece(const tuff_terrain *piece, tuff_vec2 a, tuff_vec2 b, tuff_beam *beam)
{
    uint8_t i;
    if (!tuff_is_piece(piece)) return false;
    *beam = tuff_beam_relative(a, b, piece->position);
    if (clear_of_bounds(beam, piece->bounding_radius)) return false;
    if (!tuff_piece_baked(piece)) {
        return tuff_in_range(piece->radius, TUFF_MAX_BOUNDING_RADIUS) && tuff_beam_touches_circle(beam, tuff_flush(piece->radius));
    }
    for (i = 0; i < piece->part_count; ++i) {
        if (tuff_beam_touches_part(beam, &piece->parts[i])) return true;
    }
    return false;
}

bool tuff_segment_terrain_intersect(const tuff_world *world, tuff_vec2 a, tuff_vec2 b)
{
    uint16_t piece;
    tuff_beam beam;
    tuff_walk walk;
    TUFF_ASSERT(world != NULL);
    if (world == NULL || world->terrain == NULL || !tuff_beam_ends_ok(a, b)) return false;
    tuff_walk_line(&walk, world, a, b);
    while ((piece = tuff_walk_next(&walk)) != TUFF_NO_PIECE) {
        if (tuff_beam_touches_piece(&world->terrain[piece], a, b, &beam)) return true;
    }
    return false;
}
