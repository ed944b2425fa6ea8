/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Family 7, beams: long series of the cases that segment tests get wrong, in both calls and from both ends, against exact
   arithmetic; beside them a test by strict crossings, a march along the chunks, and Box2D's ray cast. The random versions are
   tests/host/test_beams.c and test_oracle_segment.c. */
#include "accuracy.h"
#include "handed.h"
#include "picture.h"
#include "pieces.h"
#include "table.h"

#define RING     32                 /* pieces of the ring */
#define MOST     64                 /* pieces of a scene */
#define FAN      64                 /* directions of a fan */
#define PITCH    4                  /* binary logarithm of the chunks' */
#define CHUNK    (1 << PITCH)
#define FIELD    3                  /* the chunk scene has chunks from -FIELD to FIELD - 1 */

/* ---- scenes ---- */

typedef struct solid {              /* one convex part, at its place */
    random_shape   shape;
    oracle_polygon exact;
    box2d_polygon *box;
    tuff_vec2      at;
} solid;

typedef struct scene {              /* not to be copied */
    solid            solids[MOST];
    int              count;
    tuff_polygon     parts[MOST];   /* of one piece, if it is one */
    tuff_terrain     pieces[MOST];
    uint16_t         buckets[64];
    tuff_chunk_entry entries[MOST];
    tuff_chunks      chunks;
    tuff_world       world;
} scene;

static void add_solid(scene *s, tuff_vec2 at, const tuff_vec2 *vertices, int count)
{
    solid *added = &s->solids[s->count++];
    for (int i = 0; i < count; i++) added->shape.vertices[i] = vertices[i];
    random_bake(&added->shape, count);
    oracle_read_polygon(&added->exact, &added->shape.polygon);
    added->box = box2d_of(&added->shape.polygon);
    added->at = at;
    assert_non_null(added->box);
}

/* Every solid is a piece of its own. */
static void finish_pieces(scene *s, bool with_index)
{
    s->chunks = (tuff_chunks){ s->buckets, s->entries, 64, MOST, PITCH, 0, 0, false };
    s->world = (tuff_world){ s->pieces, (uint16_t)s->count, with_index ? &s->chunks : NULL, NULL, 0, TUFF_ORDER_ITERATION };
    for (int i = 0; i < s->count; i++) s->pieces[i] = convex_piece(&s->solids[i].shape, s->solids[i].at);
    assert_int_equal(tuff_world_index(&s->world), 0);
}

/* All solids, which have one place, are parts of one piece; these bits are their internal edges. */
static void finish_parts(scene *s, uint32_t internal_edges)
{
    tuff_real cover = 0;
    for (int i = 0; i < s->count; i++) {
        s->parts[i] = s->solids[i].shape.polygon;
        s->parts[i].internal_edges = internal_edges;
        if (s->solids[i].shape.bounding_radius > cover) cover = s->solids[i].shape.bounding_radius;
    }
    s->pieces[0] = (tuff_terrain){ s->solids[0].at, 0, cover, s->parts, (uint8_t)s->count };
    s->world = plain_world(s->pieces, 1, TUFF_ORDER_ITERATION);
}

static void free_scene(scene *s)
{
    for (int i = 0; i < s->count; i++) box2d_polygon_free(s->solids[i].box);
    s->count = 0;
}

/* Point i of the ring's inner outline, in whole units; the outer one is twice as far out, so that seams point at the middle
   exactly. */
static tuff_vec2 ring_point(int i, int times)
{
    double angle = TURN * (i % RING) / RING;
    int x = (int)floor(32 * cos(angle) + 0.5), y = (int)floor(32 * sin(angle) + 0.5);
    return (tuff_vec2){ tuff_from_int(times * x), tuff_from_int(times * y) };
}

#define RING_SEAMS 5u               /* edges 0 and 2 of each brick */

static void build_ring(scene *s, tuff_vec2 at)
{
    s->count = 0;
    for (int i = 0; i < RING; i++) {
        tuff_vec2 brick[4] = { ring_point(i, 1), ring_point(i, 2), ring_point(i + 1, 2), ring_point(i + 1, 1) };
        add_solid(s, at, brick, 4);
    }
}

