/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Is anything between two points? DESIGN 2 (segmentTerrainIntersect), DESIGN 4 (closed, symmetric, no leaks, 33-bit differences). */
#include "shapes.h"

#define PIECES 4

DEFINE_BOX(box, -10, -10, 10, 10);

DEFINE_TERRAIN(PIECES, 8, 5);
static tuff_world world;

void setUp(void)
{
    empty_world(&world, terrain, PIECES, &chunks);
}

void tearDown(void) {}

static void place(uint8_t piece, tuff_real x, tuff_real y, const tuff_polygon *parts, uint8_t part_count)
{
    terrain[piece] = piece_of(vec(x, y), W(8), parts, part_count);
    TEST_ASSERT_TRUE(tuff_chunks_insert(&chunks, piece, terrain[piece].position, W(15)));
}

/* Either direction, with the index and without: one answer. */
static bool blocked(tuff_vec2 a, tuff_vec2 b, UNITY_LINE_TYPE line)
{
    world.chunks = &chunks;
    bool answer = tuff_segment_terrain_intersect(&world, a, b);
    if (answer != tuff_segment_terrain_intersect(&world, b, a)) UNITY_TEST_FAIL(line, "swapping the ends changes the answer");
    world.chunks = NULL;
    if (answer != tuff_segment_terrain_intersect(&world, a, b)) UNITY_TEST_FAIL(line, "the index changes the answer");
    world.chunks = &chunks;
    return answer;
}

#define ASSERT_BLOCKED(a, b) TEST_ASSERT_TRUE(blocked((a), (b), __LINE__))
#define ASSERT_CLEAR(a, b)   TEST_ASSERT_FALSE(blocked((a), (b), __LINE__))

static void test_a_polygon_blocks_and_what_lies_beside_does_not(void)
{
    place(2, W(100), W(50), &box, 1);
    ASSERT_BLOCKED(whole(50, 50), whole(150, 52));
    ASSERT_BLOCKED(whole(50, 0), whole(150, 100));
    ASSERT_CLEAR(whole(50, 61), whole(150, 61));
    ASSERT_CLEAR(whole(50, 50), whole(89, 50));
    ASSERT_CLEAR(whole(111, 50), whole(200, 50));
}

static void test_touching_blocks(void)
{
    place(2, W(100), W(50), &box, 1);
    ASSERT_BLOCKED(whole(50, 60), whole(150, 60));
    ASSERT_BLOCKED(whole(50, 50), whole(90, 50));
    ASSERT_BLOCKED(whole(100, 70), whole(120, 50));
}

static void test_an_end_inside_blocks(void)
{
    place(2, W(100), W(50), &box, 1);
    ASSERT_BLOCKED(whole(100, 50), whole(300, 50));
    ASSERT_BLOCKED(whole(101, 51), whole(99, 49));
    ASSERT_BLOCKED(whole(105, 55), whole(105, 55));
}

static void test_an_unbaked_piece_blocks_as_its_circle(void)
{
    place(1, W(-100), W(50), NULL, 0);
    ASSERT_BLOCKED(whole(-150, 58), whole(-50, 58));
    ASSERT_CLEAR(vec(W(-150), W(58) + NUDGE), vec(W(-50), W(58) + NUDGE));
    ASSERT_BLOCKED(whole(-100, 50), whole(-100, 50));
}

/* The piece's circle is its bounding circle: touching that is touching the piece. */
static void test_tangents_of_the_bounding_circle_block(void)
{
    place(0, 0, 0, NULL, 0);
    terrain[0].radius = W(15);
    ASSERT_BLOCKED(whole(15, -40), whole(15, 40));
    ASSERT_BLOCKED(whole(-15, -40), whole(-15, 40));
    ASSERT_BLOCKED(whole(-40, 15), whole(40, 15));
    ASSERT_BLOCKED(whole(-40, -15), whole(40, -15));
    ASSERT_CLEAR(vec(W(15) + NUDGE, W(-40)), vec(W(15) + NUDGE, W(40)));
    ASSERT_CLEAR(vec(W(-40), W(-15) - NUDGE), vec(W(40), W(-15) - NUDGE));
}

static void test_any_unbaked_part_makes_the_piece_its_circle(void)
{
    tuff_polygon parts[2];
    parts[0] = box;
    parts[1] = box;
    parts[1].count = 2;
    place(0, 0, 0, parts, 2);
    ASSERT_CLEAR(whole(-50, 9), whole(50, 9));
    ASSERT_BLOCKED(whole(-50, 7), whole(50, 7));
}

static void test_the_gap_of_a_concave_piece_is_clear(void)
{
    DEFINE_PAIR_OF_BOXES(parts, 4, 10, box_normals, 0, 0);
    place(0, W(32), W(32), parts, 2);
    ASSERT_CLEAR(whole(32, 0), whole(32, 64));
    ASSERT_BLOCKED(whole(0, 32), whole(30, 32));
    ASSERT_BLOCKED(whole(64, 32), whole(32, 32));
}

