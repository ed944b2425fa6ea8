/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A piece of several parts among others: where it lies, and whether it is reached at all. Of one part or none: test_overlap_circle.c,
   test_overlap_hull.c. */
#include "shapes.h"

/* An L: 10 thick, its notch at (10, 10) open to +x and +y. */
static const tuff_vec2 foot[4] = BOX_VERTICES(0, 0, 40, 10);
static const tuff_vec2 leg[4] = BOX_VERTICES(0, 10, 10, 40);
static const tuff_unit2 normals[4] = BOX_NORMALS;
static const tuff_polygon parts[2] = { { foot, normals, 0, 4 }, { leg, normals, 1, 4 } };
static const tuff_terrain l_shape = { { 0, 0 }, W(20), W(60), parts, 2 };

DEFINE_BOX(hull, -4, -4, 4, 4);

void setUp(void) {}
void tearDown(void) {}

static void test_parts_that_are_not_touched_say_nothing(void)
{
    tuff_contact c = marked_contact();
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&l_shape, whole(20, 20), W(9), &c));
    TEST_ASSERT_FALSE(tuff_terrain_overlap_circle(&l_shape, whole(15, 15), W(5), &c));
    TEST_ASSERT_FALSE(tuff_terrain_overlap_hull(&l_shape, whole(20, 20), W(6), &hull, &c));
    ASSERT_UNTOUCHED(c);
}

static void test_parts_are_offsets_from_the_position_of_their_piece(void)
{
    for (uint8_t i = 0; i < FAR_PLACES; i++) {
        tuff_terrain far = moved_far(&l_shape, i);
        tuff_contact c = marked_contact();
        TEST_ASSERT_TRUE(tuff_terrain_overlap_circle(&far, vec(far.position.x + W(13), far.position.y + W(12)), W(5), &c));
        ASSERT_CONTACT(W(3), 0, ONE, c);
        TEST_ASSERT_TRUE(tuff_terrain_overlap_hull(&far, vec(far.position.x + W(12), far.position.y + W(13)), W(6), &hull, &c));
        ASSERT_CONTACT(W(2), ONE, 0, c);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_parts_that_are_not_touched_say_nothing);
    RUN_TEST(test_parts_are_offsets_from_the_position_of_their_piece);
    return UNITY_END();
}
