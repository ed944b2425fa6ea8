/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The index: insert, move, remove, clear. DESIGN 2 ("Chunks change at run time"), DESIGN 4 (floor, cleared and emptied index). */
#include "shapes.h"

#define PIECES  6
#define BUCKETS 8

DEFINE_TERRAIN(PIECES, BUCKETS, 6);
static uint16_t nearby[PIECES];
static tuff_world world = { terrain, PIECES, &chunks, nearby, PIECES, TUFF_ORDER_ITERATION };

void setUp(void)
{
    static const tuff_terrain empty;
    for (uint8_t i = 0; i < PIECES; i++) terrain[i] = empty;
    chunks.bucket_count = BUCKETS;
    chunks.pitch_log2 = 6;
    tuff_chunks_clear(&chunks);
}

void tearDown(void) {}

static bool put(uint16_t piece, tuff_real x, tuff_real y, tuff_real bounding_radius)
{
    terrain[piece].position = vec(x, y);
    terrain[piece].bounding_radius = bounding_radius;
    terrain[piece].radius = bounding_radius;
    return tuff_chunks_insert(&chunks, piece, terrain[piece].position, bounding_radius);
}

/* How often the query finds this piece. */
static uint16_t times_found(uint16_t piece, tuff_real x, tuff_real y, tuff_real radius)
{
    uint16_t times = 0;
    uint16_t count = tuff_nearby_terrain(&world, vec(x, y), radius);
    for (uint16_t i = 0; i < count; i++) {
        if (nearby[i] == piece) times++;
    }
    return times;
}

static void test_the_initializer_counts_both_arrays(void)
{
    static const tuff_chunks fresh = TUFF_CHUNKS(buckets, entries, 6);
    TEST_ASSERT_TRUE(fresh.buckets == buckets && fresh.entries == entries);
    TEST_ASSERT_EQUAL_INT(BUCKETS, fresh.bucket_count);
    TEST_ASSERT_EQUAL_INT(PIECES, fresh.capacity);
    TEST_ASSERT_EQUAL_INT(6, fresh.pitch_log2);
    TEST_ASSERT_FALSE(fresh.used);
}

static void test_the_index_takes_two_bytes_a_bucket_and_six_a_piece(void)
{
    TEST_ASSERT_EQUAL_INT(2, sizeof buckets[0]);
    TEST_ASSERT_EQUAL_INT(6, sizeof entries[0]);
}

static void test_an_inserted_piece_is_found_once(void)
{
    TEST_ASSERT_TRUE(put(3, W(100), W(100), W(10)));
    TEST_ASSERT_EQUAL_INT(1, times_found(3, W(105), W(95), W(1)));
    TEST_ASSERT_EQUAL_INT(0, times_found(3, W(300), W(300), W(1)));
}

static void test_inserting_again_moves_instead_of_doubling(void)
{
    put(3, W(100), W(100), W(10));
    put(3, W(101), W(100), W(10));
    TEST_ASSERT_EQUAL_INT(1, times_found(3, W(100), W(100), W(200)));
    put(3, W(-500), W(900), W(10));
    TEST_ASSERT_EQUAL_INT(0, times_found(3, W(100), W(100), W(200)));
    TEST_ASSERT_EQUAL_INT(1, times_found(3, W(-500), W(900), W(5)));
}

static void test_move_follows_a_piece(void)
{
    put(2, W(10), W(10), W(10));
    terrain[2].position = whole(1000, -1000);
    TEST_ASSERT_TRUE(tuff_chunks_move(&chunks, 2, terrain[2].position, W(10)));
    TEST_ASSERT_EQUAL_INT(1, times_found(2, W(1000), W(-1000), W(1)));
}

static void test_a_removed_piece_is_not_found(void)
{
    put(1, W(0), W(0), W(10));
    put(2, W(1), W(1), W(10));
    put(3, W(2), W(2), W(10));
    TEST_ASSERT_TRUE(tuff_chunks_remove(&chunks, 2));
    TEST_ASSERT_EQUAL_INT(1, times_found(1, 0, 0, W(5)));
    TEST_ASSERT_EQUAL_INT(0, times_found(2, 0, 0, W(5)));
    TEST_ASSERT_EQUAL_INT(1, times_found(3, 0, 0, W(5)));
    TEST_ASSERT_FALSE(tuff_chunks_remove(&chunks, 2));
}

