/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A circle against one piece, at world positions. DESIGN 2 (_terrainOverlap, fallback to the circle), DESIGN 4 (empty slot, range,
   independence of the distance from the origin). */
#include "shapes.h"

DEFINE_BOX(box, -10, -10, 10, 10);
static const tuff_terrain piece = { { W(100), W(-50) }, W(6), W(15), &box, 1 };

void setUp(void) {}
void tearDown(void) {}

static void test_a_baked_piece_collides_as_its_polygon(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_terrain_overlap_circle(&piece, whole(112, -47), W(5), &c));
    ASSERT_CONTACT(W(3), ONE, 0, c);
    TEST_ASSERT_TRUE(tuff_terrain_overlap_circle(&piece, whole(87, -64), W(6), &c));
    ASSERT_CONTACT(W(1), TUFF_UNIT_RATIO(-3, 5), TUFF_UNIT_RATIO(-4, 5), c);
}

static void test_beyond_the_bounding_circle_nothing_is_tested(void)
{
    tuff_terrain small = piece;
    tuff_contact c = marked_contact();
    small.bounding_radius = W(8);
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&small, whole(113, -50), W(5), &c));   /* the polygon would say 2 */
    ASSERT_UNTOUCHED(c);
    TEST_ASSERT_TRUE(tuff_terrain_overlap_circle(&small, vec(W(113) - LSB, W(-50)), W(5), &c));
}

static void test_touching_is_no_contact(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&piece, whole(115, -50), W(5), &c));
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&piece, whole(113, -36), W(5), &c));
    ASSERT_UNTOUCHED(c);
}

static void assert_falls_back(const tuff_terrain *unbaked)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_terrain_overlap_circle(unbaked, whole(106, -42), W(5), &c));   /* 10 away, radii 6 and 5 */
    ASSERT_CONTACT(W(1), TUFF_UNIT_RATIO(3, 5), TUFF_UNIT_RATIO(4, 5), c);
    c = marked_contact();
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(unbaked, whole(111, -50), W(5), &c));
    ASSERT_UNTOUCHED(c);
}

static void test_a_piece_without_parts_is_its_circle(void)
{
    tuff_terrain unbaked = piece;
    unbaked.parts = NULL;
    assert_falls_back(&unbaked);
    unbaked.parts = &box;
    unbaked.part_count = 0;
    assert_falls_back(&unbaked);
}

static void test_one_unbaked_part_makes_the_whole_piece_its_circle(void)
{
    tuff_polygon parts[2];
    tuff_terrain unbaked = piece;
    unbaked.parts = parts;
    unbaked.part_count = 2;
    for (uint8_t last = 0; last < 2; last++) {
        parts[0] = box;
        parts[1] = box;
        parts[last].count = 2;
        assert_falls_back(&unbaked);
        parts[last].count = 0;
        assert_falls_back(&unbaked);
        parts[last].count = 4;
        parts[last].normals = NULL;
        assert_falls_back(&unbaked);
    }
}

static void test_a_part_with_too_many_vertices_counts_as_unbaked(void)
{
    tuff_polygon part = box;
    tuff_terrain unbaked = piece;
    part.count = 33;
    unbaked.parts = &part;
    assert_falls_back(&unbaked);
}

static void test_an_empty_slot_is_skipped(void)
{
    static const tuff_terrain zero;
    tuff_terrain empty = piece;
    tuff_contact c = marked_contact();
    empty.bounding_radius = 0;
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&empty, whole(100, -50), W(5), &c));
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&zero, whole(0, 0), W(5), &c));
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(NULL, whole(0, 0), W(5), &c));
    ASSERT_UNTOUCHED(c);
}

static void test_bounding_radius_out_of_range_is_skipped(void)
{
    tuff_terrain bad = piece;
    tuff_contact c = marked_contact();
    bad.bounding_radius = W(-15);
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&bad, whole(100, -50), W(5), &c));
    bad.bounding_radius = HIGHEST;
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&bad, whole(100, -50), W(5), &c));
    ASSERT_UNTOUCHED(c);
}

static void test_radius_out_of_range_gives_no_contact(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&piece, whole(100, -50), W(-1), &c));
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&piece, whole(100, -50), W(1450), &c));
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&piece, whole(100, -50), HIGHEST, &c));
    ASSERT_UNTOUCHED(c);
}

/* Steps of 1/128 and more: what the float build still holds out there. */
static void test_results_do_not_depend_on_the_distance_from_the_origin(void)
{
    for (uint8_t i = 0; i < FAR_PLACES; i++) {
        tuff_terrain far = moved_far(&piece, i);
        tuff_contact c = marked_contact();
        tuff_vec2 center = vec(far.position.x + TUFF_RATIO(25, 2), far.position.y + TUFF_RATIO(-23, 2));
        TEST_ASSERT_TRUE(tuff_terrain_overlap_circle(&far, center, W(4), &c));
        ASSERT_CONTACT(TUFF_REAL_RAW(71075), TUFF_UNIT_RAW(920726018), TUFF_UNIT_RAW(-552435611), c);   /* (2.5, -1.5) off the corner */
    }
}

static void test_positions_at_both_ends_of_the_range_do_not_wrap(void)
{
    tuff_terrain far = piece;
    tuff_contact c = marked_contact();
    far.position = vec(HIGHEST, HIGHEST);
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&far, vec(LOWEST, LOWEST), W(1024), &c));
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&far, vec(LOWEST, HIGHEST), W(1024), &c));
    far.position = vec(LOWEST, 0);
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&far, vec(HIGHEST, 0), W(1024), &c));
    ASSERT_UNTOUCHED(c);
    TEST_ASSERT_TRUE(tuff_terrain_overlap_circle(&far, vec(LOWEST + W(12), W(3)), W(5), &c));
    ASSERT_CONTACT(W(3), ONE, 0, c);
}

static void test_not_a_number_gives_no_contact(void)
{
    tuff_terrain bad = piece;
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&piece, vec(NOT_A_NUMBER, W(-50)), W(5), &c));
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&piece, vec(W(100), INFINITE), W(5), &c));
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&piece, whole(100, -50), NOT_A_NUMBER, &c));
    bad.position.x = NOT_A_NUMBER;
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&bad, whole(100, -50), W(5), &c));
    bad = piece;
    bad.bounding_radius = NOT_A_NUMBER;
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&bad, whole(100, -50), W(5), &c));
    ASSERT_UNTOUCHED(c);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_baked_piece_collides_as_its_polygon);
    RUN_TEST(test_beyond_the_bounding_circle_nothing_is_tested);
    RUN_TEST(test_touching_is_no_contact);
    RUN_TEST(test_a_piece_without_parts_is_its_circle);
    RUN_TEST(test_one_unbaked_part_makes_the_whole_piece_its_circle);
    RUN_TEST(test_a_part_with_too_many_vertices_counts_as_unbaked);
    RUN_TEST(test_an_empty_slot_is_skipped);
    RUN_TEST(test_bounding_radius_out_of_range_is_skipped);
    RUN_TEST(test_radius_out_of_range_gives_no_contact);
    RUN_TEST(test_results_do_not_depend_on_the_distance_from_the_origin);
    RUN_TEST(test_positions_at_both_ends_of_the_range_do_not_wrap);
    if (!IS_FIXED) RUN_TEST(test_not_a_number_gives_no_contact);
    return UNITY_END();
}
