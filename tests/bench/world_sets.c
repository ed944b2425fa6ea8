/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The inputs of the scenes and of the scale. */
#include "adapt.h"
#include "sets.h"

#define SCREEN 512.0        /* half a side of the square in which the calls of a crowd are made */

static int32_t raw(double units)
{
    return (int32_t)floor(units * BENCH_ONE);
}

static bench_point point_within(random_source *source, double extent)
{
    double x = random_within(source, -extent, extent);
    return (bench_point){ raw(x), raw(random_within(source, -extent, extent)) };
}

static bench_point heading(random_source *source, double length)
{
    double angle = random_within(source, 0.0, 6.283185307179586);
    return (bench_point){ raw(cos(angle) * length), raw(sin(angle) * length) };
}

static bench_point plus(bench_point a, bench_point b)
{
    return (bench_point){ a.x + b.x, a.y + b.y };
}

static void make_shapes(random_source *source, bench_shape *octagons, int32_t *radii, bench_shape *hull)
{
    for (int i = 0; i < BENCH_OCTAGONS; i++) {
        tuff_vec2 vertices[8];
        double size = 12.0 + 20.0 * i / (BENCH_OCTAGONS - 1);
        bench_make_rock(source, &octagons[i], 8, size, size);
        for (int j = 0; j < 8; j++) vertices[j] = adapt_point(octagons[i].vertices[j]);
        radii[i] = random_cover(vertices, 8);
    }
    bench_make_rock(source, hull, 5, 7.9, 7.9);
}

static void make_pieces(random_source *source, bench_piece *pieces, uint32_t count, double extent)
{
    for (uint32_t i = 0; i < count; i++) {
        pieces[i].position = point_within(source, extent);
        pieces[i].shape = (uint8_t)random_below(source, BENCH_OCTAGONS);
    }
}

/* ---- the scene ---- */

typedef struct flight {
    tuff_vec2    vertices[BENCH_OCTAGONS * 8 + 5];
    tuff_unit2   normals[BENCH_OCTAGONS * 8 + 5];
    tuff_polygon octagons[BENCH_OCTAGONS], hull;
    tuff_terrain terrain[BENCH_PIECES];
    tuff_world   world;
    tuff_body    bodies[BENCH_BODIES];
} flight;

static void begin_flight(flight *f, random_source *source, const bench_scene *scene)
{
    adapt_pool pool = { f->vertices, f->normals, 0 };
    for (int i = 0; i < BENCH_OCTAGONS; i++) f->octagons[i] = adapt_polygon(&pool, &scene->octagons[i]);
    f->hull = adapt_polygon(&pool, &scene->hull);
    for (int i = 0; i < BENCH_PIECES; i++) {
        int shape = scene->pieces[i].shape;
        int32_t radius = scene->radii[shape];
        f->terrain[i] = (tuff_terrain){ adapt_point(scene->pieces[i].position), radius, radius, &f->octagons[shape], 1 };
    }
    f->world = (tuff_world){ f->terrain, BENCH_PIECES, NULL, NULL, 0, TUFF_ORDER_ITERATION };
    for (int i = 0; i < BENCH_BODIES; i++) {
        double speed = i <= BENCH_ENEMIES ? 2.0 : 6.0;
        f->bodies[i] = adapt_body((bench_body){ point_within(source, BENCH_SIDE / 2), heading(source, speed) });
    }
}

/* Over the edge, back in at the other side. */
static int32_t wrapped(int32_t at)
{
    const int32_t half = BENCH_SIDE / 2 * BENCH_ONE;
    return at > half ? at - 2 * half : at < -half ? at + 2 * half : at;
}

/* A body that has lost its speed to bounces sets out anew. */
static void advance(tuff_body *body, random_source *source, double speed)
{
    bench_point away = heading(source, speed);
    bool slow = abs(body->velocity.x) + abs(body->velocity.y) < raw(speed) / 4;
    if (slow) body->velocity = (tuff_vec2){ away.x, away.y };
    body->position.x = wrapped(body->position.x + body->velocity.x);
    body->position.y = wrapped(body->position.y + body->velocity.y);
}

static void record(const flight *f, random_source *source, bench_frame *frame)
{
    for (int i = 0; i < BENCH_BODIES; i++) {
        const tuff_body *body = &f->bodies[i];
        frame->bodies[i] = (bench_body){ { body->position.x, body->position.y }, { body->velocity.x, body->velocity.y } };
    }
    for (int i = 0; i < BENCH_BEAMS; i++) {
        frame->beams[i][0] = frame->bodies[1 + i].position;
        frame->beams[i][1] = plus(frame->beams[i][0], heading(source, 256.0));
    }
}

static void fly(bench_scene *scene, bench_frame *frames, int steps_a_frame)
{
    static flight f;
    random_source source = random_stream(1, 0);
    make_shapes(&source, scene->octagons, scene->radii, &scene->hull);
    make_pieces(&source, scene->pieces, BENCH_PIECES, BENCH_SIDE / 2);
    begin_flight(&f, &source, scene);
    for (int step = 0; step < BENCH_STEPS; step++) {
        for (int i = 0; i < BENCH_BODIES; i++) advance(&f.bodies[i], &source, i <= BENCH_ENEMIES ? 2.0 : 6.0);
        if (step % steps_a_frame == 0) record(&f, &source, &frames[step / steps_a_frame]);
        for (int i = 0; i < BENCH_BODIES; i++) tuff_terrain_collide(&f.world, &f.bodies[i], bench_body_radius(i), i == 0 ? &f.hull : NULL);
    }
}

void bench_make_scene(bench_scene *scene)
{
    fly(scene, scene->frames, BENCH_STEPS / BENCH_FRAMES);
}

void bench_make_whole_scene(bench_scene *scene, bench_frame *frames)
{
    fly(scene, frames, 1);
}

/* ---- the crowd ---- */

static bool on_screen(bench_point p)
{
    return abs(p.x) <= raw(SCREEN) && abs(p.y) <= raw(SCREEN);
}

/* The pieces of the screen come first, the same ones in a world of any size; the others lie around it. */
static void make_crowd_pieces(random_source *source, bench_crowd *crowd, double density, double extent)
{
    double share = (2.0 * SCREEN / BENCH_SIDE) * (2.0 * SCREEN / BENCH_SIDE);
    uint32_t inner = (uint32_t)(density * BENCH_PIECES * share);
    make_pieces(source, crowd->pieces, inner, SCREEN);
    for (uint32_t i = inner; i < crowd->piece_count; i++) {
        do make_pieces(source, &crowd->pieces[i], 1, extent);
        while (on_screen(crowd->pieces[i].position));
    }
}

void bench_make_crowd(bench_crowd *crowd, uint32_t pieces, double density, double length, bool near)
{
    random_source shapes = random_stream(1, 0), places = random_stream(1, 1), calls = random_stream(1, 2);
    double extent = BENCH_SIDE / 2 * sqrt(pieces / density / BENCH_PIECES), span = near ? SCREEN : extent;
    crowd->piece_count = pieces;
    make_shapes(&shapes, crowd->octagons, crowd->radii, &crowd->hull);
    make_crowd_pieces(&places, crowd, density, extent);
    for (int i = 0; i < BENCH_CALLS; i++) {
        crowd->bodies[i] = (bench_body){ point_within(&calls, span), heading(&calls, 2.0) };
        crowd->beams[i][0] = point_within(&calls, span);
        crowd->beams[i][1] = plus(crowd->beams[i][0], heading(&calls, length));
    }
}
