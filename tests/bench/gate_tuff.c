/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Each public function of the game's frame on fixed inputs. */
#include "adapt.h"
#include "gate.h"

#include <string.h>

#define SCREEN_PIECES 64            /* enough for the functions without an index */

typedef struct mover {
    tuff_vec2 a, b;
    tuff_real radius;
    const tuff_polygon *hull, *polygon;
} mover;

static tuff_vec2 vertices[BENCH_KINDS * (BENCH_SHAPES + BENCH_HULLS) * BENCH_MAX_VERTICES + BENCH_OCTAGONS * 8 + 5];
static tuff_unit2 normals[sizeof vertices / sizeof *vertices];
static tuff_polygon polygons[BENCH_KINDS][BENCH_SHAPES], hulls[BENCH_KINDS][BENCH_HULLS], octagons[BENCH_OCTAGONS], ship, bare_ship;
static mover movers[BENCH_KINDS][BENCH_TIMED_PAIRS];
static tuff_terrain pieces[BENCH_KINDS][BENCH_SHAPES], terrain[GATE_PIECES];
static uint16_t buckets[GATE_PIECES], nearby[SCREEN_PIECES];
static tuff_chunk_entry entries[GATE_PIECES];
static tuff_chunks chunks = TUFF_CHUNKS(buckets, entries, 6);
static tuff_world world = { terrain, GATE_PIECES, &chunks, nearby, SCREEN_PIECES, TUFF_ORDER_ITERATION };
static tuff_body fresh[BENCH_CALLS], bodies[BENCH_CALLS];
static tuff_contact contacts[BENCH_CALLS];
static tuff_vec2 beams[BENCH_CALLS][2];

static void read_set(adapt_pool *pool, const bench_set *set)
{
    bench_kind kind = set->kind;
    for (int i = 0; i < BENCH_HULLS; i++) hulls[kind][i] = adapt_polygon(pool, &set->hulls[i]);
    for (int i = 0; i < BENCH_SHAPES; i++) {
        polygons[kind][i] = adapt_polygon(pool, &set->shapes[i]);
        pieces[kind][i] = (tuff_terrain){ { 0, 0 }, TUFF_WHOLE(24), TUFF_WHOLE(33), &polygons[kind][i], 1 };
    }
    for (int i = 0; i < BENCH_TIMED_PAIRS; i++) {
        const bench_pair *pair = &set->pairs[i];
        movers[kind][i] = (mover){ adapt_point(pair->a), adapt_point(pair->b), tuff_from_q16_16(pair->radius), &hulls[kind][pair->hull],
                                   &polygons[kind][pair->shape] };
    }
}

static void read_crowd(adapt_pool *pool, const bench_crowd *crowd)
{
    for (int i = 0; i < BENCH_OCTAGONS; i++) octagons[i] = adapt_polygon(pool, &crowd->octagons[i]);
    ship = bare_ship = adapt_polygon(pool, &crowd->hull);
    bare_ship.normals = NULL;
    for (int i = 0; i < GATE_PIECES; i++) {
        int shape = crowd->pieces[i].shape;
        tuff_real radius = tuff_from_q16_16(crowd->radii[shape]);
        terrain[i] = (tuff_terrain){ adapt_point(crowd->pieces[i].position), radius, radius, &octagons[shape], 1 };
    }
    for (int i = 0; i < BENCH_CALLS; i++) {
        fresh[i] = adapt_body(crowd->bodies[i]);
        contacts[i] = (tuff_contact){ TUFF_WHOLE(1), octagons[i % BENCH_OCTAGONS].normals[i % 8] };
        for (int end = 0; end < 2; end++) beams[i][end] = adapt_point(crowd->beams[i][end]);
    }
}

static void prepare(const bench_set *sets, const bench_crowd *crowd)
{
    adapt_pool pool = { vertices, normals, 0 };
    for (int kind = 0; kind < BENCH_KINDS; kind++) read_set(&pool, &sets[kind]);
    read_crowd(&pool, crowd);
    tuff_world_index(&world);
}

static void reset(void)
{
    memcpy(bodies, fresh, sizeof bodies);
}

static uint32_t one(gate_function function, uint16_t i)
{
    const mover *circle = &movers[BENCH_CIRCLE][i], *hull = &movers[BENCH_HULL][i], *segment = &movers[BENCH_SEGMENT][i];
    const tuff_terrain *of_circle = &pieces[BENCH_CIRCLE][i % BENCH_SHAPES], *of_hull = &pieces[BENCH_HULL][i % BENCH_SHAPES];
    tuff_contact contact;
    tuff_beam_hit hit;
    switch (function) {
    case GATE_CIRCLE_CIRCLE: return tuff_circle_circle(circle->a, circle->radius, TUFF_WHOLE(24), &contact);
    case GATE_CIRCLE_POLYGON: return tuff_circle_polygon(circle->a, circle->radius, circle->polygon, &contact);
    case GATE_POLYGON_POLYGON: return tuff_polygon_polygon(hull->hull, hull->a, hull->polygon, &contact);
    case GATE_SEGMENT_CIRCLE: return tuff_segment_circle(segment->a, segment->b, TUFF_WHOLE(24));
    case GATE_SEGMENT_POLYGON: return tuff_segment_polygon(segment->a, segment->b, segment->polygon);
    case GATE_TERRAIN_OVERLAP_CIRCLE: return tuff_terrain_overlap_circle(of_circle, circle->a, circle->radius, &contact);
    case GATE_TERRAIN_OVERLAP_HULL: return tuff_terrain_overlap_hull(of_hull, hull->a, TUFF_WHOLE(11), hull->hull, &contact);
    case GATE_BOUNCE: tuff_bounce(&bodies[i], &contacts[i]); return 1;
    case GATE_TERRAIN_COLLIDE_CIRCLE: return tuff_terrain_collide_circle(&world, &bodies[i], TUFF_WHOLE(6));
    case GATE_TERRAIN_COLLIDE_HULL: return tuff_terrain_collide(&world, &bodies[i], TUFF_WHOLE(8), &ship);
    case GATE_TERRAIN_COLLIDE_BARE_HULL: return tuff_terrain_collide(&world, &bodies[i], TUFF_WHOLE(8), &bare_ship);
    case GATE_FLOATER_COLLIDE_CIRCLE: return tuff_floater_collide_circle(&bodies[i], TUFF_WHOLE(6), terrain, SCREEN_PIECES);
    case GATE_FLOATER_COLLIDE_HULL: return tuff_floater_collide(&bodies[i], TUFF_WHOLE(8), terrain, SCREEN_PIECES, &ship);
    case GATE_SEGMENT_TERRAIN_INTERSECT: return tuff_segment_terrain_intersect(&world, beams[i][0], beams[i][1]);
    case GATE_SEGMENT_TERRAIN_FIRST_HIT: return tuff_segment_terrain_first_hit(&world, beams[i][0], beams[i][1], &hit);
    case GATE_NEARBY_TERRAIN: return tuff_nearby_terrain(&world, bodies[i].position, TUFF_WHOLE(64));
    case GATE_CHUNKS_MOVE: return tuff_chunks_move(&chunks, i, terrain[i].position, terrain[i].bounding_radius);
    case GATE_FUNCTIONS: break;
    }
    return 0;
}

static uint32_t run(int what, const uint16_t *order, uint32_t count)
{
    uint32_t hits = 0;
    for (uint32_t i = 0; i < count; i++) hits += one((gate_function)what, order[i]);
    return hits;
}

const gate_side TUFF_LINK_NAME(gate_side) = { ADAPT_BUILD, prepare, reset, run };
