/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Hull against a convex polygon. DESIGN 2 (_satPolyPoly), DESIGN 4 (minimum translation, ties, windings). */
#include "shapes.h"

DEFINE_BOX(box, -10, -10, 10, 10);
DEFINE_BOX_REVERSED(reversed, -10, -10, 10, 10);

static const tuff_vec2 hull_vertices[4] = BOX_VERTICES(-4, -4, 4, 4);
static const tuff_polygon hull = { hull_vertices, box_normals, 0, 4 };

static const tuff_vec2 diamond_vertices[4] = DIAMOND_VERTICES;
static const tuff_unit2 diamond_normals[4] = { { HALF_ROOT, HALF_ROOT }, { TUFF_UNIT_RAW(-759250125), HALF_ROOT },
                                               { TUFF_UNIT_RAW(-759250125), TUFF_UNIT_RAW(-759250125) },
                                               { HALF_ROOT, TUFF_UNIT_RAW(-759250125) } };
static const tuff_polygon diamond = { diamond_vertices, diamond_normals, 0, 4 };

void setUp(void) {}
void tearDown(void) {}

static void test_each_face_pushes_along_its_normal(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&hull, whole(12, 5), &box, &c));
    ASSERT_CONTACT(W(2), ONE, 0, c);
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&hull, whole(-11, 5), &box, &c));
    ASSERT_CONTACT(W(3), -ONE, 0, c);
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&hull, whole(-3, 13), &box, &c));
    ASSERT_CONTACT(W(1), 0, ONE, c);
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&hull, whole(-3, -13), &box, &c));
    ASSERT_CONTACT(W(1), 0, -ONE, c);
}

static void test_touching_hulls_do_not_collide(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&hull, whole(14, 5), &box, &c));
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&hull, whole(-14, -14), &box, &c));
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&diamond, whole(0, 15), &box, &c));
    ASSERT_UNTOUCHED(c);
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&hull, vec(W(14) - LSB, W(5)), &box, &c));
    ASSERT_CONTACT(LSB, ONE, 0, c);
}

/* A corner of the hull at a face with the normal (4, 3) / 5, 24 from the origin. At (19, 24) it touches; the true overlaps then are, in
   LSB, 0.4 and 0.6. */
static void test_overlap_is_judged_after_rounding(void)
{
    DEFINE_WEDGE(wedge);
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&hull, vec(W(19) + LSB, W(24) - 2 * LSB), &wedge, &c));
    ASSERT_UNTOUCHED(c);
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&hull, vec(W(19), W(24) - LSB), &wedge, &c));
    ASSERT_SAME(LSB, c.overlap);
    ASSERT_UNIT(TUFF_UNIT_RATIO(4, 5), c.normal.x);
}

/* Only the hull's own edge separates a corner from it. */
static void test_the_hulls_axes_separate_too(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&diamond, whole(13, 13), &box, &c));
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&diamond, whole(-13, 13), &box, &c));
    ASSERT_UNTOUCHED(c);
}

static void test_the_hulls_axis_gives_the_normal_away_from_the_obstacle(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&diamond, whole(12, 12), &box, &c));   /* 1 / sqrt(2) deep */
    ASSERT_CONTACT(TUFF_REAL_RAW(46341), HALF_ROOT, HALF_ROOT, c);
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&diamond, whole(12, -12), &box, &c));
    ASSERT_CONTACT(TUFF_REAL_RAW(46341), HALF_ROOT, -HALF_ROOT, c);
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&box, whole(-12, -12), &diamond, &c));
    ASSERT_CONTACT(TUFF_REAL_RAW(46341), -HALF_ROOT, -HALF_ROOT, c);
}

static void test_a_vertex_in_a_face_is_as_deep_as_it_reaches(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&diamond, whole(3, 12), &box, &c));
    ASSERT_CONTACT(W(3), 0, ONE, c);
}

static void test_ties_go_to_the_obstacles_lowest_edge(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&box, vec(0, 0), &box, &c));
    ASSERT_CONTACT(W(20), 0, -ONE, c);
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&box, vec(0, 0), &reversed, &c));
    ASSERT_CONTACT(W(20), -ONE, 0, c);
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&reversed, vec(0, 0), &box, &c));
    ASSERT_CONTACT(W(20), 0, -ONE, c);
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&hull, whole(11, 11), &box, &c));
    ASSERT_CONTACT(W(3), ONE, 0, c);
}

