/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What a beam hits first: fraction, normal, piece. DESIGN 2 ("Which piece, where, how"), DESIGN 7 (tuff_beam_hit). */
#include "shapes.h"

#define PIECES 4

DEFINE_BOX(box, -10, -10, 10, 10);
DEFINE_PAIR_OF_BOXES(halves, 0, 10, box_normals, 2, 8);   /* share the edge x = 0 */

DEFINE_TERRAIN(PIECES, 8, 5);
static tuff_world world;
static tuff_beam_hit hit;

void setUp(void)
{
    empty_world(&world, terrain, PIECES, &chunks);
    hit.fraction = TUFF_UNIT_RATIO(-1, 3);
    hit.normal.x = TUFF_UNIT_RATIO(1, 8);
    hit.normal.y = TUFF_UNIT_RATIO(-1, 8);
    hit.piece = 777;
}

void tearDown(void) {}

static void place(uint8_t piece, tuff_real x, tuff_real y, const tuff_polygon *parts, uint8_t part_count)
{
    terrain[piece] = piece_of(vec(x, y), W(10), parts, part_count);
    TEST_ASSERT_TRUE(tuff_chunks_insert(&chunks, piece, terrain[piece].position, W(15)));
}

/* With the index and without: the same hit to the last bit. */
static bool first_hit(tuff_vec2 a, tuff_vec2 b)
{
    tuff_beam_hit scanned = hit;
    bool found = tuff_segment_terrain_first_hit(&world, a, b, &hit);
    world.chunks = NULL;
    TEST_ASSERT_EQUAL_INT(found, tuff_segment_terrain_first_hit(&world, a, b, &scanned));
    world.chunks = &chunks;
    ASSERT_SAME(scanned.fraction, hit.fraction);
    ASSERT_VEC_SAME(scanned.normal.x, scanned.normal.y, hit.normal);
    TEST_ASSERT_EQUAL_INT(scanned.piece, hit.piece);
    return found;
}

#define ASSERT_BEAM_HIT(number, share, nx, ny) \
    do { TEST_ASSERT_EQUAL_INT((number), hit.piece); ASSERT_WITHIN(UNIT_STEPS(16384, 32), (share), hit.fraction); \
         ASSERT_UNIT((nx), hit.normal.x); ASSERT_UNIT((ny), hit.normal.y); } while (0)

static void test_a_face_is_hit_where_the_beam_enters_it(void)
{
    place(2, W(50), W(50), &box, 1);
    TEST_ASSERT_TRUE(first_hit(whole(0, 50), whole(100, 50)));
    ASSERT_BEAM_HIT(2, TUFF_UNIT_RATIO(2, 5), -ONE, 0);
    TEST_ASSERT_TRUE(first_hit(whole(100, 50), whole(0, 50)));
    ASSERT_BEAM_HIT(2, TUFF_UNIT_RATIO(2, 5), ONE, 0);
    TEST_ASSERT_TRUE(first_hit(whole(45, 100), whole(45, 0)));
    ASSERT_BEAM_HIT(2, TUFF_UNIT_RATIO(2, 5), 0, ONE);
    TEST_ASSERT_TRUE(first_hit(whole(10, 30), whole(90, 70)));
    ASSERT_BEAM_HIT(2, TUFF_UNIT_RATIO(3, 8), -ONE, 0);
}

/* From outside of two edges at a time: the one that is entered last is the way in, whatever its number. */
static void test_of_two_edges_the_one_entered_last_is_hit(void)
{
    place(2, W(50), W(50), &box, 1);
    TEST_ASSERT_TRUE(first_hit(whole(30, 10), whole(70, 90)));
    ASSERT_BEAM_HIT(2, TUFF_UNIT_RATIO(3, 8), 0, -ONE);
    TEST_ASSERT_TRUE(first_hit(whole(90, 30), whole(10, 70)));
    ASSERT_BEAM_HIT(2, TUFF_UNIT_RATIO(3, 8), ONE, 0);
    TEST_ASSERT_TRUE(first_hit(whole(70, 90), whole(30, 10)));
    ASSERT_BEAM_HIT(2, TUFF_UNIT_RATIO(3, 8), 0, ONE);
}

