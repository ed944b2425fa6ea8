/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Filling the index from the terrain array. DESIGN 7 ("World and index set-up": static storage given by the caller, one call). */
#include "shapes.h"

#define PIECES 5

DEFINE_TERRAIN(PIECES, 4, 5);
static uint16_t nearby[PIECES];
static tuff_world world;

void setUp(void)
{
    chunks.capacity = PIECES;
    empty_world(&world, terrain, PIECES, &chunks);
    for (uint8_t i = 0; i < PIECES; i++) {
        terrain[i].position = whole((int16_t)(100 * i), 7);
        terrain[i].bounding_radius = W(10);
    }
    world.nearby = nearby;
    world.nearby_capacity = PIECES;
}

void tearDown(void) {}

static void test_every_piece_is_indexed(void)
{
    TEST_ASSERT_EQUAL_INT(0, tuff_world_index(&world));
    for (uint8_t i = 0; i < PIECES; i++) {
        TEST_ASSERT_EQUAL_INT(1, tuff_nearby_terrain(&world, terrain[i].position, W(1)));
        TEST_ASSERT_EQUAL_INT(i, nearby[0]);
    }
    TEST_ASSERT_EQUAL_INT(TUFF_OK, tuff_check_world(&world, NULL));
}

static void test_indexing_again_starts_afresh(void)
{
    tuff_world_index(&world);
    terrain[4].position = whole(-3000, -3000);
    world.terrain_count = 4;
    TEST_ASSERT_EQUAL_INT(0, tuff_world_index(&world));
    TEST_ASSERT_EQUAL_INT(0, entries[4].next);
    TEST_ASSERT_EQUAL_INT(4, tuff_nearby_terrain(&world, whole(200, 7), W(1000)));
}

static void test_pieces_that_do_not_fit_are_counted(void)
{
    chunks.capacity = 3;
    TEST_ASSERT_EQUAL_INT(2, tuff_world_index(&world));
    TEST_ASSERT_EQUAL_INT(3, tuff_nearby_terrain(&world, whole(200, 7), W(1000)));
}

static void test_bad_pieces_are_counted_and_left_out(void)
{
    terrain[1].bounding_radius = W(1450);
    terrain[2].bounding_radius = W(-1);
    TEST_ASSERT_EQUAL_INT(2, tuff_world_index(&world));
    TEST_ASSERT_EQUAL_INT(0, entries[1].next);
    TEST_ASSERT_EQUAL_INT(0, entries[2].next);
}

static void test_empty_slots_are_left_out_but_well(void)
{
    terrain[1].bounding_radius = 0;
    TEST_ASSERT_EQUAL_INT(0, tuff_world_index(&world));
    TEST_ASSERT_EQUAL_INT(0, entries[1].next);
    TEST_ASSERT_EQUAL_INT(4, tuff_nearby_terrain(&world, whole(200, 7), W(1000)));
}

static void test_without_world_terrain_or_index_nothing_happens(void)
{
    static tuff_world zero;
    TEST_ASSERT_EQUAL_INT(0, tuff_world_index(NULL));
    TEST_ASSERT_EQUAL_INT(0, tuff_world_index(&zero));
    world.terrain = NULL;
    TEST_ASSERT_EQUAL_INT(0, tuff_world_index(&world));
    world.terrain = terrain;
    world.chunks = NULL;
    (void)tuff_world_index(&world);
    TEST_ASSERT_EQUAL_INT(PIECES, tuff_nearby_terrain(&world, whole(200, 7), W(1000)));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_every_piece_is_indexed);
    RUN_TEST(test_indexing_again_starts_afresh);
    RUN_TEST(test_pieces_that_do_not_fit_are_counted);
    RUN_TEST(test_bad_pieces_are_counted_and_left_out);
    RUN_TEST(test_empty_slots_are_left_out_but_well);
    RUN_TEST(test_without_world_terrain_or_index_nothing_happens);
    return UNITY_END();
}
