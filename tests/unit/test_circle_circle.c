/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Circle against circle. DESIGN 2 (_circleCircleOverlap), DESIGN 4 (touching, coincident circles, normals). */
#include "support.h"

void setUp(void) {}
void tearDown(void) {}

static void test_touching_circles_do_not_collide(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_circle_circle(whole(30, 0), W(10), W(20), &c));
    TEST_ASSERT_FALSE(tuff_circle_circle(whole(0, -30), W(20), W(10), &c));
    TEST_ASSERT_FALSE(tuff_circle_circle(whole(18, 24), W(25), W(5), &c));
    ASSERT_UNTOUCHED(c);
}

static void test_one_step_closer_than_touching_collides(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_circle_circle(vec(W(30) - LSB, 0), W(10), W(20), &c));
    ASSERT_WITHIN(STEPS(0, 2), LSB, c.overlap);
    TEST_ASSERT_TRUE(tuff_circle_circle(vec(0, W(-30) + LSB), W(10), W(20), &c));
    ASSERT_WITHIN(STEPS(0, 2), LSB, c.overlap);
}

static void test_normal_points_away_from_the_obstacle(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_circle_circle(whole(3, 4), W(2), W(6), &c));
    ASSERT_CONTACT(W(3), TUFF_UNIT_RATIO(3, 5), TUFF_UNIT_RATIO(4, 5), c);
    TEST_ASSERT_TRUE(tuff_circle_circle(whole(-3, -4), W(2), W(6), &c));
    ASSERT_CONTACT(W(3), TUFF_UNIT_RATIO(-3, 5), TUFF_UNIT_RATIO(-4, 5), c);
    TEST_ASSERT_TRUE(tuff_circle_circle(whole(0, 5), W(2), W(6), &c));
    ASSERT_CONTACT(W(3), 0, ONE, c);
}

static void test_coincident_circles_go_out_along_plus_x_by_the_full_depth(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_circle_circle(vec(0, 0), W(7), W(9), &c));
    ASSERT_SAME(W(16), c.overlap);
    ASSERT_SAME(ONE, c.normal.x);
    ASSERT_SAME(0, c.normal.y);
}

static void test_centers_one_step_apart_have_a_unit_normal(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_circle_circle(vec(0, -LSB), W(7), W(9), &c));
    ASSERT_CONTACT(W(16) - LSB, 0, -ONE, c);
    TEST_ASSERT_TRUE(tuff_circle_circle(vec(3 * LSB, 4 * LSB), W(7), W(9), &c));
    ASSERT_CONTACT(W(16) - 5 * LSB, TUFF_UNIT_RATIO(3, 5), TUFF_UNIT_RATIO(4, 5), c);
}

static void test_points_without_radius_do_not_collide(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_circle_circle(vec(0, 0), 0, 0, &c));
    TEST_ASSERT_FALSE(tuff_circle_circle(vec(LSB, 0), 0, 0, &c));
    TEST_ASSERT_FALSE(tuff_circle_circle(whole(0, 5), 0, W(5), &c));
    ASSERT_UNTOUCHED(c);
    TEST_ASSERT_TRUE(tuff_circle_circle(whole(0, 4), 0, W(5), &c));
    ASSERT_CONTACT(W(1), 0, ONE, c);
}

/* sqrt(32) = 5.66: 0.34 LSB short of 6 is no overlap after rounding; sqrt(50) = 7.07: 0.93 LSB is one. */
static void test_overlap_is_judged_after_rounding(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_circle_circle(vec(4 * LSB, 4 * LSB), 2 * LSB, 4 * LSB, &c));
    ASSERT_UNTOUCHED(c);
    TEST_ASSERT_TRUE(tuff_circle_circle(vec(5 * LSB, -5 * LSB), 4 * LSB, 4 * LSB, &c));
    ASSERT_SAME(LSB, c.overlap);
}

static void test_radii_out_of_range_give_no_contact(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_circle_circle(vec(0, 0), W(-1), W(5), &c));
    TEST_ASSERT_FALSE(tuff_circle_circle(vec(0, 0), W(5), W(-1), &c));
    TEST_ASSERT_FALSE(tuff_circle_circle(vec(0, 0), W(1450), W(5), &c));
    TEST_ASSERT_FALSE(tuff_circle_circle(vec(0, 0), W(5), W(1450), &c));
    TEST_ASSERT_FALSE(tuff_circle_circle(vec(0, 0), HIGHEST, HIGHEST, &c));
    TEST_ASSERT_FALSE(tuff_circle_circle(vec(0, 0), LOWEST, W(5), &c));
    ASSERT_UNTOUCHED(c);
}

static void test_largest_radii_are_legal(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_circle_circle(whole(0, 2000), W(TUFF_MAX_BOUNDING_RADIUS), W(TUFF_MAX_BOUNDING_RADIUS), &c));
    ASSERT_CONTACT(W(898), 0, ONE, c);
    TEST_ASSERT_TRUE(tuff_circle_circle(whole(1200, -1600), W(1024), W(1024), &c));
    ASSERT_WITHIN(STEPS(1, 250), W(48), c.overlap);
    ASSERT_UNIT(TUFF_UNIT_RATIO(3, 5), c.normal.x);
    ASSERT_UNIT(TUFF_UNIT_RATIO(-4, 5), c.normal.y);
}

static void test_far_centers_do_not_wrap_into_a_contact(void)
{
    static const tuff_real ends[] = { LOWEST, HIGHEST, 0 };
    tuff_contact c = marked_contact();
    for (uint8_t i = 0; i < 8; i++) TEST_ASSERT_FALSE(tuff_circle_circle(vec(ends[i / 3], ends[i % 3]), W(1449), W(1449), &c));
    ASSERT_UNTOUCHED(c);
}

static void test_not_a_number_gives_no_contact(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_circle_circle(vec(NOT_A_NUMBER, 0), W(5), W(5), &c));
    TEST_ASSERT_FALSE(tuff_circle_circle(vec(0, NOT_A_NUMBER), W(5), W(5), &c));
    TEST_ASSERT_FALSE(tuff_circle_circle(vec(0, 0), NOT_A_NUMBER, W(5), &c));
    TEST_ASSERT_FALSE(tuff_circle_circle(vec(0, 0), W(5), NOT_A_NUMBER, &c));
    TEST_ASSERT_FALSE(tuff_circle_circle(vec(INFINITE, 0), W(5), W(5), &c));
    TEST_ASSERT_FALSE(tuff_circle_circle(vec(0, 0), INFINITE, W(5), &c));
    ASSERT_UNTOUCHED(c);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_touching_circles_do_not_collide);
    RUN_TEST(test_one_step_closer_than_touching_collides);
    RUN_TEST(test_normal_points_away_from_the_obstacle);
    RUN_TEST(test_coincident_circles_go_out_along_plus_x_by_the_full_depth);
    RUN_TEST(test_centers_one_step_apart_have_a_unit_normal);
    RUN_TEST(test_points_without_radius_do_not_collide);
    if (IS_FIXED) RUN_TEST(test_overlap_is_judged_after_rounding);
    RUN_TEST(test_radii_out_of_range_give_no_contact);
    RUN_TEST(test_largest_radii_are_legal);
    RUN_TEST(test_far_centers_do_not_wrap_into_a_contact);
    if (!IS_FIXED) RUN_TEST(test_not_a_number_gives_no_contact);
    return UNITY_END();
}
