/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Hull against convex polygon: separating axes over the edge normals of both (Ericson, Real-Time Collision
   Detection, 5.2.1). One edge is asked first; after that nothing branches on a projection: which way it would go is as
   good as random, and a wrong guess costs a fast CPU more than all vertices of a small polygon do. */
#include "inner.h"

static inline tuff_wide lesser(tuff_wide a, tuff_wide b)
{
    return b < a ? b : a;
}

/* The least of normal . vertex. */
static inline tuff_wide least_projection(const tuff_polygon *polygon, tuff_unit2 normal)
{
    const tuff_vec2 *v = polygon->vertices;
    tuff_wide least = lesser(lesser(tuff_project(normal, v[0]), tuff_project(normal, v[1])), tuff_project(normal, v[2]));
    uint32_t i;
    for (i = 3; i < polygon->count; ++i) least = lesser(least, tuff_project(normal, v[i]));
    return least;
}

/* How far the nearest vertex of the other polygon, at this offset, lies beyond it. */
static inline tuff_wide separation_by(const tuff_polygon *polygon, uint32_t edge, const tuff_polygon *other, tuff_vec2 offset)
{
    return tuff_wide_add(least_projection(other, polygon->normals[edge]), tuff_beyond_edge(polygon, edge, offset));
}

/* The best axis so far: number is the edge's in the part, or TUFF_MAX_VERTICES and on in the hull. */
typedef struct tuff_axis {
    tuff_wide separation;
    uint32_t  number;
} tuff_axis;

static inline tuff_axis better_axis(tuff_axis best, tuff_wide separation, uint32_t number)
{
    best.number = separation > best.separation ? number : best.number;
    best.separation = separation > best.separation ? separation : best.separation;
    return best;
}

static uint32_t edge_facing(const tuff_polygon *part, tuff_vec2 point)
{
    tuff_axis best = { TUFF_WIDE_LOWEST, 0 };
    uint32_t i;
    for (i = 0; i < part->count; ++i) best = better_axis(best, tuff_beyond_edge(part, i, point), i);
    return best.number;
}

static tuff_axis best_of_part(tuff_axis best, const tuff_polygon *part, const tuff_polygon *hull, tuff_vec2 offset)
{
    uint32_t i;
    for (i = 0; i < part->count; ++i) best = better_axis(best, separation_by(part, i, hull, offset), i);
    return best;
}

static tuff_axis best_of_hull(tuff_axis best, const tuff_polygon *part, const tuff_polygon *hull, tuff_vec2 offset)
{
    const tuff_vec2 origin = { TUFF_WHOLE(0), TUFF_WHOLE(0) };
    const tuff_vec2 position = tuff_vec2_sub(origin, offset);
    uint32_t i;
    for (i = 0; i < hull->count; ++i) best = better_axis(best, separation_by(hull, i, part, position), TUFF_MAX_VERTICES + i);
    return best;
}

static uint8_t vertex_least_along(const tuff_polygon *polygon, tuff_unit2 axis)
{
    tuff_wide least = tuff_project(axis, polygon->vertices[0]);
    uint8_t vertex = 0;
    uint8_t i;
    for (i = 1; i < polygon->count; ++i) {
        tuff_wide projection = tuff_project(axis, polygon->vertices[i]);
        if (projection < least) {
            least = projection;
            vertex = i;
        }
    }
    return vertex;
}

/* A hull's own axis counts as internal where the outline, at the part's vertex that lies farthest against it, has no such
   normal. */
static bool hull_axis_is_internal(const tuff_mover *mover, const tuff_polygon *part, tuff_unit2 hull_normal)
{
    if (part->internal_edges == 0 && !mover->seams) return false;
    return tuff_corner_is_internal(mover, part, vertex_least_along(part, hull_normal), tuff_unit2_negate(hull_normal));
}

/* Is an axis no way out where the hull is: of an internal edge, or of one that it is not over or that another piece covers, or
   a hull's own that counts as one? */
static bool axis_is_internal(const tuff_mover *mover, tuff_vec2 offset, const tuff_polygon *part, uint32_t number)
{
    if (number >= TUFF_MAX_VERTICES) return hull_axis_is_internal(mover, part, mover->hull.normals[number - TUFF_MAX_VERTICES]);
    if (tuff_edge_is_internal(part, number)) return true;
    if (part->internal_edges != 0 && tuff_edge_beside(mover, offset, part, (uint8_t)number)) return true;
    return mover->seams && tuff_edge_buried(mover, offset, part, (uint8_t)number);
}

static void make_normals(tuff_mover *mover)
{
    if (mover->hull.normals == NULL) {
        tuff_edge_normals(mover->hull.vertices, mover->hull.count, mover->scratch);
        mover->hull.normals = mover->scratch;
    }
}

/* Which way a push along an axis goes. */
static inline tuff_unit2 way_along(const tuff_mover *mover, const tuff_polygon *part, uint32_t number)
{
    if (number < TUFF_MAX_VERTICES) return part->normals[number];
    return tuff_unit2_negate(mover->hull.normals[number - TUFF_MAX_VERTICES]);
}

