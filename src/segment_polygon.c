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
    const tuff_area across = tuff_line_across(&beam->d, &beam->a, &beam->b);
    unsigned left = 0;
    unsigned right = 0;
    uint8_t i;
    for (i = 0; i < polygon->count; ++i) {
        tuff_area side = tuff_far_cross_near(&beam->d, polygon->vertices[i]);
        left |= side >= across;
        right |= side <= across;
    }
    return (left & right) == 0;
}

/* Do both ends lie strictly outside of one edge? Of an internal edge, a margin farther out, where the other part is. */
static bool ends_miss(const tuff_beam *beam, const tuff_polygon *polygon)
{
    const tuff_area seam = tuff_seam_margin(&beam->d);
    const bool forward = tuff_turns_forward(polygon);
    unsigned missed = 0;
    uint8_t i;
    for (i = 0; i < polygon->count; ++i) {
        tuff_area margin = tuff_edge_is_internal(polygon, i) ? seam : 0;
        tuff_area a = tuff_edge_outside(polygon, i, forward, &beam->a);
        tuff_area b = tuff_edge_outside(polygon, i, forward, &beam->b);
        missed |= (unsigned)(a > margin) & (unsigned)(b > margin);
    }
    return missed != 0;
}

static inline bool touches(const tuff_beam *beam, const tuff_polygon *polygon)
{
    return !line_misses(beam, polygon) && !ends_miss(beam, polygon);
}

/* Where the quicker way is unsure of one order of the ends, it may be sure of the other. */
static inline tuff_verdict quick_verdict(const tuff_vec2 *a, const tuff_vec2 *b, const tuff_polygon *polygon)
{
    tuff_verdict verdict = tuff_near_verdict(a, b, polygon);
    return verdict == TUFF_UNSURE ? tuff_near_verdict(b, a, polygon) : verdict;
}

TUFF_HOT bool tuff_beam_touches_parts(const tuff_beam *beam, const tuff_polygon *parts, uint8_t count)
{
    tuff_vec2 a, b;
    const bool narrow = tuff_far_narrow(beam->a, &a) && tuff_far_narrow(beam->b, &b);
    uint8_t i;
    for (i = 0; i < count; ++i) {
        tuff_verdict verdict = narrow ? quick_verdict(&a, &b, &parts[i]) : TUFF_UNSURE;
        if (verdict == TUFF_UNSURE ? touches(beam, &parts[i]) : verdict == TUFF_MEETS) return true;
    }
    return false;
}

bool tuff_segment_polygon(tuff_vec2 a, tuff_vec2 b, const tuff_polygon *polygon)
{
    TUFF_ASSERT(polygon != NULL);
    if (polygon == NULL || !tuff_baked(polygon) || !tuff_beam_ends_ok(a, b)) return false;
    tuff_verdict verdict = quick_verdict(&a, &b, polygon);
    if (verdict != TUFF_UNSURE) return verdict == TUFF_MEETS;
    tuff_beam beam;
    tuff_beam_between(&beam, a, b);
    return touches(&beam, polygon);
}