static void test_a_hull_inside_goes_out_whole(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&hull, whole(1, 3), &box, &c));
    ASSERT_CONTACT(W(11), 0, ONE, c);
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&box, whole(1, 3), &hull, &c));
    ASSERT_CONTACT(W(11), 0, ONE, c);
}

static void test_missing_hull_normals_are_made(void)
{
    static const int8_t offsets[][2] = { { 12, 12 }, { 3, 12 }, { -9, -8 }, { 13, 13 }, { 0, 0 }, { 14, -2 } };
    tuff_polygon bare = diamond;
    bare.normals = NULL;
    for (uint8_t i = 0; i < 6; i++) {
        tuff_contact one = marked_contact();
        tuff_contact other = marked_contact();
        tuff_vec2 offset = whole(offsets[i][0], offsets[i][1]);
        TEST_ASSERT_EQUAL_INT(tuff_polygon_polygon(&diamond, offset, &box, &one), tuff_polygon_polygon(&bare, offset, &box, &other));
        ASSERT_CONTACT(one.overlap, one.normal.x, one.normal.y, other);
    }
}

static void test_either_winding_of_either_shape_gives_the_same(void)
{
    static const int8_t offsets[][2] = { { 12, 5 }, { -5, -12 }, { 19, 1 }, { 20, 1 }, { 3, -17 } };
    for (uint8_t i = 0; i < 5; i++) {
        tuff_vec2 offset = whole(offsets[i][0], offsets[i][1]);
        tuff_contact one = marked_contact();
        bool hit = tuff_polygon_polygon(&box, offset, &box, &one);
        for (uint8_t mix = 1; mix < 4; mix++) {
            tuff_contact other = marked_contact();
            TEST_ASSERT_EQUAL_INT(hit, tuff_polygon_polygon(mix & 1 ? &reversed : &box, offset, mix & 2 ? &reversed : &box, &other));
            ASSERT_CONTACT_SAME(one, other);
        }
    }
}

static void test_moving_out_by_the_contact_separates(void)
{
    static const int8_t offsets[][2] = { { 12, 12 }, { 3, 12 }, { -9, -8 }, { 0, 0 }, { 13, -2 }, { -1, 14 } };
    for (uint8_t i = 0; i < 6; i++) {
        tuff_contact c = marked_contact();
        tuff_body body = body_at_rest(whole(offsets[i][0], offsets[i][1]));
        TEST_ASSERT_TRUE(tuff_polygon_polygon(&diamond, body.position, &box, &c));
        tuff_bounce(&body, &c);
        if (tuff_polygon_polygon(&diamond, body.position, &box, &c)) ASSERT_WITHIN(STEPS(1, 50), STEPS(1, 50), c.overlap);
    }
}

static void test_internal_marks_do_not_change_single_polygons(void)
{
    tuff_polygon marked_box = box;
    tuff_polygon marked_diamond = diamond;
    tuff_contact c = marked_contact();
    marked_box.internal_edges = 15;
    marked_diamond.internal_edges = 15;
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&marked_diamond, whole(12, 12), &box, &c));
    ASSERT_CONTACT(TUFF_REAL_RAW(46341), HALF_ROOT, HALF_ROOT, c);
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&hull, whole(12, 5), &marked_box, &c));
    ASSERT_CONTACT(W(2), ONE, 0, c);
}

