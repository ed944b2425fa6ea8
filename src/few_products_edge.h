/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The search for an edge that faces a point, with few products, in integers. Only circle_polygon.c includes this. */

/* An edge whose line the point is surely beyond, by 4 LSB as the high word shows; if there is none, the one that it is farthest beyond.
   The edges that face a point are neighbors, and mostly more than one: every other edge is asked first. */
static inline uint32_t tuff_outer_edge(const tuff_polygon *polygon, const tuff_vec2 *point, tuff_wide limit, tuff_wide *separation)
{
    const tuff_vec2 *v = polygon->vertices;
    const tuff_unit2 *n = polygon->normals;
    const tuff_vec2 *const end = v + polygon->count;
    tuff_wide most;
    (void)limit;
    do {
        const tuff_vec2 vertex = *v;
        const tuff_unit2 normal = *n;
        tuff_wide beyond = tuff_project(normal, tuff_vec2_sub(*point, vertex));
        if (tuff_roughly(beyond) > 0) {
            *separation = beyond;
            return (uint32_t)(v - polygon->vertices);
        }
        v += 2;
        n += 2;
    } while (v < end);
    uint32_t edge = tuff_farthest_edge(polygon, point, &most);
    *separation = most;
    return edge;
}
