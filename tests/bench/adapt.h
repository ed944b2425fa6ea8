/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   From the bench's integers to tuff's types: for the methods that are compiled once for each build. */
#ifndef TUFF_BENCH_ADAPT_H
#define TUFF_BENCH_ADAPT_H

#include "inputs.h"
#include "tuff/tuff.h"

#if TUFF_SCALAR == TUFF_Q16_16
#define ADAPT_BUILD "q16"
#else
#define ADAPT_BUILD "float"
#endif

static inline tuff_vec2 adapt_point(bench_point point)
{
    return (tuff_vec2){ tuff_from_q16_16(point.x), tuff_from_q16_16(point.y) };
}

static inline tuff_body adapt_body(bench_body body)
{
    return (tuff_body){ adapt_point(body.position), adapt_point(body.velocity), NULL };
}

/* Polygons with their arrays one behind the other, as a game's data file has them. */
typedef struct adapt_pool {
    tuff_vec2    *vertices;
    tuff_unit2   *normals;
    uint32_t      used;
} adapt_pool;

static inline tuff_polygon adapt_polygon(adapt_pool *pool, const bench_shape *shape)
{
    tuff_vec2 *vertices = pool->vertices + pool->used;
    tuff_unit2 *normals = pool->normals + pool->used;
    for (int i = 0; i < shape->count; i++) vertices[i] = adapt_point(shape->vertices[i]);
    tuff_edge_normals(vertices, (uint8_t)shape->count, normals);
    pool->used += (uint32_t)shape->count;
    return (tuff_polygon){ vertices, normals, 0, (uint8_t)shape->count };
}

#endif
