/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What is true, to 113 bits: how deep two shapes overlap and along which axes, whether a segment touches a shape, where a beam enters it.
   All lengths in steps of 1/65536 unit. Made from the vertices alone, never from the library's normals. */
#ifndef TUFF_TESTS_ORACLE_H
#define TUFF_TESTS_ORACLE_H

#include "exact.h"

#define ORACLE_MAX_AXES (2 * TUFF_MAX_VERTICES)

typedef struct oracle_polygon {     /* outward normals of unit length */
    exact2 vertices[TUFF_MAX_VERTICES];
    exact2 normals[TUFF_MAX_VERTICES];
    int    count;
} oracle_polygon;

/* An axis: which way to push, and how far along it until the shapes touch. Negative: they are that far apart along it. */
typedef struct oracle_axis { exact2 normal; exact depth; } oracle_axis;

typedef struct oracle_answer {
    oracle_axis axes[ORACLE_MAX_AXES];
    int   count;
    exact depth;                    /* the least of all directions: > 0 overlap, 0 touching, < 0 apart */
} oracle_answer;

/* Either winding; no edge without length. */
void oracle_read_polygon(oracle_polygon *exact_polygon, const tuff_polygon *polygon);

/* A circle against a polygon. Apart, depth is minus the distance between them. */
void oracle_circle(const oracle_polygon *polygon, exact2 center, exact radius, oracle_answer *answer);

/* A circle against a circle about the origin. Coincident centers: every axis is right; count is 0. */
void oracle_circles(exact2 center, exact radius, exact obstacle_radius, oracle_answer *answer);

/* A hull at an offset against a polygon. Apart, depth is minus the largest gap along a face normal, which is no more than the distance. */
void oracle_hull(const oracle_polygon *polygon, const oracle_polygon *hull, exact2 offset, oracle_answer *answer);

/* The distance between a hull at an offset and a polygon whose interiors are disjoint. */
exact oracle_hull_distance(const oracle_polygon *polygon, const oracle_polygon *hull, exact2 offset);

/* From a point to the nearest point of the outline; to the face with this number. */
exact oracle_outline_distance(const oracle_polygon *polygon, exact2 point);
exact oracle_face_distance(const oracle_polygon *polygon, int face, exact2 point);

/* The angle in radians, or its sine where that is small; 4 for more than a right angle. unit: of unit length. */
exact oracle_angle(exact2 a, exact2 unit);

/* How far, in radians, a normal is from the nearest axis whose depth exceeds the least by no more than slack. 0 where every axis is
   right. */
exact oracle_normal_error(const oracle_answer *answer, exact slack, exact2 normal);

/* Does the closed segment a-b touch the closed polygon? Exact for coordinates in whole steps. */
bool oracle_segment_polygon(const oracle_polygon *polygon, exact2 a, exact2 b);

/* Does it touch the closed disc about the origin? Exact for whole steps. */
bool oracle_segment_circle(exact2 a, exact2 b, exact radius);

/* How far a segment is from touching, or, where it does touch, how far it must move to stop touching. */
exact oracle_segment_polygon_margin(const oracle_polygon *polygon, exact2 a, exact2 b);
exact oracle_segment_circle_margin(exact2 a, exact2 b, exact radius);

/* The fraction of the way from a to b at which the segment enters the polygon or the disc, and the normal there. False: it does not, or
   a is inside. */
bool oracle_enter_polygon(const oracle_polygon *polygon, exact2 a, exact2 b, exact *fraction, exact2 *normal);
bool oracle_enter_circle(exact2 a, exact2 b, exact radius, exact *fraction, exact2 *normal);

#endif
