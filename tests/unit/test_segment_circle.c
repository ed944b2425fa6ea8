/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Segment against the disc about the origin. DESIGN 2 (circle fallback of _segmentPolyIntersect), DESIGN 4 (exact, closed). */
#include "support.h"

void setUp(void) {}
void tearDown(void) {}

/* Both directions must agree: the answer does not change when the ends are swapped. */
static bool touches(tuff_vec2 a, tuff_vec2 b, tuff_real radius, UNITY_LINE_TYPE line)
{
    bool forward = tuff_segment_circle(a, b, radius);
    if (forward != tuff_segment_circle(b, a, radius)) UNITY_TEST_FAIL(line, "swapping the ends changes the answer");
    return forward;
}

#define ASSERT_HIT(a, b, r)  TEST_ASSERT_TRUE(touches((a), (b), (r), __LINE__))
#define ASSERT_MISS(a, b, r) TEST_ASSERT_FALSE(touches((a), (b), (r), __LINE__))

static void test_a_crossing_hits(void)
{
    ASSERT_HIT(whole(-20, 3), whole(20, 3), W(10));
    ASSERT_HIT(whole(-20, -15), whole(20, 12), W(10));
    ASSERT_HIT(whole(0, 40), whole(0, -40), W(10));
}

static void test_the_tangent_touches_and_one_step_off_misses(void)
{
    ASSERT_HIT(whole(-20, 10), whole(20, 10), W(10));
    ASSERT_HIT(whole(-10, 20), whole(-10, -20), W(10));
    ASSERT_MISS(vec(W(-20), W(10) + NUDGE), vec(W(20), W(10) + NUDGE), W(10));
    ASSERT_MISS(vec(W(-10) - NUDGE, W(20)), vec(W(-10) - NUDGE, W(-20)), W(10));
}

/* Through (14, 2) and (-2, 14): 10 from the origin at (6, 8). */
static void test_the_oblique_tangent_touches_and_one_step_less_radius_misses(void)
{
    ASSERT_HIT(whole(14, 2), whole(-2, 14), W(10));
    ASSERT_MISS(whole(14, 2), whole(-2, 14), W(10) - NUDGE);
    ASSERT_HIT(whole(78, -46), whole(-66, 62), W(10));
    ASSERT_MISS(whole(78, -46), whole(-66, 62), W(10) - NUDGE);
}

static void test_an_end_on_the_rim_touches(void)
{
    ASSERT_HIT(whole(6, 8), whole(12, 16), W(10));
    ASSERT_HIT(whole(10, 0), whole(30, 0), W(10));
    ASSERT_MISS(vec(W(10) + NUDGE, 0), whole(30, 0), W(10));
    ASSERT_MISS(vec(W(6) + NUDGE, W(8) + NUDGE), whole(12, 16), W(10));
}

static void test_a_line_that_would_hit_but_ends_before_misses(void)
{
    ASSERT_MISS(whole(40, 5), whole(11, 5), W(10));
    ASSERT_MISS(whole(-40, -30), whole(-9, -9), W(10));
    ASSERT_MISS(whole(11, 8), whole(40, -30), W(10));
}

static void test_a_segment_inside_hits(void)
{
    ASSERT_HIT(whole(-3, 1), whole(2, 2), W(10));
    ASSERT_HIT(whole(0, 0), whole(40, 0), W(10));
}

static void test_zero_length_is_a_point_test(void)
{
    ASSERT_HIT(whole(3, 4), whole(3, 4), W(10));
    ASSERT_HIT(whole(6, 8), whole(6, 8), W(10));
    ASSERT_HIT(vec(0, 0), vec(0, 0), W(10));
    ASSERT_MISS(whole(8, 8), whole(8, 8), W(10));
    ASSERT_MISS(vec(W(6) + NUDGE, W(8)), vec(W(6) + NUDGE, W(8)), W(10));
}

static void test_a_disc_without_radius_is_its_center(void)
{
    ASSERT_HIT(whole(-8, -6), whole(12, 9), 0);
    ASSERT_HIT(vec(0, 0), vec(0, 0), 0);
    ASSERT_MISS(whole(-8, -6), vec(W(12), W(9) + 4 * NUDGE), 0);
    ASSERT_MISS(whole(4, 3), whole(12, 9), 0);
}

