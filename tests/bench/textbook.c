/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The textbook's tests; the few operations in which float and Q16.16 differ come first. */
#include "textbook.h"

#include <math.h>

#if TUFF_SCALAR == TUFF_Q16_16

#define HIGHEST TUFF_INT32_MAX

typedef int64_t product;            /* of which only the sign is wanted */

/* Sums wrap, as machines do it. */
static inline tuff_real plus(tuff_real a, tuff_real b)  { return (tuff_real)((uint32_t)a + (uint32_t)b); }
static inline tuff_real less(tuff_real a, tuff_real b)  { return (tuff_real)((uint32_t)a - (uint32_t)b); }

static inline tuff_real times(tuff_real a, tuff_real b)
{
    return (tuff_real)(((int64_t)a * b) >> 16);
}

static inline tuff_real over(tuff_real a, tuff_real b)
{
    return (tuff_real)((int64_t)a * 65536 / b);
}

/* A bit at a time, as machines without a square root do it. */
static tuff_real root(tuff_real square)
{
    uint64_t rest = (uint64_t)(uint32_t)square << 16, result = 0;
    for (uint64_t bit = (uint64_t)1 << 46; bit; bit >>= 2) {
        bool fits = rest >= result + bit;
        if (fits) rest -= result + bit;
        result = (result >> 1) + (fits ? bit : 0);
    }
    return (tuff_real)result;
}

static tuff_real from_unit(tuff_unit value)
{
    return (value + (1 << 13)) >> 14;
}

#else

#define HIGHEST 1e30f

typedef tuff_real product;

static inline tuff_real plus(tuff_real a, tuff_real b)  { return a + b; }
static inline tuff_real less(tuff_real a, tuff_real b)  { return a - b; }
static inline tuff_real times(tuff_real a, tuff_real b) { return a * b; }
static inline tuff_real over(tuff_real a, tuff_real b)  { return a / b; }
static inline tuff_real root(tuff_real square)          { return sqrtf(square); }
static tuff_real from_unit(tuff_unit value)             { return value; }

#endif

#define GUARD TUFF_RATIO(1, 100)    /* square of the distance below which the axis from the nearest vertex is left out */

typedef struct span { tuff_real low, high; } span;

static inline tuff_real dot(tuff_vec2 a, tuff_vec2 b)
{
    return plus(times(a.x, b.x), times(a.y, b.y));
}

static inline product cross(tuff_vec2 a, tuff_vec2 b)
{
    return (product)a.x * b.y - (product)a.y * b.x;
}

static inline tuff_vec2 minus(tuff_vec2 a, tuff_vec2 b)
{
    return (tuff_vec2){ less(a.x, b.x), less(a.y, b.y) };
}

static inline span project(const textbook_polygon *polygon, tuff_vec2 offset, tuff_vec2 axis)
{
    tuff_real shift = dot(offset, axis);
    span s = { HIGHEST, -HIGHEST };
    for (int i = 0; i < polygon->count; i++) {
        tuff_real at = dot(polygon->vertices[i], axis);
        if (at < s.low) s.low = at;
        if (at > s.high) s.high = at;
    }
    return (span){ plus(s.low, shift), plus(s.high, shift) };
}

/* False: the axis separates them. Otherwise keeps the least overlap; the mid points say which way is out. */
static inline bool compare(span mover, span obstacle, tuff_vec2 axis, textbook_contact *least)
{
    if (mover.high <= obstacle.low || obstacle.high <= mover.low) return false;
    bool forward = plus(mover.low, mover.high) >= plus(obstacle.low, obstacle.high);
    tuff_real overlap = forward ? less(obstacle.high, mover.low) : less(mover.high, obstacle.low);
    if (overlap >= least->overlap) return true;
    least->overlap = overlap;
    least->normal = forward ? axis : (tuff_vec2){ -axis.x, -axis.y };
    return true;
}

static inline bool compare_circle(tuff_vec2 center, tuff_real radius, const textbook_polygon *polygon, tuff_vec2 axis,
                                  textbook_contact *least)
{
    tuff_real at = dot(center, axis);
    return compare((span){ less(at, radius), plus(at, radius) }, project(polygon, (tuff_vec2){ 0, 0 }, axis), axis, least);
}

