/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The shapes of rocks and floor, drawn by hand on whole units. Parts of one outline name the same corners, so that their
   common edges are the same to the last bit. */
#include "inner.h"

/* Coordinates of the drawings are stored in steps of 1/16 unit; both builds hold them exactly. */
typedef struct corner { int16_t x, y; } corner;

/* Five convex rocks of about 16 units. */
static const int8_t rock_octagon[8][2] = {{16, 2}, {11, 11}, {2, 15}, {-9, 13}, {-15, 4}, {-14, -7}, {-5, -15}, {8, -13}};
static const int8_t rock_chunk[6][2]   = {{15, -6}, {13, 8}, {-3, 14}, {-15, 5}, {-12, -9}, {3, -14}};
static const int8_t rock_round[9][2]   = {{16, 0}, {13, 9}, {5, 15}, {-5, 15}, {-13, 9}, {-16, -1}, {-11, -11}, {0, -16}, {11, -11}};
static const int8_t rock_wedge[5][2]   = {{15, 4}, {-2, 13}, {-15, 7}, {-10, -11}, {9, -12}};
static const int8_t rock_slab[7][2]    = {{16, -2}, {14, 7}, {3, 11}, {-13, 9}, {-16, 0}, {-9, -10}, {10, -10}};

typedef struct drawing {
    const int8_t (*corners)[2];
    uint8_t count;
} drawing;

static const drawing convex_drawings[5] = {
    {rock_octagon, 8}, {rock_chunk, 6}, {rock_round, 9}, {rock_wedge, 5}, {rock_slab, 7}
};

/* Three concave rocks: corners, then parts as lists of corner numbers with the internal edges' bits. */
typedef struct part_drawing {
    uint8_t  count;
    uint8_t  corners[6];
    uint32_t internal_edges;
} part_drawing;

static const int8_t ell_corners[8][2] = {
    {-22, -30}, {-8, -28}, {-4, 6}, {-26, 8}, {24, 7}, {28, 16}, {18, 29}, {-20, 30}
};
static const part_drawing ell_parts[2] = {
    {4, {0, 1, 2, 3}, 1u << 2},
    {6, {3, 2, 4, 5, 6, 7}, 1u << 0}
};

static const int8_t star_corners[10][2] = {
    {11, -15}, {17, 6}, {0, 18}, {-17, 6}, {-11, -15},
    {40, -10}, {22, 31}, {-26, 34}, {-36, -12}, {2, -39}
};
static const part_drawing star_parts[6] = {
    {5, {0, 1, 2, 3, 4}, 0x1f},
    {3, {0, 5, 1}, 1u << 2},
    {3, {1, 6, 2}, 1u << 2},
    {3, {2, 7, 3}, 1u << 2},
    {3, {3, 8, 4}, 1u << 2},
    {3, {4, 9, 0}, 1u << 2}
};

static const int8_t crescent_corners[12][2] = {
    {32, 35}, {5, 39}, {-19, 26}, {-28, 0}, {-19, -26}, {5, -39}, {32, -35},
    {10, 24}, {-3, 16}, {-8, 0}, {-3, -16}, {10, -24}
};
static const part_drawing crescent_parts[6] = {
    {3, {0, 1, 7}, 1u << 1},
    {4, {7, 1, 2, 8}, (1u << 0) | (1u << 2)},
    {4, {8, 2, 3, 9}, (1u << 0) | (1u << 2)},
    {4, {9, 3, 4, 10}, (1u << 0) | (1u << 2)},
    {4, {10, 4, 5, 11}, (1u << 0) | (1u << 2)},
    {3, {11, 5, 6}, 1u << 0}
};

typedef struct concave_drawing {
    const int8_t (*corners)[2];
    const part_drawing *parts;
    uint8_t part_count;
} concave_drawing;

static const concave_drawing concave_drawings[SCENE_CONCAVE_SHAPES] = {
    {ell_corners, ell_parts, 2}, {star_corners, star_parts, 6}, {crescent_corners, crescent_parts, 6}
};

static void add_part(scene *s, const corner *corners, uint8_t count, uint32_t internal_edges)
{
    tuff_vec2 *vertices = &s->vertices[s->vertex_count];
    tuff_unit2 *normals = &s->normals[s->vertex_count];
    tuff_polygon *part = &s->parts[s->part_count];
    for (uint8_t i = 0; i < count; i++) vertices[i] = scene_vec2((int32_t)corners[i].x * 4096, (int32_t)corners[i].y * 4096);
    tuff_edge_normals(vertices, count, normals);
    part->vertices = vertices;
    part->normals = normals;
    part->internal_edges = internal_edges;
    part->count = count;
    s->vertex_count = (uint16_t)(s->vertex_count + count);
    s->part_count++;
}

