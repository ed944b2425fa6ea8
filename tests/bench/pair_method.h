/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A narrow phase on tuff's numbers as a bench_method. The file that includes this once defines the types polygon_type, normal_type and
   contact_type, `polygon_type polygon_of(tuff_vec2 *, normal_type *, int)`, which makes the normals, and the tests hits_circle, hits_hull
   and hits_segment; it is left to name `method`. */
#ifndef TUFF_BENCH_PAIR_METHOD_H
#define TUFF_BENCH_PAIR_METHOD_H

#include "adapt.h"
#include "bench.h"
#include "exact.h"

typedef struct mover {
    tuff_vec2 a, b;
    tuff_real radius;
    const polygon_type *hull, *polygon;
} mover;

static tuff_vec2 vertices[(BENCH_SHAPES + BENCH_HULLS) * BENCH_MAX_VERTICES];
static normal_type normals[(BENCH_SHAPES + BENCH_HULLS) * BENCH_MAX_VERTICES];
static polygon_type polygons[BENCH_SHAPES], hulls[BENCH_HULLS];
static mover movers[BENCH_PAIRS];

/* One behind the other, as a game's data file has them. */
static polygon_type read_polygon(uint32_t *used, const bench_shape *shape)
{
    uint32_t first = *used;
    for (int i = 0; i < shape->count; i++) vertices[first + (uint32_t)i] = adapt_point(shape->vertices[i]);
    *used += (uint32_t)shape->count;
    return polygon_of(vertices + first, normals + first, shape->count);
}

static void prepare(const bench_set *set)
{
    uint32_t used = 0;
    for (int i = 0; i < BENCH_SHAPES; i++) polygons[i] = read_polygon(&used, &set->shapes[i]);
    for (int i = 0; i < BENCH_HULLS; i++) hulls[i] = read_polygon(&used, &set->hulls[i]);
    for (uint32_t i = 0; i < set->count; i++) {
        const bench_pair *pair = &set->pairs[i];
        movers[i] = (mover){ adapt_point(pair->a), adapt_point(pair->b), tuff_from_q16_16(pair->radius), &hulls[pair->hull],
                             &polygons[pair->shape] };
    }
}

static inline bool test(bench_kind kind, const mover *m, contact_type *contact)
{
    if (kind == BENCH_CIRCLE) return hits_circle(m->a, m->radius, m->polygon, contact);
    if (kind == BENCH_HULL) return hits_hull(m->hull, m->a, m->polygon, contact);
    return hits_segment(m->a, m->b, m->polygon);
}

static inline uint32_t run_kind(bench_kind kind, const uint16_t *order, uint32_t count)
{
    uint32_t hits = 0;
    contact_type contact;
    for (uint32_t i = 0; i < count; i++) hits += test(kind, &movers[order[i]], &contact);
    return hits;
}

static uint32_t run(int what, const uint16_t *order, uint32_t count)
{
    if (what == BENCH_CIRCLE) return run_kind(BENCH_CIRCLE, order, count);
    if (what == BENCH_HULL) return run_kind(BENCH_HULL, order, count);
    return run_kind(BENCH_SEGMENT, order, count);
}

static void answer(bench_kind kind, uint32_t pair, bench_answer *out)
{
    contact_type contact = { 0, { 0, 0 } };
    out->hit = test(kind, &movers[pair], &contact);
    out->depth = units_of(contact.overlap);
}

static double bytes(int count)
{
    return (double)sizeof(polygon_type) + (double)count * (double)(sizeof(tuff_vec2) + sizeof(normal_type));
}

#endif
