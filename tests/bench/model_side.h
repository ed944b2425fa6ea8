/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   One build seen from the model bench: numbers in, answers out, no tuff type. model_side.c is compiled once for each build. */
#ifndef TUFF_BENCH_MODEL_SIDE_H
#define TUFF_BENCH_MODEL_SIDE_H

#include "bench.h"

#define MODEL_MOST          16      /* models of an outline */
#define MODEL_MOST_VERTICES 1024    /* of all parts of a model */
#define MODEL_MOST_PARTS    128
#define MODEL_MOST_PLACES   4096

enum { MODEL_CIRCLE, MODEL_HULL, MODEL_BEAM, MODEL_QUERIES };

typedef struct model_part { int count; uint32_t internal; } model_part;

/* All lengths have at most 24 bits, which a float holds. */
typedef struct model_source {
    bench_point position;
    int32_t     radius, bounding_radius;
    int         part_count;
    model_part  parts[MODEL_MOST_PARTS];
    bench_point vertices[MODEL_MOST_VERTICES];   /* of the parts, one after the other */
} model_source;

/* What is asked at each place. */
typedef struct model_queries {
    int32_t     radius;             /* of the circle; covers the hull */
    bench_shape hull;
} model_queries;

/* The middle of circle and hull, and of a beam from middle - reach to middle + reach. */
typedef struct model_place { bench_point middle, reach; } model_place;

typedef struct model_side {
    const char *name;
    void (*bake)(int model, const model_source *source);
    void (*prepare)(const model_queries *queries, const model_place *places, int count);
    bench_run *run;                 /* what: model * MODEL_QUERIES + query; items: places */
} model_side;

extern const model_side model_side_float, model_side_q16;

#endif
