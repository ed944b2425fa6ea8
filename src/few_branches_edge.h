/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The search for the edge that faces a point, with few branches. Only circle_polygon.c includes this. */

/* The edge whose line the point is farthest beyond, the lowest of equals; or the first one found that is limit beyond or more.
   Selections: no branch but the loop's. */
static inline uint32_t tuff_outer_edge(const tuff_polygon *polygon, const tuff_vec2 *point, tuff_wide limit, tuff_wide *separation)
{
    tuff_wide most = TUFF_WIDE_LOWEST;
    uint32_t edge = 0;
    uint32_t i;
    for (i = 0; i < polygon->count; ++i) {
        tuff_wide beyond = tuff_project(polygon->normals[i], tuff_vec2_sub(*point, polygon->vertices[i]));
        edge = beyond > most ? i : edge;
        most = beyond > most ? beyond : most;
        if (beyond >= limit) break;
    }
    *separation = most;
    return edge;
}
