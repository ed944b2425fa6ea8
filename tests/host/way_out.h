/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Where an entity may not be because of a concave rock, and the shortest way out of there: by brute force in double, in world
   units. */
#ifndef TUFF_TESTS_WAY_OUT_H
#define TUFF_TESTS_WAY_OUT_H

#include "rocks.h"

typedef struct way_point { double x, y; } way_point;

static inline way_point way_between(way_point a, way_point b)    { return (way_point){ a.x - b.x, a.y - b.y }; }
static inline double way_dot(way_point a, way_point b)           { return a.x * b.x + a.y * b.y; }
static inline double way_length(way_point a, way_point b)        { return hypot(a.x - b.x, a.y - b.y); }
static inline way_point way_point_of(tuff_vec2 v)                { return (way_point){ units_of(v.x), units_of(v.y) }; }

/* What the entity's position must not be in: the union of convex polygons, each grown by a radius. For a circle, the parts and its
   radius; for a hull, the parts grown by the hull turned about (Minkowski), and radius 0. */
#define WAY_MOST_CORNERS (2 * TUFF_MAX_VERTICES)
typedef struct way_forbidden {
    way_point corners[ROCK_MAX_PARTS][WAY_MOST_CORNERS];
    int       counts[ROCK_MAX_PARTS];
    int       count;
    double    radius;
} way_forbidden;

/* Positions are relative to the rock's. hull NULL: a circle. */
void way_forbid(way_forbidden *f, const rock *made, double radius, const tuff_polygon *hull);

/* How far from the forbidden region: negative inside, where its amount is the depth in the part where it is deepest. */
double way_clearance(const way_forbidden *f, way_point p);

/* Length of the shortest move out of the region; 0 outside. */
double way_shortest(const way_forbidden *f, way_point from);

#endif
