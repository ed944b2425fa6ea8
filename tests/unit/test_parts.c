/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The rule for the parts of a piece: of the contacts with them the one that leads out of the whole outline. DESIGN 2 ("Concave outlines
   stay exact"). */
#include "shapes.h"

#include "inner.h"

static const tuff_unit2 normals[4] = BOX_NORMALS;   /* edges: 0 down (0, -1), 1 right, 2 up, 3 left */

#define DOWN  1
#define RIGHT 2
#define UP    4
#define LEFT  8

/* A floor of two flush boxes, 40 wide and 30 thick; its surface is y = 0 and faces (0, -1). */
static const tuff_vec2 floor_left[4] = BOX_VERTICES(-20, 0, 0, 30);
static const tuff_vec2 floor_right[4] = BOX_VERTICES(0, 0, 20, 30);
static const tuff_polygon floor_parts[2] = { { floor_left, normals, RIGHT, 4 }, { floor_right, normals, LEFT, 4 } };
static const tuff_terrain flat_floor = { { 0, 0 }, W(20), W(40), floor_parts, 2 };

/* An L of three boxes: 10 thick, its notch at (10, 10) open to +x and +y. */
static const tuff_vec2 corner_box[4] = BOX_VERTICES(0, 0, 10, 10);
static const tuff_vec2 foot_box[4] = BOX_VERTICES(10, 0, 40, 10);
static const tuff_vec2 leg_box[4] = BOX_VERTICES(0, 10, 10, 40);
static const tuff_polygon l_parts[3] = { { corner_box, normals, RIGHT | UP, 4 },
                                         { foot_box, normals, LEFT, 4 },
                                         { leg_box, normals, DOWN, 4 } };
static const tuff_terrain l_shape = { { 0, 0 }, W(20), W(60), l_parts, 3 };

/* Point downward: the tip at (0, 4). */
static const tuff_vec2 dart_vertices[3] = { { 0, W(4) }, { W(-5), W(-4) }, { W(5), W(-4) } };
static const tuff_polygon dart = { dart_vertices, NULL, 0, 3 };

void setUp(void) {}
void tearDown(void) {}

static tuff_contact circle_contact(const tuff_terrain *piece, tuff_vec2 center, tuff_real radius)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_terrain_overlap_circle(piece, center, radius, &c));
    return c;
}

static tuff_contact hull_contact(const tuff_terrain *piece, tuff_vec2 position, const tuff_polygon *hull)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(tuff_terrain_overlap_hull(piece, position, W(8), hull, &c));
    return c;
}

static void test_a_flat_floor_of_two_parts_pushes_straight_up_at_its_seam(void)
{
    for (int8_t x = -6; x <= 6; x++) {
        tuff_contact c = circle_contact(&flat_floor, vec(tuff_from_int(x) / 2, W(-2)), W(5));
        ASSERT_CONTACT(W(3), 0, -ONE, c);
    }
}

/* The center is deeper than it is far from the seam: each part alone would push sideways, through its internal edge. */
static void test_a_deep_circle_at_the_seam_is_not_pushed_sideways(void)
{
    for (int8_t x = -3; x <= 3; x++) {
        tuff_contact c = circle_contact(&flat_floor, vec(tuff_from_int(x) / 4, W(1)), W(5));
        ASSERT_CONTACT(W(6), 0, -ONE, c);
    }
}

static void test_a_sharp_hull_at_the_seam_is_not_pushed_sideways(void)
{
    for (int8_t x = -4; x <= 4; x++) {
        tuff_contact c = hull_contact(&flat_floor, vec(tuff_from_int(x) / 8, W(-1)), &dart);
        ASSERT_CONTACT(W(3), 0, -ONE, c);
    }
}

static void test_an_outline_vertex_still_pushes_away_from_itself(void)
{
    tuff_contact c = circle_contact(&flat_floor, whole(23, -4), W(6));
    ASSERT_CONTACT(W(1), TUFF_UNIT_RATIO(3, 5), TUFF_UNIT_RATIO(-4, 5), c);
}

static void test_the_ends_of_the_floor_are_outline(void)
{
    tuff_contact c = circle_contact(&flat_floor, whole(22, 15), W(5));
    ASSERT_CONTACT(W(3), ONE, 0, c);
    c = circle_contact(&flat_floor, whole(-22, 15), W(5));
    ASSERT_CONTACT(W(3), -ONE, 0, c);
}

