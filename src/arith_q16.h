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
static inline tuff_wide tuff_facing(tuff_unit2 a, tuff_unit2 b)    { return tuff_dot32(a.x, a.y, b.x, b.y); }
static inline tuff_area tuff_dot(tuff_vec2 a, tuff_vec2 b)         { return tuff_dot32(a.x, a.y, b.x, b.y); }
static inline tuff_area tuff_square_of(tuff_real a)                { return (int64_t)a * a; }
static inline tuff_wide tuff_widen(tuff_real a)                    { return (int64_t)a * TUFF_UNIT_ONE; }

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

/* To nearest, halves away from zero. */
static inline int64_t tuff_shift_nearest(int64_t a, unsigned bits)
{
    int64_t half = (int64_t)1 << (bits - 1);
    return a < 0 ? -((half - a) >> bits) : (a + half) >> bits;
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
static inline int32_t tuff_ceil(tuff_real a)  { return (int32_t)(((int64_t)a + 65535) >> TUFF_REAL_BITS); }

/* Within a square about the origin? */
static inline bool tuff_in_box(tuff_vec2 a, tuff_real limit)
{
    return a.x < limit && a.x > -limit && a.y < limit && a.y > -limit;
}

/* a - b if it lies inside the open circle of this radius (0 .. 2 * TUFF_MAX_BOUNDING_RADIUS); else false. The box
   first: it keeps the squares within 64 bits. */
static inline bool tuff_offset_within(tuff_vec2 a, tuff_vec2 b, tuff_real radius, tuff_vec2 *offset)
{
    int64_t x = (int64_t)a.x - b.x;
    int64_t y = (int64_t)a.y - b.y;
    if (x >= radius || x <= -(int64_t)radius || y >= radius || y <= -(int64_t)radius) return false;
    offset->x = (tuff_real)x;
    offset->y = (tuff_real)y;
    return tuff_dot(*offset, *offset) < tuff_square_of(radius);
}

/* Do the closed circles about a and b touch? Radii 0 or more: sums to 2^32, squares to 2^64, so unsigned; after the
   box the sum of the squares could reach 2^65: it is compared by a subtraction instead. */
static inline bool tuff_circles_touch(tuff_vec2 a, tuff_real a_radius, tuff_vec2 b, tuff_real b_radius)
{
    int64_t reach = (int64_t)a_radius + b_radius;
    int64_t x = (int64_t)a.x - b.x;
    int64_t y = (int64_t)a.y - b.y;
    if (x > reach || x < -reach || y > reach || y < -reach) return false;
    uint64_t room = (uint64_t)reach * (uint64_t)reach - (uint64_t)(x < 0 ? -x : x) * (uint64_t)(x < 0 ? -x : x);
    return (uint64_t)(y < 0 ? -y : y) * (uint64_t)(y < 0 ? -y : y) <= room;
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

/* a * b + c * d of 34-bit factors: exact where it is within 2^61 - 2^51, else +-TUFF_FAR_HUGE. High and low words of
   b and d: |high| < 2^18, so that the sum of the high products has at most 53 bits, that of the low ones at most 51. */
static inline int64_t tuff_far_sum(int64_t a, int64_t b, int64_t c, int64_t d)
{
    int64_t high = a * (b >> 16) + c * (d >> 16);
    int64_t low = a * (b & 0xFFFF) + c * (d & 0xFFFF);
    if (high > (int64_t)1 << 45) return TUFF_FAR_HUGE;
    if (high < -((int64_t)1 << 45)) return -TUFF_FAR_HUGE;
    return high * 65536 + low;
}

static inline int64_t tuff_far_dot(tuff_far2 a, tuff_far2 b)   { return tuff_far_sum(a.x, b.x, a.y, b.y); }
static inline int64_t tuff_far_cross(tuff_far2 a, tuff_far2 b) { return tuff_far_sum(a.x, b.y, -a.y, b.x); }

/* d x p for every p of the line through a and b. */
static inline int64_t tuff_line_across(tuff_far2 d, tuff_far2 a, tuff_far2 b)
{
    (void)b;
    return tuff_far_cross(d, a);
}

/* d x v: 33 and 27 bits. */
static inline int64_t tuff_far_cross_near(tuff_far2 d, tuff_vec2 v)
{
    return (int64_t)((uint64_t)d.x * (uint64_t)(int64_t)v.y - (uint64_t)d.y * (uint64_t)(int64_t)v.x);
}

/* Does index order go round from +x to +y? Asked of the first edge that has a length and a normal: the normal is
   outward. */
static inline bool tuff_turns_forward(const tuff_polygon *polygon)
{
    uint8_t i;
    for (i = 0; i < polygon->count; ++i) {
        tuff_vec2 right = tuff_right_of(polygon->vertices[i], polygon->vertices[i + 1 == polygon->count ? 0 : i + 1]);
        tuff_wide facing = tuff_project(polygon->normals[i], right);
        if (facing != 0) return facing > 0;
    }
    return true;
}

/* How far p lies outside of edge i, times the edge's length; forward: tuff_turns_forward. Exact: 28 by 34 bits, twice. */
static inline tuff_area tuff_edge_outside(const tuff_polygon *polygon, uint8_t i, bool forward, tuff_far2 p)
{
    tuff_vec2 from = polygon->vertices[i];
    tuff_vec2 to = polygon->vertices[i + 1 == polygon->count ? 0 : i + 1];
    int64_t ex = (int64_t)to.x - from.x;
    int64_t ey = (int64_t)to.y - from.y;
    uint64_t right = (uint64_t)ey * (uint64_t)(p.x - from.x) - (uint64_t)ex * (uint64_t)(p.y - from.y);
    return (int64_t)(forward ? right : 0u - right);
}

/* A seam between two parts needs no margin where sides are exact. */
static inline tuff_area tuff_seam_margin(tuff_far2 d)
{
    (void)d;
    return 0;
}

/* Is p inside the closed disc about the origin? */
static inline bool tuff_far_inside(tuff_far2 p, tuff_real radius)
{
    if (p.x > radius || p.x < -(int64_t)radius || p.y > radius || p.y < -(int64_t)radius) return false;
    return (uint64_t)(p.x * p.x) + (uint64_t)(p.y * p.y) <= (uint64_t)tuff_square_of(radius);
}

#endif