static void test_of_edges_entered_at_once_an_outline_edge_is_hit(void)
{
    tuff_polygon marked = box;
    for (uint8_t turn = 0; turn < 2; turn++) {
        setUp();
        marked.internal_edges = turn ? 2 : 4;
        place(2, W(50), W(50), &marked, 1);
        TEST_ASSERT_TRUE(first_hit(whole(80, 80), whole(40, 40)));   /* the corner (60, 60) */
        ASSERT_BEAM_HIT(2, TUFF_UNIT_RATIO(1, 2), turn ? 0 : ONE, turn ? ONE : 0);
    }
}

static void test_of_two_parts_the_nearer_is_hit_whatever_their_order(void)
{
    DEFINE_PAIR_OF_BOXES(parts, 4, 10, box_normals, 0, 0);
    place(1, W(50), W(50), parts, 2);
    TEST_ASSERT_TRUE(first_hit(whole(0, 50), whole(100, 50)));
    ASSERT_BEAM_HIT(1, TUFF_UNIT_RATIO(2, 5), -ONE, 0);
    TEST_ASSERT_TRUE(first_hit(whole(100, 50), whole(0, 50)));
    ASSERT_BEAM_HIT(1, TUFF_UNIT_RATIO(2, 5), ONE, 0);
    TEST_ASSERT_TRUE(first_hit(whole(50, 50), whole(0, 50)));
    ASSERT_BEAM_HIT(1, TUFF_UNIT_RATIO(4, 50), ONE, 0);
}

static void test_the_nearest_piece_is_hit_first(void)
{
    place(0, W(150), W(50), &box, 1);
    place(1, W(100), W(50), &box, 1);
    place(3, W(200), W(50), NULL, 0);
    TEST_ASSERT_TRUE(first_hit(whole(0, 50), whole(400, 50)));
    ASSERT_BEAM_HIT(1, TUFF_UNIT_RATIO(90, 400), -ONE, 0);
    TEST_ASSERT_TRUE(first_hit(whole(400, 50), whole(0, 50)));
    ASSERT_BEAM_HIT(3, TUFF_UNIT_RATIO(190, 400), ONE, 0);
}

static void test_nothing_hit_leaves_the_report_alone(void)
{
    place(2, W(50), W(50), &box, 1);
    TEST_ASSERT_FALSE(first_hit(whole(0, 61), whole(100, 61)));
    TEST_ASSERT_FALSE(first_hit(whole(0, 50), whole(39, 50)));
    TEST_ASSERT_EQUAL_INT(777, hit.piece);
    ASSERT_SAME(TUFF_UNIT_RATIO(-1, 3), hit.fraction);
    ASSERT_VEC_SAME(TUFF_UNIT_RATIO(1, 8), TUFF_UNIT_RATIO(-1, 8), hit.normal);
}

static void test_an_end_that_touches_is_a_hit_at_the_whole_length(void)
{
    place(2, W(50), W(50), &box, 1);
    TEST_ASSERT_TRUE(first_hit(whole(0, 50), whole(40, 50)));
    ASSERT_BEAM_HIT(2, ONE, -ONE, 0);
}

static void test_a_start_inside_is_fraction_zero_with_the_normal_against_the_beam(void)
{
    place(2, W(50), W(50), &box, 1);
    TEST_ASSERT_TRUE(first_hit(whole(50, 50), whole(80, 90)));
    ASSERT_SAME(0, hit.fraction);
    ASSERT_BEAM_HIT(2, 0, TUFF_UNIT_RATIO(-3, 5), TUFF_UNIT_RATIO(-4, 5));
    TEST_ASSERT_TRUE(first_hit(whole(55, 45), whole(52, 45)));
    ASSERT_BEAM_HIT(2, 0, ONE, 0);
}

static void test_no_length_inside_is_fraction_zero_with_plus_x(void)
{
    place(1, W(50), W(50), &box, 1);
    place(2, W(150), W(50), NULL, 0);
    TEST_ASSERT_TRUE(first_hit(whole(53, 47), whole(53, 47)));
    ASSERT_SAME(0, hit.fraction);
    ASSERT_BEAM_HIT(1, 0, ONE, 0);
    TEST_ASSERT_TRUE(first_hit(whole(153, 47), whole(153, 47)));
    ASSERT_SAME(0, hit.fraction);
    ASSERT_BEAM_HIT(2, 0, ONE, 0);
}

