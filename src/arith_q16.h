/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The inner arithmetic of the fixed build: the vocabulary of arith.h in integers. Formats: tuff_real Q16.16,
   tuff_unit Q2.30, tuff_wide Q18.46 (unit * real), tuff_area Q32.32 (real * real), tuff_far Q17.16 in 64 bits (the
   difference of two positions has 33 bits). Within the ranges of shapes.h nothing below wraps; beyond them (shapes
   that the checks refuse) sums and products wrap without undefined behavior, which is why they go through unsigned
   types. */
#ifndef TUFF_ARITH_Q16_H
#define TUFF_ARITH_Q16_H

typedef int64_t tuff_wide;
typedef int64_t tuff_area;
typedef int64_t tuff_far;

#define TUFF_WIDE_LOWEST  (-((tuff_wide)1 << 62))             /* projections are above -2^60 */
#define TUFF_WIDE_NEAR    ((tuff_wide)1 << TUFF_UNIT_BITS)   /* 1 LSB; the rounding of a projection is at most 1/4 */
#define TUFF_UNIT_ONE     ((tuff_unit)1 << TUFF_UNIT_BITS)

static inline int32_t tuff_wrap_sub(int32_t a, int32_t b)
{
    return (int32_t)((uint32_t)a - (uint32_t)b);
}

static inline tuff_vec2 tuff_vec2_sub(tuff_vec2 a, tuff_vec2 b)
{
    tuff_vec2 difference = { tuff_wrap_sub(a.x, b.x), tuff_wrap_sub(a.y, b.y) };
    return difference;
}

static inline tuff_vec2 tuff_vec2_add(tuff_vec2 a, tuff_vec2 b)
{
    tuff_vec2 sum = { (int32_t)((uint32_t)a.x + (uint32_t)b.x), (int32_t)((uint32_t)a.y + (uint32_t)b.y) };
    return sum;
}

/* to - from, turned a quarter from +y to +x. */
static inline tuff_vec2 tuff_right_of(tuff_vec2 from, tuff_vec2 to)
{
    tuff_vec2 right = { tuff_wrap_sub(to.y, from.y), tuff_wrap_sub(from.x, to.x) };
    return right;
}

/* Nothing is too small to matter. */
static inline tuff_real tuff_flush(tuff_real a)                       { return a; }
static inline tuff_vec2 tuff_vec2_flush(tuff_vec2 a)                  { return a; }
static inline tuff_vec2 tuff_vec2_gap(tuff_vec2 a, tuff_vec2 b)       { return tuff_vec2_sub(a, b); }

static inline tuff_unit2 tuff_unit2_negate(tuff_unit2 n)
{
    tuff_unit2 opposite = { tuff_wrap_sub(0, n.x), tuff_wrap_sub(0, n.y) };
    return opposite;
}

/* a.x * b.x + a.y * b.y of 32-bit components in 64 bits. */
static inline int64_t tuff_dot32(int32_t ax, int32_t ay, int32_t bx, int32_t by)
{
    return (int64_t)((uint64_t)((int64_t)ax * bx) + (uint64_t)((int64_t)ay * by));
}

static inline tuff_wide tuff_project(tuff_unit2 n, tuff_vec2 v)    { return tuff_dot32(n.x, n.y, v.x, v.y); }
static inline int32_t tuff_roughly(tuff_wide a)                    { return (int32_t)(a >> 32); }
static inline tuff_wide tuff_facing(tuff_unit2 a, tuff_unit2 b)    { return tuff_dot32(a.x, a.y, b.x, b.y); }
static inline tuff_area tuff_dot(tuff_vec2 a, tuff_vec2 b)         { return tuff_dot32(a.x, a.y, b.x, b.y); }
static inline tuff_area tuff_square_of(tuff_real a)                { return (int64_t)a * a; }
static inline tuff_wide tuff_widen(tuff_real a)                    { return (int64_t)((uint64_t)(uint32_t)a << TUFF_UNIT_BITS); }

static inline tuff_area tuff_area_sub(tuff_area a, tuff_area b)    { return (int64_t)((uint64_t)a - (uint64_t)b); }
static inline tuff_area tuff_area_add(tuff_area a, tuff_area b)    { return (int64_t)((uint64_t)a + (uint64_t)b); }
static inline tuff_wide tuff_wide_add(tuff_wide a, tuff_wide b)    { return (int64_t)((uint64_t)a + (uint64_t)b); }

/* Areas are exact. */
static inline bool tuff_area_sure(tuff_area area, tuff_area squares)
{
    (void)area;
    (void)squares;
    return true;
}

