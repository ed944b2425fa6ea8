/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The oracle: plain definitions, each in the simplest way that is exact. Speed is no concern here; doubles only choose which
   vertices are worth an exact look. */
#include "oracle.h"

#include <stdint.h>

/* ---- polygons ---- */

static exact twice_area(const oracle_polygon *p)
{
    exact area = 0;
    for (int i = 1; i + 1 < p->count; i++) {
        area += exact_cross(exact_sub(p->vertices[i], p->vertices[0]), exact_sub(p->vertices[i + 1], p->vertices[0]));
    }
    return area;
}

static exact2 vertex_after(const oracle_polygon *p, int i)
{
    return p->vertices[i + 1 == p->count ? 0 : i + 1];
}

static exact2 scaled(exact2 v, exact factor)
{
    return (exact2){ v.x * factor, v.y * factor };
}

void oracle_read_polygon(oracle_polygon *p, const tuff_polygon *polygon)
{
    p->count = polygon->count;
    for (int i = 0; i < p->count; i++) p->vertices[i] = exact_vec2(polygon->vertices[i]);
    exact way = twice_area(p) > 0 ? 1 : -1;
    for (int i = 0; i < p->count; i++) {
        exact2 edge = exact_sub(vertex_after(p, i), p->vertices[i]);
        p->normals[i] = scaled((exact2){ edge.y, -edge.x }, way / exact_length(edge));
    }
}

/* The largest projection of the polygon on an axis. The doubles are off by less than 2^-20 steps. */
static exact support(const oracle_polygon *p, exact2 axis)
{
    double along[TUFF_MAX_VERTICES], most = -HUGE_VAL;
    double x = (double)axis.x, y = (double)axis.y;
    for (int i = 0; i < p->count; i++) {
        along[i] = (double)p->vertices[i].x * x + (double)p->vertices[i].y * y;
        if (along[i] > most) most = along[i];
    }
    exact best = 0;
    bool found = false;
    for (int i = 0; i < p->count; i++) {
        if (along[i] < most - 0.001) continue;
        exact value = exact_dot(p->vertices[i], axis);
        if (!found || value > best) best = value;
        found = true;
    }
    return best;
}

static exact2 closest_on_segment(exact2 point, exact2 a, exact2 b)
{
    exact2 way = exact_sub(b, a);
    exact length = exact_dot(way, way), along = exact_dot(exact_sub(point, a), way);
    if (along <= 0 || length == 0) return a;
    if (along >= length) return b;
    return exact_add(a, scaled(way, along / length));
}

static exact distance_to_segment(exact2 point, exact2 a, exact2 b)
{
    return exact_length(exact_sub(point, closest_on_segment(point, a, b)));
}

exact oracle_face_distance(const oracle_polygon *p, int face, exact2 point)
{
    return distance_to_segment(point, p->vertices[face], vertex_after(p, face));
}

exact oracle_outline_distance(const oracle_polygon *p, exact2 point)
{
    exact least = -1;
    for (int i = 0; i < p->count; i++) {
        exact distance = oracle_face_distance(p, i, point);
        if (least < 0 || distance < least) least = distance;
    }
    return least;
}

/* ---- overlaps ---- */

static void add_axis(oracle_answer *answer, exact2 normal, exact depth)
{
    answer->axes[answer->count++] = (oracle_axis){ normal, depth };
}

static void least_of_axes(oracle_answer *answer)
{
    answer->depth = answer->axes[0].depth;
    for (int i = 1; i < answer->count; i++) {
        if (answer->axes[i].depth < answer->depth) answer->depth = answer->axes[i].depth;
    }
}

/* Outwards to the center from each vertex that may be an axis as good as the best within the widest slack, 1e-3 units. */
static void add_vertex_axes(const oracle_polygon *p, exact2 center, exact radius, exact distance, oracle_answer *answer)
{
    for (int i = 0; i < p->count; i++) {
        exact2 way = exact_sub(center, p->vertices[i]);
        exact length = exact_length(way);
        if (length == 0 || length > distance + 66) continue;
        exact2 normal = scaled(way, 1 / length);
        add_axis(answer, normal, radius + support(p, normal) - exact_dot(normal, center));
    }
}

void oracle_circle(const oracle_polygon *p, exact2 center, exact radius, oracle_answer *answer)
{
    answer->count = 0;
    for (int i = 0; i < p->count; i++) {
        add_axis(answer, p->normals[i], radius - exact_dot(p->normals[i], exact_sub(center, p->vertices[i])));
    }
    least_of_axes(answer);
    if (answer->depth >= radius) return;
    exact distance = oracle_outline_distance(p, center);
    add_vertex_axes(p, center, radius, distance, answer);
    answer->depth = radius - distance;
}

