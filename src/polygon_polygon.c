/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Hull against convex polygon: separating axes over the edge normals of both (Ericson, Real-Time Collision
   Detection, 5.2.1). One edge is asked first: mostly what is apart is apart along it, and what overlaps does so least along
   it. The search among the others is the scalar's. */
#include "inner.h"

/* An edge's axis: number is the edge's in the part, or TUFF_MAX_VERTICES and on in the hull. nearest: the hull's vertex on the axis
   that the search starts from. */
typedef struct tuff_axis {
    tuff_wide separation;
    uint32_t  number;
    uint32_t  nearest;
} tuff_axis;

/* Edges of a polygon that the other one, at this offset, may lie beyond. A bit in skipped: not to be asked. nearest: any vertex of
   the other polygon; the one that is nearest to most of them saves time, or to the edge nearest_to. */
typedef struct tuff_edges {
    const tuff_polygon *asked;
    const tuff_polygon *other;
    tuff_vec2           offset;
    uint32_t            first_number;
    uint32_t            skipped;
    const tuff_vec2    *nearest;
    uint32_t            nearest_to;
} tuff_edges;

/* tuff_first_axis(part, hull, offset)    what the search among all starts from: the axis of the edge that faces the hull's position, if
                                          it separates at least
   tuff_best_of(best, edges)              the best of it and the edges' axes; of equals the lowest number
   tuff_best_around(best, edges)          the same, where nearest_to is known */
#include TUFF_AXES_SEARCH

/* A hull's own axis counts as internal where the outline, at the part's vertex that lies farthest against it, has no such
   normal. */
static bool hull_axis_is_internal(const tuff_mover *mover, const tuff_polygon *part, tuff_unit2 hull_normal)
{
    if (part->internal_edges == 0 && !mover->shape.seams) return false;
    return tuff_corner_is_internal(mover, part, tuff_least_along(part, hull_normal), tuff_unit2_negate(hull_normal));
}

/* Is an axis no way out where the hull is: of an internal edge, or of one that it is not over or that another piece covers, or
   a hull's own that counts as one? */
static bool axis_is_internal(const tuff_mover *mover, const tuff_polygon *part, uint32_t number)
{
    if (number >= TUFF_MAX_VERTICES) return hull_axis_is_internal(mover, part, mover->hull.normals[number - TUFF_MAX_VERTICES]);
    if (tuff_edge_is_internal(part, number)) return true;
    if (part->internal_edges != 0 && tuff_edge_beside(mover, part, (uint8_t)number)) return true;
    return mover->shape.seams && tuff_edge_buried(mover, part, (uint8_t)number);
}

/* Which way a push along an axis goes. */
static inline tuff_unit2 way_along(const tuff_polygon *hull, const tuff_polygon *part, uint32_t number)
{
    if (number < TUFF_MAX_VERTICES) return part->normals[number];
    return tuff_unit2_negate(hull->normals[number - TUFF_MAX_VERTICES]);
}

static bool axis_contact(const tuff_polygon *hull, const tuff_polygon *part, const tuff_axis *best, tuff_contact *contact)
{
    tuff_real overlap = tuff_narrow(-best->separation);
    if (!(overlap > 0)) return false;
    contact->overlap = overlap;
    contact->normal = way_along(hull, part, best->number);
    return true;
}

/* All edges of the part, and of the hull about it; a vertex of the other polygon, and the hull's edge near to it. */
static inline tuff_edges part_edges(const tuff_polygon *hull, tuff_vec2 offset, const tuff_polygon *part, uint32_t vertex)
{
    tuff_edges edges = { part, hull, offset, 0, 0, hull->vertices + vertex, 0 };
    return edges;
}

static inline tuff_edges hull_edges(const tuff_polygon *hull, tuff_vec2 offset, const tuff_polygon *part, uint32_t vertex, uint32_t edge)
{
    const tuff_vec2 origin = { TUFF_WHOLE(0), TUFF_WHOLE(0) };
    tuff_edges edges = { hull, part, tuff_vec2_sub(origin, offset), TUFF_MAX_VERTICES, 0, part->vertices + vertex, edge };
    return edges;
}

