/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Circle against a convex polygon. DESIGN 2 (_satCirclePoly), DESIGN 4 (every Voronoi region, ties, touching, windings). */
#include "shapes.h"

DEFINE_BOX(box, -10, -10, 10, 10);
DEFINE_BOX_REVERSED(reversed, -10, -10, 10, 10);
DEFINE_WEDGE(wedge);

void setUp(void) {}
void tearDown(void) {}

static void test_a_face_pushes_along_its_normal(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(12, 3), W(5), &box, &c));
    ASSERT_CONTACT(W(3), ONE, 0, c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(-12, -9), W(5), &box, &c));
    ASSERT_CONTACT(W(3), -ONE, 0, c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(9, 14), W(5), &box, &c));
    ASSERT_CONTACT(W(1), 0, ONE, c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(0, -13), W(5), &box, &c));
    ASSERT_CONTACT(W(2), 0, -ONE, c);
}

static void test_an_oblique_face_pushes_along_its_normal(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(19, 23), W(6), &wedge, &c));   /* 29 along the normal: 5 outside */
    ASSERT_CONTACT(W(1), TUFF_UNIT_RATIO(4, 5), TUFF_UNIT_RATIO(3, 5), c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(14, 11), W(6), &wedge, &c));   /* 17.8 along the normal: 6.2 inside */
    ASSERT_CONTACT(TUFF_RATIO(61, 5), TUFF_UNIT_RATIO(4, 5), TUFF_UNIT_RATIO(3, 5), c);
}

static void test_touching_a_face_is_no_contact(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_circle_polygon(whole(15, 3), W(5), &box, &c));
    TEST_ASSERT_FALSE(tuff_circle_polygon(whole(3, -15), W(5), &box, &c));
    ASSERT_UNTOUCHED(c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(vec(W(15) - LSB, W(3)), W(5), &box, &c));
    ASSERT_CONTACT(LSB, ONE, 0, c);
}

/* The true overlaps, in LSB: 0.2 and 0.6 at the face, 0.34 and 0.93 at the vertex. */
static void test_overlap_is_judged_after_rounding(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_circle_polygon(vec(W(19) + LSB, W(23)), W(5) + LSB, &wedge, &c));
    TEST_ASSERT_FALSE(tuff_circle_polygon(vec(W(10) + 4 * LSB, W(10) + 4 * LSB), 6 * LSB, &box, &c));
    ASSERT_UNTOUCHED(c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(vec(W(19) + 3 * LSB, W(23)), W(5) + 3 * LSB, &wedge, &c));
    ASSERT_SAME(LSB, c.overlap);
    TEST_ASSERT_TRUE(tuff_circle_polygon(vec(W(10) + 5 * LSB, W(10) + 5 * LSB), 8 * LSB, &box, &c));
    ASSERT_SAME(LSB, c.overlap);
}

static void test_a_vertex_pushes_along_the_line_to_the_center(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(13, 14), W(6), &box, &c));
    ASSERT_CONTACT(W(1), TUFF_UNIT_RATIO(3, 5), TUFF_UNIT_RATIO(4, 5), c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(-14, 13), W(6), &box, &c));
    ASSERT_CONTACT(W(1), TUFF_UNIT_RATIO(-4, 5), TUFF_UNIT_RATIO(3, 5), c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(-13, -14), W(6), &box, &c));
    ASSERT_CONTACT(W(1), TUFF_UNIT_RATIO(-3, 5), TUFF_UNIT_RATIO(-4, 5), c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(14, -13), W(6), &box, &c));
    ASSERT_CONTACT(W(1), TUFF_UNIT_RATIO(4, 5), TUFF_UNIT_RATIO(-3, 5), c);
}

static void test_touching_a_vertex_is_no_contact(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_circle_polygon(whole(13, 14), W(5), &box, &c));
    ASSERT_UNTOUCHED(c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(13, 14), W(5) + LSB, &box, &c));
    ASSERT_CONTACT(LSB, TUFF_UNIT_RATIO(3, 5), TUFF_UNIT_RATIO(4, 5), c);
}

