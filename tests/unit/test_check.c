/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What the checks call well and what they name. DESIGN 2 ("Checks for shapes and worlds"), DESIGN 4 (ranges, either winding). */
#include "shapes.h"

#define PIECES 4

DEFINE_BOX(box, -10, -10, 10, 10);

static tuff_polygon polygon;       /* a box whose vertices and normals a test may spoil */
static tuff_vec2 vertices[4];
static tuff_unit2 normals[4];
static tuff_terrain piece;
static tuff_body body;
static tuff_material material;

DEFINE_TERRAIN(PIECES, 4, 6);
static tuff_world world;

void setUp(void)
{
    for (uint8_t i = 0; i < 4; i++) {
        vertices[i] = box_vertices[i];
        normals[i] = box_normals[i];
    }
    polygon = box;
    polygon.vertices = vertices;
    polygon.normals = normals;
    piece = piece_of(whole(100, -50), W(10), &polygon, 1);
    material.restitution = TUFF_RATIO(1, 2);
    material.friction = TUFF_RATIO(1, 10);
    body = body_of(whole(3, 4), whole(-5, 6), &material);
    for (uint8_t i = 0; i < PIECES; i++) {
        terrain[i] = piece;
        terrain[i].parts = &box;
        terrain[i].position = whole((int16_t)(200 * i), 0);
    }
    world.terrain = terrain;
    world.terrain_count = PIECES;
    world.chunks = &chunks;
    world.nearby = NULL;
    world.nearby_capacity = 0;
    world.order = TUFF_ORDER_ITERATION;
    chunks.bucket_count = 4;
    chunks.capacity = PIECES;
    chunks.pitch_log2 = 6;
    TEST_ASSERT_EQUAL_INT(0, tuff_world_index(&world));
}

void tearDown(void) {}

#define ASSERT_POLYGON(fault) TEST_ASSERT_EQUAL_INT((fault), tuff_check_polygon(&polygon))
#define ASSERT_HULL(fault)    TEST_ASSERT_EQUAL_INT((fault), tuff_check_hull(&polygon))
#define ASSERT_PIECE(fault)   TEST_ASSERT_EQUAL_INT((fault), tuff_check_terrain(&piece))
#define ASSERT_BODY(fault)    TEST_ASSERT_EQUAL_INT((fault), tuff_check_body(&body, W(15), &polygon))

/* ---------------------------------------------------------------------------------------------------------- shapes */

static void test_good_polygons_are_well_in_either_winding(void)
{
    static const tuff_vec2 reversed[4] = BOX_VERTICES_REVERSED(-1024, -1024, 1024, 1024);
    static const tuff_unit2 reversed_normals[4] = BOX_NORMALS_REVERSED;
    ASSERT_POLYGON(TUFF_OK);
    polygon.vertices = reversed;
    polygon.normals = reversed_normals;
    ASSERT_POLYGON(TUFF_OK);
    ASSERT_HULL(TUFF_OK);
}

static void test_the_largest_polygon_with_made_normals_is_well(void)
{
    tuff_vec2 many[32];
    tuff_unit2 made[32];
    tuff_polygon large = baked_largest_polygon(many, made);
    large.internal_edges = UINT32_C(0xFFFFFFFF);
    TEST_ASSERT_EQUAL_INT(TUFF_OK, tuff_check_polygon(&large));
}

static void test_collinear_vertices_are_well(void)
{
    static const tuff_vec2 five[5] = { { W(-10), W(-10) }, { 0, W(-10) }, { W(10), W(-10) }, { W(10), W(10) }, { W(-10), W(10) } };
    tuff_unit2 made[5];
    tuff_polygon straight = baked(five, 5, made);
    TEST_ASSERT_EQUAL_INT(TUFF_OK, tuff_check_polygon(&straight));
}

static void test_missing_pointers_are_named(void)
{
    TEST_ASSERT_EQUAL_INT(TUFF_FAULT_NULL, tuff_check_polygon(NULL));
    TEST_ASSERT_EQUAL_INT(TUFF_FAULT_NULL, tuff_check_hull(NULL));
    polygon.vertices = NULL;
    ASSERT_POLYGON(TUFF_FAULT_NULL);
    ASSERT_HULL(TUFF_FAULT_NULL);
}

