/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The frame call behind all collide calls: orders, re-tests, the limit of pushes, reports. DESIGN 2 ("Resolution free of insertion order",
   "Which piece, where, how", concave re-tests), DESIGN 4 (hull normals at most once, never loses a piece). */
#include "shapes.h"

#include "inner.h"

#define PIECES 8

DEFINE_BOX(box, -10, -10, 10, 10);
static const tuff_material dead = { 0, 0 };

DEFINE_TERRAIN(PIECES, 8, 6);
static tuff_world world;
static tuff_touch list[4];
static tuff_touches touches;

void setUp(void)
{
    empty_world(&world, terrain, PIECES, &chunks);
    world.chunks = NULL;
    world.order = TUFF_ORDER_ITERATION;
    touches.list = list;
    touches.capacity = 4;
    touches.count = 77;
}

void tearDown(void) {}

static void place(uint8_t piece, int16_t x, int16_t y, const tuff_polygon *part)
{
    terrain[piece] = piece_of(whole(x, y), W(5), part, part != NULL ? 1 : 0);
}

static tuff_body body_at(tuff_real x, tuff_real y)
{
    return body_of(vec(x, y), vec(0, 0), &dead);
}

static uint16_t collide(tuff_body *body, tuff_real radius)
{
    return tuff_terrain_collide_report(&world, body, radius, NULL, &touches);
}

static void test_a_touched_piece_pushes_bounces_and_is_reported(void)
{
    tuff_body body = body_at(W(13), W(2));
    body.velocity = whole(-6, 3);
    place(3, 0, 0, &box);
    TEST_ASSERT_EQUAL_INT(1, collide(&body, W(5)));
    ASSERT_VEC_SAME(W(15), W(2), body.position);
    ASSERT_VEC_SAME(0, W(3), body.velocity);
    TEST_ASSERT_EQUAL_INT(1, touches.count);
    TEST_ASSERT_EQUAL_INT(3, list[0].piece);
    ASSERT_CONTACT(W(2), ONE, 0, list[0].contact);
}

static void test_nothing_touched_is_zero_and_an_empty_report(void)
{
    tuff_body body = body_at(W(15), W(2));
    place(3, 0, 0, &box);
    TEST_ASSERT_EQUAL_INT(0, collide(&body, W(5)));
    TEST_ASSERT_EQUAL_INT(0, touches.count);
    ASSERT_VEC_SAME(W(15), W(2), body.position);
}

/* A box below and a box to the right: a circle of 6 at (0, -1) is 2 deep in each. */
static void place_step(void)
{
    place(1, 0, 13, &box);
    place(4, 14, -8, &box);
}

static void test_iteration_order_takes_each_piece_by_number(void)
{
    tuff_body body = body_at(W(0), W(-1));
    place_step();
    TEST_ASSERT_EQUAL_INT(2, collide(&body, W(6)));
    TEST_ASSERT_EQUAL_INT(1, list[0].piece);
    TEST_ASSERT_EQUAL_INT(4, list[1].piece);
    ASSERT_VEC_SAME(W(-2), W(-3), body.position);
}

static void test_iteration_order_follows_the_chunks(void)
{
    place(0, 9, 9, &box);
    place(1, -9, 9, &box);
    place(2, 9, -9, &box);
    place(3, -9, -9, &box);
    world.chunks = &chunks;
    touches.capacity = 1;
    for (uint8_t fine = 0; fine < 2; fine++) {   /* with a pitch of 8 units there are more chunks about than pieces */
        tuff_body body = body_at(W(0), W(0));
        chunks.pitch_log2 = fine ? 3 : 6;
        TEST_ASSERT_EQUAL_INT(0, tuff_world_index(&world));
        TEST_ASSERT_TRUE(collide(&body, W(3)) >= 1);
        TEST_ASSERT_EQUAL_INT(3, list[0].piece);
    }
    chunks.pitch_log2 = 6;
}

static void test_deepest_first_takes_the_deepest(void)
{
    tuff_body body = body_at(W(0), W(-1));
    place(1, -2, 13, &box);   /* 2 deep in a circle of 6 */
    place(4, 3, 11, &box);    /* 4 deep: after it the other is clear */
    world.order = TUFF_ORDER_DEEPEST;
    TEST_ASSERT_EQUAL_INT(1, collide(&body, W(6)));
    TEST_ASSERT_EQUAL_INT(4, list[0].piece);
    ASSERT_VEC_SAME(0, W(-5), body.position);
}

