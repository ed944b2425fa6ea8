/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The search for the best axis with few branches. Only polygon_polygon.c includes this. All vertices are asked and nothing branches
   on a projection: which way it would go is as good as random, and a wrong guess costs a CPU that guesses more than all vertices of
   a small polygon do. */

static inline tuff_wide tuff_lesser(tuff_wide a, tuff_wide b)
{
    return b < a ? b : a;
}

/* How far the nearest vertex of the other polygon, at this offset, lies beyond an edge. */
static inline tuff_wide tuff_separation_by(const tuff_polygon *asked, uint32_t edge, const tuff_polygon *other, tuff_vec2 offset)
{
    const tuff_vec2 *v = other->vertices;
    const tuff_unit2 n = asked->normals[edge];
    tuff_wide least = tuff_lesser(tuff_lesser(tuff_project(n, v[0]), tuff_project(n, v[1])), tuff_project(n, v[2]));
    uint32_t i;
    for (i = 3; i < other->count; ++i) least = tuff_lesser(least, tuff_project(n, v[i]));
    return tuff_wide_add(least, tuff_beyond_edge(asked, edge, offset));
}

static inline tuff_axis tuff_better(tuff_axis best, tuff_wide separation, uint32_t number)
{
    best.number = separation > best.separation ? number : best.number;
    best.separation = separation > best.separation ? separation : best.separation;
    return best;
}

static inline void tuff_best_of(tuff_axis *best, const tuff_edges *edges)
{
    tuff_axis found = *best;
    uint32_t i;
    for (i = 0; i < edges->asked->count; ++i) {
        if ((edges->skipped >> i & 1u) != 0) continue;
        found = tuff_better(found, tuff_separation_by(edges->asked, i, edges->other, edges->offset), edges->first_number + i);
    }
    *best = found;
}

static inline void tuff_best_around(tuff_axis *best, const tuff_edges *edges)
{
    tuff_best_of(best, edges);
}

/* If that edge does not separate, it is asked again with the others, in order. */
static inline tuff_axis tuff_first_axis(const tuff_polygon *part, const tuff_polygon *hull, tuff_vec2 offset)
{
    tuff_axis facing = { TUFF_WIDE_LOWEST, 0, 0 };
    uint32_t i;
    for (i = 0; i < part->count; ++i) facing = tuff_better(facing, tuff_beyond_edge(part, i, offset), i);
    facing.separation = tuff_separation_by(part, facing.number, hull, offset);
    if (!(facing.separation >= 0)) facing.separation = TUFF_WIDE_LOWEST;
    return facing;
}