static void test_a_circle_is_hit_on_its_rim(void)
{
    place(2, W(50), W(50), NULL, 0);
    TEST_ASSERT_TRUE(first_hit(whole(0, 58), whole(100, 58)));   /* enters at (44, 58): (-6, 8) from the center */
    ASSERT_WITHIN(UNIT_STEPS(16384, 64), TUFF_UNIT_RATIO(44, 100), hit.fraction);
    ASSERT_WITHIN(UNIT_STEPS(8192, 128), TUFF_UNIT_RATIO(-3, 5), hit.normal.x);
    ASSERT_WITHIN(UNIT_STEPS(8192, 128), TUFF_UNIT_RATIO(4, 5), hit.normal.y);
    TEST_ASSERT_TRUE(first_hit(whole(50, 50), whole(50, 90)));
    ASSERT_BEAM_HIT(2, 0, 0, -ONE);
}

static void test_a_tangent_is_hit_where_it_touches(void)
{
    place(2, W(50), W(50), NULL, 0);
    TEST_ASSERT_TRUE(first_hit(whole(0, 60), whole(100, 60)));
    ASSERT_WITHIN(UNIT_STEPS(INT32_C(1) << 20, 20000), TUFF_UNIT_RATIO(1, 2), hit.fraction);
    TEST_ASSERT_TRUE(hit.normal.y > TUFF_UNIT_RATIO(99, 100));
}

static void test_ties_go_to_the_lowest_piece(void)
{
    for (uint8_t turn = 0; turn < 2; turn++) {
        setUp();
        place(turn ? 3 : 1, W(50), W(40), &box, 1);
        place(turn ? 1 : 3, W(50), W(60), &box, 1);
        TEST_ASSERT_TRUE(first_hit(whole(0, 50), whole(100, 50)));
        ASSERT_BEAM_HIT(1, TUFF_UNIT_RATIO(2, 5), -ONE, 0);
        TEST_ASSERT_TRUE(first_hit(whole(45, 50), whole(100, 50)));
        ASSERT_BEAM_HIT(1, 0, -ONE, 0);
    }
}

/* Two parts with a shared edge across the beam: entered at the outline, never inside the piece. */
static void test_a_piece_of_parts_is_hit_at_its_outline(void)
{
    place(0, W(50), W(50), halves, 2);
    TEST_ASSERT_TRUE(first_hit(whole(0, 50), whole(100, 50)));
    ASSERT_BEAM_HIT(0, TUFF_UNIT_RATIO(2, 5), -ONE, 0);
    TEST_ASSERT_TRUE(first_hit(whole(50, 0), whole(50, 100)));
    ASSERT_BEAM_HIT(0, TUFF_UNIT_RATIO(2, 5), 0, -ONE);
    TEST_ASSERT_TRUE(first_hit(whole(100, 50), whole(50, 50)));
    ASSERT_BEAM_HIT(0, TUFF_UNIT_RATIO(4, 5), ONE, 0);
}

static void test_a_beam_that_ends_at_the_seam_of_two_parts_is_inside(void)
{
    place(0, W(50), W(50), halves, 2);
    TEST_ASSERT_TRUE(first_hit(whole(50, 50), whole(90, 50)));
    ASSERT_SAME(0, hit.fraction);
    ASSERT_BEAM_HIT(0, 0, -ONE, 0);
}

static void test_the_hit_of_the_longest_beam_is_as_exact_as_it_says(void)
{
    place(0, 0, 0, &box, 1);
    TEST_ASSERT_TRUE(first_hit(vec(LOWEST, 0), vec(HIGHEST, 0)));   /* 32,758 of 65,536 */
    ASSERT_WITHIN(UNIT_STEPS(6, 16), TUFF_UNIT_RATIO(INT32_C(32758), INT32_C(65536)), hit.fraction);
    ASSERT_UNIT(-ONE, hit.normal.x);
    TEST_ASSERT_TRUE(first_hit(vec(0, HIGHEST), vec(0, LOWEST)));
    ASSERT_WITHIN(UNIT_STEPS(40000, 16), TUFF_UNIT_RATIO(INT32_C(32758), INT32_C(65536)), hit.fraction);
    ASSERT_UNIT(ONE, hit.normal.y);
}

