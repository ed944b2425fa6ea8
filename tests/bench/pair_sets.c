/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The pairs: rocks of 12 to 32 units that many pairs share, met by circles, hulls and segments at random places. The exact oracle says
   how deep each pair overlaps, and so whose class it belongs to. Of the pairs that are judged only, every other one that is not
   far is brought close to touching, where wrong answers are. */
#include "oracle.h"
#include "sets.h"

#define SEED        20260402u
#define APPROACHES  4               /* each leaves about a fifth of the distance */

typedef struct exact_set { oracle_polygon shapes[BENCH_SHAPES], hulls[BENCH_HULLS]; } exact_set;

void bench_make_rock(random_source *source, bench_shape *shape, int count, double least, double most)
{
    double wide = random_within(source, least, most), high = wide * random_within(source, 0.6, 1.0);
    double turn = random_within(source, 0.0, 6.283185307179586);
    shape->count = count;
    for (int i = 0; i < count; i++) {
        double angle = (i + random_within(source, 0.0, 0.7)) / count * 6.283185307179586;
        double x = wide * cos(angle), y = high * sin(angle);
        shape->vertices[i].x = (int32_t)floor((x * cos(turn) - y * sin(turn)) * BENCH_ONE);
        shape->vertices[i].y = (int32_t)floor((x * sin(turn) + y * cos(turn)) * BENCH_ONE);
    }
}

static void read_shape(oracle_polygon *out, const bench_shape *shape)
{
    tuff_vec2 vertices[BENCH_MAX_VERTICES];
    tuff_polygon polygon = { vertices, NULL, 0, (uint8_t)shape->count };
    for (int i = 0; i < shape->count; i++) vertices[i] = (tuff_vec2){ shape->vertices[i].x, shape->vertices[i].y };
    oracle_read_polygon(out, &polygon);
}

static exact2 exact_point(bench_point point)
{
    return (exact2){ point.x, point.y };
}

static exact true_depth(bench_kind kind, const exact_set *truth, const bench_pair *pair)
{
    const oracle_polygon *polygon = &truth->shapes[pair->shape], *hull = &truth->hulls[pair->hull];
    exact2 a = exact_point(pair->a);
    oracle_answer answer;
    if (kind == BENCH_SEGMENT) {
        exact margin = oracle_segment_polygon_margin(polygon, a, exact_point(pair->b));
        return oracle_segment_polygon(polygon, a, exact_point(pair->b)) ? margin : -margin;
    }
    if (kind == BENCH_CIRCLE) {
        oracle_circle(polygon, a, pair->radius, &answer);
        return answer.depth;
    }
    oracle_hull(polygon, hull, a, &answer);
    return answer.depth > 0 ? answer.depth : -oracle_hull_distance(polygon, hull, a);
}

static bench_point point_around(bench_point center, double distance, double angle)
{
    return (bench_point){ center.x + (int32_t)floor(distance * cos(angle) * BENCH_ONE),
                          center.y + (int32_t)floor(distance * sin(angle) * BENCH_ONE) };
}

/* Somewhere, in the direction that is returned; the distance is chosen so that about half of the places are of the wanted class. */
static double place(random_source *source, bench_kind kind, bench_class class, bench_pair *pair)
{
    static const double reach[] = { 36.0, 46.0, 104.0 };
    const bench_point origin = { 0, 0 };
    double angle = random_within(source, 0.0, 6.283185307179586);
    pair->radius = (int32_t)(random_within(source, 2.0, 10.0) * BENCH_ONE);
    pair->a = point_around(origin, random_within(source, class == BENCH_FAR ? 24.0 : 0.0, reach[class]), angle);
    pair->b = pair->a;
    if (kind == BENCH_SEGMENT) {
        double half = random_within(source, 4.0, 32.0), direction = random_within(source, 0.0, 6.283185307179586);
        bench_point middle = pair->a;
        pair->a = point_around(middle, half, direction);
        pair->b = point_around(middle, -half, direction);
    }
    return angle;
}

static double depth_in_units(bench_kind kind, const exact_set *truth, const bench_pair *pair)
{
    return (double)true_depth(kind, truth, pair) / BENCH_ONE;
}

/* Move in or out along the direction, to about this depth. */
static void approach(bench_kind kind, const exact_set *truth, double angle, double depth, bench_pair *pair)
{
    for (int i = 0; i < APPROACHES; i++) {
        double distance = depth_in_units(kind, truth, pair) - depth;
        pair->a = point_around(pair->a, distance, angle);
        pair->b = point_around(pair->b, distance, angle);
    }
}

static bench_class class_of(double depth)
{
    if (depth > 0.0) return BENCH_OVERLAP;
    if (depth > -8.0) return BENCH_NEAR;
    return depth > -64.0 ? BENCH_FAR : BENCH_CLASSES;
}

static void make_pair(bench_set *set, const exact_set *truth, uint32_t number)
{
    bench_pair *pair = &set->pairs[number];
    random_source source = random_stream(SEED + (uint64_t)set->kind, number);
    bench_class class = (bench_class)(number % BENCH_CLASSES);
    bool close = number >= BENCH_TIMED_PAIRS && number % 2 && class != BENCH_FAR;
    pair->shape = (uint8_t)random_below(&source, BENCH_SHAPES);
    pair->hull = (uint8_t)random_below(&source, BENCH_HULLS);
    do {
        double angle = place(&source, set->kind, class, pair);
        double depth = random_magnitude(&source, 1e-4, 1e-2);
        if (close) approach(set->kind, truth, angle, class == BENCH_OVERLAP ? depth : -depth, pair);
        pair->depth = depth_in_units(set->kind, truth, pair);
    } while (class_of(pair->depth) != class);
}

void bench_make_set(bench_set *set, bench_kind kind, int least, int most, uint32_t count)
{
    static exact_set truth;
    random_source source = random_stream(SEED, (uint64_t)(least * 100 + most));
    set->kind = kind;
    set->least = least;
    set->most = most;
    set->count = count;
    for (int i = 0; i < BENCH_SHAPES; i++) {
        bench_make_rock(&source, &set->shapes[i], least + i % (most - least + 1), 12.0, 32.0);
        read_shape(&truth.shapes[i], &set->shapes[i]);
    }
    for (int i = 0; i < BENCH_HULLS; i++) {
        bench_make_rock(&source, &set->hulls[i], 5, 6.0, 10.0);
        read_shape(&truth.hulls[i], &set->hulls[i]);
    }
    for (uint32_t i = 0; i < count; i++) make_pair(set, &truth, i);
}
