/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The textbook's tests. */
#include "textbook_tests.h"

#define method       TUFF_LINK_NAME(bench_textbook)

#include "pair_method.h"

const bench_method method = { "textbook", ADAPT_BUILD, BENCH_MAX_VERTICES, prepare, run, answer, bytes };