static tuff_vec2 plus(tuff_vec2 a, tuff_vec2 b)
{
    return (tuff_vec2){ a.x + b.x, a.y + b.y };
}

static tuff_vec2 minus(tuff_vec2 a, tuff_vec2 b)
{
    return (tuff_vec2){ a.x - b.x, a.y - b.y };
}

/* ---- methods that fail ---- */

/* A difference as 32 bits have it; a float's own in the float build. */
static exact narrow_difference(tuff_real a, tuff_real b)
{
    if (!EXACT_WHOLE) return exact_real(a - b);
    return (exact)(int32_t)((uint32_t)tuff_to_q16_16(a) - (uint32_t)tuff_to_q16_16(b));
}

static exact narrow_cross(tuff_vec2 from, tuff_vec2 to, tuff_vec2 p)
{
    exact dx = narrow_difference(to.x, from.x), dy = narrow_difference(to.y, from.y);
    return dx * narrow_difference(p.y, from.y) - dy * narrow_difference(p.x, from.x);
}

/* The crossing test of many games: the ends of each segment strictly on different sides of the other. Here even with exact
   products. */
static bool strictly_crosses(tuff_vec2 a, tuff_vec2 b, tuff_vec2 c, tuff_vec2 d)
{
    exact at_c = narrow_cross(a, b, c), at_d = narrow_cross(a, b, d), at_a = narrow_cross(c, d, a), at_b = narrow_cross(c, d, b);
    return ((at_c < 0 && at_d > 0) || (at_c > 0 && at_d < 0)) && ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0));
}

/* Strict crossings alone, without a look at where the segment begins. */
static bool crossings_say(const scene *s, tuff_vec2 a, tuff_vec2 b)
{
    for (int k = 0; k < s->count; k++) {
        const solid *rock = &s->solids[k];
        for (int i = 0; i < rock->shape.polygon.count; i++) {
            tuff_vec2 from = rock->shape.vertices[i], to = rock->shape.vertices[(i + 1) % rock->shape.polygon.count];
            if (strictly_crosses(a, b, plus(rock->at, from), plus(rock->at, to))) return true;
        }
    }
    return false;
}

static bool solid_is_hit(const solid *rock, tuff_vec2 a, tuff_vec2 b)
{
    exact2 at = exact_vec2(rock->at);
    return oracle_segment_polygon(&rock->exact, exact_sub(exact_vec2(a), at), exact_sub(exact_vec2(b), at));
}

static bool chunk_is_hit(const scene *s, int x, int y, tuff_vec2 a, tuff_vec2 b)
{
    for (int i = 0; i < s->count; i++) {
        bool here = (int)floor(units_of(s->solids[i].at.x) / CHUNK) == x && (int)floor(units_of(s->solids[i].at.y) / CHUNK) == y;
        if (here && solid_is_hit(&s->solids[i], a, b)) return true;
    }
    return false;
}

/* How far along the beam, in parts of it, the next border lies, and from there each next one. */
static void borders(double from, double way, double *next, double *between)
{
    double ahead = way > 0 ? floor(from) + 1 - from : from - floor(from);
    *between = way == 0 ? 2.0 : 1.0 / fabs(way);
    *next = way == 0 ? 2.0 : ahead * *between;
}

/* A march along the chunks from border to border, as the grids of many games do it: only the chunks that the line is in, each
   with its own pieces. */
static bool march_says(const scene *s, tuff_vec2 a, tuff_vec2 b)
{
    double ax = units_of(a.x) / CHUNK, ay = units_of(a.y) / CHUNK, dx = units_of(b.x) / CHUNK - ax, dy = units_of(b.y) / CHUNK - ay;
    double next_x, next_y, between_x, between_y;
    int x = (int)floor(ax), y = (int)floor(ay);
    borders(ax, dx, &next_x, &between_x);
    borders(ay, dy, &next_y, &between_y);
    for (;;) {
        if (chunk_is_hit(s, x, y, a, b)) return true;
        double now = fmin(next_x, next_y);
        if (now > 1) return false;
        if (next_x == now) {
            x += dx > 0 ? 1 : -1;
            next_x += between_x;
        }
        if (next_y == now) {
            y += dy > 0 ? 1 : -1;
            next_y += between_y;
        }
    }
}

