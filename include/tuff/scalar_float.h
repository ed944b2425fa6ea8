/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The numbers of the float build, and the way in and out of them. */
#ifndef TUFF_SCALAR_FLOAT_H
#define TUFF_SCALAR_FLOAT_H

typedef float tuff_real;
typedef float tuff_unit;

/* Literals: constant expressions. The argument must be a constant. */
#define TUFF_REAL(x) ((tuff_real)(x))
#define TUFF_UNIT(x) ((tuff_unit)(x))

/* num / den from integers; exact to the last bit for |num|, |den| < 2^24. */
#define TUFF_RATIO(num, den)      ((tuff_real)(num) / (tuff_real)(den))
#define TUFF_UNIT_RATIO(num, den) ((tuff_unit)(num) / (tuff_unit)(den))

/* From the bits of the fixed build: n / 65536 and n / 2^30, rounded to float where n has more than 24 bits. */
#define TUFF_REAL_RAW(n) ((tuff_real)(n) / 65536.0f)
#define TUFF_UNIT_RAW(n) ((tuff_unit)(n) / 1073741824.0f)

/* A constant given twice, as n / 2^30 and as a float literal, so that either build has it right to the last bit. For
   tables that tools write. */
#define TUFF_UNIT_EITHER(n, floating) ((tuff_unit)(floating))

/* The number closest to value / 2^fraction_bits. fraction_bits: 0 .. 30. */
static inline tuff_real tuff_real_from_fixed(int32_t value, unsigned fraction_bits)
{
    return (tuff_real)value / (tuff_real)((uint32_t)1 << fraction_bits);
}

/* value * 2^fraction_bits to the nearest integer, halves away from zero; saturates at the ends of int32_t; NaN gives 0.
   fraction_bits: 0 .. 30. A float of 2^23 or more is whole already: adding a half would round it a second time. */
static inline int32_t tuff_fixed_from_real(tuff_real value, unsigned fraction_bits)
{
    float scaled = value * (tuff_real)((uint32_t)1 << fraction_bits);
    if (scaled != scaled) return 0;
    if (scaled >= 2147483648.0f) return TUFF_INT32_MAX;
    if (scaled <= -2147483648.0f) return TUFF_INT32_MIN;
    if (scaled >= 8388608.0f || scaled <= -8388608.0f) return (int32_t)scaled;
    int32_t whole = (int32_t)scaled;
    float rest = scaled - (float)whole;
    return whole + (rest >= 0.5f ? 1 : 0) - (rest <= -0.5f ? 1 : 0);
}

/* length * factor. A component of a vector along a normal; a beam's way to its hit. */
static inline tuff_real tuff_scale(tuff_real length, tuff_unit factor)
{
    return length * factor;
}

/* From and to Q2.30; to nearest, |value| < 2. */
static inline tuff_unit tuff_unit_from_q2_30(int32_t value) { return (tuff_unit)value / 1073741824.0f; }
static inline int32_t tuff_unit_to_q2_30(tuff_unit value)   { return tuff_fixed_from_real(value, 30); }

static inline tuff_real tuff_real_from_float(float value)
{
    return value;
}

static inline float tuff_float_from_real(tuff_real value)
{
    return value;
}

static inline float tuff_unit_to_float(tuff_unit value)
{
    return value;
}

#endif
