/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Random numbers, random convex shapes, and the frame of a random test: each case has a stream of its own, made from seed and index,
   so that a failing case can be repeated alone by the command that the failure prints. */
#ifndef TUFF_TESTS_RANDOM_H
#define TUFF_TESTS_RANDOM_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "exact.h"

/* ---- numbers ---- */

typedef struct random_source { uint64_t state; } random_source;

/* splitmix64, by its published constants. */
static inline uint64_t random_word(random_source *source)
{
    uint64_t z = source->state += UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return z ^ (z >> 31);
}

/* The stream of one case. */
static inline random_source random_stream(uint64_t seed, uint64_t index)
{
    random_source source = { seed };
    source.state = random_word(&source) ^ index;
    source.state = random_word(&source);
    return source;
}

static inline uint32_t random_bits(random_source *source)
{
    return (uint32_t)(random_word(source) >> 32);
}

/* 0 .. count - 1. */
static inline uint32_t random_below(random_source *source, uint32_t count)
{
    return (uint32_t)(((uint64_t)random_bits(source) * count) >> 32);
}

/* low .. high, both included. */
static inline int32_t random_between(random_source *source, int32_t low, int32_t high)
{
    uint64_t span = (uint64_t)((int64_t)high - low) + 1;
    return (int32_t)((int64_t)low + (int64_t)(((uint64_t)random_bits(source) * span) >> 32));
}

/* 0 <= result < 1. */
static inline double random_fraction(random_source *source)
{
    return (double)(random_word(source) >> 11) / 9007199254740992.0;
}

static inline double random_within(random_source *source, double low, double high)
{
    return low + (high - low) * random_fraction(source);
}

static inline bool random_chance(random_source *source, uint32_t percent)
{
    return random_below(source, 100) < percent;
}

/* Spread evenly over the magnitudes: as many between 1 and 2 as between 512 and 1024. */
static inline double random_magnitude(random_source *source, double low, double high)
{
    return low * pow(high / low, random_fraction(source));
}

/* ---- coordinates ---- */

/* The point nearest to (x, y), given in units, that the build can hold. */
static inline tuff_vec2 random_point_at(double x, double y)
{
    return vec2_from_doubles(x * EXACT_UNIT, y * EXACT_UNIT);
}

/* Anywhere in the square of this many units about the origin. */
static inline tuff_vec2 random_point(random_source *source, double extent)
{
    double x = random_within(source, -extent, extent);
    return random_point_at(x, random_within(source, -extent, extent));
}

/* ---- convex shapes ---- */

typedef struct random_shape {       /* not to be copied: the polygon points into it */
    tuff_vec2    vertices[TUFF_MAX_VERTICES];
    tuff_unit2   normals[TUFF_MAX_VERTICES];
    tuff_polygon polygon;
    tuff_real    bounding_radius;
} random_shape;

static inline int random_compare_points(const void *left, const void *right)
{
    const tuff_vec2 *a = (const tuff_vec2 *)left, *b = (const tuff_vec2 *)right;
    if (a->x != b->x) return a->x < b->x ? -1 : 1;
    return (a->y > b->y) - (a->y < b->y);
}

/* One half of the hull of the sorted points: from end to end, turning strictly one way. The number of points kept. */
static inline int random_half_hull(const tuff_vec2 *points, int count, int step, tuff_vec2 *hull)
{
    int kept = 0;
    for (int i = step > 0 ? 0 : count - 1; i >= 0 && i < count; i += step) {
        while (kept >= 2 && exact_turn(hull[kept - 2], hull[kept - 1], points[i]) <= 0) kept--;
        hull[kept++] = points[i];
    }
    return kept;
}

/* The exact convex hull of up to TUFF_MAX_VERTICES points, which are sorted on the way: no two collinear edges, counterclockwise where
   y grows upwards. Fewer than 3: the points have no area. */
static inline int random_hull_of(tuff_vec2 *points, int count, tuff_vec2 *hull)
{
    tuff_vec2 half[TUFF_MAX_VERTICES];
    qsort(points, (size_t)count, sizeof *points, random_compare_points);
    int total = random_half_hull(points, count, 1, hull) - 1;
    int back = random_half_hull(points, count, -1, half) - 1;
    for (int i = 0; i < back; i++) hull[total++] = half[i];
    return total;
}

/* A radius about the origin that covers all vertices: the least one, and a millionth more. */
static inline tuff_real random_cover(const tuff_vec2 *vertices, int count)
{
    exact most = 0;
    for (int i = 0; i < count; i++) {
        exact length = exact_length(exact_vec2(vertices[i]));
        if (length > most) most = length;
    }
    return real_from_double((double)most * 1.000001 + 1.0);
}

/* Finish a shape whose vertices are in place: normals, bounding radius, polygon. */
static inline void random_bake(random_shape *shape, int count)
{
    tuff_edge_normals(shape->vertices, (uint8_t)count, shape->normals);
    shape->polygon = (tuff_polygon){ shape->vertices, shape->normals, 0, (uint8_t)count };
    shape->bounding_radius = random_cover(shape->vertices, count);
}

