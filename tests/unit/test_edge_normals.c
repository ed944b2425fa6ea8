/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Outward unit normals from vertices. DESIGN 7 (tuff_edge_normals), DESIGN 4 (no normalized zero vector). */
#include "shapes.h"

static tuff_unit2 normals[33];

static void mark_normals(void)
{
    for (uint8_t i = 0; i < 33; i++) {
        normals[i].x = TUFF_UNIT_RATIO(1, 4);
        normals[i].y = TUFF_UNIT_RATIO(-1, 4);
    }
}

void setUp(void)
{
    mark_normals();
}

void tearDown(void) {}

/* The bound of the header: 0.8 * 2^-30 a component, or 2^-23. */
#define ASSERT_NORMAL(ex, ey, n) \
    do { ASSERT_WITHIN(UNIT_STEPS(1, 2), (ex), (n).x); ASSERT_WITHIN(UNIT_STEPS(1, 2), (ey), (n).y); } while (0)

#define ASSERT_MARKED(n) \
    do { ASSERT_SAME(TUFF_UNIT_RATIO(1, 4), (n).x); ASSERT_SAME(TUFF_UNIT_RATIO(-1, 4), (n).y); } while (0)

static void test_normals_point_outward_in_one_winding(void)
{
    static const tuff_vec2 vertices[4] = BOX_VERTICES(-3, -3, 7, 9);
    tuff_edge_normals(vertices, 4, normals);
    ASSERT_NORMAL(0, -ONE, normals[0]);
    ASSERT_NORMAL(ONE, 0, normals[1]);
    ASSERT_NORMAL(0, ONE, normals[2]);
    ASSERT_NORMAL(-ONE, 0, normals[3]);
}

static void test_normals_point_outward_in_the_other_winding(void)
{
    static const tuff_vec2 vertices[4] = BOX_VERTICES_REVERSED(-3, -3, 7, 9);
    tuff_edge_normals(vertices, 4, normals);
    ASSERT_NORMAL(-ONE, 0, normals[0]);
    ASSERT_NORMAL(0, ONE, normals[1]);
    ASSERT_NORMAL(ONE, 0, normals[2]);
    ASSERT_NORMAL(0, -ONE, normals[3]);
}

static void test_oblique_normals_are_unit_vectors(void)
{
    static const tuff_vec2 vertices[3] = { { 0, 0 }, { W(30), 0 }, { 0, W(40) } };
    static const tuff_vec2 other[3] = { { W(-5), W(3) }, { W(0), W(15) }, { W(-8), W(0) } };   /* 12/13, 15/17 and 3/5 sides */
    tuff_edge_normals(vertices, 3, normals);
    ASSERT_NORMAL(TUFF_UNIT_RATIO(4, 5), TUFF_UNIT_RATIO(3, 5), normals[1]);
    tuff_edge_normals(other, 3, normals);
    ASSERT_NORMAL(TUFF_UNIT_RATIO(12, 13), TUFF_UNIT_RATIO(-5, 13), normals[0]);
    ASSERT_NORMAL(TUFF_UNIT_RATIO(-15, 17), TUFF_UNIT_RATIO(8, 17), normals[1]);
    ASSERT_NORMAL(HALF_ROOT, -HALF_ROOT, normals[2]);
}

static void test_the_smallest_and_the_largest_edges_have_the_same_normals(void)
{
    static const tuff_vec2 tiny[4] = { { TUFF_REAL_RAW(-4), 0 }, { 0, TUFF_REAL_RAW(-3) },
                                       { TUFF_REAL_RAW(4), 0 }, { 0, TUFF_REAL_RAW(3) } };
    static const tuff_vec2 huge[4] = { { W(-1024), 0 }, { 0, W(-768) }, { W(1024), 0 }, { 0, W(768) } };
    tuff_edge_normals(tiny, 4, normals);
    tuff_edge_normals(huge, 4, normals + 4);
    for (uint8_t i = 0; i < 8; i++) {
        tuff_unit x = i % 4 == 0 || i % 4 == 3 ? TUFF_UNIT_RATIO(-3, 5) : TUFF_UNIT_RATIO(3, 5);
        ASSERT_NORMAL(x, i % 4 < 2 ? TUFF_UNIT_RATIO(-4, 5) : TUFF_UNIT_RATIO(4, 5), normals[i]);
    }
}

/* A needle of 2048 by 1 LSB: its sides are square to x to the last bit. */
static void test_a_needle_has_outward_normals(void)
{
    static const tuff_vec2 vertices[3] = { { W(-1024), 0 }, { W(1024), 0 }, { 0, TUFF_REAL_RAW(1) } };
    tuff_edge_normals(vertices, 3, normals);
    ASSERT_NORMAL(0, -ONE, normals[0]);
    ASSERT_NORMAL(TUFF_UNIT_RAW(16), ONE, normals[1]);
    ASSERT_NORMAL(TUFF_UNIT_RAW(-16), ONE, normals[2]);
}

