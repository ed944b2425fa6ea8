/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Box2D as a whole engine on a game's scene, in the game's units: lengths in world units, speeds in units a step, 60 steps a
   second. Bodies do not rotate and do not meet each other. 32 units are one of Box2D's meters, which its tolerances are made
   for: its slop of 5 mm is 0.16 units. */
#ifndef TUFF_STABILITY_YARDSTICK_H
#define TUFF_STABILITY_YARDSTICK_H

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

#define YARDSTICK_VERTICES 8        /* that Box2D's polygons may have */

typedef struct yardstick yardstick;
typedef struct yardstick_vec { double x, y; } yardstick_vec;
typedef struct yardstick_material { double restitution, friction; } yardstick_material;  /* friction is Coulomb's, not tuff's */
typedef struct yardstick_state { yardstick_vec position, velocity; } yardstick_state;

/* continuous: also against tunnelling, Box2D's default. */
yardstick *yardstick_new(yardstick_vec gravity, bool continuous);
void yardstick_free(yardstick *yard);

/* Terrain. False: Box2D does not take the polygon (more than 8 vertices, or it would weld some). A chain is Box2D's own remedy
   for seams: an open line of points without ghost collisions, solid from the left of its direction. */
bool yardstick_add_polygon(yardstick *yard, yardstick_vec at, const yardstick_vec *vertices, int count, double friction);
void yardstick_add_circle(yardstick *yard, yardstick_vec at, double radius, double friction);
void yardstick_add_chain(yardstick *yard, const yardstick_vec *points, int count, double friction);

/* Which terrain, by number in the order of adding, does Box2D's tree offer for this box? Up to room numbers; the count. */
int yardstick_query(const yardstick *yard, yardstick_vec low, yardstick_vec high, int *found, int room);

/* Bodies; their number, or -1. They bounce at any speed, slower ones than 1 m/s included. */
int yardstick_add_ball(yardstick *yard, yardstick_state state, double radius, yardstick_material material);
int yardstick_add_hull(yardstick *yard, yardstick_state state, const yardstick_vec *vertices, int count, yardstick_material material);

void yardstick_step(yardstick *yard);
yardstick_state yardstick_body(const yardstick *yard, int body);
void yardstick_set(yardstick *yard, int body, yardstick_state state);

#ifdef __cplusplus
}
#endif

#endif
