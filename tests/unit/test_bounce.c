/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Push-out and bounce. DESIGN 2 (_applyBounce, materials), DESIGN 4 (push-out always, velocity only inwards, toward zero, saturation). */
#include "shapes.h"

static const tuff_material elastic = { W(1), 0 };
static const tuff_material dead = { 0, 0 };

void setUp(void) {}
void tearDown(void) {}

static tuff_contact contact_of(tuff_real overlap, tuff_unit nx, tuff_unit ny)
{
    tuff_contact c;
    c.overlap = overlap;
    c.normal.x = nx;
    c.normal.y = ny;
    return c;
}

static void test_the_body_moves_by_overlap_times_normal(void)
{
    tuff_body body = body_of(whole(100, -50), whole(0, 0), NULL);
    tuff_contact c = contact_of(W(10), TUFF_UNIT_RATIO(3, 5), TUFF_UNIT_RATIO(-4, 5));
    tuff_bounce(&body, &c);
    ASSERT_WITHIN(STEPS(1, 20), W(106), body.position.x);
    ASSERT_WITHIN(STEPS(1, 20), W(-58), body.position.y);
    ASSERT_VEC_SAME(0, 0, body.velocity);
}

static void test_a_body_moving_outward_is_pushed_but_keeps_its_velocity(void)
{
    tuff_body body = body_of(whole(0, 0), vec(TUFF_RATIO(17, 3), LSB), NULL);
    tuff_contact c = contact_of(W(2), 0, ONE);
    tuff_bounce(&body, &c);
    ASSERT_VEC_SAME(0, W(2), body.position);
    ASSERT_VEC_SAME(TUFF_RATIO(17, 3), LSB, body.velocity);
}

static void test_a_body_moving_along_the_surface_keeps_its_velocity(void)
{
    tuff_body body = body_of(whole(0, 0), vec(TUFF_RATIO(-17, 3), 0), NULL);
    tuff_contact c = contact_of(W(2), 0, ONE);
    tuff_bounce(&body, &c);
    ASSERT_VEC_SAME(TUFF_RATIO(-17, 3), 0, body.velocity);
    body.velocity = vec(0, TUFF_RATIO(17, 3));
    c = contact_of(W(2), -ONE, 0);
    tuff_bounce(&body, &c);
    ASSERT_VEC_SAME(0, TUFF_RATIO(17, 3), body.velocity);
}

static void test_the_default_material_is_nearly_inelastic(void)
{
    tuff_body body = body_of(whole(0, 0), whole(10, -10), NULL);
    tuff_contact c = contact_of(W(1), 0, ONE);
    ASSERT_SAME(TUFF_RATIO(109 - 100, 100), tuff_default_material.restitution);
    ASSERT_SAME(TUFF_RATIO(1, 100), tuff_default_material.friction);
    tuff_bounce(&body, &c);
    ASSERT_WITHIN(STEPS(6, 20), TUFF_RATIO(99, 10), body.velocity.x);
    ASSERT_WITHIN(STEPS(6, 20), TUFF_RATIO(9, 10), body.velocity.y);
}

static void test_a_bodys_own_material_overrides_the_default(void)
{
    static const tuff_material own = { TUFF_RATIO(1, 2), TUFF_RATIO(1, 4) };
    tuff_body body = body_of(whole(0, 0), whole(-8, 12), &own);
    tuff_contact c = contact_of(W(1), 0, -ONE);
    tuff_bounce(&body, &c);
    ASSERT_REAL(W(-6), body.velocity.x);
    ASSERT_REAL(W(-6), body.velocity.y);
}

/* v = (-5, 10), n = (3, 4) / 5: v . n = 5 is outward; its opposite is inward. Tangent (4, -3) / 5: v . t = -10. */
static void test_normal_and_tangential_parts_obey_their_formulas(void)
{
    static const tuff_material half = { TUFF_RATIO(1, 2), TUFF_RATIO(1, 2) };
    tuff_body body = body_of(whole(0, 0), whole(5, -10), &half);
    tuff_contact c = contact_of(W(1), TUFF_UNIT_RATIO(3, 5), TUFF_UNIT_RATIO(4, 5));
    tuff_bounce(&body, &c);   /* normal 5 -> out 2.5, tangential 10 -> 5 */
    ASSERT_WITHIN(STEPS(1, 10), TUFF_RATIO(11, 2), body.velocity.x);
    ASSERT_WITHIN(STEPS(1, 10), W(-1), body.velocity.y);
}

