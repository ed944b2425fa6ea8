/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A hull against one piece, at world positions. DESIGN 2 (_terrainOverlapPoly), DESIGN 7 (hull NULL, the hull's radius). */
#include "shapes.h"

DEFINE_BOX(box, -10, -10, 10, 10);
static const tuff_terrain piece = { { W(100), W(-50) }, W(6), W(15), &box, 1 };

static const tuff_vec2 hull_vertices[4] = BOX_VERTICES(-4, -4, 4, 4);
static const tuff_polygon hull = { hull_vertices, NULL, 0, 4 };

void setUp(void) {}
void tearDown(void) {}

static void test_a_baked_piece_collides_with_the_hull(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_terrain_overlap_hull(&piece, whole(112, -45), W(6), &hull, &c));
    ASSERT_CONTACT(W(2), ONE, 0, c);
    c = marked_contact();
    TEST_ASSERT_FALSE(tuff_terrain_overlap_hull(&piece, whole(114, -45), W(6), &hull, &c));
    ASSERT_UNTOUCHED(c);
}

static void test_the_hulls_radius_rejects_by_bounding_circles(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_terrain_overlap_hull(&piece, whole(113, -36), W(4), &hull, &c));   /* 19.1 away: reaches 15 + 4 */
    ASSERT_UNTOUCHED(c);
    TEST_ASSERT_TRUE(tuff_terrain_overlap_hull(&piece, whole(113, -37), W(6), &hull, &c));
    ASSERT_CONTACT(W(1), ONE, 0, c);
}

static void test_against_an_unbaked_piece_the_hull_is_its_circle(void)
{
    tuff_terrain unbaked = piece;
    tuff_contact c = marked_contact();
    unbaked.parts = NULL;
    TEST_ASSERT_TRUE(tuff_terrain_overlap_hull(&unbaked, whole(106, -42), W(5), &hull, &c));
    ASSERT_CONTACT(W(1), TUFF_UNIT_RATIO(3, 5), TUFF_UNIT_RATIO(4, 5), c);
    c = marked_contact();
    TEST_ASSERT_FALSE(tuff_terrain_overlap_hull(&unbaked, whole(111, -50), W(5), &hull, &c));
    ASSERT_UNTOUCHED(c);
}

static void assert_is_the_circle(const tuff_polygon *no_hull)
{
    static const int8_t centers[][2] = { { 112, -47 }, { 87, -64 }, { 115, -50 }, { 100, -50 }, { 90, -40 } };
    for (uint8_t i = 0; i < 5; i++) {
        tuff_contact one = marked_contact();
        tuff_contact other = marked_contact();
        tuff_vec2 center = whole(centers[i][0], centers[i][1]);
        TEST_ASSERT_EQUAL_INT(tuff_terrain_overlap_circle(&piece, center, W(5), &one),
                              tuff_terrain_overlap_hull(&piece, center, W(5), no_hull, &other));
        ASSERT_CONTACT_SAME(one, other);
    }
}

static void test_a_hull_of_null_is_the_circle(void)
{
    assert_is_the_circle(NULL);
}

static void test_a_hull_with_fewer_than_three_vertices_is_the_circle(void)
{
    tuff_polygon thin = hull;
    thin.count = 2;
    assert_is_the_circle(&thin);
    thin.count = 0;
    assert_is_the_circle(&thin);
    thin.count = 4;
    thin.vertices = NULL;
    assert_is_the_circle(&thin);
}

static void test_given_and_missing_normals_give_the_same_contact(void)
{
    tuff_polygon complete = hull;
    complete.normals = box_normals;
    for (int8_t y = -68; y < -30; y = (int8_t)(y + 3)) {
        tuff_contact one = marked_contact();
        tuff_contact other = marked_contact();
        TEST_ASSERT_EQUAL_INT(tuff_terrain_overlap_hull(&piece, whole(107, y), W(6), &hull, &one),
                              tuff_terrain_overlap_hull(&piece, whole(107, y), W(6), &complete, &other));
        ASSERT_CONTACT(one.overlap, one.normal.x, one.normal.y, other);
    }
}