static void test_an_edge_without_length_takes_the_next_real_edges_normal(void)
{
    static const tuff_vec2 vertices[6] = { { W(-3), W(-3) }, { W(7), W(-3) }, { W(7), W(-3) },
                                           { W(7), W(-3) }, { W(7), W(9) }, { W(-3), W(9) } };
    tuff_edge_normals(vertices, 6, normals);
    ASSERT_NORMAL(0, -ONE, normals[0]);
    ASSERT_NORMAL(ONE, 0, normals[1]);
    ASSERT_NORMAL(ONE, 0, normals[2]);
    ASSERT_NORMAL(ONE, 0, normals[3]);
    ASSERT_NORMAL(0, ONE, normals[4]);
    ASSERT_NORMAL(-ONE, 0, normals[5]);
}

static void test_a_last_edge_without_length_wraps_to_the_first(void)
{
    static const tuff_vec2 vertices[5] = { { W(-3), W(-3) }, { W(7), W(-3) }, { W(7), W(9) }, { W(-3), W(9) }, { W(-3), W(-3) } };
    tuff_edge_normals(vertices, 5, normals);
    ASSERT_NORMAL(-ONE, 0, normals[3]);
    ASSERT_NORMAL(0, -ONE, normals[4]);
}

static void test_a_polygon_without_any_edge_has_normals_along_x(void)
{
    static const tuff_vec2 vertices[3] = { { W(5), W(5) }, { W(5), W(5) }, { W(5), W(5) } };
    tuff_edge_normals(vertices, 3, normals);
    for (uint8_t i = 0; i < 3; i++) ASSERT_NORMAL(ONE, 0, normals[i]);
    ASSERT_MARKED(normals[3]);
}

static void test_counts_out_of_range_write_nothing(void)
{
    static const tuff_vec2 vertices[33] = { { 0, 0 }, { W(1), 0 }, { 0, W(1) } };
    tuff_edge_normals(vertices, 0, normals);
    tuff_edge_normals(vertices, 2, normals);
    tuff_edge_normals(vertices, 33, normals);
    tuff_edge_normals(vertices, 255, normals);
    for (uint8_t i = 0; i < 33; i++) ASSERT_MARKED(normals[i]);
}

static void test_null_pointers_write_nothing(void)
{
    static const tuff_vec2 vertices[3] = { { 0, 0 }, { W(1), 0 }, { 0, W(1) } };
    tuff_edge_normals(NULL, 3, normals);
    tuff_edge_normals(vertices, 3, NULL);
    ASSERT_MARKED(normals[0]);
}

/* Square to their whole-numbered steps (sx, sy), of length 1, and on the side of (sy, -sx). */
static void test_the_largest_count_has_32_square_unit_normals(void)
{
    tuff_vec2 vertices[32];
    largest_polygon(vertices);
    tuff_edge_normals(vertices, 32, normals);
    for (uint8_t i = 0; i < 32; i++) {
        tuff_vec2 a = vertices[i];
        tuff_vec2 b = vertices[(i + 1) % 32];
        test_wide sx = (test_wide)tuff_to_int(b.x - a.x);
        test_wide sy = (test_wide)tuff_to_int(b.y - a.y);
        test_wide along = sx * normals[i].x + sy * normals[i].y;
        test_wide length = (test_wide)normals[i].x * normals[i].x + (test_wide)normals[i].y * normals[i].y - (test_wide)ONE * ONE;
        TEST_ASSERT_TRUE(along <= 4 * UNIT_STEPS(1, 2) && along >= -4 * UNIT_STEPS(1, 2));
        TEST_ASSERT_TRUE(length <= 3 * (test_wide)ONE * UNIT_STEPS(1, 2) && length >= -3 * (test_wide)ONE * UNIT_STEPS(1, 2));
        TEST_ASSERT_TRUE(sy * normals[i].x > sx * normals[i].y);
    }
    ASSERT_MARKED(normals[32]);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_normals_point_outward_in_one_winding);
    RUN_TEST(test_normals_point_outward_in_the_other_winding);
    RUN_TEST(test_oblique_normals_are_unit_vectors);
    RUN_TEST(test_the_smallest_and_the_largest_edges_have_the_same_normals);
    RUN_TEST(test_a_needle_has_outward_normals);
    RUN_TEST(test_an_edge_without_length_takes_the_next_real_edges_normal);
    RUN_TEST(test_a_last_edge_without_length_wraps_to_the_first);
    RUN_TEST(test_a_polygon_without_any_edge_has_normals_along_x);
    RUN_TEST(test_counts_out_of_range_write_nothing);
    RUN_TEST(test_null_pointers_write_nothing);
    RUN_TEST(test_the_largest_count_has_32_square_unit_normals);
    return UNITY_END();
}
