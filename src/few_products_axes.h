/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The search for the best axis with few products, in integers. Only polygon_polygon.c includes this. The other polygon reaches at least
   as far back as any one vertex of it: one that is beyond an edge by less than the best so far rules the edge out, and mostly does. A
   product of 64 bits costs a handheld more than a branch. The wrong vertex costs time and nothing else. What a loop over edges seldom
   needs is a function of its own: so the loop's values stay in registers. */

/* The axis of an edge, by its normal: all vertices of the other polygon are asked, and the nearest is noted. */
static void tuff_ask_edge(tuff_axis *best, tuff_edges *edges, const tuff_unit2 *n)
{
    const uint32_t edge = (uint32_t)(n - edges->asked->normals);
    const uint32_t number = edges->first_number + edge;
    if ((edges->skipped >> edge & 1u) != 0) return;
    edges->nearest = edges->other->vertices + tuff_least_along(edges->other, *n);
    tuff_wide separation = tuff_beyond_edge(edges->asked, edge, tuff_vec2_add(*edges->nearest, edges->offset));
    if (separation < best->separation || (separation == best->separation && number > best->number)) return;
    best->separation = separation;
    best->number = number;
}

/* The nearest vertex is asked first. */
static void tuff_best_of(tuff_axis *best, tuff_edges *edges)
{
    const tuff_vec2 *v = edges->asked->vertices;
    const tuff_vec2 *end = v + edges->asked->count;
    const tuff_unit2 *n = edges->asked->normals;
    tuff_vec2 point = tuff_vec2_add(*edges->nearest, edges->offset);
    int32_t high = tuff_roughly(best->separation);
    for (; v != end; ++v, ++n) {
        if (tuff_roughly(tuff_project(*n, tuff_vec2_sub(point, *v))) < high) continue;
        if (edges->first_number + (uint32_t)(n - edges->asked->normals) == best->number) continue;      /* where the search began */
        tuff_ask_edge(best, edges, n);
        point = tuff_vec2_add(*edges->nearest, edges->offset);
        high = tuff_roughly(best->separation);
    }
}

/* Where both polygons go round the same way, the vertex that matters goes round with the edges, so it is guessed from their numbers. */
static void tuff_best_around(tuff_axis *best, tuff_edges *edges)
{
    const uint32_t count = edges->asked->count;
    const uint32_t other_count = edges->other->count;
    const tuff_vec2 *v = edges->asked->vertices;
    const tuff_unit2 *n = edges->asked->normals;
    const tuff_unit2 *end = n + count;
    const tuff_vec2 *w = edges->nearest;
    const tuff_vec2 *other_end = edges->other->vertices + other_count;
    const tuff_vec2 offset = edges->offset;
    uint32_t turned = other_count / 2 + (count - edges->nearest_to) * other_count;    /* parts of a step from vertex to vertex */
    int32_t high = tuff_roughly(best->separation);
    for (; n != end; ++n, ++v) {
        for (; turned >= count; turned -= count) {
            if (++w == other_end) w -= other_count;
        }
        if (tuff_roughly(tuff_project(*n, tuff_vec2_sub(tuff_vec2_add(*w, offset), *v))) >= high) {
            tuff_ask_edge(best, edges, n);
            high = tuff_roughly(best->separation);
        }
        turned += other_count;
    }
}

/* The edge whose line the point is farthest beyond, by the high words. Selections: which way a branch would go is as good as random. */
static inline uint32_t tuff_facing_edge(const tuff_polygon *part, tuff_vec2 point)
{
    const tuff_vec2 *v = part->vertices;
    const tuff_unit2 *n = part->normals;
    const uint32_t count = part->count;     /* as long as an index: the loop needs no masks */
    int32_t most = tuff_roughly(TUFF_WIDE_LOWEST);
    uint32_t edge = 0;
    uint32_t i;
    for (i = 0; i < count; ++i, ++n, ++v) {
        int32_t beyond = tuff_roughly(tuff_project(*n, tuff_vec2_sub(point, *v)));
        edge = beyond > most ? i : edge;
        most = beyond > most ? beyond : most;
    }
    return edge;
}

static inline tuff_axis tuff_first_axis(const tuff_polygon *part, const tuff_polygon *hull, tuff_vec2 offset)
{
    const uint32_t edge = tuff_facing_edge(part, offset);
    const tuff_vec2 *nearest = tuff_nearest_along(hull, part->normals[edge]);
    tuff_axis facing = { tuff_beyond_edge(part, edge, tuff_vec2_add(*nearest, offset)), edge, (uint32_t)(nearest - hull->vertices) };
    return facing;
}