static void test_deepest_first_ties_go_to_the_lowest_number(void)
{
    for (uint8_t turn = 0; turn < 2; turn++) {
        tuff_body body = body_at(W(0), W(-1));
        setUp();
        world.order = TUFF_ORDER_DEEPEST;
        world.chunks = &chunks;
        place(turn ? 5 : 2, -4, 12, &box);
        place(turn ? 2 : 5, 4, 12, &box);
        TEST_ASSERT_TRUE(tuff_chunks_insert(&chunks, 5, terrain[5].position, W(15)));
        TEST_ASSERT_TRUE(tuff_chunks_insert(&chunks, 2, terrain[2].position, W(15)));
        TEST_ASSERT_EQUAL_INT(1, collide(&body, W(6)));
        TEST_ASSERT_EQUAL_INT(2, list[0].piece);
        ASSERT_VEC_SAME(0, W(-4), body.position);
    }
}

static void test_deepest_first_does_not_depend_on_the_order_of_insertion(void)
{
    tuff_vec2 first = vec(0, 0);
    world.order = TUFF_ORDER_DEEPEST;
    world.chunks = &chunks;
    for (uint8_t i = 0; i < PIECES; i++) place(i, (int16_t)(i * 7 % 20 - 10), (int16_t)(i * 11 % 23 + 2), i % 2 ? &box : NULL);
    for (uint8_t turn = 0; turn < PIECES; turn++) {
        tuff_body body = body_at(W(1), W(-3));
        tuff_chunks_clear(&chunks);
        for (uint8_t i = 0; i < PIECES; i++) {
            uint8_t piece = (uint8_t)((i * 3 + turn) % PIECES);
            TEST_ASSERT_TRUE(tuff_chunks_insert(&chunks, piece, terrain[piece].position, terrain[piece].bounding_radius));
        }
        TEST_ASSERT_TRUE(collide(&body, W(6)) > 0);
        if (turn == 0) first = body.position;
        ASSERT_VEC_SAME(first.x, first.y, body.position);
    }
}

/* A floor of separate flush boxes: a circle that sinks in beside a seam goes straight up. */
static void test_deepest_first_does_not_snag_on_flush_pieces(void)
{
    place(0, -10, 10, &box);
    place(1, 10, 10, &box);
    world.order = TUFF_ORDER_DEEPEST;
    for (int8_t x = -8; x <= 8; x++) {
        tuff_body body = body_at(tuff_from_int(x) / 2, W(-4));
        body.velocity = whole(7, 3);
        TEST_ASSERT_EQUAL_INT(1, collide(&body, W(5)));
        ASSERT_VEC_SAME(tuff_from_int(x) / 2, W(-5), body.position);
        ASSERT_VEC_SAME(W(7), 0, body.velocity);
    }
}

/* A corridor too narrow for the body: it is pushed to and fro, but not for ever. */
static void place_corridor(void)
{
    place(0, -13, 0, &box);
    place(1, 13, 0, &box);
}

static void test_no_more_than_the_limit_of_pushes_deepest_first(void)
{
    tuff_body body = body_at(W(1), 0);
    place_corridor();
    world.order = TUFF_ORDER_DEEPEST;
    TEST_ASSERT_EQUAL_INT(TUFF_MAX_PUSHES, collide(&body, W(5)));
    TEST_ASSERT_EQUAL_INT(TUFF_MAX_PUSHES, touches.count);
}

static void test_in_iteration_order_separate_pieces_push_once_each(void)
{
    tuff_body body = body_at(W(1), 0);
    place_corridor();
    TEST_ASSERT_EQUAL_INT(2, collide(&body, W(5)));
    ASSERT_VEC_SAME(W(-2), 0, body.position);
}

static void test_no_more_than_the_limit_of_pushes_within_one_piece(void)
{
    DEFINE_PAIR_OF_BOXES(parts, 3, 23, box_normals, 0, 0);
    tuff_body body = body_at(W(1), 0);
    place(0, 0, 0, parts);
    terrain[0].bounding_radius = W(30);
    terrain[0].part_count = 2;
    TEST_ASSERT_EQUAL_INT(TUFF_MAX_PUSHES, collide(&body, W(5)));
}