/* a x b: 64 bits, exact for |components| < 2^31. */
static inline tuff_area tuff_cross(tuff_vec2 a, tuff_vec2 b)
{
    return (int64_t)((uint64_t)((int64_t)a.x * b.y) - (uint64_t)((int64_t)a.y * b.x));
}

/* To nearest, halves away from zero: of a negative number, rounded down by its shift, a half and all below go down if one less than a half
   is added. */
static inline int64_t tuff_shift_nearest(int64_t a, unsigned bits)
{
    int64_t half = (int64_t)1 << (bits - 1);
    return (a + (half + (a >> 63))) >> bits;
}

static inline tuff_real tuff_narrow(tuff_wide a)
{
    return (tuff_real)tuff_shift_nearest(a, TUFF_UNIT_BITS);
}

static inline int32_t tuff_clamp64(int64_t a, int32_t limit)
{
    return a > limit ? limit : a < -(int64_t)limit ? -limit : (int32_t)a;
}

/* Every tuff_real is a position. Speeds are clamped where they are used. */
static inline bool tuff_position_ok(tuff_vec2 position) { (void)position; return true; }
static inline bool tuff_velocity_ok(tuff_vec2 velocity) { (void)velocity; return true; }
static inline bool tuff_number_ok(tuff_real a)          { (void)a; return true; }
static inline bool tuff_normal_ok(tuff_unit2 n)         { (void)n; return true; }

/* What a push may leave of an overlap. */
static inline tuff_real tuff_residue(tuff_vec2 position, tuff_real size)
{
    (void)position;
    (void)size;
    return 2;
}

/* Whole units below and above. */
static inline int32_t tuff_floor(tuff_real a) { return a >> TUFF_REAL_BITS; }
static inline int32_t tuff_ceil(tuff_real a)  { return (a >> TUFF_REAL_BITS) + ((a & 0xFFFF) != 0 ? 1 : 0); }

/* Within a square about the origin? */
static inline bool tuff_in_box(tuff_vec2 a, tuff_real limit)
{
    return a.x < limit && a.x > -limit && a.y < limit && a.y > -limit;
}

/* |a - b|, which may have 32 bits. */
static inline uint32_t tuff_apart(tuff_real a, tuff_real b)
{
    return a > b ? (uint32_t)a - (uint32_t)b : (uint32_t)b - (uint32_t)a;
}

/* Do the closed squares about a and b touch? Half sides of 0 or more. */
static inline bool tuff_squares_touch(tuff_vec2 a, tuff_real a_half, tuff_vec2 b, tuff_real b_half)
{
    uint32_t reach = (uint32_t)a_half + (uint32_t)b_half;
    return tuff_apart(a.x, b.x) <= reach && tuff_apart(a.y, b.y) <= reach;
}

/* Half the side of a square that covers a and b, and its center, which halves rounded down put off by less than 1. */
static inline tuff_real tuff_middle(tuff_vec2 a, tuff_vec2 b, tuff_vec2 *center)
{
    uint32_t x = tuff_apart(a.x, b.x);
    uint32_t y = tuff_apart(a.y, b.y);
    center->x = (a.x >> 1) + (b.x >> 1);
    center->y = (a.y >> 1) + (b.y >> 1);
    return (tuff_real)(((x > y ? x : y) >> 1) + 2);
}

/* a - b if it lies inside the open circle of this radius (0 .. 2 * TUFF_MAX_BOUNDING_RADIUS); else false. The box
   first: it keeps the difference within 32 bits and the squares within 64. */
static inline bool tuff_offset_within(tuff_vec2 a, tuff_vec2 b, tuff_real radius, tuff_vec2 *offset)
{
    if (tuff_apart(a.x, b.x) >= (uint32_t)radius || tuff_apart(a.y, b.y) >= (uint32_t)radius) return false;
    *offset = tuff_vec2_sub(a, b);
    return tuff_dot(*offset, *offset) < tuff_square_of(radius);
}

/* Do the closed circles about a and b touch? Radii 0 or more: sums to 2^32, squares to 2^64, so unsigned; after the
   box the sum of the squares could reach 2^65: it is compared by a subtraction instead. */
static inline bool tuff_circles_touch(tuff_vec2 a, tuff_real a_radius, tuff_vec2 b, tuff_real b_radius)
{
    uint64_t reach = (uint32_t)a_radius + (uint32_t)b_radius;
    uint64_t x = tuff_apart(a.x, b.x);
    uint64_t y = tuff_apart(a.y, b.y);
    return x <= reach && y <= reach && y * y <= reach * reach - x * x;
}

/* What a push may leave over, and as much again. */
#define TUFF_STEP_MARGIN  4