static void test_no_beam_passes_between_two_parts_that_share_an_edge(void)
{
    static const tuff_vec2 left[3] = { { W(-10), W(-10) }, { W(3), W(7) }, { W(-10), W(10) } };
    static const tuff_vec2 right[3] = { { W(-10), W(-10) }, { W(10), W(-9) }, { W(3), W(7) } };
    tuff_unit2 normals[2][3];
    tuff_polygon parts[2] = { { left, normals[0], 1, 3 }, { right, normals[1], 4, 3 } };
    tuff_edge_normals(left, 3, normals[0]);
    tuff_edge_normals(right, 3, normals[1]);
    place(0, W(5), W(3), parts, 2);
    ASSERT_BLOCKED(whole(-18, -24), whole(21, 27));   /* the line of the shared edge */
    for (int8_t i = -6; i <= 6; i++) ASSERT_BLOCKED(vec(W(-18) + i * LSB, W(-24)), vec(W(21) - i * LSB, W(27)));
}

static void test_no_beam_passes_between_two_pieces_that_share_a_vertex(void)
{
    place(0, W(0), W(0), &box, 1);
    place(1, W(20), W(20), &box, 1);
    ASSERT_BLOCKED(whole(0, 20), whole(20, 0));
    ASSERT_BLOCKED(whole(-80, 100), whole(100, -80));
    ASSERT_BLOCKED(whole(9, 11), whole(11, 9));
}

static void test_beams_along_the_borders_of_chunks_see_both_sides(void)
{
    place(0, W(22), W(100), &box, 1);    /* touches x = 32 from the left */
    place(1, W(-54), W(-100), &box, 1);  /* touches x = -64 from the right */
    ASSERT_BLOCKED(whole(32, 0), whole(32, 500));
    ASSERT_BLOCKED(whole(-64, 0), whole(-64, -500));
    ASSERT_CLEAR(vec(W(32) + NUDGE, 0), vec(W(32) + NUDGE, W(500)));
}

static void test_beams_across_the_whole_range_do_not_wrap(void)
{
    place(0, 0, 0, &box, 1);
    place(1, HIGHEST, LOWEST, NULL, 0);
    ASSERT_BLOCKED(vec(LOWEST, W(9)), vec(HIGHEST, W(9)));
    ASSERT_BLOCKED(vec(LOWEST, LOWEST), vec(HIGHEST, HIGHEST));
    ASSERT_CLEAR(vec(LOWEST, W(11)), vec(HIGHEST, W(11)));
    ASSERT_CLEAR(vec(LOWEST, HIGHEST), vec(HIGHEST, HIGHEST));
    ASSERT_BLOCKED(vec(LOWEST, LOWEST), vec(HIGHEST, LOWEST));
    ASSERT_BLOCKED(vec(HIGHEST, HIGHEST), vec(HIGHEST, LOWEST));
    ASSERT_BLOCKED(vec(HIGHEST, LOWEST), vec(HIGHEST, LOWEST));
}

static void test_empty_slots_and_stale_entries_do_not_block(void)
{
    place(1, 0, 0, &box, 1);
    terrain[1].bounding_radius = 0;
    ASSERT_CLEAR(whole(-50, 0), whole(50, 0));
    terrain[1].bounding_radius = W(15);
    ASSERT_BLOCKED(whole(-50, 0), whole(50, 0));
    world.terrain_count = 1;
    ASSERT_CLEAR(whole(-50, 0), whole(50, 0));
}

static void test_bad_worlds_do_not_block(void)
{
    static const tuff_world zero;
    place(1, 0, 0, &box, 1);
    TEST_ASSERT_FALSE(tuff_segment_terrain_intersect(NULL, whole(-50, 0), whole(50, 0)));
    TEST_ASSERT_FALSE(tuff_segment_terrain_intersect(&zero, whole(-50, 0), whole(50, 0)));
    world.terrain = NULL;
    TEST_ASSERT_FALSE(tuff_segment_terrain_intersect(&world, whole(-50, 0), whole(50, 0)));
}

static void test_not_a_number_does_not_block(void)
{
    place(1, 0, 0, &box, 1);
    TEST_ASSERT_FALSE(tuff_segment_terrain_intersect(&world, vec(NOT_A_NUMBER, 0), whole(50, 0)));
    TEST_ASSERT_FALSE(tuff_segment_terrain_intersect(&world, whole(-50, 0), vec(W(50), NOT_A_NUMBER)));
    TEST_ASSERT_FALSE(tuff_segment_terrain_intersect(&world, vec(-INFINITE, 0), vec(INFINITE, 0)));
    TEST_ASSERT_FALSE(tuff_segment_terrain_intersect(&world, vec(tuff_from_int(INT32_C(-40000)), 0), whole(50, 0)));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_polygon_blocks_and_what_lies_beside_does_not);
    RUN_TEST(test_touching_blocks);
    RUN_TEST(test_an_end_inside_blocks);
    RUN_TEST(test_an_unbaked_piece_blocks_as_its_circle);
    RUN_TEST(test_tangents_of_the_bounding_circle_block);
    RUN_TEST(test_any_unbaked_part_makes_the_piece_its_circle);
    RUN_TEST(test_the_gap_of_a_concave_piece_is_clear);
    RUN_TEST(test_no_beam_passes_between_two_parts_that_share_an_edge);
    RUN_TEST(test_no_beam_passes_between_two_pieces_that_share_a_vertex);
    RUN_TEST(test_beams_along_the_borders_of_chunks_see_both_sides);
    RUN_TEST(test_beams_across_the_whole_range_do_not_wrap);
    RUN_TEST(test_empty_slots_and_stale_entries_do_not_block);
    RUN_TEST(test_bad_worlds_do_not_block);
    if (!IS_FIXED) RUN_TEST(test_not_a_number_does_not_block);
    return UNITY_END();
}
