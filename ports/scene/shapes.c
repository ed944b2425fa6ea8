/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The shapes of rocks, which tools/shapes traced from the pictures in rocks/, and of the floor, which is computed. */
#include "inner.h"

#include "rocks/small.h"
#include "rocks/medium.h"
#include "rocks/large.h"
#include "rocks/concave.h"

#if SMALL_ROCKS_COUNT != SCENE_SIZE_SHAPES || MEDIUM_ROCKS_COUNT != SCENE_SIZE_SHAPES || LARGE_ROCKS_COUNT != SCENE_SIZE_SHAPES \
    || CONCAVE_ROCKS_COUNT != SCENE_CONCAVE_SHAPES
#error "each frame of a picture in rocks/ holds one rock"
#endif

/* A rock about (0, 0). */
const tuff_terrain *scene_rock(uint8_t shape)
{
    static const tuff_terrain *const sheets[] = {small_rocks, medium_rocks, large_rocks, concave_rocks};
    return &sheets[shape / SCENE_SIZE_SHAPES][shape % SCENE_SIZE_SHAPES];
}

/* In sixteenths of a unit, which both builds hold exactly. */
typedef struct corner { int16_t x, y; } corner;

/* The floor's height at a seam, in sixteenths of a unit: two waves. */
static int32_t floor_height(int32_t seam)
{
    int32_t wide = scene_heading((uint8_t)(seam * 12)).y, narrow = scene_heading((uint8_t)(seam * 28 + 40)).y;
    return 176 * 16 + wide * 30 * 16 / 16384 + narrow * 8 * 16 / 16384;
}

/* The piece's part, normals and bounding radius from its corners. In sixteenths: the square of 1449 units would not fit. */
static void set_corners(scene *s, uint16_t piece, const corner corners[SCENE_FLOOR_CORNERS])
{
    tuff_terrain *floor = &s->terrain[piece];
    tuff_polygon *part = &s->floor_parts[piece];
    tuff_vec2 *vertices = &s->floor_vertices[piece * SCENE_FLOOR_CORNERS];
    tuff_unit2 *normals = &s->floor_normals[piece * SCENE_FLOOR_CORNERS];
    floor->bounding_radius = floor->radius;
    for (uint8_t i = 0; i < SCENE_FLOOR_CORNERS; i++) {
        tuff_real reach = tuff_from_q16_16((scene_distance(corners[i].x, corners[i].y) + 1) * 4096);
        vertices[i] = scene_vec2((int32_t)corners[i].x * 4096, (int32_t)corners[i].y * 4096);
        if (reach > floor->bounding_radius) floor->bounding_radius = reach;
    }
    tuff_edge_normals(vertices, SCENE_FLOOR_CORNERS, normals);
    part->vertices = vertices;
    part->normals = normals;
    part->internal_edges = 0;
    part->count = SCENE_FLOOR_CORNERS;
    floor->parts = part;
    floor->part_count = 1;
}

/* Pieces of 32 units, flush: neighbors name the same two corners of their seam. */
void scene_build_floor(scene *s)
{
    for (uint16_t i = 0; i < SCENE_FLOOR_COUNT; i++) {
        int32_t left = floor_height(i), right = floor_height(i + 1);
        int32_t middle = (left + right) / 32 + 18;
        int16_t low = (int16_t)(left - middle * 16), high = (int16_t)(right - middle * 16);
        corner corners[SCENE_FLOOR_CORNERS] = {{-256, 0}, {256, 0}, {256, 0}, {-256, 0}};
        corners[0].y = low;
        corners[1].y = high;
        corners[2].y = (int16_t)(high + 36 * 16);
        corners[3].y = (int16_t)(low + 36 * 16);
        s->terrain[i].position = scene_vec2(((int32_t)i - SCENE_FLOOR_COUNT / 2) * 32 * SCENE_ONE + 16 * SCENE_ONE, middle * SCENE_ONE);
        s->terrain[i].radius = TUFF_WHOLE(18);
        set_corners(s, i, corners);
    }
}
