/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The collide calls for circles. DESIGN 2 (terrainCollide, floaterCollide), DESIGN 7 ("The same without a hull"). */
#include "shapes.h"

DEFINE_BOX(box, -10, -10, 10, 10);
static const tuff_terrain pieces[3] = { { { W(0), W(0) }, W(8), W(15), &box, 1 },
                                        { { W(0), W(0) }, 0, 0, NULL, 0 },
                                        { { W(60), W(0) }, W(8), W(15), NULL, 0 } };
static tuff_world world = { pieces, 3, NULL, NULL, 0, TUFF_ORDER_ITERATION };

void setUp(void)
{
    world.order = TUFF_ORDER_ITERATION;
}

void tearDown(void) {}

static void test_a_circle_is_pushed_out_of_a_polygon(void)
{
    tuff_body body = moving_body(12, 3);
    TEST_ASSERT_EQUAL_INT(1, tuff_terrain_collide_circle(&world, &body, W(5)));
    ASSERT_VEC_SAME(W(15), W(3), body.position);
    ASSERT_WITHIN(STEPS(6, 20), TUFF_RATIO(36, 100), body.velocity.x);   /* 0.09 of 4 */
    ASSERT_WITHIN(STEPS(6, 20), TUFF_RATIO(594, 100), body.velocity.y);   /* 0.99 of 6 */
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide_circle(&world, &body, W(5)));
}

static void test_a_circle_is_pushed_out_of_an_unbaked_piece(void)
{
    tuff_body body = moving_body(49, 0);
    TEST_ASSERT_EQUAL_INT(1, tuff_terrain_collide_circle(&world, &body, W(5)));
    ASSERT_VEC_SAME(W(47), W(0), body.position);
}

static void test_it_does_what_the_hull_call_does_with_null(void)
{
    for (int16_t x = -18; x < 80; x = (int16_t)(x + 3)) {
        tuff_body one = moving_body(x, (int16_t)(x % 7));
        tuff_body other = one;
        tuff_body floater = one;
        uint16_t pushes = tuff_terrain_collide_circle(&world, &one, W(5));
        TEST_ASSERT_EQUAL_INT(pushes, tuff_terrain_collide(&world, &other, W(5), NULL));
        TEST_ASSERT_EQUAL_INT(pushes, tuff_floater_collide_circle(&floater, W(5), pieces, 3));
        ASSERT_BODY_SAME(one, other);
        ASSERT_BODY_SAME(one, floater);
    }
}

static void test_the_worlds_order_is_obeyed(void)
{
    static const tuff_terrain pair[2] = { { { W(-7), W(0) }, W(10), W(10), NULL, 0 }, { { W(6), W(0) }, W(10), W(10), NULL, 0 } };
    tuff_world two = { pair, 2, NULL, NULL, 0, TUFF_ORDER_ITERATION };
    tuff_body iterated = moving_body(1, 0);
    tuff_body deepest = moving_body(1, 0);
    TEST_ASSERT_EQUAL_INT(2, tuff_terrain_collide_circle(&two, &iterated, W(5)));
    two.order = TUFF_ORDER_DEEPEST;
    TEST_ASSERT_EQUAL_INT(2, tuff_terrain_collide_circle(&two, &deepest, W(5)));
    ASSERT_VEC_SAME(W(21), 0, iterated.position);   /* 7 to the right by the first, then 13 by the second */
    ASSERT_VEC_SAME(W(-22), 0, deepest.position);   /* 10 to the left by the second, then 13 by the first */
}

static void test_floaters_are_taken_in_ascending_order_once(void)
{
    static const tuff_terrain pair[2] = { { { W(0), W(0) }, W(10), W(10), NULL, 0 }, { { W(20), W(0) }, W(10), W(10), NULL, 0 } };
    tuff_body body = moving_body(9, 0);
    TEST_ASSERT_EQUAL_INT(2, tuff_floater_collide_circle(&body, W(5), pair, 2));
    ASSERT_VEC_SAME(W(5), 0, body.position);   /* 15 by the first, 5 by the second: what still overlaps waits */
}

static void test_null_and_none_are_no_contact(void)
{
    tuff_body body = moving_body(12, 3);
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide_circle(NULL, &body, W(5)));
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide_circle(&world, NULL, W(5)));
    TEST_ASSERT_EQUAL_INT(0, tuff_floater_collide_circle(&body, W(5), NULL, 3));
    TEST_ASSERT_EQUAL_INT(0, tuff_floater_collide_circle(&body, W(5), pieces, 0));
    TEST_ASSERT_EQUAL_INT(0, tuff_floater_collide_circle(NULL, W(5), pieces, 3));
    ASSERT_VEC_SAME(W(12), W(3), body.position);
}

static void test_radius_out_of_range_is_no_contact(void)
{
    tuff_body body = moving_body(12, 3);
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide_circle(&world, &body, W(-5)));
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide_circle(&world, &body, W(1450)));
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide_circle(&world, &body, LOWEST));
    TEST_ASSERT_EQUAL_INT(0, tuff_floater_collide_circle(&body, HIGHEST, pieces, 3));
    ASSERT_VEC_SAME(W(12), W(3), body.position);
    ASSERT_VEC_SAME(W(-4), W(6), body.velocity);
}

static void test_a_point_collides(void)
{
    tuff_body body = moving_body(8, 3);
    TEST_ASSERT_EQUAL_INT(1, tuff_terrain_collide_circle(&world, &body, 0));
    ASSERT_VEC_SAME(W(10), W(3), body.position);
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide_circle(&world, &body, 0));
}

static void test_not_a_number_is_no_contact(void)
{
    tuff_body body = moving_body(12, 3);
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide_circle(&world, &body, NOT_A_NUMBER));
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide_circle(&world, &body, INFINITE));
    ASSERT_VEC_SAME(W(12), W(3), body.position);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_circle_is_pushed_out_of_a_polygon);
    RUN_TEST(test_a_circle_is_pushed_out_of_an_unbaked_piece);
    RUN_TEST(test_it_does_what_the_hull_call_does_with_null);
    RUN_TEST(test_the_worlds_order_is_obeyed);
    RUN_TEST(test_floaters_are_taken_in_ascending_order_once);
    RUN_TEST(test_null_and_none_are_no_contact);
    RUN_TEST(test_radius_out_of_range_is_no_contact);
    RUN_TEST(test_a_point_collides);
    if (!IS_FIXED) RUN_TEST(test_not_a_number_is_no_contact);
    return UNITY_END();
}