static void test_remove_works_whatever_the_position_has_become(void)
{
    put(4, W(100), W(100), W(10));
    put(5, W(100), W(100), W(10));
    terrain[4].position = whole(-9999, 12345);
    TEST_ASSERT_TRUE(tuff_chunks_remove(&chunks, 4));
    terrain[4].position = whole(100, 100);
    TEST_ASSERT_EQUAL_INT(0, times_found(4, W(100), W(100), W(5)));
    TEST_ASSERT_EQUAL_INT(1, times_found(5, W(100), W(100), W(5)));
}

static void test_removing_what_is_not_there_changes_nothing(void)
{
    TEST_ASSERT_FALSE(tuff_chunks_remove(&chunks, 0));
    put(1, W(0), W(0), W(10));
    TEST_ASSERT_FALSE(tuff_chunks_remove(&chunks, 0));
    TEST_ASSERT_FALSE(tuff_chunks_remove(&chunks, PIECES));
    TEST_ASSERT_FALSE(tuff_chunks_remove(&chunks, 65535));
    TEST_ASSERT_EQUAL_INT(1, times_found(1, 0, 0, W(5)));
}

static void test_after_clear_the_world_is_scanned(void)
{
    put(1, W(0), W(0), W(10));
    terrain[2].position = whole(5, 5);
    terrain[2].bounding_radius = W(10);
    TEST_ASSERT_EQUAL_INT(0, times_found(2, 0, 0, W(5)));
    tuff_chunks_clear(&chunks);
    TEST_ASSERT_EQUAL_INT(1, times_found(1, 0, 0, W(5)));
    TEST_ASSERT_EQUAL_INT(1, times_found(2, 0, 0, W(5)));
}

static void test_an_index_emptied_by_removing_finds_nothing(void)
{
    put(1, W(0), W(0), W(10));
    TEST_ASSERT_TRUE(tuff_chunks_remove(&chunks, 1));
    TEST_ASSERT_EQUAL_INT(0, times_found(1, 0, 0, W(5)));
}

static void test_an_empty_slot_is_not_entered(void)
{
    TEST_ASSERT_TRUE(put(1, W(0), W(0), 0));
    TEST_ASSERT_EQUAL_INT(0, entries[1].next);
    put(2, W(0), W(0), W(10));
    TEST_ASSERT_TRUE(put(2, W(0), W(0), 0));
    TEST_ASSERT_EQUAL_INT(0, entries[2].next);
}

static void test_what_is_out_of_range_changes_nothing(void)
{
    put(1, W(0), W(0), W(10));
    TEST_ASSERT_FALSE(tuff_chunks_insert(&chunks, PIECES, whole(0, 0), W(10)));
    TEST_ASSERT_FALSE(tuff_chunks_insert(&chunks, 65535, whole(0, 0), W(10)));
    TEST_ASSERT_FALSE(tuff_chunks_insert(&chunks, 1, whole(500, 500), W(1450)));
    TEST_ASSERT_FALSE(tuff_chunks_insert(&chunks, 1, whole(500, 500), W(-1)));
    TEST_ASSERT_FALSE(tuff_chunks_move(&chunks, 1, whole(500, 500), HIGHEST));
    TEST_ASSERT_EQUAL_INT(1, times_found(1, 0, 0, W(5)));
}

static void test_an_index_without_storage_takes_nothing(void)
{
    tuff_chunks zero = { 0 };
    tuff_chunks bare = chunks;
    bare.buckets = NULL;
    TEST_ASSERT_FALSE(tuff_chunks_insert(NULL, 0, whole(0, 0), W(10)));
    TEST_ASSERT_FALSE(tuff_chunks_insert(&zero, 0, whole(0, 0), W(10)));
    TEST_ASSERT_FALSE(tuff_chunks_insert(&bare, 0, whole(0, 0), W(10)));
    bare = chunks;
    bare.entries = NULL;
    TEST_ASSERT_FALSE(tuff_chunks_insert(&bare, 0, whole(0, 0), W(10)));
    TEST_ASSERT_FALSE(tuff_chunks_remove(NULL, 0));
    TEST_ASSERT_FALSE(tuff_chunks_remove(&zero, 0));
    tuff_chunks_clear(NULL);
    tuff_chunks_clear(&zero);
    tuff_chunks_clear(&bare);
}

