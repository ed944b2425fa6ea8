/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The functions whose instructions are counted and compared with tests/bench/instructions.csv. */
#ifndef TUFF_BENCH_GATE_H
#define TUFF_BENCH_GATE_H

#include "bench.h"

#define GATE_PIECES 1024

typedef enum gate_function {
    GATE_CIRCLE_CIRCLE, GATE_CIRCLE_POLYGON, GATE_POLYGON_POLYGON, GATE_SEGMENT_CIRCLE, GATE_SEGMENT_POLYGON, GATE_TERRAIN_OVERLAP_CIRCLE,
    GATE_TERRAIN_OVERLAP_HULL, GATE_BOUNCE, GATE_TERRAIN_COLLIDE_CIRCLE, GATE_TERRAIN_COLLIDE_HULL, GATE_TERRAIN_COLLIDE_BARE_HULL,
    GATE_FLOATER_COLLIDE_CIRCLE, GATE_FLOATER_COLLIDE_HULL, GATE_SEGMENT_TERRAIN_INTERSECT, GATE_SEGMENT_TERRAIN_FIRST_HIT,
    GATE_NEARBY_TERRAIN, GATE_CHUNKS_MOVE, GATE_FUNCTIONS
} gate_function;

typedef struct gate_side {          /* one build */
    const char *build;
    void (*prepare)(const bench_set *sets, const bench_crowd *crowd);   /* a set of each kind */
    void (*reset)(void);
    bench_run *run;                 /* what: a gate_function */
} gate_side;

extern const gate_side tuff_float_gate_side, tuff_q16_gate_side;

#endif
