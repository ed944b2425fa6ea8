/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The textbook's tests; the normals of hulls are given here, too, which the game it comes from makes anew at each call. */
#include "adapt.h"
#include "exact.h"
#include "textbook.h"

#define method TUFF_LINK_NAME(bench_textbook)

typedef struct mover {
    tuff_vec2 a, b;
    tuff_real radius;
    const textbook_polygon *hull, *polygon;
} mover;

static tuff_vec2 vertices[(BENCH_SHAPES + BENCH_HULLS) * BENCH_MAX_VERTICES];
static tuff_vec2 normals[(BENCH_SHAPES + BENCH_HULLS) * BENCH_MAX_VERTICES];
static textbook_polygon polygons[BENCH_SHAPES], hulls[BENCH_HULLS];
static mover movers[BENCH_PAIRS];

static textbook_polygon read_polygon(uint32_t *used, const bench_shape *shape)
{
    textbook_polygon polygon = { vertices + *used, normals + *used, shape->count };
    for (int i = 0; i < shape->count; i++) vertices[*used + (uint32_t)i] = adapt_point(shape->vertices[i]);
    textbook_normals(polygon.vertices, shape->count, normals + *used);
    *used += (uint32_t)shape->count;
    return polygon;
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

static inline bool test(bench_kind kind, const mover *m, textbook_contact *contact)
{
    if (kind == BENCH_CIRCLE) return textbook_circle(m->a, m->radius, m->polygon, contact);
    if (kind == BENCH_HULL) return textbook_hull(m->hull, m->a, m->polygon, contact);
    return textbook_segment(m->a, m->b, m->polygon);
}

static inline uint32_t run_kind(bench_kind kind, const uint16_t *order, uint32_t count)
{
    uint32_t hits = 0;
    textbook_contact contact;
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
    textbook_contact contact = { 0, { 0, 0 } };
    out->hit = test(kind, &movers[pair], &contact);
    out->depth = units_of(contact.overlap);
}

static double bytes(int count)
{
    return (double)sizeof(textbook_polygon) + (double)count * 2.0 * (double)sizeof(tuff_vec2);
}

const bench_method method = { "textbook", ADAPT_BUILD, BENCH_MAX_VERTICES, prepare, run, answer, bytes };
