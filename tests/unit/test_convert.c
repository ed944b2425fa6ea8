/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Literals and converters (scalar_*.h, convert.h): rounding, signs, saturation. DESIGN 4, "Literals". */
#include "support.h"

/* Constant expressions: usable in a static initializer, or this file does not compile. */
static const tuff_real real_literal = TUFF_REAL(12.5);
static const tuff_unit unit_literal = TUFF_UNIT(0.625);
static const tuff_material material_literal = { TUFF_RATIO(109 - 100, 100), TUFF_RATIO(1, 100) };

void setUp(void) {}
void tearDown(void) {}

static void test_real_literals_are_static_initializers_with_24_bits(void)
{
    ASSERT_SAME(TUFF_RATIO(25, 2), real_literal);
    ASSERT_SAME(TUFF_UNIT_RATIO(5, 8), unit_literal);
    ASSERT_SAME(TUFF_RATIO(-25, 2), TUFF_REAL(-12.5));
    ASSERT_SAME(TUFF_UNIT_RATIO(-5, 8), TUFF_UNIT(-0.625));
    TEST_ASSERT_EQUAL_INT32(INT32_C(5898), tuff_to_q16_16(material_literal.restitution));
}

static void test_ratios_round_to_nearest_on_both_sides_of_zero(void)
{
    TEST_ASSERT_EQUAL_INT32(INT32_C(21845), tuff_to_q16_16(TUFF_RATIO(1, 3)));
    TEST_ASSERT_EQUAL_INT32(INT32_C(43691), tuff_to_q16_16(TUFF_RATIO(2, 3)));
    TEST_ASSERT_EQUAL_INT32(INT32_C(-43691), tuff_to_q16_16(TUFF_RATIO(-2, 3)));
    TEST_ASSERT_EQUAL_INT32(INT32_C(-43691), tuff_to_q16_16(TUFF_RATIO(2, -3)));
    TEST_ASSERT_EQUAL_INT32(INT32_C(1), tuff_to_q16_16(TUFF_RATIO(1, INT32_C(131072))));
    TEST_ASSERT_EQUAL_INT32(INT32_C(-1), tuff_to_q16_16(TUFF_RATIO(-1, INT32_C(131072))));
}

static void test_unit_ratios_are_exact_to_the_last_bit(void)
{
    ASSERT_WITHIN(UNIT_STEPS(0, 1), TUFF_UNIT_RAW(INT32_C(357913941)), TUFF_UNIT_RATIO(1, 3));
    ASSERT_WITHIN(UNIT_STEPS(0, 1), TUFF_UNIT_RAW(INT32_C(715827883)), TUFF_UNIT_RATIO(2, 3));
    ASSERT_WITHIN(UNIT_STEPS(0, 1), TUFF_UNIT_RAW(INT32_C(-715827883)), TUFF_UNIT_RATIO(-2, 3));
    ASSERT_SAME(TUFF_UNIT_RAW(INT32_C(1073741824)), ONE);
}

static void test_whole_numbers_reach_both_ends_of_the_range(void)
{
    TEST_ASSERT_EQUAL_INT32(INT32_C(-32768), tuff_to_int(TUFF_WHOLE(INT32_C(-32768))));
    TEST_ASSERT_EQUAL_INT32(INT32_C(32767), tuff_to_int(TUFF_WHOLE(32767)));
    ASSERT_SAME(TUFF_WHOLE(-7), tuff_from_int(-7));
    TEST_ASSERT_EQUAL_INT32(0, tuff_to_int(0));
}

static void test_to_int_rounds_halves_away_from_zero(void)
{
    TEST_ASSERT_EQUAL_INT32(3, tuff_to_int(TUFF_RATIO(5, 2)));
    TEST_ASSERT_EQUAL_INT32(-3, tuff_to_int(TUFF_RATIO(-5, 2)));
    TEST_ASSERT_EQUAL_INT32(1, tuff_to_int(TUFF_RATIO(1, 2)));
    TEST_ASSERT_EQUAL_INT32(-1, tuff_to_int(TUFF_RATIO(-1, 2)));
    TEST_ASSERT_EQUAL_INT32(2, tuff_to_int(TUFF_RATIO(5, 2) - LSB));
    TEST_ASSERT_EQUAL_INT32(-2, tuff_to_int(TUFF_RATIO(-5, 2) + LSB));
    TEST_ASSERT_EQUAL_INT32(0, tuff_to_int(TUFF_RATIO(1, 2) - LSB));
}

static void test_every_fixed_format_reads_one_and_a_half(void)
{
    ASSERT_SAME(TUFF_RATIO(3, 2), tuff_from_q16_16(INT32_C(98304)));
    ASSERT_SAME(TUFF_RATIO(3, 2), tuff_from_q24_8(384));
    ASSERT_SAME(TUFF_RATIO(3, 2), tuff_from_q20_12(6144));
    ASSERT_SAME(TUFF_RATIO(3, 2), tuff_from_q22_10(1536));
    ASSERT_SAME(TUFF_RATIO(3, 2), tuff_from_q10_6(96));
    ASSERT_SAME(TUFF_RATIO(-3, 2), tuff_from_q24_8(-384));
    ASSERT_SAME(TUFF_RATIO(-3, 2), tuff_from_q10_6(-96));
}

