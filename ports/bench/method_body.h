/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A method on tuff's numbers. The file that includes this once defines the type polygon_type, normal_type and contact_type, polygon_of, and
   the tests hits_circle, hits_hull and hits_segment, as for tests/bench/pair_method.h. */
#ifndef TUFF_PORTS_METHOD_BODY_H
#define TUFF_PORTS_METHOD_BODY_H

#include "adapt.h"
#include "count.h"
#include "method.h"

const int method_max_vertices = BENCH_MAX_VERTICES;

static tuff_vec2 corners[2][BENCH_MAX_VERTICES];
static normal_type outward[2][BENCH_MAX_VERTICES];
static polygon_type polygon, hull;

static polygon_type read_polygon(int slot, const bench_shape *shape)
{
    for (int i = 0; i < shape->count; i++) corners[slot][i] = adapt_point(shape->vertices[i]);
    return polygon_of(corners[slot], outward[slot], shape->count);
}

void method_load(const bench_shape *polygon_shape, const bench_shape *hull_shape)
{
    polygon = read_polygon(0, polygon_shape);
    hull = read_polygon(1, hull_shape);
}

static bool count_circle(tuff_vec2 center, tuff_real radius)
{
    contact_type contact;
    count_begin();
    bool hit = hits_circle(center, radius, &polygon, &contact);
    count_end();
    return hit;
}

static bool count_hull(tuff_vec2 offset)
{
    contact_type contact;
    count_begin();
    bool hit = hits_hull(&hull, offset, &polygon, &contact);
    count_end();
    return hit;
}

static bool count_segment(tuff_vec2 a, tuff_vec2 b)
{
    count_begin();
    bool hit = hits_segment(a, b, &polygon);
    count_end();
    return hit;
}

bool method_count(bench_kind kind, const sets_pair *pair)
{
    tuff_vec2 a = adapt_point(pair->a);
    if (kind == BENCH_CIRCLE) return count_circle(a, tuff_from_q16_16(pair->radius));
    if (kind == BENCH_HULL) return count_hull(a);
    return count_segment(a, adapt_point(pair->b));
}

#endif
