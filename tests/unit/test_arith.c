/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The inner arithmetic (arith.h), against exact 64-bit integers: square root, direction, fractions of beams. DESIGN 4 ("Fixed build:
   widen before the product", "narrow once, to nearest, symmetric about zero"). */
#include "support.h"

#include "arith.h"

void setUp(void) {}
void tearDown(void) {}

/* ------------------------------------------------------------------------------------------ normalization, exactly */

static int64_t size64(int64_t a)
{
    return a < 0 ? -a : a;
}

/* The bounds in 1/1024 of 2^-30: 0.75 in the fixed build, with 2 for the reckoning here; 2^-23 in the float build. */
#define DIRECTION_BOUND EITHER(INT64_C(770), INT64_C(131072) + 512)

/* With d the direction found, v the vector and L its length: the error across is v x d / L, the error in length (d . d - 1) / 2.
   Turned back into x and y they are the errors of the components. */
static bool direction_ok(int64_t x, int64_t y, int64_t length, int64_t dx, int64_t dy)
{
    int64_t across = (x * dy - y * dx) * 1024 / length;
    int64_t along = (dx * dx + dy * dy - ((int64_t)1 << 60)) / ((int64_t)1 << 21);
    int64_t error_x = (along * dx - across * dy) / ((int64_t)1 << 30);
    int64_t error_y = (along * dy + across * dx) / ((int64_t)1 << 30);
    return size64(error_x) <= DIRECTION_BOUND && size64(error_y) <= DIRECTION_BOUND;
}

/* To nearest in the fixed build: (2 L - 1)^2 <= 4 v . v <= (2 L + 1)^2; two roundings of 2^-24 in the float build and that to LSB. */
static bool length_ok(int64_t x, int64_t y, int64_t length)
{
    uint64_t square = 4 * ((uint64_t)(x * x) + (uint64_t)(y * y));
    int64_t slack = EITHER(1, 2 + length / 4194304);
    uint64_t low = (uint64_t)(2 * length - slack);
    uint64_t high = (uint64_t)(2 * length + slack);
    return low * low <= square && square <= high * high;
}

/* Shows the vector's bits: with them the case can be repeated alone. */
static void expect_normalized(int32_t raw_x, int32_t raw_y)
{
    tuff_vec2 v = vec(tuff_from_q16_16(raw_x), tuff_from_q16_16(raw_y));
    int64_t x = tuff_to_q16_16(v.x);
    int64_t y = tuff_to_q16_16(v.y);
    tuff_unit2 d = { ONE, ONE };
    int64_t length = tuff_to_q16_16(tuff_normalize(v, &d));
    if (length > 0 && length_ok(x, y, length) && direction_ok(x, y, length, UNIT_BITS_OF(d.x), UNIT_BITS_OF(d.y))) return;
    UnityPrint("vector in 1/65536: ");
    UnityPrintNumber(raw_x);
    UnityPrint(" ");
    UnityPrintNumber(raw_y);
    UNITY_PRINT_EOL();
    TEST_FAIL_MESSAGE("length or direction beyond its bound");
}

static void test_every_small_vector_is_normalized_within_the_bound(void)
{
    for (int16_t x = -20; x <= 20; x++) {
        for (int16_t y = -20; y <= 20; y++) {
            if (x != 0 || y != 0) expect_normalized(x, y);
        }
    }
}

/* Strata: each power of two to 2^30 for the larger component, sixteen slopes and the ends of the octant. */
static void test_every_magnitude_is_normalized_within_the_bound(void)
{
    uint32_t random = UINT32_C(20260101);
    for (uint8_t bits = 0; bits < 30; bits++) {
        int32_t top = (int32_t)1 << bits;
        for (uint8_t i = 0; i < 16; i++) {
            int32_t major = top + (int32_t)(next_random(&random) & (uint32_t)(top - 1));
            int32_t minor = (int32_t)((int64_t)major * (2 * i + (int32_t)(next_random(&random) & 1)) / 32);
            expect_normalized(i & 1 ? -major : major, i & 2 ? -minor : minor);
            expect_normalized(i & 4 ? -minor : minor, i & 8 ? -major : major);
        }
        expect_normalized(top, top);
        expect_normalized(-top, 1);
        expect_normalized(2 * (top - 1) + 1, -top);
    }
}

static void test_axes_are_exact(void)
{
    for (uint8_t bits = 0; bits < 31; bits++) {
        tuff_unit2 d = { 0, 0 };
        tuff_real size = tuff_from_q16_16((int32_t)1 << bits);
        ASSERT_SAME(size, tuff_normalize(vec(size, 0), &d));
        ASSERT_VEC_SAME(ONE, 0, d);
        ASSERT_SAME(size, tuff_normalize(vec(-size, 0), &d));
        ASSERT_VEC_SAME(-ONE, 0, d);
        ASSERT_SAME(size, tuff_normalize(vec(0, size), &d));
        ASSERT_VEC_SAME(0, ONE, d);
        ASSERT_SAME(size, tuff_normalize(vec(0, -size), &d));
        ASSERT_VEC_SAME(0, -ONE, d);
    }
}

static void test_directions_are_symmetric_about_zero(void)
{
    uint32_t random = UINT32_C(77);
    for (uint8_t i = 0; i < 64; i++) {
        tuff_vec2 v;
        v.x = tuff_from_q16_16((int32_t)(next_random(&random) >> 8));
        v.y = tuff_from_q16_16((int32_t)(next_random(&random) >> (8 + i % 16)));
        tuff_unit2 d = { 0, 0 };
        tuff_unit2 mirrored = { 0, 0 };
        tuff_unit2 turned = { 0, 0 };
        tuff_real length = tuff_normalize(v, &d);
        ASSERT_SAME(length, tuff_normalize(vec(-v.x, v.y), &mirrored));
        ASSERT_SAME(length, tuff_normalize(vec(-v.y, v.x), &turned));
        ASSERT_VEC_SAME(-d.x, d.y, mirrored);
        ASSERT_VEC_SAME(-d.y, d.x, turned);
    }
}

static void test_a_zero_vector_has_no_direction(void)
{
    tuff_unit2 d = { ONE, -ONE };
    ASSERT_SAME(0, tuff_normalize(vec(0, 0), &d));
    ASSERT_VEC_SAME(ONE, -ONE, d);
}

/* ---------------------------------------------------------------------------------------------- products, narrowed */

static void test_narrowing_rounds_to_nearest_symmetrically(void)
{
    tuff_wide half = tuff_widen(LSB) / 2;
    ASSERT_SAME(EITHER(LSB, LSB / 2), tuff_narrow(half));
    ASSERT_SAME(EITHER(-LSB, -LSB / 2), tuff_narrow(-half));
    ASSERT_SAME(0, EITHER(tuff_narrow(half - 1), 0));
    ASSERT_SAME(0, EITHER(tuff_narrow(1 - half), 0));
    ASSERT_SAME(W(-1024), tuff_narrow(tuff_widen(W(-1024))));
    ASSERT_SAME(HIGHEST, tuff_narrow(tuff_widen(HIGHEST)));
    ASSERT_SAME(LOWEST, tuff_narrow(tuff_widen(LOWEST)));
}

static void test_a_push_at_the_edge_of_the_range_saturates(void)
{
    ASSERT_SAME(HIGHEST, tuff_pushed(HIGHEST, LSB, ONE));
    ASSERT_SAME(HIGHEST, tuff_pushed(W(32700), W(2473), ONE));
    ASSERT_SAME(LOWEST, tuff_pushed(LOWEST, LSB, -ONE));
    ASSERT_SAME(LOWEST, tuff_pushed(W(-32700), W(2473), -ONE));
    ASSERT_SAME(W(32703), tuff_pushed(W(32700), W(6), TUFF_UNIT_RATIO(1, 2)));
}

static void test_floor_and_ceiling_bracket_both_signs(void)
{
    TEST_ASSERT_EQUAL_INT32(-1, tuff_floor(-LSB));
    TEST_ASSERT_EQUAL_INT32(0, tuff_floor(W(1) - LSB));
    TEST_ASSERT_EQUAL_INT32(-3, tuff_floor(W(-3)));
    TEST_ASSERT_EQUAL_INT32(-32768, tuff_floor(LOWEST));
    TEST_ASSERT_EQUAL_INT32(0, tuff_ceil(-LSB));
    TEST_ASSERT_EQUAL_INT32(1, tuff_ceil(LSB));
    TEST_ASSERT_EQUAL_INT32(3, tuff_ceil(W(3)));
    TEST_ASSERT_EQUAL_INT32(INT32_C(32768), tuff_ceil(HIGHEST));
}

static void test_the_difference_of_positions_does_not_wrap(void)
{
    tuff_vec2 offset = whole(7, 7);
    TEST_ASSERT_FALSE(tuff_offset_within(vec(LOWEST, 0), vec(HIGHEST, 0), W(2898), &offset));
    TEST_ASSERT_FALSE(tuff_offset_within(vec(0, HIGHEST), vec(0, LOWEST), W(2898), &offset));
    ASSERT_VEC_SAME(W(7), W(7), offset);
    TEST_ASSERT_TRUE(tuff_offset_within(vec(HIGHEST, LOWEST), vec(HIGHEST - W(3), LOWEST + W(4)), W(6), &offset));
    ASSERT_VEC_SAME(W(3), W(-4), offset);
    TEST_ASSERT_FALSE(tuff_offset_within(whole(3, -4), vec(0, 0), W(5), &offset));
}

static void test_circles_touch_at_any_distance(void)
{
    TEST_ASSERT_TRUE(tuff_circles_touch(whole(3, -4), W(2), vec(0, 0), W(3)));
    TEST_ASSERT_FALSE(tuff_circles_touch(whole(3, -4), W(2), vec(0, 0), W(3) - LSB));
    TEST_ASSERT_FALSE(tuff_circles_touch(vec(LOWEST, LOWEST), W(1449), vec(HIGHEST, HIGHEST), W(1449)));
    TEST_ASSERT_FALSE(tuff_circles_touch(vec(LOWEST, LOWEST), HIGHEST, vec(HIGHEST, HIGHEST), W(1449)));
    TEST_ASSERT_TRUE(tuff_circles_touch(vec(LOWEST + LSB, LOWEST), HIGHEST, vec(HIGHEST, LOWEST), HIGHEST));
    TEST_ASSERT_TRUE(tuff_circles_touch(vec(LOWEST, 0), HIGHEST, vec(0, 0), W(2)));
}

static void test_squares_touch_at_any_distance(void)
{
    TEST_ASSERT_TRUE(tuff_squares_touch(whole(5, -5), W(2), vec(0, 0), W(3)));
    TEST_ASSERT_FALSE(tuff_squares_touch(whole(5, -4), W(2), vec(0, 0), W(3) - LSB));
    TEST_ASSERT_FALSE(tuff_squares_touch(whole(-4, -5), W(2), vec(0, 0), W(3) - LSB));
    TEST_ASSERT_FALSE(tuff_squares_touch(vec(LOWEST, 0), HIGHEST, vec(HIGHEST, 0), W(1449)));
    TEST_ASSERT_FALSE(tuff_squares_touch(vec(0, HIGHEST), W(1449), vec(0, LOWEST), HIGHEST));
    TEST_ASSERT_TRUE(tuff_squares_touch(vec(LOWEST + LSB, LOWEST), HIGHEST, vec(HIGHEST, LOWEST), HIGHEST));
}

static void test_the_middle_of_two_points_has_both_in_its_square(void)
{
    const tuff_vec2 ends[] = { vec(LOWEST, LOWEST), vec(HIGHEST, HIGHEST), vec(LOWEST, HIGHEST), vec(0, 0), vec(LSB, -LSB), whole(-3, 4) };
    const uint8_t count = sizeof ends / sizeof ends[0];
    for (uint8_t i = 0; i < count * count; i++) {
        tuff_vec2 a = ends[i % count];
        tuff_vec2 b = ends[i / count];
        tuff_vec2 center;
        tuff_real half = tuff_middle(a, b, &center);
        TEST_ASSERT_TRUE(tuff_squares_touch(center, half, a, 0));
        TEST_ASSERT_TRUE(tuff_squares_touch(center, half, b, 0));
    }
    tuff_vec2 center;
    TEST_ASSERT_TRUE(tuff_middle(whole(-6, 2), whole(10, 8), &center) <= W(9));
    ASSERT_WITHIN(W(1), W(2), center.x);
    ASSERT_WITHIN(W(1), W(5), center.y);
}

/* ------------------------------------------------------------------------------------------------ fractions of beams */

/* 3/7 and 1 with every number of bits that an area can have. */
static void test_ratios_are_right_for_every_size_of_their_terms(void)
{
    tuff_area unit = 1;
    for (uint8_t bits = 0; bits < 58; bits++) {
        ASSERT_WITHIN(UNIT_STEPS(1, 2), TUFF_UNIT_RATIO(3, 7), tuff_ratio(3 * unit, 7 * unit));
        ASSERT_WITHIN(UNIT_STEPS(1, 2), TUFF_UNIT_RATIO(6, 7), tuff_ratio(6 * unit, 7 * unit));
        ASSERT_SAME(ONE, tuff_ratio(7 * unit, 7 * unit));
        ASSERT_SAME(0, tuff_ratio(0, 7 * unit));
        unit *= 2;
    }
}

static bool ratio_less(tuff_area part, tuff_area whole, tuff_area other_part, tuff_area other_whole)
{
    tuff_ratio_of one = { part, whole }, other = { other_part, other_whole };
    return tuff_ratio_less(&one, &other);
}

static void test_ratios_compare_by_their_cross_products(void)
{
    tuff_area large = (tuff_area)INT32_MAX * 1048576;
    TEST_ASSERT_TRUE(ratio_less(1, 3, 2, 5));
    TEST_ASSERT_FALSE(ratio_less(2, 5, 1, 3));
    TEST_ASSERT_FALSE(ratio_less(2, 6, 1, 3));
    TEST_ASSERT_TRUE(ratio_less(large / 4, large, large / 2, large));
    TEST_ASSERT_FALSE(ratio_less(large / 2, large, large / 4, large));
    TEST_ASSERT_FALSE(ratio_less(large, large, large, large));
}

/* In the fixed build one unit in 2^51 decides. */
static void test_ratios_of_64_bit_terms_compare_exactly(void)
{
    tuff_area large = (tuff_area)INT32_MAX * 1048576;
    TEST_ASSERT_TRUE(ratio_less(large - 2, large - 1, large - 1, large));
    TEST_ASSERT_FALSE(ratio_less(large - 1, large, large - 2, large - 1));
}

/* From (-30, 8) along +x, 60 long: a circle of 10 is entered at x = -6. */
static void test_a_circle_is_entered_where_the_line_meets_its_rim(void)
{
    tuff_far2 a = tuff_far_sub(whole(-30, 8), vec(0, 0));
    tuff_far2 d = tuff_far_sub(whole(30, 8), whole(-30, 8));
    ASSERT_WITHIN(UNIT_STEPS(64, 64), TUFF_UNIT_RATIO(2, 5), tuff_circle_entry(&a, &d, W(10)));
    ASSERT_WITHIN(UNIT_STEPS(64, 64), TUFF_UNIT_RATIO(1, 2), tuff_circle_entry(&a, &d, W(8)));
    a = tuff_far_sub(vec(0, LOWEST), vec(0, 0));
    d = tuff_far_sub(vec(0, HIGHEST), vec(0, LOWEST));
    ASSERT_WITHIN(UNIT_STEPS(64, 64), TUFF_UNIT_RATIO(INT32_C(32768) - 1024, INT32_C(65536)), tuff_circle_entry(&a, &d, W(1024)));
}

static void test_directions_of_33_bits_are_unit_vectors(void)
{
    tuff_far2 d = tuff_far_sub(vec(HIGHEST, HIGHEST), vec(LOWEST, LOWEST));
    tuff_unit2 n = tuff_far_direction(&d);
    ASSERT_UNIT(HALF_ROOT, n.x);
    ASSERT_UNIT(HALF_ROOT, n.y);
    d = tuff_far_sub(vec(LOWEST, 0), vec(HIGHEST, 0));
    n = tuff_far_direction(&d);
    ASSERT_VEC_SAME(-ONE, 0, n);
    d = tuff_far_sub(vec(3 * LSB, 0), vec(0, 4 * LSB));
    n = tuff_far_direction(&d);
    ASSERT_UNIT(TUFF_UNIT_RATIO(3, 5), n.x);
    ASSERT_UNIT(TUFF_UNIT_RATIO(-4, 5), n.y);
}

static void test_a_chord_reaches_the_circle_it_touches(void)
{
    tuff_far2 d = tuff_far_sub(whole(-2, 14), whole(14, 2));   /* passes the origin 10 away, 20 long */
    tuff_far2 a = tuff_far_sub(whole(14, 2), vec(0, 0));
    tuff_area across = tuff_far_cross(&d, &a);
    TEST_ASSERT_TRUE(tuff_chord_reaches(across, &d, W(10)));
    TEST_ASSERT_TRUE(tuff_chord_reaches(-across, &d, W(10)));
    TEST_ASSERT_FALSE(tuff_chord_reaches(across, &d, W(10) - NUDGE));
    TEST_ASSERT_FALSE(tuff_chord_reaches(-across, &d, W(10) - NUDGE));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_every_small_vector_is_normalized_within_the_bound);
    RUN_TEST(test_every_magnitude_is_normalized_within_the_bound);
    RUN_TEST(test_axes_are_exact);
    RUN_TEST(test_directions_are_symmetric_about_zero);
    RUN_TEST(test_a_zero_vector_has_no_direction);
    RUN_TEST(test_narrowing_rounds_to_nearest_symmetrically);
    RUN_TEST(test_a_push_at_the_edge_of_the_range_saturates);
    RUN_TEST(test_floor_and_ceiling_bracket_both_signs);
    RUN_TEST(test_the_difference_of_positions_does_not_wrap);
    RUN_TEST(test_circles_touch_at_any_distance);
    RUN_TEST(test_squares_touch_at_any_distance);
    RUN_TEST(test_the_middle_of_two_points_has_both_in_its_square);
    RUN_TEST(test_ratios_are_right_for_every_size_of_their_terms);
    RUN_TEST(test_ratios_compare_by_their_cross_products);
    if (IS_FIXED) RUN_TEST(test_ratios_of_64_bit_terms_compare_exactly);
    RUN_TEST(test_a_circle_is_entered_where_the_line_meets_its_rim);
    RUN_TEST(test_directions_of_33_bits_are_unit_vectors);
    RUN_TEST(test_a_chord_reaches_the_circle_it_touches);
    return UNITY_END();
}
