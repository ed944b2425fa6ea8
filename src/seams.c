/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What is no way out for a hull: a corner between two parts of an outline that has no such normal there, an edge that the hull
   is only beside, and, where it meets several pieces at once, a side that another piece covers and a corner that another piece
   rises from. */
#include "inner.h"

/* Is the point in the closed part, or out of it by no more than this? */
static bool holds(const tuff_polygon *part, tuff_vec2 point, tuff_wide slack)
{
    uint8_t i;
    for (i = 0; i < part->count; ++i) {
        if (tuff_beyond_edge(part, i, point) > slack) return false;
    }
    return true;
}

/* Does the part reach beyond the point along the axis? */
static bool rises(const tuff_polygon *part, tuff_vec2 point, tuff_unit2 axis, tuff_wide slack)
{
    uint8_t i;
    for (i = 0; i < part->count; ++i) {
        if (tuff_project(axis, tuff_vec2_sub(part->vertices[i], point)) > slack) return true;
    }
    return false;
}

/* Does a neighbor of the piece tested cover the line between two points of it, and go on from there along the axis? */
static bool buried(const tuff_mover *mover, tuff_vec2 from, tuff_vec2 to, tuff_unit2 axis)
{
    const tuff_wide slack = tuff_widen(tuff_residue(mover->piece->position, mover->piece->bounding_radius));
    uint8_t i;
    for (i = 0; i < mover->neighbor_count; ++i) {
        const tuff_terrain *other = mover->neighbors[i];
        tuff_vec2 between = tuff_vec2_sub(mover->piece->position, other->position);
        tuff_vec2 first = tuff_vec2_add(from, between);
        tuff_vec2 last = tuff_vec2_add(to, between);
        uint8_t k;
        for (k = 0; other != mover->piece && tuff_piece_baked(other) && k < other->part_count; ++k) {
            const tuff_polygon *part = &other->parts[k];
            if (holds(part, first, slack) && holds(part, last, slack) && rises(part, first, axis, slack)) return true;
        }
    }
    return false;
}

/* ---- corners ---- */

/* Where the outline goes on at a vertex of a part, one of whose edges there is internal: along another part's edge, from the
   vertex by this much. False: no other part has such an edge. */
static bool outline_beyond(const tuff_terrain *piece, const tuff_polygon *part, tuff_vec2 vertex, tuff_vec2 *along)
{
    uint8_t i;
    for (i = 0; i < piece->part_count; ++i) {
        const tuff_polygon *other = &piece->parts[i];
        uint8_t from;
        for (from = 0; other != part && from < other->count; ++from) {
            tuff_vec2 a = tuff_vec2_gap(other->vertices[from], vertex);
            tuff_vec2 b = tuff_vec2_gap(other->vertices[tuff_next_index(from, other->count)], vertex);
            bool begins = a.x == 0 && a.y == 0;
            if (tuff_edge_is_internal(other, from) || !(begins || (b.x == 0 && b.y == 0))) continue;
            *along = begins ? b : a;
            return true;
        }
    }
    return false;
}

/* Both edges of the vertex are internal, or one is, and the outline, which goes on along another part, does not bend away from
   the axis. Where no part has it, the nearer of the two normals tells. */
static bool between_parts(const tuff_mover *mover, const tuff_polygon *part, uint8_t vertex, tuff_unit2 axis)
{
    tuff_vec2 along;
    uint8_t before = tuff_previous_index(vertex, part->count);
    bool before_is_internal = tuff_edge_is_internal(part, before);
    if (before_is_internal == tuff_edge_is_internal(part, vertex)) return before_is_internal;
    tuff_unit2 outward = part->normals[before_is_internal ? vertex : before];
    tuff_unit2 inward = part->normals[before_is_internal ? before : vertex];
    if (mover->piece == NULL || !outline_beyond(mover->piece, part, part->vertices[vertex], &along)) {
        return tuff_facing(inward, axis) > tuff_facing(outward, axis);
    }
    return tuff_project(outward, along) >= 0 || tuff_project(axis, along) > 0;
}

bool tuff_corner_is_internal(const tuff_mover *mover, const tuff_polygon *part, uint8_t vertex, tuff_unit2 axis)
{
    tuff_vec2 at = part->vertices[vertex];
    return between_parts(mover, part, vertex, axis) || (mover->seams && buried(mover, at, at, axis));
}

/* ---- sides ---- */

/* What the hull covers of a line along this direction. */
typedef struct span {
    tuff_wide low;
    tuff_wide high;
} span;

static span span_along(const tuff_polygon *hull, tuff_vec2 offset, tuff_unit2 along)
{
    tuff_wide first = tuff_project(along, tuff_vec2_add(hull->vertices[0], offset));
    span covered = { first, first };
    uint8_t i;
    for (i = 1; i < hull->count; ++i) {
        tuff_wide at = tuff_project(along, tuff_vec2_add(hull->vertices[i], offset));
        if (at < covered.low) covered.low = at;
        if (at > covered.high) covered.high = at;
    }
    return covered;
}

/* The point of an edge that lies so far along it, or the end that is nearer. */
static tuff_vec2 point_of_edge(tuff_vec2 from, tuff_vec2 to, tuff_unit2 along, tuff_wide at)
{
    tuff_wide way = at - tuff_project(along, from);
    if (way <= 0) return from;
    if (at >= tuff_project(along, to)) return to;
    tuff_vec2 ahead = { tuff_scale(tuff_narrow(way), along.x), tuff_scale(tuff_narrow(way), along.y) };
    return tuff_vec2_add(from, ahead);
}

/* The direction of an edge, from its first vertex to the next. */
static tuff_unit2 direction_of(const tuff_polygon *part, uint8_t edge)
{
    tuff_unit2 normal = part->normals[edge];
    tuff_unit2 along = { normal.y, tuff_unit2_negate(normal).x };
    tuff_vec2 way = tuff_vec2_sub(part->vertices[tuff_next_index(edge, part->count)], part->vertices[edge]);
    return tuff_project(along, way) < 0 ? tuff_unit2_negate(along) : along;
}

bool tuff_edge_beside(const tuff_mover *mover, tuff_vec2 offset, const tuff_polygon *part, uint8_t edge)
{
    uint8_t next = tuff_next_index(edge, part->count);
    bool starts_inside = tuff_edge_is_internal(part, tuff_previous_index(edge, part->count));
    bool ends_inside = tuff_edge_is_internal(part, next);
    if (!starts_inside && !ends_inside) return false;
    tuff_unit2 along = direction_of(part, edge);
    span covered = span_along(&mover->hull, offset, along);
    return (starts_inside && covered.high < tuff_project(along, part->vertices[edge])) ||
           (ends_inside && covered.low > tuff_project(along, part->vertices[next]));
}

bool tuff_edge_buried(const tuff_mover *mover, tuff_vec2 offset, const tuff_polygon *part, uint8_t edge)
{
    tuff_unit2 along = direction_of(part, edge);
    tuff_vec2 from = part->vertices[edge];
    tuff_vec2 to = part->vertices[tuff_next_index(edge, part->count)];
    span covered = span_along(&mover->hull, offset, along);
    tuff_vec2 first = point_of_edge(from, to, along, covered.low);
    tuff_vec2 last = point_of_edge(from, to, along, covered.high);
    return buried(mover, first, last, part->normals[edge]);
}