static bool box2d_says(const scene *s, tuff_vec2 a, tuff_vec2 b)
{
    box2d_hit hit;
    for (int i = 0; i < s->count; i++) {
        if (box2d_ray_polygon(s->solids[i].box, twin_vec(s->solids[i].at), twin_vec(a), twin_vec(b), &hit)) return true;
    }
    return false;
}

/* ---- the truth ---- */

typedef struct truth {
    bool  touched;
    bool  must, must_not;           /* float build: neither is set within the band of touching */
    bool  inside;                   /* the beam begins on a solid or in it */
    exact fraction, length;         /* of the first entry; fraction 2: none */
} truth;

/* Where a segment from outside that touches the polygon enters it (Cyrus and Beck), by the edges themselves: a segment along
   one is exactly parallel to it. */
static exact entry_of(const oracle_polygon *p, exact2 a, exact2 b)
{
    exact entry = 0;
    for (int i = 0; i < p->count; i++) {
        exact2 edge = exact_sub(p->vertices[(i + 1) % p->count], p->vertices[i]), out = { edge.y, -edge.x };
        if (exact_dot(out, p->normals[i]) < 0) out = (exact2){ -out.x, -out.y };
        exact outside = exact_dot(out, exact_sub(a, p->vertices[i])), way = exact_dot(out, exact_sub(a, b));
        if (outside > 0 && way > 0 && outside > entry * way) entry = outside / way;
    }
    return entry;
}

static void look_at_solid(truth *is, const solid *rock, tuff_vec2 from, tuff_vec2 to, exact band)
{
    exact2 at = exact_vec2(rock->at), a = exact_sub(exact_vec2(from), at), b = exact_sub(exact_vec2(to), at);
    bool touched = oracle_segment_polygon(&rock->exact, a, b);
    bool clear = EXACT_WHOLE || oracle_segment_polygon_margin(&rock->exact, a, b) > band;
    if (touched && clear) is->must = true;
    if (touched || !clear) is->must_not = false;
    if (!touched) return;
    is->touched = true;
    if (oracle_segment_polygon(&rock->exact, a, a)) is->inside = true;
    else if (entry_of(&rock->exact, a, b) < is->fraction) is->fraction = entry_of(&rock->exact, a, b);
}

static truth truth_of(const scene *s, tuff_vec2 a, tuff_vec2 b)
{
    truth is = { false, false, true, false, 2, exact_length(exact_sub(exact_vec2(b), exact_vec2(a))) };
    for (int i = 0; i < s->count; i++) look_at_solid(&is, &s->solids[i], a, b, accuracy_float_beam_band(is.length));
    if (is.inside) is.fraction = 0;
    return is;
}

/* ---- judging ---- */

typedef struct series {
    const char   *name;
    bool          deep;             /* every beam of it must be stopped in the float build too: it runs through the middle of one piece */
    bool          by_march;         /* the method that fails is the march, else the crossings */
    unsigned long beams, touching, missed, box2d_missed, tuff_missed;    /* tuff's: only where the float build may answer either way */
} series;

/* Fixed build: where the header says that the point of the hit is. */
static const char *hit_fault(const truth *is, const tuff_beam_hit *hit)
{
    exact tolerance = 2 + is->length / 268435456;
    if (exact_unit(hit->fraction) < 0 || exact_unit(hit->fraction) > 1) return "a fraction beyond 0 .. 1";
    if (hit->normal.x == 0 && hit->normal.y == 0) return "no normal";
    if (!EXACT_WHOLE) return NULL;
    if (is->inside) return hit->fraction == 0 ? NULL : "a start on a piece or in it is not the hit";
    return exact_abs(exact_unit(hit->fraction) - is->fraction) * is->length <= tolerance ? NULL : "the point of the hit";
}