static void test_between_two_faces_a_circle_clear_of_the_vertex_is_clear(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_circle_polygon(whole(14, 14), W(5), &box, &c));   /* 4 from both faces, 5.66 from the corner */
    ASSERT_UNTOUCHED(c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(14, 14), W(6), &box, &c));
    ASSERT_UNIT(HALF_ROOT, c.normal.x);
    ASSERT_UNIT(HALF_ROOT, c.normal.y);
}

/* No guard about the vertex: five steps from it the axis is still the line to the center. */
static void test_vertex_region_holds_down_to_the_last_bit(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_circle_polygon(vec(W(10) + 3 * LSB, W(10) + 4 * LSB), 6 * LSB, &box, &c));
    ASSERT_CONTACT(LSB, TUFF_UNIT_RATIO(3, 5), TUFF_UNIT_RATIO(4, 5), c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(vec(W(10) + 3 * LSB, W(10) + 4 * LSB), W(8), &box, &c));
    ASSERT_CONTACT(W(8) - 5 * LSB, TUFF_UNIT_RATIO(3, 5), TUFF_UNIT_RATIO(4, 5), c);
}

static void test_center_on_a_vertex_takes_the_normal_of_its_lowest_edge(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(10, 10), W(5), &box, &c));
    ASSERT_CONTACT(W(5), ONE, 0, c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(-10, -10), W(5), &box, &c));
    ASSERT_CONTACT(W(5), 0, -ONE, c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(-10, 10), W(5), &reversed, &c));
    ASSERT_CONTACT(W(5), -ONE, 0, c);
}

static void test_center_on_an_edge_takes_its_normal_and_the_whole_radius(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(3, 10), W(5), &box, &c));
    ASSERT_CONTACT(W(5), 0, ONE, c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(15, 20), W(5), &wedge, &c));
    ASSERT_CONTACT(W(5), TUFF_UNIT_RATIO(4, 5), TUFF_UNIT_RATIO(3, 5), c);
}

static void test_ties_go_to_the_lowest_edge(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_circle_polygon(vec(0, 0), W(5), &box, &c));
    ASSERT_CONTACT(W(15), 0, -ONE, c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(vec(0, 0), W(5), &reversed, &c));
    ASSERT_CONTACT(W(15), -ONE, 0, c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(4, 4), W(5), &box, &c));
    ASSERT_CONTACT(W(11), ONE, 0, c);
}

static void test_center_inside_goes_out_through_the_nearest_face(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(-8, 5), W(2), &box, &c));
    ASSERT_CONTACT(W(4), -ONE, 0, c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(-8, 9), W(2), &box, &c));
    ASSERT_CONTACT(W(3), 0, ONE, c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(10, 1), W(50), &wedge, &c));
    ASSERT_CONTACT(W(51), 0, -ONE, c);
}

static void test_a_point_collides_inside_only(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_circle_polygon(whole(10, 3), 0, &box, &c));
    TEST_ASSERT_FALSE(tuff_circle_polygon(whole(10, 10), 0, &box, &c));
    TEST_ASSERT_FALSE(tuff_circle_polygon(whole(11, 3), 0, &box, &c));
    ASSERT_UNTOUCHED(c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(7, 2), 0, &box, &c));
    ASSERT_CONTACT(W(3), ONE, 0, c);
}

static void test_either_winding_gives_the_same_contact(void)
{
    static const int8_t centers[][2] = { { 12, 3 }, { -3, -12 }, { 13, 14 }, { -14, 13 }, { 9, 1 }, { -1, 8 }, { 16, 0 }, { 14, 14 } };
    for (uint8_t i = 0; i < 8; i++) {
        tuff_contact one = marked_contact();
        tuff_contact other = marked_contact();
        tuff_vec2 center = whole(centers[i][0], centers[i][1]);
        TEST_ASSERT_EQUAL_INT(tuff_circle_polygon(center, W(5), &box, &one), tuff_circle_polygon(center, W(5), &reversed, &other));
        ASSERT_CONTACT_SAME(one, other);
    }
}

