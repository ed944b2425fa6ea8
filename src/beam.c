/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Beams through the world: is anything in between? */
#include "inner.h"

static bool both_beyond(tuff_real a, tuff_real b, tuff_real reach)
{
    return (a > reach && b > reach) || (a < -reach && b < -reach);
}

/* Do both ends lie beyond the same side of the square about the bounding circle? Of ends too far to tell so: no. */
static bool clear_of_bounds(const tuff_beam *beam, tuff_real reach)
{
    tuff_vec2 a, b;
    if (!tuff_far_narrow(beam->a, &a) || !tuff_far_narrow(beam->b, &b)) return false;
    return both_beyond(a.x, b.x, reach) || both_beyond(a.y, b.y, reach);
}

TUFF_HOT bool tuff_beam_aim(tuff_beam *beam, const tuff_terrain *piece, const tuff_vec2 *a, const tuff_vec2 *b)
{
    if (!tuff_is_piece(piece)) return false;
    tuff_beam_relative(beam, *a, *b, piece->position);
    return !clear_of_bounds(beam, piece->bounding_radius);
}

bool tuff_beam_touches_piece(const tuff_beam *beam, const tuff_terrain *piece)
{
    if (tuff_has_outline(piece)) return tuff_beam_touches_parts(beam, piece->parts, piece->part_count);
    return tuff_in_range(piece->radius, TUFF_MAX_BOUNDING_RADIUS) && tuff_beam_touches_circle(beam, tuff_flush(piece->radius));
}

typedef struct sight { tuff_line_search walk; tuff_beam beam; tuff_vec2 a, b; bool blocked; } sight;

static bool look(tuff_search *search, uint16_t piece)
{
    sight *beyond = (sight *)search;
    const tuff_terrain *terrain = &search->world->terrain[piece];
    beyond->blocked = tuff_beam_aim(&beyond->beam, terrain, &beyond->a, &beyond->b) && tuff_beam_touches_piece(&beyond->beam, terrain);
    return !beyond->blocked;
}

bool tuff_segment_terrain_intersect(const tuff_world *world, tuff_vec2 a, tuff_vec2 b)
{
    sight beyond;
    TUFF_ASSERT(world != NULL);
    if (world == NULL || world->terrain == NULL || !tuff_beam_ends_ok(a, b)) return false;
    beyond.walk.visit = look;
    beyond.a = tuff_vec2_flush(a);
    beyond.b = tuff_vec2_flush(b);
    beyond.beam.d = tuff_far_sub(beyond.b, beyond.a);
    beyond.blocked = false;
    tuff_walk_line(&beyond.walk, world, a, b);
    return beyond.blocked;
}
