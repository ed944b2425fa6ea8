/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Walks over the index (inner.h): order, coverage, ends. DESIGN 2 (iteration order), DESIGN 4 ("no more chunks than needed", "Beams walk
   the chunks along the line"). */
#include "shapes.h"

#include "inner.h"

#define PIECES 12

DEFINE_TERRAIN(PIECES, 8, 4);   /* 16 units */
static tuff_world world = { terrain, PIECES, &chunks, NULL, 0, TUFF_ORDER_ITERATION };
static uint16_t met[2 * PIECES];
static uint16_t met_count;
static uint16_t enough;         /* so many are met, then the visitor has had enough */
static const tuff_terrain empty_slot;

void setUp(void)
{
    enough = PIECES + 1;
    world.terrain_count = PIECES;
    world.chunks = &chunks;
    chunks.pitch_log2 = 4;
    tuff_chunks_clear(&chunks);
    for (uint8_t i = 0; i < PIECES; i++) terrain[i] = empty_slot;
}

void tearDown(void) {}

static void insert_at(uint16_t piece, tuff_vec2 position, tuff_real bounding_radius)
{
    terrain[piece].position = position;
    terrain[piece].bounding_radius = bounding_radius;
    TEST_ASSERT_TRUE(tuff_chunks_insert(&chunks, piece, position, bounding_radius));
}

static void insert(uint16_t piece, int16_t x, int16_t y, int16_t bounding_radius)
{
    insert_at(piece, whole(x, y), tuff_from_int(bounding_radius));
}

/* Notes what a walk meets; more than there is to meet is a failure of its own. */
static bool meet(tuff_search *search, uint16_t piece)
{
    TEST_ASSERT_TRUE(met_count < 2 * PIECES);
    TEST_ASSERT_TRUE(piece < search->world->terrain_count);
    met[met_count++] = piece;
    return met_count < enough;
}

static void walk_box(int16_t x, int16_t y, int16_t radius, bool ordered)
{
    tuff_search search;
    search.world = &world;
    search.visit = meet;
    search.center = whole(x, y);
    search.radius = tuff_from_int(radius);
    met_count = 0;
    tuff_walk_box(&search, ordered);
}

static void walk_line(tuff_vec2 a, tuff_vec2 b)
{
    tuff_line_search walk;
    walk.visit = meet;
    met_count = 0;
    tuff_walk_line(&walk, &world, a, b);
}

static uint16_t times_met(uint16_t piece)
{
    uint16_t times = 0;
    for (uint16_t i = 0; i < met_count; i++) {
        if (met[i] == piece) times++;
    }
    return times;
}

static void assert_met(const uint16_t *expected, uint16_t count)
{
    TEST_ASSERT_EQUAL_INT(count, met_count);
    for (uint16_t i = 0; i < count; i++) TEST_ASSERT_EQUAL_INT(expected[i], met[i]);
}

#define ASSERT_MET_ONLY(piece) \
    do { TEST_ASSERT_EQUAL_INT(1, met_count); TEST_ASSERT_EQUAL_INT((piece), met[0]); } while (0)

static void test_rows_come_by_ascending_y_then_x(void)
{
    static const uint16_t expected[] = { 3, 1, 0, 2, 4 };
    insert(0, -20, 5, 4);
    insert(1, 25, -10, 4);
    insert(2, 5, 5, 4);
    insert(3, -20, -10, 4);
    insert(4, 5, 25, 4);
    walk_box(0, 5, 40, true);
    assert_met(expected, 5);
}

static void test_within_a_chunk_they_come_as_inserted(void)
{
    static const uint16_t expected[] = { 7, 2, 9, 4 };
    static const uint16_t moved[] = { 7, 9, 4, 2 };
    insert(7, 3, 3, 4);
    insert(2, 12, 12, 4);
    insert(9, 1, 15, 4);
    insert(4, 8, 2, 4);
    walk_box(8, 8, 5, true);
    assert_met(expected, 4);
    insert(2, 12, 12, 4);
    walk_box(8, 8, 5, true);
    assert_met(moved, 4);
}

static void test_large_pieces_come_in_their_own_chunks_turn(void)
{
    static const uint16_t expected[] = { 5, 0, 6, 1, 7 };
    insert(0, 5, -10, 4);
    insert(1, 5, 25, 4);
    insert(7, 5, 300, 400);
    insert(6, 5, 5, 400);
    insert(5, 5, -300, 400);
    walk_box(5, 5, 40, true);
    assert_met(expected, 5);
}

static void test_large_pieces_of_a_row_come_by_x_and_then_as_inserted(void)
{
    static const uint16_t expected[] = { 8, 5, 2, 9, 1 };
    insert(1, 150, 5, 400);
    insert(5, 5, 5, 400);
    insert(2, 5, 8, 400);
    insert(8, -300, 5, 400);
    insert(9, 8, 5, 400);
    walk_box(5, 5, 40, true);
    assert_met(expected, 5);
    walk_box(-250, 5, 40, true);
    assert_met(expected, 5);
}

static void test_without_an_index_numbers_ascend(void)
{
    world.chunks = NULL;
    world.terrain_count = 4;
    for (uint8_t ordered = 0; ordered < 2; ordered++) {
        static const uint16_t expected[] = { 0, 1, 2, 3 };
        walk_box(0, 0, 1, ordered != 0);
        assert_met(expected, 4);
    }
    walk_line(whole(0, 0), whole(1, 1));
    TEST_ASSERT_EQUAL_INT(4, met_count);
    world.terrain_count = 0;
    walk_box(0, 0, 1, true);
    TEST_ASSERT_EQUAL_INT(0, met_count);
}

static void test_far_chunks_are_not_visited(void)
{
    insert(0, 0, 0, 4);
    insert(1, 500, 0, 4);
    insert(2, 0, 500, 4);
    insert(3, -500, -500, 4);
    walk_box(3, 3, 4, true);
    ASSERT_MET_ONLY(0);
}

static void test_entries_past_the_terrain_count_are_skipped(void)
{
    for (uint8_t i = 0; i < PIECES; i++) insert(i, i, 3, i % 2 ? 4 : 400);
    world.terrain_count = 5;
    walk_box(3, 3, 4, true);
    TEST_ASSERT_EQUAL_INT(5, met_count);
    walk_box(3, 3, 4, false);
    TEST_ASSERT_EQUAL_INT(5, met_count);
    walk_line(whole(0, 3), whole(20, 3));
    TEST_ASSERT_EQUAL_INT(5, met_count);
}

static void test_entries_past_the_capacity_are_not_read(void)
{
    for (uint8_t i = 0; i < 6; i++) insert(i, (int16_t)(20 * i), 3, 4);
    chunks.capacity = 3;
    walk_box(0, 0, 2000, false);
    chunks.capacity = PIECES;
    TEST_ASSERT_EQUAL_INT(3, met_count);
}

static void test_ordered_or_not_the_same_pieces_are_met_once(void)
{
    for (uint8_t i = 0; i < PIECES; i++) insert(i, (int16_t)(i * 13 - 70), (int16_t)(i * 29 % 90 - 40), (int16_t)(i % 4 == 0 ? 60 : 3 + i));
    for (uint8_t ordered = 0; ordered < 2; ordered++) {
        walk_box(0, 0, 2000, ordered != 0);
        TEST_ASSERT_EQUAL_INT(PIECES, met_count);
        for (uint8_t i = 0; i < PIECES; i++) TEST_ASSERT_EQUAL_INT(1, times_met(i));
    }
}

/* A line in each of sixteen directions, with a piece that touches its middle and its end from either side. */
static void test_a_line_meets_every_piece_it_touches(void)
{
    static const int8_t ends[][2] = { { 100, 0 }, { 96, 40 }, { 71, 71 }, { 40, 96 }, { 0, 100 }, { -40, 96 }, { -71, 71 },
                                      { -96, 40 }, { -100, 0 }, { -96, -40 }, { -71, -71 }, { -40, -96 }, { 0, -100 },
                                      { 40, -96 }, { 71, -71 }, { 96, -40 } };
    for (uint8_t i = 0; i < 16; i++) {
        int16_t x = ends[i][0];
        int16_t y = ends[i][1];
        tuff_chunks_clear(&chunks);
        insert(0, 0, 0, 15);
        insert(1, (int16_t)(x / 2 - y / 10), (int16_t)(y / 2 + x / 10), 15);
        insert(2, (int16_t)(x / 2 + y / 10), (int16_t)(y / 2 - x / 10), 15);
        insert(3, (int16_t)(x + x / 10), (int16_t)(y + y / 10), 15);
        insert(4, (int16_t)(x * 10), (int16_t)(y * 10), 15);
        insert(5, (int16_t)(-y), x, 15);
        for (uint8_t turn = 0; turn < 2; turn++) {
            walk_line(turn ? whole(x, y) : whole(0, 0), turn ? whole(0, 0) : whole(x, y));
            for (uint16_t piece = 0; piece < 4; piece++) TEST_ASSERT_EQUAL_INT(1, times_met(piece));
            TEST_ASSERT_EQUAL_INT(0, times_met(4));
            TEST_ASSERT_EQUAL_INT(0, times_met(5));
        }
    }
}

/* One of so many numbers, from the lowest up. */
static int16_t random_from(uint32_t *state, int16_t lowest, uint16_t many)
{
    return (int16_t)((int32_t)(next_random(state) % many) + lowest);
}

/* From the same seed in each run: lines of any slope, each with one piece of radius 64 that reaches a point of it. Shows the number of
   the case that fails. */
static void test_no_piece_that_reaches_a_line_is_missed(void)
{
    uint32_t random = UINT32_C(5);
    chunks.pitch_log2 = 6;
    for (int16_t i = 0; i < 1500; i++) {
        int16_t ax = random_from(&random, -1200, 2400);
        int16_t ay = random_from(&random, -1200, 2400);
        int16_t bx = random_from(&random, -1200, 2400);
        int16_t by = random_from(&random, -1200, 2400);
        int16_t share = random_from(&random, 0, 17);
        int16_t dx = random_from(&random, -60, 121);
        int16_t dy = random_from(&random, -60, 121);
        if (dx * dx + dy * dy > 3600) continue;
        tuff_chunks_clear(&chunks);
        insert(0, (int16_t)(ax + (int32_t)(bx - ax) * share / 16 + dx), (int16_t)(ay + (int32_t)(by - ay) * share / 16 + dy), 64);
        walk_line(whole(ax, ay), whole(bx, by));
        if (times_met(0) != 1) {
            UnityPrintNumber(i);
            UNITY_PRINT_EOL();
            TEST_FAIL_MESSAGE("the piece of this case was missed");
        }
    }
}

static void test_a_line_does_not_visit_the_box_around_it(void)
{
    insert(0, 500, 500, 8);
    insert(1, 1500, 500, 8);
    insert(2, 500, 1500, 8);
    walk_line(whole(0, 0), whole(2000, 2000));
    ASSERT_MET_ONLY(0);
}

static void test_a_line_across_the_whole_range_meets_both_its_ends(void)
{
    chunks.pitch_log2 = 10;
    insert_at(0, vec(LOWEST, LOWEST), W(5));
    insert_at(1, vec(HIGHEST, HIGHEST), W(5));
    insert_at(2, vec(HIGHEST, LOWEST), W(5));
    insert(3, 3, -3, 5);
    walk_line(vec(LOWEST, LOWEST), vec(HIGHEST, HIGHEST));
    TEST_ASSERT_EQUAL_INT(3, met_count);
    TEST_ASSERT_EQUAL_INT(0, times_met(2));
    walk_line(vec(HIGHEST, LOWEST), vec(HIGHEST, HIGHEST));
    TEST_ASSERT_EQUAL_INT(2, met_count);
    walk_line(vec(LOWEST, HIGHEST), vec(HIGHEST, LOWEST));
    TEST_ASSERT_EQUAL_INT(2, met_count);
}

static void test_a_line_without_length_is_a_point(void)
{
    insert(0, 5, 5, 8);
    insert(1, 200, 5, 8);
    walk_line(whole(12, 5), whole(12, 5));
    ASSERT_MET_ONLY(0);
}

/* Each list for as many steps as there are entries. */
static void test_lists_in_a_circle_end(void)
{
    for (uint16_t i = 0; i < 3; i++) insert(i, 5, 5, 4);
    for (uint16_t i = 3; i < 6; i++) insert(i, 5, 5, 400);
    entries[2].next = 1;
    entries[5].next = 4;
    enough = 2 * PIECES + 1;
    walk_box(5, 5, 5, true);
    TEST_ASSERT_EQUAL_INT(2 * PIECES, met_count);
}

static void test_a_visitor_may_have_enough(void)
{
    for (uint16_t i = 0; i < 6; i++) insert(i, (int16_t)(5 * i), 5, i < 3 ? 4 : 400);
    for (enough = 1; enough <= 6; enough++) {
        walk_box(5, 5, 30, true);
        TEST_ASSERT_EQUAL_INT(enough, met_count);
        walk_box(5, 5, 30, false);
        TEST_ASSERT_EQUAL_INT(enough, met_count);
        walk_line(whole(0, 5), whole(30, 5));
        TEST_ASSERT_EQUAL_INT(enough, met_count);
        world.chunks = NULL;
        walk_box(5, 5, 30, false);
        TEST_ASSERT_EQUAL_INT(enough, met_count);
        world.chunks = &chunks;
    }
}

/* A walk goes by where the body is now: the second piece is out of reach from where it began. */
static bool meet_and_move(tuff_search *search, uint16_t piece)
{
    search->center = whole(20, 5);
    return meet(search, piece);
}

static void test_the_center_may_move(void)
{
    tuff_search search = { &world, meet_and_move, whole(5, 5), W(2), { { 0, 0 }, { 0, 0 } } };
    insert(0, 4, 5, 4);
    insert(1, 15, 5, 4);
    met_count = 0;
    tuff_walk_box(&search, true);
    TEST_ASSERT_EQUAL_INT(2, met_count);
}

static void test_of_the_chunks_pieces_only_those_in_reach_are_met(void)
{
    insert(0, 1, 1, 3);
    insert(1, 14, 14, 3);
    walk_box(3, 3, 1, true);
    ASSERT_MET_ONLY(0);
    walk_box(14, 3, 8, true);
    ASSERT_MET_ONLY(1);
    walk_line(whole(0, 14), whole(13, 14));
    ASSERT_MET_ONLY(1);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_rows_come_by_ascending_y_then_x);
    RUN_TEST(test_within_a_chunk_they_come_as_inserted);
    RUN_TEST(test_large_pieces_come_in_their_own_chunks_turn);
    RUN_TEST(test_large_pieces_of_a_row_come_by_x_and_then_as_inserted);
    RUN_TEST(test_without_an_index_numbers_ascend);
    RUN_TEST(test_far_chunks_are_not_visited);
    RUN_TEST(test_entries_past_the_terrain_count_are_skipped);
    RUN_TEST(test_entries_past_the_capacity_are_not_read);
    RUN_TEST(test_ordered_or_not_the_same_pieces_are_met_once);
    RUN_TEST(test_a_line_meets_every_piece_it_touches);
    RUN_TEST(test_no_piece_that_reaches_a_line_is_missed);
    RUN_TEST(test_a_line_does_not_visit_the_box_around_it);
    RUN_TEST(test_a_line_across_the_whole_range_meets_both_its_ends);
    RUN_TEST(test_a_line_without_length_is_a_point);
    RUN_TEST(test_lists_in_a_circle_end);
    RUN_TEST(test_a_visitor_may_have_enough);
    RUN_TEST(test_the_center_may_move);
    RUN_TEST(test_of_the_chunks_pieces_only_those_in_reach_are_met);
    return UNITY_END();
}
