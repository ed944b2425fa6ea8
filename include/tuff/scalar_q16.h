/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The numbers of the fixed build, and the way in and out of them. */
#ifndef TUFF_SCALAR_Q16_H
#define TUFF_SCALAR_Q16_H

typedef int32_t tuff_real;   /* Q16.16 */
typedef int32_t tuff_unit;   /* Q2.30 */

#define TUFF_REAL_BITS 16    /* fraction bits of a tuff_real */
#define TUFF_UNIT_BITS 30    /* fraction bits of a tuff_unit */

/* Literals: constant expressions, to the nearest step, halves away from zero. The argument must be a constant.
   Where double has 32 bits (AVR) TUFF_REAL and TUFF_UNIT carry 24 bits; the other forms are exact everywhere. */
#define TUFF_REAL(x) ((tuff_real)((x) * 65536.0 + ((x) < 0 ? -0.5 : 0.5)))
#define TUFF_UNIT(x) ((tuff_unit)((x) * 1073741824.0 + ((x) < 0 ? -0.5 : 0.5)))

/* num / den from integers, |num / den| < 32768 (TUFF_RATIO) or < 2 (TUFF_UNIT_RATIO), |num| < 2^31. The doubled quotient is
   truncated first, then halved away from zero: together, to nearest. */
#define TUFF_RATIO(num, den)      ((tuff_real)TUFF_HALVED((int64_t)(num) * 131072 / (den)))
#define TUFF_UNIT_RATIO(num, den) ((tuff_unit)TUFF_HALVED((int64_t)(num) * 2147483648LL / (den)))
#define TUFF_HALVED(twice)        (((twice) < 0 ? (twice) - 1 : (twice) + 1) / 2)

/* From the bits: n / 65536 and n / 2^30. */
#define TUFF_REAL_RAW(n) ((tuff_real)(n))
#define TUFF_UNIT_RAW(n) ((tuff_unit)(n))

/* A constant given twice, as n / 2^30 and as a float literal, so that either build has it right to the last bit. For
   tables that tools write. */
#define TUFF_UNIT_EITHER(n, floating) ((tuff_unit)(n))

/* The number closest to value / 2^fraction_bits; saturates at +-32768. fraction_bits: 0 .. 30. The way from Q16.16 to Q16.16 costs
   nothing: compilers do not see that the general one changes no bit. */
static inline tuff_real tuff_real_from_fixed(int32_t value, unsigned fraction_bits)
{
    if (fraction_bits == TUFF_REAL_BITS) return value;
    int64_t doubled = (int64_t)value * 131072 / ((int64_t)1 << fraction_bits);
    int64_t rounded = TUFF_HALVED(doubled);
    return (tuff_real)(rounded > TUFF_INT32_MAX ? TUFF_INT32_MAX : rounded < TUFF_INT32_MIN ? TUFF_INT32_MIN : rounded);
}

/* value * 2^fraction_bits to the nearest integer; saturates at the ends of int32_t. fraction_bits: 0 .. 30. */
static inline int32_t tuff_fixed_from_real(tuff_real value, unsigned fraction_bits)
{
    if (fraction_bits == TUFF_REAL_BITS) return value;
    int64_t doubled = (int64_t)value * ((int64_t)1 << fraction_bits) / 32768;
    int64_t rounded = TUFF_HALVED(doubled);
    return (int32_t)(rounded > TUFF_INT32_MAX ? TUFF_INT32_MAX : rounded < TUFF_INT32_MIN ? TUFF_INT32_MIN : rounded);
}

/* length * factor, to nearest; saturates. A component of a vector along a normal; a beam's way to its hit. */
static inline tuff_real tuff_scale(tuff_real length, tuff_unit factor)
{
    int64_t product = (int64_t)length * factor;
    int64_t half = (int64_t)1 << (TUFF_UNIT_BITS - 1);
    int64_t rounded = product < 0 ? -((half - product) >> TUFF_UNIT_BITS) : (product + half) >> TUFF_UNIT_BITS;
    return (tuff_real)(rounded > TUFF_INT32_MAX ? TUFF_INT32_MAX : rounded < TUFF_INT32_MIN ? TUFF_INT32_MIN : rounded);
}

/* Q2.30, which a tuff_unit is here. */
static inline tuff_unit tuff_unit_from_q2_30(int32_t value) { return value; }
static inline int32_t tuff_unit_to_q2_30(tuff_unit value)   { return value; }

/* For the host and for machines with an FPU; nothing of the library calls these. NaN gives 0. */
static inline tuff_real tuff_real_from_float(float value)
{
    if (value != value) return 0;
    if (value >= 32768.0f) return TUFF_INT32_MAX;
    if (value <= -32768.0f) return TUFF_INT32_MIN;
    return (tuff_real)(value * 65536.0f + (value < 0.0f ? -0.5f : 0.5f));
}

static inline float tuff_float_from_real(tuff_real value)
{
    return (float)value / 65536.0f;
}

static inline float tuff_unit_to_float(tuff_unit value)
{
    return (float)value / 1073741824.0f;
}

#endif
