/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The little of Box2D 2.4 that the tests compare with, for C. Polygons have radius 0, so that Box2D's skin does not count. */
#ifndef TUFF_TESTS_BOX2D_SHIM_H
#define TUFF_TESTS_BOX2D_SHIM_H

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct box2d_vec { float x, y; } box2d_vec;
typedef struct box2d_contact { float overlap; box2d_vec normal; } box2d_contact;    /* normal: away from the obstacle */
typedef struct box2d_hit { float fraction; box2d_vec normal; } box2d_hit;
typedef struct box2d_polygon box2d_polygon;
typedef struct box2d_world box2d_world;

/* 3 .. 8 convex vertices, either winding. NULL: Box2D would weld or drop one of them. */
box2d_polygon *box2d_polygon_new(const box2d_vec *vertices, int count);
void box2d_polygon_free(box2d_polygon *polygon);

/* Does the manifold have points, how deep is the deepest, along which normal? */
bool box2d_circle_polygon(const box2d_polygon *polygon, box2d_vec at, box2d_vec center, float radius, box2d_contact *contact);
bool box2d_hull_polygon(const box2d_polygon *polygon, box2d_vec at, const box2d_polygon *hull, box2d_vec position, box2d_contact *contact);

/* b2TestOverlap, by Box2D's other algorithm (GJK). */
bool box2d_circle_touches(const box2d_polygon *polygon, box2d_vec at, box2d_vec center, float radius);
bool box2d_hull_touches(const box2d_polygon *polygon, box2d_vec at, const box2d_polygon *hull, box2d_vec position);

/* Ray casts over the whole of a-b. */
bool box2d_ray_polygon(const box2d_polygon *polygon, box2d_vec at, box2d_vec a, box2d_vec b, box2d_hit *hit);
bool box2d_ray_circle(float radius, box2d_vec at, box2d_vec a, box2d_vec b, box2d_hit *hit);

/* A world without gravity, friction, sleep and continuous collision; balls do not meet each other, and bounce at any speed (as a rule
   Box2D takes less than 1 unit a second for resting). */
box2d_world *box2d_world_new(void);
void box2d_world_free(box2d_world *world);
void box2d_world_add_rock(box2d_world *world, const box2d_polygon *polygon, box2d_vec at);
int  box2d_world_add_ball(box2d_world *world, box2d_vec position, box2d_vec velocity, float radius, float restitution);
void box2d_world_step(box2d_world *world, float seconds);
void box2d_world_ball(const box2d_world *world, int ball, box2d_vec *position, box2d_vec *velocity);

#ifdef __cplusplus
}
#endif

#endif
