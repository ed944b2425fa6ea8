/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The inner arithmetic of the float build: the vocabulary of arith.h in float. Compiled with -ffp-contract=off.
   Machines that trap denormals (N64) never meet one: whatever comes in below TUFF_TINY = 2^-48 counts as zero. A
   product of two such numbers, or of a difference of two (2^-71 or more) and a normal's component (2^-32 or more),
   is above 2^-103, so even the last bit of a sum of products (2^-126) is a normal number. */
#ifndef TUFF_ARITH_FLOAT_H
#define TUFF_ARITH_FLOAT_H

typedef float tuff_wide;
typedef float tuff_area;
typedef float tuff_far;

#define TUFF_WIDE_LOWEST  (-3.0e38f)
#define TUFF_WIDE_NEAR    (1.0f / 1024.0f)    /* a projection over 4,096 units is good to 2^-10 */
#define TUFF_UNIT_ONE     1.0f
#define TUFF_TINY         3.5527137e-15f      /* 2^-48 */

/* Without a branch where the CPU has a maximum. */
static inline float tuff_abs(float a)   { return a > -a ? a : -a; }

static inline float tuff_clamp(float a, float limit)
{
    return a > limit ? limit : a < -limit ? -limit : a;
}

/* Zero for whatever is too small to matter. */
static inline float tuff_flush(float a) { return tuff_abs(a) < TUFF_TINY ? 0.0f : a; }

static inline tuff_vec2 tuff_vec2_flush(tuff_vec2 a)
{
    tuff_vec2 flushed = { tuff_flush(a.x), tuff_flush(a.y) };
    return flushed;
}

static inline tuff_vec2 tuff_vec2_sub(tuff_vec2 a, tuff_vec2 b)
{
    tuff_vec2 difference = { a.x - b.x, a.y - b.y };
    return difference;
}

static inline tuff_vec2 tuff_vec2_gap(tuff_vec2 a, tuff_vec2 b)
{
    return tuff_vec2_flush(tuff_vec2_sub(a, b));
}

static inline tuff_vec2 tuff_vec2_add(tuff_vec2 a, tuff_vec2 b)
{
    tuff_vec2 sum = { a.x + b.x, a.y + b.y };
    return sum;
}

/* to - from, turned a quarter from +y to +x. */
static inline tuff_vec2 tuff_right_of(tuff_vec2 from, tuff_vec2 to)
{
    tuff_vec2 right = { tuff_flush(to.y - from.y), tuff_flush(from.x - to.x) };
    return right;
}

static inline tuff_unit2 tuff_unit2_negate(tuff_unit2 n)
{
    tuff_unit2 opposite = { 0.0f - n.x, 0.0f - n.y };
    return opposite;
}

static inline tuff_wide tuff_project(tuff_unit2 n, tuff_vec2 v) { return n.x * v.x + n.y * v.y; }
static inline float tuff_roughly(tuff_wide a)                   { return a; }
static inline tuff_wide tuff_facing(tuff_unit2 a, tuff_unit2 b) { return a.x * b.x + a.y * b.y; }
static inline tuff_area tuff_dot(tuff_vec2 a, tuff_vec2 b)      { return a.x * b.x + a.y * b.y; }
static inline tuff_area tuff_cross(tuff_vec2 a, tuff_vec2 b)    { return a.x * b.y - a.y * b.x; }

static inline tuff_area tuff_area_sub(tuff_area a, tuff_area b) { return a - b; }
static inline tuff_area tuff_area_add(tuff_area a, tuff_area b) { return a + b; }
static inline tuff_wide tuff_wide_add(tuff_wide a, tuff_wide b) { return a + b; }
static inline tuff_area tuff_square_of(tuff_real a)             { return a * a; }
static inline tuff_wide tuff_widen(tuff_real a)                 { return a; }
static inline tuff_real tuff_narrow(tuff_wide a)                { return a; }

