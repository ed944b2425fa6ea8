/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A frame of the scene by the textbook's tests: tuff's index says which pieces are near, each is rejected by its bounding circle or tested,
   pushed out of and bounced off. */
#include "adapt.h"
#include "bench.h"
#include "textbook.h"

#define method TUFF_LINK_NAME(bench_textbook_scene)

#define NEARBY 64

typedef struct calls { tuff_body bodies[BENCH_BODIES]; tuff_vec2 beams[BENCH_BEAMS][2]; } calls;

static tuff_vec2 vertices[BENCH_OCTAGONS * 8 + 5], normals[BENCH_OCTAGONS * 8 + 5];
static textbook_polygon octagons[BENCH_OCTAGONS], hull;
static const textbook_polygon *polygons[BENCH_PIECES];
static tuff_terrain terrain[BENCH_PIECES];
static uint16_t buckets[BENCH_PIECES], nearby[NEARBY];
static tuff_chunk_entry entries[BENCH_PIECES];
static tuff_chunks chunks = TUFF_CHUNKS(buckets, entries, 6);
static tuff_world world = { terrain, BENCH_PIECES, &chunks, nearby, NEARBY, TUFF_ORDER_ITERATION };
static tuff_real radii[BENCH_BODIES];
static calls frames[BENCH_FRAMES];

static textbook_polygon read_polygon(uint32_t *used, const bench_shape *shape)
{
    textbook_polygon polygon = { vertices + *used, normals + *used, shape->count };
    for (int i = 0; i < shape->count; i++) vertices[*used + (uint32_t)i] = adapt_point(shape->vertices[i]);
    textbook_normals(polygon.vertices, shape->count, normals + *used);
    *used += (uint32_t)shape->count;
    return polygon;
}

static void read_frame(calls *out, const bench_frame *frame)
{
    for (int i = 0; i < BENCH_BODIES; i++) out->bodies[i] = adapt_body(frame->bodies[i]);
    for (int i = 0; i < BENCH_BEAMS * 2; i++) out->beams[i / 2][i % 2] = adapt_point(frame->beams[i / 2][i % 2]);
}

static void prepare(const bench_scene *scene)
{
    uint32_t used = 0;
    for (int i = 0; i < BENCH_OCTAGONS; i++) octagons[i] = read_polygon(&used, &scene->octagons[i]);
    hull = read_polygon(&used, &scene->hull);
    for (int i = 0; i < BENCH_PIECES; i++) {
        int shape = scene->pieces[i].shape;
        tuff_real radius = tuff_from_q16_16(scene->radii[shape]);
        terrain[i] = (tuff_terrain){ adapt_point(scene->pieces[i].position), radius, radius, NULL, 0 };
        polygons[i] = &octagons[shape];
    }
    for (int i = 0; i < BENCH_BODIES; i++) radii[i] = tuff_from_q16_16(bench_body_radius(i));
    for (int i = 0; i < BENCH_FRAMES; i++) read_frame(&frames[i], &scene->frames[i]);
    tuff_world_index(&world);
}

static tuff_vec2 minus(tuff_vec2 a, tuff_vec2 b)
{
    return (tuff_vec2){ a.x - b.x, a.y - b.y };
}

static uint32_t nearby_pieces(tuff_vec2 center, tuff_real radius)
{
    uint32_t count = tuff_nearby_terrain(&world, center, radius);
    return count < NEARBY ? count : NEARBY;
}

static uint32_t collide(tuff_body *body, tuff_real radius, const textbook_polygon *shape)
{
    uint32_t pushes = 0, count = nearby_pieces(body->position, radius);
    for (uint32_t i = 0; i < count; i++) {
        textbook_contact contact;
        tuff_vec2 at = minus(body->position, terrain[nearby[i]].position);
        const textbook_polygon *polygon = polygons[nearby[i]];
        if (!(shape ? textbook_hull(shape, at, polygon, &contact) : textbook_circle(at, radius, polygon, &contact))) continue;
        textbook_bounce(body, &contact);
        pushes++;
    }
    return pushes;
}

static bool beam(tuff_vec2 a, tuff_vec2 b)
{
    tuff_vec2 middle = { a.x / 2 + b.x / 2, a.y / 2 + b.y / 2 };
    uint32_t count = nearby_pieces(middle, TUFF_WHOLE(128));
    for (uint32_t i = 0; i < count; i++) {
        tuff_vec2 at = terrain[nearby[i]].position;
        if (textbook_segment(minus(a, at), minus(b, at), polygons[nearby[i]])) return true;
    }
    return false;
}

static uint32_t run_frame(const calls *frame)
{
    uint32_t hits = 0;
    for (int i = 0; i < BENCH_BODIES; i++) {
        tuff_body body = frame->bodies[i];
        hits += collide(&body, radii[i], i == 0 ? &hull : NULL);
    }
    for (int i = 0; i < BENCH_BEAMS; i++) hits += beam(frame->beams[i][0], frame->beams[i][1]);
    return hits;
}

static uint32_t run(int what, const uint16_t *order, uint32_t count)
{
    uint32_t hits = 0;
    (void)what;
    for (uint32_t i = 0; i < count; i++) hits += run_frame(&frames[order[i]]);
    return hits;
}

static uint32_t bytes(void)
{
    return (uint32_t)(sizeof vertices + sizeof normals + sizeof octagons + sizeof polygons + sizeof terrain + sizeof buckets +
                      sizeof entries + sizeof chunks);
}

const bench_scene_method method = { "reference", "textbook", ADAPT_BUILD, prepare, run, bytes, 0 };
