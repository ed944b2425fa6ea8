/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Normals of a polygon's edges, for hulls that turn and for shapes made at run time. */
#include "inner.h"

/* Twice the signed area about the first vertex: positive if the vertices go round from +x to +y. At most 30 * 2^55
   (fixed). *sure: it is not lost in its rounding. */
static bool goes_from_x_to_y(const tuff_vec2 *vertices, uint8_t count, bool *sure)
{
    tuff_vec2 before = tuff_vec2_gap(vertices[1], vertices[0]);
    tuff_area squares = tuff_dot(before, before);
    tuff_area area = 0;
    uint8_t i;
    for (i = 2; i < count; ++i) {
        tuff_vec2 here = tuff_vec2_gap(vertices[i], vertices[0]);
        area = tuff_area_sub(area, tuff_cross(here, before));
        squares = tuff_area_add(squares, tuff_dot(here, here));
        before = here;
    }
    *sure = tuff_area_sure(area, squares);
    return area >= 0;
}

/* The turns from normal to normal tell the winding too, whichever way the normals point. Their sines are lost in rounding
   only where all edges lie in one line; then either side is outside. */
static void face_outward(tuff_unit2 *normals, uint8_t count, bool forward)
{
    tuff_wide turns = 0;
    uint8_t i;
    for (i = 0; i < count; ++i) {
        tuff_unit2 next = normals[tuff_next_index(i, count)];
        tuff_unit2 next_right = { next.y, tuff_unit2_negate(next).x };
        turns = tuff_wide_add(turns, tuff_facing(normals[i], next_right));
    }
    if ((turns >= 0) == forward) return;
    for (i = 0; i < count; ++i) normals[i] = tuff_unit2_negate(normals[i]);
}

void tuff_edge_normals(const tuff_vec2 *vertices, uint8_t count, tuff_unit2 *normals)
{
    uint8_t i;
    TUFF_ASSERT(vertices != NULL && normals != NULL && count >= 3 && count <= TUFF_MAX_VERTICES);
    if (vertices == NULL || normals == NULL || count < 3 || count > TUFF_MAX_VERTICES) return;
    bool sure;
    bool forward = goes_from_x_to_y(vertices, count, &sure);

    /* Backwards, twice round at most: an edge without length finds the next one's normal already there. */
    tuff_unit2 later = { TUFF_UNIT_ONE, 0 };
    uint8_t rounds;
    for (rounds = 0; rounds < 2; ++rounds) {
        bool gaps = false;
        for (i = count; i-- > 0;) {
            tuff_vec2 from = vertices[i];
            tuff_vec2 to = vertices[tuff_next_index(i, count)];
            if (tuff_normalize(forward ? tuff_right_of(from, to) : tuff_right_of(to, from), &later) == 0) gaps = true;
            normals[i] = later;
        }
        if (!gaps) break;
    }
    if (!sure) face_outward(normals, count, forward);
}