static void test_normals_may_be_missing_from_a_hull_only(void)
{
    polygon.normals = NULL;
    ASSERT_POLYGON(TUFF_FAULT_NO_NORMALS);
    ASSERT_HULL(TUFF_OK);
}

static void test_too_few_and_too_many_vertices_are_named(void)
{
    polygon.count = 2;
    ASSERT_POLYGON(TUFF_FAULT_TOO_FEW_VERTICES);
    polygon.count = 0;
    ASSERT_POLYGON(TUFF_FAULT_TOO_FEW_VERTICES);
    polygon.count = 33;
    ASSERT_POLYGON(TUFF_FAULT_TOO_MANY_VERTICES);
    ASSERT_HULL(TUFF_FAULT_TOO_MANY_VERTICES);
}

static void test_vertices_out_of_range_are_named(void)
{
    vertices[2].x = W(1024) + LSB * 64;
    ASSERT_POLYGON(TUFF_FAULT_VERTEX_RANGE);
    vertices[2].x = W(10);
    vertices[0].y = W(-1025);
    ASSERT_POLYGON(TUFF_FAULT_VERTEX_RANGE);
    vertices[0].y = LOWEST;
    ASSERT_POLYGON(TUFF_FAULT_VERTEX_RANGE);
}

static void test_duplicate_vertices_are_named(void)
{
    vertices[3] = vertices[0];
    ASSERT_POLYGON(TUFF_FAULT_DUPLICATE_VERTEX);
    vertices[3] = vertices[2];
    ASSERT_POLYGON(TUFF_FAULT_DUPLICATE_VERTEX);
}

static void test_polygons_without_area_are_named(void)
{
    for (uint8_t i = 0; i < 4; i++) vertices[i] = whole((int16_t)(5 * i), (int16_t)(3 * i));
    ASSERT_POLYGON(TUFF_FAULT_NO_AREA);
    polygon.count = 3;
    ASSERT_POLYGON(TUFF_FAULT_NO_AREA);
}

static void test_concave_polygons_are_named(void)
{
    vertices[2] = whole(-5, -5);
    ASSERT_POLYGON(TUFF_FAULT_CONCAVE);
    vertices[2] = box_vertices[3];
    vertices[3] = box_vertices[2];   /* crosses itself */
    ASSERT_POLYGON(TUFF_FAULT_CONCAVE);
}

static void test_going_round_twice_is_named(void)
{
    static const tuff_vec2 star[5] = { { 0, W(10) }, { W(-6), W(-8) }, { W(10), W(3) }, { W(-10), W(3) }, { W(6), W(-8) } };
    static const tuff_polygon pentagram = { star, NULL, 0, 5 };
    tuff_polygon twice = { NULL, NULL, 0, 8 };
    tuff_vec2 around[8];
    for (uint8_t i = 0; i < 8; i++) around[i] = box_vertices[i % 4];
    twice.vertices = around;
    TEST_ASSERT_EQUAL_INT(TUFF_FAULT_CONCAVE, tuff_check_hull(&pentagram));
    TEST_ASSERT_EQUAL_INT(TUFF_FAULT_CONCAVE, tuff_check_hull(&twice));
}

static void test_an_edge_that_goes_straight_back_is_named(void)
{
    static const tuff_vec2 spike[5] = { { W(-10), W(-10) }, { W(20), W(-10) }, { W(10), W(-10) }, { W(10), W(10) }, { W(-10), W(10) } };
    static const tuff_polygon polygon_with_spike = { spike, NULL, 0, 5 };
    TEST_ASSERT_EQUAL_INT(TUFF_FAULT_CONCAVE, tuff_check_hull(&polygon_with_spike));
}

static void test_normals_of_wrong_length_are_named(void)
{
    normals[1].x = TUFF_UNIT_RATIO(99, 100);
    ASSERT_POLYGON(TUFF_FAULT_NORMAL_LENGTH);
    ASSERT_HULL(TUFF_FAULT_NORMAL_LENGTH);
    normals[1].x = 0;
    ASSERT_POLYGON(TUFF_FAULT_NORMAL_LENGTH);
    normals[1].x = TUFF_UNIT_RATIO(19, 10);
    normals[1].y = TUFF_UNIT_RATIO(19, 10);
    ASSERT_POLYGON(TUFF_FAULT_NORMAL_LENGTH);
}

