/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Chipmunk2D's narrow phase: bodies, shapes and their transformed copies (cpShapeCacheBB) are made beforehand. Counts in double. Each
   mover has a shape of its own, since a shape belongs to a body. The mover comes first: where Chipmunk 7.0.3 has to swap a polygon and a
   circle, it returns the distance with the wrong sign. */
#include "bench.h"

#include <chipmunk/chipmunk_private.h>

static cpBody *bodies[BENCH_PAIRS];
static cpShape *polygons[BENCH_SHAPES], *movers[BENCH_PAIRS];
static const cpShape *obstacles[BENCH_PAIRS];
static cpVect from[BENCH_PAIRS], to[BENCH_PAIRS];
static cpBody *ground;
static uint32_t prepared;

static cpVect vect(bench_point p)
{
    return cpv((cpFloat)p.x / BENCH_ONE, (cpFloat)p.y / BENCH_ONE);
}

static cpShape *polygon_of(cpBody *body, const bench_shape *shape)
{
    cpVect vertices[BENCH_MAX_VERTICES];
    for (int i = 0; i < shape->count; i++) vertices[i] = vect(shape->vertices[i]);
    return cpPolyShapeNew(body, shape->count, vertices, cpTransformIdentity, 0.0);
}

static void release(void)
{
    for (uint32_t i = 0; i < prepared; i++) {
        cpShapeFree(movers[i]);
        cpBodyFree(bodies[i]);
    }
    for (int i = 0; i < BENCH_SHAPES && ground; i++) cpShapeFree(polygons[i]);
    if (ground) cpBodyFree(ground);
}

static cpShape *mover_of(cpBody *body, const bench_set *set, const bench_pair *pair)
{
    if (set->kind == BENCH_HULL) return polygon_of(body, &set->hulls[pair->hull]);
    return cpCircleShapeNew(body, (cpFloat)pair->radius / BENCH_ONE, cpvzero);
}

static void prepare(const bench_set *set)
{
    release();
    ground = cpBodyNewStatic();
    for (int i = 0; i < BENCH_SHAPES; i++) {
        polygons[i] = polygon_of(ground, &set->shapes[i]);
        cpShapeCacheBB(polygons[i]);
    }
    for (uint32_t i = 0; i < set->count; i++) {
        const bench_pair *pair = &set->pairs[i];
        from[i] = vect(pair->a);
        to[i] = vect(pair->b);
        bodies[i] = cpBodyNewKinematic();
        cpBodySetPosition(bodies[i], from[i]);
        movers[i] = mover_of(bodies[i], set, pair);
        cpShapeCacheBB(movers[i]);
        obstacles[i] = polygons[pair->shape];
    }
    prepared = set->count;
}

static uint32_t run(int what, const uint16_t *order, uint32_t count)
{
    uint32_t hits = 0;
    cpSegmentQueryInfo info;
    if (what == BENCH_SEGMENT) {
        for (uint32_t i = 0; i < count; i++) hits += cpShapeSegmentQuery(obstacles[order[i]], from[order[i]], to[order[i]], 0.0, &info);
    } else {
        for (uint32_t i = 0; i < count; i++) hits += cpShapesCollide(movers[order[i]], obstacles[order[i]]).count > 0;
    }
    return hits;
}

static void answer(bench_kind kind, uint32_t pair, bench_answer *out)
{
    cpSegmentQueryInfo info;
    out->depth = 0.0;
    if (kind == BENCH_SEGMENT) {
        out->hit = cpShapeSegmentQuery(obstacles[pair], from[pair], to[pair], 0.0, &info);
        return;
    }
    cpContactPointSet contacts = cpShapesCollide(movers[pair], obstacles[pair]);
    out->hit = contacts.count > 0;
    for (int i = 0; i < contacts.count; i++) {
        if (-contacts.points[i].distance > out->depth) out->depth = -contacts.points[i].distance;
    }
}

static double bytes(int count)
{
    int outside = count > CP_POLY_SHAPE_INLINE_ALLOC ? 2 * count : 0;
    return (double)sizeof(cpPolyShape) + (double)outside * (double)sizeof(struct cpSplittingPlane);
}

const bench_method bench_chipmunk = { "chipmunk", "double", BENCH_MAX_VERTICES, prepare, run, answer, bytes };