static void test_no_restitution_leaves_the_tangential_part_alone(void)
{
    tuff_body body = body_of(whole(0, 0), whole(7, -9), &dead);
    tuff_contact c = contact_of(W(1), 0, ONE);
    tuff_bounce(&body, &c);
    ASSERT_VEC_SAME(W(7), 0, body.velocity);
}

static void test_full_friction_stops_the_tangential_part(void)
{
    static const tuff_material sticky = { W(1), W(1) };
    tuff_body body = body_of(whole(0, 0), whole(7, -9), &sticky);
    tuff_contact c = contact_of(W(1), 0, ONE);
    tuff_bounce(&body, &c);
    ASSERT_VEC_SAME(0, W(9), body.velocity);
}

static void test_a_bumper_adds_speed_up_to_the_limit(void)
{
    static const tuff_material bumper = { W(4), 0 };
    tuff_body body = body_of(whole(0, 0), whole(0, -100), &bumper);
    tuff_contact c = contact_of(W(1), 0, ONE);
    tuff_bounce(&body, &c);
    ASSERT_VEC_SAME(0, W(400), body.velocity);
    body.velocity = whole(1024, -1024);
    tuff_bounce(&body, &c);
    ASSERT_VEC_SAME(W(1024), W(1024), body.velocity);
    body.velocity = whole(-1024, -1024);
    c = contact_of(W(1), HALF_ROOT, HALF_ROOT);
    tuff_bounce(&body, &c);
    ASSERT_VEC_SAME(W(1024), W(1024), body.velocity);
}

static void test_material_values_are_clamped_to_their_limits(void)
{
    static const tuff_material wild = { W(100), W(-3) };
    static const tuff_material other = { W(-1), W(7) };
    tuff_body body = body_of(whole(0, 0), whole(5, -10), &wild);
    tuff_contact c = contact_of(W(1), 0, ONE);
    tuff_bounce(&body, &c);
    ASSERT_VEC_SAME(W(5), W(40), body.velocity);
    body = body_of(whole(0, 0), whole(5, -10), &other);
    tuff_bounce(&body, &c);
    ASSERT_VEC_SAME(0, 0, body.velocity);
}

/* Fixed: 1.5 steps become 1 on either side of zero. */
static void test_new_components_are_rounded_toward_zero(void)
{
    static const tuff_material half = { TUFF_RATIO(1, 2), 0 };
    tuff_body body = body_of(whole(0, 0), vec(0, -3 * LSB), &half);
    tuff_contact c = contact_of(W(1), 0, ONE);
    tuff_bounce(&body, &c);
    ASSERT_SAME(EITHER(LSB, 3 * LSB / 2), body.velocity.y);
    body.velocity = vec(0, 3 * LSB);
    c = contact_of(W(1), 0, -ONE);
    tuff_bounce(&body, &c);
    ASSERT_SAME(EITHER(-LSB, -3 * LSB / 2), body.velocity.y);
}

/* v . n = -0.6 steps: rounded to a whole step it would come out as (0, 1) steps; kept wide it is (0.28, 0.96). */
static void test_the_inward_speed_is_kept_wider_than_the_velocity(void)
{
    tuff_body body = body_of(whole(0, 0), vec(LSB, 0), &elastic);
    tuff_contact c = contact_of(W(1), TUFF_UNIT_RATIO(-3, 5), TUFF_UNIT_RATIO(4, 5));
    tuff_bounce(&body, &c);
    ASSERT_WITHIN(STEPS(0, 1), EITHER(0, LSB * 7 / 25), body.velocity.x);
    ASSERT_WITHIN(STEPS(0, 1), EITHER(0, LSB * 24 / 25), body.velocity.y);
}

/* 10^5 bounces without friction and with restitution 1: slow speeds (to 255 steps), each set afresh after 50 bounces off the 32 normals in
   random turn. Fixed: the square of the speed never grows, not by one; float: by no more than its rounding. The generator starts from
   the same seed in each run. */