/* The notch of an L: up, then right, in one call and either order. */
static void test_a_piece_of_parts_is_tested_again_after_each_push(void)
{
    static const tuff_vec2 corner[4] = BOX_VERTICES(0, 0, 10, 10);
    static const tuff_vec2 foot[4] = BOX_VERTICES(10, 0, 40, 10);
    static const tuff_vec2 leg[4] = BOX_VERTICES(0, 10, 10, 40);
    static const tuff_polygon parts[3] = { { corner, box_normals, 6, 4 }, { foot, box_normals, 8, 4 }, { leg, box_normals, 1, 4 } };
    for (uint8_t order = TUFF_ORDER_ITERATION; order <= TUFF_ORDER_DEEPEST; order++) {
        tuff_body body = body_at(W(12), W(11));
        place(0, 0, 0, parts);
        terrain[0].bounding_radius = W(60);
        terrain[0].part_count = 3;
        world.order = order;
        TEST_ASSERT_EQUAL_INT(2, collide(&body, W(5)));
        ASSERT_VEC(W(15), W(15), body.position);
        ASSERT_CONTACT(W(4), 0, ONE, list[0].contact);
        ASSERT_CONTACT(W(3), ONE, 0, list[1].contact);
    }
}

static void test_the_reported_contacts_add_up_to_the_movement(void)
{
    tuff_body body = body_at(W(1), W(-3));
    tuff_body again = body;
    place(0, -8, 9, &box);
    place(1, 9, 4, NULL);
    place(2, 2, 12, &box);
    world.order = TUFF_ORDER_DEEPEST;
    uint16_t pushes = collide(&body, W(6));
    TEST_ASSERT_TRUE(pushes > 0 && pushes <= 4);
    for (uint16_t i = 0; i < pushes; i++) tuff_bounce(&again, &list[i].contact);
    ASSERT_VEC_SAME(body.position.x, body.position.y, again.position);
}

static void test_a_short_report_counts_on_and_keeps_what_fits(void)
{
    tuff_body body = body_at(W(1), 0);
    place_corridor();
    world.order = TUFF_ORDER_DEEPEST;
    touches.capacity = 2;
    list[2].piece = 999;
    TEST_ASSERT_EQUAL_INT(TUFF_MAX_PUSHES, collide(&body, W(5)));
    TEST_ASSERT_EQUAL_INT(TUFF_MAX_PUSHES, touches.count);
    TEST_ASSERT_EQUAL_INT(1, list[0].piece);
    TEST_ASSERT_EQUAL_INT(0, list[1].piece);
    TEST_ASSERT_EQUAL_INT(999, list[2].piece);
}

static void test_a_report_without_a_list_only_counts(void)
{
    tuff_body body = body_at(W(13), W(2));
    place(3, 0, 0, &box);
    touches.capacity = 0;
    TEST_ASSERT_EQUAL_INT(1, collide(&body, W(5)));
    TEST_ASSERT_EQUAL_INT(1, touches.count);
    body = body_at(W(13), W(2));
    touches.list = NULL;
    touches.capacity = 4;
    TEST_ASSERT_EQUAL_INT(1, collide(&body, W(5)));
    TEST_ASSERT_EQUAL_INT(1, touches.count);
    body = body_at(W(13), W(2));
    TEST_ASSERT_EQUAL_INT(1, tuff_terrain_collide_report(&world, &body, W(5), NULL, NULL));
}

static void test_the_nearby_buffer_plays_no_part(void)
{
    static uint16_t one_slot[1];
    place_step();
    for (uint8_t capacity = 0; capacity < 2; capacity++) {
        tuff_body body = body_at(W(0), W(-1));
        world.nearby = capacity ? one_slot : NULL;
        world.nearby_capacity = capacity;
        one_slot[0] = 999;
        TEST_ASSERT_EQUAL_INT(2, collide(&body, W(6)));
        TEST_ASSERT_EQUAL_INT(999, one_slot[0]);
    }
    world.nearby = NULL;
    world.nearby_capacity = 0;
}

static void test_stale_entries_and_empty_slots_are_skipped_and_the_index_is_not_touched(void)
{
    tuff_chunk_entry before[PIECES];
    tuff_body body = body_at(W(0), W(-1));
    place_step();
    world.chunks = &chunks;
    tuff_world_index(&world);
    for (uint8_t i = 0; i < PIECES; i++) before[i] = entries[i];
    world.terrain_count = 4;
    TEST_ASSERT_EQUAL_INT(1, collide(&body, W(6)));
    TEST_ASSERT_EQUAL_INT(1, list[0].piece);
    body = body_at(W(0), W(-1));
    terrain[1].bounding_radius = 0;
    TEST_ASSERT_EQUAL_INT(0, collide(&body, W(6)));
    TEST_ASSERT_EQUAL_MEMORY(before, entries, sizeof entries);
}

