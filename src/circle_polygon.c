/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Circle against convex polygon. The signed distance to the polygon is the largest signed distance to its edge lines
   wherever the nearest point lies on an edge, so one dot product an edge finds a separating axis or the nearest
   edge; only where that edge's end is nearer is there a square root to take (Ericson, Real-Time Collision Detection,
   5.1 and 5.5.7). */
#include "inner.h"

/* The Voronoi region of the center: an edge's or that of the vertex where the edge begins. */
typedef struct tuff_region {
    uint8_t edge;
    bool    at_vertex;
} tuff_region;

static tuff_region region_of(uint8_t edge, bool at_vertex)
{
    tuff_region region = { edge, at_vertex };
    return region;
}

static inline bool has_length(tuff_vec2 edge)
{
    return edge.x != 0 || edge.y != 0;
}

/* Onward from vertex i, or back, to the region that the center is in; it lies past the vertex. An edge without length (the
   checks refuse them) is no region and ends no walk. */
static tuff_region region_past(tuff_vec2 center, const tuff_polygon *polygon, uint8_t i, bool onward)
{
    const tuff_vec2 *v = polygon->vertices;
    uint8_t steps;
    for (steps = polygon->count; steps > 0; --steps) {
        uint8_t other = onward ? tuff_next_index(i, polygon->count) : tuff_previous_index(i, polygon->count);
        tuff_vec2 along = tuff_vec2_gap(v[other], v[i]);
        if (tuff_dot(tuff_vec2_gap(center, v[i]), along) <= 0 && has_length(along)) return region_of(i, true);
        if (tuff_dot(tuff_vec2_gap(center, v[other]), along) < 0) return region_of(onward ? i : other, false);
        i = other;
    }
    return region_of(i, false);     /* not convex */
}

/* From the edge that faces the center most, walk to the region the center is in. Mostly no step is taken: it is the
   edge itself or one of its ends. Where edges are nearly in line, rounded projections may favor an edge farther on;
   exact products of the edges do not. An edge without length has the next one's normal. */
static tuff_region find_region(tuff_vec2 center, const tuff_polygon *polygon, uint8_t edge)
{
    const tuff_vec2 *v = polygon->vertices;
    uint8_t next = tuff_next_index(edge, polygon->count);
    while (!has_length(tuff_vec2_gap(v[next], v[edge])) && next != 0) {
        edge = next;
        next = tuff_next_index(next, polygon->count);
    }
    tuff_vec2 along = tuff_vec2_gap(v[next], v[edge]);
    if (tuff_dot(tuff_vec2_gap(center, v[edge]), along) < 0) return region_past(center, polygon, edge, false);
    if (tuff_dot(tuff_vec2_gap(center, v[next]), along) > 0) return region_past(center, polygon, next, true);
    return region_of(edge, false);
}

static tuff_standing standing_at(const tuff_polygon *polygon, uint32_t edge)
{
    return tuff_edge_is_internal(polygon, edge) ? TUFF_BY_INTERNAL : TUFF_BY_OUTLINE;
}

static tuff_standing edge_contact(tuff_real radius, const tuff_polygon *polygon, uint32_t edge, tuff_wide separation, tuff_contact *contact)
{
    tuff_real overlap = tuff_narrow(tuff_widen(radius) - separation);
    if (!(overlap > 0)) return TUFF_APART;
    contact->overlap = overlap;
    contact->normal = polygon->normals[edge];
    return standing_at(polygon, edge);
}

/* Of the two edges that meet at a vertex, the one that faces the center more tells. */
static tuff_standing standing_at_vertex(tuff_vec2 center, const tuff_polygon *polygon, uint8_t vertex)
{
    uint8_t before = tuff_previous_index(vertex, polygon->count);
    tuff_vec2 d = tuff_vec2_sub(center, polygon->vertices[vertex]);
    bool faces_before = tuff_project(polygon->normals[before], d) > tuff_project(polygon->normals[vertex], d);
    return standing_at(polygon, faces_before ? before : vertex);
}

