/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What the programs that count need of a method. */
#ifndef TUFF_PORTS_METHOD_H
#define TUFF_PORTS_METHOD_H

#include "sets.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const int method_max_vertices;

/* The shapes of the next calls; normals are made here, before the counting. */
void method_load(const bench_shape *polygon, const bench_shape *hull);

/* Counts one call. The result: it hit. */
bool method_count(bench_kind kind, const sets_pair *pair);

#ifdef __cplusplus
}
#endif

#endif
