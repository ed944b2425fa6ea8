/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   In how many steps a motion must be made, and the thickness of shapes. */
#include "shapes.h"

#define MARGIN EITHER(TUFF_REAL_RAW(4), TUFF_RATIO(1, 256))   /* of a thickness: world.h */

void setUp(void) {}
void tearDown(void) {}

static void test_a_slow_motion_needs_one_step(void)
{
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(vec(0, 0), W(8), W(4)));
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(vec(LSB, LSB), W(8), W(4)));
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(whole(-3, 4), W(4), W(4)));
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(vec(0, 0), 0, 0));
}

/* 3, 4, 5: steps of exactly the radius are enough. */
static void test_the_count_changes_exactly_at_multiples_of_the_step(void)
{
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(whole(6, 8), W(10), 0));
    TEST_ASSERT_EQUAL_UINT16(2, tuff_substeps(vec(W(6), W(8) + NUDGE), W(10), 0));
    TEST_ASSERT_EQUAL_UINT16(3, tuff_substeps(whole(-18, 24), W(10), 0));
    TEST_ASSERT_EQUAL_UINT16(4, tuff_substeps(vec(W(-18), W(24) + NUDGE), W(10), 0));
    TEST_ASSERT_EQUAL_UINT16(100, tuff_substeps(whole(600, -800), W(10), 0));
    TEST_ASSERT_EQUAL_UINT16(101, tuff_substeps(vec(W(600), W(-800) - NUDGE), W(10), 0));
}

static void test_half_of_the_thickness_less_the_margin_counts(void)
{
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(vec(W(10), 0), W(7), W(6) + 2 * MARGIN));
    TEST_ASSERT_EQUAL_UINT16(2, tuff_substeps(vec(W(10), 0), W(7), W(6)));
    TEST_ASSERT_EQUAL_UINT16(2, tuff_substeps(vec(W(20), 0), W(7), W(6) + 2 * MARGIN));
}

/* A thickness that the margin eats takes nothing from the radius. */
static void test_a_thin_piece_leaves_the_radius(void)
{
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(whole(8, 0), W(8), 0));
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(whole(8, 0), W(8), MARGIN));
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(whole(8, 0), W(8), 2 * MARGIN));
}

static void test_a_point_alone_needs_the_thickness(void)
{
    TEST_ASSERT_EQUAL_UINT16(10, tuff_substeps(whole(0, 30), 0, W(6) + 2 * MARGIN));
}

static void test_the_count_saturates(void)
{
    TEST_ASSERT_EQUAL_UINT16(65535, tuff_substeps(vec(LSB, 0), 0, 0));
    TEST_ASSERT_EQUAL_UINT16(65535, tuff_substeps(vec(HIGHEST, LOWEST), 0, 0));
    TEST_ASSERT_EQUAL_UINT16(65535, tuff_substeps(vec(W(4096), 0), TUFF_RATIO(1, 32), 0));
    TEST_ASSERT_EQUAL_UINT16(65535, tuff_substeps(vec(TUFF_RATIO(65535, 16), 0), TUFF_RATIO(1, 16), 0));
    TEST_ASSERT_EQUAL_UINT16(65534, tuff_substeps(vec(TUFF_RATIO(65534, 16), 0), TUFF_RATIO(1, 16), 0));
}

/* 46,340.95 units, which a tuff_real of the fixed build does not hold. */
static void test_the_longest_motion_is_counted_in_full(void)
{
    TEST_ASSERT_EQUAL_UINT16(47, tuff_substeps(vec(LOWEST, LOWEST), W(1000), 0));
    TEST_ASSERT_EQUAL_UINT16(32, tuff_substeps(vec(LOWEST, LOWEST), W(1449), 0));
    TEST_ASSERT_EQUAL_UINT16(16, tuff_substeps(vec(LOWEST, LOWEST), W(1449), W(2898)));
}

static void test_numbers_out_of_range_need_one_step(void)
{
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(whole(100, 0), W(-1), 0));
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(whole(100, 0), W(1), W(-1)));
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(whole(30000, 0), W(1450), 0));
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(whole(30000, 0), 0, W(2899)));
}

#if !IS_FIXED
static void test_bad_numbers_need_one_step(void)
{
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(vec(NOT_A_NUMBER, 0), W(1), 0));
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(vec(0, INFINITE), W(1), 0));
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(whole(100, 0), NOT_A_NUMBER, 0));
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(whole(100, 0), W(1), NOT_A_NUMBER));
    TEST_ASSERT_EQUAL_UINT16(1, tuff_substeps(vec(40000.0f, 0), W(1), 0));
    TEST_ASSERT_EQUAL_UINT16(65535, tuff_substeps(whole(100, 0), 1e-40f, 1e-40f));
}
#endif