static const char *beam_fault(const series *now, const scene *s, const truth *is, tuff_vec2 a, tuff_vec2 b)
{
    tuff_beam_hit hit = { 0, { 0, 0 }, 77 }, back;
    bool must = is->must || now->deep, stopped = tuff_segment_terrain_intersect(&s->world, a, b);
    if (must && !stopped) return "leaked";
    if (is->must_not && !now->deep && stopped) return "stopped by nothing";
    if (tuff_segment_terrain_intersect(&s->world, b, a) != stopped) return "another answer with the ends swapped";
    if (tuff_segment_terrain_first_hit(&s->world, a, b, &hit) != stopped) return "the two calls disagree";
    if (tuff_segment_terrain_first_hit(&s->world, b, a, &back) != stopped) return "the two calls disagree with the ends swapped";
    return stopped ? hit_fault(is, &hit) : NULL;
}

static void judge(series *now, const scene *s, tuff_vec2 a, tuff_vec2 b)
{
    truth is = truth_of(s, a, b);
    const char *fault = beam_fault(now, s, &is, a, b);
    now->beams++;
    now->touching += is.touched;
    now->missed += is.touched && !(now->by_march ? march_says(s, a, b) : crossings_say(s, a, b));
    now->box2d_missed += is.touched && !box2d_says(s, a, b);
    now->tuff_missed += is.touched && !tuff_segment_terrain_intersect(&s->world, a, b);
    if (!fault) return;
    fail_msg("%s: from (%.17g, %.17g) to (%.17g, %.17g): %s", now->name, units_of(a.x), units_of(a.y), units_of(b.x), units_of(b.y), fault);
}

static void print_series(const series *now)
{
    printf("figures: " EXACT_BUILD " %s: %lu beams, %lu touch; missed by %s %lu, by Box2D's ray %lu, by tuff %lu\n", now->name, now->beams,
           now->touching, now->by_march ? "the march" : "strict crossings", now->missed, now->box2d_missed, now->tuff_missed);
}

static void print_row(const series *now, const char *measure)
{
    table_row(measure);
    table_fails(now->by_march ? "march along chunks" : "strict crossings", "%lu of %lu", now->missed, now->touching);
    table_box2d("%lu", now->box2d_missed);
    table_tuff("%lu", now->tuff_missed);
}

/* ---- shared edges and vertices ---- */

/* Outward and inward along every seam, from the middle or from the inner corner, to the outer corner or beyond. */
static void beams_along_seams(series *now, const scene *s)
{
    for (int i = 0; i < RING; i++) {
        tuff_vec2 middle = s->solids[0].at, inner = plus(middle, ring_point(i, 1)), outer = plus(middle, ring_point(i, 2));
        tuff_vec2 far = plus(middle, ring_point(i, 4));
        judge(now, s, middle, far);
        judge(now, s, far, middle);
        judge(now, s, inner, far);
        judge(now, s, outer, middle);
        judge(now, s, middle, outer);
    }
}

static void test_no_beam_leaks_along_the_seams_of_separate_pieces(void **state)
{
    static scene s;
    series now = { .name = "along the seams of a ring of pieces" };
    (void)state;
    build_ring(&s, (tuff_vec2){ TUFF_WHOLE(300), TUFF_WHOLE(-7) });
    finish_pieces(&s, false);
    beams_along_seams(&now, &s);
    print_series(&now);
    assert_int_equal(now.missed, now.touching);
    free_scene(&s);
}

static void test_no_beam_leaks_along_the_seams_of_one_piece(void **state)
{
    static scene s;
    series now = { .name = "along the seams of a ring of parts", .deep = true };
    (void)state;
    build_ring(&s, (tuff_vec2){ TUFF_WHOLE(300), TUFF_WHOLE(-7) });
    finish_parts(&s, RING_SEAMS);
    beams_along_seams(&now, &s);
    print_series(&now);
    print_row(&now, "beams along the seams of a ring that leak");
    assert_int_equal(now.missed, now.touching);
    free_scene(&s);
}

