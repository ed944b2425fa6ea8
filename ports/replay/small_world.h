/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The world of the replays for machines with 2.5 KB of RAM: rocks that die and grow again, and what moves among them. All numbers are
   exact in both builds. */
#ifndef SMALL_WORLD_H
#define SMALL_WORLD_H

#include <stdio.h>

#include <tuff/tuff.h>

#include "trace.h"

#define STEPS  3600
#define ROCKS  9
#define MOVING 7       /* bodies, or the ends of beams */
#define SIDE   160     /* they turn round this far from the middle */

#if TUFF_SCALAR == TUFF_Q16_16
#define BUILD "q16"
#else
#define BUILD "float"
#endif

#define AT(x, y) { TUFF_WHOLE(x), TUFF_WHOLE(y) }

static const tuff_vec2 boulder_corners[6] = { AT(-20, -9), AT(-3, -19), AT(17, -13), AT(22, 6), AT(4, 20), AT(-16, 13) };
static const tuff_vec2 slab_corners[4] = { AT(-30, -6), AT(28, -8), AT(30, 5), AT(-26, 9) };
static tuff_unit2 boulder_normals[6], slab_normals[4];
static const tuff_polygon boulder = { boulder_corners, boulder_normals, 0, 6 };
static const tuff_polygon slab = { slab_corners, slab_normals, 0, 4 };
static const tuff_material bumper = { TUFF_RATIO(1, 1), TUFF_RATIO(0, 1) };

static tuff_terrain rocks[ROCKS];
static uint16_t buckets[8];
static tuff_chunk_entry entries[ROCKS];
static tuff_chunks chunks = TUFF_CHUNKS(buckets, entries, 6);
static tuff_world world = { rocks, ROCKS, &chunks, NULL, 0, TUFF_ORDER_ITERATION };
static tuff_body bodies[MOVING];
static uint32_t seed = 1, hash = 2166136261u;
static uint32_t histories[MOVING];

/* Numerical Recipes' generator; its high bits. */
static int16_t random_within(int16_t range)
{
    seed = seed * 1664525u + 1013904223u;
    return (int16_t)((int32_t)((seed >> 16) * (uint32_t)(2 * range + 1) >> 16) - range);
}

static void note(uint32_t word)
{
    hash = fold(hash, word);
}

static tuff_terrain rock_at(uint8_t kind, int16_t x, int16_t y)
{
    tuff_terrain rock = { AT(x, y), TUFF_WHOLE(18), TUFF_WHOLE(32), NULL, 1 };
    if (kind % 3 == 0) rock.parts = &boulder;
    if (kind % 3 == 1) rock.parts = &slab;
    return rock;
}

/* One of each place of a grid, off it by up to this. */
static tuff_terrain rock_of(uint16_t number, int16_t off)
{
    int16_t x = (int16_t)(number % 3 * 100 - 100 + random_within(off));
    int16_t y = (int16_t)(number / 3 * 100 - 100 + random_within(off));
    return rock_at((uint8_t)number, x, y);
}

static void begin_world(void)
{
    uint8_t i;
    tuff_edge_normals(boulder_corners, 6, boulder_normals);
    tuff_edge_normals(slab_corners, 4, slab_normals);
    for (i = 0; i < ROCKS; ++i) rocks[i] = rock_of(i, 12);
    for (i = 0; i < MOVING; ++i) {
        bodies[i].position.x = TUFF_WHOLE(50) - TUFF_WHOLE(1) * (tuff_real)(i % 2 * 100);
        bodies[i].position.y = TUFF_WHOLE(1) * (tuff_real)(i * 15) - TUFF_WHOLE(52);
        bodies[i].velocity.x = TUFF_RATIO(1, 64) * (tuff_real)random_within(96);
        bodies[i].velocity.y = TUFF_RATIO(1, 64) * (tuff_real)random_within(96);
        bodies[i].material = &bumper;
    }
    (void)tuff_world_index(&world);
}

static void turn_round(tuff_real position, tuff_real *velocity)
{
    if ((position > TUFF_WHOLE(SIDE) && *velocity > 0) || (position < -TUFF_WHOLE(SIDE) && *velocity < 0)) *velocity = -*velocity;
}

static void move(tuff_body *body)
{
    turn_round(body->position.x, &body->velocity.x);
    turn_round(body->position.y, &body->velocity.y);
    body->position.x += body->velocity.x;
    body->position.y += body->velocity.y;
}

/* Every 128 steps a rock dies, and 64 steps later it grows again somewhere near. */
static void edit_world(uint16_t step)
{
    uint16_t number = (uint16_t)(step / 128 % ROCKS);
    if (step % 128 == 0) {
        note(tuff_chunks_remove(&chunks, number));
        rocks[number].bounding_radius = 0;
    }
    if (step % 128 == 64) {
        rocks[number] = rock_of(number, 20);
        note(tuff_chunks_insert(&chunks, number, rocks[number].position, rocks[number].bounding_radius));
    }
}

static void end_step(void)
{
    trace_text(" ");
    trace_hash(hash);
    trace_text("\n");
}

static void print_hash(void)
{
    printf("replay " BUILD " %08lX\n", (unsigned long)hash);
}

#endif
