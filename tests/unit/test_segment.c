/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A segment relative to an obstacle (inner.h). DESIGN 4 ("the answer does not change when the ends are swapped", positions in 33 bits). */
#include "support.h"

#include "inner.h"

void setUp(void) {}
void tearDown(void) {}

static tuff_beam relative(tuff_vec2 a, tuff_vec2 b, tuff_vec2 origin)
{
    tuff_beam beam;
    tuff_beam_between(&beam, a, b);
    tuff_beam_relative(&beam, tuff_vec2_flush(a), tuff_vec2_flush(b), origin);
    return beam;
}

static tuff_area across(const tuff_beam *beam)
{
    return tuff_line_across(&beam->d, &beam->a, &beam->b);
}

/* The same line the other way: d and d x a change their signs to the last bit. */
static bool reversed(const tuff_beam *one, const tuff_beam *other)
{
    return one->a.x == other->b.x && one->a.y == other->b.y && one->b.x == other->a.x && one->b.y == other->a.y &&
           one->d.x == -other->d.x && one->d.y == -other->d.y && across(one) == -across(other);
}

static void test_swapped_ends_make_the_same_beam_the_other_way(void)
{
    static const int8_t ends[][4] = { { 1, 2, 30, 4 }, { 30, 4, -7, -9 }, { 5, 5, 5, -5 }, { -3, 8, 3, 8 }, { 6, 6, 6, 6 } };
    for (uint8_t i = 0; i < 5; i++) {
        tuff_vec2 a = vec(TUFF_RATIO(ends[i][0], 3), TUFF_RATIO(ends[i][1], 3));
        tuff_vec2 b = vec(TUFF_RATIO(ends[i][2], 7), TUFF_RATIO(ends[i][3], 7));
        tuff_beam one = relative(a, b, whole(11, -12));
        tuff_beam other = relative(b, a, whole(11, -12));
        TEST_ASSERT_TRUE(reversed(&one, &other));
    }
}

static void test_ends_are_relative_to_the_obstacle(void)
{
    tuff_beam beam = relative(whole(100, 50), whole(130, 90), whole(110, 60));
    TEST_ASSERT_TRUE(beam.a.x == W(-10) && beam.a.y == W(-10));
    TEST_ASSERT_TRUE(beam.b.x == W(20) && beam.b.y == W(30));
    TEST_ASSERT_TRUE(beam.d.x == W(30) && beam.d.y == W(40));
}

static void test_differences_have_33_bits(void)
{
    tuff_beam beam = relative(vec(LOWEST, HIGHEST), vec(HIGHEST, LOWEST), vec(HIGHEST, HIGHEST));
    TEST_ASSERT_TRUE(beam.d.x == (test_wide)HIGHEST - LOWEST);
    TEST_ASSERT_TRUE(beam.d.y == (test_wide)LOWEST - HIGHEST);
    TEST_ASSERT_TRUE(beam.a.x == (test_wide)LOWEST - HIGHEST && beam.a.y == 0);
    TEST_ASSERT_TRUE(beam.b.x == 0 && beam.b.y == (test_wide)LOWEST - HIGHEST);
}

/* d x a is positive where the obstacle lies to the right of the beam, and 0 where the line meets it. */
static void test_across_tells_the_side_on_which_the_obstacle_lies(void)
{
    tuff_beam beam = relative(whole(0, 5), whole(30, 5), whole(10, 0));
    TEST_ASSERT_TRUE(across(&beam) > 0);
    beam = relative(whole(0, -5), whole(30, -5), whole(10, 0));
    TEST_ASSERT_TRUE(across(&beam) < 0);
    beam = relative(whole(0, -5), whole(30, 25), whole(10, 5));
    TEST_ASSERT_TRUE(across(&beam) == 0);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_swapped_ends_make_the_same_beam_the_other_way);
    RUN_TEST(test_ends_are_relative_to_the_obstacle);
    RUN_TEST(test_differences_have_33_bits);
    RUN_TEST(test_across_tells_the_side_on_which_the_obstacle_lies);
    return UNITY_END();
}
