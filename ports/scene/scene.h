/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   An asteroid belt in which everything that tuff does happens: input in, state and drawing list out. It knows no machine: no
   clock, file, heap or screen. The same seed and input give the same state, and with Q16.16 the same bits on every CPU.

   Compiled once for each number type; the object names carry the build, as the library's do, so both fit into one program. */
#ifndef SCENE_H
#define SCENE_H

#include <tuff/tuff.h>

#include "marks.h"

#define scene_init     TUFF_LINK_NAME(scene_init)
#define scene_step     TUFF_LINK_NAME(scene_step)
#define scene_pilot    TUFF_LINK_NAME(scene_pilot)
#define scene_take_aim TUFF_LINK_NAME(scene_take_aim)
#define scene_steer    TUFF_LINK_NAME(scene_steer)
#define scene_draw     TUFF_LINK_NAME(scene_draw)
#define scene_hash     TUFF_LINK_NAME(scene_hash)
#define scene_count    TUFF_LINK_NAME(scene_count)
#define scene_fault    TUFF_LINK_NAME(scene_fault)

/* The pieces of terrain by number: floor, two moons, then rocks: concave ones, those that can be blown up, plain ones. */
#define SCENE_FLOOR_COUNT     48
#define SCENE_MOON_COUNT      2
#define SCENE_CONCAVE_COUNT   9
#define SCENE_VOLATILE_COUNT  8
#define SCENE_PLAIN_COUNT     38
#define SCENE_FIRST_MOON      SCENE_FLOOR_COUNT
#define SCENE_FIRST_CONCAVE   (SCENE_FIRST_MOON + SCENE_MOON_COUNT)
#define SCENE_FIRST_VOLATILE  (SCENE_FIRST_CONCAVE + SCENE_CONCAVE_COUNT)
#define SCENE_FIRST_PLAIN     (SCENE_FIRST_VOLATILE + SCENE_VOLATILE_COUNT)
#define SCENE_PIECES          (SCENE_FIRST_PLAIN + SCENE_PLAIN_COUNT)

/* How much there is of what moves, and how many random places are tried in a step for what comes back; a port to a small machine may say
   less. Floaters: an even number. */
#ifndef SCENE_TRIES
#define SCENE_TRIES      60
#endif
#ifndef SCENE_ENEMIES
#define SCENE_ENEMIES    10
#endif
#ifndef SCENE_FLOATERS
#define SCENE_FLOATERS   10
#endif
#ifndef SCENE_SHOTS
#define SCENE_SHOTS      12
#endif
#define SCENE_SPARKS     40
#define SCENE_SCARS      16    /* pushes remembered for the picture */
#define SCENE_BUCKETS    128
#define SCENE_PITCH_LOG2 6     /* chunks of 64 units */
#define SCENE_HULL       5

/* Shapes of rocks are shared and constant: five small ones, five of medium size, five large ones, three concave ones. */
#define SCENE_CONVEX_SHAPES   15
#define SCENE_CONCAVE_SHAPES  3
#define SCENE_SIZE_SHAPES     5
#define SCENE_MEDIUM_SHAPES   5     /* the first of them */
#define SCENE_FLOOR_CORNERS   4

typedef struct scene_enemy {
    tuff_body body;
    uint8_t   facing;     /* 256 to the turn */
    uint8_t   hits;       /* left to take; 0: gone */
    uint8_t   shy;        /* steps that it keeps away after a bump */
    uint16_t  return_in;  /* steps until a new one takes its place */
} scene_enemy;

typedef struct scene_shot {
    tuff_body body;
    uint8_t   life;       /* steps left; 0: no shot */
    uint8_t   bounces;    /* left */
} scene_shot;

typedef struct scene_spark {   /* for the eye only; positions and speeds in Q16.16 */
    int32_t x, y, vx, vy;
    uint8_t life, color;
} scene_spark;

typedef struct scene_scar {    /* a push, for the eye only; Q16.16 */
    int32_t x, y;              /* where the body was touched */
    int32_t nx, ny;            /* normal */
    int32_t overlap;
    uint8_t life;
} scene_scar;

/* All of it. It points into itself: do not copy or move it. */
typedef struct scene {
    tuff_world       world;
    tuff_chunks      chunks;
    tuff_terrain     terrain[SCENE_PIECES];
    tuff_chunk_entry entries[SCENE_PIECES];
    uint16_t         buckets[SCENE_BUCKETS];
    uint16_t         nearby[SCENE_PIECES];
    uint8_t          hits[SCENE_VOLATILE_COUNT];      /* left to take by a volatile rock */
    uint16_t         grow_in[SCENE_VOLATILE_COUNT];   /* steps until a blown-up rock grows elsewhere */

    tuff_polygon floor_parts[SCENE_FLOOR_COUNT];
    tuff_vec2    floor_vertices[SCENE_FLOOR_COUNT * SCENE_FLOOR_CORNERS];
    tuff_unit2   floor_normals[SCENE_FLOOR_COUNT * SCENE_FLOOR_CORNERS];

    tuff_body    ship;
    tuff_vec2    hull_vertices[SCENE_HULL];
    tuff_polygon hull;
    uint8_t      facing;       /* 256 to the turn */
    uint8_t      shield, safe, energy, reload, heal;
    uint16_t     buttons;

    bool         beam_on;
    tuff_vec2    beam_end;

    scene_enemy  enemies[SCENE_ENEMIES];
    tuff_terrain floaters[SCENE_FLOATERS];
    tuff_body    floater_bodies[SCENE_FLOATERS];
    scene_shot   shots[SCENE_SHOTS];
    scene_spark  sparks[SCENE_SPARKS];
    scene_scar   scars[SCENE_SCARS];
    uint8_t      next_spark, next_scar;

    int32_t      camera_x, camera_y;   /* Q16.16 */
    uint32_t     random, frame, score;
    uint16_t     pushes;               /* in the latest step */
    uint16_t     events[SCENE_EVENTS];
} scene;

typedef struct scene_int2 { int32_t x, y; } scene_int2;

typedef struct scene_aim {
    scene_int2 way;      /* whole units to the target */
    int32_t distance;
    bool    enemy, rock;
} scene_aim;

/* A new belt. */
void scene_init(scene *s, uint32_t seed);

/* One sixtieth of a second. buttons: a sum of SCENE_LEFT ... SCENE_BEAM. */
void scene_step(scene *s, uint16_t buttons);

/* The buttons that the autopilot would press now. */
uint16_t scene_pilot(const scene *s);

/* The autopilot's work in two halves, for a machine that has no time for both in one step: what to hunt, and the buttons. */
void     scene_take_aim(const scene *s, scene_aim *target);
uint16_t scene_steer(const scene *s, const scene_aim *target);

/* Emits the marks of the picture, from back to front. */
void scene_draw(scene *s, const scene_view *view, scene_emit emit, void *context);

/* The state folded into a number; start with 0 and pass the result of the step before for a hash of a whole run. */
uint32_t scene_hash(const scene *s, uint32_t hash);

void scene_count(scene *s, scene_counts *counts);

/* What tuff's checks find wrong with the world, the floaters and the bodies, in words; NULL: nothing. *number: the piece, floater or
   body at fault. */
const char *scene_fault(const scene *s, uint16_t *number);

#endif
