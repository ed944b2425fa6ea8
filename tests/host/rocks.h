/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Random concave rocks for the host tests: an outline on a coarse grid, which both builds hold exactly, cut into convex parts that
   share whole edges, with those edges marked. */
#ifndef TUFF_TESTS_ROCKS_H
#define TUFF_TESTS_ROCKS_H

#include "random.h"

#define ROCK_GRID        64      /* steps to a unit */
#define ROCK_MAX_POINTS  64
#define ROCK_MAX_PARTS   64

typedef struct rock_point { int32_t x, y; } rock_point;   /* steps of the rock's grid */

typedef struct rock {            /* not to be copied: the parts point into it */
    tuff_vec2    vertices[ROCK_MAX_PARTS][TUFF_MAX_VERTICES];
    tuff_unit2   normals[ROCK_MAX_PARTS][TUFF_MAX_VERTICES];
    tuff_polygon parts[ROCK_MAX_PARTS];
    uint8_t      part_count;
    tuff_real    bounding_radius;
} rock;

enum {
    ROCK_STAR,                   /* a random radius for each of up to 24 directions */
    ROCK_SPIKES,                 /* long and short in turn */
    ROCK_ELL,
    ROCK_CRESCENT,
    ROCK_RING,                   /* a hole in the middle */
    ROCK_CUT_CONVEX,             /* no notch at all: only the seams could disturb */
    ROCK_KINDS
};

/* Cut the simple outline points[0 .. count - 1], which runs counterclockwise where y grows upwards, into triangles, and join neighbors
   that stay convex together, each with a chance of so many percent. False: the outline is not simple, or too fine to be cut. */
bool rock_from_outline(random_source *source, rock *made, const rock_point *points, int count, uint32_t join_percent);

/* A rock of this kind within size units of the origin (4 .. 1000). Never fails. */
void rock_make(random_source *source, rock *made, int kind, double size);

/* An obstacle made of the rock. */
tuff_terrain rock_terrain(const rock *made, tuff_vec2 position);

#endif