static void test_inward_normals_are_named(void)
{
    normals[1].x = -ONE;
    ASSERT_POLYGON(TUFF_FAULT_NORMAL_INWARD);
}

static void test_oblique_normals_are_named(void)
{
    normals[1].x = TUFF_UNIT_RATIO(4, 5);
    normals[1].y = TUFF_UNIT_RATIO(3, 5);
    ASSERT_POLYGON(TUFF_FAULT_NORMAL_DIRECTION);
    normals[1].x = ONE;
    normals[1].y = TUFF_UNIT_RATIO(1, 10000);
    ASSERT_POLYGON(TUFF_FAULT_NORMAL_DIRECTION);
}

static void test_marks_beyond_the_last_edge_are_named(void)
{
    polygon.internal_edges = 16;
    ASSERT_POLYGON(TUFF_FAULT_INTERNAL_BITS);
    polygon.internal_edges = UINT32_C(0x80000000);
    ASSERT_POLYGON(TUFF_FAULT_INTERNAL_BITS);
    polygon.internal_edges = 15;
    ASSERT_POLYGON(TUFF_OK);
}

/* ---------------------------------------------------------------------------------------------------------- pieces */

static void test_good_pieces_empty_slots_and_unbaked_pieces_are_well(void)
{
    static const tuff_terrain zero;
    ASSERT_PIECE(TUFF_OK);
    TEST_ASSERT_EQUAL_INT(TUFF_OK, tuff_check_terrain(&zero));
    piece.parts = NULL;
    piece.part_count = 0;
    ASSERT_PIECE(TUFF_OK);
    TEST_ASSERT_EQUAL_INT(TUFF_FAULT_NULL, tuff_check_terrain(NULL));
}

static void test_radii_out_of_range_are_named(void)
{
    piece.radius = W(-1);
    ASSERT_PIECE(TUFF_FAULT_RADIUS_RANGE);
    piece.radius = W(1025);
    piece.bounding_radius = W(1026);
    ASSERT_PIECE(TUFF_FAULT_RADIUS_RANGE);
    piece.radius = W(10);
    piece.bounding_radius = W(1450);
    ASSERT_PIECE(TUFF_FAULT_BOUNDING_RANGE);
    piece.bounding_radius = 0;
    ASSERT_PIECE(TUFF_FAULT_BOUNDING_RANGE);
    piece.bounding_radius = W(-15);
    ASSERT_PIECE(TUFF_FAULT_BOUNDING_RANGE);
}

static void test_a_bounding_radius_that_covers_too_little_is_named(void)
{
    piece.bounding_radius = W(14);   /* the corners are 14.14 away */
    ASSERT_PIECE(TUFF_FAULT_BOUNDING_TOO_SMALL);
    piece.parts = NULL;
    piece.part_count = 0;
    ASSERT_PIECE(TUFF_OK);
    piece.bounding_radius = W(9);
    ASSERT_PIECE(TUFF_FAULT_BOUNDING_TOO_SMALL);
}

static void test_the_largest_piece_is_well(void)
{
    static const tuff_vec2 corners[4] = BOX_VERTICES(-1024, -1024, 1024, 1024);
    polygon.vertices = corners;
    piece.radius = W(TUFF_MAX_RADIUS);
    piece.bounding_radius = W(TUFF_MAX_BOUNDING_RADIUS);
    ASSERT_PIECE(TUFF_OK);
}

static void test_the_faults_of_every_part_are_named(void)
{
    tuff_polygon parts[2];
    parts[0] = box;
    parts[1] = polygon;
    normals[3].x = ONE;
    piece.parts = parts;
    piece.part_count = 2;
    ASSERT_PIECE(TUFF_FAULT_NORMAL_INWARD);
    parts[1].count = 2;
    ASSERT_PIECE(TUFF_FAULT_TOO_FEW_VERTICES);
}

