/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Mirrored and turned copies of shapes and pieces: coordinates and normals negated in x, or turned a quarter from +x to +y, all
   indices kept. */
#ifndef TUFF_TESTS_TURNED_H
#define TUFF_TESTS_TURNED_H

#include "tuff/tuff.h"

#define TURNED_MOST_PARTS 512

enum { MIRROR, TURN_LEFT, TRANSFORMS };

static const char *const transform_names[TRANSFORMS] = { "mirrored", "turned" };

static inline tuff_vec2 apply(int transform, tuff_vec2 v)
{
    return transform == MIRROR ? (tuff_vec2){ 0 - v.x, v.y } : (tuff_vec2){ 0 - v.y, v.x };
}

static inline tuff_unit2 apply_unit(int transform, tuff_unit2 n)
{
    return transform == MIRROR ? (tuff_unit2){ 0 - n.x, n.y } : (tuff_unit2){ 0 - n.y, n.x };
}

typedef struct copies {        /* not to be copied: the polygons point into it */
    tuff_vec2    vertices[TURNED_MOST_PARTS][TUFF_MAX_VERTICES];
    tuff_unit2   normals[TURNED_MOST_PARTS][TUFF_MAX_VERTICES];
    tuff_polygon polygons[TURNED_MOST_PARTS];
    int          count;      /* 0 to begin anew */
} copies;

static inline const tuff_polygon *copy_polygon(copies *to, int transform, const tuff_polygon *from)
{
    int slot = to->count++;
    for (int i = 0; i < from->count; i++) {
        to->vertices[slot][i] = apply(transform, from->vertices[i]);
        if (from->normals) to->normals[slot][i] = apply_unit(transform, from->normals[i]);
    }
    to->polygons[slot] = *from;
    to->polygons[slot].vertices = to->vertices[slot];
    to->polygons[slot].normals = from->normals ? to->normals[slot] : NULL;
    return &to->polygons[slot];
}

static inline tuff_terrain copy_terrain(copies *to, int transform, const tuff_terrain *from)
{
    tuff_terrain made = *from;
    made.position = apply(transform, from->position);
    made.parts = from->parts ? &to->polygons[to->count] : NULL;
    for (int i = 0; i < from->part_count; i++) copy_polygon(to, transform, &from->parts[i]);
    return made;
}

#endif
