/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Segment against a closed convex polygon. DESIGN 2 (_segmentPolyIntersect), DESIGN 4 (closed, exact, symmetric, no leaks). */
#include "shapes.h"

DEFINE_BOX(box, -10, -10, 10, 10);
DEFINE_BOX_REVERSED(reversed, -10, -10, 10, 10);
DEFINE_WEDGE(wedge);

void setUp(void) {}
void tearDown(void) {}

/* The answer does not change when the ends are swapped. */
static bool touches(tuff_vec2 a, tuff_vec2 b, const tuff_polygon *polygon, UNITY_LINE_TYPE line)
{
    bool forward = tuff_segment_polygon(a, b, polygon);
    if (forward != tuff_segment_polygon(b, a, polygon)) UNITY_TEST_FAIL(line, "swapping the ends changes the answer");
    return forward;
}

#define ASSERT_HIT(a, b, p)  TEST_ASSERT_TRUE(touches((a), (b), (p), __LINE__))
#define ASSERT_MISS(a, b, p) TEST_ASSERT_FALSE(touches((a), (b), (p), __LINE__))

static void test_a_crossing_hits(void)
{
    ASSERT_HIT(whole(-20, 3), whole(20, 5), &box);
    ASSERT_HIT(whole(-20, 3), whole(0, 3), &box);
    ASSERT_HIT(whole(5, 21), whole(21, 5), &wedge);
    ASSERT_HIT(whole(-5, 20), whole(15, 5), &wedge);
}

static void test_beside_it_misses(void)
{
    ASSERT_MISS(whole(-20, 11), whole(20, 11), &box);
    ASSERT_MISS(whole(11, 0), whole(30, 0), &box);
    ASSERT_MISS(whole(5, 17), whole(17, 5), &box);    /* past each corner: only the line itself separates */
    ASSERT_MISS(whole(-5, 17), whole(-17, 5), &box);
    ASSERT_MISS(whole(-5, -17), whole(-17, -5), &box);
    ASSERT_MISS(whole(5, -17), whole(17, -5), &box);
    ASSERT_MISS(whole(30, 8), whole(8, 30), &wedge);
}

static void test_a_segment_inside_hits(void)
{
    ASSERT_HIT(whole(-3, 1), whole(2, 2), &box);
    ASSERT_HIT(whole(1, 1), whole(5, 3), &wedge);
}

static void test_a_start_inside_hits(void)
{
    ASSERT_HIT(whole(0, 0), whole(50, 7), &box);
    ASSERT_HIT(whole(9, 9), whole(9, 90), &box);
}

static void test_an_end_on_an_edge_touches(void)
{
    ASSERT_HIT(whole(10, 3), whole(30, 3), &box);
    ASSERT_HIT(whole(15, 20), whole(23, 26), &wedge);
    ASSERT_MISS(vec(W(10) + NUDGE, W(3)), whole(30, 3), &box);
    ASSERT_MISS(vec(W(15) + NUDGE, W(20)), whole(23, 26), &wedge);
}

static void test_a_line_along_an_edge_touches(void)
{
    ASSERT_HIT(whole(-20, 10), whole(20, 10), &box);
    ASSERT_HIT(whole(-2, 10), whole(2, 10), &box);
    ASSERT_HIT(whole(45, -20), whole(-15, 60), &wedge);
    ASSERT_MISS(vec(W(-20), W(10) + NUDGE), vec(W(20), W(10) + NUDGE), &box);
}

static void test_a_line_along_an_edge_but_beyond_its_end_misses(void)
{
    ASSERT_MISS(whole(11, 10), whole(20, 10), &box);
    ASSERT_MISS(whole(10, -30), whole(10, -11), &box);
    ASSERT_HIT(whole(10, 10), whole(20, 10), &box);
    ASSERT_MISS(whole(33, -4), whole(45, -20), &wedge);
}

static void test_a_vertex_touched_in_passing_hits(void)
{
    ASSERT_HIT(whole(0, 20), whole(20, 0), &box);
    ASSERT_HIT(whole(-20, 0), whole(0, -20), &box);
    ASSERT_MISS(vec(NUDGE, W(20)), vec(W(20), NUDGE), &box);
    ASSERT_HIT(whole(-10, 40), whole(20, 40), &wedge);
}

static void test_a_vertex_touched_by_an_end_hits(void)
{
    ASSERT_HIT(whole(10, 10), whole(15, 15), &box);
    ASSERT_HIT(whole(30, 0), whole(50, -1), &wedge);
    ASSERT_MISS(vec(W(10) + NUDGE, W(10) + NUDGE), whole(15, 15), &box);
}