/* Every share of a long oblique beam, where products have up to 61 bits. */
static void test_fractions_are_right_all_along_a_long_beam(void)
{
    for (int16_t i = 1; i < 32; i++) {
        setUp();
        place(0, tuff_from_int(INT32_C(900) * i - 15000), tuff_from_int(INT32_C(450) * i - 7500), &box, 1);
        TEST_ASSERT_TRUE(first_hit(whole(-15000, -7500), whole(15000, 7500)));   /* the face is 10 before the middle */
        ASSERT_WITHIN(UNIT_STEPS(2048, 64), TUFF_UNIT_RATIO(INT32_C(900) * i - 10, INT32_C(30000)), hit.fraction);
        ASSERT_UNIT(-ONE, hit.normal.x);
    }
}

static void test_empty_slots_and_bad_worlds_are_not_hit(void)
{
    static const tuff_world zero;
    place(1, 0, 0, &box, 1);
    terrain[1].bounding_radius = 0;
    TEST_ASSERT_FALSE(first_hit(whole(-50, 0), whole(50, 0)));
    terrain[1].bounding_radius = W(15);
    world.terrain_count = 1;
    TEST_ASSERT_FALSE(first_hit(whole(-50, 0), whole(50, 0)));
    TEST_ASSERT_FALSE(tuff_segment_terrain_first_hit(NULL, whole(-50, 0), whole(50, 0), &hit));
    TEST_ASSERT_FALSE(tuff_segment_terrain_first_hit(&zero, whole(-50, 0), whole(50, 0), &hit));
    world.terrain = NULL;
    TEST_ASSERT_FALSE(tuff_segment_terrain_first_hit(&world, whole(-50, 0), whole(50, 0), &hit));
    TEST_ASSERT_EQUAL_INT(777, hit.piece);
}

static void test_not_a_number_hits_nothing(void)
{
    place(1, 0, 0, &box, 1);
    TEST_ASSERT_FALSE(first_hit(vec(NOT_A_NUMBER, 0), whole(50, 0)));
    TEST_ASSERT_FALSE(first_hit(whole(-50, 0), vec(INFINITE, 0)));
    TEST_ASSERT_EQUAL_INT(777, hit.piece);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_face_is_hit_where_the_beam_enters_it);
    RUN_TEST(test_of_two_edges_the_one_entered_last_is_hit);
    RUN_TEST(test_of_edges_entered_at_once_an_outline_edge_is_hit);
    RUN_TEST(test_of_two_parts_the_nearer_is_hit_whatever_their_order);
    RUN_TEST(test_the_nearest_piece_is_hit_first);
    RUN_TEST(test_nothing_hit_leaves_the_report_alone);
    RUN_TEST(test_an_end_that_touches_is_a_hit_at_the_whole_length);
    RUN_TEST(test_a_start_inside_is_fraction_zero_with_the_normal_against_the_beam);
    RUN_TEST(test_no_length_inside_is_fraction_zero_with_plus_x);
    RUN_TEST(test_a_circle_is_hit_on_its_rim);
    RUN_TEST(test_a_tangent_is_hit_where_it_touches);
    RUN_TEST(test_ties_go_to_the_lowest_piece);
    RUN_TEST(test_a_piece_of_parts_is_hit_at_its_outline);
    RUN_TEST(test_a_beam_that_ends_at_the_seam_of_two_parts_is_inside);
    RUN_TEST(test_the_hit_of_the_longest_beam_is_as_exact_as_it_says);
    RUN_TEST(test_fractions_are_right_all_along_a_long_beam);
    RUN_TEST(test_empty_slots_and_bad_worlds_are_not_hit);
    if (!IS_FIXED) RUN_TEST(test_not_a_number_hits_nothing);
    return UNITY_END();
}