/* -1 LSB is in chunk -1, not in chunk 0. */
static void test_chunks_of_negative_coordinates_are_floored(void)
{
    put(0, EITHER(-LSB, TUFF_RATIO(-1, 8)), W(-64), W(10));
    TEST_ASSERT_EQUAL_INT(-1, entries[0].x);
    TEST_ASSERT_EQUAL_INT(-1, entries[0].y);
    put(1, W(0), W(-65), W(10));
    TEST_ASSERT_EQUAL_INT(0, entries[1].x);
    TEST_ASSERT_EQUAL_INT(-2, entries[1].y);
    TEST_ASSERT_EQUAL_INT(1, times_found(0, W(5), W(-60), W(1)));
    TEST_ASSERT_EQUAL_INT(1, times_found(1, W(-5), W(-60), W(1)));
}

static void test_the_corners_of_the_range_are_reached_at_every_pitch(void)
{
    for (uint8_t pitch = 0; pitch <= TUFF_MAX_PITCH_LOG2; pitch++) {
        tuff_chunks_clear(&chunks);
        chunks.pitch_log2 = pitch;
        for (uint8_t i = 0; i < 4; i++) {
            tuff_real x = i & 1 ? HIGHEST : LOWEST;
            tuff_real y = i & 2 ? HIGHEST : LOWEST;
            TEST_ASSERT_TRUE(put(i, x, y, W(3)));
            TEST_ASSERT_EQUAL_INT(1, times_found(i, x, y, W(2)));
            TEST_ASSERT_EQUAL_INT(1, tuff_nearby_terrain(&world, vec(x, y), W(2)));
            TEST_ASSERT_EQUAL_INT(0, tuff_nearby_terrain(&world, vec(0, 0), W(2)));
        }
    }
}

static void test_a_piece_larger_than_a_chunk_is_found_from_every_chunk_it_covers(void)
{
    put(0, W(32), W(32), W(1000));
    TEST_ASSERT_EQUAL_INT(1, times_found(0, W(1000), W(32), W(1)));
    TEST_ASSERT_EQUAL_INT(1, times_found(0, W(32), W(-900), W(1)));
    TEST_ASSERT_EQUAL_INT(0, times_found(0, W(1100), W(32), W(1)));
    TEST_ASSERT_TRUE(tuff_chunks_remove(&chunks, 0));
    TEST_ASSERT_EQUAL_INT(0, times_found(0, W(32), W(32), W(1)));
}

static void test_a_piece_may_grow_and_shrink(void)
{
    put(0, W(32), W(32), W(10));
    put(0, W(32), W(32), W(1000));
    TEST_ASSERT_EQUAL_INT(1, times_found(0, W(900), W(32), W(1)));
    put(0, W(32), W(32), W(10));
    TEST_ASSERT_EQUAL_INT(1, times_found(0, W(40), W(32), W(1)));
    TEST_ASSERT_EQUAL_INT(0, times_found(0, W(900), W(32), W(1)));
    put(0, W(32), W(32), W(64));
    TEST_ASSERT_EQUAL_INT(1, times_found(0, W(-33), W(32), W(1)));
}

static void test_pieces_of_other_chunks_in_the_same_bucket_stay_apart(void)
{
    chunks.bucket_count = 1;
    for (uint8_t i = 0; i < PIECES; i++) put(i, W(i * 200), W(0), W(10));
    for (uint8_t i = 0; i < PIECES; i++) {
        TEST_ASSERT_EQUAL_INT(1, tuff_nearby_terrain(&world, vec(W(i * 200), W(0)), W(10)));
        TEST_ASSERT_EQUAL_INT(i, nearby[0]);
    }
    TEST_ASSERT_TRUE(tuff_chunks_remove(&chunks, 0));
    TEST_ASSERT_TRUE(tuff_chunks_remove(&chunks, 5));
    TEST_ASSERT_TRUE(tuff_chunks_remove(&chunks, 2));
    TEST_ASSERT_EQUAL_INT(3, tuff_nearby_terrain(&world, vec(W(500), W(0)), W(600)));
}

