/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A frame of the scene by tuff's own calls: with the index, and by linear scan. The ship's hull has no normals, and gets them at each call
   that needs them. */
#include "adapt.h"
#include "bench.h"

#define indexed  TUFF_LINK_NAME(bench_scene)
#define linear   TUFF_LINK_NAME(bench_linear_scene)

enum { INDEXED, LINEAR };

typedef struct calls { tuff_body bodies[BENCH_BODIES]; tuff_vec2 beams[BENCH_BEAMS][2]; } calls;

static tuff_vec2 vertices[BENCH_OCTAGONS * 8 + 5];
static tuff_unit2 normals[BENCH_OCTAGONS * 8 + 5];
static tuff_polygon octagons[BENCH_OCTAGONS], hull;
static tuff_terrain terrain[BENCH_PIECES];
static uint16_t buckets[BENCH_PIECES];
static tuff_chunk_entry entries[BENCH_PIECES];
static tuff_chunks chunks = TUFF_CHUNKS(buckets, entries, 6);
static tuff_world worlds[] = { { terrain, BENCH_PIECES, &chunks, NULL, 0, TUFF_ORDER_ITERATION },
                               { terrain, BENCH_PIECES, NULL, NULL, 0, TUFF_ORDER_ITERATION } };
static tuff_real radii[BENCH_BODIES];
static calls frames[BENCH_FRAMES];

static void read_frame(calls *out, const bench_frame *frame)
{
    for (int i = 0; i < BENCH_BODIES; i++) out->bodies[i] = adapt_body(frame->bodies[i]);
    for (int i = 0; i < BENCH_BEAMS * 2; i++) out->beams[i / 2][i % 2] = adapt_point(frame->beams[i / 2][i % 2]);
}

static void prepare(const bench_scene *scene)
{
    adapt_pool pool = { vertices, normals, 0 };
    for (int i = 0; i < BENCH_OCTAGONS; i++) octagons[i] = adapt_polygon(&pool, &scene->octagons[i]);
    hull = adapt_polygon(&pool, &scene->hull);
    hull.normals = NULL;
    for (int i = 0; i < BENCH_PIECES; i++) {
        int shape = scene->pieces[i].shape;
        tuff_real radius = tuff_from_q16_16(scene->radii[shape]);
        terrain[i] = (tuff_terrain){ adapt_point(scene->pieces[i].position), radius, radius, &octagons[shape], 1 };
    }
    for (int i = 0; i < BENCH_BODIES; i++) radii[i] = tuff_from_q16_16(bench_body_radius(i));
    for (int i = 0; i < BENCH_FRAMES; i++) read_frame(&frames[i], &scene->frames[i]);
    tuff_world_index(&worlds[INDEXED]);
}

static uint32_t run_frame(const tuff_world *world, const calls *frame)
{
    uint32_t hits = 0;
    for (int i = 0; i < BENCH_BODIES; i++) {
        tuff_body body = frame->bodies[i];
        hits += tuff_terrain_collide(world, &body, radii[i], i == 0 ? &hull : NULL);
    }
    for (int i = 0; i < BENCH_BEAMS; i++) hits += tuff_segment_terrain_intersect(world, frame->beams[i][0], frame->beams[i][1]);
    return hits;
}

static uint32_t run(int what, const uint16_t *order, uint32_t count)
{
    uint32_t hits = 0;
    for (uint32_t i = 0; i < count; i++) hits += run_frame(&worlds[what], &frames[order[i]]);
    return hits;
}

static uint32_t linear_bytes(void)
{
    return (uint32_t)(sizeof vertices + sizeof normals + sizeof octagons + sizeof terrain);
}

static uint32_t indexed_bytes(void)
{
    return linear_bytes() + (uint32_t)(sizeof buckets + sizeof entries + sizeof chunks);
}

const bench_scene_method indexed = { "reference", "tuff", ADAPT_BUILD, prepare, run, indexed_bytes, INDEXED };
const bench_scene_method linear = { "linear", "tuff", ADAPT_BUILD, prepare, run, linear_bytes, LINEAR };
