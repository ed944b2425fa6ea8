/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   SGDK has types of its own, no <stdint.h> and no <stdbool.h>: tuff takes them from here, whichever header comes first. */
#include <genesis.h>
#define TUFF_NO_STD_TYPES
typedef signed long long   int64_t;
typedef unsigned long long uint64_t;