static void test_links_that_point_beyond_the_entries_are_not_followed(void)
{
    put(0, W(0), W(0), W(10));
    entries[0].next = 4000;
    TEST_ASSERT_EQUAL_INT(1, times_found(0, 0, 0, W(5)));
    buckets[0] = 5000;
    buckets[1] = 5001;
    chunks.large = 6000;
    TEST_ASSERT_TRUE(tuff_nearby_terrain(&world, vec(0, 0), W(500)) <= PIECES);
}

static void test_lists_in_a_circle_end(void)
{
    for (uint8_t i = 0; i < 3; i++) put(i, W(0), W(0), W(10));
    for (uint8_t i = 3; i < PIECES; i++) put(i, W(0), W(0), W(1000));
    entries[2].next = 1;
    entries[5].next = 4;
    (void)tuff_nearby_terrain(&world, vec(0, 0), W(5));
    (void)tuff_chunks_insert(&chunks, 1, whole(0, 0), W(10));
    (void)tuff_chunks_insert(&chunks, 4, whole(0, 0), W(1000));
    (void)tuff_chunks_remove(&chunks, 0);
    (void)tuff_chunks_remove(&chunks, 3);
    tuff_chunks_clear(&chunks);
    put(0, W(0), W(0), W(10));
    TEST_ASSERT_EQUAL_INT(1, tuff_nearby_terrain(&world, vec(0, 0), W(5)));
}

static void test_not_a_number_is_not_inserted(void)
{
    TEST_ASSERT_FALSE(tuff_chunks_insert(&chunks, 0, vec(NOT_A_NUMBER, 0), W(10)));
    TEST_ASSERT_FALSE(tuff_chunks_insert(&chunks, 0, vec(0, INFINITE), W(10)));
    TEST_ASSERT_FALSE(tuff_chunks_insert(&chunks, 0, vec(0, tuff_from_int(INT32_C(40000))), W(10)));
    TEST_ASSERT_FALSE(tuff_chunks_insert(&chunks, 0, vec(0, 0), NOT_A_NUMBER));
    TEST_ASSERT_FALSE(chunks.used);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_initializer_counts_both_arrays);
    RUN_TEST(test_the_index_takes_two_bytes_a_bucket_and_six_a_piece);
    RUN_TEST(test_an_inserted_piece_is_found_once);
    RUN_TEST(test_inserting_again_moves_instead_of_doubling);
    RUN_TEST(test_move_follows_a_piece);
    RUN_TEST(test_a_removed_piece_is_not_found);
    RUN_TEST(test_remove_works_whatever_the_position_has_become);
    RUN_TEST(test_removing_what_is_not_there_changes_nothing);
    RUN_TEST(test_after_clear_the_world_is_scanned);
    RUN_TEST(test_an_index_emptied_by_removing_finds_nothing);
    RUN_TEST(test_an_empty_slot_is_not_entered);
    RUN_TEST(test_what_is_out_of_range_changes_nothing);
    RUN_TEST(test_an_index_without_storage_takes_nothing);
    RUN_TEST(test_chunks_of_negative_coordinates_are_floored);
    RUN_TEST(test_the_corners_of_the_range_are_reached_at_every_pitch);
    RUN_TEST(test_a_piece_larger_than_a_chunk_is_found_from_every_chunk_it_covers);
    RUN_TEST(test_a_piece_may_grow_and_shrink);
    RUN_TEST(test_pieces_of_other_chunks_in_the_same_bucket_stay_apart);
    RUN_TEST(test_links_that_point_beyond_the_entries_are_not_followed);
    RUN_TEST(test_lists_in_a_circle_end);
    if (!IS_FIXED) RUN_TEST(test_not_a_number_is_not_inserted);
    return UNITY_END();
}
