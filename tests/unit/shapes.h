/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Shapes, bodies and worlds that several unit tests use. DEFINE_... stands where a file wants the thing, with a semicolon after it: what
   a file does not define takes none of its memory. */
#ifndef SHAPES_H
#define SHAPES_H

#include "support.h"

/* -------------------------------------------------------------------------------------------------------- shapes */

/* A box, counterclockwise where y grows upwards: edges y = y0, x = x1, y = y1, x = x0 in this order. */
#define BOX_VERTICES(x0, y0, x1, y1) \
    { { W(x0), W(y0) }, { W(x1), W(y0) }, { W(x1), W(y1) }, { W(x0), W(y1) } }
#define BOX_NORMALS \
    { { 0, TUFF_UNIT_RATIO(-1, 1) }, { ONE, 0 }, { 0, ONE }, { TUFF_UNIT_RATIO(-1, 1), 0 } }

/* The same in the other winding: edges x = x0, y = y1, x = x1, y = y0. */
#define BOX_VERTICES_REVERSED(x0, y0, x1, y1) \
    { { W(x0), W(y0) }, { W(x0), W(y1) }, { W(x1), W(y1) }, { W(x1), W(y0) } }
#define BOX_NORMALS_REVERSED \
    { { TUFF_UNIT_RATIO(-1, 1), 0 }, { 0, ONE }, { ONE, 0 }, { 0, TUFF_UNIT_RATIO(-1, 1) } }

/* A square that stands on a corner, each corner 5 from the middle. */
#define DIAMOND_VERTICES \
    { { W(5), 0 }, { 0, W(5) }, { W(-5), 0 }, { 0, W(-5) } }

