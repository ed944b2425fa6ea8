/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Segment against convex polygon, by separating axes on cross products that are exact in the fixed build: the
   segment's own normal, then the edges' (Ericson, Real-Time Collision Detection, 5.2.1 and 5.3.8). Nothing is
   divided and nothing rounded there, so the ends may be swapped, and two polygons that share an edge or a vertex
   leave no gap. */
#include "inner.h"

/* Are all vertices strictly on one side of the line? */
static bool line_misses(const tuff_beam *beam, const tuff_polygon *polygon)
{
    bool left = false;
    bool right = false;
    uint8_t i;
    for (i = 0; i < polygon->count; ++i) {
        tuff_area side = tuff_far_cross_near(beam->d, polygon->vertices[i]);
        if (side >= beam->across) left = true;
        if (side <= beam->across) right = true;
        if (left && right) return false;
    }
    return true;
}

/* Do both ends lie strictly outside of one edge? Outside is the right of an edge that goes forward; of an internal edge,
   a margin farther out, where the other part is. */
static bool ends_miss(const tuff_beam *beam, const tuff_polygon *polygon)
{
    bool forward = tuff_goes_forward(polygon);
    uint8_t i;
    for (i = 0; i < polygon->count; ++i) {
        uint8_t next = tuff_next_index(i, polygon->count);
        tuff_vec2 from = polygon->vertices[forward ? i : next];
        tuff_vec2 to = polygon->vertices[forward ? next : i];
        tuff_area outside = tuff_edge_is_internal(polygon, i) ? -tuff_seam_margin(beam->d, from, to) : 0;
        if (tuff_edge_side(beam->a, from, to) < outside && tuff_edge_side(beam->b, from, to) < outside) return true;
    }
    return false;
}

TUFF_HOT bool tuff_beam_touches_part(const tuff_beam *beam, const tuff_polygon *polygon)
{
    return !line_misses(beam, polygon) && !ends_miss(beam, polygon);
}

bool tuff_segment_polygon(tuff_vec2 a, tuff_vec2 b, const tuff_polygon *polygon)
{
    const tuff_vec2 origin = { TUFF_WHOLE(0), TUFF_WHOLE(0) };
    TUFF_ASSERT(polygon != NULL);
    if (polygon == NULL || !tuff_baked(polygon) || !tuff_beam_ends_ok(a, b)) return false;
    tuff_beam beam = tuff_beam_relative(a, b, origin);
    return tuff_beam_touches_part(&beam, polygon);
}