void oracle_circles(exact2 center, exact radius, exact obstacle_radius, oracle_answer *answer)
{
    exact distance = exact_length(center);
    answer->count = 0;
    answer->depth = radius + obstacle_radius - distance;
    if (distance > 0) add_axis(answer, scaled(center, 1 / distance), answer->depth);
}

void oracle_hull(const oracle_polygon *p, const oracle_polygon *hull, exact2 offset, oracle_answer *answer)
{
    answer->count = 0;
    for (int i = 0; i < p->count; i++) {
        exact2 n = p->normals[i];
        add_axis(answer, n, exact_dot(n, exact_sub(p->vertices[i], offset)) + support(hull, scaled(n, -1)));
    }
    for (int i = 0; i < hull->count; i++) {
        exact2 n = hull->normals[i];
        add_axis(answer, scaled(n, -1), exact_dot(n, exact_add(hull->vertices[i], offset)) + support(p, scaled(n, -1)));
    }
    least_of_axes(answer);
}

exact oracle_hull_distance(const oracle_polygon *p, const oracle_polygon *hull, exact2 offset)
{
    exact least = -1;
    for (int i = 0; i < hull->count; i++) {
        exact distance = oracle_outline_distance(p, exact_add(hull->vertices[i], offset));
        if (least < 0 || distance < least) least = distance;
    }
    for (int i = 0; i < p->count; i++) {
        exact distance = oracle_outline_distance(hull, exact_sub(p->vertices[i], offset));
        if (distance < least) least = distance;
    }
    return least;
}

exact oracle_angle(exact2 a, exact2 unit)
{
    exact length = exact_length(a);
    if (length == 0 || exact_dot(a, unit) <= 0) return 4;
    return exact_abs(exact_cross(a, unit)) / length;
}

exact oracle_normal_error(const oracle_answer *answer, exact slack, exact2 normal)
{
    exact least = answer->count == 0 ? 0 : 4;
    for (int i = 0; i < answer->count; i++) {
        if (answer->axes[i].depth > answer->depth + slack) continue;
        exact error = oracle_angle(normal, answer->axes[i].normal);
        if (error < least) least = error;
    }
    return least;
}

/* ---- segments ---- */

static int sign_of(exact value)
{
    return (value > 0) - (value < 0);
}

static int side_of(exact2 a, exact2 b, exact2 point)
{
    return sign_of(exact_cross(exact_sub(b, a), exact_sub(point, a)));
}

static bool point_in_polygon(const oracle_polygon *p, exact2 point)
{
    int way = sign_of(twice_area(p));
    for (int i = 0; i < p->count; i++) {
        if (side_of(p->vertices[i], vertex_after(p, i), point) * way < 0) return false;
    }
    return true;
}

/* A point known to be on the line a-b: is it on the segment? */
static bool between(exact2 a, exact2 b, exact2 point)
{
    return exact_dot(exact_sub(point, a), exact_sub(point, b)) <= 0;
}

static bool segments_touch(exact2 a, exact2 b, exact2 c, exact2 d)
{
    int side_c = side_of(a, b, c), side_d = side_of(a, b, d), side_a = side_of(c, d, a), side_b = side_of(c, d, b);
    if (side_c * side_d < 0 && side_a * side_b < 0) return true;
    return (side_c == 0 && between(a, b, c)) || (side_d == 0 && between(a, b, d)) ||
           (side_a == 0 && between(c, d, a)) || (side_b == 0 && between(c, d, b));
}

bool oracle_segment_polygon(const oracle_polygon *p, exact2 a, exact2 b)
{
    if (point_in_polygon(p, a)) return true;
    for (int i = 0; i < p->count; i++) {
        if (segments_touch(a, b, p->vertices[i], vertex_after(p, i))) return true;
    }
    return false;
}

/* value = high * 2^80 + low, both whole and of few enough bits that their products are exact. */
typedef struct wide { exact high, low; } wide;

static const exact two80 = (exact)((uint64_t)1 << 40) * (exact)((uint64_t)1 << 40);