static tuff_standing axis_contact(const tuff_mover *mover, tuff_vec2 offset, const tuff_polygon *part, tuff_axis best,
                                  tuff_contact *contact)
{
    tuff_real overlap = tuff_narrow(-best.separation);
    if (!(overlap > 0)) return TUFF_APART;
    contact->overlap = overlap;
    contact->normal = way_along(mover, part, best.number);
    return axis_is_internal(mover, offset, part, best.number) ? TUFF_BY_INTERNAL : TUFF_BY_OUTLINE;
}

/* Mostly what is apart is apart along the edge of the part that faces the hull's position most. */
static bool facing_edge_separates(const tuff_polygon *part, const tuff_polygon *hull, tuff_vec2 offset)
{
    return separation_by(part, edge_facing(part, offset), hull, offset) >= 0;
}

static tuff_standing all_axes(tuff_mover *mover, tuff_vec2 offset, const tuff_polygon *part, tuff_contact *contact)
{
    tuff_axis best = { TUFF_WIDE_LOWEST, 0 };
    best = best_of_part(best, part, &mover->hull, offset);
    if (best.separation >= 0) return TUFF_APART;
    make_normals(mover);
    best = best_of_hull(best, part, &mover->hull, offset);
    return best.separation >= 0 ? TUFF_APART : axis_contact(mover, offset, part, best, contact);
}

static bool axis_is_skipped(const tuff_mover *mover, tuff_vec2 offset, const tuff_polygon *part, uint32_t number, tuff_skipped skipped)
{
    if (skipped == TUFF_SKIP_BACK) return tuff_leads_back(way_along(mover, part, number), offset);
    return axis_is_internal(mover, offset, part, number);
}

/* The least of the axes that are not skipped, for a hull known to overlap; its normals are there. */
static tuff_standing unskipped_axes(const tuff_mover *mover, tuff_vec2 offset, const tuff_polygon *part, tuff_skipped skipped,
                                    tuff_contact *contact)
{
    const tuff_vec2 origin = { TUFF_WHOLE(0), TUFF_WHOLE(0) };
    const tuff_vec2 position = tuff_vec2_sub(origin, offset);
    tuff_axis best = { TUFF_WIDE_LOWEST, 0 };
    uint32_t i;
    for (i = 0; i < part->count; ++i) {
        if (!axis_is_skipped(mover, offset, part, i, skipped)) best = better_axis(best, separation_by(part, i, &mover->hull, offset), i);
    }
    for (i = 0; i < mover->hull.count; ++i) {
        uint32_t number = TUFF_MAX_VERTICES + i;
        if (axis_is_skipped(mover, offset, part, number, skipped)) continue;
        best = better_axis(best, separation_by(&mover->hull, i, part, position), number);
    }
    return best.separation == TUFF_WIDE_LOWEST ? TUFF_APART : axis_contact(mover, offset, part, best, contact);
}

TUFF_HOT tuff_standing tuff_hull_part(tuff_mover *mover, tuff_vec2 offset, const tuff_polygon *part, tuff_skipped skipped,
                                      tuff_contact *contact)
{
    if (skipped != TUFF_SKIP_NONE) return unskipped_axes(mover, offset, part, skipped, contact);
    if (facing_edge_separates(part, &mover->hull, offset)) return TUFF_APART;
    return all_axes(mover, offset, part, contact);
}

bool tuff_hull_mover(tuff_mover *mover, tuff_real radius, const tuff_polygon *hull, tuff_unit2 *scratch)
{
    mover->test = tuff_hull_part;
    TUFF_ASSERT(tuff_in_range(radius, TUFF_MAX_BOUNDING_RADIUS));
    mover->radius = tuff_flush(radius);
    mover->hull = *hull;
    mover->scratch = scratch;
    mover->seams = false;
    mover->neighbor_count = 0;
    return tuff_in_range(radius, TUFF_MAX_BOUNDING_RADIUS);
}

TUFF_HOT bool tuff_polygon_polygon(const tuff_polygon *hull, tuff_vec2 offset, const tuff_polygon *polygon, tuff_contact *contact)
{
    const tuff_vec2 flushed = tuff_vec2_flush(offset);
    tuff_unit2 scratch[TUFF_MAX_VERTICES];
    tuff_mover mover;
    TUFF_ASSERT(polygon != NULL && hull != NULL && contact != NULL);
    if (polygon == NULL || !tuff_baked(polygon) || !tuff_is_hull(hull)) return false;
    /* Both lie within a bounding radius of their owners. */
    if (!tuff_in_box(offset, TUFF_WHOLE(2 * TUFF_MAX_BOUNDING_RADIUS))) return false;
    if (facing_edge_separates(polygon, hull, flushed)) return false;
    (void)tuff_hull_mover(&mover, TUFF_WHOLE(0), hull, scratch);
    mover.piece = NULL;
    return all_axes(&mover, flushed, polygon, contact) != TUFF_APART;
}
