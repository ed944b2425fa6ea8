/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What is no way out for a hull: corners and sides between the parts of a piece, and between pieces that lie flush. DESIGN 2 ("Concave
   outlines stay exact", "Resolution free of insertion order"). */
#include "shapes.h"

#include "inner.h"

#define PIECES 10

/* Edges of a box and of a column: 0 its top (y grows downwards), 1 its right side, 3 its left one. */
#define TOP        0
#define RIGHT_SIDE 1
#define RIGHT      2   /* as marks */
#define LEFT       8
#define ALL        15

DEFINE_BOX(box, -10, -10, 10, 10);
DEFINE_BOX(hull, -4, -4, 4, 4);
static const tuff_vec2 diamond_vertices[4] = DIAMOND_VERTICES;
static const tuff_polygon diamond = { diamond_vertices, NULL, 0, 4 };
static const tuff_material dead = { 0, 0 };

static tuff_unit2 scratch[4];
static tuff_mover mover;
static tuff_terrain terrain[PIECES];
static tuff_world world;

void setUp(void)
{
    static const tuff_terrain empty;
    TEST_ASSERT_TRUE(tuff_hull_mover(&mover, W(6), &hull, scratch));
    mover.shape.piece = NULL;
    mover.terrain = terrain;
    for (uint8_t i = 0; i < PIECES; i++) terrain[i] = empty;
    world.terrain = terrain;
    world.terrain_count = PIECES;
    world.order = TUFF_ORDER_DEEPEST;
}

void tearDown(void) {}

/* With the hull at this offset. */
static bool edge_beside(tuff_vec2 offset, const tuff_polygon *part, uint8_t edge)
{
    mover.shape.offset = offset;
    return tuff_edge_beside(&mover, part, edge);
}

static bool edge_buried(tuff_vec2 offset, const tuff_polygon *part, uint8_t edge)
{
    mover.shape.offset = offset;
    return tuff_edge_buried(&mover, part, edge);
}

/* ------------------------------------------------------------------------------------------------------- columns */

static tuff_vec2 column_vertices[2][4];
static tuff_unit2 column_normals[2][4];
static tuff_polygon columns[2];

/* A left and a right column that share the side x = 0, marked. Their tops meet at the origin: the left one's vertex 1, the right one's 0.
   The outer ends, 40 away, lie lower by so much: 30 makes a normal of (-3, -4) / 5 or (3, -4) / 5. */
static void make_columns(int16_t left_drop, int16_t right_drop)
{
    for (uint8_t i = 0; i < 2; i++) {
        tuff_vec2 *v = column_vertices[i];
        v[0] = i == 0 ? whole(-40, left_drop) : whole(0, 0);
        v[1] = i == 0 ? whole(0, 0) : whole(40, right_drop);
        v[2] = whole(i == 0 ? 0 : 40, 60);
        v[3] = whole(i == 0 ? -40 : 0, 60);
        columns[i] = baked(v, 4, column_normals[i]);
        columns[i].internal_edges = i == 0 ? RIGHT : LEFT;
    }
    terrain[0] = piece_of(whole(0, 0), W(20), columns, 2);
    terrain[0].bounding_radius = W(80);
    mover.shape.piece = &terrain[0];
}

/* Axis (x, y) / denominator at the corner where the columns meet. */
static bool left_corner_is_internal(int16_t x, int16_t y, int16_t denominator)
{
    tuff_unit2 axis = { TUFF_UNIT_RATIO(x, denominator), TUFF_UNIT_RATIO(y, denominator) };
    return tuff_corner_is_internal(&mover, &columns[0], 1, axis);
}

/* The same axis mirrored, as the columns are. */
static bool right_corner_is_internal(int16_t x, int16_t y, int16_t denominator)
{
    tuff_unit2 axis = { TUFF_UNIT_RATIO(-x, denominator), TUFF_UNIT_RATIO(y, denominator) };
    return tuff_corner_is_internal(&mover, &columns[1], 0, axis);
}

#define ASSERT_CORNERS(expected, x, y, denominator) \
    do { TEST_ASSERT_EQUAL_INT((expected), left_corner_is_internal((x), (y), (denominator))); \
         TEST_ASSERT_EQUAL_INT((expected), right_corner_is_internal((x), (y), (denominator))); } while (0)

/* ------------------------------------------------------------------------------------------------------- corners */

static void test_a_corner_between_two_internal_edges_is_internal_and_one_between_two_of_the_outline_is_not(void)
{
    static const tuff_unit2 axis = { TUFF_UNIT_RATIO(3, 5), TUFF_UNIT_RATIO(-4, 5) };
    tuff_polygon part = box;
    TEST_ASSERT_FALSE(tuff_corner_is_internal(&mover, &part, 1, axis));
    part.internal_edges = 3;
    TEST_ASSERT_TRUE(tuff_corner_is_internal(&mover, &part, 1, axis));
}

static void test_where_the_outline_goes_straight_on_the_corner_is_internal(void)
{
    make_columns(0, 0);
    ASSERT_CORNERS(true, 0, -1, 1);
    ASSERT_CORNERS(true, 3, -4, 5);
}

static void test_where_the_outline_goes_on_concave_the_corner_is_internal(void)
{
    make_columns(-30, -30);
    ASSERT_CORNERS(true, 3, -4, 5);
    ASSERT_CORNERS(true, 4, -3, 5);
}

/* The outline's normals there lie between (-3, -4) / 5 and (3, -4) / 5. */
static void test_where_the_outline_goes_on_convex_an_axis_between_its_normals_is_outline_and_one_beyond_is_internal(void)
{
    make_columns(30, 30);
    ASSERT_CORNERS(false, 0, -1, 1);
    ASSERT_CORNERS(false, 7, -24, 25);
    ASSERT_CORNERS(true, 4, -3, 5);
}

/* No piece, a piece of one part, and one whose other part has no outline there. */
static void test_where_no_other_part_goes_on_the_nearer_normal_tells(void)
{
    for (uint8_t known = 0; known < 3; known++) {
        make_columns(0, 0);
        if (known == 0) mover.shape.piece = NULL;
        if (known == 1) terrain[0].part_count = 1;
        if (known == 2) columns[1].internal_edges = ALL;
        TEST_ASSERT_FALSE(left_corner_is_internal(3, -4, 5));
        TEST_ASSERT_TRUE(left_corner_is_internal(4, -3, 5));
    }
}

/* The left column's least axis is the diamond's own, and no such normal is in the floor's outline. */
static void test_a_hulls_own_axis_at_a_seam_is_not_taken_and_at_an_outline_corner_is(void)
{
    tuff_contact c = marked_contact();
    make_columns(0, 0);
    TEST_ASSERT_TRUE(tuff_polygon_polygon(&diamond, whole(1, -3), &columns[0], &c));
    TEST_ASSERT_TRUE(c.overlap < W(2) && c.normal.x > TUFF_UNIT_RATIO(1, 2));
    TEST_ASSERT_TRUE(tuff_terrain_overlap_hull(&terrain[0], whole(1, -3), W(5), &diamond, &c));
    ASSERT_CONTACT(W(2), 0, -ONE, c);
    TEST_ASSERT_TRUE(tuff_terrain_overlap_hull(&terrain[0], whole(42, -2), W(5), &diamond, &c));   /* 1 / sqrt(2) deep at (40, 0) */
    ASSERT_CONTACT(TUFF_REAL_RAW(46341), HALF_ROOT, -HALF_ROOT, c);
    TEST_ASSERT_TRUE(tuff_terrain_overlap_hull(&terrain[0], whole(-42, -2), W(5), &diamond, &c));
    ASSERT_CONTACT(TUFF_REAL_RAW(46341), -HALF_ROOT, -HALF_ROOT, c);
}

/* ------------------------------------------------------------------------------------------------- beside an edge */

static bool beside_top(uint8_t column, int16_t x)
{
    return edge_beside(whole(x, -3), &columns[column], TOP);
}

static void test_a_hull_is_beside_an_edge_only_wholly_beyond_its_internal_end(void)
{
    make_columns(0, 0);
    TEST_ASSERT_FALSE(beside_top(0, -20));
    TEST_ASSERT_FALSE(beside_top(0, 3));
    TEST_ASSERT_FALSE(beside_top(0, 4));
    TEST_ASSERT_TRUE(beside_top(0, 5));
    TEST_ASSERT_FALSE(beside_top(1, 20));
    TEST_ASSERT_FALSE(beside_top(1, -3));
    TEST_ASSERT_FALSE(beside_top(1, -4));
    TEST_ASSERT_TRUE(beside_top(1, -5));
}

static void test_beyond_an_end_where_the_outline_goes_on_a_hull_is_not_beside_an_edge(void)
{
    make_columns(0, 0);
    TEST_ASSERT_FALSE(beside_top(0, -50));
    TEST_ASSERT_FALSE(beside_top(1, 50));
    columns[0].internal_edges = 0;
    TEST_ASSERT_FALSE(beside_top(0, 5));
}

static void test_a_hull_is_beside_an_edge_in_either_winding(void)
{
    DEFINE_BOX_REVERSED(reversed, -10, -10, 10, 10);   /* edge 3 is the top, from right to left; 2 the right side */
    tuff_polygon part = reversed;
    part.internal_edges = 4;
    TEST_ASSERT_TRUE(edge_beside(whole(15, -13), &part, 3));
    TEST_ASSERT_FALSE(edge_beside(whole(0, -13), &part, 3));
    TEST_ASSERT_FALSE(edge_beside(whole(-15, -13), &part, 3));
}

/* --------------------------------------------------------------------------------------------------------- buried */

/* A box at (100, -50), whose edges are asked about, and another one from there by this much. */
static void make_neighbors(tuff_real x, tuff_real y)
{
    terrain[0] = piece_of(whole(100, -50), W(5), &box, 1);
    terrain[1] = piece_of(vec(W(100) + x, W(-50) + y), W(5), &box, 1);
    mover.shape.piece = &terrain[0];
    mover.neighbors[0] = 0;
    mover.neighbors[1] = 1;
    mover.shape.neighbor_count = 2;
    mover.shape.seams = true;
}

static bool right_side_buried(int16_t y)
{
    return edge_buried(whole(12, y), &box, RIGHT_SIDE);
}

static bool top_buried(int16_t x)
{
    return edge_buried(whole(x, -12), &box, TOP);
}

static void test_a_side_that_a_neighbor_covers_is_buried_wherever_the_hull_is(void)
{
    make_neighbors(W(20), 0);
    for (int16_t y = -15; y <= 15; y = (int16_t)(y + 5)) TEST_ASSERT_TRUE(right_side_buried(y));
}

static void test_a_side_that_a_neighbor_covers_by_half_is_buried_only_there(void)
{
    make_neighbors(W(20), W(10));   /* the neighbor's top is at 0 */
    TEST_ASSERT_TRUE(right_side_buried(15));
    TEST_ASSERT_TRUE(right_side_buried(5));
    TEST_ASSERT_FALSE(right_side_buried(3));
    TEST_ASSERT_FALSE(right_side_buried(-5));
    TEST_ASSERT_FALSE(right_side_buried(-15));
    make_neighbors(W(20), W(-10));
    TEST_ASSERT_TRUE(right_side_buried(-5));
    TEST_ASSERT_FALSE(right_side_buried(-3));
}

static void test_a_side_that_a_neighbor_covers_but_does_not_rise_from_is_not_buried(void)
{
    make_neighbors(W(5), 0);
    TEST_ASSERT_FALSE(top_buried(0));
    make_neighbors(W(5), W(-1));
    TEST_ASSERT_TRUE(top_buried(0));
}

/* Two LSB, or 1e-4 units, are what a push may leave. */
static void test_a_gap_or_a_step_of_a_residue_is_none(void)
{
    make_neighbors(W(20) + STEPS(2, 100), 0);
    TEST_ASSERT_TRUE(right_side_buried(0));
    make_neighbors(W(20) + STEPS(3, 500), 0);
    TEST_ASSERT_FALSE(right_side_buried(0));
    make_neighbors(W(5), -STEPS(2, 100));
    TEST_ASSERT_FALSE(top_buried(0));
    make_neighbors(W(5), -STEPS(3, 500));
    TEST_ASSERT_TRUE(top_buried(0));
}

/* A piece's own parts are told by their marks. */
static void test_a_piece_does_not_bury_its_own_sides(void)
{
    make_columns(0, 0);
    mover.neighbors[0] = 0;
    mover.shape.neighbor_count = 1;
    TEST_ASSERT_FALSE(edge_buried(whole(3, 20), &columns[0], RIGHT_SIDE));
    terrain[1] = terrain[0];
    mover.neighbors[0] = 1;
    TEST_ASSERT_TRUE(edge_buried(whole(3, 20), &columns[0], RIGHT_SIDE));
}

static void test_a_neighbor_that_is_not_baked_buries_nothing(void)
{
    tuff_polygon unbaked = box;
    make_neighbors(W(20), 0);
    terrain[1].parts = &unbaked;
    TEST_ASSERT_TRUE(right_side_buried(0));
    unbaked.normals = NULL;
    TEST_ASSERT_FALSE(right_side_buried(0));
    terrain[1].parts = NULL;
    TEST_ASSERT_FALSE(right_side_buried(0));
}

/* Corner 1 of the box: the neighbor is flush, or stands 5 higher. */
static void test_a_corner_that_a_neighbor_rises_from_is_internal_while_seams_matter(void)
{
    static const tuff_unit2 up = { 0, TUFF_UNIT_RATIO(-1, 1) };
    static const tuff_unit2 across = { TUFF_UNIT_RATIO(3, 5), TUFF_UNIT_RATIO(-4, 5) };
    make_neighbors(W(20), 0);
    TEST_ASSERT_TRUE(tuff_corner_is_internal(&mover, &box, 1, across));
    TEST_ASSERT_FALSE(tuff_corner_is_internal(&mover, &box, 1, up));
    make_neighbors(W(20), W(-5));
    TEST_ASSERT_TRUE(tuff_corner_is_internal(&mover, &box, 1, up));
    TEST_ASSERT_FALSE(tuff_corner_is_internal(&mover, &box, 0, up));
    mover.shape.seams = false;
    TEST_ASSERT_FALSE(tuff_corner_is_internal(&mover, &box, 1, across));
}

/* -------------------------------------------------------------------------------------------------------- sliding */

/* The columns as one piece of two marked parts, or as two pieces; the left column first or second. */
enum { MARKED = 0, SEPARATE = 2 };

static void make_form(uint8_t form, int16_t left_drop, int16_t right_drop)
{
    make_columns(left_drop, right_drop);
    if (form % 2 != 0) {
        tuff_polygon left = columns[0];
        columns[0] = columns[1];
        columns[1] = left;
    }
    if (form < SEPARATE) return;
    for (uint8_t i = 0; i < 2; i++) {
        columns[i].internal_edges = 0;
        terrain[i] = piece_of(whole(0, 0), W(20), &columns[i], 1);
        terrain[i].bounding_radius = W(80);
    }
}

/* Down to the right: its outward normal is (3, -4) / 5. */
static void make_slope(uint8_t form)
{
    make_form(form, -30, 30);
}

/* A box whose lower left corner is so far right of the seam and so far below the slope, sliding along the slope and sinking by 1. */
static tuff_body sinking_body(tuff_real right, tuff_real below, int16_t way)
{
    tuff_vec2 position = vec(right + W(4), right * 3 / 4 + below - W(4));
    return body_of(position, whole((int16_t)(4 * way), (int16_t)(3 * way + 1)), &dead);
}

/* The push is 4 / 5 of the depth along the normal; of the velocity it takes what goes inwards, (-12, 16) / 25. */
static void assert_slides(tuff_real right, tuff_real below, int16_t way)
{
    tuff_body body = sinking_body(right, below, way);
    tuff_vec2 start = body.position;
    uint16_t pushes = tuff_terrain_collide(&world, &body, W(6), &hull);
    TEST_ASSERT_TRUE(pushes > 0 && pushes < TUFF_MAX_PUSHES);
    ASSERT_WITHIN(STEPS(4, 40), start.x + below * 12 / 25, body.position.x);
    ASSERT_WITHIN(STEPS(4, 40), start.y - below * 16 / 25, body.position.y);
    ASSERT_WITHIN(STEPS(4, 40), W(4) * way + TUFF_RATIO(12, 25), body.velocity.x);
    ASSERT_WITHIN(STEPS(4, 40), W(3) * way + TUFF_RATIO(9, 25), body.velocity.y);
}

/* The corner from 3 / 4 left of the seam to 3 / 4 right of it, 1 deep: from there the left column's nearest way out is to the right, and
   the right column's is up. */
static void slide_over_the_seam(uint8_t form)
{
    make_slope(form);
    for (int16_t way = -1; way <= 1; way = (int16_t)(way + 2)) {
        for (int16_t right = -12; right <= 12; right++) assert_slides(TUFF_RATIO(right, 16), W(1), way);
    }
}

static void test_a_box_slides_over_the_seam_of_marked_parts(void)
{
    for (uint8_t order = TUFF_ORDER_ITERATION; order <= TUFF_ORDER_DEEPEST; order++) {
        world.order = order;
        slide_over_the_seam(MARKED);
        slide_over_the_seam(MARKED + 1);
    }
}

static void test_a_box_slides_over_the_seam_of_separate_pieces_deepest_first(void)
{
    slide_over_the_seam(SEPARATE);
    slide_over_the_seam(SEPARATE + 1);
}

/* Along the slope and nothing else, with the corner over the seam, and below the slope, by no more than a push leaves. */
static void test_a_residue_at_a_seam_does_not_turn_the_velocity_deepest_first(void)
{
    for (uint8_t i = 0; i < 2 * 3 * 5 * 2; i++) {
        int16_t way = i % 2 == 0 ? 1 : -1;
        tuff_body body = sinking_body((i / 2 % 3) * -STEPS(1, 40), (i / 6 % 5) * STEPS(1, 40), way);
        make_slope((uint8_t)(SEPARATE + i / 30));
        body.velocity = whole((int16_t)(4 * way), (int16_t)(3 * way));
        TEST_ASSERT_TRUE(tuff_terrain_collide(&world, &body, W(6), &hull) < TUFF_MAX_PUSHES);
        ASSERT_WITHIN(STEPS(4, 40), W(4) * way, body.velocity.x);
        ASSERT_WITHIN(STEPS(4, 40), W(3) * way, body.velocity.y);
    }
}

static void assert_goes(tuff_vec2 from, const tuff_polygon *mover_hull, tuff_real x, tuff_real y)
{
    tuff_body body = body_of(from, vec(0, 0), &dead);
    TEST_ASSERT_EQUAL_INT(1, tuff_terrain_collide(&world, &body, W(6), mover_hull));
    ASSERT_VEC(x, y, body.position);
}

/* The left column is to be left by 13 / 2 upwards, for its right side is buried; the right one by 29 / 5 of its own. */
static void test_a_contact_by_an_outline_edge_comes_before_a_deeper_one_that_had_to_do_without(void)
{
    for (uint8_t form = SEPARATE; form < SEPARATE + 2; form++) {
        make_form(form, 0, 30);
        assert_goes(vec(W(3), TUFF_RATIO(5, 2)), &hull, TUFF_RATIO(162, 25), TUFF_RATIO(-107, 50));
    }
}

/* Deep under a ridge: 21 by the left column's top, 22.2 by the right one's. */
static void test_of_contacts_that_had_to_do_without_an_outline_edge_the_least_is_taken(void)
{
    for (uint8_t form = SEPARATE; form < SEPARATE + 2; form++) {
        make_form(form, 30, 30);
        assert_goes(whole(-1, 20), &hull, TUFF_RATIO(-68, 5), TUFF_RATIO(16, 5));
        assert_goes(whole(1, 20), &hull, TUFF_RATIO(68, 5), TUFF_RATIO(16, 5));
    }
}

/* Under the flat left column, half a unit deep in the rising right one, whose top is no way out there. */
static void test_a_top_that_the_hull_is_beside_is_not_taken(void)
{
    for (uint8_t form = MARKED; form < MARKED + 2; form++) {
        make_form(form, 0, -30);
        assert_goes(vec(TUFF_RATIO(-9, 2), TUFF_RATIO(11, 2)), &diamond, TUFF_RATIO(-9, 2), W(-5));
    }
}

/* A floor of tiles 4 wide. */
static void test_a_hull_that_meets_more_pieces_than_it_minds_is_still_pushed_out(void)
{
    DEFINE_BOX(tile, -2, -2, 2, 2);
    DEFINE_BOX(plank, -17, -4, 21, 4);
    for (uint8_t i = 0; i < PIECES; i++) terrain[i] = piece_of(whole((int16_t)(4 * i - 16), 2), W(2), &tile, 1);
    for (uint8_t count = TUFF_MOST_NEIGHBORS; count <= PIECES; count++) {
        tuff_body body = body_of(vec(0, TUFF_RATIO(-7, 2)), whole(5, 2), &dead);
        world.terrain_count = count;
        TEST_ASSERT_EQUAL_INT(1, tuff_terrain_collide(&world, &body, W(22), &plank));
        ASSERT_VEC_SAME(0, W(-4), body.position);
        ASSERT_VEC_SAME(W(5), 0, body.velocity);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_corner_between_two_internal_edges_is_internal_and_one_between_two_of_the_outline_is_not);
    RUN_TEST(test_where_the_outline_goes_straight_on_the_corner_is_internal);
    RUN_TEST(test_where_the_outline_goes_on_concave_the_corner_is_internal);
    RUN_TEST(test_where_the_outline_goes_on_convex_an_axis_between_its_normals_is_outline_and_one_beyond_is_internal);
    RUN_TEST(test_where_no_other_part_goes_on_the_nearer_normal_tells);
    RUN_TEST(test_a_hulls_own_axis_at_a_seam_is_not_taken_and_at_an_outline_corner_is);
    RUN_TEST(test_a_hull_is_beside_an_edge_only_wholly_beyond_its_internal_end);
    RUN_TEST(test_beyond_an_end_where_the_outline_goes_on_a_hull_is_not_beside_an_edge);
    RUN_TEST(test_a_hull_is_beside_an_edge_in_either_winding);
    RUN_TEST(test_a_side_that_a_neighbor_covers_is_buried_wherever_the_hull_is);
    RUN_TEST(test_a_side_that_a_neighbor_covers_by_half_is_buried_only_there);
    RUN_TEST(test_a_side_that_a_neighbor_covers_but_does_not_rise_from_is_not_buried);
    RUN_TEST(test_a_gap_or_a_step_of_a_residue_is_none);
    RUN_TEST(test_a_piece_does_not_bury_its_own_sides);
    RUN_TEST(test_a_neighbor_that_is_not_baked_buries_nothing);
    RUN_TEST(test_a_corner_that_a_neighbor_rises_from_is_internal_while_seams_matter);
    RUN_TEST(test_a_box_slides_over_the_seam_of_marked_parts);
    RUN_TEST(test_a_box_slides_over_the_seam_of_separate_pieces_deepest_first);
    RUN_TEST(test_a_residue_at_a_seam_does_not_turn_the_velocity_deepest_first);
    RUN_TEST(test_a_contact_by_an_outline_edge_comes_before_a_deeper_one_that_had_to_do_without);
    RUN_TEST(test_of_contacts_that_had_to_do_without_an_outline_edge_the_least_is_taken);
    RUN_TEST(test_a_top_that_the_hull_is_beside_is_not_taken);
    RUN_TEST(test_a_hull_that_meets_more_pieces_than_it_minds_is_still_pushed_out);
    return UNITY_END();
}
