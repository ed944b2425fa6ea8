/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   tuff's narrow phase; hulls with their normals given. */
#include "adapt.h"
#include "exact.h"

#define method TUFF_LINK_NAME(bench_tuff)

typedef struct mover {
    tuff_vec2 a, b;
    tuff_real radius;
    const tuff_polygon *hull, *polygon;
} mover;

static tuff_vec2 vertices[(BENCH_SHAPES + BENCH_HULLS) * BENCH_MAX_VERTICES];
static tuff_unit2 normals[(BENCH_SHAPES + BENCH_HULLS) * BENCH_MAX_VERTICES];
static tuff_polygon polygons[BENCH_SHAPES], hulls[BENCH_HULLS];
static mover movers[BENCH_PAIRS];

static void prepare(const bench_set *set)
{
    adapt_pool pool = { vertices, normals, 0 };
    for (int i = 0; i < BENCH_SHAPES; i++) polygons[i] = adapt_polygon(&pool, &set->shapes[i]);
    for (int i = 0; i < BENCH_HULLS; i++) hulls[i] = adapt_polygon(&pool, &set->hulls[i]);
    for (uint32_t i = 0; i < set->count; i++) {
        const bench_pair *pair = &set->pairs[i];
        movers[i] = (mover){ adapt_point(pair->a), adapt_point(pair->b), tuff_from_q16_16(pair->radius), &hulls[pair->hull],
                             &polygons[pair->shape] };
    }
}

static inline bool test(bench_kind kind, const mover *m, tuff_contact *contact)
{
    if (kind == BENCH_CIRCLE) return tuff_circle_polygon(m->a, m->radius, m->polygon, contact);
    if (kind == BENCH_HULL) return tuff_polygon_polygon(m->hull, m->a, m->polygon, contact);
    return tuff_segment_polygon(m->a, m->b, m->polygon);
}

static inline uint32_t run_kind(bench_kind kind, const uint16_t *order, uint32_t count)
{
    uint32_t hits = 0;
    tuff_contact contact;
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
    tuff_contact contact = { 0, { 0, 0 } };
    out->hit = test(kind, &movers[pair], &contact);
    out->depth = units_of(contact.overlap);
}

static double bytes(int count)
{
    return (double)sizeof(tuff_polygon) + (double)count * (double)(sizeof(tuff_vec2) + sizeof(tuff_unit2));
}

const bench_method method = { "tuff", ADAPT_BUILD, BENCH_MAX_VERTICES, prepare, run, answer, bytes };