static void test_moving_out_by_the_contact_separates(void)
{
    static const int8_t centers[][2] = { { 12, 3 }, { 13, 14 }, { -2, -9 }, { 0, 0 }, { -12, -11 }, { 10, 10 }, { 5, -14 } };
    for (uint8_t i = 0; i < 7; i++) {
        tuff_contact c = marked_contact();
        tuff_body body = body_at_rest(whole(centers[i][0], centers[i][1]));
        TEST_ASSERT_TRUE(tuff_circle_polygon(body.position, W(6), &box, &c));
        tuff_bounce(&body, &c);
        if (tuff_circle_polygon(body.position, W(6), &box, &c)) ASSERT_WITHIN(STEPS(1, 50), STEPS(1, 50), c.overlap);
    }
}

static void test_a_vertex_on_a_straight_edge_changes_nothing(void)
{
    static const tuff_vec2 vertices[5] = { { W(-10), W(-10) }, { W(10), W(-10) }, { W(10), 0 }, { W(10), W(10) }, { W(-10), W(10) } };
    tuff_unit2 normals[5];
    tuff_polygon polygon = baked(vertices, 5, normals);
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(13, 0), W(5), &polygon, &c));
    ASSERT_CONTACT(W(2), ONE, 0, c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(vec(W(13), LSB), W(5), &polygon, &c));
    ASSERT_CONTACT(W(2), ONE, 0, c);
    TEST_ASSERT_FALSE(tuff_circle_polygon(whole(15, 0), W(5), &polygon, &c));
}

/* Alone, a part is a polygon like any other; internal edges are the piece's affair. */
static void test_internal_marks_do_not_change_a_single_polygon(void)
{
    tuff_polygon marked = box;
    tuff_contact c = marked_contact();
    marked.internal_edges = 15;
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(12, 3), W(5), &marked, &c));
    ASSERT_CONTACT(W(3), ONE, 0, c);
}

static void test_every_edge_and_vertex_of_the_largest_polygon_is_found(void)
{
    tuff_vec2 vertices[32];
    tuff_unit2 normals[32];
    tuff_polygon polygon = baked_largest_polygon(vertices, normals);
    for (uint8_t i = 0; i < 32; i++) {
        tuff_contact c = marked_contact();
        tuff_body body = body_on_edge(&polygon, i);
        tuff_contact out = { W(3), normals[i] };
        tuff_bounce(&body, &out);
        TEST_ASSERT_TRUE(tuff_circle_polygon(body.position, W(4), &polygon, &c));
        ASSERT_CONTACT(W(1), normals[i].x, normals[i].y, c);
        TEST_ASSERT_FALSE(tuff_circle_polygon(body.position, W(3) - 2 * LSB, &polygon, &c));
        tuff_bounce(&body, &out);
        TEST_ASSERT_FALSE(tuff_circle_polygon(body.position, W(5), &polygon, &c));
        TEST_ASSERT_TRUE(tuff_circle_polygon(vertices[i], W(1), &polygon, &c));
        ASSERT_REAL(W(1), c.overlap);
    }
}

static void test_the_limits_of_size_are_legal(void)
{
    static const tuff_vec2 vertices[4] = BOX_VERTICES(-1024, -1024, 1024, 1024);
    static const tuff_polygon polygon = { vertices, box_normals, 0, 4 };
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_circle_polygon(vec(TUFF_RATIO(4095, 2), W(1000)), W(1024), &polygon, &c));
    ASSERT_CONTACT(TUFF_RATIO(1, 2), ONE, 0, c);
    TEST_ASSERT_TRUE(tuff_circle_polygon(vec(0, 0), W(TUFF_MAX_BOUNDING_RADIUS), &polygon, &c));
    ASSERT_CONTACT(W(2473), 0, -ONE, c);
    TEST_ASSERT_FALSE(tuff_circle_polygon(whole(0, 2048), W(1024), &polygon, &c));
}

static void test_radius_out_of_range_gives_no_contact(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_circle_polygon(vec(0, 0), W(-1), &box, &c));
    TEST_ASSERT_FALSE(tuff_circle_polygon(vec(0, 0), -LSB, &box, &c));
    TEST_ASSERT_FALSE(tuff_circle_polygon(vec(0, 0), W(1450), &box, &c));
    TEST_ASSERT_FALSE(tuff_circle_polygon(vec(0, 0), LOWEST, &box, &c));
    ASSERT_UNTOUCHED(c);
}