/* Whole numbers of 1/64 unit, all round. */
static tuff_vec2 fan_direction(int i)
{
    double angle = TURN * i / FAN;
    return random_point_at(floor(cos(angle) * 100 * 64) / 64, floor(sin(angle) * 100 * 64) / 64);
}

/* Exactly through every corner of the ring, which two bricks share. */
static void test_no_beam_leaks_through_a_shared_vertex(void **state)
{
    static scene s;
    series now = { .name = "through shared vertices" };
    (void)state;
    build_ring(&s, (tuff_vec2){ TUFF_WHOLE(-40), TUFF_WHOLE(90) });
    finish_pieces(&s, true);
    for (int i = 0; i < 2 * RING; i++) {
        tuff_vec2 vertex = plus(s.solids[0].at, ring_point(i / 2, 1 + i % 2));
        for (int k = 0; k < FAN; k++) judge(&now, &s, plus(vertex, fan_direction(k)), minus(vertex, fan_direction(k)));
    }
    print_series(&now);
    assert_int_equal(now.touching, 2 * RING * FAN);
    assert_true(now.missed > 0);
    free_scene(&s);
}

/* The ring scaled and turned, as one piece, at any place, which it returns. outer: the far ends of its seams. */
static tuff_vec2 build_odd_ring(random_source *source, scene *s, tuff_vec2 *outer)
{
    double scale = random_within(source, 0.3, 10), turned = random_within(source, 0, 6.2831853);
    tuff_vec2 at = random_point(source, 2000), inner[RING + 1];
    for (int k = 0; k <= RING; k++) {
        double angle = turned + TURN * (k % RING) / RING, x = scale * 32 * cos(angle), y = scale * 32 * sin(angle);
        inner[k] = random_point_at(x, y);
        outer[k] = random_point_at(1.7 * x, 1.7 * y);
    }
    s->count = 0;
    for (int k = 0; k < RING; k++) add_solid(s, at, (tuff_vec2[4]){ inner[k], outer[k], outer[k + 1], inner[k + 1] }, 4);
    finish_parts(s, RING_SEAMS);
    return at;
}

/* So many times as far out as the corner. */
static tuff_vec2 far_out(tuff_vec2 at, tuff_vec2 corner, double times)
{
    return random_point_at(units_of(at.x) + units_of(corner.x) * times, units_of(at.y) + units_of(corner.y) * times);
}

/* The same with numbers that no line meets exactly. */
static void test_no_beam_slips_into_a_seam_of_odd_numbers(void **state)
{
    static scene s;
    random_run run = random_cases(__func__, 7001, 300);
    series now = { .name = "along seams of odd numbers", .deep = true };
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        tuff_vec2 outer[RING + 1], at = build_odd_ring(&source, &s, outer);
        for (int k = 0; k < RING; k++) {
            double from = random_within(&source, 0, 0.5), to = random_magnitude(&source, 1.5, 20);
            judge(&now, &s, far_out(at, outer[k], from), far_out(at, outer[k], to));
        }
        free_scene(&s);
    }
    print_series(&now);
}

/* ---- one piece: edges, corners, starts ---- */

/* A seven-gon with all vertices on whole multiples of 4 units. */
static void build_rock(scene *s, tuff_vec2 at)
{
    static const int8_t corners[7][2] = { { -40, -8 }, { -20, -32 }, { 12, -36 }, { 36, -12 }, { 36, 16 }, { 8, 40 }, { -28, 24 } };
    tuff_vec2 vertices[7];
    for (int i = 0; i < 7; i++) vertices[i] = (tuff_vec2){ tuff_from_int(corners[i][0]), tuff_from_int(corners[i][1]) };
    s->count = 0;
    add_solid(s, at, vertices, 7);
    finish_pieces(s, false);
}

/* Quarters of the edge from its first vertex. */
static tuff_vec2 on_edge(const scene *s, int edge, int quarters)
{
    const random_shape *shape = &s->solids[0].shape;
    tuff_vec2 from = shape->vertices[edge], way = minus(shape->vertices[(edge + 1) % shape->polygon.count], from);
    const tuff_real times = (tuff_real)quarters;
    return plus(s->solids[0].at, (tuff_vec2){ from.x + way.x / 4 * times, from.y + way.y / 4 * times });
}

