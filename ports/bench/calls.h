/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   tuff's calls that are no test of a pair, each between the marks of the count. */
#ifndef TUFF_PORTS_CALLS_H
#define TUFF_PORTS_CALLS_H

#include "adapt.h"

typedef struct calls_frame { tuff_body bodies[BENCH_BODIES]; tuff_vec2 beams[BENCH_BEAMS][2]; } calls_frame;

void count_bounce(tuff_body *body, const tuff_contact *contact);
uint16_t count_nearby(tuff_world *world, tuff_vec2 center, tuff_real radius);

uint16_t count_collide(const tuff_world *world, tuff_body *body, tuff_real radius);
bool count_beam(const tuff_world *world, tuff_vec2 a, tuff_vec2 b);

/* All calls of a frame of the reference scene. The result: pushes and stopped beams. */
uint16_t count_frame(const tuff_world *world, calls_frame *frame, const tuff_real *radii, const tuff_polygon *hull);

#endif
