/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Options. Each can be given on the command line (-DNAME=value). A file named by TUFF_CONFIG_HEADER is read first and
   replaces the defaults; the command line wins where that file guards its lines with #ifndef, as this one does. The
   library and the game must be compiled with the same values. */
#ifndef TUFF_CONFIG_H
#define TUFF_CONFIG_H

/* TUFF_SCALAR, the number type; no default. TUFF_FLOAT: float, for machines with an FPU. TUFF_Q16_16: 16.16 fixed point
   in int32_t, for machines without one, and for the same bits on all of them. */
#define TUFF_FLOAT  32
#define TUFF_Q16_16 16

/* -DTUFF_CONFIG_HEADER='"my_tuff_config.h"': a file of your own with any of the options below. Default: none. */
#ifdef TUFF_CONFIG_HEADER
#include TUFF_CONFIG_HEADER
#endif

/* Pushes that one collide call makes at most. Unit: pushes. Default 16, range 1 .. 65535. A body wedged between
   pieces needs a push for each; what still overlaps waits for the next step, which bounds the time of a call
   (a wedge of 5 degrees would take 3,146). Costs time only where bodies are wedged. */
#ifndef TUFF_MAX_PUSHES
#define TUFF_MAX_PUSHES 16
#endif
#if TUFF_MAX_PUSHES < 1 || TUFF_MAX_PUSHES > 65535
#error "tuff: TUFF_MAX_PUSHES must be 1 .. 65535"
#endif

/* How the fixed build searches for the edge that parts two shapes; the answers have the same bits. 0, the default: it multiplies as
   little as it can, for handhelds, where a branch is cheap and a product is not. 1: it branches as little as it can, for CPUs that guess
   branches, as PCs do: circles and hulls take a third less time there. The float build always does the latter. */
#ifndef TUFF_FEW_BRANCHES
#define TUFF_FEW_BRANCHES 0
#endif

/* Called with a condition that only a caller's bug makes false. Default: nothing, at no cost; safety never depends on it.
   A debug build may say -D'TUFF_ASSERT(condition)=assert(condition)' with <assert.h> in the config header. */
#ifndef TUFF_ASSERT
#define TUFF_ASSERT(condition) ((void)0)
#endif

/* Stands before the declaration and the definition of each hot function: the SDK's placement macro, such as IWRAM_CODE of
   libtonc or ITCM_CODE of libnds. Default: empty. */
#ifndef TUFF_HOT
#define TUFF_HOT
#endif

/* Define TUFF_NO_STD_TYPES in the config header if the SDK has int8_t .. uint64_t and bool of its own that clash with
   <stdint.h> and <stdbool.h>; the config header must then supply int8_t .. uint64_t,
   bool, true and false. Default: the standard headers. */
#ifndef TUFF_NO_STD_TYPES
#include <stdbool.h>
#include <stdint.h>
#endif

/* Ends of the types, which <stdint.h> may not be there to name. */
#define TUFF_INT16_MAX  32767
#define TUFF_INT16_MIN  (-TUFF_INT16_MAX - 1)
#define TUFF_INT32_MAX  2147483647
#define TUFF_INT32_MIN  (-TUFF_INT32_MAX - 1)
#define TUFF_UINT32_MAX 4294967295u

/* NULL without <stddef.h>, which some SDKs replace. */
#ifndef NULL
#include <stddef.h>
#endif

#endif
