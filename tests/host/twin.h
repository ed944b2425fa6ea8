/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A shape that tuff, Box2D and the oracle all hold exactly. */
#ifndef TUFF_TESTS_TWIN_H
#define TUFF_TESTS_TWIN_H

#include "box2d_shim.h"
#include "families.h"
#include "oracle.h"

typedef struct twin {               /* not to be copied */
    random_shape   shape;
    oracle_polygon exact;
    box2d_polygon *box;
} twin;

/* Of 3 .. 8 vertices, none farther than size units (1 .. 1,024) from the origin. */
void twin_make(random_source *source, twin *t, double size);
void twin_free(twin *t);

/* The nearest number on a grid of 1/1024 unit, from steps: float holds it to 16,000 units. */
tuff_real twin_real(double steps);

box2d_vec twin_vec(tuff_vec2 v);

#endif