static void test_far_centers_do_not_wrap_into_a_contact(void)
{
    tuff_contact c = marked_contact();
    for (uint8_t i = 0; i < 8; i++) TEST_ASSERT_FALSE(tuff_circle_polygon(end_of_range(i), W(1449), &wedge, &c));
    ASSERT_UNTOUCHED(c);
}

static void test_a_polygon_that_is_not_baked_gives_no_contact(void)
{
    tuff_polygon bad = box;
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_circle_polygon(vec(0, 0), W(5), NULL, &c));
    bad.count = 2;
    TEST_ASSERT_FALSE(tuff_circle_polygon(vec(0, 0), W(5), &bad, &c));
    bad.count = 0;
    TEST_ASSERT_FALSE(tuff_circle_polygon(vec(0, 0), W(5), &bad, &c));
    bad.count = 33;
    TEST_ASSERT_FALSE(tuff_circle_polygon(vec(0, 0), W(5), &bad, &c));
    bad.count = 4;
    bad.normals = NULL;
    TEST_ASSERT_FALSE(tuff_circle_polygon(vec(0, 0), W(5), &bad, &c));
    bad.normals = box_normals;
    bad.vertices = NULL;
    TEST_ASSERT_FALSE(tuff_circle_polygon(vec(0, 0), W(5), &bad, &c));
    ASSERT_UNTOUCHED(c);
}

static void test_not_a_number_gives_no_contact(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_circle_polygon(vec(NOT_A_NUMBER, 0), W(5), &box, &c));
    TEST_ASSERT_FALSE(tuff_circle_polygon(vec(0, NOT_A_NUMBER), W(5), &box, &c));
    TEST_ASSERT_FALSE(tuff_circle_polygon(vec(0, 0), NOT_A_NUMBER, &box, &c));
    TEST_ASSERT_FALSE(tuff_circle_polygon(vec(0, 0), INFINITE, &box, &c));
    TEST_ASSERT_FALSE(tuff_circle_polygon(vec(-INFINITE, 0), W(5), &box, &c));
    ASSERT_UNTOUCHED(c);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_face_pushes_along_its_normal);
    RUN_TEST(test_an_oblique_face_pushes_along_its_normal);
    RUN_TEST(test_touching_a_face_is_no_contact);
    if (IS_FIXED) RUN_TEST(test_overlap_is_judged_after_rounding);
    RUN_TEST(test_a_vertex_pushes_along_the_line_to_the_center);
    RUN_TEST(test_touching_a_vertex_is_no_contact);
    RUN_TEST(test_between_two_faces_a_circle_clear_of_the_vertex_is_clear);
    RUN_TEST(test_vertex_region_holds_down_to_the_last_bit);
    RUN_TEST(test_center_on_a_vertex_takes_the_normal_of_its_lowest_edge);
    RUN_TEST(test_center_on_an_edge_takes_its_normal_and_the_whole_radius);
    RUN_TEST(test_ties_go_to_the_lowest_edge);
    RUN_TEST(test_center_inside_goes_out_through_the_nearest_face);
    RUN_TEST(test_a_point_collides_inside_only);
    RUN_TEST(test_either_winding_gives_the_same_contact);
    RUN_TEST(test_moving_out_by_the_contact_separates);
    RUN_TEST(test_a_vertex_on_a_straight_edge_changes_nothing);
    RUN_TEST(test_internal_marks_do_not_change_a_single_polygon);
    RUN_TEST(test_every_edge_and_vertex_of_the_largest_polygon_is_found);
    RUN_TEST(test_the_limits_of_size_are_legal);
    RUN_TEST(test_radius_out_of_range_gives_no_contact);
    RUN_TEST(test_far_centers_do_not_wrap_into_a_contact);
    RUN_TEST(test_a_polygon_that_is_not_baked_gives_no_contact);
    if (!IS_FIXED) RUN_TEST(test_not_a_number_gives_no_contact);
    return UNITY_END();
}
