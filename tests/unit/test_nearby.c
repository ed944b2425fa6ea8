/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The nearby query. DESIGN 2 (nearbyTerrain), DESIGN 4 ("Nearby query": exactly the pieces whose circles touch, each once). */
#include "shapes.h"

#define PIECES 8

DEFINE_TERRAIN(PIECES, 16, 6);
static uint16_t nearby[PIECES];
static tuff_world world;

void setUp(void)
{
    empty_world(&world, terrain, PIECES, &chunks);
    world.nearby = nearby;
    world.nearby_capacity = PIECES;
}

void tearDown(void) {}

static void place(uint8_t piece, tuff_real x, tuff_real y, tuff_real bounding_radius)
{
    terrain[piece].position = vec(x, y);
    terrain[piece].bounding_radius = bounding_radius;
}

/* A row of pieces of radius 10, 30 apart; all of them indexed. */
static void place_row(void)
{
    for (uint8_t i = 0; i < PIECES; i++) place(i, W(30 * i), W(0), W(10));
    TEST_ASSERT_EQUAL_INT(0, tuff_world_index(&world));
}

static bool found(uint16_t piece, uint16_t count)
{
    for (uint16_t i = 0; i < count; i++) {
        if (nearby[i] == piece) return true;
    }
    return false;
}

static void test_exactly_the_touching_pieces_are_found(void)
{
    place_row();
    uint16_t count = tuff_nearby_terrain(&world, whole(60, 0), W(20));   /* touches 30 and 90, too */
    TEST_ASSERT_EQUAL_INT(3, count);
    TEST_ASSERT_TRUE(found(1, count) && found(2, count) && found(3, count));
    TEST_ASSERT_EQUAL_INT(1, tuff_nearby_terrain(&world, whole(60, 0), W(20) - NUDGE));
    TEST_ASSERT_EQUAL_INT(2, nearby[0]);
}

static void test_the_corner_of_the_box_is_not_near(void)
{
    place(0, W(30), W(40), W(10));
    tuff_world_index(&world);
    TEST_ASSERT_EQUAL_INT(0, tuff_nearby_terrain(&world, whole(0, 0), W(39)));   /* 50 away */
    TEST_ASSERT_EQUAL_INT(1, tuff_nearby_terrain(&world, whole(0, 0), W(40)));
}

static void test_radius_zero_asks_for_a_point(void)
{
    place_row();
    TEST_ASSERT_EQUAL_INT(1, tuff_nearby_terrain(&world, whole(40, 0), 0));
    TEST_ASSERT_EQUAL_INT(0, tuff_nearby_terrain(&world, whole(45, 0), 0));
}

static void test_without_an_index_the_answer_is_the_same(void)
{
    place_row();
    world.chunks = NULL;
    TEST_ASSERT_EQUAL_INT(3, tuff_nearby_terrain(&world, whole(60, 0), W(20)));
    TEST_ASSERT_EQUAL_INT(1, nearby[0]);
    TEST_ASSERT_EQUAL_INT(2, nearby[1]);
    TEST_ASSERT_EQUAL_INT(3, nearby[2]);
}

static void test_straddling_pieces_are_found_from_the_next_chunk(void)
{
    place(0, W(63), W(63), W(5));
    tuff_world_index(&world);
    TEST_ASSERT_EQUAL_INT(1, tuff_nearby_terrain(&world, whole(66, 66), W(1)));
    TEST_ASSERT_EQUAL_INT(1, tuff_nearby_terrain(&world, whole(66, 61), W(1)));
    TEST_ASSERT_EQUAL_INT(1, tuff_nearby_terrain(&world, whole(61, 66), W(1)));
}

static void test_large_pieces_are_found_once(void)
{
    place(3, W(0), W(0), W(1449));
    place(4, W(2000), W(0), W(500));
    tuff_world_index(&world);
    TEST_ASSERT_EQUAL_INT(1, tuff_nearby_terrain(&world, whole(1000, 1000), W(40)));
    TEST_ASSERT_EQUAL_INT(3, nearby[0]);
    TEST_ASSERT_EQUAL_INT(2, tuff_nearby_terrain(&world, whole(1465, 0), W(40)));
}

static void test_a_full_buffer_still_returns_the_count_needed(void)
{
    place_row();
    for (uint8_t i = 0; i < PIECES; i++) nearby[i] = 999;
    world.nearby_capacity = 2;
    TEST_ASSERT_EQUAL_INT(PIECES, tuff_nearby_terrain(&world, whole(100, 0), W(500)));
    TEST_ASSERT_TRUE(nearby[0] < PIECES && nearby[1] < PIECES && nearby[0] != nearby[1]);
    TEST_ASSERT_EQUAL_INT(999, nearby[2]);
}

static void test_without_a_buffer_the_count_is_returned(void)
{
    place_row();
    world.nearby_capacity = 0;
    TEST_ASSERT_EQUAL_INT(PIECES, tuff_nearby_terrain(&world, whole(100, 0), W(500)));
    world.nearby = NULL;
    world.nearby_capacity = PIECES;
    TEST_ASSERT_EQUAL_INT(PIECES, tuff_nearby_terrain(&world, whole(100, 0), W(500)));
}

