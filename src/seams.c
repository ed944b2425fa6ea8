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
        if (tuff_reach(part->normals[i], tuff_vec2_sub(point, part->vertices[i])) > slack) return false;
    }
    return true;
}

/* Does the part reach beyond the point along the axis? */
static bool rises(const tuff_polygon *part, tuff_vec2 point, tuff_unit2 axis, tuff_wide slack)
{
    const tuff_vec2 farthest = part->vertices[tuff_least_along(part, tuff_unit2_negate(axis))];
    return tuff_reach(axis, tuff_vec2_sub(farthest, point)) > slack;
}

/* Does a part of a piece, from which the points are seen, hold the line between them, and go on from the first along the axis? */
static bool covers_line(const tuff_terrain *piece, const tuff_vec2 line[2], tuff_unit2 axis, tuff_wide slack)
{
    const tuff_polygon *part = piece->parts;
    const tuff_polygon *end = part + piece->part_count;
    for (; part != end; ++part) {
        if (holds(part, line[0], slack) && holds(part, line[1], slack) && rises(part, line[0], axis, slack)) return true;
    }
    return false;
}

/* Does a neighbor of the piece tested cover the line between two points of it, and go on from there along the axis? */
static bool buried(const tuff_mover *mover, const tuff_vec2 line[2], tuff_unit2 axis)
{
    const tuff_terrain *piece = mover->shape.piece;
    const tuff_wide slack = tuff_widen(tuff_residue(piece->position, piece->bounding_radius));
    uint8_t i;
    for (i = 0; i < mover->shape.neighbor_count; ++i) {
        const tuff_terrain *other = &mover->terrain[mover->neighbors[i]];
        const tuff_vec2 between = tuff_vec2_sub(piece->position, other->position);
        const tuff_vec2 seen[2] = { tuff_vec2_add(line[0], between), tuff_vec2_add(line[1], between) };
        if (other != piece && tuff_has_outline(other) && covers_line(other, seen, axis, slack)) return true;
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

/* tuff_facing by the function that is there: how far the tip of one reaches along the other, in another format. */
static tuff_wide facing(tuff_unit2 normal, tuff_unit2 axis)
{
    const tuff_vec2 tip = { normal.x, normal.y };
    return tuff_reach(axis, tip);
}

/* Both edges of the vertex are internal, or one is, and the outline, which goes on along another part, does not bend away from
   the axis. Where no part has it, the nearer of the two normals tells. Not static: merged into the only caller its frame would be there
   while the neighbors are asked, too. */
bool tuff_between_parts(const tuff_mover *mover, const tuff_polygon *part, uint8_t vertex, tuff_unit2 axis)
{
    tuff_vec2 along;
    uint8_t before = tuff_previous_index(vertex, part->count);
    bool before_is_internal = tuff_edge_is_internal(part, before);
    if (before_is_internal == tuff_edge_is_internal(part, vertex)) return before_is_internal;
    tuff_unit2 outward = part->normals[before_is_internal ? vertex : before];
    tuff_unit2 inward = part->normals[before_is_internal ? before : vertex];
    if (mover->shape.piece == NULL || !outline_beyond(mover->shape.piece, part, part->vertices[vertex], &along)) {
        return facing(inward, axis) > facing(outward, axis);
    }
    return tuff_reach(outward, along) >= 0 || tuff_reach(axis, along) > 0;
}

bool tuff_corner_is_internal(const tuff_mover *mover, const tuff_polygon *part, uint8_t vertex, tuff_unit2 axis)
{
    if (tuff_between_parts(mover, part, vertex, axis)) return true;
    if (!mover->shape.seams) return false;
    const tuff_vec2 corner[2] = { part->vertices[vertex], part->vertices[vertex] };
    return buried(mover, corner, axis);
}

/* ---- sides ---- */

/* An edge of a part, and its direction, from its first vertex to the next. */
typedef struct tuff_side {
    tuff_vec2  from, to;
    tuff_unit2 along;
} tuff_side;

static void side_of(tuff_side *side, const tuff_polygon *part, uint8_t edge)
{
    const tuff_unit2 normal = part->normals[edge];
    const tuff_unit2 along = { normal.y, tuff_unit2_negate(normal).x };
    side->from = part->vertices[edge];
    side->to = part->vertices[tuff_next_index(edge, part->count)];
    side->along = tuff_reach(along, tuff_vec2_sub(side->to, side->from)) < 0 ? tuff_unit2_negate(along) : along;
}

/* How far the hull's vertex that lies least far along one direction lies along another. */
static tuff_wide hull_reach(const tuff_mover *mover, tuff_unit2 least_along, tuff_unit2 along)
{
    const tuff_vec2 vertex = mover->hull.vertices[tuff_least_along(&mover->hull, least_along)];
    return tuff_reach(along, tuff_vec2_add(vertex, mover->shape.offset));
}

/* The point of an edge that lies so far along it, or the end that is nearer. */
static void point_of_edge(tuff_vec2 *point, const tuff_side *side, tuff_wide at)
{
    tuff_wide way = at - tuff_reach(side->along, side->from);
    *point = side->from;
    if (way <= 0) return;
    *point = side->to;
    if (at >= tuff_reach(side->along, side->to)) return;
    tuff_vec2 ahead = { tuff_scale(tuff_narrow(way), side->along.x), tuff_scale(tuff_narrow(way), side->along.y) };
    *point = tuff_vec2_add(side->from, ahead);
}

bool tuff_edge_beside(const tuff_mover *mover, const tuff_polygon *part, uint8_t edge)
{
    tuff_side side;
    bool starts_inside = tuff_edge_is_internal(part, tuff_previous_index(edge, part->count));
    bool ends_inside = tuff_edge_is_internal(part, tuff_next_index(edge, part->count));
    if (!starts_inside && !ends_inside) return false;
    side_of(&side, part, edge);
    if (starts_inside && hull_reach(mover, tuff_unit2_negate(side.along), side.along) < tuff_reach(side.along, side.from)) return true;
    return ends_inside && hull_reach(mover, side.along, side.along) > tuff_reach(side.along, side.to);
}

bool tuff_edge_buried(const tuff_mover *mover, const tuff_polygon *part, uint8_t edge)
{
    tuff_side side;
    tuff_vec2 line[2];
    side_of(&side, part, edge);
    point_of_edge(&line[0], &side, hull_reach(mover, side.along, side.along));
    point_of_edge(&line[1], &side, hull_reach(mover, tuff_unit2_negate(side.along), side.along));
    return buried(mover, line, part->normals[edge]);
}