/* Is the sign of an area right, which is a sum of at most 30 products of vectors with this sum of squares? The products
   and their sum are good to 2^-19 of the squares. */
static inline bool tuff_area_sure(tuff_area area, tuff_area squares) { return tuff_abs(area) > squares * 1.9073486e-6f; }

/* False for NaN and infinity too. */
static inline bool tuff_number_ok(tuff_real a) { return tuff_abs(a) <= 3.0e38f; }

static inline bool tuff_normal_ok(tuff_unit2 n) { return tuff_abs(n.x) <= 2.0f && tuff_abs(n.y) <= 2.0f; }

/* What a push may leave of an overlap: 1e-4 units and two steps of position and shapes. */
static inline tuff_real tuff_residue(tuff_vec2 position, tuff_real size)
{
    return 1e-4f + (tuff_abs(position.x) + tuff_abs(position.y) + size) * 2.3841858e-7f;
}

static inline bool tuff_position_ok(tuff_vec2 position)
{
    return tuff_abs(position.x) <= (float)TUFF_MAX_POSITION && tuff_abs(position.y) <= (float)TUFF_MAX_POSITION;
}

static inline bool tuff_velocity_ok(tuff_vec2 velocity)
{
    return tuff_abs(velocity.x) <= (float)TUFF_MAX_SPEED && tuff_abs(velocity.y) <= (float)TUFF_MAX_SPEED;
}

/* Whole units below and above; beyond the positions: the nearest of their ends. */
static inline int32_t tuff_floor(tuff_real a)
{
    if (a >= (float)TUFF_MAX_POSITION) return TUFF_MAX_POSITION;
    if (!(a > -(float)TUFF_MAX_POSITION)) return -(int32_t)TUFF_MAX_POSITION;
    int32_t whole = (int32_t)tuff_flush(a);
    return (float)whole > a ? whole - 1 : whole;
}

static inline int32_t tuff_ceil(tuff_real a) { return -tuff_floor(0.0f - tuff_flush(a)); }

/* Within a square about the origin? False for NaN. */
static inline bool tuff_in_box(tuff_vec2 a, tuff_real limit)
{
    return tuff_abs(a.x) < limit && tuff_abs(a.y) < limit;
}

/* Half the side of a square that covers a and b, and its center, by a unit to spare for its rounding. */
static inline tuff_real tuff_middle(tuff_vec2 a, tuff_vec2 b, tuff_vec2 *center)
{
    tuff_vec2 first = tuff_vec2_flush(a);
    tuff_vec2 last = tuff_vec2_flush(b);
    float x = tuff_abs(last.x - first.x);
    float y = tuff_abs(last.y - first.y);
    center->x = tuff_flush(first.x + last.x) * 0.5f;
    center->y = tuff_flush(first.y + last.y) * 0.5f;
    return (x > y ? x : y) * 0.5f + 1.0f;
}

/* a - b if it lies inside the open circle of this radius; else false, for NaN too. */
static inline bool tuff_offset_within(tuff_vec2 a, tuff_vec2 b, tuff_real radius, tuff_vec2 *offset)
{
    tuff_vec2 d = tuff_vec2_sub(a, b);
    if (!tuff_in_box(d, radius)) return false;
    *offset = tuff_vec2_flush(d);
    return tuff_dot(*offset, *offset) < tuff_square_of(radius);
}

/* Do the closed squares about a and b touch? a is flushed. False for NaN. */
static inline bool tuff_squares_touch(tuff_vec2 a, tuff_real a_half, tuff_vec2 b, tuff_real b_half)
{
    float reach = tuff_flush(a_half) + tuff_flush(b_half);
    tuff_vec2 d = tuff_vec2_gap(a, b);
    return tuff_abs(d.x) <= reach && tuff_abs(d.y) <= reach;
}