/* A box about the origin, corner the one with the largest x and y. */
static inline void random_box_shape(random_shape *shape, tuff_vec2 corner)
{
    shape->vertices[0] = (tuff_vec2){ -corner.x, -corner.y };
    shape->vertices[1] = (tuff_vec2){ corner.x, -corner.y };
    shape->vertices[2] = corner;
    shape->vertices[3] = (tuff_vec2){ -corner.x, corner.y };
    random_bake(shape, 4);
}

/* Turn the list of vertices to begin anywhere, and half of the time to run the other way round. */
static inline void random_renumber(random_source *source, tuff_vec2 *vertices, int count)
{
    tuff_vec2 old[TUFF_MAX_VERTICES];
    int first = (int)random_below(source, (uint32_t)count);
    int step = random_chance(source, 50) ? 1 : count - 1;
    for (int i = 0; i < count; i++) old[i] = vertices[i];
    for (int i = 0; i < count; i++) vertices[i] = old[(first + i * step) % count];
}

/* A convex polygon with at most this many vertices (3 .. TUFF_MAX_VERTICES) from random points of an ellipse about center with the half
   axes wide and high, turned by angle; all in units. Either winding. A shape too small for the grid becomes a triangle of 1/1024 unit. */
static inline void random_ellipse_shape(random_source *source, random_shape *shape, int count, double wide, double high, double angle,
                                        double center_x, double center_y)
{
    tuff_vec2 points[TUFF_MAX_VERTICES], hull[TUFF_MAX_VERTICES + 2];
    int kept = 0;
    for (int attempt = 0; attempt < 8 && kept < 3; attempt++) {
        for (int i = 0; i < count; i++) {
            double at = random_within(source, 0.0, 6.283185307179586);
            double x = wide * cos(at), y = high * sin(at);
            points[i] = random_point_at(center_x + x * cos(angle) - y * sin(angle), center_y + x * sin(angle) + y * cos(angle));
        }
        kept = random_hull_of(points, count, hull);
    }
    if (kept < 3) {
        hull[0] = random_point_at(center_x, center_y);
        hull[1] = (tuff_vec2){ hull[0].x + TUFF_REAL_RAW(64), hull[0].y };
        hull[2] = (tuff_vec2){ hull[0].x, hull[0].y + TUFF_REAL_RAW(64) };
        kept = 3;
    }
    for (int i = 0; i < kept; i++) shape->vertices[i] = hull[i];
    random_renumber(source, shape->vertices, kept);
    random_bake(shape, kept);
}

/* A rock: within size units of the origin in every direction, 3 .. most vertices. */
static inline void random_rock_shape(random_source *source, random_shape *shape, int most, double size)
{
    double flat = random_within(source, 0.4, 1.0);
    int count = random_between(source, 3, most);
    random_ellipse_shape(source, shape, count, size, size * flat, random_within(source, 0.0, 3.14159265), 0.0, 0.0);
}

/* ---- the frame of a random test ---- */

static const char *random_program = "";

/* First thing in main: remembers the program's name, and lets TUFF_TEST_NAME pick one test. */
static inline void random_begin(char **argv)
{
    const char *name = getenv("TUFF_TEST_NAME");
    random_program = argv[0];
    if (name) cmocka_set_test_filter(name);
}

typedef struct random_run {
    const char *name;               /* of the test function */
    uint64_t seed;
    uint32_t first, end;            /* the cases to run: first .. end - 1 */
} random_run;

static inline uint64_t random_environment(const char *name, uint64_t fallback)
{
    const char *text = getenv(name);
    return text && *text ? (uint64_t)strtoull(text, NULL, 10) : fallback;
}

/* count cases, times TUFF_TEST_SCALE percent; TUFF_TEST_SEED and TUFF_TEST_CASE repeat one. */
static inline random_run random_cases(const char *name, uint64_t seed, uint32_t count)
{
    random_run run = { name, random_environment("TUFF_TEST_SEED", seed), 0, 0 };
    uint64_t scaled = (uint64_t)count * random_environment("TUFF_TEST_SCALE", 100) / 100;
    uint64_t only = random_environment("TUFF_TEST_CASE", UINT64_MAX);
    run.end = (uint32_t)(scaled > 0 ? scaled : 1);
    if (only < UINT32_MAX) {
        run.first = (uint32_t)only;
        run.end = run.first + 1;
    }
    return run;
}

/* The command that repeats one case. Print it before failing. */
static inline void random_print_case(const random_run *run, uint32_t index)
{
    print_error("repeat: TUFF_TEST_NAME=%s TUFF_TEST_SEED=%llu TUFF_TEST_CASE=%lu %s\n", run->name, (unsigned long long)run->seed,
                (unsigned long)index, random_program);
}

/* Ends the test; the arguments after index are those of fail_msg. A macro, so that the failure is reported at the caller's line. */
#define random_fail(run, index, ...)       \
    do {                                   \
        random_print_case((run), (index)); \
        fail_msg(__VA_ARGS__);             \
    } while (0)

/* For tests that go on after a fault (NULL: there is none) and end with assert_int_equal(faults, 0): counts it, and prints the first three.
   True: it was printed, and details may follow. */
static inline bool random_count_fault(unsigned long *faults, const random_run *run, uint32_t index, const char *fault)
{
    if (!fault || ++*faults > 3) return false;
    print_error("%s\n", fault);
    random_print_case(run, index);
    return true;
}

#endif
