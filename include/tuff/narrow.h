/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   One shape against one obstacle. Positions are relative to the obstacle. Touching is no overlap: a contact's
   overlap is greater than zero after rounding. Where a call returns false, *contact is untouched. An obstacle that
   is not baked, and a radius that is negative, NaN or above its limit: false. Vertices out of range give a wrong
   answer, never a fault of the machine. */
#ifndef TUFF_NARROW_H
#define TUFF_NARROW_H

#include "shapes.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Does a circle overlap a circle? Radii 0 .. TUFF_MAX_BOUNDING_RADIUS. Coincident centers: out along +x by the full depth.
   Overlap: within 1/2 LSB (fixed), normal within 1e-8 rad (fixed) or 2e-7 (float). */
bool tuff_circle_circle(tuff_vec2 center, tuff_real radius, tuff_real obstacle_radius, tuff_contact *contact);

/* Does a circle overlap a convex polygon? Radius 0 .. TUFF_MAX_BOUNDING_RADIUS. The contact is the minimum
   translation in every Voronoi region (Ericson, Real-Time Collision Detection, 5.1 and 5.5.7); a center on a vertex
   takes an edge's normal. Ties: the lowest edge. Overlap: within 1 LSB (fixed), 5e-5 units for shapes up to 64 units
   (float). */
TUFF_HOT bool tuff_circle_polygon(tuff_vec2 center, tuff_real radius, const tuff_polygon *polygon, tuff_contact *contact);

/* Does a hull at this offset overlap a convex polygon? The contact is the minimum translation over the edge normals of both
   (separating axes: Ericson 5.2.1). Ties: the lowest edge, the obstacle's first. A hull without normals has them made on
   the stack here; its own internal_edges count for nothing. Accuracy as above. */
TUFF_HOT bool tuff_polygon_polygon(const tuff_polygon *hull, tuff_vec2 offset, const tuff_polygon *polygon, tuff_contact *contact);

/* Does the segment a-b touch the disc about the origin? Exact in the fixed build, for every a and b. */
bool tuff_segment_circle(tuff_vec2 a, tuff_vec2 b, tuff_real radius);

/* Does the segment a-b touch the closed polygon? Touching counts, a start inside counts, zero length is a point
   test; the ends may be swapped. Exact in the fixed build, for every a and b; in the float build outside of 1e-3
   units of touching, or length * 2^-22. */
TUFF_HOT bool tuff_segment_polygon(tuff_vec2 a, tuff_vec2 b, const tuff_polygon *polygon);

/* Does a circle or a hull overlap a piece, both at world positions? Bounding circles first, then the parts, or the
   piece's circle while it is not baked. The piece's contact is the deepest of its parts' contacts; a part whose
   least axis is an internal edge gives none while another part gives one (for a vertex and for a hull's own axis,
   the adjacent edge nearest to it decides); if no part gives one, the least outline axis of the overlapped parts; if
   those have no outline edge, the least internal axis. It is the first step out. */
bool tuff_terrain_overlap_circle(const tuff_terrain *piece, tuff_vec2 center, tuff_real radius, tuff_contact *contact);

/* radius covers the hull and is the circle used against a piece that is not baked; 0 .. TUFF_MAX_BOUNDING_RADIUS.
   hull NULL: the circle. */
bool tuff_terrain_overlap_hull(const tuff_terrain *piece, tuff_vec2 position, tuff_real radius, const tuff_polygon *hull,
                               tuff_contact *contact);

/* Outward unit normals of a convex polygon in either winding; each component within 0.8 * 2^-30 (fixed) or 2^-23
   (float). count: 3 .. TUFF_MAX_VERTICES, otherwise nothing is written. An edge without length takes the next real
   edge's; with none: (1, 0). */
void tuff_edge_normals(const tuff_vec2 *vertices, uint8_t count, tuff_unit2 *normals);

#ifdef __cplusplus
}
#endif

#endif