/* A polygon of this name with the arrays name_vertices and name_normals. */
#define DEFINE_BOX(name, x0, y0, x1, y1) \
    static const tuff_vec2 name##_vertices[4] = BOX_VERTICES(x0, y0, x1, y1); \
    static const tuff_unit2 name##_normals[4] = BOX_NORMALS; \
    static const tuff_polygon name = { name##_vertices, name##_normals, 0, 4 }
#define DEFINE_BOX_REVERSED(name, x0, y0, x1, y1) \
    static const tuff_vec2 name##_vertices[4] = BOX_VERTICES_REVERSED(x0, y0, x1, y1); \
    static const tuff_unit2 name##_normals[4] = BOX_NORMALS_REVERSED; \
    static const tuff_polygon name = { name##_vertices, name##_normals, 0, 4 }

/* Right angle at the origin, legs of 30 and 40; the third side faces (4, 3) / 5 at a distance of 24. */
#define DEFINE_WEDGE(name) \
    static const tuff_vec2 name##_vertices[3] = { { 0, 0 }, { W(30), 0 }, { 0, W(40) } }; \
    static const tuff_unit2 name##_normals[3] = { { 0, TUFF_UNIT_RATIO(-1, 1) }, { TUFF_UNIT_RATIO(4, 5), TUFF_UNIT_RATIO(3, 5) }, \
                                                  { TUFF_UNIT_RATIO(-1, 1), 0 } }; \
    static const tuff_polygon name = { name##_vertices, name##_normals, 0, 3 }

/* Two parts side by side, 20 high: from -outer to -inner and from inner to outer, with their internal edges. normals: a box's. */
#define DEFINE_PAIR_OF_BOXES(name, inner, outer, normals, left_internal, right_internal) \
    static const tuff_vec2 name##_left[4] = BOX_VERTICES(-(outer), -10, -(inner), 10); \
    static const tuff_vec2 name##_right[4] = BOX_VERTICES(inner, -10, outer, 10); \
    static const tuff_polygon name[2] = { { name##_left, normals, left_internal, 4 }, { name##_right, normals, right_internal, 4 } }

/* A polygon of these vertices; its normals are made. */
static inline tuff_polygon baked(const tuff_vec2 *vertices, uint8_t count, tuff_unit2 *normals)
{
    tuff_polygon polygon;
    polygon.vertices = vertices;
    polygon.normals = normals;
    polygon.internal_edges = 0;
    polygon.count = count;
    tuff_edge_normals(vertices, count, normals);
    return polygon;
}

/* A convex polygon with 32 edges, no two parallel alike, 13 to 14 units each way from its middle: eight primitive steps in the order
   of their angle, then the same turned by 90, 180 and 270 degrees. */
static inline void largest_polygon(tuff_vec2 vertices[32])
{
    static const int8_t step_x[8] = { 1, 3, 2, 3, 1, 2, 1, 1 };
    static const int8_t step_y[8] = { 0, 1, 1, 2, 1, 3, 2, 3 };
    int16_t x = 0;
    int16_t y = -13;
    for (uint8_t i = 0; i < 32; i++) {
        int16_t sx = step_x[i % 8];
        int16_t sy = step_y[i % 8];
        uint8_t quarter = i / 8;
        vertices[i] = whole(x, y);
        x = (int16_t)(x + (quarter == 0 ? sx : quarter == 1 ? -sy : quarter == 2 ? -sx : sy));
        y = (int16_t)(y + (quarter == 0 ? sy : quarter == 1 ? sx : quarter == 2 ? -sy : -sx));
    }
}

static inline tuff_polygon baked_largest_polygon(tuff_vec2 vertices[32], tuff_unit2 normals[32])
{
    largest_polygon(vertices);
    return baked(vertices, 32, normals);
}

/* -------------------------------------------------------------------------------------------------------- bodies */

static inline tuff_body body_of(tuff_vec2 position, tuff_vec2 velocity, const tuff_material *material)
{
    tuff_body body;
    body.position = position;
    body.velocity = velocity;
    body.material = material;
    return body;
}

static inline tuff_body body_at_rest(tuff_vec2 position)
{
    return body_of(position, vec(0, 0), NULL);
}

/* Without a material, its velocity (-4, 6). */
static inline tuff_body moving_body(int16_t x, int16_t y)
{
    return body_of(whole(x, y), whole(-4, 6), NULL);
}

/* At rest in the middle of an edge. */
static inline tuff_body body_on_edge(const tuff_polygon *polygon, uint8_t edge)
{
    tuff_vec2 a = polygon->vertices[edge];
    tuff_vec2 b = polygon->vertices[(edge + 1) % polygon->count];
    return body_at_rest(vec((a.x + b.x) / 2, (a.y + b.y) / 2));
}

/* The corners of the range of positions and the middles of its sides, 0 to 7. */
static inline tuff_vec2 end_of_range(uint8_t number)
{
    static const tuff_real ends[3] = { LOWEST, HIGHEST, 0 };
    return vec(ends[number / 3], ends[number % 3]);
}

/* -------------------------------------------------------------------------------------------------------- worlds */

/* Storage for a terrain and its index: terrain, buckets, entries, chunks. */
#define DEFINE_TERRAIN(pieces, bucket_number, pitch) \
    static tuff_terrain terrain[pieces]; \
    static uint16_t buckets[bucket_number]; \
    static tuff_chunk_entry entries[pieces]; \
    static tuff_chunks chunks = TUFF_CHUNKS(buckets, entries, pitch)

/* All slots empty, nothing in the index, which is given to the world. */
static inline void empty_world(tuff_world *world, tuff_terrain *terrain, uint16_t count, tuff_chunks *chunks)
{
    static const tuff_terrain empty;
    for (uint16_t i = 0; i < count; i++) terrain[i] = empty;
    tuff_chunks_clear(chunks);
    world->terrain = terrain;
    world->terrain_count = count;
    world->chunks = chunks;
}

/* A piece whose bounding radius, 15, covers a box of 20 by 20. */
static inline tuff_terrain piece_of(tuff_vec2 position, tuff_real radius, const tuff_polygon *parts, uint8_t part_count)
{
    tuff_terrain piece;
    piece.position = position;
    piece.radius = radius;
    piece.bounding_radius = W(15);
    piece.parts = parts;
    piece.part_count = part_count;
    return piece;
}

/* The piece at one of the places 0 to 4: at the origin and at four far from it. */
#define FAR_PLACES 5
static inline tuff_terrain moved_far(const tuff_terrain *piece, uint8_t place)
{
    static const int16_t origins[FAR_PLACES][2] = { { 0, 0 }, { 16000, -16000 }, { -32000, 32000 }, { 32000, 1 }, { -7, -32000 } };
    tuff_terrain far = *piece;
    far.position = whole(origins[place][0], origins[place][1]);
    return far;
}

#endif
