/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The collide calls for hulls, with and without a report. DESIGN 2 (terrainCollide and floaterCollide with hullPoly), DESIGN 4 ("a push-out
   moves the hull too"), DESIGN 7 (hull NULL or under 3 vertices: the circle). */
#include "shapes.h"

DEFINE_BOX(box, -10, -10, 10, 10);
static const tuff_terrain pieces[2] = { { { W(0), W(0) }, W(8), W(15), &box, 1 }, { { W(60), W(0) }, W(8), W(15), NULL, 0 } };
static const tuff_world world = { pieces, 2, NULL, NULL, 0, TUFF_ORDER_ITERATION };

static const tuff_vec2 hull_vertices[4] = DIAMOND_VERTICES;
static const tuff_polygon hull = { hull_vertices, NULL, 0, 4 };

void setUp(void) {}
void tearDown(void) {}

static void test_a_hull_is_pushed_out_along_a_face(void)
{
    tuff_body body = moving_body(12, 3);
    TEST_ASSERT_EQUAL_INT(1, tuff_terrain_collide(&world, &body, W(5), &hull));
    ASSERT_VEC_SAME(W(15), W(3), body.position);
    ASSERT_WITHIN(STEPS(6, 20), TUFF_RATIO(36, 100), body.velocity.x);
    ASSERT_WITHIN(STEPS(6, 20), TUFF_RATIO(594, 100), body.velocity.y);
}

static void test_a_push_moves_the_hull_too(void)
{
    for (int16_t y = -12; y <= 12; y = (int16_t)(y + 2)) {
        tuff_body body = moving_body(11, y);
        uint16_t pushes = tuff_terrain_collide(&world, &body, W(5), &hull);
        tuff_contact c = marked_contact();
        TEST_ASSERT_EQUAL_INT(1, pushes);
        if (tuff_terrain_overlap_hull(&pieces[0], body.position, W(5), &hull, &c)) ASSERT_WITHIN(STEPS(1, 50), STEPS(1, 50), c.overlap);
    }
}

/* A circle of the hull's radius would touch here; the hull does not. */
static void test_the_hull_decides_and_not_its_circle(void)
{
    tuff_body body = moving_body(13, 13);
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide(&world, &body, W(5), &hull));
    TEST_ASSERT_EQUAL_INT(1, tuff_terrain_collide(&world, &body, W(5), NULL));
}

static void test_against_an_unbaked_piece_the_radius_decides(void)
{
    tuff_body body = moving_body(54, 8);   /* 10 away: 8 and 5 reach it, 8 and 2 do not */
    TEST_ASSERT_EQUAL_INT(1, tuff_terrain_collide(&world, &body, W(5), &hull));
    ASSERT_VEC(TUFF_RATIO(522, 10), TUFF_RATIO(104, 10), body.position);
    body = moving_body(54, 8);
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide(&world, &body, W(2), &hull));
}

static void test_a_hull_with_too_few_vertices_is_the_circle(void)
{
    tuff_polygon thin = hull;
    thin.count = 2;
    for (int16_t y = -14; y <= 14; y = (int16_t)(y + 4)) {
        tuff_body one = moving_body(12, y);
        tuff_body other = one;
        TEST_ASSERT_EQUAL_INT(tuff_terrain_collide_circle(&world, &one, W(5)), tuff_terrain_collide(&world, &other, W(5), &thin));
        ASSERT_BODY_SAME(one, other);
    }
}

static void test_given_and_missing_normals_do_the_same(void)
{
    tuff_unit2 normals[4];
    tuff_polygon complete = hull;
    tuff_edge_normals(hull_vertices, 4, normals);
    complete.normals = normals;
    for (int16_t y = -14; y <= 14; y++) {
        tuff_body one = moving_body(9, y);
        tuff_body other = one;
        TEST_ASSERT_EQUAL_INT(tuff_terrain_collide(&world, &one, W(5), &hull), tuff_terrain_collide(&world, &other, W(5), &complete));
        ASSERT_BODY_SAME(one, other);
    }
}

