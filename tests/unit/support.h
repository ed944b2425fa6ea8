/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What the unit tests share: tolerances and comparisons. The one place of tests/unit that knows the scalar.
   No heap, no floating point beyond tuff_real, no more than integers for Unity. */
#ifndef SUPPORT_H
#define SUPPORT_H

#include <tuff/tuff.h>

#include "unity.h"

/* EITHER picks by build. STEPS(lsb, millionths) is a tolerance: so many LSB of Q16.16, or so many 1e-6 units in the float build. UNIT_STEPS
   the same for the components of a normal: LSB of Q2.30, or 2^-24. NUDGE: the least distance that a segment test must tell. */
#if TUFF_SCALAR == TUFF_Q16_16
#define IS_FIXED 1
#define EITHER(fixed, floating)    (fixed)
#define STEPS(lsb, millionths)     ((tuff_real)(lsb))
#define UNIT_STEPS(lsb, floating)  ((tuff_unit)(lsb))
typedef int64_t test_wide;
#else
#define IS_FIXED 0
#define EITHER(fixed, floating)    (floating)
#define STEPS(lsb, millionths)     ((tuff_real)(millionths) * 1e-6f)
#define UNIT_STEPS(lsb, floating)  ((tuff_unit)(floating) / 16777216.0f)
typedef float test_wide;
#endif

/* The bits of a component of a unit vector in Q2.30, in either build. */
#define UNIT_BITS_OF(u) EITHER((int32_t)(u), tuff_fixed_from_real((tuff_real)(u), 30))

#define LSB    TUFF_REAL_RAW(1)
#define NUDGE  EITHER(TUFF_REAL_RAW(1), TUFF_RATIO(1, 256))
#define W(n)   TUFF_WHOLE(n)
#define ONE    TUFF_UNIT_RATIO(1, 1)
#define HALF_ROOT TUFF_UNIT_RAW(759250125)   /* sqrt(1/2) */

/* The ends of what a position can hold: all of int32_t, or the limit of the float build. */
#define LOWEST   EITHER(INT32_MIN, -32768.0f)
#define HIGHEST  EITHER(INT32_MAX, 32768.0f)

/* ------------------------------------------------------------------------------------------------------- numbers */

/* Infinity and NaN, which only the float build has: tests that use them run there only. */
static inline tuff_real real_from_bits(uint32_t bits)
{
    union { uint32_t bits; tuff_real real; } both;
    both.bits = bits;
    return both.real;
}

#define NOT_A_NUMBER real_from_bits(UINT32_C(0x7fc00000))
#define INFINITE     real_from_bits(UINT32_C(0x7f800000))

static inline tuff_vec2 vec(tuff_real x, tuff_real y)
{
    tuff_vec2 v;
    v.x = x;
    v.y = y;
    return v;
}

static inline tuff_vec2 whole(int16_t x, int16_t y)
{
    return vec(tuff_from_int(x), tuff_from_int(y));
}

/* xorshift32: the same numbers on every machine. */
static inline uint32_t next_random(uint32_t *state)
{
    uint32_t x = *state;
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    *state = x;
    return x;
}

/* --------------------------------------------------------------------------------------------------- comparisons */

/* Shows both numbers in 1/65536 before the failure: Unity alone would print only where it was. */
static inline void expect_within(tuff_real tolerance, tuff_real expected, tuff_real actual, UNITY_LINE_TYPE line)
{
    test_wide difference = (test_wide)actual - (test_wide)expected;
    if (difference <= tolerance && difference >= -(test_wide)tolerance) return;
    UnityPrint("expected / 65536: ");
    UnityPrintNumber(tuff_to_q16_16(expected));
    UnityPrint(", was: ");
    UnityPrintNumber(tuff_to_q16_16(actual));
    UNITY_PRINT_EOL();
    UNITY_TEST_FAIL(line, "beyond the tolerance");
}

#define ASSERT_WITHIN(tolerance, expected, actual) expect_within((tolerance), (expected), (actual), __LINE__)
#define ASSERT_REAL(expected, actual)              expect_within(STEPS(1, 10), (expected), (actual), __LINE__)
#define ASSERT_UNIT(expected, actual)              expect_within(UNIT_STEPS(1000, 16), (expected), (actual), __LINE__)   /* 1e-6 */
#define ASSERT_SAME(expected, actual)              expect_within(0, (expected), (actual), __LINE__)

#define ASSERT_VEC(ex, ey, v) \
    do { ASSERT_REAL((ex), (v).x); ASSERT_REAL((ey), (v).y); } while (0)
#define ASSERT_VEC_SAME(ex, ey, v) \
    do { ASSERT_SAME((ex), (v).x); ASSERT_SAME((ey), (v).y); } while (0)
#define ASSERT_CONTACT(depth, nx, ny, c) \
    do { ASSERT_REAL((depth), (c).overlap); ASSERT_UNIT((nx), (c).normal.x); ASSERT_UNIT((ny), (c).normal.y); } while (0)
#define ASSERT_CONTACT_SAME(one, other) \
    do { ASSERT_SAME((one).overlap, (other).overlap); ASSERT_VEC_SAME((one).normal.x, (one).normal.y, (other).normal); } while (0)
#define ASSERT_BODY_SAME(one, other) \
    do { ASSERT_VEC_SAME((one).position.x, (one).position.y, (other).position); \
         ASSERT_VEC_SAME((one).velocity.x, (one).velocity.y, (other).velocity); } while (0)

/* A contact that no call returns: proves that false leaves it untouched. */
static inline tuff_contact marked_contact(void)
{
    tuff_contact c;
    c.overlap = W(-77);
    c.normal.x = TUFF_UNIT_RATIO(1, 8);
    c.normal.y = TUFF_UNIT_RATIO(-1, 8);
    return c;
}

#define ASSERT_UNTOUCHED(c) \
    do { ASSERT_SAME(W(-77), (c).overlap); ASSERT_SAME(TUFF_UNIT_RATIO(1, 8), (c).normal.x); \
         ASSERT_SAME(TUFF_UNIT_RATIO(-1, 8), (c).normal.y); } while (0)

#endif
