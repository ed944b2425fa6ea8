/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Segment against convex polygon, by separating axes on cross products that are exact in the fixed build: the
   segment's own normal, then the edges' (Ericson, Real-Time Collision Detection, 5.2.1 and 5.3.8). Nothing is
   divided and nothing rounded there, so the ends may be swapped, and two polygons that share an edge or a vertex
   leave no gap. */
#include "inner.h"

/* Are all vertices strictly on one side of the line? As in ends_miss, nothing branches on a side: which way it would go
   is as good as random, and a wrong guess costs a fast CPU more than all vertices do. */
static inline bool line_misses(const tuff_beam *beam, const tuff_polygon *polygon)
{
    unsigned left = 0;
    unsigned right = 0;
    uint8_t i;
    for (i = 0; i < polygon->count; ++i) {
        tuff_area side = tuff_far_cross_near(beam->d, polygon->vertices[i]);
        left |= side >= beam->across;
        right |= side <= beam->across;
    }
    return (left & right) == 0;
}

/* Do both ends lie strictly outside of one edge? Of an internal edge, a margin farther out, where the other part is. */
static bool ends_miss(const tuff_beam *beam, const tuff_polygon *polygon)
{
    const tuff_area seam = tuff_seam_margin(beam->d);
    const bool forward = tuff_turns_forward(polygon);
    unsigned missed = 0;
    uint8_t i;
    for (i = 0; i < polygon->count; ++i) {
        tuff_area margin = tuff_edge_is_internal(polygon, i) ? seam : 0;
        tuff_area a = tuff_edge_outside(polygon, i, forward, beam->a);
        tuff_area b = tuff_edge_outside(polygon, i, forward, beam->b);
        missed |= (unsigned)(a > margin) & (unsigned)(b > margin);
    }
    return missed != 0;
}

static inline bool touches(const tuff_beam *beam, const tuff_polygon *polygon)
{
    return !line_misses(beam, polygon) && !ends_miss(beam, polygon);
}

TUFF_HOT bool tuff_beam_touches_part(const tuff_beam *beam, const tuff_polygon *polygon)
{
    return touches(beam, polygon);
}

bool tuff_segment_polygon(tuff_vec2 a, tuff_vec2 b, const tuff_polygon *polygon)
{
    const tuff_vec2 origin = { TUFF_WHOLE(0), TUFF_WHOLE(0) };
    TUFF_ASSERT(polygon != NULL);
    if (polygon == NULL || !tuff_baked(polygon) || !tuff_beam_ends_ok(a, b)) return false;
    tuff_beam beam = tuff_beam_relative(a, b, origin);
    return touches(&beam, polygon);
}