/* Any motion: so many steps cover it, one less would not. */
static void test_the_count_is_the_least_that_covers_the_motion(void)
{
    uint32_t state = 5;
    for (uint16_t i = 0; i < 500; i++) {
        int16_t x = (int16_t)(next_random(&state) % 2001) - 1000;
        int16_t y = (int16_t)(next_random(&state) % 2001) - 1000;
        uint32_t radius = 1 + next_random(&state) % 60;
        uint32_t square = (uint32_t)((int32_t)x * x) + (uint32_t)((int32_t)y * y);
        uint32_t count = tuff_substeps(whole(x, y), tuff_from_int((int32_t)radius), 0);
        uint32_t way = count * radius;
        uint32_t shorter = (count - 1) * radius;
        TEST_ASSERT_TRUE(way * way >= square);
        TEST_ASSERT_TRUE(count == 1 || shorter * shorter < square);
    }
}

static void test_a_boxs_thickness_is_its_lesser_side(void)
{
    DEFINE_BOX(box, -3, -40, 5, 60);
    DEFINE_BOX_REVERSED(other, 100, 7, 900, 20);
    ASSERT_REAL(W(8), tuff_polygon_thickness(&box));
    ASSERT_REAL(W(13), tuff_polygon_thickness(&other));
}

/* Heights 30, 40 and 24. */
static void test_a_triangles_thickness_is_two_thirds_of_its_least_height(void)
{
    DEFINE_WEDGE(wedge);
    ASSERT_REAL(W(16), tuff_polygon_thickness(&wedge));
}

static void test_normals_are_not_needed(void)
{
    static const tuff_vec2 diamond[4] = DIAMOND_VERTICES;
    tuff_polygon hull = { diamond, NULL, 0, 4 };
    ASSERT_REAL(TUFF_REAL_RAW(463410), tuff_polygon_thickness(&hull));   /* 10 / sqrt(2) */
}

static void test_the_largest_polygon_has_a_thickness(void)
{
    static const tuff_vec2 vertices[4] = BOX_VERTICES(-1024, -1024, 1024, 1024);
    static tuff_vec2 many[32];
    tuff_polygon largest = { vertices, NULL, 0, 4 };
    tuff_polygon collinear = { many, NULL, 0, 32 };
    ASSERT_SAME(W(2048), tuff_polygon_thickness(&largest));
    for (uint8_t i = 0; i < 32; i++) many[i] = i < 16 ? whole(1024, (int16_t)(i - 512)) : whole(1000, (int16_t)(31 - i - 512));
    ASSERT_SAME(W(15), tuff_polygon_thickness(&collinear));
}

static void test_an_edge_without_length_does_not_count(void)
{
    static const tuff_vec2 vertices[5] = { { 0, 0 }, { 0, 0 }, { W(30), 0 }, { W(30), W(20) }, { 0, W(20) } };
    tuff_polygon polygon = { vertices, NULL, 0, 5 };
    ASSERT_REAL(W(16), tuff_polygon_thickness(&polygon));   /* the mean is drawn to the doubled corner */
}

static void test_what_has_no_area_has_no_thickness(void)
{
    static const tuff_vec2 line[3] = { { W(-5), W(3) }, { W(5), W(3) }, { 0, W(3) } };
    static const tuff_vec2 point[3] = { { W(5), W(3) }, { W(5), W(3) }, { W(5), W(3) } };
    tuff_polygon flat = { line, NULL, 0, 3 };
    tuff_polygon none = { point, NULL, 0, 3 };
    ASSERT_SAME(0, tuff_polygon_thickness(&flat));
    ASSERT_SAME(0, tuff_polygon_thickness(&none));
    flat.count = 2;
    none.vertices = NULL;
    ASSERT_SAME(0, tuff_polygon_thickness(&flat));
    ASSERT_SAME(0, tuff_polygon_thickness(&none));
    ASSERT_SAME(0, tuff_polygon_thickness(NULL));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_slow_motion_needs_one_step);
    RUN_TEST(test_the_count_changes_exactly_at_multiples_of_the_step);
    RUN_TEST(test_half_of_the_thickness_less_the_margin_counts);
    RUN_TEST(test_a_thin_piece_leaves_the_radius);
    RUN_TEST(test_a_point_alone_needs_the_thickness);
    RUN_TEST(test_the_count_saturates);
    RUN_TEST(test_the_longest_motion_is_counted_in_full);
    RUN_TEST(test_numbers_out_of_range_need_one_step);
#if !IS_FIXED
    RUN_TEST(test_bad_numbers_need_one_step);
#endif
    RUN_TEST(test_the_count_is_the_least_that_covers_the_motion);
    RUN_TEST(test_a_boxs_thickness_is_its_lesser_side);
    RUN_TEST(test_a_triangles_thickness_is_two_thirds_of_its_least_height);
    RUN_TEST(test_normals_are_not_needed);
    RUN_TEST(test_the_largest_polygon_has_a_thickness);
    RUN_TEST(test_an_edge_without_length_does_not_count);
    RUN_TEST(test_what_has_no_area_has_no_thickness);
    return UNITY_END();
}
