/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The frame call as the textbook has it: every convex part on its own, in the order of the array, pushed out of and bounced
   off; seams are edges like all others. Its tests are those of tests/bench/textbook.h. */
#ifndef TUFF_STABILITY_NAIVE_H
#define TUFF_STABILITY_NAIVE_H

#include "textbook.h"

/* What the textbook keeps of a polygon. */
typedef struct naive_polygon {
    tuff_vec2        normals[TUFF_MAX_VERTICES];
    textbook_polygon polygon;
} naive_polygon;

void naive_read(naive_polygon *naive, const tuff_polygon *polygon);

/* hull NULL: the circle. Returns the pushes. The material is the default one. */
uint16_t naive_collide(const tuff_terrain *terrain, uint16_t count, tuff_body *body, tuff_real radius, const tuff_polygon *hull);

#endif