static void test_in_a_notch_the_deepest_part_goes_first(void)
{
    tuff_contact c = circle_contact(&l_shape, vec(W(13), TUFF_RATIO(25, 2)), W(5));
    ASSERT_CONTACT(TUFF_RATIO(5, 2), 0, ONE, c);
    c = circle_contact(&l_shape, vec(TUFF_RATIO(25, 2), W(13)), W(5));
    ASSERT_CONTACT(TUFF_RATIO(5, 2), ONE, 0, c);
}

static void test_in_a_notch_ties_go_to_the_lowest_part(void)
{
    tuff_contact c = circle_contact(&l_shape, whole(13, 13), W(5));
    ASSERT_CONTACT(W(2), 0, ONE, c);
}

/* All three parts are reached; the corner part by its vertex between two internal edges. */
static void test_an_internal_vertex_gives_no_contact_while_another_part_does(void)
{
    tuff_contact alone = marked_contact();
    TEST_ASSERT_TRUE(tuff_circle_polygon(whole(13, 14), W(6), &l_parts[0], &alone));
    ASSERT_CONTACT(W(1), TUFF_UNIT_RATIO(3, 5), TUFF_UNIT_RATIO(4, 5), alone);
    tuff_contact c = circle_contact(&l_shape, whole(13, 14), W(6));
    ASSERT_CONTACT(W(3), ONE, 0, c);
}

static void test_deep_in_the_corner_part_the_least_outline_axis_of_the_overlapped_parts_is_taken(void)
{
    tuff_contact c = circle_contact(&l_shape, whole(9, 8), W(1));
    ASSERT_CONTACT(W(9), 0, -ONE, c);
    c = circle_contact(&l_shape, whole(7, 9), W(1));
    ASSERT_CONTACT(W(8), -ONE, 0, c);
}

static void test_a_piece_of_internal_edges_only_is_left_by_the_least_that_leads_away_from_its_position(void)
{
    static const tuff_polygon part = { corner_box, normals, 15, 4 };
    static const tuff_terrain inner = { { 0, 0 }, W(10), W(20), &part, 1 };
    tuff_contact c = circle_contact(&inner, whole(3, 5), W(1));
    ASSERT_CONTACT(W(6), 0, ONE, c);
    c = hull_contact(&inner, whole(5, -2), &dart);
    ASSERT_CONTACT(W(2), 0, -ONE, c);
}

/* Two boxes side by side, in either order; the left one has these marks, the right one all but UP. A circle at the seam overlaps both by
   their internal edges only. */
static tuff_contact seam_contact(uint8_t left_marks, bool left_first, tuff_real y)
{
    static const tuff_vec2 right_box[4] = BOX_VERTICES(10, 0, 20, 10);
    tuff_polygon parts[2] = { { right_box, normals, DOWN | RIGHT | LEFT, 4 }, { right_box, normals, DOWN | RIGHT | LEFT, 4 } };
    tuff_terrain pair = { { 0, 0 }, W(10), W(30), NULL, 2 };
    tuff_polygon *left = &parts[left_first ? 0 : 1];
    left->vertices = corner_box;
    left->internal_edges = left_marks;
    pair.parts = parts;
    return circle_contact(&pair, vec(TUFF_RATIO(19, 2), y), W(1));
}

static void test_an_outline_axis_goes_before_any_internal_one(void)
{
    for (uint8_t order = 0; order < 2; order++) {
        tuff_contact c = seam_contact(DOWN | RIGHT | UP | LEFT, order != 0, W(4));
        ASSERT_CONTACT(W(7), 0, ONE, c);
    }
}

static void test_of_the_outline_axes_of_all_overlapped_parts_the_least_is_taken(void)
{
    for (uint8_t order = 0; order < 2; order++) {
        tuff_contact c = seam_contact(RIGHT | UP | LEFT, order != 0, W(4));
        ASSERT_CONTACT(W(5), 0, -ONE, c);
        c = seam_contact(RIGHT | UP | LEFT, order != 0, W(6));
        ASSERT_CONTACT(W(5), 0, ONE, c);
    }
}

