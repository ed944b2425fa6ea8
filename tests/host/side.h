/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   One build seen from outside: numbers in, numbers out, no tuff type. side.c is compiled once for each build, so that one program
   holds both. */
#ifndef TUFF_TESTS_SIDE_H
#define TUFF_TESTS_SIDE_H

#include <stdbool.h>
#include <stdint.h>

#define SIDE_VERTICES 12

typedef struct side_vec { int32_t x, y; } side_vec;              /* in steps of 1/65536 unit; at most 24 bits, which float holds */
typedef struct side_shape { side_vec vertices[SIDE_VERTICES]; int count; } side_shape;

typedef struct side_contact { bool found; double overlap, x, y; } side_contact;
typedef struct side_hit { bool found; double fraction, x, y; } side_hit;
typedef struct side_state { int pushes; double x, y, vx, vy; } side_state;

typedef struct side {
    const char *name;
    side_contact (*circle)(const side_shape *rock, side_vec at, side_vec center, int32_t radius);
    side_contact (*hull)(const side_shape *rock, side_vec at, const side_shape *hull, side_vec position);
    side_hit (*beam)(const side_shape *rock, side_vec at, side_vec a, side_vec b);
    side_state (*collide)(const side_shape *rock, side_vec at, const side_shape *hull, side_vec position, side_vec velocity);
    uint32_t real_size, polygon_size;
} side;

extern const side side_float, side_q16;

#endif