/* Whole numbers below 2^68; in the halves of 40 bits no product has more than 80. */
static wide wide_product(exact a, exact b)
{
    const exact two40 = (exact)((uint64_t)1 << 40);
    exact a1 = (exact)(uint64_t)(a / two40), b1 = (exact)(uint64_t)(b / two40);
    exact a0 = a - a1 * two40, b0 = b - b1 * two40;
    exact middle = a1 * b0 + a0 * b1;
    exact carry = (exact)(uint64_t)(middle / two40);
    wide product = { a1 * b1 + carry, (middle - carry * two40) * two40 + a0 * b0 };
    if (product.low >= two80) {
        product.low -= two80;
        product.high += 1;
    }
    return product;
}

static bool wide_not_above(wide a, wide b)
{
    return a.high < b.high || (a.high == b.high && a.low <= b.low);
}

bool oracle_segment_circle(exact2 a, exact2 b, exact radius)
{
    exact2 way = exact_sub(b, a);
    exact along = -exact_dot(a, way), length = exact_dot(way, way), square = radius * radius;
    if (along <= 0) return exact_dot(a, a) <= square;
    if (along >= length) return exact_dot(b, b) <= square;
    exact cross = exact_abs(exact_cross(a, way));
    if (EXACT_WHOLE) return wide_not_above(wide_product(cross, cross), wide_product(square, length));
    return cross * cross <= square * length;
}

/* How far the hull of a and b must move along its own normal or an edge's to leave the polygon. */
static exact segment_depth(const oracle_polygon *p, exact2 a, exact2 b)
{
    exact least = 0;
    for (int i = 0; i < p->count; i++) {
        exact at_a = exact_dot(p->normals[i], exact_sub(p->vertices[i], a));
        exact at_b = exact_dot(p->normals[i], exact_sub(p->vertices[i], b));
        exact depth = at_a > at_b ? at_a : at_b;
        if (i == 0 || depth < least) least = depth;     /* a hair below 0 for an end exactly on the outline */
    }
    exact length = exact_length(exact_sub(b, a));
    if (length == 0) return least;
    exact2 across = scaled((exact2){ b.y - a.y, a.x - b.x }, 1 / length);
    exact up = support(p, across) - exact_dot(a, across), down = support(p, scaled(across, -1)) + exact_dot(a, across);
    least = up < least ? up : least;
    return down < least ? down : least;
}

exact oracle_segment_polygon_margin(const oracle_polygon *p, exact2 a, exact2 b)
{
    if (oracle_segment_polygon(p, a, b)) return segment_depth(p, a, b);
    exact at_a = oracle_outline_distance(p, a), at_b = oracle_outline_distance(p, b);
    exact least = at_a < at_b ? at_a : at_b;
    for (int i = 0; i < p->count; i++) {
        exact distance = distance_to_segment(p->vertices[i], a, b);
        if (distance < least) least = distance;
    }
    return least;
}

exact oracle_segment_circle_margin(exact2 a, exact2 b, exact radius)
{
    return exact_abs(distance_to_segment((exact2){ 0, 0 }, a, b) - radius);
}

/* ---- beams ---- */

/* Clip against the half-planes (Cyrus and Beck); the last one entered gives the normal. */
bool oracle_enter_polygon(const oracle_polygon *p, exact2 a, exact2 b, exact *fraction, exact2 *normal)
{
    exact enter = 0, leave = 1;
    exact2 way = exact_sub(b, a);
    int entered = -1;
    for (int i = 0; i < p->count; i++) {
        exact outside = exact_dot(p->normals[i], exact_sub(a, p->vertices[i])), speed = exact_dot(p->normals[i], way);
        if (speed == 0 && outside > 0) return false;
        if (speed < 0 && outside > 0 && outside >= -speed * enter) {
            enter = outside / -speed;
            entered = i;
        }
        if (speed > 0 && -outside < speed * leave) leave = -outside / speed;
    }
    if (entered < 0 || enter > leave || enter > 1) return false;
    *fraction = enter;
    *normal = p->normals[entered];
    return true;
}

bool oracle_enter_circle(exact2 a, exact2 b, exact radius, exact *fraction, exact2 *normal)
{
    exact2 way = exact_sub(b, a);
    exact length = exact_dot(way, way), along = exact_dot(a, way), gap = exact_dot(a, a) - radius * radius;
    exact inner = along * along - length * gap;
    if (gap <= 0 || along >= 0 || inner < 0) return false;
    *fraction = (-along - exact_sqrt(inner)) / length;
    *normal = scaled(exact_add(a, scaled(way, *fraction)), 1 / radius);
    return *fraction <= 1;
}