static void test_zero_length_is_a_point_test(void)
{
    ASSERT_HIT(whole(3, 4), whole(3, 4), &box);
    ASSERT_HIT(whole(10, 4), whole(10, 4), &box);
    ASSERT_HIT(whole(-10, -10), whole(-10, -10), &box);
    ASSERT_HIT(whole(15, 20), whole(15, 20), &wedge);
    ASSERT_MISS(vec(W(10) + NUDGE, W(4)), vec(W(10) + NUDGE, W(4)), &box);
    ASSERT_MISS(whole(-11, -11), whole(-11, -11), &box);
    ASSERT_MISS(whole(16, 20), whole(16, 20), &wedge);
}

static void test_either_winding_gives_the_same(void)
{
    for (int8_t x = -22; x <= 22; x = (int8_t)(x + 4)) {
        tuff_vec2 a = whole(x, 12);
        tuff_vec2 b = whole(11, (int16_t)(x - 6));
        TEST_ASSERT_EQUAL_INT(touches(a, b, &box, __LINE__), touches(a, b, &reversed, __LINE__));
    }
    ASSERT_HIT(whole(-20, 10), whole(20, 10), &reversed);
    ASSERT_MISS(whole(-20, 11), whole(20, 11), &reversed);
}

static void test_differences_of_33_bits_do_not_wrap(void)
{
    ASSERT_HIT(vec(LOWEST, W(5)), vec(HIGHEST, W(5)), &box);
    ASSERT_HIT(vec(W(-9), HIGHEST), vec(W(-9), LOWEST), &box);
    ASSERT_HIT(vec(LOWEST, LOWEST), vec(HIGHEST, HIGHEST), &box);
    ASSERT_HIT(vec(LOWEST, HIGHEST), vec(HIGHEST, LOWEST), &box);
    ASSERT_MISS(vec(LOWEST, W(11)), vec(HIGHEST, W(11)), &box);
    ASSERT_MISS(vec(W(-11), HIGHEST), vec(W(-11), LOWEST), &box);
    ASSERT_MISS(vec(LOWEST, LOWEST), vec(HIGHEST, LOWEST), &box);
    ASSERT_MISS(vec(LOWEST, HIGHEST), vec(HIGHEST, HIGHEST), &box);
    ASSERT_MISS(vec(LOWEST, HIGHEST), vec(LOWEST, HIGHEST), &box);
}

/* Across the whole range, one step at one end decides. */
static void test_the_longest_lines_are_judged_exactly(void)
{
    static const tuff_vec2 small_vertices[3] = { { 0, 0 }, { W(1), W(-2) }, { W(2), W(-1) } };
    static const tuff_polygon small = { small_vertices, box_normals, 0, 3 };
    ASSERT_HIT(vec(LOWEST, LOWEST), vec(HIGHEST, HIGHEST), &small);
    ASSERT_MISS(vec(LOWEST, LOWEST), vec(HIGHEST - LSB, HIGHEST), &small);
    ASSERT_MISS(vec(LOWEST, LOWEST + LSB), vec(HIGHEST, HIGHEST), &small);
    ASSERT_HIT(vec(LOWEST + LSB, LOWEST), vec(HIGHEST, HIGHEST), &small);
    ASSERT_HIT(vec(LOWEST, W(10)), vec(HIGHEST, W(10)), &box);
    ASSERT_MISS(vec(LOWEST, W(10) + LSB), vec(HIGHEST, W(10) + LSB), &box);
    ASSERT_HIT(vec(LOWEST, W(10) + LSB), vec(HIGHEST, W(10) - LSB), &box);
}

/* The fixed build judges ends within 8,192 units another way. */
static void test_the_length_does_not_matter_where_the_way_of_judging_changes(void)
{
    const tuff_real reaches[] = { W(8192) - LSB, W(8192), W(8192) + LSB, W(8193), W(20000) };
    unsigned i;
    for (i = 0; i < sizeof reaches / sizeof *reaches; ++i) {
        const tuff_real r = reaches[i];
        ASSERT_HIT(vec(-r, W(10)), vec(r, W(10)), &box);
        ASSERT_HIT(vec(-r, W(10)), whole(20, 10), &box);
        ASSERT_MISS(vec(-r, W(10) + LSB), vec(r, W(10) + LSB), &box);
        ASSERT_HIT(vec(-r, W(20) - r), vec(r, W(20) + r), &reversed);     /* past the corner (-10, 10) */
        ASSERT_HIT(vec(-r, W(20) - r), whole(0, 20), &box);
        ASSERT_MISS(vec(-r, W(20) - r), whole(-11, 9), &box);
        ASSERT_MISS(vec(-r, W(20) + LSB - r), vec(r, W(20) + LSB + r), &box);
    }
}

