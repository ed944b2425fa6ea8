/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Segments against polygons and circles, judged by the oracle: never wrong in the fixed build, for every end that it can represent; in the
   float build outside of 1e-3 units of touching, or length * 2^-22. Ends swapped: the same answer. */
#include "accuracy.h"
#include "families.h"

#define PLACES 10                   /* segments of a case */

typedef struct segment { double ax, ay, bx, by; } segment;       /* steps, relative to the piece */

typedef struct target {             /* a polygon, or a circle if radius > 0 */
    random_shape   shape;
    oracle_polygon polygon;
    tuff_real      radius;
    double         size;            /* steps */
} target;

typedef struct tally { unsigned long segments, hits, wrong, faults; double widest; } tally;

static const double turn = 6.283185307179586;

/* ---- where ---- */

static segment anywhere(random_source *source, const target *t)
{
    double most = t->size * random_magnitude(source, 1, 4);
    segment s = { random_within(source, -most, most), random_within(source, -most, most), 0, 0 };
    s.bx = random_within(source, -most, most);
    s.by = random_within(source, -most, most);
    return s;
}

/* Ends anywhere in the range of the numbers. */
static segment from_far(random_source *source, const target *t)
{
    double most = 2147483000.0;
    segment s = { random_within(source, -most, most), random_within(source, -most, most), 0, 0 };
    s.bx = random_chance(source, 50) ? -s.ax : random_within(source, -t->size, t->size);
    s.by = random_chance(source, 50) ? -s.ay : random_within(source, -t->size, t->size);
    return s;
}

static void feature_point(random_source *source, const target *t, double *x, double *y)
{
    int i = (int)random_below(source, (uint32_t)t->polygon.count), next = (i + 1) % t->polygon.count;
    double angle = random_within(source, 0, turn), share = random_chance(source, 50) ? 0 : 0.5;
    *x = (double)t->polygon.vertices[i].x * (1 - share) + (double)t->polygon.vertices[next].x * share;
    *y = (double)t->polygon.vertices[i].y * (1 - share) + (double)t->polygon.vertices[next].y * share;
    if (t->radius <= 0) return;
    *x = (double)exact_real(t->radius) * cos(angle);
    *y = (double)exact_real(t->radius) * sin(angle);
}

/* One end on the outline, or a few steps off. */
static segment end_on_outline(random_source *source, const target *t)
{
    segment s = anywhere(source, t);
    feature_point(source, t, &s.ax, &s.ay);
    s.ax += family_steps(source);
    s.ay += family_steps(source);
    return s;
}

/* Whole steps on both sides of a point of the outline, which is then in the middle, exactly for a vertex. */
static segment through_outline(random_source *source, const target *t)
{
    double x, y, most = t->size * random_magnitude(source, 0.1, 10);
    feature_point(source, t, &x, &y);
    double dx = floor(random_within(source, -most, most)), dy = floor(random_within(source, -most, most));
    if (t->radius > 0 && random_chance(source, 80)) {
        dx = -y * most / t->size;
        dy = x * most / t->size;
    }
    return (segment){ x + dx, y + dy, x - dx, y - dy };
}

/* Along the line of an edge, exactly on it or a few steps beside it. */
static segment along_edge(random_source *source, const target *t)
{
    int i = (int)random_below(source, (uint32_t)t->polygon.count), next = (i + 1) % t->polygon.count;
    double x = (double)t->polygon.vertices[i].x, y = (double)t->polygon.vertices[i].y, aside = family_steps(source);
    double dx = (double)t->polygon.vertices[next].x - x, dy = (double)t->polygon.vertices[next].y - y;
    double from = random_between(source, -3, 3), to = random_between(source, -3, 3);
    x += aside * (double)t->polygon.normals[i].x;
    y += aside * (double)t->polygon.normals[i].y;
    return (segment){ x + dx * from, y + dy * from, x + dx * to, y + dy * to };
}

/* A tangent of a circle, exact to the last bit wherever the radius is a multiple of the triple's hypotenuse, or one step beside it. */
static segment tangent(random_source *source, const target *t)
{
    static const int triples[][3] = { { 3, 4, 5 }, { 5, 12, 13 }, { 8, 15, 17 }, { 0, 1, 1 } };
    const int *triple = triples[random_below(source, 4)];
    double scale = floor((double)exact_real(t->radius) / triple[2]), x = triple[0] * scale, y = triple[1] * scale;
    double before = random_between(source, 0, 30000), after = random_between(source, 0, 30000), aside = random_between(source, -1, 1);
    return (segment){ x - triple[1] * before + aside, y + triple[0] * before, x + triple[1] * after + aside, y - triple[0] * after };
}

static segment some_segment(random_source *source, const target *t)
{
    segment s;
    switch (random_below(source, 6)) {
    case 0:  s = anywhere(source, t); break;
    case 1:  s = from_far(source, t); break;
    case 2:  s = end_on_outline(source, t); break;
    case 3:  s = along_edge(source, t); break;
    case 4:  s = t->radius > 0 ? tangent(source, t) : through_outline(source, t); break;
    default: s = through_outline(source, t); break;
    }
    if (random_chance(source, 5)) {
        s.bx = s.ax;
        s.by = s.ay;
    }
    return s;
}

/* ---- asking ---- */

static tuff_real clipped(double steps)
{
    double most = EXACT_WHOLE ? 2147483647.0 : 2147483647.0 - 128;
    return real_from_double(steps > most ? most : steps < -most ? -most : steps);
}

