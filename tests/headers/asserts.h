/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The config header of a debug build, and of a game that places hot functions. */
#include <assert.h>
#define TUFF_ASSERT(condition) assert(condition)
#define TUFF_HOT __attribute__((noinline))