static void test_every_fixed_format_writes_minus_one_and_a_half(void)
{
    const tuff_real value = TUFF_RATIO(-3, 2);
    TEST_ASSERT_EQUAL_INT32(INT32_C(-98304), tuff_to_q16_16(value));
    TEST_ASSERT_EQUAL_INT32(-384, tuff_to_q24_8(value));
    TEST_ASSERT_EQUAL_INT32(-6144, tuff_to_q20_12(value));
    TEST_ASSERT_EQUAL_INT32(-1536, tuff_to_q22_10(value));
    TEST_ASSERT_EQUAL_INT32(-96, tuff_to_q10_6(value));
}

static void test_coarser_formats_round_to_nearest(void)
{
    TEST_ASSERT_EQUAL_INT32(1, tuff_to_q24_8(TUFF_REAL_RAW(128)));
    TEST_ASSERT_EQUAL_INT32(-1, tuff_to_q24_8(TUFF_REAL_RAW(-128)));
    TEST_ASSERT_EQUAL_INT32(0, tuff_to_q24_8(TUFF_REAL_RAW(127)));
    TEST_ASSERT_EQUAL_INT32(0, tuff_to_q24_8(TUFF_REAL_RAW(-127)));
    TEST_ASSERT_EQUAL_INT32(1, tuff_to_q20_12(TUFF_REAL_RAW(8)));
    TEST_ASSERT_EQUAL_INT32(0, tuff_to_q20_12(TUFF_REAL_RAW(7)));
    TEST_ASSERT_EQUAL_INT32(-1, tuff_to_q22_10(TUFF_REAL_RAW(-32)));
    TEST_ASSERT_EQUAL_INT32(0, tuff_to_q22_10(TUFF_REAL_RAW(-31)));
    TEST_ASSERT_EQUAL_INT32(1, tuff_to_q10_6(TUFF_REAL_RAW(512)));
    TEST_ASSERT_EQUAL_INT32(0, tuff_to_q10_6(TUFF_REAL_RAW(511)));
}

static void test_what_does_not_fit_saturates(void)
{
    TEST_ASSERT_EQUAL_INT32(INT16_MAX, tuff_to_q10_6(TUFF_WHOLE(600)));
    TEST_ASSERT_EQUAL_INT32(INT16_MIN, tuff_to_q10_6(TUFF_WHOLE(-600)));
    TEST_ASSERT_EQUAL_INT32(INT16_MIN, tuff_to_q10_6(TUFF_WHOLE(-512)));
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, tuff_to_q16_16(tuff_from_int(INT32_C(40000))));
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, tuff_to_q16_16(tuff_from_int(INT32_C(-40000))));
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, tuff_to_q16_16(tuff_from_q24_8(INT32_MAX)));
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, tuff_to_q16_16(tuff_from_q24_8(INT32_MIN)));
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, tuff_fixed_from_real(W(2), 30));
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, tuff_fixed_from_real(W(-2), 30));
}

static void test_float_converts_both_ways(void)
{
    ASSERT_SAME(TUFF_RATIO(-13, 4), tuff_from_float(-3.25f));
    TEST_ASSERT_TRUE(tuff_to_float(TUFF_RATIO(-13, 4)) == -3.25f);
    ASSERT_SAME(LSB, tuff_from_float(1.0f / 65536.0f));
    ASSERT_SAME(EITHER(LSB, LSB / 2), tuff_from_float(0.5f / 65536.0f));
}

static void test_floats_beyond_the_fixed_range_saturate(void)
{
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, tuff_to_q16_16(tuff_from_float(1e10f)));
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, tuff_to_q16_16(tuff_from_float(-1e10f)));
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, tuff_to_q16_16(tuff_from_float(32768.0f)));
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, tuff_to_q16_16(tuff_from_float(-32768.0f)));
}

static void test_not_a_number_becomes_zero_in_integers(void)
{
    union { uint32_t bits; float value; } nan;
    nan.bits = UINT32_C(0x7fc00000);
    TEST_ASSERT_EQUAL_INT32(0, tuff_to_q16_16(tuff_from_float(nan.value)));
    TEST_ASSERT_EQUAL_INT32(0, tuff_to_int(tuff_from_float(nan.value)));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_real_literals_are_static_initializers_with_24_bits);
    RUN_TEST(test_ratios_round_to_nearest_on_both_sides_of_zero);
    RUN_TEST(test_unit_ratios_are_exact_to_the_last_bit);
    RUN_TEST(test_whole_numbers_reach_both_ends_of_the_range);
    RUN_TEST(test_to_int_rounds_halves_away_from_zero);
    RUN_TEST(test_every_fixed_format_reads_one_and_a_half);
    RUN_TEST(test_every_fixed_format_writes_minus_one_and_a_half);
    RUN_TEST(test_coarser_formats_round_to_nearest);
    RUN_TEST(test_what_does_not_fit_saturates);
    RUN_TEST(test_float_converts_both_ways);
    RUN_TEST(test_floats_beyond_the_fixed_range_saturate);
    RUN_TEST(test_not_a_number_becomes_zero_in_integers);
    return UNITY_END();
}