static void test_the_callers_hull_is_not_written(void)
{
    tuff_polygon watched = hull;
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_terrain_overlap_hull(&piece, whole(112, -45), W(6), &watched, &c));
    TEST_ASSERT_NULL(watched.normals);
}

static void test_empty_slots_and_null_give_no_contact(void)
{
    tuff_terrain empty = piece;
    tuff_contact c = marked_contact();
    empty.bounding_radius = 0;
    TEST_ASSERT_FALSE(tuff_terrain_overlap_hull(&empty, whole(100, -50), W(6), &hull, &c));
    TEST_ASSERT_FALSE(tuff_terrain_overlap_hull(NULL, whole(100, -50), W(6), &hull, &c));
    ASSERT_UNTOUCHED(c);
}

static void test_radius_out_of_range_gives_no_contact(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_terrain_overlap_hull(&piece, whole(100, -50), W(-1), &hull, &c));
    TEST_ASSERT_FALSE(tuff_terrain_overlap_hull(&piece, whole(100, -50), W(1450), &hull, &c));
    TEST_ASSERT_FALSE(tuff_terrain_overlap_hull(&piece, whole(100, -50), W(-1), NULL, &c));
    ASSERT_UNTOUCHED(c);
    TEST_ASSERT_TRUE(tuff_terrain_overlap_hull(&piece, whole(100, -50), W(1449), &hull, &c));
}

static void test_results_do_not_depend_on_the_distance_from_the_origin(void)
{
    for (uint8_t i = 0; i < FAR_PLACES; i++) {
        tuff_terrain far = moved_far(&piece, i);
        tuff_contact c = marked_contact();
        tuff_vec2 position = vec(far.position.x + TUFF_RATIO(25, 2), far.position.y + TUFF_RATIO(-27, 2));
        TEST_ASSERT_TRUE(tuff_terrain_overlap_hull(&far, position, W(6), &hull, &c));
        ASSERT_CONTACT(TUFF_RATIO(1, 2), 0, -ONE, c);
    }
}

static void test_positions_at_both_ends_of_the_range_do_not_wrap(void)
{
    tuff_terrain far = piece;
    tuff_contact c = marked_contact();
    far.position = vec(HIGHEST, LOWEST);
    TEST_ASSERT_FALSE(tuff_terrain_overlap_hull(&far, vec(LOWEST, LOWEST), W(1449), &hull, &c));
    TEST_ASSERT_FALSE(tuff_terrain_overlap_hull(&far, vec(LOWEST, HIGHEST), W(1449), &hull, &c));
    ASSERT_UNTOUCHED(c);
}

static void test_not_a_number_gives_no_contact(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_terrain_overlap_hull(&piece, vec(NOT_A_NUMBER, W(-50)), W(6), &hull, &c));
    TEST_ASSERT_FALSE(tuff_terrain_overlap_hull(&piece, vec(W(100), -INFINITE), W(6), &hull, &c));
    TEST_ASSERT_FALSE(tuff_terrain_overlap_hull(&piece, whole(100, -50), NOT_A_NUMBER, &hull, &c));
    ASSERT_UNTOUCHED(c);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_baked_piece_collides_with_the_hull);
    RUN_TEST(test_the_hulls_radius_rejects_by_bounding_circles);
    RUN_TEST(test_against_an_unbaked_piece_the_hull_is_its_circle);
    RUN_TEST(test_a_hull_of_null_is_the_circle);
    RUN_TEST(test_a_hull_with_fewer_than_three_vertices_is_the_circle);
    RUN_TEST(test_given_and_missing_normals_give_the_same_contact);
    RUN_TEST(test_the_callers_hull_is_not_written);
    RUN_TEST(test_empty_slots_and_null_give_no_contact);
    RUN_TEST(test_radius_out_of_range_gives_no_contact);
    RUN_TEST(test_results_do_not_depend_on_the_distance_from_the_origin);
    RUN_TEST(test_positions_at_both_ends_of_the_range_do_not_wrap);
    if (!IS_FIXED) RUN_TEST(test_not_a_number_gives_no_contact);
    return UNITY_END();
}
