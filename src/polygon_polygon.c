/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Hull against convex polygon: separating axes over the edge normals of both (Ericson, Real-Time Collision
   Detection, 5.2.1). As the axis turns from one edge to the next, the nearest vertex of the other polygon only moves
   on in the same sense, so that the whole takes about two projections for each edge of both. */
#include "inner.h"

/* The vertex of a polygon nearest to a line, kept from axis to axis. */
typedef struct tuff_support {
    const tuff_vec2 *vertices;
    uint8_t count;
    uint8_t nearest;
    bool    ascending;      /* indices grow as the axis turns the way the other polygon's indices turn it */
    bool    known;          /* nearest is that of the axis before */
} tuff_support;

/* The least of normal . (vertex - shift). From a known neighbor it falls toward the least and never rises before it;
   equal values are passed (parallel edges, duplicate vertices). */
static tuff_wide least_projection(tuff_support *support, tuff_unit2 normal, tuff_vec2 shift)
{
    tuff_wide least = tuff_project(normal, tuff_vec2_sub(support->vertices[support->nearest], shift));
    uint8_t at = support->nearest;
    uint8_t left;
    for (left = support->count; left > 1; --left) {
        at = support->ascending ? tuff_next_index(at, support->count) : tuff_previous_index(at, support->count);
        tuff_wide projection = tuff_project(normal, tuff_vec2_sub(support->vertices[at], shift));
        if (projection <= least) {
            least = projection;
            support->nearest = at;
        } else if (support->known) {
            break;
        }
    }
    support->known = true;
    return least;
}

/* A hull's own axis counts as internal if, at the part's vertex that lies farthest against it, the nearer of the two
   adjacent normals is an internal edge's. */
static bool hull_axis_is_internal(const tuff_polygon *part, uint8_t vertex, tuff_unit2 hull_normal)
{
    tuff_unit2 axis = tuff_unit2_negate(hull_normal);
    uint8_t before = tuff_previous_index(vertex, part->count);
    bool nearer_before = tuff_facing(part->normals[before], axis) > tuff_facing(part->normals[vertex], axis);
    return tuff_edge_is_internal(part, nearer_before ? before : vertex);
}

/* The best axis so far. */
typedef struct tuff_axis {
    tuff_wide  separation;
    tuff_unit2 normal;
    bool       internal;
} tuff_axis;

/* Axes of the part. False: one separates. Bit i of skipped: edge i is not to be chosen. */
static bool part_axes(const tuff_polygon *part, const tuff_polygon *hull, tuff_vec2 offset, bool ascending, uint32_t skipped,
                      tuff_axis *best)
{
    tuff_support support = { hull->vertices, hull->count, 0, ascending, false };
    uint8_t i;
    for (i = 0; i < part->count; ++i) {
        tuff_wide separation = least_projection(&support, part->normals[i], tuff_vec2_sub(part->vertices[i], offset));
        if (separation >= 0) return false;
        if (separation > best->separation && (skipped >> i & 1u) == 0) {
            best->separation = separation;
            best->normal = part->normals[i];
            best->internal = tuff_edge_is_internal(part, i);
        }
    }
    return true;
}

/* Axes of the hull, likewise. */
static bool hull_axes(const tuff_polygon *part, const tuff_polygon *hull, tuff_vec2 offset, bool ascending, bool outline_only,
                      tuff_axis *best)
{
    tuff_support support = { part->vertices, part->count, 0, ascending, false };
    uint8_t i;
    for (i = 0; i < hull->count; ++i) {
        tuff_wide separation = least_projection(&support, hull->normals[i], tuff_vec2_add(hull->vertices[i], offset));
        if (separation >= 0) return false;
        if (separation <= best->separation) continue;
        bool internal = part->internal_edges != 0 && hull_axis_is_internal(part, support.nearest, hull->normals[i]);
        if (internal && outline_only) continue;
        best->separation = separation;
        best->normal = tuff_unit2_negate(hull->normals[i]);
        best->internal = internal;
    }
    return true;
}

static const tuff_polygon *with_normals(tuff_mover *mover)
{
    if (mover->hull.normals == NULL) {
        tuff_edge_normals(mover->hull.vertices, mover->hull.count, mover->scratch);
        mover->hull.normals = mover->scratch;
    }
    return &mover->hull;
}

TUFF_HOT tuff_standing tuff_hull_part(tuff_mover *mover, tuff_vec2 offset, const tuff_polygon *part, bool outline_only,
                                      tuff_contact *contact)
{
    const tuff_polygon *hull = with_normals(mover);
    bool ascending = tuff_goes_forward(part) == tuff_goes_forward(hull);
    tuff_axis best = { TUFF_WIDE_LOWEST, { 0, 0 }, false };
    if (!part_axes(part, hull, offset, ascending, outline_only ? part->internal_edges : 0, &best)) return TUFF_APART;
    if (!hull_axes(part, hull, offset, ascending, outline_only, &best)) return TUFF_APART;

    if (best.separation == TUFF_WIDE_LOWEST) return TUFF_APART;     /* no outline axis */
    tuff_real overlap = tuff_narrow(-best.separation);
    if (!(overlap > 0)) return TUFF_APART;
    contact->overlap = overlap;
    contact->normal = best.normal;
    return best.internal ? TUFF_BY_INTERNAL : TUFF_BY_OUTLINE;
}

bool tuff_hull_mover(tuff_mover *mover, tuff_real radius, const tuff_polygon *hull, tuff_unit2 *scratch)
{
    mover->test = tuff_hull_part;
    TUFF_ASSERT(tuff_in_range(radius, TUFF_MAX_BOUNDING_RADIUS));
    mover->radius = tuff_flush(radius);
    mover->hull = *hull;
    mover->scratch = scratch;
    return tuff_in_range(radius, TUFF_MAX_BOUNDING_RADIUS);
}

TUFF_HOT bool tuff_polygon_polygon(const tuff_polygon *hull, tuff_vec2 offset, const tuff_polygon *polygon, tuff_contact *contact)
{
    const tuff_vec2 origin = { TUFF_WHOLE(0), TUFF_WHOLE(0) };
    tuff_unit2 scratch[TUFF_MAX_VERTICES];
    tuff_mover mover;
    tuff_vec2 relative;
    TUFF_ASSERT(polygon != NULL && hull != NULL && contact != NULL);
    if (polygon == NULL || !tuff_baked(polygon) || !tuff_is_hull(hull)) return false;
    (void)tuff_hull_mover(&mover, TUFF_WHOLE(0), hull, scratch);
    /* Both lie within a bounding radius of their owners. */
    if (!tuff_offset_within(tuff_vec2_flush(offset), origin, TUFF_WHOLE(2 * TUFF_MAX_BOUNDING_RADIUS), &relative)) return false;
    return tuff_hull_part(&mover, relative, polygon, false, contact) != TUFF_APART;
}
