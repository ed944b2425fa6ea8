/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The one header that knows which number the build counts with. Everything else speaks of

     tuff_real    a length, position or speed         float, or Q16.16 in int32_t: steps of 1/65536, +-32768
     tuff_unit    a component of a unit vector        float, or Q2.30 in int32_t: steps of 2^-30, +-2

   and of the literals and converters that the two headers below define alike. */
#ifndef TUFF_SCALAR_H
#define TUFF_SCALAR_H

#include "config.h"

/* Public function names carry the build in the object file (tuff_q16_bounce, tuff_float_bounce), so that a game of one
   build does not link with the library of the other, and both libraries link into one program. TUFF_ARITH_HEADER and
   TUFF_ARITH_SOURCE name the inner arithmetic of the build for src/, TUFF_EDGE_SEARCH and TUFF_AXES_SEARCH the way it searches. */
#ifndef TUFF_SCALAR
#error "tuff: choose the number type: -DTUFF_SCALAR=TUFF_FLOAT or -DTUFF_SCALAR=TUFF_Q16_16"
#elif (TUFF_SCALAR + 0) == TUFF_Q16_16
#include "scalar_q16.h"
#define TUFF_LINK_NAME(name) tuff_q16_##name
#define TUFF_ARITH_HEADER "arith_q16.h"
#define TUFF_ARITH_SOURCE "arith_q16_body.h"
#elif (TUFF_SCALAR + 0) == TUFF_FLOAT
#include "scalar_float.h"
#define TUFF_LINK_NAME(name) tuff_float_##name
#define TUFF_ARITH_HEADER "arith_float.h"
#define TUFF_ARITH_SOURCE "arith_float_body.h"
#else
#error "tuff: TUFF_SCALAR is neither: spell it -DTUFF_SCALAR=TUFF_FLOAT or -DTUFF_SCALAR=TUFF_Q16_16"
#endif

#if (TUFF_SCALAR + 0) == TUFF_Q16_16 && !TUFF_FEW_BRANCHES
#define TUFF_EDGE_SEARCH "few_products_edge.h"
#define TUFF_AXES_SEARCH "few_products_axes.h"
#else
#define TUFF_EDGE_SEARCH "few_branches_edge.h"
#define TUFF_AXES_SEARCH "few_branches_axes.h"
#endif

/* A whole number of units as a constant expression: TUFF_WHOLE(12) is 12 units. Range: -32768 .. 32767. */
#define TUFF_WHOLE(n) TUFF_RATIO(n, 1)

#endif