static void test_every_edge_of_the_largest_polygon_separates_a_small_hull(void)
{
    static const tuff_vec2 small_vertices[3] = { { LSB, 0 }, { 0, LSB }, { TUFF_REAL_RAW(-1), TUFF_REAL_RAW(-1) } };
    static const tuff_polygon small = { small_vertices, NULL, 0, 3 };
    tuff_vec2 vertices[32];
    tuff_unit2 normals[32];
    tuff_polygon polygon = baked_largest_polygon(vertices, normals);
    for (uint8_t i = 0; i < 32; i++) {
        tuff_contact c = marked_contact();
        tuff_body body = body_on_edge(&polygon, i);
        tuff_contact out = { 3 * LSB, normals[i] };
        tuff_bounce(&body, &out);
        TEST_ASSERT_FALSE(tuff_polygon_polygon(&small, body.position, &polygon, &c));
        out.overlap = TUFF_RATIO(1, 4);
        out.normal.x = -out.normal.x;
        out.normal.y = -out.normal.y;
        tuff_bounce(&body, &out);
        TEST_ASSERT_TRUE(tuff_polygon_polygon(&small, body.position, &polygon, &c));
        ASSERT_WITHIN(STEPS(6, 100), TUFF_RATIO(1, 4), c.overlap);
        ASSERT_UNIT(normals[i].x, c.normal.x);
        ASSERT_UNIT(normals[i].y, c.normal.y);
    }
}

static void test_the_limits_of_size_are_legal(void)
{
    static const tuff_vec2 vertices[4] = BOX_VERTICES(-1024, -1024, 1024, 1024);
    static const tuff_polygon giant = { vertices, box_normals, 0, 4 };
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&giant, whole(2047, 2000), &giant, &c));
    ASSERT_CONTACT(W(1), ONE, 0, c);
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&giant, vec(0, 0), &giant, &c));
    ASSERT_CONTACT(W(2048), 0, -ONE, c);
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&giant, whole(2048, 0), &giant, &c));
}

static void test_far_offsets_do_not_wrap_into_a_contact(void)
{
    tuff_contact c = marked_contact();
    for (uint8_t i = 0; i < 8; i++) TEST_ASSERT_FALSE(tuff_polygon_polygon(&diamond, end_of_range(i), &box, &c));
    ASSERT_UNTOUCHED(c);
}

static void test_a_shape_that_is_not_baked_gives_no_contact(void)
{
    tuff_polygon bad = box;
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_polygon_polygon(NULL, vec(0, 0), &box, &c));
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&hull, vec(0, 0), NULL, &c));
    bad.normals = NULL;
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&hull, vec(0, 0), &bad, &c));
    bad.normals = box_normals;
    bad.count = 2;
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&hull, vec(0, 0), &bad, &c));
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&bad, vec(0, 0), &box, &c));
    bad.count = 33;
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&hull, vec(0, 0), &bad, &c));
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&bad, vec(0, 0), &box, &c));
    bad.count = 4;
    bad.vertices = NULL;
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&hull, vec(0, 0), &bad, &c));
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&bad, vec(0, 0), &box, &c));
    ASSERT_UNTOUCHED(c);
}

static void test_not_a_number_gives_no_contact(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&hull, vec(NOT_A_NUMBER, 0), &box, &c));
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&hull, vec(0, NOT_A_NUMBER), &box, &c));
    TEST_ASSERT_FALSE(tuff_polygon_polygon(&hull, vec(0, INFINITE), &box, &c));
    ASSERT_UNTOUCHED(c);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_each_face_pushes_along_its_normal);
    RUN_TEST(test_touching_hulls_do_not_collide);
    if (IS_FIXED) RUN_TEST(test_overlap_is_judged_after_rounding);
    RUN_TEST(test_the_hulls_axes_separate_too);
    RUN_TEST(test_the_hulls_axis_gives_the_normal_away_from_the_obstacle);
    RUN_TEST(test_a_vertex_in_a_face_is_as_deep_as_it_reaches);
    RUN_TEST(test_ties_go_to_the_obstacles_lowest_edge);
    RUN_TEST(test_a_hull_inside_goes_out_whole);
    RUN_TEST(test_missing_hull_normals_are_made);
    RUN_TEST(test_either_winding_of_either_shape_gives_the_same);
    RUN_TEST(test_moving_out_by_the_contact_separates);
    RUN_TEST(test_internal_marks_do_not_change_single_polygons);
    RUN_TEST(test_every_edge_of_the_largest_polygon_separates_a_small_hull);
    RUN_TEST(test_the_limits_of_size_are_legal);
    RUN_TEST(test_far_offsets_do_not_wrap_into_a_contact);
    RUN_TEST(test_a_shape_that_is_not_baked_gives_no_contact);
    if (!IS_FIXED) RUN_TEST(test_not_a_number_gives_no_contact);
    return UNITY_END();
}
