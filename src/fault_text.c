/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A sentence for each fault. A switch, not a table: no copy in RAM on machines that cannot read constants in place,
   and a compiler's warning where one is missing. */
#include "tuff/check.h"

const char *tuff_fault_text(tuff_fault fault)
{
    switch (fault) {
    case TUFF_OK:                       return "no fault";
    case TUFF_FAULT_NULL:               return "a pointer that is needed is NULL";
    case TUFF_FAULT_TOO_FEW_VERTICES:   return "a polygon has fewer than 3 vertices";
    case TUFF_FAULT_TOO_MANY_VERTICES:  return "a polygon has more vertices than TUFF_MAX_VERTICES";
    case TUFF_FAULT_NOT_FINITE:         return "a number is NaN or infinite";
    case TUFF_FAULT_VERTEX_RANGE:       return "a vertex lies beyond TUFF_MAX_EXTENT";
    case TUFF_FAULT_DUPLICATE_VERTEX:   return "two successive vertices are the same";
    case TUFF_FAULT_NO_AREA:            return "a polygon has no area";
    case TUFF_FAULT_CONCAVE:            return "a polygon is not convex, or goes round more than once";
    case TUFF_FAULT_NO_NORMALS:         return "an obstacle's polygon has no normals";
    case TUFF_FAULT_NORMAL_LENGTH:      return "a normal is not a unit vector";
    case TUFF_FAULT_NORMAL_DIRECTION:   return "a normal is not square to its edge";
    case TUFF_FAULT_NORMAL_INWARD:      return "a normal points inward";
    case TUFF_FAULT_INTERNAL_BITS:      return "internal_edges marks an edge that the polygon does not have";
    case TUFF_FAULT_POSITION_RANGE:     return "a position lies beyond TUFF_MAX_POSITION";
    case TUFF_FAULT_RADIUS_RANGE:       return "a radius is negative or beyond TUFF_MAX_RADIUS";
    case TUFF_FAULT_BOUNDING_RANGE:     return "a bounding radius is not above 0 or beyond TUFF_MAX_BOUNDING_RADIUS";
    case TUFF_FAULT_BOUNDING_TOO_SMALL: return "a bounding radius does not cover a vertex or the circle";
    case TUFF_FAULT_INTERNAL_UNMATCHED: return "an internal edge is not shared over its whole length with another part";
    case TUFF_FAULT_VELOCITY_RANGE:     return "a velocity lies beyond TUFF_MAX_SPEED";
    case TUFF_FAULT_HULL_RADIUS:        return "the radius that goes with a hull does not cover it";
    case TUFF_FAULT_RESTITUTION_RANGE:  return "a restitution is negative or beyond TUFF_MAX_RESTITUTION";
    case TUFF_FAULT_FRICTION_RANGE:     return "a friction is negative or beyond TUFF_MAX_FRICTION";
    case TUFF_FAULT_TERRAIN_COUNT:      return "a world has more pieces than TUFF_MAX_PIECES";
    case TUFF_FAULT_ORDER:              return "a world's order is none of TUFF_ORDER_ITERATION and TUFF_ORDER_DEEPEST";
    case TUFF_FAULT_BUCKET_COUNT:       return "an index's bucket count is 0, beyond 32768 or not a power of two";
    case TUFF_FAULT_PITCH:              return "an index's pitch is beyond TUFF_MAX_PITCH_LOG2";
    case TUFF_FAULT_INDEX_STALE:        return "the index holds a piece that the terrain has not, or an empty slot";
    case TUFF_FAULT_INDEX_MISSING:      return "a piece is not in the index";
    case TUFF_FAULT_INDEX_MOVED:        return "a piece is no longer where the index has it, or has grown";
    case TUFF_FAULT_INDEX_BROKEN:       return "the index's lists are broken: its storage was overwritten";
    case TUFF_FAULT_COUNT:              break;
    }
    return "no such fault";
}