static void test_internal_edges_must_be_shared(void)
{
    static const tuff_vec2 left[4] = BOX_VERTICES(-10, -10, 0, 10);
    static const tuff_vec2 right[4] = BOX_VERTICES(0, -10, 10, 10);
    static const tuff_vec2 longer[4] = BOX_VERTICES(0, -10, 10, 11);
    tuff_polygon parts[2] = { { left, box_normals, 2, 4 }, { right, box_normals, 8, 4 } };
    piece.parts = parts;
    piece.part_count = 2;
    ASSERT_PIECE(TUFF_OK);
    parts[1].vertices = longer;
    ASSERT_PIECE(TUFF_FAULT_INTERNAL_UNMATCHED);
    parts[1].vertices = right;
    parts[1].internal_edges = 2;
    ASSERT_PIECE(TUFF_FAULT_INTERNAL_UNMATCHED);
    polygon.internal_edges = 1;
    piece.parts = &polygon;
    piece.part_count = 1;
    ASSERT_PIECE(TUFF_FAULT_INTERNAL_UNMATCHED);
}

/* ---------------------------------------------------------------------------------------------------------- bodies */

static void test_good_bodies_are_well(void)
{
    ASSERT_BODY(TUFF_OK);
    TEST_ASSERT_EQUAL_INT(TUFF_OK, tuff_check_body(&body, W(5), NULL));
    body.material = NULL;
    polygon.normals = NULL;
    ASSERT_BODY(TUFF_OK);
    body.position = vec(LOWEST, HIGHEST);
    body.velocity = whole(-1024, 1024);
    ASSERT_BODY(TUFF_OK);
    TEST_ASSERT_EQUAL_INT(TUFF_FAULT_NULL, tuff_check_body(NULL, W(15), &polygon));
}

static void test_velocities_out_of_range_are_named(void)
{
    body.velocity.x = W(1024) + 64 * LSB;
    ASSERT_BODY(TUFF_FAULT_VELOCITY_RANGE);
    body.velocity = whole(0, -1025);
    ASSERT_BODY(TUFF_FAULT_VELOCITY_RANGE);
    body.velocity = vec(0, LOWEST);
    ASSERT_BODY(TUFF_FAULT_VELOCITY_RANGE);
}

static void test_materials_out_of_range_are_named(void)
{
    material.restitution = W(4) + LSB;
    ASSERT_BODY(TUFF_FAULT_RESTITUTION_RANGE);
    material.restitution = -LSB;
    ASSERT_BODY(TUFF_FAULT_RESTITUTION_RANGE);
    material.restitution = W(4);
    material.friction = W(1) + LSB;
    ASSERT_BODY(TUFF_FAULT_FRICTION_RANGE);
    material.friction = -LSB;
    ASSERT_BODY(TUFF_FAULT_FRICTION_RANGE);
    material.friction = W(1);
    ASSERT_BODY(TUFF_OK);
}

static void test_a_radius_that_does_not_cover_the_hull_is_named(void)
{
    TEST_ASSERT_EQUAL_INT(TUFF_FAULT_HULL_RADIUS, tuff_check_body(&body, W(14), &polygon));
    TEST_ASSERT_EQUAL_INT(TUFF_FAULT_RADIUS_RANGE, tuff_check_body(&body, W(-1), NULL));
    TEST_ASSERT_EQUAL_INT(TUFF_FAULT_RADIUS_RANGE, tuff_check_body(&body, W(1450), &polygon));
}

static void test_the_faults_of_the_hull_are_named(void)
{
    vertices[2] = whole(-5, -5);
    ASSERT_BODY(TUFF_FAULT_CONCAVE);
    polygon.count = 33;
    ASSERT_BODY(TUFF_FAULT_TOO_MANY_VERTICES);
}

/* ---------------------------------------------------------------------------------------------------------- worlds */

static void expect_world(tuff_fault fault, uint16_t at, UNITY_LINE_TYPE line)
{
    uint16_t number = 999;
    UNITY_TEST_ASSERT_EQUAL_INT(fault, tuff_check_world(&world, &number), line, NULL);
    UNITY_TEST_ASSERT_EQUAL_INT(at, number, line, "the piece at fault");
    UNITY_TEST_ASSERT_EQUAL_INT(fault, tuff_check_world(&world, NULL), line, NULL);
}

#define ASSERT_WORLD(fault, at) expect_world((fault), (at), __LINE__)