/* Two boxes side by side, without any outline: as if others lay around them. */
static const tuff_vec2 inner_right_box[4] = BOX_VERTICES(10, 0, 20, 10);
static const tuff_polygon inner_parts[2] = { { corner_box, normals, 15, 4 }, { inner_right_box, normals, 15, 4 } };
static const tuff_terrain inner_pair = { { 0, 0 }, W(10), W(30), inner_parts, 2 };

static void test_without_outline_the_least_internal_axis_of_all_that_leads_away_is_taken(void)
{
    tuff_contact c = circle_contact(&inner_pair, vec(TUFF_RATIO(19, 2), W(4)), W(1));
    ASSERT_CONTACT(TUFF_RATIO(3, 2), ONE, 0, c);
    c = circle_contact(&inner_pair, vec(TUFF_RATIO(21, 2), W(4)), W(1));
    ASSERT_CONTACT(TUFF_RATIO(1, 2), ONE, 0, c);
    c = hull_contact(&inner_pair, whole(1, 4), &inner_parts[0]);
    ASSERT_CONTACT(W(6), 0, ONE, c);
}

/* The least axes of the two boxes lead from one into the other and back. */
static void test_a_body_between_inner_parts_is_not_pushed_to_and_fro(void)
{
    tuff_body body = { { TUFF_RATIO(19, 2), W(4) }, { 0, 0 }, NULL };
    TEST_ASSERT_EQUAL_UINT16(2, tuff_floater_collide_circle(&body, W(1), &inner_pair, 1));
    ASSERT_VEC(W(11), W(11), body.position);
}

/* The middle of a row of three: its outline edges are taken although the internal ones are nearer. */
static void test_a_part_between_two_others_goes_out_by_its_outline(void)
{
    static const tuff_vec2 a[4] = BOX_VERTICES(-12, -10, -2, 10);
    static const tuff_vec2 b[4] = BOX_VERTICES(-2, -10, 2, 10);
    static const tuff_vec2 d[4] = BOX_VERTICES(2, -10, 12, 10);
    static const tuff_polygon parts[3] = { { a, normals, RIGHT, 4 }, { b, normals, RIGHT | LEFT, 4 }, { d, normals, LEFT, 4 } };
    static const tuff_terrain row = { { 0, 0 }, W(10), W(20), parts, 3 };
    tuff_contact c = circle_contact(&row, whole(0, 3), W(1));
    ASSERT_CONTACT(W(8), 0, ONE, c);
    c = circle_contact(&row, whole(0, -3), W(3));
    ASSERT_CONTACT(W(10), 0, -ONE, c);
}

static void test_the_order_of_the_parts_does_not_matter_at_a_seam(void)
{
    tuff_polygon swapped[2];
    tuff_terrain other = flat_floor;
    swapped[0] = floor_parts[1];
    swapped[1] = floor_parts[0];
    other.parts = swapped;
    for (int8_t x = -6; x <= 6; x++) {
        tuff_contact c = circle_contact(&other, vec(tuff_from_int(x) / 4, W(1)), W(5));
        ASSERT_CONTACT(W(6), 0, -ONE, c);
    }
}

static void test_marks_in_one_part_do_not_hide_a_single_part_piece(void)
{
    static const tuff_polygon part = { corner_box, normals, UP, 4 };
    static const tuff_terrain piece = { { 0, 0 }, W(10), W(20), &part, 1 };
    tuff_contact c = circle_contact(&piece, whole(5, 12), W(3));   /* least axis internal; the least outline axis is 8 */
    ASSERT_CONTACT(W(8), ONE, 0, c);
}

/* ------------------------------------------------------------------------------------------------------- residues */

DEFINE_BOX(square, -4, -4, 4, 4);
static tuff_mover mover;

/* A square against two boxes: one of 10 by 10, its right side marked, and beside it one whose top is 1 above that one's bottom. An overlap
   of 1 / 2 counts as what an earlier push has left. */
static bool residue_contact(uint8_t part_count, tuff_vec2 offset, bool seams, tuff_contact *contact)
{
    static const tuff_vec2 low_box[4] = BOX_VERTICES(10, 9, 40, 30);
    static const tuff_polygon parts[2] = { { corner_box, normals, RIGHT, 4 }, { low_box, normals, 0, 4 } };
    tuff_terrain piece = { { 0, 0 }, W(10), W(60), parts, part_count };
    tuff_unit2 scratch[4];
    TEST_ASSERT_TRUE(tuff_hull_mover(&mover, W(6), &square, scratch));
    mover.shape.seams = seams;
    mover.shape.by_outline = true;
    mover.shape.piece = &piece;
    mover.shape.offset = offset;
    return tuff_parts_contact(&mover.shape, TUFF_RATIO(1, 2), contact);
}