/* The contact along the best axis of all, from the facing one on. A hull without normals gets them in scratch. */
static bool least_contact(tuff_polygon *hull, tuff_unit2 *scratch, tuff_vec2 offset, const tuff_polygon *part, tuff_axis *best,
                          tuff_contact *contact)
{
    const uint32_t next = tuff_next_index((uint8_t)best->number, part->count);
    tuff_edges edges = part_edges(hull, offset, part, best->nearest);
    tuff_best_of(best, &edges);
    if (best->separation >= 0) return false;
    if (hull->normals == NULL) {
        tuff_edge_normals(hull->vertices, hull->count, scratch);
        hull->normals = scratch;
    }
    edges = hull_edges(hull, offset, part, next, best->nearest);
    tuff_best_around(best, &edges);
    return best->separation < 0 && axis_contact(hull, part, best, contact);
}

static bool axis_is_skipped(const tuff_mover *mover, tuff_vec2 offset, const tuff_polygon *part, uint32_t number, tuff_skipped skipped)
{
    if (skipped == TUFF_SKIP_BACK) return tuff_leads_back(way_along(&mover->hull, part, number), offset);
    return axis_is_internal(mover, part, number);
}

static void ask_unskipped(tuff_axis *best, tuff_edges *edges, const tuff_mover *mover, tuff_vec2 offset, const tuff_polygon *part,
                          tuff_skipped skipped)
{
    uint32_t i;
    for (i = 0; i < edges->asked->count; ++i) {
        if (axis_is_skipped(mover, offset, part, edges->first_number + i, skipped)) edges->skipped |= (uint32_t)1 << i;
    }
    tuff_best_of(best, edges);
}

/* The contact along the best of the axes that are not skipped, for a hull known to overlap; its normals are there. */
static bool unskipped_axis_contact(const tuff_mover *mover, tuff_vec2 offset, const tuff_polygon *part, tuff_skipped skipped, tuff_axis *best,
                              tuff_contact *contact)
{
    tuff_edges edges = part_edges(&mover->hull, offset, part, 0);
    best->separation = TUFF_WIDE_LOWEST;
    best->number = 2 * TUFF_MAX_VERTICES;
    ask_unskipped(best, &edges, mover, offset, part, skipped);
    edges = hull_edges(&mover->hull, offset, part, 0, 0);
    ask_unskipped(best, &edges, mover, offset, part, skipped);
    return best->separation != TUFF_WIDE_LOWEST && axis_contact(&mover->hull, part, best, contact);
}

TUFF_HOT tuff_standing tuff_hull_part(tuff_shape *shape, const tuff_polygon *part, tuff_skipped skipped, tuff_contact *contact)
{
    tuff_mover *mover = (tuff_mover *)shape;
    const tuff_vec2 offset = shape->offset;
    tuff_axis best;
    if (skipped == TUFF_SKIP_NONE) {
        best = tuff_first_axis(part, &mover->hull, offset);
        if (best.separation >= 0) return TUFF_APART;
        if (!least_contact(&mover->hull, mover->scratch, offset, part, &best, contact)) return TUFF_APART;
    } else if (!unskipped_axis_contact(mover, offset, part, skipped, &best, contact)) {
        return TUFF_APART;
    }
    return axis_is_internal(mover, part, best.number) ? TUFF_BY_INTERNAL : TUFF_BY_OUTLINE;
}

bool tuff_hull_mover(tuff_mover *mover, tuff_real radius, const tuff_polygon *hull, tuff_unit2 *scratch)
{
    mover->shape.test = tuff_hull_part;
    TUFF_ASSERT(tuff_in_range(radius, TUFF_MAX_BOUNDING_RADIUS));
    mover->shape.radius = tuff_flush(radius);
    mover->hull = *hull;
    mover->scratch = scratch;
    mover->shape.seams = false;
    mover->shape.neighbor_count = 0;
    return tuff_in_range(radius, TUFF_MAX_BOUNDING_RADIUS);
}

TUFF_HOT bool tuff_polygon_polygon(const tuff_polygon *hull, tuff_vec2 offset, const tuff_polygon *polygon, tuff_contact *contact)
{
    const tuff_vec2 flushed = tuff_vec2_flush(offset);
    tuff_unit2 scratch[TUFF_MAX_VERTICES];
    TUFF_ASSERT(polygon != NULL && hull != NULL && contact != NULL);
    if (polygon == NULL || !tuff_baked(polygon) || !tuff_is_hull(hull)) return false;
    /* Both lie within a bounding radius of their owners. */
    if (!tuff_in_box(offset, TUFF_WHOLE(2 * TUFF_MAX_BOUNDING_RADIUS))) return false;
    tuff_axis best = tuff_first_axis(polygon, hull, flushed);
    if (best.separation >= 0) return false;
    tuff_polygon shape = *hull;
    return least_contact(&shape, scratch, flushed, polygon, &best, contact);
}
