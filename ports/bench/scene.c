/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   In the reference scene: counts the nearby query and the circles' collide calls for the first frame's bodies, single beams, and whole
   frames; the ship's hull has no normals. Prints `case,NAME,,CLASS` before the counts of each. */
#include <stdio.h>

#include "calls.h"
#include "sets.h"

#define QUERY  64                   /* units */
#define NEARBY 64
#define BEAM_FRAMES 12              /* give this many times six beams */

static tuff_vec2 vertices[BENCH_OCTAGONS * 8 + 5];
static tuff_unit2 normals[BENCH_OCTAGONS * 8 + 5];
static tuff_polygon octagons[BENCH_OCTAGONS], hull;
static tuff_terrain terrain[BENCH_PIECES];
static uint16_t buckets[BENCH_PIECES], nearby[NEARBY];
static tuff_chunk_entry entries[BENCH_PIECES];
static tuff_chunks chunks = TUFF_CHUNKS(buckets, entries, 6);
static tuff_world world = { terrain, BENCH_PIECES, &chunks, nearby, NEARBY, TUFF_ORDER_ITERATION };
static tuff_real radii[BENCH_BODIES];
static calls_frame calls;

static void read_world(void)
{
    adapt_pool pool = { vertices, normals, 0 };
    for (int i = 0; i < BENCH_OCTAGONS; i++) octagons[i] = adapt_polygon(&pool, &sets_scene.octagons[i]);
    hull = adapt_polygon(&pool, sets_scene.hull);
    hull.normals = NULL;
    for (int i = 0; i < BENCH_PIECES; i++) {
        int shape = sets_scene.pieces[i].shape;
        tuff_real radius = tuff_from_q16_16(sets_scene.radii[shape]);
        terrain[i] = (tuff_terrain){ adapt_point(sets_scene.pieces[i].position), radius, radius, &octagons[shape], 1 };
    }
    for (int i = 0; i < BENCH_BODIES; i++) radii[i] = tuff_from_q16_16(bench_body_radius(i));
    tuff_world_index(&world);
}

static void read_frame(const bench_frame *frame)
{
    for (int i = 0; i < BENCH_BODIES; i++) calls.bodies[i] = adapt_body(frame->bodies[i]);
    for (int i = 0; i < BENCH_BEAMS * 2; i++) calls.beams[i / 2][i % 2] = adapt_point(frame->beams[i / 2][i % 2]);
}

static void begin_case(const char *name)
{
    puts(name);
    fflush(stdout);
}

static void run_nearby(void)
{
    begin_case("case,nearby,,64 units");
    read_frame(&sets_scene.frames[0]);
    for (int i = 0; i < BENCH_BODIES; i++) count_nearby(&world, calls.bodies[i].position, TUFF_WHOLE(QUERY));
}

static void run_collide(void)
{
    begin_case("case,collide,,circle");
    for (int i = 1; i < BENCH_BODIES; i++) count_collide(&world, &calls.bodies[i], radii[i]);
}

static void run_beams(void)
{
    begin_case("case,beam,,256 units");
    for (uint16_t frame = 0; frame < BEAM_FRAMES; frame++) {
        read_frame(&sets_scene.frames[frame]);
        for (int i = 0; i < BENCH_BEAMS; i++) count_beam(&world, calls.beams[i][0], calls.beams[i][1]);
    }
}

static void run_frames(void)
{
    begin_case("case,scene,,frame");
    for (uint16_t frame = 0; frame < sets_scene.frame_count; frame++) {
        read_frame(&sets_scene.frames[frame]);
        count_frame(&world, &calls, radii, &hull);
    }
}

int main(void)
{
    read_world();
    run_nearby();
    run_collide();
    run_beams();
    run_frames();
    return 0;
}