static void test_beside_an_outline_contact_of_a_residue_a_part_overlapped_by_clearly_more_is_left_by_its_outline(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(residue_contact(2, vec(W(11), TUFF_RATIO(11, 2)), false, &c));   /* 3 deep by the marked side */
    ASSERT_CONTACT(TUFF_RATIO(17, 2), 0, ONE, c);
    TEST_ASSERT_TRUE(residue_contact(2, vec(W(13), TUFF_RATIO(11, 2)), false, &c));   /* 1 deep: no more than 4 residues */
    ASSERT_CONTACT(TUFF_RATIO(1, 2), 0, -ONE, c);
    TEST_ASSERT_FALSE(mover.shape.by_outline);
    TEST_ASSERT_TRUE(residue_contact(2, vec(W(13), W(6)), false, &c));                /* the outline contact is more than a residue */
    ASSERT_CONTACT(W(1), 0, -ONE, c);
    TEST_ASSERT_TRUE(mover.shape.by_outline);
}

static void test_a_residue_by_an_internal_edge_is_left_by_an_outline_axis_that_is_hardly_farther(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(residue_contact(1, vec(TUFF_RATIO(27, 2), W(-3)), false, &c));
    ASSERT_CONTACT(W(1), 0, -ONE, c);
    TEST_ASSERT_TRUE(residue_contact(1, vec(TUFF_RATIO(27, 2), W(-3)), true, &c));
    ASSERT_CONTACT(W(1), 0, -ONE, c);
}

static void test_a_residue_by_an_internal_edge_far_from_any_outline_is_left_by_that_edge_and_waits_where_seams_matter(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_TRUE(residue_contact(1, vec(TUFF_RATIO(27, 2), W(4)), false, &c));
    ASSERT_CONTACT(TUFF_RATIO(1, 2), ONE, 0, c);
    TEST_ASSERT_FALSE(residue_contact(1, vec(TUFF_RATIO(27, 2), W(4)), true, &c));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_flat_floor_of_two_parts_pushes_straight_up_at_its_seam);
    RUN_TEST(test_a_deep_circle_at_the_seam_is_not_pushed_sideways);
    RUN_TEST(test_a_sharp_hull_at_the_seam_is_not_pushed_sideways);
    RUN_TEST(test_an_outline_vertex_still_pushes_away_from_itself);
    RUN_TEST(test_the_ends_of_the_floor_are_outline);
    RUN_TEST(test_in_a_notch_the_deepest_part_goes_first);
    RUN_TEST(test_in_a_notch_ties_go_to_the_lowest_part);
    RUN_TEST(test_an_internal_vertex_gives_no_contact_while_another_part_does);
    RUN_TEST(test_deep_in_the_corner_part_the_least_outline_axis_of_the_overlapped_parts_is_taken);
    RUN_TEST(test_a_piece_of_internal_edges_only_is_left_by_the_least_that_leads_away_from_its_position);
    RUN_TEST(test_an_outline_axis_goes_before_any_internal_one);
    RUN_TEST(test_of_the_outline_axes_of_all_overlapped_parts_the_least_is_taken);
    RUN_TEST(test_without_outline_the_least_internal_axis_of_all_that_leads_away_is_taken);
    RUN_TEST(test_a_body_between_inner_parts_is_not_pushed_to_and_fro);
    RUN_TEST(test_a_part_between_two_others_goes_out_by_its_outline);
    RUN_TEST(test_the_order_of_the_parts_does_not_matter_at_a_seam);
    RUN_TEST(test_marks_in_one_part_do_not_hide_a_single_part_piece);
    RUN_TEST(test_beside_an_outline_contact_of_a_residue_a_part_overlapped_by_clearly_more_is_left_by_its_outline);
    RUN_TEST(test_a_residue_by_an_internal_edge_is_left_by_an_outline_axis_that_is_hardly_farther);
    RUN_TEST(test_a_residue_by_an_internal_edge_far_from_any_outline_is_left_by_that_edge_and_waits_where_seams_matter);
    return UNITY_END();
}
