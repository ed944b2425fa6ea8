/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What is wrong with this shape, this world? For debug builds, tools and tests; the frame calls do without. */
#ifndef TUFF_CHECK_H
#define TUFF_CHECK_H

#include "world.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum tuff_fault {
    TUFF_OK = 0,
    /* polygons */
    TUFF_FAULT_NULL,                  /* a pointer that must not be NULL is */
    TUFF_FAULT_TOO_FEW_VERTICES,
    TUFF_FAULT_TOO_MANY_VERTICES,
    TUFF_FAULT_NOT_FINITE,            /* NaN or infinity */
    TUFF_FAULT_VERTEX_RANGE,          /* beyond TUFF_MAX_EXTENT */
    TUFF_FAULT_DUPLICATE_VERTEX,      /* an edge without length */
    TUFF_FAULT_NO_AREA,
    TUFF_FAULT_CONCAVE,               /* or crossing itself, or going round twice */
    TUFF_FAULT_NO_NORMALS,
    TUFF_FAULT_NORMAL_LENGTH,         /* not a unit vector */
    TUFF_FAULT_NORMAL_DIRECTION,      /* not square to its edge */
    TUFF_FAULT_NORMAL_INWARD,
    TUFF_FAULT_INTERNAL_BITS,         /* bits beyond the last edge */
    /* pieces */
    TUFF_FAULT_POSITION_RANGE,
    TUFF_FAULT_RADIUS_RANGE,          /* negative or beyond TUFF_MAX_RADIUS */
    TUFF_FAULT_BOUNDING_RANGE,        /* not above 0, or beyond TUFF_MAX_BOUNDING_RADIUS */
    TUFF_FAULT_BOUNDING_TOO_SMALL,    /* does not cover a vertex or the circle */
    TUFF_FAULT_INTERNAL_UNMATCHED,    /* an internal edge that no other part has, ends swapped or not */
    /* bodies */
    TUFF_FAULT_VELOCITY_RANGE,
    TUFF_FAULT_HULL_RADIUS,           /* the radius does not cover the hull */
    TUFF_FAULT_RESTITUTION_RANGE,
    TUFF_FAULT_FRICTION_RANGE,
    /* worlds */
    TUFF_FAULT_TERRAIN_COUNT,         /* more than TUFF_MAX_PIECES */
    TUFF_FAULT_ORDER,
    TUFF_FAULT_BUCKET_COUNT,          /* 0 or not a power of two */
    TUFF_FAULT_PITCH,
    TUFF_FAULT_INDEX_STALE,           /* the index holds a number beyond the terrain, or an empty slot */
    TUFF_FAULT_INDEX_MISSING,         /* a piece that the index in use does not hold */
    TUFF_FAULT_INDEX_MOVED,           /* a piece is no longer where, or as large as, the index has it */
    TUFF_FAULT_INDEX_BROKEN,          /* lists that are no lists: the storage was overwritten */
    TUFF_FAULT_COUNT
} tuff_fault;

/* A convex part of an obstacle: normals are needed. Collinear vertices are legal, duplicates are not. */
tuff_fault tuff_check_polygon(const tuff_polygon *polygon);

/* A body's hull: as a part, but normals may be NULL. */
tuff_fault tuff_check_hull(const tuff_polygon *hull);

/* A piece with all its parts. An empty slot is well. A piece that is not baked yet (parts NULL, count 0) is well. */
tuff_fault tuff_check_terrain(const tuff_terrain *piece);

/* A body with the radius and hull (or NULL) that go into the collide call. */
tuff_fault tuff_check_body(const tuff_body *body, tuff_real radius, const tuff_polygon *hull);

/* A world, its pieces and its index. *piece (may be NULL): the piece at fault, 0 if the fault is the world's own.
   Time: pieces, and for the index pieces again. */
tuff_fault tuff_check_world(const tuff_world *world, uint16_t *piece);

/* One English sentence without a period. Never NULL. */
const char *tuff_fault_text(tuff_fault fault);

#ifdef __cplusplus
}
#endif

#endif
