/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Bad input: the checks name every fault; the calls of a frame survive whatever they are given (run this under the sanitizers) and leave
   the body alone or in range; and the float build raises no floating-point exception on legal numbers, however small. */
#define _GNU_SOURCE
#include <fenv.h>
#include <setjmp.h>
#include <signal.h>
#include <string.h>
#include <unistd.h>

#include "rocks.h"

/* ---- numbers of every kind ---- */

/* As float: zeros, the smallest numbers, infinities, NaNs, the largest numbers. As integers: the ends of the range and their like. */
static const uint32_t odd_bits[] = { 0, 1, 0x80000000u, 0x80000001u, 0x7FFFFFFFu, 0xFFFFFFFFu, 0x00800000u, 0x007FFFFFu,
                                     0x7F800000u, 0xFF800000u, 0x7FC00000u, 0xFFC00000u, 0x7F800001u, 0x7F7FFFFFu, 0xFF7FFFFFu };

/* The same bits are a number of some kind in either build. */
static tuff_real real_of_bits(uint32_t bits)
{
    tuff_real value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static tuff_unit unit_of_bits(uint32_t bits)
{
    tuff_unit value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static uint32_t any_bits(random_source *source)
{
    if (random_chance(source, 50)) return random_bits(source);
    return odd_bits[random_below(source, sizeof odd_bits / sizeof odd_bits[0])];
}

/* Whatever fits into a tuff_real, with the limits and their neighbors among it. */
static tuff_real any_real(random_source *source)
{
    static const int16_t limits[] = { 0, 1, TUFF_MAX_RESTITUTION, TUFF_MAX_RADIUS, TUFF_MAX_BOUNDING_RADIUS, 32767 };
    switch (random_below(source, 4)) {
    case 0:  return real_of_bits(any_bits(source));
    case 1:  return random_point(source, 1024.0).x;
    case 2:  return random_point(source, 20.0).x;
    default: break;
    }
    tuff_real limit = TUFF_WHOLE(limits[random_below(source, 6)]);
    if (random_chance(source, 50)) limit = -limit;
    return limit + TUFF_REAL_RAW(random_between(source, -1, 1));
}

static tuff_vec2 any_vec2(random_source *source)
{
    tuff_real x = any_real(source);
    return (tuff_vec2){ x, any_real(source) };
}

static bool finite_within(tuff_real a, int32_t limit)
{
    return exact_real(a) <= (exact)limit * EXACT_UNIT && exact_real(a) >= -(exact)limit * EXACT_UNIT;
}

static bool vec2_within(tuff_vec2 v, int32_t limit)
{
    return finite_within(v.x, limit) && finite_within(v.y, limit);
}

/* ---- the checks ---- */

static bool named[TUFF_FAULT_COUNT];

static void expect_fault(tuff_fault wanted, tuff_fault got)
{
    if (got != wanted) fail_msg("wanted: %s; got: %s", tuff_fault_text(wanted), tuff_fault_text(got));
    named[wanted] = true;
}

static void make_box(random_shape *box)
{
    random_box_shape(box, (tuff_vec2){ TUFF_WHOLE(4), TUFF_WHOLE(3) });
}

/* A polygon that was edited after it was baked. */
static void expect_rebaked(tuff_fault wanted, random_shape *shape, int count)
{
    tuff_edge_normals(shape->vertices, (uint8_t)count, shape->normals);
    shape->polygon.count = (uint8_t)count;
    expect_fault(wanted, tuff_check_polygon(&shape->polygon));
    expect_fault(wanted, tuff_check_hull(&shape->polygon));
}

static void name_faults_of_counts(void)
{
    random_shape box;
    make_box(&box);
    expect_fault(TUFF_OK, tuff_check_polygon(&box.polygon));
    expect_fault(TUFF_FAULT_NULL, tuff_check_polygon(NULL));
    expect_fault(TUFF_FAULT_NULL, tuff_check_hull(NULL));
    for (int count = 0; count < 3; count++) {
        box.polygon.count = (uint8_t)count;
        expect_fault(TUFF_FAULT_TOO_FEW_VERTICES, tuff_check_polygon(&box.polygon));
    }
    for (int count = TUFF_MAX_VERTICES + 1; count < 256; count++) {
        box.polygon.count = (uint8_t)count;
        expect_fault(TUFF_FAULT_TOO_MANY_VERTICES, tuff_check_polygon(&box.polygon));
    }
    make_box(&box);
    box.polygon.internal_edges = 16;
    expect_fault(TUFF_FAULT_INTERNAL_BITS, tuff_check_polygon(&box.polygon));
    make_box(&box);
    box.polygon.vertices = NULL;
    expect_fault(TUFF_FAULT_NULL, tuff_check_polygon(&box.polygon));
}

static void name_faults_of_vertices(void)
{
    random_shape box;
    make_box(&box);
    box.vertices[2].y = TUFF_WHOLE(TUFF_MAX_EXTENT) + TUFF_REAL_RAW(64);
    expect_rebaked(TUFF_FAULT_VERTEX_RANGE, &box, 4);
    make_box(&box);
    box.vertices[0].x = -TUFF_WHOLE(TUFF_MAX_EXTENT) - TUFF_REAL_RAW(64);
    expect_rebaked(TUFF_FAULT_VERTEX_RANGE, &box, 4);
    make_box(&box);
    box.vertices[3] = box.vertices[2];
    expect_rebaked(TUFF_FAULT_DUPLICATE_VERTEX, &box, 4);
    make_box(&box);
    box.vertices[3] = box.vertices[0];
    expect_rebaked(TUFF_FAULT_DUPLICATE_VERTEX, &box, 4);
    make_box(&box);
    for (int i = 0; i < 4; i++) box.vertices[i] = (tuff_vec2){ TUFF_WHOLE(i), TUFF_WHOLE(2 * i) };
    expect_rebaked(TUFF_FAULT_NO_AREA, &box, 4);
}

static void name_faults_of_outlines(void)
{
    static const int8_t star[5][2] = { { 0, 10 }, { 6, -8 }, { -10, 3 }, { 10, 3 }, { -6, -8 } };
    random_shape shape;
    make_box(&shape);
    shape.vertices[2] = (tuff_vec2){ -TUFF_WHOLE(3), -TUFF_WHOLE(2) };
    expect_rebaked(TUFF_FAULT_CONCAVE, &shape, 4);
    make_box(&shape);
    shape.vertices[1] = (tuff_vec2){ TUFF_WHOLE(4), TUFF_WHOLE(3) };
    shape.vertices[2] = (tuff_vec2){ TUFF_WHOLE(4), -TUFF_WHOLE(3) };
    expect_rebaked(TUFF_FAULT_CONCAVE, &shape, 4);
    for (int i = 0; i < 5; i++) shape.vertices[i] = (tuff_vec2){ TUFF_WHOLE(star[i][0]), TUFF_WHOLE(star[i][1]) };
    expect_rebaked(TUFF_FAULT_CONCAVE, &shape, 5);
    make_box(&shape);
    for (int i = 0; i < 4; i++) shape.vertices[i + 4] = shape.vertices[i];
    expect_rebaked(TUFF_FAULT_CONCAVE, &shape, 8);
    make_box(&shape);
    shape.vertices[4] = (tuff_vec2){ -TUFF_WHOLE(4), 0 };
    expect_rebaked(TUFF_OK, &shape, 5);
}

static void name_faults_of_normals(void)
{
    random_shape box;
    make_box(&box);
    box.polygon.normals = NULL;
    expect_fault(TUFF_FAULT_NO_NORMALS, tuff_check_polygon(&box.polygon));
    expect_fault(TUFF_OK, tuff_check_hull(&box.polygon));
    make_box(&box);
    box.normals[1].x = TUFF_UNIT_RATIO(99, 100);
    expect_fault(TUFF_FAULT_NORMAL_LENGTH, tuff_check_polygon(&box.polygon));
    box.normals[1].x = 0;
    expect_fault(TUFF_FAULT_NORMAL_LENGTH, tuff_check_polygon(&box.polygon));
    make_box(&box);
    box.normals[1].x = -box.normals[1].x;
    expect_fault(TUFF_FAULT_NORMAL_INWARD, tuff_check_polygon(&box.polygon));
    expect_fault(TUFF_FAULT_NORMAL_INWARD, tuff_check_hull(&box.polygon));
    make_box(&box);
    box.normals[1] = (tuff_unit2){ TUFF_UNIT_RATIO(3, 5), TUFF_UNIT_RATIO(4, 5) };
    expect_fault(TUFF_FAULT_NORMAL_DIRECTION, tuff_check_polygon(&box.polygon));
    make_box(&box);
    random_source source = random_stream(71, 0);
    for (int i = 0; i < 32; i++) {
        random_renumber(&source, box.vertices, 4);
        expect_rebaked(TUFF_OK, &box, 4);
    }
}

static void name_faults_of_pieces(void)
{
    random_shape box;
    make_box(&box);
    const tuff_terrain good = { { 0, 0 }, TUFF_WHOLE(4), box.bounding_radius, &box.polygon, 1 };
    tuff_terrain piece = good, slot;
    memset(&slot, 0, sizeof slot);
    expect_fault(TUFF_OK, tuff_check_terrain(&piece));
    expect_fault(TUFF_OK, tuff_check_terrain(&slot));
    expect_fault(TUFF_FAULT_NULL, tuff_check_terrain(NULL));
    piece.radius = -TUFF_REAL_RAW(1);
    expect_fault(TUFF_FAULT_RADIUS_RANGE, tuff_check_terrain(&piece));
    piece.radius = TUFF_WHOLE(TUFF_MAX_RADIUS + 1);
    expect_fault(TUFF_FAULT_RADIUS_RANGE, tuff_check_terrain(&piece));
    piece = good;
    piece.bounding_radius = 0;
    expect_fault(TUFF_FAULT_BOUNDING_RANGE, tuff_check_terrain(&piece));
    piece.bounding_radius = TUFF_WHOLE(TUFF_MAX_BOUNDING_RADIUS + 1);
    expect_fault(TUFF_FAULT_BOUNDING_RANGE, tuff_check_terrain(&piece));
    piece.bounding_radius = TUFF_WHOLE(3);
    expect_fault(TUFF_FAULT_BOUNDING_TOO_SMALL, tuff_check_terrain(&piece));
    piece.radius = 0;
    piece.bounding_radius = TUFF_RATIO(499, 100);
    expect_fault(TUFF_FAULT_BOUNDING_TOO_SMALL, tuff_check_terrain(&piece));
    piece = good;
    box.polygon.internal_edges = 2;
    expect_fault(TUFF_FAULT_INTERNAL_UNMATCHED, tuff_check_terrain(&piece));
    box.polygon.internal_edges = 0;
    box.polygon.count = 2;
    expect_fault(TUFF_FAULT_TOO_FEW_VERTICES, tuff_check_terrain(&piece));
}

static void name_faults_of_bodies(void)
{
    random_shape hull;
    tuff_material material = { TUFF_WHOLE(TUFF_MAX_RESTITUTION), TUFF_WHOLE(TUFF_MAX_FRICTION) };
    tuff_body body = { { 0, 0 }, { 0, 0 }, &material };
    make_box(&hull);
    expect_fault(TUFF_FAULT_NULL, tuff_check_body(NULL, TUFF_WHOLE(5), NULL));
    expect_fault(TUFF_OK, tuff_check_body(&body, TUFF_WHOLE(5), &hull.polygon));
    expect_fault(TUFF_FAULT_HULL_RADIUS, tuff_check_body(&body, TUFF_WHOLE(5) - TUFF_REAL_RAW(64), &hull.polygon));
    expect_fault(TUFF_FAULT_RADIUS_RANGE, tuff_check_body(&body, -TUFF_REAL_RAW(1), NULL));
    expect_fault(TUFF_FAULT_RADIUS_RANGE, tuff_check_body(&body, TUFF_WHOLE(TUFF_MAX_BOUNDING_RADIUS + 1), NULL));
    hull.polygon.count = 40;
    expect_fault(TUFF_FAULT_TOO_MANY_VERTICES, tuff_check_body(&body, TUFF_WHOLE(5), &hull.polygon));
    body.velocity.y = -TUFF_WHOLE(TUFF_MAX_SPEED) - TUFF_REAL_RAW(64);
    expect_fault(TUFF_FAULT_VELOCITY_RANGE, tuff_check_body(&body, TUFF_WHOLE(5), NULL));
    body.velocity.y = 0;
    material.restitution = TUFF_WHOLE(TUFF_MAX_RESTITUTION) + TUFF_REAL_RAW(1);
    expect_fault(TUFF_FAULT_RESTITUTION_RANGE, tuff_check_body(&body, TUFF_WHOLE(5), NULL));
    material.restitution = -TUFF_REAL_RAW(1);
    expect_fault(TUFF_FAULT_RESTITUTION_RANGE, tuff_check_body(&body, TUFF_WHOLE(5), NULL));
    material = (tuff_material){ 0, TUFF_WHOLE(TUFF_MAX_FRICTION) + TUFF_REAL_RAW(1) };
    expect_fault(TUFF_FAULT_FRICTION_RANGE, tuff_check_body(&body, TUFF_WHOLE(5), NULL));
}

#if TUFF_SCALAR == TUFF_FLOAT
static void name_faults_of_numbers(void)
{
    static const uint32_t bad[] = { 0x7F800000u, 0xFF800000u, 0x7FC00000u };
    for (int i = 0; i < 3; i++) {
        tuff_real nan = real_of_bits(bad[i]);
        random_shape box;
        make_box(&box);
        box.vertices[1].y = nan;
        expect_fault(TUFF_FAULT_NOT_FINITE, tuff_check_polygon(&box.polygon));
        tuff_terrain piece = { { nan, 0 }, 1, 1, NULL, 0 };
        expect_fault(TUFF_FAULT_NOT_FINITE, tuff_check_terrain(&piece));
        piece = (tuff_terrain){ { 0, 0 }, nan, 1, NULL, 0 };
        expect_fault(TUFF_FAULT_NOT_FINITE, tuff_check_terrain(&piece));
        tuff_material material = { nan, 0 };
        tuff_body body = { { 0, 0 }, { 0, 0 }, &material };
        expect_fault(TUFF_FAULT_NOT_FINITE, tuff_check_body(&body, 1, NULL));
        body = (tuff_body){ { 0, nan }, { 0, 0 }, NULL };
        expect_fault(TUFF_FAULT_NOT_FINITE, tuff_check_body(&body, 1, NULL));
        body = (tuff_body){ { 0, 0 }, { nan, 0 }, NULL };
        expect_fault(TUFF_FAULT_NOT_FINITE, tuff_check_body(&body, 1, NULL));
    }
    tuff_terrain piece = { { 32769, 0 }, 1, 1, NULL, 0 };
    tuff_body body = { { 0, -32769 }, { 0, 0 }, NULL };
    expect_fault(TUFF_FAULT_POSITION_RANGE, tuff_check_terrain(&piece));
    expect_fault(TUFF_FAULT_POSITION_RANGE, tuff_check_body(&body, 1, NULL));
}
#else
/* Every bit pattern is a number within the range of positions. */
static void name_faults_of_numbers(void)
{
    named[TUFF_FAULT_NOT_FINITE] = true;
    named[TUFF_FAULT_POSITION_RANGE] = true;
}
#endif

#define PIECES 3
typedef struct tiny_world {
    tuff_terrain     pieces[PIECES];
    uint16_t         buckets[4];
    tuff_chunk_entry entries[PIECES];
    tuff_chunks      chunks;
    tuff_world       world;
} tiny_world;

static void make_world(tiny_world *t)
{
    memset(t, 0, sizeof *t);
    t->chunks = (tuff_chunks){ t->buckets, t->entries, 4, PIECES, 4, 0, 0, false };
    t->world = (tuff_world){ t->pieces, PIECES, &t->chunks, NULL, 0, TUFF_ORDER_ITERATION };
    for (int i = 0; i < PIECES; i++) t->pieces[i] = (tuff_terrain){ { TUFF_WHOLE(3 * i), 0 }, TUFF_WHOLE(2), TUFF_WHOLE(2), NULL, 0 };
    assert_int_equal(tuff_world_index(&t->world), 0);
}

static void expect_world(tuff_fault wanted, const tiny_world *t, uint16_t wanted_piece)
{
    uint16_t piece = 777;
    expect_fault(wanted, tuff_check_world(&t->world, &piece));
    assert_int_equal(piece, wanted_piece);
    expect_fault(wanted, tuff_check_world(&t->world, NULL));
}

static void name_faults_of_worlds(void)
{
    tiny_world t;
    uint16_t piece = 0;
    static tuff_terrain many[TUFF_MAX_PIECES + 1];
    make_world(&t);
    expect_world(TUFF_OK, &t, 0);
    expect_fault(TUFF_FAULT_NULL, tuff_check_world(NULL, &piece));
    t.world.order = 2;
    expect_world(TUFF_FAULT_ORDER, &t, 0);
    make_world(&t);
    t.world.terrain = NULL;
    expect_world(TUFF_FAULT_NULL, &t, 0);
    make_world(&t);
    t.world.terrain = many;
    t.world.terrain_count = TUFF_MAX_PIECES + 1;
    expect_world(TUFF_FAULT_TERRAIN_COUNT, &t, 0);
    make_world(&t);
    t.world.nearby_capacity = 1;
    expect_world(TUFF_FAULT_NULL, &t, 0);
    make_world(&t);
    t.pieces[1].radius = -TUFF_WHOLE(1);
    expect_world(TUFF_FAULT_RADIUS_RANGE, &t, 1);
    memset(&t.world, 0, sizeof t.world);
    expect_world(TUFF_OK, &t, 0);
}

static void name_faults_of_indices(void)
{
    tiny_world t;
    make_world(&t);
    t.chunks.bucket_count = 3;
    expect_world(TUFF_FAULT_BUCKET_COUNT, &t, 0);
    t.chunks.bucket_count = 0;
    expect_world(TUFF_FAULT_BUCKET_COUNT, &t, 0);
    make_world(&t);
    t.chunks.pitch_log2 = TUFF_MAX_PITCH_LOG2 + 1;
    expect_world(TUFF_FAULT_PITCH, &t, 0);
    make_world(&t);
    t.chunks.entries = NULL;
    expect_world(TUFF_FAULT_NULL, &t, 0);
    make_world(&t);
    t.world.terrain_count = 2;
    expect_world(TUFF_FAULT_INDEX_STALE, &t, 2);
    make_world(&t);
    memset(&t.pieces[1], 0, sizeof t.pieces[1]);
    expect_world(TUFF_FAULT_INDEX_STALE, &t, 1);
    make_world(&t);
    assert_true(tuff_chunks_remove(&t.chunks, 2));
    expect_world(TUFF_FAULT_INDEX_MISSING, &t, 2);
    make_world(&t);
    t.pieces[2].position.x += TUFF_WHOLE(40);
    expect_world(TUFF_FAULT_INDEX_MOVED, &t, 2);
    make_world(&t);
    t.pieces[2].bounding_radius = TUFF_WHOLE(40);
    expect_world(TUFF_FAULT_INDEX_MOVED, &t, 2);
    make_world(&t);
    for (int i = 0; i < PIECES; i++) t.entries[i].next = (uint16_t)(i + 1);
    expect_world(TUFF_FAULT_INDEX_BROKEN, &t, 0);
}

static void test_the_checks_name_every_fault(void **state)
{
    (void)state;
    name_faults_of_counts();
    name_faults_of_vertices();
    name_faults_of_outlines();
    name_faults_of_normals();
    name_faults_of_pieces();
    name_faults_of_bodies();
    name_faults_of_numbers();
    name_faults_of_worlds();
    name_faults_of_indices();
    for (int fault = 0; fault < TUFF_FAULT_COUNT; fault++) {
        if (!named[fault]) fail_msg("no case for: %s", tuff_fault_text((tuff_fault)fault));
    }
}

static void test_every_fault_has_a_text_of_its_own(void **state)
{
    (void)state;
    for (int fault = 0; fault < TUFF_FAULT_COUNT; fault++) {
        const char *text = tuff_fault_text((tuff_fault)fault);
        assert_non_null(text);
        assert_true(strlen(text) > 0 && text[strlen(text) - 1] != '.');
        for (int other = 0; other < fault; other++) assert_string_not_equal(text, tuff_fault_text((tuff_fault)other));
    }
    assert_non_null(tuff_fault_text(TUFF_FAULT_COUNT));
    assert_non_null(tuff_fault_text((tuff_fault)0x7FFF));
}

/* ---- garbage: blocks of memory of exactly the size that a struct's own numbers give ---- */

#define MOST_BLOCKS 64
#define MOST_PIECES 12

typedef struct garbage {
    void            *blocks[MOST_BLOCKS];
    int              block_count;
    tuff_terrain    *pieces;
    tuff_chunks      chunks;
    tuff_world       world;
    tuff_polygon     hull;
    const tuff_polygon *hull_given;
    tuff_material    material;
    tuff_body        body;
    tuff_real        radius;
    uint16_t         touch_room;
} garbage;

static void *block(garbage *g, size_t size)
{
    void *made = malloc(size > 0 ? size : 1);
    assert_non_null(made);
    assert_true(g->block_count < MOST_BLOCKS);
    g->blocks[g->block_count++] = made;
    return made;
}

static void *block_of_words(random_source *source, garbage *g, size_t size)
{
    uint8_t *made = (uint8_t *)block(g, size);
    for (size_t i = 0; i < size; i++) made[i] = (uint8_t)random_bits(source);
    return made;
}

static void free_blocks(garbage *g)
{
    while (g->block_count > 0) free(g->blocks[--g->block_count]);
}

/* A good shape, some of its numbers, or all of them, overwritten. */
static tuff_polygon any_polygon(random_source *source, garbage *g)
{
    random_shape shape;
    uint32_t spoiled = random_chance(source, 50) ? 0 : random_below(source, 101);
    random_rock_shape(source, &shape, TUFF_MAX_VERTICES, random_magnitude(source, 0.001, 1000.0));
    tuff_polygon made = shape.polygon;
    if (random_chance(source, 20)) made.count = (uint8_t)random_below(source, random_chance(source, 50) ? 6 : 256);
    size_t count = made.count <= TUFF_MAX_VERTICES ? made.count : 0;
    tuff_vec2 *vertices = (tuff_vec2 *)block(g, count * sizeof *vertices);
    tuff_unit2 *normals = (tuff_unit2 *)block(g, count * sizeof *normals);
    for (size_t i = 0; i < count; i++) {
        vertices[i] = random_chance(source, spoiled) || i >= shape.polygon.count ? any_vec2(source) : shape.vertices[i];
        normals[i] = random_chance(source, spoiled) || i >= shape.polygon.count
                         ? (tuff_unit2){ unit_of_bits(any_bits(source)), unit_of_bits(any_bits(source)) } : shape.normals[i];
    }
    made.vertices = random_chance(source, 3) ? NULL : vertices;
    made.normals = random_chance(source, 10) ? NULL : normals;
    if (random_chance(source, 30)) made.internal_edges = random_bits(source);
    return made;
}

static tuff_terrain any_piece(random_source *source, garbage *g)
{
    tuff_terrain made = { random_point(source, 60.0), random_point_at(random_within(source, 0.0, 60.0), 0).x, TUFF_WHOLE(60), NULL, 0 };
    if (g->block_count < MOST_BLOCKS - 24 && random_chance(source, 70)) {
        made.part_count = (uint8_t)random_below(source, 4);
        tuff_polygon *parts = (tuff_polygon *)block(g, made.part_count * sizeof *parts);
        for (int i = 0; i < made.part_count; i++) parts[i] = any_polygon(source, g);
        made.parts = random_chance(source, 5) ? NULL : parts;
    }
    if (random_chance(source, 20)) made.position = any_vec2(source);
    if (random_chance(source, 20)) made.radius = any_real(source);
    if (random_chance(source, 30)) made.bounding_radius = any_real(source);
    return made;
}

/* An index, filled and then overwritten here and there, or never filled at all. */
static void any_index(random_source *source, garbage *g)
{
    uint16_t buckets = (uint16_t)(random_chance(source, 80) ? 1u << random_below(source, 7) : random_below(source, 70));
    uint16_t capacity = (uint16_t)random_below(source, MOST_PIECES + 6);
    uint16_t *bucket_words = (uint16_t *)block_of_words(source, g, buckets * sizeof *bucket_words);
    tuff_chunk_entry *entries = (tuff_chunk_entry *)block_of_words(source, g, capacity * sizeof *entries);
    g->chunks = (tuff_chunks){ bucket_words, entries, buckets, capacity, (uint16_t)random_between(source, 4, 8), 0, 0, false };
    if (random_chance(source, 80)) tuff_world_index(&g->world);
    for (uint32_t i = random_below(source, 6); i-- > 0 && capacity > 0 && random_chance(source, 50);) {
        entries[random_below(source, capacity)].next = (uint16_t)random_below(source, capacity + 3u);
    }
    if (random_chance(source, 10) && buckets > 0) bucket_words[random_below(source, buckets)] = (uint16_t)random_bits(source);
    if (random_chance(source, 10)) g->chunks.large = (uint16_t)random_bits(source);
    if (random_chance(source, 10)) g->chunks.reach = (uint16_t)random_below(source, TUFF_MAX_BOUNDING_RADIUS);
    if (random_chance(source, 10)) g->chunks.pitch_log2 = (uint16_t)random_between(source, 9, 65535);
    if (random_chance(source, 10)) g->chunks.used = !g->chunks.used;
    if (random_chance(source, 3)) g->chunks.buckets = NULL;
    if (random_chance(source, 3)) g->chunks.entries = NULL;
}

static void any_body(random_source *source, garbage *g)
{
    g->body = (tuff_body){ random_point(source, 70.0), random_point(source, 50.0), NULL };
    if (random_chance(source, 10)) g->body.position = any_vec2(source);
    if (random_chance(source, 20)) g->body.velocity = any_vec2(source);
    if (random_chance(source, 50)) g->body.material = &g->material;
    g->material = (tuff_material){ any_real(source), any_real(source) };
    g->radius = random_chance(source, 20) ? any_real(source) : random_point_at(random_within(source, 0.0, 60.0), 0).x;
    g->hull = any_polygon(source, g);
    g->hull_given = random_chance(source, 60) ? &g->hull : NULL;
    g->touch_room = (uint16_t)random_below(source, 5);
}

static void make_garbage(random_source *source, garbage *g)
{
    memset(g, 0, sizeof *g);
    uint16_t count = (uint16_t)random_below(source, MOST_PIECES + 1), room = (uint16_t)random_below(source, 4);
    g->pieces = (tuff_terrain *)block(g, count * sizeof *g->pieces);
    any_body(source, g);
    for (int i = 0; i < count; i++) g->pieces[i] = any_piece(source, g);
    uint16_t *nearby = (uint16_t *)block(g, room * sizeof *nearby);
    g->world = (tuff_world){ g->pieces, count, &g->chunks, nearby, room, (uint8_t)random_below(source, 3) };
    any_index(source, g);
    if (random_chance(source, 3)) g->world.terrain = NULL;
    if (random_chance(source, 3)) g->world.nearby = NULL;
    if (random_chance(source, 20)) g->world.chunks = NULL;
}

/* ---- what no call may do ---- */

/* The fixed build pushes bodies at any speed. */
static bool legal_body(const tuff_body *body)
{
    int32_t fastest = TUFF_SCALAR == TUFF_FLOAT ? TUFF_MAX_SPEED : TUFF_MAX_POSITION;
    return vec2_within(body->position, TUFF_MAX_POSITION) && vec2_within(body->velocity, fastest);
}

static bool same_bits(const tuff_body *a, const tuff_body *b)
{
    return memcmp(&a->position, &b->position, sizeof a->position) == 0 && memcmp(&a->velocity, &b->velocity, sizeof a->velocity) == 0 &&
           a->material == b->material;
}

/* Unpushed: unchanged. Pushed: it was legal before, and is in range now, no faster than it may be. */
static bool body_right(const tuff_body *before, const tuff_body *after, uint16_t pushes)
{
    int32_t fastest = vec2_within(before->velocity, TUFF_MAX_SPEED) ? TUFF_MAX_SPEED : TUFF_MAX_POSITION;
    if (pushes == 0) return same_bits(before, after);
    return pushes <= TUFF_MAX_PUSHES && legal_body(before) && vec2_within(after->position, TUFF_MAX_POSITION) &&
           vec2_within(after->velocity, fastest) && before->material == after->material;
}

static const char *collide_fault(const garbage *g)
{
    tuff_touch *list = (tuff_touch *)malloc(g->touch_room * sizeof *list + 1);
    tuff_touches touches = { list, g->touch_room, 999 };
    const tuff_world *w = &g->world;
    tuff_body body[6] = { g->body, g->body, g->body, g->body, g->body, g->body };
    uint16_t floaters = w->terrain ? w->terrain_count : (uint16_t)5;
    const uint16_t pushes[6] = {
        tuff_terrain_collide(w, &body[0], g->radius, g->hull_given),
        tuff_terrain_collide_circle(w, &body[1], g->radius),
        tuff_terrain_collide_report(w, &body[2], g->radius, g->hull_given, &touches),
        tuff_floater_collide(&body[3], g->radius, w->terrain, floaters, g->hull_given),
        tuff_floater_collide_circle(&body[4], g->radius, w->terrain, floaters),
        tuff_floater_collide_report(&body[5], g->radius, w->terrain, floaters, g->hull_given, 1, NULL) };
    bool report_right = touches.count == pushes[2];
    free(list);
    for (int i = 0; i < 6; i++) {
        if (!body_right(&g->body, &body[i], pushes[i])) return "a body was changed wrongly";
    }
    return report_right ? NULL : "the report's count is wrong";
}

static const char *query_fault(random_source *source, garbage *g)
{
    tuff_vec2 a = random_chance(source, 50) ? any_vec2(source) : random_point(source, 80.0);
    tuff_vec2 b = random_chance(source, 50) ? any_vec2(source) : random_point(source, 80.0);
    tuff_beam_hit hit = { 0, { 0, 0 }, 0 };
    tuff_segment_terrain_intersect(&g->world, a, b);
    if (tuff_segment_terrain_first_hit(&g->world, a, b, &hit)) {
        if (hit.piece >= g->world.terrain_count) return "a beam hit no piece";
        if (!(exact_unit(hit.fraction) >= 0 && exact_unit(hit.fraction) <= 1)) return "a beam's fraction is none";
    }
    (void)tuff_nearby_terrain(&g->world, a, g->radius);
    g->world.chunks = random_chance(source, 50) ? &g->chunks : NULL;
    return NULL;
}

/* An overlap above zero, or nothing. */
static bool contact_right(bool overlapping, const tuff_contact *contact)
{
    return overlapping ? contact->overlap > 0 : contact->overlap == 0 && contact->normal.x == 0 && contact->normal.y == 0;
}

static const char *narrow_fault(random_source *source, const garbage *g)
{
    tuff_vec2 at = random_chance(source, 50) ? any_vec2(source) : random_point(source, 80.0);
    tuff_vec2 other = any_vec2(source);
    tuff_contact c[5];
    memset(c, 0, sizeof c);
    bool right = contact_right(tuff_circle_circle(at, g->radius, any_real(source), &c[0]), &c[0]);
    tuff_segment_circle(at, other, g->radius);
    for (int i = 0; i < g->world.terrain_count && right; i++) {
        const tuff_terrain *piece = &g->pieces[i];
        memset(c, 0, sizeof c);
        right = contact_right(tuff_terrain_overlap_circle(piece, at, g->radius, &c[1]), &c[1]) &&
                contact_right(tuff_terrain_overlap_hull(piece, at, g->radius, g->hull_given, &c[2]), &c[2]);
        for (int k = 0; piece->parts && k < piece->part_count && right; k++) {
            c[3] = c[4] = (tuff_contact){ 0, { 0, 0 } };
            right = contact_right(tuff_circle_polygon(at, g->radius, &piece->parts[k], &c[3]), &c[3]) &&
                    contact_right(tuff_polygon_polygon(g->hull_given, at, &piece->parts[k], &c[4]), &c[4]);
            tuff_segment_polygon(at, other, &piece->parts[k]);
            tuff_check_polygon(&piece->parts[k]);
        }
        tuff_check_terrain(piece);
    }
    tuff_check_body(&g->body, g->radius, g->hull_given);
    tuff_check_world(&g->world, NULL);
    return right ? NULL : "a contact is none, or was touched";
}

static const char *bounce_fault(random_source *source, const garbage *g)
{
    tuff_body body = g->body;
    tuff_contact contact = { any_real(source), { unit_of_bits(any_bits(source)), unit_of_bits(any_bits(source)) } };
    tuff_bounce(&body, &contact);
    tuff_bounce(NULL, &contact);
    tuff_bounce(&body, NULL);
    return same_bits(&g->body, &body) || body_right(&g->body, &body, 1) ? NULL : "a bounce left the range";
}

/* Calls of a frame leave the world's memory alone; edits only the index's. */
static const char *world_fault(random_source *source, garbage *g)
{
    size_t size = g->world.terrain_count * sizeof *g->pieces;
    tuff_terrain *before = (tuff_terrain *)malloc(size + 1);
    tuff_chunks chunks = g->chunks;
    memcpy(before, g->pieces, size);
    const char *fault = collide_fault(g);
    if (!fault) fault = query_fault(source, g);
    if (!fault) fault = narrow_fault(source, g);
    if (!fault) fault = bounce_fault(source, g);
    if (!fault && memcmp(before, g->pieces, size) != 0) fault = "the terrain was changed";
    if (!fault && memcmp(&chunks, &g->chunks, sizeof chunks) != 0) fault = "the index was changed";
    free(before);
    return fault;
}

static void edit_index(random_source *source, garbage *g)
{
    for (int i = 0; i < 6; i++) {
        uint16_t piece = (uint16_t)(random_chance(source, 90) ? random_below(source, MOST_PIECES + 6) : random_bits(source));
        if (random_chance(source, 50)) tuff_chunks_remove(&g->chunks, piece);
        else tuff_chunks_insert(&g->chunks, piece, any_vec2(source), any_real(source));
    }
}

/* A case that hangs ends the program, with the command that repeats it. */
static random_run watched;
static volatile uint32_t watched_case;

static void on_alarm(int signal_number)
{
    (void)signal_number;
    random_print_case(&watched, watched_case);
    print_error("a call does not end\n");
    _exit(1);
}

static void test_calls_survive_garbage(void **state)
{
    random_run run = random_cases(__func__, 72, 60000);
    (void)state;
    watched = run;
    signal(SIGALRM, on_alarm);
    for (uint32_t i = run.first; i < run.end; i++) {
        static garbage g;
        random_source source = random_stream(run.seed, i);
        watched_case = i;
        alarm(30);
        make_garbage(&source, &g);
        const char *fault = world_fault(&source, &g);
        edit_index(&source, &g);
        if (!fault) fault = world_fault(&source, &g);
        free_blocks(&g);
        if (fault) random_fail(&run, i, "%s", fault);
    }
    alarm(0);
    print_message("figures: " EXACT_BUILD " bad input: %lu worlds of garbage survived\n", (unsigned long)(run.end - run.first));
}

static void test_nothing_given_does_nothing(void **state)
{
    tuff_body body = { { TUFF_WHOLE(1), 0 }, { TUFF_WHOLE(2), 0 }, NULL }, before = body;
    tuff_world empty;
    tuff_touches touches = { NULL, 0, 5 };
    tuff_contact contact = { 0, { 0, 0 } };
    (void)state;
    memset(&empty, 0, sizeof empty);
    assert_int_equal(tuff_terrain_collide(NULL, &body, TUFF_WHOLE(1), NULL), 0);
    assert_int_equal(tuff_terrain_collide(&empty, &body, TUFF_WHOLE(1), NULL), 0);
    assert_int_equal(tuff_terrain_collide_circle(&empty, NULL, TUFF_WHOLE(1)), 0);
    assert_int_equal(tuff_terrain_collide_report(&empty, &body, TUFF_WHOLE(1), NULL, &touches), 0);
    assert_int_equal(touches.count, 0);
    touches.count = 5;
    assert_int_equal(tuff_terrain_collide_report(&empty, &body, -TUFF_WHOLE(1), NULL, &touches), 0);
    assert_int_equal(touches.count, 0);
    assert_int_equal(tuff_floater_collide(&body, TUFF_WHOLE(1), NULL, 3, NULL), 0);
    assert_int_equal(tuff_floater_collide_circle(NULL, TUFF_WHOLE(1), NULL, 3), 0);
    assert_int_equal(tuff_nearby_terrain(NULL, body.position, 0), 0);
    assert_int_equal(tuff_nearby_terrain(&empty, body.position, 0), 0);
    assert_int_equal(tuff_world_index(NULL), 0);
    assert_false(tuff_circle_polygon(body.position, TUFF_WHOLE(1), NULL, &contact));
    assert_false(tuff_polygon_polygon(NULL, body.position, NULL, &contact));
    assert_false(tuff_segment_polygon(body.position, body.position, NULL));
    assert_false(tuff_terrain_overlap_circle(NULL, body.position, TUFF_WHOLE(1), &contact));
    assert_false(tuff_terrain_overlap_hull(NULL, body.position, TUFF_WHOLE(1), NULL, &contact));
    assert_true(same_bits(&before, &body));
}

static void test_bad_radii_touch_nothing(void **state)
{
    tuff_terrain ball = { { 0, 0 }, TUFF_WHOLE(5), TUFF_WHOLE(5), NULL, 0 };
    const tuff_real radii[3] = { -TUFF_REAL_RAW(1), -TUFF_WHOLE(1000), TUFF_WHOLE(TUFF_MAX_BOUNDING_RADIUS) + TUFF_REAL_RAW(64) };
    (void)state;
    for (int i = 0; i < 3; i++) {
        tuff_body body = { { TUFF_WHOLE(1), 0 }, { 0, 0 }, NULL }, before = body;
        tuff_contact contact;
        assert_int_equal(tuff_floater_collide(&body, radii[i], &ball, 1, NULL), 0);
        assert_false(tuff_circle_circle(body.position, radii[i], TUFF_WHOLE(5), &contact));
        assert_false(tuff_circle_circle(body.position, TUFF_WHOLE(5), radii[i], &contact));
        assert_true(same_bits(&before, &body));
    }
}

#if TUFF_SCALAR == TUFF_FLOAT
/* ---- no number, and numbers too large ---- */

static void test_a_body_without_numbers_is_left_alone(void **state)
{
    /* The last one is the next after 32768. */
    static const uint32_t bad[] = { 0x7F800000u, 0xFF800000u, 0x7FC00000u, 0xFFC00001u, 0x7F7FFFFFu, 0x47000001u };
    tuff_terrain ball = { { 0, 0 }, 5, 5, NULL, 0 };
    tuff_world world = { &ball, 1, NULL, NULL, 0, 0 };
    (void)state;
    for (uint32_t i = 0; i < 24 * 2; i++) {
        float numbers[4] = { 1, 1, 1, 1 };
        tuff_beam_hit hit;
        numbers[i % 4] = real_of_bits(bad[i / 4 % 6]);
        world.order = (uint8_t)(i / 24);
        tuff_body body = { { numbers[0], numbers[1] }, { numbers[2], numbers[3] }, NULL }, before = body;
        assert_int_equal(tuff_terrain_collide(&world, &body, 3, NULL), 0);
        assert_true(same_bits(&before, &body));
        if (i % 4 >= 2) continue;
        assert_false(tuff_segment_terrain_intersect(&world, body.position, (tuff_vec2){ 0, 0 }));
        assert_false(tuff_segment_terrain_first_hit(&world, (tuff_vec2){ 0, 0 }, body.position, &hit));
        assert_int_equal(tuff_nearby_terrain(&world, body.position, 3), 0);
    }
}

/* ---- floating-point exceptions ---- */

static sigjmp_buf trapped;

static void on_exception(int signal_number)
{
    (void)signal_number;
    siglongjmp(trapped, 1);
}

/* Legal, and of any size: down to the smallest normal number, in bodies to the smallest of all. */
static float small_number(random_source *source, float most, bool denormals)
{
    float value = (float)random_within(source, -1.0, 1.0) * most;
    uint32_t kind = random_below(source, 10), sign = random_chance(source, 50) ? 0x80000000u : 0;
    if (kind == 0) value = 0.0f;
    else if (kind <= 3) value = (float)(random_magnitude(source, 1.2e-38, 1.0) * (random_chance(source, 50) ? 1 : -1));
    else if (kind == 4) value = most * (random_chance(source, 50) ? 1 : -1);
    else if (kind == 5 && denormals) value = real_of_bits(random_below(source, 0x00800000u) | sign);
    return value;
}

static tuff_vec2 small_vec2(random_source *source, float most, bool denormals)
{
    float x = small_number(source, most, denormals);
    return (tuff_vec2){ x, small_number(source, most, denormals) };
}

typedef struct small_scene {
    random_shape  shapes[3];
    random_shape  hull;
    tuff_terrain  pieces[4];
    tuff_material material;
    tuff_body     body;
    float         radius;
    tuff_vec2     a, b;
} small_scene;

static void make_small_shape(random_source *source, random_shape *shape)
{
    random_rock_shape(source, shape, 8, random_magnitude(source, 1e-30, 700.0));
    if (tuff_check_polygon(&shape->polygon) == TUFF_OK) return;
    make_box(shape);
}

static void make_small_scene(random_source *source, small_scene *s)
{
    for (int i = 0; i < 3; i++) {
        make_small_shape(source, &s->shapes[i]);
        tuff_real cover = s->shapes[i].bounding_radius;
        s->pieces[i] = (tuff_terrain){ small_vec2(source, 30, false), cover, cover, &s->shapes[i].polygon, 1 };
    }
    float radius = fabsf(small_number(source, 50, false)) + 1.2e-38f;
    s->pieces[3] = (tuff_terrain){ small_vec2(source, 30, false), radius, radius, NULL, 0 };
    make_small_shape(source, &s->hull);
    if (random_chance(source, 50)) s->hull.polygon.normals = NULL;
    s->material = (tuff_material){ fabsf(small_number(source, 4, true)), fabsf(small_number(source, 1, true)) };
    s->body = (tuff_body){ small_vec2(source, 30, true), small_vec2(source, 1024, true), random_chance(source, 70) ? &s->material : NULL };
    if (random_chance(source, 10)) s->body.position = s->pieces[random_below(source, 4)].position;
    s->radius = random_chance(source, 50) ? s->hull.bounding_radius : fabsf(small_number(source, 50, true));
    s->a = small_vec2(source, 100, true);
    s->b = random_chance(source, 80) ? small_vec2(source, 100, true) : s->a;
}

static void run_small_scene(small_scene *s)
{
    uint16_t buckets[4], nearby[4];
    tuff_chunk_entry entries[4];
    tuff_chunks chunks = TUFF_CHUNKS(buckets, entries, 5);
    tuff_world world = { s->pieces, 4, &chunks, nearby, 4, TUFF_ORDER_ITERATION };
    tuff_beam_hit hit;
    tuff_unit2 normals[TUFF_MAX_VERTICES];
    (void)tuff_world_index(&world);
    for (int i = 0; i < 4; i++) {
        tuff_body body = s->body;
        world.order = (uint8_t)(i & 1);
        (void)tuff_terrain_collide(&world, &body, s->radius, i & 2 ? &s->hull.polygon : NULL);
        (void)tuff_terrain_collide(&world, &body, s->radius, i & 2 ? &s->hull.polygon : NULL);
    }
    (void)tuff_nearby_terrain(&world, s->body.position, s->radius);
    (void)tuff_segment_terrain_intersect(&world, s->a, s->b);
    (void)tuff_segment_terrain_first_hit(&world, s->a, s->b, &hit);
    tuff_edge_normals(s->hull.vertices, s->hull.polygon.count, normals);
}

static void test_legal_numbers_raise_no_exception(void **state)
{
    random_run run = random_cases(__func__, 73, 60000);
    const int exceptions = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW;
    static small_scene s;
    volatile uint32_t i;
    (void)state;
    void (*old)(int) = signal(SIGFPE, on_exception);
    for (i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        make_small_scene(&source, &s);
        feclearexcept(FE_ALL_EXCEPT);
        if (sigsetjmp(trapped, 1)) {
            fedisableexcept(exceptions);
            random_fail(&run, i, "a floating-point exception");
        }
        feenableexcept(exceptions);
        run_small_scene(&s);
        fedisableexcept(exceptions);
    }
    signal(SIGFPE, old);
    print_message("figures: " EXACT_BUILD " bad input: %lu scenes of small numbers without a floating-point exception\n",
                  (unsigned long)(run.end - run.first));
}
#endif

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_checks_name_every_fault),
        cmocka_unit_test(test_every_fault_has_a_text_of_its_own),
        cmocka_unit_test(test_calls_survive_garbage),
        cmocka_unit_test(test_nothing_given_does_nothing),
        cmocka_unit_test(test_bad_radii_touch_nothing),
#if TUFF_SCALAR == TUFF_FLOAT
        cmocka_unit_test(test_a_body_without_numbers_is_left_alone),
        cmocka_unit_test(test_legal_numbers_raise_no_exception),
#endif
    };
    (void)argc;
    random_begin(argv);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
