/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Circle against convex polygon. From any edge whose line the center is beyond, the way round the polygon to the Voronoi region
   that it is in is a short one; inside, the edge with the largest signed distance to its line is the nearest. One dot product an
   edge finds either, and only where a vertex is nearest is there a square root to take (Ericson, Real-Time Collision Detection,
   5.1 and 5.5.7). */
#include "inner.h"

/* tuff_outer_edge: of a part, an edge that a point is beyond, or the one that it is farthest beyond */
#include TUFF_EDGE_SEARCH

static inline bool has_length(tuff_vec2 edge)
{
    return edge.x != 0 || edge.y != 0;
}

static tuff_standing standing_at(const tuff_polygon *polygon, uint32_t edge)
{
    return tuff_edge_is_internal(polygon, edge) ? TUFF_BY_INTERNAL : TUFF_BY_OUTLINE;
}

static inline tuff_real overlap_by(tuff_real radius, tuff_wide separation)
{
    return tuff_narrow(tuff_widen(radius) - separation);
}

static tuff_standing edge_contact(const tuff_polygon *polygon, uint32_t edge, tuff_real overlap, tuff_contact *contact)
{
    if (!(overlap > 0)) return TUFF_APART;
    contact->overlap = overlap;
    contact->normal = polygon->normals[edge];
    return standing_at(polygon, edge);
}

/* Of the two edges that meet at a vertex, the one that faces the center more tells. */
static tuff_standing standing_at_vertex(tuff_vec2 from, const tuff_polygon *polygon, uint32_t vertex)
{
    uint32_t before = vertex == 0 ? polygon->count - 1u : vertex - 1;
    bool faces_before = tuff_project(polygon->normals[before], from) > tuff_project(polygon->normals[vertex], from);
    return standing_at(polygon, faces_before ? before : vertex);
}

/* from: from the vertex to the center. */
static tuff_standing vertex_contact(tuff_vec2 from, tuff_real radius, const tuff_polygon *polygon, uint32_t vertex, tuff_contact *contact)
{
    tuff_unit2 normal;
    if (tuff_dot(from, from) >= tuff_square_of(radius)) return TUFF_APART;
    tuff_real distance = tuff_normalize(from, &normal);
    tuff_real overlap = radius - distance;
    if (!(overlap > 0)) return TUFF_APART;
    if (!(distance > 0)) normal = polygon->normals[vertex];
    contact->overlap = overlap;
    contact->normal = normal;
    return polygon->internal_edges == 0 ? TUFF_BY_OUTLINE : standing_at_vertex(from, polygon, vertex);
}

static bool is_skipped(const tuff_polygon *polygon, uint8_t edge, tuff_vec2 center, tuff_skipped skipped)
{
    return skipped == TUFF_SKIP_BACK ? tuff_leads_back(polygon->normals[edge], center) : tuff_edge_is_internal(polygon, edge);
}

/* The least edge that is not skipped, for a circle known to overlap. */
static tuff_standing unskipped_contact(tuff_vec2 center, tuff_real radius, const tuff_polygon *polygon, tuff_skipped skipped,
                                       tuff_contact *contact)
{
    tuff_wide best = TUFF_WIDE_LOWEST;
    uint8_t edge = TUFF_MAX_VERTICES;
    uint8_t i;
    for (i = 0; i < polygon->count; ++i) {
        if (is_skipped(polygon, i, center, skipped)) continue;
        tuff_wide separation = tuff_beyond_edge(polygon, i, center);
        if (separation > best) {
            best = separation;
            edge = i;
        }
    }
    return edge == TUFF_MAX_VERTICES ? TUFF_APART : edge_contact(polygon, edge, overlap_by(radius, best), contact);
}

/* How far the center lies beyond a point on the way from one vertex to another, times their distance. */
static inline tuff_area beyond(const tuff_vec2 *center, const tuff_vec2 *point, const tuff_vec2 *from, const tuff_vec2 *to)
{
    return tuff_dot(tuff_vec2_gap(*center, *point), tuff_vec2_gap(*to, *from));
}

static inline bool lies_before(const tuff_vec2 *center, const tuff_vec2 *from, const tuff_vec2 *to)
{
    return beyond(center, from, from, to) < 0;
}

static inline bool lies_past(const tuff_vec2 *center, const tuff_vec2 *from, const tuff_vec2 *to)
{
    return beyond(center, to, from, to) > 0;
}

/* Edges, or vertices, farther on round the polygon; count - 1 of them are one back. */
static inline uint32_t farther(uint32_t i, uint32_t stride, uint32_t count)
{
    return i + stride >= count ? i + stride - count : i + stride;
}

/* The first edge from this one on that has a length: one without has the next one's normal. */
static uint32_t real_edge(const tuff_polygon *polygon, uint32_t edge)
{
    const uint32_t last = polygon->count - 1u;
    while (edge < last && !has_length(tuff_vec2_gap(polygon->vertices[edge + 1], polygon->vertices[edge]))) ++edge;
    return edge;
}

