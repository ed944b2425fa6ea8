/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The build that this file is compiled for, behind side.h. */
#include "side.h"

#include "tuff/tuff.h"

#if TUFF_SCALAR == TUFF_Q16_16
#define SIDE side_q16
#define SIDE_NAME "q16"
#define FROM_REAL(r) ((double)(r) / 65536.0)
#define FROM_UNIT(u) ((double)(u) / 1073741824.0)
#else
#define SIDE side_float
#define SIDE_NAME "float"
#define FROM_REAL(r) ((double)(r))
#define FROM_UNIT(u) ((double)(u))
#endif

typedef struct baked {
    tuff_vec2    vertices[SIDE_VERTICES];
    tuff_unit2   normals[SIDE_VERTICES];
    tuff_polygon polygon;
} baked;

/* Covers every shape of the test. */
static const tuff_real cover = TUFF_WHOLE(200);

static tuff_vec2 vec(side_vec v)
{
    return (tuff_vec2){ tuff_from_q16_16(v.x), tuff_from_q16_16(v.y) };
}

static void bake(baked *b, const side_shape *shape)
{
    for (int i = 0; i < shape->count; i++) b->vertices[i] = vec(shape->vertices[i]);
    tuff_edge_normals(b->vertices, (uint8_t)shape->count, b->normals);
    b->polygon = (tuff_polygon){ b->vertices, b->normals, 0, (uint8_t)shape->count };
}

static tuff_terrain piece_of(const baked *rock, side_vec at)
{
    return (tuff_terrain){ vec(at), 0, cover, &rock->polygon, 1 };
}

static side_contact contact_of(bool found, const tuff_contact *c)
{
    return (side_contact){ found, FROM_REAL(c->overlap), FROM_UNIT(c->normal.x), FROM_UNIT(c->normal.y) };
}

static side_contact circle(const side_shape *shape, side_vec at, side_vec center, int32_t radius)
{
    baked rock;
    tuff_contact contact = { 0, { 0, 0 } };
    bake(&rock, shape);
    tuff_terrain piece = piece_of(&rock, at);
    bool found = tuff_terrain_overlap_circle(&piece, vec(center), tuff_from_q16_16(radius), &contact);
    return contact_of(found, &contact);
}

static side_contact hull(const side_shape *shape, side_vec at, const side_shape *hull_shape, side_vec position)
{
    baked rock, own;
    tuff_contact contact = { 0, { 0, 0 } };
    bake(&rock, shape);
    bake(&own, hull_shape);
    tuff_terrain piece = piece_of(&rock, at);
    bool found = tuff_terrain_overlap_hull(&piece, vec(position), cover, &own.polygon, &contact);
    return contact_of(found, &contact);
}

static side_hit beam(const side_shape *shape, side_vec at, side_vec a, side_vec b)
{
    baked rock;
    tuff_beam_hit hit = { 0, { 0, 0 }, 0 };
    bake(&rock, shape);
    tuff_terrain piece = piece_of(&rock, at);
    tuff_world world = { &piece, 1, NULL, NULL, 0, TUFF_ORDER_ITERATION };
    bool found = tuff_segment_terrain_first_hit(&world, vec(a), vec(b), &hit);
    return (side_hit){ found, FROM_UNIT(hit.fraction), FROM_UNIT(hit.normal.x), FROM_UNIT(hit.normal.y) };
}

static side_state collide(const side_shape *shape, side_vec at, const side_shape *hull_shape, side_vec position, side_vec velocity)
{
    baked rock, own;
    bake(&rock, shape);
    bake(&own, hull_shape);
    tuff_terrain piece = piece_of(&rock, at);
    tuff_world world = { &piece, 1, NULL, NULL, 0, TUFF_ORDER_ITERATION };
    tuff_body body = { vec(position), vec(velocity), NULL };
    int pushes = tuff_terrain_collide(&world, &body, cover, &own.polygon);
    return (side_state){ pushes, FROM_REAL(body.position.x), FROM_REAL(body.position.y), FROM_REAL(body.velocity.x),
                         FROM_REAL(body.velocity.y) };
}

const side SIDE = { SIDE_NAME, circle, hull, beam, collide, sizeof(tuff_real), sizeof(tuff_polygon) };