static void test_a_beam_between_two_polygons_that_share_an_edge_hits(void)
{
    static const tuff_vec2 left_vertices[4] = BOX_VERTICES(-20, -10, 0, 10);
    static const tuff_vec2 right_vertices[4] = BOX_VERTICES(0, -10, 20, 10);
    static const tuff_polygon left = { left_vertices, box_normals, 2, 4 };
    static const tuff_polygon right = { right_vertices, box_normals, 8, 4 };
    ASSERT_HIT(whole(0, -30), whole(0, 30), &left);
    ASSERT_HIT(whole(0, -30), whole(0, 30), &right);
    for (int8_t i = -5; i <= 5; i++) {
        tuff_vec2 a = vec(i * LSB, W(-30));
        tuff_vec2 b = vec(-i * LSB, W(30));
        TEST_ASSERT_TRUE(touches(a, b, &left, __LINE__) || touches(a, b, &right, __LINE__));
    }
}

static void test_the_normals_do_not_matter_but_must_be_there(void)
{
    static const tuff_polygon wrong = { box_vertices, wedge_normals, 0, 3 };
    tuff_polygon bare = box;
    bare.normals = NULL;
    ASSERT_HIT(whole(-20, -5), whole(20, -5), &wrong);
    ASSERT_MISS(whole(-20, -5), whole(20, -5), &bare);
}

static void test_a_polygon_that_is_not_baked_misses(void)
{
    tuff_polygon bad = box;
    ASSERT_MISS(whole(-20, 0), whole(20, 0), NULL);
    bad.count = 2;
    ASSERT_MISS(whole(-20, 0), whole(20, 0), &bad);
    bad.count = 33;
    ASSERT_MISS(whole(-20, 0), whole(20, 0), &bad);
    bad.count = 4;
    bad.vertices = NULL;
    ASSERT_MISS(whole(-20, 0), whole(20, 0), &bad);
}

static void test_the_largest_polygon_is_tested_edge_by_edge(void)
{
    tuff_vec2 vertices[32];
    tuff_unit2 normals[32];
    tuff_polygon polygon = baked_largest_polygon(vertices, normals);
    for (uint8_t i = 0; i < 32; i++) {
        tuff_vec2 a = vertices[i];
        tuff_vec2 b = vertices[(i + 1) % 32];
        tuff_vec2 step = vec(b.x - a.x, b.y - a.y);
        tuff_vec2 ahead = vec(b.x + 4 * step.x, b.y + 4 * step.y);
        ASSERT_HIT(a, vec(a.x - step.x, a.y - step.y), &polygon);
        ASSERT_HIT(vec(a.x - step.x, a.y - step.y), ahead, &polygon);
        ASSERT_HIT(vec((a.x + b.x) / 2, (a.y + b.y) / 2), vec(a.x + 9 * step.y, a.y - 9 * step.x), &polygon);
        ASSERT_MISS(vec(b.x + step.x, b.y + step.y), ahead, &polygon);
    }
}

static void test_not_a_number_misses(void)
{
    ASSERT_MISS(vec(NOT_A_NUMBER, 0), whole(0, 0), &box);
    ASSERT_MISS(vec(0, NOT_A_NUMBER), whole(0, 0), &box);
    ASSERT_MISS(vec(INFINITE, 0), whole(0, 0), &box);
    ASSERT_MISS(vec(-INFINITE, 0), vec(INFINITE, 0), &box);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_crossing_hits);
    RUN_TEST(test_beside_it_misses);
    RUN_TEST(test_a_segment_inside_hits);
    RUN_TEST(test_a_start_inside_hits);
    RUN_TEST(test_an_end_on_an_edge_touches);
    RUN_TEST(test_a_line_along_an_edge_touches);
    RUN_TEST(test_a_line_along_an_edge_but_beyond_its_end_misses);
    RUN_TEST(test_a_vertex_touched_in_passing_hits);
    RUN_TEST(test_a_vertex_touched_by_an_end_hits);
    RUN_TEST(test_zero_length_is_a_point_test);
    RUN_TEST(test_either_winding_gives_the_same);
    RUN_TEST(test_differences_of_33_bits_do_not_wrap);
    if (IS_FIXED) RUN_TEST(test_the_longest_lines_are_judged_exactly);
    if (IS_FIXED) RUN_TEST(test_the_length_does_not_matter_where_the_way_of_judging_changes);
    RUN_TEST(test_a_beam_between_two_polygons_that_share_an_edge_hits);
    RUN_TEST(test_the_normals_do_not_matter_but_must_be_there);
    RUN_TEST(test_a_polygon_that_is_not_baked_misses);
    RUN_TEST(test_the_largest_polygon_is_tested_edge_by_edge);
    if (!IS_FIXED) RUN_TEST(test_not_a_number_misses);
    return UNITY_END();
}