/* Along the line of each edge from each quarter to each other, two lengths beyond both ends; equal ends are points. */
static void test_beams_along_an_edge_are_stopped_if_they_meet_it(void **state)
{
    static scene s;
    series now = { .name = "along an edge" };
    (void)state;
    build_rock(&s, (tuff_vec2){ TUFF_WHOLE(-700), TUFF_WHOLE(1200) });
    for (int edge = 0; edge < 7; edge++) {
        for (int i = 0; i < 21 * 21; i++) judge(&now, &s, on_edge(&s, edge, i / 21 - 8), on_edge(&s, edge, i % 21 - 8));
    }
    print_series(&now);
    assert_true(now.missed > 0 && now.box2d_missed > 0);
    free_scene(&s);
}

/* Across each corner in every direction, exactly and one step to each side; some go in, some touch, some pass. */
static void test_beams_that_graze_a_corner_are_told_apart(void **state)
{
    static scene s;
    series now = { .name = "grazing a corner" };
    const tuff_real step = EXACT_WHOLE ? TUFF_REAL_RAW(1) : TUFF_RATIO(1, 64);
    (void)state;
    build_rock(&s, (tuff_vec2){ TUFF_WHOLE(-700), TUFF_WHOLE(1200) });
    for (int corner = 0; corner < 7; corner++) {
        for (int i = 0; i < 9 * FAN; i++) {
            tuff_vec2 aside = { step * (tuff_real)(i % 3 - 1), step * (tuff_real)(i / 3 % 3 - 1) };
            tuff_vec2 at = plus(on_edge(&s, corner, 0), aside);
            judge(&now, &s, plus(at, fan_direction(i / 9)), minus(at, fan_direction(i / 9)));
        }
    }
    print_series(&now);
    assert_true(now.touching < now.beams);
    assert_true(now.missed > 0);
    free_scene(&s);
}

/* From corners, edges, the inside and the outside: to the side, through, away from the piece behind, and to the same point. */
static void beams_from(series *now, const scene *s, tuff_vec2 start)
{
    judge(now, s, start, start);
    for (int i = 0; i < FAN; i++) judge(now, s, start, plus(start, fan_direction(i)));
}

static void test_a_beam_that_starts_in_a_piece_is_stopped_there(void **state)
{
    static scene s;
    series now = { .name = "starting in a piece" };
    (void)state;
    build_rock(&s, (tuff_vec2){ TUFF_WHOLE(-700), TUFF_WHOLE(1200) });
    for (int i = 0; i < 49; i++) {
        tuff_vec2 aside = { tuff_from_int(4 * (i % 7 - 3)), tuff_from_int(4 * (i / 7 - 3)) };
        tuff_vec2 start = plus(s.solids[0].at, aside);
        judge(&now, &s, start, plus(start, (tuff_vec2){ aside.x / 4, TUFF_WHOLE(1) }));
        beams_from(&now, &s, start);
    }
    print_series(&now);
    print_row(&now, "beams that start inside, missed");
    assert_int_equal(now.touching, now.beams);
    assert_true(now.missed > 0);
    free_scene(&s);
}

static void test_a_beam_that_starts_on_the_outline_or_behind_is_judged_exactly(void **state)
{
    static scene s;
    series now = { .name = "starting on the outline, or with the piece behind" };
    (void)state;
    build_rock(&s, (tuff_vec2){ TUFF_WHOLE(-700), TUFF_WHOLE(1200) });
    for (int edge = 0; edge < 7; edge++) {
        for (int quarter = 0; quarter < 4; quarter++) beams_from(&now, &s, on_edge(&s, edge, quarter));
        for (int beyond = 1; beyond < 4; beyond++) beams_from(&now, &s, on_edge(&s, edge, 4 + beyond));
    }
    print_series(&now);
    assert_true(now.touching < now.beams);
    assert_true(now.missed > 0 && now.box2d_missed > 0);
    free_scene(&s);
}