static void test_floaters_do_what_terrain_does(void)
{
    for (int16_t x = -16; x <= 78; x = (int16_t)(x + 5)) {
        tuff_touch list[2];
        tuff_touches touches = { list, 2, 0 };
        tuff_body one = moving_body(x, 9);
        tuff_body other = one;
        tuff_body reported = one;
        uint16_t pushes = tuff_terrain_collide(&world, &one, W(5), &hull);
        TEST_ASSERT_EQUAL_INT(pushes, tuff_floater_collide(&other, W(5), pieces, 2, &hull));
        TEST_ASSERT_EQUAL_INT(pushes, tuff_floater_collide_report(&reported, W(5), pieces, 2, &hull, TUFF_ORDER_ITERATION, &touches));
        TEST_ASSERT_EQUAL_INT(pushes, touches.count);
        ASSERT_VEC_SAME(one.position.x, one.position.y, other.position);
        ASSERT_VEC_SAME(one.position.x, one.position.y, reported.position);
    }
}

static void test_floaters_may_be_taken_deepest_first(void)
{
    static const tuff_terrain pair[2] = { { { W(0), W(13) }, W(10), W(15), &box, 1 }, { { W(3), W(11) }, W(10), W(15), &box, 1 } };
    tuff_touch list[2];
    tuff_touches touches = { list, 2, 0 };
    tuff_body body = moving_body(0, -2);
    TEST_ASSERT_EQUAL_INT(1, tuff_floater_collide_report(&body, W(6), pair, 2, &hull, TUFF_ORDER_DEEPEST, &touches));
    TEST_ASSERT_EQUAL_INT(1, list[0].piece);
    ASSERT_CONTACT(W(2), 0, -ONE, list[0].contact);
    body = moving_body(0, 0);
    TEST_ASSERT_EQUAL_INT(2, tuff_floater_collide_report(&body, W(6), pair, 2, &hull, TUFF_ORDER_ITERATION, &touches));
    TEST_ASSERT_EQUAL_INT(0, list[0].piece);
    TEST_ASSERT_EQUAL_INT(1, list[1].piece);
}

static void test_null_and_bad_radius_are_no_contact(void)
{
    tuff_touches touches = { NULL, 0, 77 };
    tuff_body body = moving_body(12, 3);
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide(NULL, &body, W(5), &hull));
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide(&world, NULL, W(5), &hull));
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide(&world, &body, W(-5), &hull));
    TEST_ASSERT_EQUAL_INT(0, tuff_terrain_collide(&world, &body, W(1450), &hull));
    TEST_ASSERT_EQUAL_INT(0, tuff_floater_collide(&body, W(5), NULL, 2, &hull));
    TEST_ASSERT_EQUAL_INT(0, tuff_floater_collide(&body, W(5), pieces, 0, &hull));
    TEST_ASSERT_EQUAL_INT(0, tuff_floater_collide_report(&body, W(-5), pieces, 2, &hull, TUFF_ORDER_ITERATION, &touches));
    TEST_ASSERT_EQUAL_INT(0, touches.count);
    ASSERT_VEC_SAME(W(12), W(3), body.position);
    ASSERT_VEC_SAME(W(-4), W(6), body.velocity);
}

static void test_the_largest_hull_without_normals_collides(void)
{
    tuff_vec2 vertices[32];
    tuff_polygon large = { vertices, NULL, 0, 32 };
    tuff_body body = moving_body(22, 0);   /* its left end (-13, 1) is 1 deep in the face */
    largest_polygon(vertices);
    TEST_ASSERT_EQUAL_INT(1, tuff_terrain_collide(&world, &body, W(16), &large));
    ASSERT_VEC(W(23), 0, body.position);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_hull_is_pushed_out_along_a_face);
    RUN_TEST(test_a_push_moves_the_hull_too);
    RUN_TEST(test_the_hull_decides_and_not_its_circle);
    RUN_TEST(test_against_an_unbaked_piece_the_radius_decides);
    RUN_TEST(test_a_hull_with_too_few_vertices_is_the_circle);
    RUN_TEST(test_given_and_missing_normals_do_the_same);
    RUN_TEST(test_floaters_do_what_terrain_does);
    RUN_TEST(test_floaters_may_be_taken_deepest_first);
    RUN_TEST(test_null_and_bad_radius_are_no_contact);
    RUN_TEST(test_the_largest_hull_without_normals_collides);
    return UNITY_END();
}
