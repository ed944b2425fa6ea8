/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Random shapes of every family that is hard on a narrow phase, and where to put them so that it matters. */
#ifndef TUFF_TESTS_FAMILIES_H
#define TUFF_TESTS_FAMILIES_H

#include "random.h"

/* A shape of a random family with 3 .. TUFF_MAX_VERTICES vertices, none farther than largest units from the origin: rocks, needles
   1:1000, shapes of 1 unit and less, outlines with collinear vertices, shapes off their origin, boxes and flat triangles on whole
   units, regular polygons. */
void family_shape(random_source *source, random_shape *shape, double largest);

/* The same shape turned by an angle, as near as the grid allows, and convex again. */
void family_turned(random_shape *turned, const random_shape *shape, double angle);

/* A convex shape of 3 .. most vertices on a grid of 1/4096 unit, which float holds to 1,024 units; no two vertices closer than 1/16
   unit. */
void family_plain_shape(random_source *source, random_shape *shape, int most, double size);

/* A world position within +-16,000 units on a grid of 1/1024 unit, which float holds: at the origin, near it, or far from it. */
tuff_vec2 family_position(random_source *source);

/* A number of steps that is mostly small: 0 .. 3, sometimes up to 1,000; either sign. */
double family_steps(random_source *source);

#endif