/* By what stride the regions go on from edge *i toward the center's, and from which vertex, *i; 0: it is that of the edge. */
static inline uint32_t stride_from(const tuff_vec2 *center, const tuff_polygon *polygon, uint32_t *i)
{
    const tuff_vec2 *const vertices = polygon->vertices;
    const uint32_t count = polygon->count;
    const uint32_t next = farther(*i, 1, count);
    if (lies_before(center, &vertices[*i], &vertices[next])) return count - 1;
    if (lies_past(center, &vertices[*i], &vertices[next])) {
        *i = next;
        return 1;
    }
    if (has_length(tuff_vec2_gap(vertices[next], vertices[*i]))) return 0;
    *i = real_edge(polygon, *i);
    return lies_before(center, &vertices[*i], &vertices[farther(*i, 1, count)]) ? count - 1 : 1;
}

/* The Voronoi region that the center is in: of an edge, or from TUFF_MAX_VERTICES on of a vertex. It is near the line of edge i or
   beyond it: from there round the polygon the distance falls on the way, and mostly a step or none is taken. Exact products of
   the edges decide, which do not mind where rounded projections favor an edge nearly in line. Edges without length (the checks
   refuse them) are passed; the steps end where a shape is not convex. */
static uint32_t nearest_feature(const tuff_vec2 *center, const tuff_polygon *polygon, uint32_t i)
{
    const tuff_vec2 *const vertices = polygon->vertices;
    const uint32_t count = polygon->count;
    const uint32_t stride = stride_from(center, polygon, &i);
    if (stride == 0) return i;
    const uint32_t start = i;
    do {
        uint32_t other = farther(i, stride, count);
        if (lies_before(center, &vertices[i], &vertices[other])) return TUFF_MAX_VERTICES + i;
        if (!lies_past(center, &vertices[i], &vertices[other]) && has_length(tuff_vec2_gap(vertices[other], vertices[i]))) {
            return stride == 1 ? i : other;
        }
        i = other;
    } while (i != start);
    return i;
}

static tuff_standing nearest_contact(const tuff_vec2 *center, tuff_real radius, const tuff_polygon *polygon, uint32_t edge,
                                     tuff_contact *contact)
{
    const uint32_t feature = nearest_feature(center, polygon, edge);
    if (feature < TUFF_MAX_VERTICES) {
        return edge_contact(polygon, feature, overlap_by(radius, tuff_beyond_edge(polygon, feature, *center)), contact);
    }
    const uint32_t vertex = feature - TUFF_MAX_VERTICES;
    return vertex_contact(tuff_vec2_gap(*center, polygon->vertices[vertex]), radius, polygon, vertex, contact);
}

/* Well inside, the edge is the answer, unless a neighbor in line with it would make the difference of outline and internal. */
static inline tuff_standing circle_contact(const tuff_vec2 *center, tuff_real radius, const tuff_polygon *polygon, tuff_contact *contact)
{
    const tuff_wide limit = tuff_widen(radius);
    tuff_wide separation;
    uint32_t edge = tuff_outer_edge(polygon, center, limit, &separation);
    if (tuff_roughly(separation) > tuff_roughly(limit)) return TUFF_APART;
    if (separation <= -TUFF_WIDE_NEAR && polygon->internal_edges == 0) {
        return edge_contact(polygon, edge, overlap_by(radius, separation), contact);
    }
    return nearest_contact(center, radius, polygon, edge, contact);
}

TUFF_HOT tuff_standing tuff_circle_part(tuff_shape *shape, const tuff_polygon *polygon, tuff_skipped skipped, tuff_contact *contact)
{
    if (skipped != TUFF_SKIP_NONE) return unskipped_contact(shape->offset, shape->radius, polygon, skipped, contact);
    return circle_contact(&shape->offset, shape->radius, polygon, contact);
}

TUFF_HOT bool tuff_circle_polygon(tuff_vec2 center, tuff_real radius, const tuff_polygon *polygon, tuff_contact *contact)
{
    TUFF_ASSERT(polygon != NULL && contact != NULL);
    TUFF_ASSERT(tuff_in_range(radius, TUFF_MAX_BOUNDING_RADIUS));
    if (polygon == NULL || !tuff_baked(polygon)) return false;
    if (!tuff_in_range(radius, TUFF_MAX_BOUNDING_RADIUS)) return false;
    /* No vertex is farther out than a bounding radius may be: 2,898 units; the power of two is cheaper to compare with. */
    if (!tuff_in_box(center, TUFF_WHOLE(4096))) return false;
    center = tuff_vec2_flush(center);
    return circle_contact(&center, tuff_flush(radius), polygon, contact) != TUFF_APART;
}