static tuff_standing vertex_contact(tuff_vec2 center, tuff_real radius, const tuff_polygon *polygon, uint8_t vertex, tuff_contact *contact)
{
    tuff_vec2 d = tuff_vec2_gap(center, polygon->vertices[vertex]);
    tuff_unit2 normal = polygon->normals[vertex];
    if (tuff_dot(d, d) >= tuff_square_of(radius)) return TUFF_APART;
    tuff_real overlap = radius - tuff_normalize(d, &normal);
    if (!(overlap > 0)) return TUFF_APART;
    contact->overlap = overlap;
    contact->normal = normal;
    return polygon->internal_edges == 0 ? TUFF_BY_OUTLINE : standing_at_vertex(center, polygon, vertex);
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
    return edge == TUFF_MAX_VERTICES ? TUFF_APART : edge_contact(radius, polygon, edge, best, contact);
}

/* The edge whose line the center is farthest beyond, or the first one found that separates. */
typedef struct tuff_facing_edge {
    tuff_wide separation;
    uint32_t  edge;
} tuff_facing_edge;

static inline tuff_facing_edge facing_edge(tuff_vec2 center, tuff_wide limit, const tuff_polygon *polygon)
{
    tuff_facing_edge facing = { TUFF_WIDE_LOWEST, 0 };
    uint32_t i;
    for (i = 0; i < polygon->count; ++i) {
        tuff_wide separation = tuff_beyond_edge(polygon, i, center);
        facing.edge = separation > facing.separation ? i : facing.edge;
        facing.separation = separation > facing.separation ? separation : facing.separation;
        if (separation >= limit) break;
    }
    return facing;
}

/* No edge's line separates. Well inside, the edge is the answer, unless a neighbor in line with it would make the difference of
   outline and internal. */
static tuff_standing contact_at(tuff_vec2 center, tuff_real radius, const tuff_polygon *polygon, tuff_facing_edge facing,
                                tuff_contact *contact)
{
    if (facing.separation <= -TUFF_WIDE_NEAR && polygon->internal_edges == 0) {
        return edge_contact(radius, polygon, facing.edge, facing.separation, contact);
    }
    tuff_region region = find_region(center, polygon, (uint8_t)facing.edge);
    if (region.at_vertex) return vertex_contact(center, radius, polygon, region.edge, contact);
    if (region.edge != facing.edge) facing.separation = tuff_beyond_edge(polygon, region.edge, center);
    return edge_contact(radius, polygon, region.edge, facing.separation, contact);
}

TUFF_HOT tuff_standing tuff_circle_part(tuff_mover *mover, tuff_vec2 center, const tuff_polygon *polygon, tuff_skipped skipped,
                                        tuff_contact *contact)
{
    const tuff_wide limit = tuff_widen(mover->radius);
    if (skipped != TUFF_SKIP_NONE) return unskipped_contact(center, mover->radius, polygon, skipped, contact);
    tuff_facing_edge facing = facing_edge(center, limit, polygon);
    return facing.separation >= limit ? TUFF_APART : contact_at(center, mover->radius, polygon, facing, contact);
}

bool tuff_circle_mover(tuff_mover *mover, tuff_real radius)
{
    mover->test = tuff_circle_part;
    mover->seams = false;
    mover->neighbor_count = TUFF_NO_NEIGHBORS;
    TUFF_ASSERT(tuff_in_range(radius, TUFF_MAX_BOUNDING_RADIUS));
    mover->radius = tuff_flush(radius);
    return tuff_in_range(radius, TUFF_MAX_BOUNDING_RADIUS);
}

TUFF_HOT bool tuff_circle_polygon(tuff_vec2 center, tuff_real radius, const tuff_polygon *polygon, tuff_contact *contact)
{
    TUFF_ASSERT(polygon != NULL && contact != NULL);
    TUFF_ASSERT(tuff_in_range(radius, TUFF_MAX_BOUNDING_RADIUS));
    if (polygon == NULL || !tuff_baked(polygon) || !tuff_in_range(radius, TUFF_MAX_BOUNDING_RADIUS)) return false;
    /* No vertex is farther out than a bounding radius may be. */
    if (!tuff_in_box(center, TUFF_WHOLE(2 * TUFF_MAX_BOUNDING_RADIUS))) return false;
    const tuff_vec2 flushed = tuff_vec2_flush(center);
    const tuff_wide limit = tuff_widen(tuff_flush(radius));
    tuff_facing_edge facing = facing_edge(flushed, limit, polygon);
    if (facing.separation >= limit) return false;
    return contact_at(flushed, tuff_flush(radius), polygon, facing, contact) != TUFF_APART;
}
