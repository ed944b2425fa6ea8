/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   tuff's narrow phase. */
#include "tuff_tests.h"

#define method       TUFF_LINK_NAME(bench_tuff)

#include "pair_method.h"

const bench_method method = { "tuff", ADAPT_BUILD, BENCH_MAX_VERTICES, prepare, run, answer, bytes };
