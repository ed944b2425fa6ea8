/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What the makers of inputs share. Compiled in Q16.16, in which the inputs are counted. */
#ifndef TUFF_BENCH_SETS_H
#define TUFF_BENCH_SETS_H

#include "bench.h"
#include "random.h"

/* A convex polygon of exactly this many vertices: points of an ellipse at growing angles, no two less than 0.3 of their mean
   distance apart. The longer half axis is least .. most units. */
void bench_make_rock(random_source *source, bench_shape *shape, int count, double least, double most);

/* The reference scene: 2048 x 2048 units, 256 pieces of 8 shared octagons, a ship, 24 enemies, 48 shots, 6 beams of 256 units, flown
   through 600 steps by tuff; every fifth is a frame. */
void bench_make_scene(bench_scene *scene);

/* The same with every step as a frame: BENCH_STEPS of them. The beams of a frame take their turns at the random numbers, so it is another
   flight. */
void bench_make_whole_scene(bench_scene *scene, bench_frame *frames);

/* Pieces of the same kind, density times 256 on 2048 x 2048 units, around the origin; no fewer than the 64 times density that lie within
   512 units of it. There the bodies and the beams' starts are, if near, and otherwise all over the world. */
void bench_make_crowd(bench_crowd *crowd, uint32_t pieces, double density, double length, bool near);

#endif