static void test_good_worlds_are_well(void)
{
    static const tuff_world zero;
    ASSERT_WORLD(TUFF_OK, 0);
    TEST_ASSERT_EQUAL_INT(TUFF_OK, tuff_check_world(&zero, NULL));
    world.chunks = NULL;
    ASSERT_WORLD(TUFF_OK, 0);
    world.chunks = &chunks;
    tuff_chunks_clear(&chunks);
    ASSERT_WORLD(TUFF_OK, 0);
}

static void test_worlds_without_what_they_need_are_named(void)
{
    TEST_ASSERT_EQUAL_INT(TUFF_FAULT_NULL, tuff_check_world(NULL, NULL));
    world.nearby_capacity = 4;
    ASSERT_WORLD(TUFF_FAULT_NULL, 0);
    world.nearby_capacity = 0;
    world.terrain = NULL;
    ASSERT_WORLD(TUFF_FAULT_NULL, 0);
    world.terrain = terrain;
    world.order = 2;
    ASSERT_WORLD(TUFF_FAULT_ORDER, 0);
    world.order = TUFF_ORDER_DEEPEST;
    world.terrain_count = 65535;
    ASSERT_WORLD(TUFF_FAULT_TERRAIN_COUNT, 0);
}

static void test_the_piece_at_fault_is_told(void)
{
    terrain[2].radius = W(-1);
    ASSERT_WORLD(TUFF_FAULT_RADIUS_RANGE, 2);
    terrain[2].radius = W(10);
    terrain[3].bounding_radius = W(12);
    ASSERT_WORLD(TUFF_FAULT_BOUNDING_TOO_SMALL, 3);
}

static void test_bad_index_storage_is_named(void)
{
    chunks.bucket_count = 3;
    ASSERT_WORLD(TUFF_FAULT_BUCKET_COUNT, 0);
    chunks.bucket_count = 0;
    ASSERT_WORLD(TUFF_FAULT_BUCKET_COUNT, 0);
    chunks.bucket_count = 4;
    chunks.pitch_log2 = 15;
    ASSERT_WORLD(TUFF_FAULT_PITCH, 0);
    chunks.pitch_log2 = 6;
    chunks.buckets = NULL;
    ASSERT_WORLD(TUFF_FAULT_NULL, 0);
    chunks.buckets = buckets;
}

static void test_stale_entries_are_named(void)
{
    world.terrain_count = 2;
    ASSERT_WORLD(TUFF_FAULT_INDEX_STALE, 2);
    world.terrain_count = PIECES;
    terrain[1].bounding_radius = 0;
    terrain[1].radius = 0;
    terrain[1].parts = NULL;
    terrain[1].part_count = 0;
    ASSERT_WORLD(TUFF_FAULT_INDEX_STALE, 1);
}

static void test_missing_pieces_are_named(void)
{
    TEST_ASSERT_TRUE(tuff_chunks_remove(&chunks, 3));
    ASSERT_WORLD(TUFF_FAULT_INDEX_MISSING, 3);
    chunks.capacity = 2;
    TEST_ASSERT_EQUAL_INT(2, tuff_world_index(&world));
    ASSERT_WORLD(TUFF_FAULT_INDEX_MISSING, 2);
}

static void test_moved_and_grown_pieces_are_named(void)
{
    terrain[2].position = whole(-400, 0);
    ASSERT_WORLD(TUFF_FAULT_INDEX_MOVED, 2);
    terrain[2].position = whole(401, 1);   /* the same chunk */
    ASSERT_WORLD(TUFF_OK, 0);
    terrain[2].bounding_radius = W(40);
    ASSERT_WORLD(TUFF_FAULT_INDEX_MOVED, 2);
    TEST_ASSERT_TRUE(tuff_chunks_move(&chunks, 2, terrain[2].position, terrain[2].bounding_radius));
    ASSERT_WORLD(TUFF_OK, 0);
}

static void test_broken_lists_are_named(void)
{
    entries[1].next = 2;
    ASSERT_WORLD(TUFF_FAULT_INDEX_BROKEN, 0);
    entries[1].next = 4000;
    ASSERT_WORLD(TUFF_FAULT_INDEX_BROKEN, 0);
    tuff_world_index(&world);
    buckets[0] = 60000;
    ASSERT_WORLD(TUFF_FAULT_INDEX_BROKEN, 0);
    tuff_world_index(&world);
    chunks.large = 60000;
    ASSERT_WORLD(TUFF_FAULT_INDEX_BROKEN, 0);
}

