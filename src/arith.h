/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The arithmetic that the rest of src/ is written in. Both builds define the same names:

     tuff_wide, TUFF_WIDE_LOWEST     unit * real, before it is narrowed: what axes are compared in
     tuff_roughly(wide)              its leading digits: cheaper to compare
     TUFF_WIDE_NEAR                  within this of a face the side is not certain
     tuff_area                       real * real; its operators are + - < and so on
     tuff_far, tuff_far2             differences of positions; tuff_area holds their products with near vectors
     tuff_vec2_add, tuff_vec2_sub    a + b, a - b
     tuff_right_of(from, to)         to - from, turned a quarter from +y to +x
     tuff_vec2_gap                   a - b for squares and products: in float, too small to square is zero
     tuff_flush, tuff_vec2_flush     the same for what comes in
     tuff_project(n, v)              n . v, wide           tuff_widen, tuff_narrow    real, 0 or more, to wide; back, to nearest
     tuff_dot, tuff_cross            of near vectors       tuff_facing                of unit vectors
     tuff_offset_within              difference of positions inside an open circle
     tuff_squares_touch, tuff_circles_touch    closed squares and circles at any distance
     tuff_middle                     half the side and the center of a square that covers two points
     tuff_pushed                     position + overlap * normal, saturating
     tuff_steps_cover                steps * step against the length of a motion
     TUFF_STEP_MARGIN                how much deeper than thought a body may be after a step
     tuff_floor, tuff_ceil           whole units
     tuff_position_ok, tuff_velocity_ok, tuff_number_ok, tuff_normal_ok
     tuff_residue                    what a push may leave of an overlap
     tuff_area_add, tuff_area_sub, tuff_wide_add    where terms of bad shapes may be huge
     tuff_area_sure                  is an area's sign not lost in its rounding
     tuff_far_sub, tuff_far_narrow, tuff_far_dot, tuff_far_cross, tuff_far_cross_near, tuff_line_across, tuff_edge_outside,
     tuff_turns_forward, tuff_seam_margin, tuff_far_inside     beams
     tuff_near_verdict               segment against polygon where there is a quicker way than the general one; it may be
                                     sure of the ends in the other order only */
#ifndef TUFF_ARITH_H
#define TUFF_ARITH_H

#include "tuff/shapes.h"

typedef enum tuff_verdict { TUFF_MISSES, TUFF_MEETS, TUFF_UNSURE } tuff_verdict;

#include TUFF_ARITH_HEADER

#define tuff_normalize_xy    TUFF_LINK_NAME(normalize_xy)
#define tuff_reflect         TUFF_LINK_NAME(reflect)
#define tuff_chord_reaches   TUFF_LINK_NAME(chord_reaches)
#define tuff_ratio           TUFF_LINK_NAME(ratio)
#define tuff_ratio_less      TUFF_LINK_NAME(ratio_less)
#define tuff_circle_entry    TUFF_LINK_NAME(circle_entry)
#define tuff_far_direction   TUFF_LINK_NAME(far_direction)
#define tuff_along           TUFF_LINK_NAME(along)

/* Length of v, and its direction unless the length is 0. Fixed: the length to nearest, each component of the
   direction within 0.8 * 2^-30, (+-1, 0) and (0, +-1) exact. By components: a structure would be stored to be handed over. */
tuff_real tuff_normalize_xy(tuff_real x, tuff_real y, tuff_unit2 *direction);

static inline tuff_real tuff_normalize(tuff_vec2 v, tuff_unit2 *direction) { return tuff_normalize_xy(v.x, v.y, direction); }

/* If v . n < 0: v becomes (1 - friction) * v - (1 - friction + restitution) * (v . n) * n, within the speed limit.
   Fixed: rounded toward zero. 0 <= restitution <= TUFF_MAX_RESTITUTION, 0 <= friction <= 1. */
void tuff_reflect(tuff_vec2 *v, tuff_unit2 n, tuff_real restitution, tuff_real friction);

/* |across| <= radius * |d|, where across = d x a: does the line through a along d reach the circle about the origin? */
bool tuff_chord_reaches(tuff_area across, const tuff_far2 *d, tuff_real radius);

/* 0 <= part <= whole, whole > 0 */
typedef struct tuff_ratio_of { tuff_area part, whole; } tuff_ratio_of;

/* The value to nearest, and a comparison. */
tuff_unit tuff_ratio(tuff_area part, tuff_area whole);
bool tuff_ratio_less(const tuff_ratio_of *a, const tuff_ratio_of *b);

/* How far along the segment from a (outside) in steps of d the circle about the origin is entered; the segment is
   known to touch it. */
tuff_unit tuff_circle_entry(const tuff_far2 *a, const tuff_far2 *d, tuff_real radius);

/* Direction of d, which is not 0. */
tuff_unit2 tuff_far_direction(const tuff_far2 *d);

/* a + fraction * d, known to be near. */
tuff_vec2 tuff_along(const tuff_far2 *a, const tuff_far2 *d, tuff_unit fraction);

#endif
