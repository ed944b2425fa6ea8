/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A frame of the scene by Chipmunk2D's queries of a space: each body's shape against the static shapes, pushed and bounced as tuff does
   it; a beam finds the first shape. A piece is a shape of its own, since its place is baked into it. */
#include "bench.h"

#include <chipmunk/chipmunk_private.h>

typedef struct mover { cpVect position, velocity; } mover;
typedef struct calls { mover bodies[BENCH_BODIES]; cpVect beams[BENCH_BEAMS][2]; } calls;
typedef struct collision { mover moving; cpBody *body; cpShape *shape; uint32_t pushes; } collision;

static cpSpace *space;
static cpBody *bodies[BENCH_BODIES];
static cpShape *shapes[BENCH_BODIES];
static calls frames[BENCH_FRAMES];

static cpVect vect(bench_point p)
{
    return cpv((cpFloat)p.x / BENCH_ONE, (cpFloat)p.y / BENCH_ONE);
}

static cpShape *polygon_at(cpBody *body, const bench_shape *shape, cpVect at)
{
    cpVect vertices[BENCH_MAX_VERTICES];
    for (int i = 0; i < shape->count; i++) vertices[i] = vect(shape->vertices[i]);
    return cpPolyShapeNew(body, shape->count, vertices, cpTransformTranslate(at), 0.0);
}

static void read_frame(calls *out, const bench_frame *frame)
{
    for (int i = 0; i < BENCH_BODIES; i++) out->bodies[i] = (mover){ vect(frame->bodies[i].position), vect(frame->bodies[i].velocity) };
    for (int i = 0; i < BENCH_BEAMS * 2; i++) out->beams[i / 2][i % 2] = vect(frame->beams[i / 2][i % 2]);
}

static void prepare(const bench_scene *scene)
{
    space = cpSpaceNew();
    for (int i = 0; i < BENCH_PIECES; i++) {
        const bench_piece *piece = &scene->pieces[i];
        cpSpaceAddShape(space, polygon_at(cpSpaceGetStaticBody(space), &scene->octagons[piece->shape], vect(piece->position)));
    }
    for (int i = 0; i < BENCH_BODIES; i++) {
        bodies[i] = cpBodyNewKinematic();
        shapes[i] = i == 0 ? polygon_at(bodies[i], &scene->hull, cpvzero)
                           : cpCircleShapeNew(bodies[i], (cpFloat)bench_body_radius(i) / BENCH_ONE, cpvzero);
    }
    for (int i = 0; i < BENCH_FRAMES; i++) read_frame(&frames[i], &scene->frames[i]);
}

static void bounce(mover *moving, cpVect normal, cpFloat depth)
{
    cpFloat speed = cpvdot(moving->velocity, normal);
    moving->position = cpvadd(moving->position, cpvmult(normal, depth));
    if (speed >= 0.0) return;
    cpVect along = cpvsub(moving->velocity, cpvmult(normal, speed));
    moving->velocity = cpvadd(cpvmult(normal, -0.09 * speed), cpvmult(along, 0.99));
}

/* The points' normal leads from the body into the piece. */
static void push_out(cpShape *piece, cpContactPointSet *points, void *data)
{
    collision *query = (collision *)data;
    cpFloat depth = 0.0;
    (void)piece;
    for (int i = 0; i < points->count; i++) depth = cpfmax(depth, -points->points[i].distance);
    bounce(&query->moving, cpvneg(points->normal), depth);
    cpBodySetPosition(query->body, query->moving.position);
    cpShapeCacheBB(query->shape);
    query->pushes++;
}

static uint32_t run_frame(const calls *frame)
{
    uint32_t hits = 0;
    for (int i = 0; i < BENCH_BODIES; i++) {
        collision query = { frame->bodies[i], bodies[i], shapes[i], 0 };
        cpBodySetPosition(bodies[i], query.moving.position);
        cpSpaceShapeQuery(space, shapes[i], push_out, &query);
        hits += query.pushes;
    }
    for (int i = 0; i < BENCH_BEAMS; i++) {
        cpSegmentQueryInfo info;
        hits += cpSpaceSegmentQueryFirst(space, frame->beams[i][0], frame->beams[i][1], 0.0, CP_SHAPE_FILTER_ALL, &info) != NULL;
    }
    return hits;
}

static uint32_t run(int what, const uint16_t *order, uint32_t count)
{
    uint32_t hits = 0;
    (void)what;
    for (uint32_t i = 0; i < count; i++) hits += run_frame(&frames[order[i]]);
    return hits;
}

/* The shapes alone; the tree's nodes are private. */
static uint32_t bytes(void)
{
    return (uint32_t)(BENCH_PIECES * (sizeof(cpPolyShape) + 2 * 8 * sizeof(struct cpSplittingPlane)));
}

const bench_scene_method bench_chipmunk_scene = { "reference", "chipmunk", "double", prepare, run, bytes, 0 };