/* ------------------------------------------------------------------------------------------- what only float can have */

static void test_positions_out_of_range_are_named(void)
{
    piece.position.x = tuff_from_int(INT32_C(32769));
    ASSERT_PIECE(TUFF_FAULT_POSITION_RANGE);
    body.position.y = tuff_from_int(INT32_C(-32769));
    ASSERT_BODY(TUFF_FAULT_POSITION_RANGE);
}

#define ASSERT_NOT_FINITE(number, bad, check) \
    do { setUp(); (number) = (bad); check(TUFF_FAULT_NOT_FINITE); } while (0)

static void test_numbers_that_are_not_finite_are_named(void)
{
    for (uint8_t i = 0; i < 2; i++) {
        tuff_real bad = i ? NOT_A_NUMBER : INFINITE;
        ASSERT_NOT_FINITE(piece.position.y, bad, ASSERT_PIECE);
        ASSERT_NOT_FINITE(piece.radius, bad, ASSERT_PIECE);
        ASSERT_NOT_FINITE(piece.bounding_radius, bad, ASSERT_PIECE);
        ASSERT_NOT_FINITE(body.velocity.x, bad, ASSERT_BODY);
        ASSERT_NOT_FINITE(material.friction, bad, ASSERT_BODY);
        ASSERT_NOT_FINITE(vertices[3].y, bad, ASSERT_POLYGON);
        setUp();
        normals[2].y = bad;
        TEST_ASSERT_TRUE(tuff_check_polygon(&polygon) != TUFF_OK);
        TEST_ASSERT_EQUAL_INT(TUFF_FAULT_NOT_FINITE, tuff_check_body(&body, bad, NULL));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_good_polygons_are_well_in_either_winding);
    RUN_TEST(test_the_largest_polygon_with_made_normals_is_well);
    RUN_TEST(test_collinear_vertices_are_well);
    RUN_TEST(test_missing_pointers_are_named);
    RUN_TEST(test_normals_may_be_missing_from_a_hull_only);
    RUN_TEST(test_too_few_and_too_many_vertices_are_named);
    RUN_TEST(test_vertices_out_of_range_are_named);
    RUN_TEST(test_duplicate_vertices_are_named);
    RUN_TEST(test_polygons_without_area_are_named);
    RUN_TEST(test_concave_polygons_are_named);
    RUN_TEST(test_going_round_twice_is_named);
    RUN_TEST(test_an_edge_that_goes_straight_back_is_named);
    RUN_TEST(test_normals_of_wrong_length_are_named);
    RUN_TEST(test_inward_normals_are_named);
    RUN_TEST(test_oblique_normals_are_named);
    RUN_TEST(test_marks_beyond_the_last_edge_are_named);
    RUN_TEST(test_good_pieces_empty_slots_and_unbaked_pieces_are_well);
    RUN_TEST(test_radii_out_of_range_are_named);
    RUN_TEST(test_a_bounding_radius_that_covers_too_little_is_named);
    RUN_TEST(test_the_largest_piece_is_well);
    RUN_TEST(test_the_faults_of_every_part_are_named);
    RUN_TEST(test_internal_edges_must_be_shared);
    RUN_TEST(test_good_bodies_are_well);
    RUN_TEST(test_velocities_out_of_range_are_named);
    RUN_TEST(test_materials_out_of_range_are_named);
    RUN_TEST(test_a_radius_that_does_not_cover_the_hull_is_named);
    RUN_TEST(test_the_faults_of_the_hull_are_named);
    RUN_TEST(test_good_worlds_are_well);
    RUN_TEST(test_worlds_without_what_they_need_are_named);
    RUN_TEST(test_the_piece_at_fault_is_told);
    RUN_TEST(test_bad_index_storage_is_named);
    RUN_TEST(test_stale_entries_are_named);
    RUN_TEST(test_missing_pieces_are_named);
    RUN_TEST(test_moved_and_grown_pieces_are_named);
    RUN_TEST(test_broken_lists_are_named);
    if (!IS_FIXED) RUN_TEST(test_positions_out_of_range_are_named);
    if (!IS_FIXED) RUN_TEST(test_numbers_that_are_not_finite_are_named);
    return UNITY_END();
}