/* In sixteenths: the square of 1449 units would not fit. */
static tuff_real cover(const corner *corners, uint8_t count, tuff_real so_far)
{
    for (uint8_t i = 0; i < count; i++) {
        int32_t reach = scene_distance(corners[i].x, corners[i].y) + 1;
        tuff_real radius = tuff_from_q16_16(reach * 4096);
        if (radius > so_far) so_far = radius;
    }
    return so_far;
}

/* Sizes 4, 6 and 8 quarters, each a quarter turn on from the one before. */
static void add_convex(scene *s, scene_shape *shape, const drawing *rock, uint8_t size)
{
    corner corners[9];
    for (uint8_t i = 0; i < rock->count; i++) {
        int16_t x = (int16_t)(rock->corners[i][0] * (4 + 2 * size) * 4);
        int16_t y = (int16_t)(rock->corners[i][1] * (4 + 2 * size) * 4);
        corners[i].x = size == 0 ? x : size == 1 ? (int16_t)-y : (int16_t)-x;
        corners[i].y = size == 0 ? y : size == 1 ? x : (int16_t)-y;
    }
    shape->first_part = (uint8_t)s->part_count;
    shape->part_count = 1;
    shape->bounding_radius = cover(corners, rock->count, 0);
    add_part(s, corners, rock->count, 0);
}

static void add_concave(scene *s, scene_shape *shape, const concave_drawing *rock)
{
    corner corners[6];
    shape->first_part = (uint8_t)s->part_count;
    shape->part_count = rock->part_count;
    for (uint8_t p = 0; p < rock->part_count; p++) {
        const part_drawing *part = &rock->parts[p];
        for (uint8_t i = 0; i < part->count; i++) {
            corners[i].x = (int16_t)(rock->corners[part->corners[i]][0] * 16);
            corners[i].y = (int16_t)(rock->corners[part->corners[i]][1] * 16);
        }
        shape->bounding_radius = cover(corners, part->count, shape->bounding_radius);
        add_part(s, corners, part->count, part->internal_edges);
    }
}

void scene_build_shapes(scene *s)
{
    for (uint8_t i = 0; i < SCENE_CONVEX_SHAPES; i++) add_convex(s, &s->shapes[i], &convex_drawings[i / 3], (uint8_t)(i % 3));
    for (uint8_t i = 0; i < SCENE_CONCAVE_SHAPES; i++) add_concave(s, &s->shapes[SCENE_CONVEX_SHAPES + i], &concave_drawings[i]);
}

/* The floor's height at a seam, in sixteenths of a unit: two waves. */
static int32_t floor_height(int32_t seam)
{
    int32_t wide = scene_heading((uint8_t)(seam * 12)).y, narrow = scene_heading((uint8_t)(seam * 28 + 40)).y;
    return 176 * 16 + wide * 30 * 16 / 16384 + narrow * 8 * 16 / 16384;
}

/* Pieces of 32 units, flush: neighbors name the same two corners of their seam. */
void scene_build_floor(scene *s)
{
    for (uint16_t i = 0; i < SCENE_FLOOR_COUNT; i++) {
        int32_t left = floor_height(i), right = floor_height(i + 1);
        int32_t middle = (left + right) / 32 + 18;
        int16_t low = (int16_t)(left - middle * 16), high = (int16_t)(right - middle * 16);
        corner corners[4];
        corners[0].x = -256;
        corners[0].y = low;
        corners[1].x = 256;
        corners[1].y = high;
        corners[2].x = 256;
        corners[2].y = (int16_t)(high + 36 * 16);
        corners[3].x = -256;
        corners[3].y = (int16_t)(low + 36 * 16);
        tuff_terrain *piece = &s->terrain[i];
        piece->position = scene_vec2(((int32_t)i - SCENE_FLOOR_COUNT / 2) * 32 * SCENE_ONE + 16 * SCENE_ONE, middle * SCENE_ONE);
        piece->radius = TUFF_WHOLE(18);
        piece->bounding_radius = cover(corners, 4, piece->radius);
        piece->parts = &s->parts[s->part_count];
        piece->part_count = 1;
        add_part(s, corners, 4, 0);
    }
}