/* ---- longer than the world ---- */

/* From end to end of the positions: 65,535 units in x or y, more across. Of Q16.16 differences 32 bits are not enough. */
static void test_beams_longer_than_the_world_are_exact(void **state)
{
    static scene s;
    series now = { .name = "longer than the world" };
    const tuff_real end = TUFF_WHOLE(32767);
    (void)state;
    build_ring(&s, (tuff_vec2){ TUFF_WHOLE(5), TUFF_WHOLE(-3) });
    finish_pieces(&s, true);
    for (int i = -200; i <= 200; i++) {
        tuff_vec2 aside = { tuff_from_int(i), tuff_from_int(i) };
        judge(&now, &s, (tuff_vec2){ -end, aside.y }, (tuff_vec2){ end, aside.y });
        judge(&now, &s, (tuff_vec2){ -aside.x, end }, (tuff_vec2){ aside.x, -end });
        judge(&now, &s, (tuff_vec2){ -end, -end + TUFF_WHOLE(200) + aside.y }, (tuff_vec2){ end, end });
    }
    print_series(&now);
    print_row(&now, "beams of 65,534 units and more, hits missed");
    assert_true(now.touching > 100 && now.touching < now.beams);
    assert_true(now.missed > (EXACT_WHOLE ? now.touching / 10 : 0));
    free_scene(&s);
}

/* ---- chunk borders and corners ---- */

/* It fills a chunk to its borders. */
static void add_box(scene *s, tuff_vec2 at)
{
    const tuff_real half = TUFF_WHOLE(CHUNK / 2);
    const tuff_vec2 box[4] = { { -half, -half }, { half, -half }, { half, half }, { -half, half } };
    add_solid(s, at, box, 4);
}

/* Boxes in some of the chunks. */
static void build_field(random_source *source, scene *s)
{
    s->count = 0;
    for (int x = -FIELD; x < FIELD; x++) {
        for (int y = -FIELD; y < FIELD; y++) {
            if (!random_chance(source, 12)) continue;
            add_box(s, (tuff_vec2){ tuff_from_int(x * CHUNK + CHUNK / 2), tuff_from_int(y * CHUNK + CHUNK / 2) });
        }
    }
    finish_pieces(s, true);
}

static tuff_vec2 chunk_corner(int number)
{
    int x = number / (2 * FIELD + 1) - FIELD, y = number % (2 * FIELD + 1) - FIELD;
    return (tuff_vec2){ tuff_from_int(x * CHUNK), tuff_from_int(y * CHUNK) };
}

/* From every corner of a chunk to every other: along borders, along diagonals, through corners. */
static void test_beams_along_chunk_borders_and_corners_find_every_piece(void **state)
{
    static scene s;
    const int corners = (2 * FIELD + 1) * (2 * FIELD + 1);
    series now = { .name = "along chunk borders and corners", .by_march = true };
    (void)state;
    for (uint32_t field = 0; field < 8; field++) {
        random_source source = random_stream(7002, field);
        build_field(&source, &s);
        for (int i = 0; i < corners * corners; i++) judge(&now, &s, chunk_corner(i / corners), chunk_corner(i % corners));
        free_scene(&s);
    }
    print_series(&now);
    print_row(&now, "beams along chunk borders and corners, hits missed");
    assert_true(now.missed > 0);
}

/* ---- the picture ---- */

static void draw_beam(picture_role role, tuff_vec2 a, tuff_vec2 b)
{
    picture_arrow(role, units_of(a.x), units_of(a.y), units_of(b.x), units_of(b.y));
}

/* To where tuff stops it. */
static void draw_stopped(const scene *s, tuff_vec2 a, tuff_vec2 b)
{
    tuff_beam_hit hit;
    assert_true(tuff_segment_terrain_first_hit(&s->world, a, b, &hit));
    tuff_vec2 way = minus(b, a), end = { a.x + tuff_scale(way.x, hit.fraction), a.y + tuff_scale(way.y, hit.fraction) };
    if (hit.fraction != 0) draw_beam(PICTURE_TUFF, a, end);
    picture_dot(PICTURE_TUFF, units_of(end.x), units_of(end.y));
}