static tuff_vec2 from_nearest_vertex(tuff_vec2 center, const textbook_polygon *polygon)
{
    tuff_vec2 nearest = minus(center, polygon->vertices[0]);
    tuff_real least = dot(nearest, nearest);
    for (int i = 1; i < polygon->count; i++) {
        tuff_vec2 d = minus(center, polygon->vertices[i]);
        tuff_real square = dot(d, d);
        if (square >= least) continue;
        least = square;
        nearest = d;
    }
    return nearest;
}

bool textbook_circle(tuff_vec2 center, tuff_real radius, const textbook_polygon *polygon, textbook_contact *contact)
{
    textbook_contact least = { HIGHEST, { 0, 0 } };
    for (int i = 0; i < polygon->count; i++) {
        if (!compare_circle(center, radius, polygon, polygon->normals[i], &least)) return false;
    }
    tuff_vec2 d = from_nearest_vertex(center, polygon);
    tuff_real square = dot(d, d);
    if (square >= GUARD) {
        tuff_real length = root(square);
        tuff_vec2 axis = { over(d.x, length), over(d.y, length) };
        if (!compare_circle(center, radius, polygon, axis, &least)) return false;
    }
    *contact = least;
    return true;
}

static bool compare_along(const textbook_polygon *hull, tuff_vec2 offset, const textbook_polygon *polygon, const textbook_polygon *whose,
                          textbook_contact *least)
{
    for (int i = 0; i < whose->count; i++) {
        tuff_vec2 axis = whose->normals[i];
        if (!compare(project(hull, offset, axis), project(polygon, (tuff_vec2){ 0, 0 }, axis), axis, least)) return false;
    }
    return true;
}

bool textbook_hull(const textbook_polygon *hull, tuff_vec2 offset, const textbook_polygon *polygon, textbook_contact *contact)
{
    textbook_contact least = { HIGHEST, { 0, 0 } };
    if (!compare_along(hull, offset, polygon, polygon, &least)) return false;
    if (!compare_along(hull, offset, polygon, hull, &least)) return false;
    *contact = least;
    return true;
}

static inline bool crosses(tuff_vec2 a, tuff_vec2 b, tuff_vec2 c, tuff_vec2 d)
{
    tuff_vec2 ab = minus(b, a), cd = minus(d, c);
    product c_side = cross(ab, minus(c, a)), d_side = cross(ab, minus(d, a));
    if ((c_side > 0 && d_side > 0) || (c_side < 0 && d_side < 0)) return false;
    product a_side = cross(cd, minus(a, c)), b_side = cross(cd, minus(b, c));
    return !((a_side > 0 && b_side > 0) || (a_side < 0 && b_side < 0));
}

static bool inside(tuff_vec2 p, const textbook_polygon *polygon)
{
    bool odd = false;
    for (int i = 0, j = polygon->count - 1; i < polygon->count; j = i++) {
        tuff_vec2 from = polygon->vertices[j], to = polygon->vertices[i];
        if ((to.y > p.y) == (from.y > p.y)) continue;
        if (p.x - to.x < over(times(from.x - to.x, p.y - to.y), from.y - to.y)) odd = !odd;
    }
    return odd;
}

bool textbook_segment(tuff_vec2 a, tuff_vec2 b, const textbook_polygon *polygon)
{
    for (int i = 0, j = polygon->count - 1; i < polygon->count; j = i++) {
        if (crosses(a, b, polygon->vertices[j], polygon->vertices[i])) return true;
    }
    return inside(a, polygon);
}

void textbook_normals(const tuff_vec2 *vertices, int count, tuff_vec2 *normals)
{
    tuff_unit2 exact_normals[TUFF_MAX_VERTICES];
    tuff_edge_normals(vertices, (uint8_t)count, exact_normals);
    for (int i = 0; i < count; i++) normals[i] = (tuff_vec2){ from_unit(exact_normals[i].x), from_unit(exact_normals[i].y) };
}

void textbook_bounce(tuff_body *body, const textbook_contact *contact)
{
    tuff_vec2 n = contact->normal;
    tuff_real speed = dot(body->velocity, n);
    body->position.x = plus(body->position.x, times(contact->overlap, n.x));
    body->position.y = plus(body->position.y, times(contact->overlap, n.y));
    if (speed >= 0) return;
    tuff_vec2 along = minus(body->velocity, (tuff_vec2){ times(speed, n.x), times(speed, n.y) });
    tuff_real back = times(speed, TUFF_RATIO(-9, 100));
    body->velocity.x = times(back, n.x) + times(along.x, TUFF_RATIO(99, 100));
    body->velocity.y = times(back, n.y) + times(along.y, TUFF_RATIO(99, 100));
}
