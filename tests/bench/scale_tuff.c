/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Calls in worlds of any size, with the index: a bucket for each piece, as far as buckets go. */
#include "adapt.h"
#include "bench.h"

#include <string.h>

#define method TUFF_LINK_NAME(bench_scale)

#define MAX_BUCKETS 32768

static tuff_vec2 vertices[BENCH_OCTAGONS * 8 + 5];
static tuff_unit2 normals[BENCH_OCTAGONS * 8 + 5];
static tuff_polygon octagons[BENCH_OCTAGONS], hull;
static tuff_terrain terrain[BENCH_MAX_PIECES];
static uint16_t buckets[MAX_BUCKETS];
static tuff_chunk_entry entries[BENCH_MAX_PIECES];
static tuff_chunks chunks;
static tuff_world world;
static tuff_body fresh[BENCH_CALLS], bodies[BENCH_CALLS];
static tuff_vec2 beams[BENCH_CALLS][2];

static void prepare(const bench_crowd *crowd)
{
    adapt_pool pool = { vertices, normals, 0 };
    uint16_t count = (uint16_t)crowd->piece_count, bucket_count = 1;
    while (bucket_count < count && bucket_count < MAX_BUCKETS) bucket_count = (uint16_t)(bucket_count * 2);
    for (int i = 0; i < BENCH_OCTAGONS; i++) octagons[i] = adapt_polygon(&pool, &crowd->octagons[i]);
    hull = adapt_polygon(&pool, &crowd->hull);
    for (uint32_t i = 0; i < count; i++) {
        int shape = crowd->pieces[i].shape;
        tuff_real radius = tuff_from_q16_16(crowd->radii[shape]);
        terrain[i] = (tuff_terrain){ adapt_point(crowd->pieces[i].position), radius, radius, &octagons[shape], 1 };
    }
    for (int i = 0; i < BENCH_CALLS; i++) {
        fresh[i] = adapt_body(crowd->bodies[i]);
        for (int end = 0; end < 2; end++) beams[i][end] = adapt_point(crowd->beams[i][end]);
    }
    chunks = (tuff_chunks){ buckets, entries, bucket_count, count, 6, 0, 0, false };
    world = (tuff_world){ terrain, count, &chunks, NULL, 0, TUFF_ORDER_ITERATION };
    tuff_world_index(&world);
}

static void reset(void)
{
    memcpy(bodies, fresh, sizeof bodies);
}

static uint32_t collide(const uint16_t *order, uint32_t count, tuff_real radius, const tuff_polygon *shape)
{
    uint32_t hits = 0;
    for (uint32_t i = 0; i < count; i++) hits += tuff_terrain_collide(&world, &bodies[order[i]], radius, shape);
    return hits;
}

static uint32_t cast(const uint16_t *order, uint32_t count)
{
    uint32_t hits = 0;
    for (uint32_t i = 0; i < count; i++) hits += tuff_segment_terrain_intersect(&world, beams[order[i]][0], beams[order[i]][1]);
    return hits;
}

/* Takes pieces out and puts them back, where they were. */
static uint32_t insert(const uint16_t *order, uint32_t count)
{
    uint32_t hits = 0;
    for (uint32_t i = 0; i < count; i++) {
        uint16_t piece = order[i];
        hits += tuff_chunks_move(&chunks, piece, terrain[piece].position, terrain[piece].bounding_radius);
    }
    return hits;
}

static uint32_t run(int what, const uint16_t *order, uint32_t count)
{
    if (what == BENCH_ENTITY_HULL) return collide(order, count, TUFF_WHOLE(8), &hull);
    if (what == BENCH_ENTITY_CIRCLE) return collide(order, count, TUFF_WHOLE(6), NULL);
    return what == BENCH_BEAM ? cast(order, count) : insert(order, count);
}

static uint32_t bytes(void)
{
    return (uint32_t)(chunks.bucket_count * sizeof buckets[0] + chunks.capacity * sizeof entries[0] + sizeof chunks);
}

const bench_scale_method method = { ADAPT_BUILD, prepare, reset, run, bytes };