static void draw_ring(void)
{
    static scene s;
    build_ring(&s, (tuff_vec2){ 0, 0 });
    finish_parts(&s, RING_SEAMS);
    picture_panel("Along seams: out of a closed ring", -16, -50, 118, 50);
    picture_piece(&s.pieces[0]);
    for (int i = -2; i <= 2; i += 2) {
        assert_false(crossings_say(&s, (tuff_vec2){ 0, 0 }, ring_point(i + RING, 3)));
        draw_beam(PICTURE_FAILS, (tuff_vec2){ 0, 0 }, ring_point(i + RING, 3));
        draw_stopped(&s, (tuff_vec2){ 0, 0 }, ring_point(i + RING, 3));
    }
    free_scene(&s);
}

static void draw_inside(void)
{
    static scene s;
    tuff_vec2 start = { TUFF_WHOLE(-10), TUFF_WHOLE(4) }, to = { TUFF_WHOLE(96), TUFF_WHOLE(26) };
    build_rock(&s, (tuff_vec2){ 0, 0 });
    picture_panel("From inside: Box2D's ray goes on", -48, -46, 104, 66);
    picture_piece(&s.pieces[0]);
    assert_false(box2d_says(&s, start, to));
    draw_beam(PICTURE_BOX2D, start, to);
    draw_stopped(&s, start, to);
    picture_note(-34, -16, "tuff: hit at the start");
    free_scene(&s);
}

static void draw_march(void)
{
    static scene s;
    tuff_vec2 from = { TUFF_WHOLE(-24), TUFF_WHOLE(-24) }, to = { TUFF_WHOLE(24), TUFF_WHOLE(24) };
    s.count = 0;
    add_box(&s, (tuff_vec2){ TUFF_WHOLE(-8), TUFF_WHOLE(8) });
    add_box(&s, (tuff_vec2){ TUFF_WHOLE(8), TUFF_WHOLE(-8) });
    finish_pieces(&s, true);
    picture_panel("A march leaves out two chunks", -40, -29, 40, 29);
    for (int i = -2; i <= 2; i++) {
        picture_segment(PICTURE_SEAM, "chunk border", i * CHUNK, -29, i * CHUNK, 29);
        picture_segment(PICTURE_SEAM, "chunk border", -40, i * CHUNK, 40, i * CHUNK);
    }
    for (int i = 0; i < s.count; i++) picture_piece(&s.pieces[i]);
    assert_false(march_says(&s, from, to));
    draw_beam(PICTURE_FAILS, from, to);
    draw_stopped(&s, from, to);
    free_scene(&s);
}

static void test_what_leaks_in_the_picture_is_stopped_by_tuff(void **state)
{
    (void)state;
    picture_begin("beams");
    draw_ring();
    draw_inside();
    draw_march();
    picture_end();
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_no_beam_leaks_along_the_seams_of_separate_pieces),
        cmocka_unit_test(test_no_beam_leaks_along_the_seams_of_one_piece),
        cmocka_unit_test(test_no_beam_leaks_through_a_shared_vertex),
        cmocka_unit_test(test_no_beam_slips_into_a_seam_of_odd_numbers),
        cmocka_unit_test(test_beams_along_an_edge_are_stopped_if_they_meet_it),
        cmocka_unit_test(test_beams_that_graze_a_corner_are_told_apart),
        cmocka_unit_test(test_a_beam_that_starts_in_a_piece_is_stopped_there),
        cmocka_unit_test(test_a_beam_that_starts_on_the_outline_or_behind_is_judged_exactly),
        cmocka_unit_test(test_beams_longer_than_the_world_are_exact),
        cmocka_unit_test(test_beams_along_chunk_borders_and_corners_find_every_piece),
        cmocka_unit_test(test_what_leaks_in_the_picture_is_stopped_by_tuff),
    };
    (void)argc;
    random_begin(argv);
    table_family(7, "Beams");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