/* Do the closed circles about a and b touch? a is flushed. */
static inline bool tuff_circles_touch(tuff_vec2 a, tuff_real a_radius, tuff_vec2 b, tuff_real b_radius)
{
    float reach = tuff_flush(a_radius) + tuff_flush(b_radius);
    tuff_vec2 d = tuff_vec2_gap(a, b);
    return tuff_squares_touch(a, a_radius, b, b_radius) && tuff_dot(d, d) <= reach * reach;
}

/* What a push may leave over, and the last digits of positions: at 32,768 units 1e-4, and one and a half times 2^-9. */
#define TUFF_STEP_MARGIN  (1.0f / 256.0f)

/* steps * step >= |motion| */
static inline bool tuff_steps_cover(tuff_vec2 motion, tuff_real step, uint16_t steps)
{
    float way = (float)steps * step;
    return way * way >= tuff_dot(motion, motion);
}

/* position + overlap * normal; stops at the edge of the range. */
static inline tuff_real tuff_pushed(tuff_real position, tuff_real overlap, tuff_unit normal)
{
    float moved = tuff_flush(position) + overlap * normal;
    return tuff_clamp(moved, (float)TUFF_MAX_POSITION);
}

/* --- beams ------------------------------------------------------------------------------------------------- */

typedef tuff_vec2 tuff_far2;

static inline tuff_far2 tuff_far_sub(tuff_vec2 a, tuff_vec2 b)          { return tuff_vec2_gap(a, b); }
static inline float tuff_far_dot(const tuff_far2 *a, const tuff_far2 *b)      { return tuff_dot(*a, *b); }
static inline float tuff_far_cross(const tuff_far2 *a, const tuff_far2 *b)    { return tuff_cross(*a, *b); }

/* d x p for every p of the line through a and b, by their middle: it is the same from either end, and near the obstacle
   where both ends are far. */
static inline float tuff_line_across(const tuff_far2 *d, const tuff_far2 *a, const tuff_far2 *b)
{
    tuff_vec2 middle = { tuff_flush(a->x + b->x) * 0.5f, tuff_flush(a->y + b->y) * 0.5f };
    return tuff_cross(*d, middle);
}

static inline float tuff_far_cross_near(const tuff_far2 *d, tuff_vec2 v)      { return tuff_cross(*d, v); }

/* How far p lies outside of edge i. */
static inline tuff_area tuff_edge_outside(const tuff_polygon *polygon, uint8_t i, bool forward, const tuff_far2 *p)
{
    (void)forward;
    return tuff_project(polygon->normals[i], tuff_vec2_sub(*p, polygon->vertices[i]));
}

/* The normals tell. */
static inline bool tuff_turns_forward(const tuff_polygon *polygon)
{
    (void)polygon;
    return true;
}

/* How far parts reach beyond the inner edge that they share, so that the line's and the edge's rounding cannot both miss a
   beam along it: 2^-11 units, or 2^-22 of the beam's length if that is more. */
static inline tuff_area tuff_seam_margin(const tuff_far2 *d)
{
    float length = tuff_abs(d->x) + tuff_abs(d->y);
    return length > 2048.0f ? length * 2.3841858e-7f : 4.8828125e-4f;
}

static inline bool tuff_far_narrow(tuff_far2 p, tuff_vec2 *narrow)
{
    *narrow = p;
    return true;
}

/* No way is quicker than the general one. */
static inline tuff_verdict tuff_near_verdict(const tuff_vec2 *a, const tuff_vec2 *b, const tuff_polygon *polygon)
{
    (void)a;
    (void)b;
    (void)polygon;
    return TUFF_UNSURE;
}

/* Is p inside the closed disc about the origin? */
static inline bool tuff_far_inside(const tuff_far2 *p, tuff_real radius)
{
    return tuff_abs(p->x) <= radius && tuff_abs(p->y) <= radius && tuff_dot(*p, *p) <= tuff_square_of(radius);
}

#endif
