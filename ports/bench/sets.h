/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The inputs of the counted cases, made on the host by tests/bench/write_sets.c. */
#ifndef TUFF_PORTS_SETS_H
#define TUFF_PORTS_SETS_H

#include <stdbool.h>

#include "inputs.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SETS_NAME 24

typedef struct sets_pair {          /* the polygon stands at the origin */
    bench_point a, b;               /* the circle's center, the hull's position, or the segment's ends */
    int32_t     radius;
    struct { uint8_t polygon, hull; } shapes;
} sets_pair;

extern const uint8_t  sets_cases;
extern const uint16_t sets_pairs;   /* of a case */

/* Writes the columns `kind,vertices,class`. */
bench_kind sets_read_case(uint8_t number, char name[SETS_NAME]);

void sets_read_pair(uint8_t number, uint16_t pair, sets_pair *out);
void sets_read_shapes(const sets_pair *pair, bench_shape *polygon, bench_shape *hull);

/* The reference scene; only where there is room for it. */
extern const struct sets_scene {
    const bench_shape *octagons, *hull;
    const int32_t     *radii;
    const bench_piece *pieces;
    const bench_frame *frames;
    uint16_t           frame_count;
} sets_scene;

#ifdef __cplusplus
}
#endif

#endif