static void test_differences_of_33_bits_do_not_wrap(void)
{
    ASSERT_HIT(vec(LOWEST, W(5)), vec(HIGHEST, W(5)), W(10));
    ASSERT_HIT(vec(LOWEST, W(10)), vec(HIGHEST, W(10)), W(10));
    ASSERT_HIT(vec(W(-10), HIGHEST), vec(W(-10), LOWEST), W(10));
    ASSERT_MISS(vec(LOWEST, W(11)), vec(HIGHEST, W(11)), W(10));
    ASSERT_MISS(vec(W(-11), HIGHEST), vec(W(-11), LOWEST), W(10));
    ASSERT_HIT(vec(LOWEST, LOWEST), vec(HIGHEST, HIGHEST), W(1));
    ASSERT_HIT(vec(LOWEST, HIGHEST), vec(HIGHEST, LOWEST), W(1));
    ASSERT_MISS(vec(LOWEST, LOWEST), vec(HIGHEST, LOWEST), W(1449));
    ASSERT_MISS(vec(LOWEST, HIGHEST), vec(LOWEST, LOWEST), W(1449));
}

/* Exact for every representable end: across the whole range, lines that pass the origin by less than one step. */
static void test_the_longest_lines_are_judged_exactly(void)
{
    ASSERT_HIT(vec(LOWEST, W(10)), vec(HIGHEST, W(10)), W(10));
    ASSERT_MISS(vec(LOWEST, W(10) + LSB), vec(HIGHEST, W(10) + LSB), W(10));
    ASSERT_HIT(vec(LOWEST, W(10) + LSB), vec(HIGHEST, W(10) - LSB), W(10));
    ASSERT_HIT(vec(LOWEST + LSB, LOWEST + LSB), vec(HIGHEST, HIGHEST), 0);
    ASSERT_HIT(vec(LOWEST, LOWEST), vec(HIGHEST, HIGHEST), 0);
    ASSERT_MISS(vec(LOWEST + LSB, LOWEST), vec(HIGHEST, HIGHEST), 0);
    ASSERT_HIT(vec(LOWEST + LSB, LOWEST), vec(HIGHEST, HIGHEST), LSB);
}

static void test_radius_out_of_range_misses(void)
{
    ASSERT_MISS(whole(-20, 0), whole(20, 0), W(-1));
    ASSERT_MISS(whole(-20, 0), whole(20, 0), -LSB);
    ASSERT_MISS(whole(-20, 0), whole(20, 0), W(1450));
    ASSERT_MISS(whole(-20, 0), whole(20, 0), LOWEST);
}

static void test_not_a_number_misses(void)
{
    ASSERT_MISS(vec(NOT_A_NUMBER, 0), whole(20, 0), W(10));
    ASSERT_MISS(vec(0, NOT_A_NUMBER), whole(0, 0), W(10));
    ASSERT_MISS(vec(INFINITE, 0), whole(0, 0), W(10));
    ASSERT_MISS(whole(-20, 0), whole(20, 0), NOT_A_NUMBER);
    ASSERT_MISS(whole(-20, 0), whole(20, 0), INFINITE);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_crossing_hits);
    RUN_TEST(test_the_tangent_touches_and_one_step_off_misses);
    RUN_TEST(test_the_oblique_tangent_touches_and_one_step_less_radius_misses);
    RUN_TEST(test_an_end_on_the_rim_touches);
    RUN_TEST(test_a_line_that_would_hit_but_ends_before_misses);
    RUN_TEST(test_a_segment_inside_hits);
    RUN_TEST(test_zero_length_is_a_point_test);
    RUN_TEST(test_a_disc_without_radius_is_its_center);
    RUN_TEST(test_differences_of_33_bits_do_not_wrap);
    if (IS_FIXED) RUN_TEST(test_the_longest_lines_are_judged_exactly);
    RUN_TEST(test_radius_out_of_range_misses);
    if (!IS_FIXED) RUN_TEST(test_not_a_number_misses);
    return UNITY_END();
}
