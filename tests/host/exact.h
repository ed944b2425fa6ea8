/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Numbers of 113 bits for the host tests, in steps of the fixed build (1/65536 unit) in both builds. Sums and products of two
   differences of coordinates are exact: nothing that a test compares is rounded before the comparison. */
#ifndef TUFF_TESTS_EXACT_H
#define TUFF_TESTS_EXACT_H

#include <float.h>
#include <math.h>

#include "tuff/tuff.h"

#if LDBL_MANT_DIG >= 113
typedef long double exact;
#elif defined(__SIZEOF_FLOAT128__)
__extension__ typedef __float128 exact;
#else
#error "the host tests need a floating-point type of 113 bits: __float128 or long double"
#endif

#define EXACT_UNIT  65536        /* steps to a world unit */

typedef struct exact2 { exact x, y; } exact2;

#if TUFF_SCALAR == TUFF_Q16_16
#define EXACT_BUILD "q16"
#define EXACT_WHOLE 1            /* all lengths are whole steps */
static inline exact exact_real(tuff_real value)   { return (exact)value; }
static inline exact exact_unit(tuff_unit value)   { return (exact)value / 1073741824; }
static inline tuff_real real_from_double(double steps) { return (tuff_real)floor(steps + 0.5); }
#else
#define EXACT_BUILD "float"
#define EXACT_WHOLE 0
static inline exact exact_real(tuff_real value)   { return (exact)value * EXACT_UNIT; }
static inline exact exact_unit(tuff_unit value)   { return (exact)value; }
static inline tuff_real real_from_double(double steps) { return (tuff_real)(steps / 65536.0); }
#endif

/* The point nearest to (x, y), given in steps, that the build can hold. */
static inline tuff_vec2 vec2_from_doubles(double x, double y)
{
    return (tuff_vec2){ real_from_double(x), real_from_double(y) };
}

static inline exact2 exact_vec2(tuff_vec2 v)      { return (exact2){ exact_real(v.x), exact_real(v.y) }; }
static inline exact2 exact_unit2(tuff_unit2 v)    { return (exact2){ exact_unit(v.x), exact_unit(v.y) }; }
static inline exact2 exact_sub(exact2 a, exact2 b) { return (exact2){ a.x - b.x, a.y - b.y }; }
static inline exact2 exact_add(exact2 a, exact2 b) { return (exact2){ a.x + b.x, a.y + b.y }; }
static inline exact exact_dot(exact2 a, exact2 b)  { return a.x * b.x + a.y * b.y; }
static inline exact exact_cross(exact2 a, exact2 b) { return a.x * b.y - a.y * b.x; }
static inline exact exact_abs(exact a)            { return a < 0 ? -a : a; }

/* In world units. */
static inline double units_of(tuff_real value)
{
    return (double)exact_real(value) / EXACT_UNIT;
}

/* Keep the largest so far. */
static inline void raise_to(double *most, exact value)
{
    if ((double)value > *most) *most = (double)value;
}

/* Two Newton steps take the 53 bits of sqrt() to all 113. */
static inline exact exact_sqrt(exact square)
{
    exact root = (exact)sqrt((double)square);
    if (root == 0) return 0;
    root = (root + square / root) / 2;
    return (root + square / root) / 2;
}

static inline exact exact_length(exact2 a)
{
    return exact_sqrt(exact_dot(a, a));
}

/* Twice the area of the triangle a, b, c: above 0 if it turns the way from +x to +y. Exact. */
static inline exact exact_turn(tuff_vec2 a, tuff_vec2 b, tuff_vec2 c)
{
    exact2 origin = exact_vec2(a);
    return exact_cross(exact_sub(exact_vec2(b), origin), exact_sub(exact_vec2(c), origin));
}

#endif
