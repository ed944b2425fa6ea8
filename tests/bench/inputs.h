/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The inputs' types, free of any library's: raw Q16.16 integers within 256 units, which float and double hold exactly. For machines of any
   size. */
#ifndef TUFF_BENCH_INPUTS_H
#define TUFF_BENCH_INPUTS_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define BENCH_ONE           65536    /* 1 unit */
#ifndef BENCH_MAX_VERTICES
#define BENCH_MAX_VERTICES  16
#endif

typedef enum bench_kind  { BENCH_CIRCLE, BENCH_HULL, BENCH_SEGMENT, BENCH_KINDS } bench_kind;

typedef struct bench_point { int32_t x, y; } bench_point;

typedef struct bench_shape {        /* convex, counterclockwise where y grows upwards */
    bench_point vertices[BENCH_MAX_VERTICES];
    int count;
} bench_shape;

/* ---- the scene ---- */

#define BENCH_PIECES   256
#define BENCH_OCTAGONS 8
#define BENCH_ENEMIES  24
#define BENCH_SHOTS    48
#define BENCH_BODIES   (1 + BENCH_ENEMIES + BENCH_SHOTS)     /* the ship comes first */
#define BENCH_BEAMS    6
#define BENCH_STEPS    600
#define BENCH_FRAMES   120          /* of these steps */
#define BENCH_SIDE     2048

typedef struct bench_piece { bench_point position; uint8_t shape; } bench_piece;
typedef struct bench_body  { bench_point position, velocity; } bench_body;

typedef struct bench_frame {        /* where everything is before the frame's calls, for every method the same */
    bench_body  bodies[BENCH_BODIES];
    bench_point beams[BENCH_BEAMS][2];
} bench_frame;

static inline int32_t bench_body_radius(int body)
{
    return (body == 0 ? 8 : body <= BENCH_ENEMIES ? 6 : 2) * BENCH_ONE;
}

#ifdef __cplusplus
}
#endif

#endif