static bool ask_shape(const target *t, tuff_vec2 a, tuff_vec2 b)
{
    return t->radius > 0 ? tuff_segment_circle(a, b, t->radius) : tuff_segment_polygon(a, b, &t->shape.polygon);
}

static bool ask_world(const target *t, tuff_vec2 position, tuff_vec2 a, tuff_vec2 b)
{
    bool circle = t->radius > 0;
    tuff_real cover = circle ? t->radius : t->shape.bounding_radius;
    tuff_terrain piece = { position, t->radius, cover, circle ? NULL : &t->shape.polygon, circle ? 0 : 1 };
    tuff_world world = { &piece, 1, NULL, NULL, 0, TUFF_ORDER_ITERATION };
    return tuff_segment_terrain_intersect(&world, a, b);
}

/* Anywhere, to the very corners of the range, where relative ends need 33 bits. */
static tuff_vec2 piece_position(random_source *source)
{
    double most = random_chance(source, 50) ? 16000.0 * EXACT_UNIT : 2147483647.0;
    tuff_vec2 p = { clipped(random_within(source, -most, most)), clipped(random_within(source, -most, most)) };
    if (random_chance(source, 90)) return p;
    return (tuff_vec2){ clipped(p.x < 0 ? -1e10 : 1e10), clipped(p.y < 0 ? -1e10 : 1e10) };
}

static exact allowance(exact2 a, exact2 b)
{
    return EXACT_WHOLE ? -1 : accuracy_float_beam_band(exact_length(exact_sub(b, a)));
}

static const char *judge(tally *sum, const target *t, exact2 a, exact2 b, bool found)
{
    exact radius = exact_real(t->radius);
    bool hit = t->radius > 0 ? oracle_segment_circle(a, b, radius) : oracle_segment_polygon(&t->polygon, a, b);
    sum->segments++;
    sum->hits += hit;
    if (hit == found) return NULL;
    exact margin = t->radius > 0 ? oracle_segment_circle_margin(a, b, radius) : oracle_segment_polygon_margin(&t->polygon, a, b);
    raise_to(&sum->widest, margin);
    if (margin <= allowance(a, b)) return NULL;
    sum->wrong++;
    return hit ? "hit missed" : "hit reported of a segment that is apart";
}

static void report(tally *sum, const random_run *run, uint32_t index, const char *fault, exact2 a, exact2 b)
{
    if (!random_count_fault(&sum->faults, run, index, fault)) return;
    print_error("from (%.3f, %.3f) to (%.3f, %.3f) steps from the piece\n", (double)a.x, (double)a.y, (double)b.x, (double)b.y);
}

static void judge_segment(tally *sum, const random_run *run, uint32_t index, const target *t, segment s, const tuff_vec2 *position)
{
    tuff_vec2 at = position ? *position : (tuff_vec2){ 0, 0 };
    double x = (double)exact_real(at.x), y = (double)exact_real(at.y);
    tuff_vec2 a = { clipped(s.ax + x), clipped(s.ay + y) }, b = { clipped(s.bx + x), clipped(s.by + y) };
    exact2 exact_a = exact_sub(exact_vec2(a), exact_vec2(at)), exact_b = exact_sub(exact_vec2(b), exact_vec2(at));
    bool found = position ? ask_world(t, at, a, b) : ask_shape(t, a, b);
    bool swapped = position ? ask_world(t, at, b, a) : ask_shape(t, b, a);
    const char *fault = judge(sum, t, exact_a, exact_b, found);
    if (found != swapped) fault = "another answer with the ends swapped";
    report(sum, run, index, fault, exact_a, exact_b);
}

/* Half of them multiples of 5 * 13 * 17 steps, for exact tangents. */
static tuff_real some_radius(random_source *source)
{
    if (random_chance(source, 50)) return clipped(1105 * floor(random_magnitude(source, 1, 60000)));
    return clipped(EXACT_UNIT * random_magnitude(source, 1.0 / 64, 1024));
}

static void segment_case(tally *sum, const random_run *run, uint32_t index, bool circle)
{
    random_source source = random_stream(run->seed, index);
    target t;
    family_shape(&source, &t.shape, 1024);
    oracle_read_polygon(&t.polygon, &t.shape.polygon);
    t.radius = circle ? some_radius(&source) : 0;
    t.size = (double)exact_real(circle ? t.radius : t.shape.bounding_radius);
    for (int i = 0; i < PLACES; i++) {
        tuff_vec2 position = piece_position(&source);
        segment s = some_segment(&source, &t);
        judge_segment(sum, run, index, &t, s, random_chance(&source, 50) ? &position : NULL);
    }
}

static void segments(const char *name, const char *what, uint32_t cases, bool circle)
{
    random_run run = random_cases(name, 301, cases);
    tally sum = { 0 };
    for (uint32_t i = run.first; i < run.end; i++) segment_case(&sum, &run, i, circle);
    printf("figures: %s: tuff %s against the oracle: %lu segments, %lu hits, %lu wrong; farthest from touching where they differ: "
           "%.3g units\n", what, EXACT_BUILD, sum.segments, sum.hits, sum.wrong, sum.widest / EXACT_UNIT);
    assert_int_equal(sum.faults, 0);
}

static void segment_and_polygon(void **state)
{
    (void)state;
    segments(__func__, "segment and polygon", 20000, false);
}

static void segment_and_circle(void **state)
{
    (void)state;
    segments(__func__, "segment and circle", 15000, true);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(segment_and_polygon),
        cmocka_unit_test(segment_and_circle),
    };
    (void)argc;
    random_begin(argv);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
