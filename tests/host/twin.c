/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Shapes for Box2D and tuff alike: at most 8 vertices, far enough apart that Box2D welds none. */
#include "twin.h"

void twin_make(random_source *source, twin *t, double size)
{
    box2d_vec vertices[TUFF_MAX_VERTICES];
    t->box = NULL;
    while (t->box == NULL) {
        family_plain_shape(source, &t->shape, 8, size);
        for (int i = 0; i < t->shape.polygon.count; i++) vertices[i] = twin_vec(t->shape.vertices[i]);
        t->box = box2d_polygon_new(vertices, t->shape.polygon.count);
    }
    oracle_read_polygon(&t->exact, &t->shape.polygon);
}

void twin_free(twin *t)
{
    box2d_polygon_free(t->box);
}

tuff_real twin_real(double steps)
{
    return tuff_from_q22_10((int32_t)floor(steps / 64 + 0.5));
}

box2d_vec twin_vec(tuff_vec2 v)
{
    return (box2d_vec){ tuff_to_float(v.x), tuff_to_float(v.y) };
}
