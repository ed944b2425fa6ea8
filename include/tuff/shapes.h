/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The limits, and the plain structs that a game fills in. */
#ifndef TUFF_SHAPES_H
#define TUFF_SHAPES_H

#include "names.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Limits, in whole units; TUFF_WHOLE(TUFF_MAX_...) is the number. They keep every product of the fixed build within
   64 bits. */
#define TUFF_MAX_VERTICES         32     /* vertices of a polygon: one bit each in internal_edges */
#define TUFF_MAX_EXTENT           1024   /* |x| and |y| of a vertex, from its owner's position */
#define TUFF_MAX_RADIUS           1024   /* radius of a circle */
#define TUFF_MAX_BOUNDING_RADIUS  1449   /* covers a vertex at (1024, 1024); also the radius that goes with a hull */
#define TUFF_MAX_SPEED            1024   /* |vx| and |vy|, units a step */
#define TUFF_MAX_RESTITUTION      4
#define TUFF_MAX_FRICTION         1
#define TUFF_MAX_POSITION         32768  /* |x| and |y| of a position; in the fixed build every tuff_real is within */

typedef struct tuff_vec2  { tuff_real x, y; } tuff_vec2;    /* world units; y grows the way the game says */
typedef struct tuff_unit2 { tuff_unit x, y; } tuff_unit2;   /* unit vector */

/* A convex polygon, in either winding: an obstacle's part or a body's hull. */
typedef struct tuff_polygon {
    const tuff_vec2  *vertices;     /* offsets from the owner's position, within TUFF_MAX_EXTENT */
    const tuff_unit2 *normals;      /* outward; normals[i] belongs to the edge vertices[i] -> vertices[i + 1]; a hull may leave it NULL */
    uint32_t internal_edges;        /* bit i: edge i touches a neighboring part over its whole length; 0 for a whole outline */
    uint8_t  count;                 /* 3 .. TUFF_MAX_VERTICES; otherwise: not baked yet, and a hull counts as NULL */
} tuff_polygon;

/* One piece of terrain: an asteroid, a floater, a length of floor. All zero: an empty slot, skipped by every call.
   Not baked while parts is NULL, part_count is 0 or any part has fewer than 3 vertices or NULL normals: a circle then. */
typedef struct tuff_terrain {
    tuff_vec2 position;
    tuff_real radius;               /* the circle used while there is no polygon; 0 .. TUFF_MAX_RADIUS */
    tuff_real bounding_radius;      /* covers every vertex and the circle; > 0, to TUFF_MAX_BOUNDING_RADIUS */
    const tuff_polygon *parts;      /* convex parts of one outline */
    uint8_t   part_count;
} tuff_terrain;

/* How far to move out, and which way: moving the entity by overlap * normal separates it from the obstacle. */
typedef struct tuff_contact {
    tuff_real  overlap;             /* > 0 */
    tuff_unit2 normal;              /* away from the obstacle; never (0, 0) */
} tuff_contact;

/* What a bounce leaves of the speed: v_n' = -restitution * v_n along the normal, v_t' = (1 - friction) * v_t along
   the surface. */
typedef struct tuff_material {
    tuff_real restitution;          /* 0 .. TUFF_MAX_RESTITUTION; above 1 adds energy (a bumper) */
    tuff_real friction;             /* 0 .. TUFF_MAX_FRICTION */
} tuff_material;

/* Used where a body's material is NULL: restitution 1.09 - 1, friction 0.01 ("nearly inelastic"; 1.09 is the impulse
   factor 1 + e). */
extern const tuff_material tuff_default_material;

/* Whatever moves: a ship, an enemy, a shot. */
typedef struct tuff_body {
    tuff_vec2 position;
    tuff_vec2 velocity;             /* units a step, within TUFF_MAX_SPEED */
    const tuff_material *material;  /* NULL: tuff_default_material */
} tuff_body;

#ifdef __cplusplus
}
#endif

#endif