static void test_bad_worlds_and_bodies_are_left_alone(void)
{
    static const tuff_world zero;
    tuff_body body = body_at(W(13), W(2));
    place(3, 0, 0, &box);
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide_report(NULL, &body, W(5), NULL, &touches));
    TEST_ASSERT_EQUAL_INT(0, touches.count);
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide_report(&zero, &body, W(5), NULL, &touches));
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide_report(&world, NULL, W(5), NULL, &touches));
    touches.count = 77;
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide_report(&world, &body, W(-5), NULL, &touches));
    TEST_ASSERT_EQUAL_INT(0, touches.count);
    world.terrain = NULL;
    TEST_ASSERT_EQUAL_INT(0, collide(&body, W(5)));
    world.terrain = terrain;
    world.terrain_count = 0;
    TEST_ASSERT_EQUAL_INT(0, collide(&body, W(5)));
    ASSERT_VEC_SAME(W(13), W(2), body.position);
}

static void test_hull_normals_are_made_once_and_only_when_needed(void)
{
    tuff_unit2 scratch[4] = { { 0, 0 }, { 0, 0 }, { 0, 0 }, { 0, 0 } };
    tuff_polygon hull = box;
    tuff_collision call;
    tuff_mover mover;
    tuff_body body = body_at(W(40), 0);
    hull.normals = NULL;
    call.shape = &mover.shape;
    place(0, 0, 0, &box);
    TEST_ASSERT_TRUE(tuff_hull_mover(&mover, W(15), &hull, scratch));
    tuff_collide(&call, &world, &body, NULL);
    TEST_ASSERT_EQUAL_INT(0, call.pushes);
    ASSERT_VEC_SAME(0, 0, scratch[1]);
    body = body_at(W(18), 0);
    tuff_collide(&call, &world, &body, NULL);
    TEST_ASSERT_EQUAL_INT(1, call.pushes);
    ASSERT_VEC_SAME(ONE, 0, scratch[1]);
    scratch[0].x = TUFF_UNIT_RATIO(1, 64);
    body = body_at(W(18), 0);
    tuff_collide(&call, &world, &body, NULL);
    TEST_ASSERT_EQUAL_INT(1, call.pushes);
    ASSERT_SAME(TUFF_UNIT_RATIO(1, 64), scratch[0].x);
}

static void test_a_body_that_is_not_a_number_is_left_alone(void)
{
    place(3, 0, 0, &box);
    for (uint8_t i = 0; i < 8; i++) {
        tuff_body body = body_at(W(13), W(2));
        tuff_real bad = i & 4 ? NOT_A_NUMBER : INFINITE;
        if (i % 4 == 0) body.position.x = bad;
        if (i % 4 == 1) body.position.y = bad;
        if (i % 4 == 2) body.velocity.x = bad;
        if (i % 4 == 3) body.velocity.y = bad;
        tuff_body before = body;
        TEST_ASSERT_EQUAL_INT(0, collide(&body, W(5)));
        TEST_ASSERT_EQUAL_MEMORY(&before, &body, sizeof body);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_touched_piece_pushes_bounces_and_is_reported);
    RUN_TEST(test_nothing_touched_is_zero_and_an_empty_report);
    RUN_TEST(test_iteration_order_takes_each_piece_by_number);
    RUN_TEST(test_iteration_order_follows_the_chunks);
    RUN_TEST(test_deepest_first_takes_the_deepest);
    RUN_TEST(test_deepest_first_ties_go_to_the_lowest_number);
    RUN_TEST(test_deepest_first_does_not_depend_on_the_order_of_insertion);
    RUN_TEST(test_deepest_first_does_not_snag_on_flush_pieces);
    RUN_TEST(test_no_more_than_the_limit_of_pushes_deepest_first);
    RUN_TEST(test_in_iteration_order_separate_pieces_push_once_each);
    RUN_TEST(test_no_more_than_the_limit_of_pushes_within_one_piece);
    RUN_TEST(test_a_piece_of_parts_is_tested_again_after_each_push);
    RUN_TEST(test_the_reported_contacts_add_up_to_the_movement);
    RUN_TEST(test_a_short_report_counts_on_and_keeps_what_fits);
    RUN_TEST(test_a_report_without_a_list_only_counts);
    RUN_TEST(test_the_nearby_buffer_plays_no_part);
    RUN_TEST(test_stale_entries_and_empty_slots_are_skipped_and_the_index_is_not_touched);
    RUN_TEST(test_bad_worlds_and_bodies_are_left_alone);
    RUN_TEST(test_hull_normals_are_made_once_and_only_when_needed);
    if (!IS_FIXED) RUN_TEST(test_a_body_that_is_not_a_number_is_left_alone);
    return UNITY_END();
}