static void test_empty_slots_are_skipped(void)
{
    place_row();
    terrain[2].bounding_radius = 0;
    TEST_ASSERT_EQUAL_INT(PIECES - 1, tuff_nearby_terrain(&world, whole(100, 0), W(500)));
    world.chunks = NULL;
    TEST_ASSERT_EQUAL_INT(PIECES - 1, tuff_nearby_terrain(&world, whole(100, 0), W(500)));
}

static void test_entries_past_the_terrain_count_are_skipped_and_kept(void)
{
    place_row();
    world.terrain_count = 3;
    TEST_ASSERT_EQUAL_INT(3, tuff_nearby_terrain(&world, whole(100, 0), W(500)));
    world.terrain_count = PIECES;
    TEST_ASSERT_EQUAL_INT(PIECES, tuff_nearby_terrain(&world, whole(100, 0), W(500)));
}

static void test_any_radius_is_legal(void)
{
    place_row();
    TEST_ASSERT_EQUAL_INT(PIECES, tuff_nearby_terrain(&world, whole(0, 0), HIGHEST));
    for (uint8_t indexed = 0; indexed < 2; indexed++) {
        world.chunks = indexed ? &chunks : NULL;
        TEST_ASSERT_EQUAL_INT(PIECES, tuff_nearby_terrain(&world, whole(-32000, 0), HIGHEST));
        TEST_ASSERT_EQUAL_INT(1, tuff_nearby_terrain(&world, vec(LOWEST, 0), HIGHEST));
        TEST_ASSERT_EQUAL_INT(0, tuff_nearby_terrain(&world, vec(LOWEST, HIGHEST), HIGHEST));
    }
}

static void test_the_finest_pitch_and_the_widest_query_end(void)
{
    chunks.pitch_log2 = 0;
    place(0, W(5), W(5), W(1));
    place(1, W(-900), W(5), W(30));
    tuff_world_index(&world);
    TEST_ASSERT_EQUAL_INT(2, tuff_nearby_terrain(&world, whole(0, 0), HIGHEST));
    chunks.pitch_log2 = 6;
}

static void test_bad_worlds_and_queries_find_nothing(void)
{
    static tuff_world zero;
    place_row();
    TEST_ASSERT_EQUAL_INT(0, tuff_nearby_terrain(NULL, whole(0, 0), W(500)));
    TEST_ASSERT_EQUAL_INT(0, tuff_nearby_terrain(&zero, whole(0, 0), W(500)));
    TEST_ASSERT_EQUAL_INT(0, tuff_nearby_terrain(&world, whole(0, 0), W(-1)));
    TEST_ASSERT_EQUAL_INT(0, tuff_nearby_terrain(&world, whole(0, 0), LOWEST));
    world.terrain = NULL;
    TEST_ASSERT_EQUAL_INT(0, tuff_nearby_terrain(&world, whole(0, 0), W(500)));
    world.terrain = terrain;
    world.terrain_count = 0;
    TEST_ASSERT_EQUAL_INT(0, tuff_nearby_terrain(&world, whole(0, 0), W(500)));
}

static void test_not_a_number_finds_nothing(void)
{
    place_row();
    TEST_ASSERT_EQUAL_INT(0, tuff_nearby_terrain(&world, vec(NOT_A_NUMBER, 0), W(500)));
    TEST_ASSERT_EQUAL_INT(0, tuff_nearby_terrain(&world, vec(0, INFINITE), W(500)));
    TEST_ASSERT_EQUAL_INT(0, tuff_nearby_terrain(&world, whole(0, 0), NOT_A_NUMBER));
    terrain[0].position.x = NOT_A_NUMBER;
    TEST_ASSERT_EQUAL_INT(PIECES - 1, tuff_nearby_terrain(&world, whole(100, 0), W(500)));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_exactly_the_touching_pieces_are_found);
    RUN_TEST(test_the_corner_of_the_box_is_not_near);
    RUN_TEST(test_radius_zero_asks_for_a_point);
    RUN_TEST(test_without_an_index_the_answer_is_the_same);
    RUN_TEST(test_straddling_pieces_are_found_from_the_next_chunk);
    RUN_TEST(test_large_pieces_are_found_once);
    RUN_TEST(test_a_full_buffer_still_returns_the_count_needed);
    RUN_TEST(test_without_a_buffer_the_count_is_returned);
    RUN_TEST(test_empty_slots_are_skipped);
    RUN_TEST(test_entries_past_the_terrain_count_are_skipped_and_kept);
    RUN_TEST(test_any_radius_is_legal);
    RUN_TEST(test_the_finest_pitch_and_the_widest_query_end);
    RUN_TEST(test_bad_worlds_and_queries_find_nothing);
    if (!IS_FIXED) RUN_TEST(test_not_a_number_finds_nothing);
    return UNITY_END();
}