/* steps * step >= |motion|, exactly; 0 <= step < 2^31. A product of 32 bits or more is longer than any motion within the positions. */
static inline bool tuff_steps_cover(tuff_vec2 motion, tuff_real step, uint16_t steps)
{
    uint64_t way = (uint64_t)steps * (uint32_t)step;
    uint64_t square = (uint64_t)((int64_t)motion.x * motion.x) + (uint64_t)((int64_t)motion.y * motion.y);
    return way >> 32 != 0 || way * way >= square;
}

/* position + overlap * normal, to nearest; saturates at the edge of the range. */
static inline tuff_real tuff_pushed(tuff_real position, tuff_real overlap, tuff_unit normal)
{
    int64_t moved = position + tuff_shift_nearest((int64_t)overlap * normal, TUFF_UNIT_BITS);
    return (tuff_real)(moved > TUFF_INT32_MAX ? TUFF_INT32_MAX : moved < TUFF_INT32_MIN ? TUFF_INT32_MIN : moved);
}

#define tuff_farthest_edge  TUFF_LINK_NAME(farthest_edge)

/* The edge whose line the point is farthest beyond, the lowest of equals; or one found on the way that it is surely beyond. */
TUFF_HOT uint32_t tuff_farthest_edge(const tuff_polygon *polygon, const tuff_vec2 *point, tuff_wide *separation);

/* --- beams ------------------------------------------------------------------------------------------------- */

typedef struct tuff_far2 { tuff_far x, y; } tuff_far2;

/* What tuff_far_dot and tuff_far_cross answer where the exact value is beyond 2^61: larger than whatever it is
   compared with. */
#define TUFF_FAR_HUGE ((int64_t)1 << 62)

static inline tuff_far2 tuff_far_sub(tuff_vec2 a, tuff_vec2 b)
{
    tuff_far2 difference = { (int64_t)a.x - b.x, (int64_t)a.y - b.y };
    return difference;
}

/* Does a difference fit 32 bits? Then *narrow is it. */
static inline bool tuff_far_narrow(tuff_far2 p, tuff_vec2 *narrow)
{
    narrow->x = (int32_t)p.x;
    narrow->y = (int32_t)p.y;
    return narrow->x == p.x && narrow->y == p.y;
}

/* d x v: 33 and 27 bits. */
static inline int64_t tuff_far_cross_near(const tuff_far2 *d, tuff_vec2 v)
{
    return (int64_t)((uint64_t)d->x * (uint64_t)(int64_t)v.y - (uint64_t)d->y * (uint64_t)(int64_t)v.x);
}

/* A seam between two parts needs no margin where sides are exact. */
static inline tuff_area tuff_seam_margin(const tuff_far2 *d)
{
    (void)d;
    return 0;
}

#define tuff_far_dot        TUFF_LINK_NAME(far_dot)
#define tuff_far_cross      TUFF_LINK_NAME(far_cross)
#define tuff_edge_outside   TUFF_LINK_NAME(edge_outside)
#define tuff_turns_forward  TUFF_LINK_NAME(turns_forward)
#define tuff_near_verdict   TUFF_LINK_NAME(near_verdict)

/* 64-bit products are calls on small machines: these are there once. Factors of 34 bits. */
tuff_area tuff_far_dot(const tuff_far2 *a, const tuff_far2 *b);
tuff_area tuff_far_cross(const tuff_far2 *a, const tuff_far2 *b);

/* d x p for every p of the line through a and b. */
static inline tuff_area tuff_line_across(const tuff_far2 *d, const tuff_far2 *a, const tuff_far2 *b)
{
    (void)b;
    return tuff_far_cross(d, a);
}

/* Is p inside the closed disc about the origin? */
static inline bool tuff_far_inside(const tuff_far2 *p, tuff_real radius)
{
    tuff_vec2 narrow;
    return tuff_far_narrow(*p, &narrow) && (uint64_t)tuff_dot(narrow, narrow) <= (uint64_t)tuff_square_of(radius);
}

/* Does index order go round from +x to +y? Asked of the first edge that has a length and a normal: the normal is
   outward. */
bool tuff_turns_forward(const tuff_polygon *polygon);

/* How far p lies outside of edge i, times the edge's length; forward: tuff_turns_forward. Exact: 28 by 34 bits, twice. */
tuff_area tuff_edge_outside(const tuff_polygon *polygon, uint8_t i, bool forward, const tuff_far2 *p);

/* Unsure: an end is far; or the first vertex lies on the line and none to its right, which the other order of the ends settles
   unless all lie on it. */
TUFF_HOT tuff_verdict tuff_near_verdict(const tuff_vec2 *a, const tuff_vec2 *b, const tuff_polygon *polygon);

#endif