static void test_slow_elastic_bounces_never_gain_energy(void)
{
    tuff_vec2 vertices[32];
    tuff_unit2 normals[32];
    uint32_t random = UINT32_C(1);
    tuff_body body = body_of(whole(0, 0), whole(0, 0), &elastic);
    test_wide energy = 0;
    largest_polygon(vertices);
    tuff_edge_normals(vertices, 32, normals);
    for (uint32_t i = 0; i < UINT32_C(100000); i++) {
        uint32_t dice = next_random(&random);
        if (i % 50 == 0) {
            body.velocity = vec(tuff_from_q16_16((int32_t)(dice >> 8 & 255) - 128), tuff_from_q16_16((int32_t)(dice >> 16 & 255) - 128));
            energy = (test_wide)body.velocity.x * body.velocity.x + (test_wide)body.velocity.y * body.velocity.y;
        }
        tuff_unit2 n = normals[dice & 31];
        tuff_contact c = contact_of(LSB, n.x, n.y);
        body.position = whole(0, 0);
        tuff_bounce(&body, &c);
        test_wide now = (test_wide)body.velocity.x * body.velocity.x + (test_wide)body.velocity.y * body.velocity.y;
        if (now > energy + EITHER(0, energy * 1e-6f)) TEST_FAIL_MESSAGE("energy gained");
        energy = now;
    }
}

static void test_a_push_at_the_edge_of_the_range_saturates(void)
{
    tuff_body body = body_of(vec(HIGHEST - LSB, LOWEST), whole(0, 0), NULL);
    tuff_contact c = contact_of(W(100), ONE, 0);
    tuff_bounce(&body, &c);
    ASSERT_VEC_SAME(HIGHEST, LOWEST, body.position);
    c = contact_of(W(2473), 0, -ONE);
    tuff_bounce(&body, &c);
    ASSERT_VEC_SAME(HIGHEST, LOWEST, body.position);
}

static void test_null_is_no_contact(void)
{
    tuff_body body = body_of(whole(1, 2), whole(3, -4), NULL);
    tuff_contact c = contact_of(W(1), 0, ONE);
    tuff_bounce(&body, NULL);
    tuff_bounce(NULL, &c);
    ASSERT_VEC_SAME(W(1), W(2), body.position);
    ASSERT_VEC_SAME(W(3), W(-4), body.velocity);
}

/* Fixed: clamped where it is used. Float: beyond the limit is as bad as NaN, the body stays as it is. */
static void test_speeds_beyond_the_limit_are_clamped_or_refused(void)
{
    tuff_body body = body_of(whole(0, 0), whole(0, -3000), &elastic);
    tuff_contact c = contact_of(W(1), 0, ONE);
    tuff_bounce(&body, &c);
    ASSERT_VEC_SAME(0, EITHER(W(1), 0), body.position);
    ASSERT_VEC_SAME(0, EITHER(W(1024), W(-3000)), body.velocity);
}

static void test_a_body_that_is_not_a_number_is_left_alone(void)
{
    static const uint32_t bad[] = { UINT32_C(0x7fc00000), UINT32_C(0x7f800000), UINT32_C(0xff800000), UINT32_C(0x47800000) };   /* 65536 */
    tuff_contact c = contact_of(W(1), 0, ONE);
    for (uint8_t i = 0; i < 16; i++) {
        tuff_real value = real_from_bits(bad[i / 4]);
        tuff_real number[4] = { W(1), W(2), W(3), W(-4) };
        number[i % 4] = value;
        tuff_body body = body_of(vec(number[0], number[1]), vec(number[2], number[3]), NULL);
        tuff_body before = body;
        tuff_bounce(&body, &c);
        TEST_ASSERT_EQUAL_MEMORY(&before, &body, sizeof body);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_body_moves_by_overlap_times_normal);
    RUN_TEST(test_a_body_moving_outward_is_pushed_but_keeps_its_velocity);
    RUN_TEST(test_a_body_moving_along_the_surface_keeps_its_velocity);
    RUN_TEST(test_the_default_material_is_nearly_inelastic);
    RUN_TEST(test_a_bodys_own_material_overrides_the_default);
    RUN_TEST(test_normal_and_tangential_parts_obey_their_formulas);
    RUN_TEST(test_no_restitution_leaves_the_tangential_part_alone);
    RUN_TEST(test_full_friction_stops_the_tangential_part);
    RUN_TEST(test_a_bumper_adds_speed_up_to_the_limit);
    RUN_TEST(test_material_values_are_clamped_to_their_limits);
    RUN_TEST(test_new_components_are_rounded_toward_zero);
    RUN_TEST(test_the_inward_speed_is_kept_wider_than_the_velocity);
    RUN_TEST(test_slow_elastic_bounces_never_gain_energy);
    RUN_TEST(test_a_push_at_the_edge_of_the_range_saturates);
    RUN_TEST(test_null_is_no_contact);
    RUN_TEST(test_speeds_beyond_the_limit_are_clamped_or_refused);
    if (!IS_FIXED) RUN_TEST(test_a_body_that_is_not_a_number_is_left_alone);
    return UNITY_END();
}
