/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The functions of arith.h that are too long to be inline; the scalar decides which set. */
#include "arith.h"
#include TUFF_ARITH_SOURCE
