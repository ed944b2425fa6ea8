/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   From and to the number formats that people already have. All round to nearest and saturate at the end of the range of
   the result; none is exact where the target has fewer fraction bits. */
#ifndef TUFF_CONVERT_H
#define TUFF_CONVERT_H

#include "scalar.h"

/* Whole numbers; to int rounds to nearest, halves away from zero. */
static inline tuff_real tuff_from_int(int32_t value)    { return tuff_real_from_fixed(value, 0); }
static inline int32_t   tuff_to_int(tuff_real value)    { return tuff_fixed_from_real(value, 0); }

/* float. */
static inline tuff_real tuff_from_float(float value)    { return tuff_real_from_float(value); }
static inline float     tuff_to_float(tuff_real value)  { return tuff_float_from_real(value); }

/* Q16.16: this library's own fixed build, and most fixed-point libraries. */
static inline tuff_real tuff_from_q16_16(int32_t value) { return tuff_real_from_fixed(value, 16); }
static inline int32_t   tuff_to_q16_16(tuff_real value) { return tuff_fixed_from_real(value, 16); }

/* Q24.8: libtonc. */
static inline tuff_real tuff_from_q24_8(int32_t value)  { return tuff_real_from_fixed(value, 8); }
static inline int32_t   tuff_to_q24_8(tuff_real value)  { return tuff_fixed_from_real(value, 8); }

/* Q20.12: libnds, Butano. */
static inline tuff_real tuff_from_q20_12(int32_t value) { return tuff_real_from_fixed(value, 12); }
static inline int32_t   tuff_to_q20_12(tuff_real value) { return tuff_fixed_from_real(value, 12); }

/* Q22.10: SGDK's fix32. */
static inline tuff_real tuff_from_q22_10(int32_t value) { return tuff_real_from_fixed(value, 10); }
static inline int32_t   tuff_to_q22_10(tuff_real value) { return tuff_fixed_from_real(value, 10); }

/* Q10.6: SGDK's fix16, +-512. */
static inline tuff_real tuff_from_q10_6(int16_t value)  { return tuff_real_from_fixed(value, 6); }
static inline int16_t   tuff_to_q10_6(tuff_real value)
{
    int32_t wide = tuff_fixed_from_real(value, 6);
    return (int16_t)(wide > TUFF_INT16_MAX ? TUFF_INT16_MAX : wide < TUFF_INT16_MIN ? TUFF_INT16_MIN : wide);
}

#endif
