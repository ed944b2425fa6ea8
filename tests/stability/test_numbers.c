/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Family 6, numbers: shapes too far apart for the square of their distance, the ends of the range, differences of 33 bits,
   offsets whose products vanish, overlaps of 1 LSB, the speed limit, saturation; and what float alone has: NaN, infinity,
   denormals, -0, and steps of position that grow with the distance from the origin. tests/host/test_bad_input.c has the rest of
   the bad numbers. */
#include <string.h>

#include "accuracy.h"
#include "handed.h"
#include "naive.h"
#include "picture.h"
#include "pieces.h"
#include "table.h"

#define HIGHEST TUFF_REAL_RAW(TUFF_INT32_MAX)      /* the ends of a position; in float they are +-TUFF_MAX_POSITION */
#define LOWEST  TUFF_REAL_RAW(TUFF_INT32_MIN)
#define LSB     TUFF_REAL_RAW(1)
#define IS_FIXED (TUFF_SCALAR == TUFF_Q16_16)

/* ---- arithmetic as it is written at first: 32 bits in, 32 bits out ---- */

#if TUFF_SCALAR == TUFF_Q16_16
static tuff_real naive_times(tuff_real a, tuff_real b) { return (tuff_real)(uint32_t)(uint64_t)(((int64_t)a * b) >> 16); }
static tuff_real naive_plus(tuff_real a, tuff_real b)  { return (tuff_real)((uint32_t)a + (uint32_t)b); }
static tuff_real naive_minus(tuff_real a, tuff_real b) { return (tuff_real)((uint32_t)a - (uint32_t)b); }
#else
static tuff_real naive_times(tuff_real a, tuff_real b) { return a * b; }
static tuff_real naive_plus(tuff_real a, tuff_real b)  { return a + b; }
static tuff_real naive_minus(tuff_real a, tuff_real b) { return a - b; }
#endif

static tuff_real naive_square(tuff_vec2 d)
{
    return naive_plus(naive_times(d.x, d.x), naive_times(d.y, d.y));
}

static tuff_vec2 naive_difference(tuff_vec2 a, tuff_vec2 b)
{
    return (tuff_vec2){ naive_minus(a.x, b.x), naive_minus(a.y, b.y) };
}

static bool naive_circles_touch(tuff_vec2 a, tuff_vec2 b, tuff_real reach)
{
    return naive_square(naive_difference(a, b)) < naive_times(reach, reach);
}

/* ---- pieces ---- */

/* A box and a ball of 8 units at the same place, for a body of 8 units. */
typedef struct scene {              /* not to be copied */
    random_shape box;
    tuff_terrain pieces[2];
    tuff_world   world;
    uint16_t     nearby[2];
} scene;

static void make_scene(scene *s, tuff_vec2 at)
{
    random_box_shape(&s->box, (tuff_vec2){ TUFF_WHOLE(5), TUFF_WHOLE(5) });
    s->pieces[0] = convex_piece(&s->box, at);
    s->pieces[1] = (tuff_terrain){ at, TUFF_WHOLE(8), TUFF_WHOLE(8), NULL, 0 };
    s->world = (tuff_world){ s->pieces, 2, NULL, s->nearby, 2, TUFF_ORDER_ITERATION };
}

/* Does any call find the pieces from there? */
static bool anything_touches(scene *s, tuff_vec2 from)
{
    tuff_contact contact;
    tuff_body body = body_at(from);
    bool touched = false;
    for (int i = 0; i < 2; i++) {
        touched = tuff_terrain_overlap_circle(&s->pieces[i], from, TUFF_WHOLE(8), &contact) || touched;
        touched = tuff_terrain_overlap_hull(&s->pieces[i], from, TUFF_WHOLE(8), &s->box.polygon, &contact) || touched;
    }
    s->world.order ^= 1;
    return touched || tuff_terrain_collide(&s->world, &body, TUFF_WHOLE(8), &s->box.polygon) != 0 ||
           tuff_nearby_terrain(&s->world, from, TUFF_WHOLE(8)) != 0 || tuff_segment_terrain_intersect(&s->world, from, from);
}

/* ---- far apart ---- */

typedef struct far_pair { tuff_vec2 piece, body; } far_pair;

/* So many units apart, both in range: about a middle that leaves room. */
static far_pair place_far(random_source *source, double distance)
{
    double angle = random_within(source, 0, TURN), x = cos(angle) * distance, y = sin(angle) * distance;
    x = x > 65535 ? 65535 : x < -65535 ? -65535 : x;
    double room_x = 32767.5 - fabs(x) / 2, room_y = 32767.5 - fabs(y) / 2;
    double middle_x = random_within(source, -room_x, room_x), middle_y = random_within(source, -room_y, room_y);
    return (far_pair){ random_point_at(middle_x - x / 2, middle_y - y / 2), random_point_at(middle_x + x / 2, middle_y + y / 2) };
}

typedef struct far_count { unsigned long pairs, naive, box2d, tuff; } far_count;

static bool box2d_touches(const box2d_polygon *box, far_pair at)
{
    box2d_contact contact;
    return box2d_circle_polygon(box, twin_vec(at.piece), twin_vec(at.body), 8, &contact);
}

static void count_far(random_source *source, const box2d_polygon *box, double low, double high, far_count *count)
{
    scene s;
    far_pair at = place_far(source, random_magnitude(source, low, high));
    make_scene(&s, at.piece);
    count->pairs++;
    count->naive += naive_circles_touch(at.piece, at.body, TUFF_WHOLE(16));
    count->box2d += box2d_touches(box, at);
    count->tuff += anything_touches(&s, at.body);
}

static box2d_polygon *box_of_box2d(void)
{
    static const box2d_vec corners[4] = { { -5, -5 }, { 5, -5 }, { 5, 5 }, { -5, 5 } };
    return box2d_polygon_new(corners, 4);
}

/* Squares of 181 units are beyond 32768: what is left of them is as good as random. */
static void test_distances_of_181_to_65535_units_never_touch(void **state)
{
    random_run run = random_cases(__func__, 1601, 100000);
    far_count count = { 0, 0, 0, 0 };
    box2d_polygon *box = box_of_box2d();
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        count_far(&source, box, 181, 65535, &count);
        if (count.tuff) random_fail(&run, i, "a touch over 181 units");
    }
    box2d_polygon_free(box);
    table_row("181 to 65,535 units apart: told as touching, %");
    table_fails("32-bit squares", "%.2f", percent(count.naive, count.pairs));
    table_box2d("%.2f", percent(count.box2d, count.pairs));
    table_tuff("%.2f", percent(count.tuff, count.pairs));
    if (IS_FIXED && count.pairs >= 1000) assert_true(count.naive > 0);
    assert_int_equal(count.tuff, 0);
}

/* ---- the corners of the range ---- */

static tuff_vec2 place_of_nine(int i)
{
    const tuff_real places[3] = { LOWEST, 0, HIGHEST };
    return (tuff_vec2){ places[i % 3], places[i / 3] };
}

/* Of opposite ends the difference has 33 bits; in 32 it is one step. */
static void test_opposite_ends_of_the_range_do_not_touch(void **state)
{
    unsigned long naive = 0, pairs = 0;
    scene s;
    (void)state;
    for (int i = 0; i < 81; i++) {
        if (i / 9 == i % 9) continue;
        make_scene(&s, place_of_nine(i / 9));
        pairs++;
        naive += naive_square(naive_difference(place_of_nine(i / 9), place_of_nine(i % 9))) < TUFF_WHOLE(16);
        assert_false(anything_touches(&s, place_of_nine(i % 9)));
    }
    printf("figures: corners, sides and middle of the range, " EXACT_BUILD ": touching with a 32-bit difference: %lu of %lu\n", naive,
           pairs);
    if (IS_FIXED) assert_int_equal(naive, pairs);
}

/* A box about so many units beside the line from a to b, somewhere along it. */
static tuff_vec2 beside_line(random_source *source, tuff_vec2 a, tuff_vec2 b)
{
    double share = random_fraction(source), aside = random_within(source, -12, 12) * EXACT_UNIT;
    double x = (double)exact_real(a.x), y = (double)exact_real(a.y), dx = (double)exact_real(b.x) - x, dy = (double)exact_real(b.y) - y;
    double length = sqrt(dx * dx + dy * dy);
    x += dx * share - dy / length * aside;
    y += dy * share + dx / length * aside;
    const double most = 32767.0 * EXACT_UNIT;
    return vec2_from_doubles(fmax(-most, fmin(most, x)), fmax(-most, fmin(most, y)));
}

/* Their ends differ by 33 bits. Float: outside of what it promises of so long a beam. */
static void test_beams_from_end_to_end_of_the_range_hit_what_lies_on_them(void **state)
{
    random_run run = random_cases(__func__, 1605, 20000);
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        tuff_vec2 a = place_of_nine((int)random_below(&source, 9)), b = place_of_nine((int)random_below(&source, 9));
        oracle_polygon box;
        scene s;
        if (same_point(a, b)) continue;
        make_scene(&s, beside_line(&source, a, b));
        s.world.terrain_count = 1;
        oracle_read_polygon(&box, &s.box.polygon);
        exact2 at = exact_vec2(s.pieces[0].position), from = exact_sub(exact_vec2(a), at), to = exact_sub(exact_vec2(b), at);
        exact band = IS_FIXED ? 0 : accuracy_float_beam_band(exact_length(exact_sub(to, from)));
        if (tuff_segment_terrain_intersect(&s.world, a, b) == oracle_segment_polygon(&box, from, to)) continue;
        if (oracle_segment_polygon_margin(&box, from, to) > band) random_fail(&run, i, "a beam over the whole range is wrong");
    }
}

/* Relative positions are small there too: the same contact as at the origin, to float's steps of position. */
static void test_contacts_at_every_end_of_the_range_are_those_of_the_origin(void **state)
{
    const tuff_real tolerance = IS_FIXED ? 0 : TUFF_RATIO(1, 256);
    (void)state;
    for (int i = 0; i < 9; i++) {
        scene s;
        tuff_contact here, there;
        tuff_vec2 at = place_of_nine(i);
        tuff_vec2 inward = { at.x > 0 ? TUFF_WHOLE(-12) : TUFF_WHOLE(12), at.y > 0 ? TUFF_WHOLE(-2) : TUFF_WHOLE(2) };
        make_scene(&s, (tuff_vec2){ 0, 0 });
        assert_true(tuff_terrain_overlap_circle(&s.pieces[0], inward, TUFF_WHOLE(8), &here));
        make_scene(&s, at);
        assert_true(tuff_terrain_overlap_circle(&s.pieces[0], (tuff_vec2){ at.x + inward.x, at.y + inward.y }, TUFF_WHOLE(8), &there));
        assert_true(same_normal(here.normal, there.normal));
        assert_true(here.overlap - there.overlap <= tolerance && there.overlap - here.overlap <= tolerance);
    }
}

/* ---- saturation ---- */

/* A body that a rock pushes out of the world. */
static void test_a_push_over_the_edge_of_the_range_stops_there(void **state)
{
    double naive_end = 0, end = 0;
    (void)state;
    for (int i = 0; i < 9; i++) {
        scene s;
        tuff_vec2 at = place_of_nine(i);
        tuff_body body = body_at(at);
        if (at.x == 0 || at.y == 0) continue;
        make_scene(&s, (tuff_vec2){ at.x + (at.x > 0 ? TUFF_WHOLE(-6) : TUFF_WHOLE(6)), at.y });
        tuff_contact contact;
        assert_true(tuff_terrain_overlap_circle(&s.pieces[0], at, TUFF_WHOLE(8), &contact));
        tuff_real push = naive_times(contact.overlap, at.x > 0 ? TUFF_WHOLE(1) : TUFF_WHOLE(-1));
        naive_end = fabs(units_of(naive_plus(at.x, push)) - units_of(at.x));
        tuff_bounce(&body, &contact);
        end = fabs(units_of(body.position.x) - units_of(at.x));
        assert_true(same_point(body.position, at));
        assert_true(naive_end > 1);
    }
    table_row("a push of 7 over the edge of the range: body moved, units");
    table_fails("plain addition", "%.0f", naive_end);
    table_tuff("%.0f", end);
}

/* ---- small offsets ---- */

/* tuff_lost: tuff's normal is off by over a hundredth of a radian. */
typedef struct small_count { unsigned long pairs, lost, tuff_lost; double normal, depth; } small_count;

static void judge_small(small_count *count, tuff_vec2 offset)
{
    oracle_answer answer;
    tuff_contact contact;
    oracle_circles(exact_vec2(offset), exact_real(TUFF_WHOLE(2)), exact_real(TUFF_WHOLE(3)), &answer);
    assert_true(tuff_circle_circle(offset, TUFF_WHOLE(2), TUFF_WHOLE(3), &contact));
    count->pairs++;
    count->lost += naive_square(offset) == 0;
    double off = (double)oracle_normal_error(&answer, 0, exact_unit2(contact.normal));
    count->tuff_lost += off > 0.01;
    raise_to(&count->normal, off);
    raise_to(&count->depth, exact_abs(exact_real(contact.overlap) - answer.depth));
}

/* (255 * 255) >> 16 is 0: no length, no direction. */
static void test_offsets_under_256_LSB_keep_their_direction(void **state)
{
    const double depth_held = IS_FIXED ? 0.5 : 0.5 + EXACT_UNIT * 2.4e-7, normal_held = IS_FIXED ? 1e-8 : 2e-7;
    small_count count = { 0, 0, 0, 0, 0 };
    (void)state;
    for (int32_t x = -255; x < 256; x++) {
        for (int32_t y = -255; y < 256; y++) {
            if (x != 0 || y != 0) judge_small(&count, (tuff_vec2){ TUFF_REAL_RAW(x), TUFF_REAL_RAW(y) });
        }
    }
    table_row("offsets under 256 LSB without a direction, %");
    table_fails("products >> 16", "%.1f", percent(count.lost, count.pairs));
    table_tuff("%.1f", percent(count.tuff_lost, count.pairs));
    printf("figures: offsets under 256 LSB, " EXACT_BUILD ": normal within %.1e rad, depth within %.2f LSB\n", count.normal, count.depth);
    if (IS_FIXED) assert_true(count.lost > 0);
    assert_int_equal(count.tuff_lost, 0);
    assert_true(count.normal <= normal_held && count.depth <= depth_held);
}

static void test_edges_under_256_LSB_have_normals(void **state)
{
    (void)state;
    for (int32_t i = 1; i < 256; i++) {
        random_shape shape;
        oracle_polygon truth;
        for (int k = 0; k < 3; k++) shape.vertices[k] = (tuff_vec2){ TUFF_REAL_RAW(k == 1 ? i : 0), TUFF_REAL_RAW(k == 2 ? 256 - i : 0) };
        random_bake(&shape, 3);
        oracle_read_polygon(&truth, &shape.polygon);
        for (int k = 0; k < 3; k++) assert_true(oracle_angle(exact_unit2(shape.normals[k]), truth.normals[k]) < (exact)2e-7);
        if (IS_FIXED) assert_true(naive_square(shape.vertices[1]) == 0);
    }
}

/* ---- overlaps of 1 LSB ---- */

/* A square whose edges have the normals (4, 3) / 5 and so on, and a circle off the middle of an edge by whole steps: its radius
   is the distance and more. */
static const int tilted[5][2] = { { 49, -7 }, { 7, 49 }, { -49, 7 }, { -7, -49 }, { 49, -7 } };

static void make_tilted(random_shape *shape)
{
    for (int i = 0; i < 4; i++) shape->vertices[i] = (tuff_vec2){ TUFF_WHOLE(tilted[i][0]), TUFF_WHOLE(tilted[i][1]) };
    random_bake(shape, 4);
}

typedef struct one_lsb { unsigned long asked, naive_wrong, box2d_wrong, wrong; double depth; } one_lsb;

static void judge_one_lsb(one_lsb *sum, const random_shape *shape, const box2d_polygon *box, int edge, int32_t out, int32_t more)
{
    const int *from = tilted[edge], *to = tilted[edge + 1];
    const int32_t across_x = (to[1] - from[1]) / 14, across_y = (from[0] - to[0]) / 14;
    tuff_vec2 middle = { TUFF_RATIO(from[0] + to[0], 2), TUFF_RATIO(from[1] + to[1], 2) };
    tuff_vec2 center = { middle.x + TUFF_REAL_RAW(across_x * out), middle.y + TUFF_REAL_RAW(across_y * out) };
    tuff_real radius = TUFF_REAL_RAW(5 * out + more);
    textbook_contact rough;
    box2d_contact floating = { 0, { 0, 0 } };
    tuff_contact contact = { 0, { 0, 0 } };
    naive_polygon naive;
    naive_read(&naive, &shape->polygon);
    sum->asked++;
    sum->naive_wrong += textbook_circle(center, radius, &naive.polygon, &rough) != (more > 0);
    bool box2d_found = box2d_circle_polygon(box, (box2d_vec){ 0, 0 }, twin_vec(center), tuff_to_float(radius), &floating);
    sum->box2d_wrong += (box2d_found && floating.overlap > 0) != (more > 0);
    sum->wrong += tuff_circle_polygon(center, radius, &shape->polygon, &contact) != (more > 0);
    if (more > 0) raise_to(&sum->depth, exact_abs(exact_real(contact.overlap) - more));
}

/* Gaps and overlaps of 1 to 3 LSB; touching, which float's normals cannot tell, is left to the fixed build. */
static void test_overlaps_of_1_LSB_are_seen_and_gaps_of_1_LSB_are_not(void **state)
{
    one_lsb sum = { 0, 0, 0, 0, 0 };
    random_shape shape;
    (void)state;
    make_tilted(&shape);
    box2d_polygon *box = box2d_of(&shape.polygon);
    for (int32_t out = 1000; out < 100000; out += 331) {
        for (int32_t more = -3; more <= 3; more++) {
            if (more == 0 && !IS_FIXED) continue;
            for (int edge = 0; edge < 4; edge++) judge_one_lsb(&sum, &shape, box, edge, out, more);
        }
    }
    box2d_polygon_free(box);
    table_row("within 3 LSB of touching: wrong yes or no, %");
    table_fails("textbook", "%.1f", percent(sum.naive_wrong, sum.asked));
    table_box2d("%.1f", percent(sum.box2d_wrong, sum.asked));
    table_tuff("%.1f", percent(sum.wrong, sum.asked));
    if (IS_FIXED) assert_true(sum.naive_wrong > 0);
    assert_int_equal(sum.wrong, 0);
    assert_true(sum.depth <= 0.5);
}

/* ---- velocities at the limit ---- */

static const tuff_material bumper = { TUFF_WHOLE(TUFF_MAX_RESTITUTION), TUFF_WHOLE(0) };

/* Between two walls that each give back four times the speed. */
static void test_bumpers_end_at_the_speed_limit_and_never_turn_round(void **state)
{
    tuff_body body = { { 0, 0 }, { TUFF_WHOLE(TUFF_MAX_SPEED), TUFF_WHOLE(-TUFF_MAX_SPEED) }, &bumper };
    tuff_real naive = body.velocity.x;
    unsigned long turned = 0;
    (void)state;
    for (int i = 0; i < 20; i++) {
        tuff_contact wall = { LSB, { body.velocity.x > 0 ? TUFF_UNIT_RATIO(-1, 1) : TUFF_UNIT_RATIO(1, 1), 0 } };
        bool right = body.velocity.x > 0, naive_right = naive > 0;
        tuff_bounce(&body, &wall);
        naive = naive_times(naive, TUFF_WHOLE(-TUFF_MAX_RESTITUTION));
        turned += (naive > 0) == naive_right;
        assert_int_equal(body.velocity.x > 0, !right);
        assert_true(fabs(units_of(body.velocity.x)) == TUFF_MAX_SPEED && body.velocity.y == TUFF_WHOLE(-TUFF_MAX_SPEED));
    }
    printf("figures: speed after 20 bounces of restitution 4, " EXACT_BUILD ": %.3g units a step without a limit, tuff %.0f\n",
           fabs(units_of(naive)), fabs(units_of(body.velocity.x)));
    if (IS_FIXED) assert_true(turned > 0);
    else assert_true(naive > TUFF_WHOLE(TUFF_MAX_SPEED) || -naive > TUFF_WHOLE(TUFF_MAX_SPEED));
}

static exact within_limit(exact speed)
{
    const exact limit = (exact)TUFF_MAX_SPEED * EXACT_UNIT;
    return speed > limit ? limit : speed < -limit ? -limit : speed;
}

/* What the header says of a bounce, in exact numbers. */
static exact2 bounce_by_formula(tuff_vec2 v, tuff_unit2 normal, const tuff_material *material)
{
    exact2 n = exact_unit2(normal), before = exact_vec2(v);
    exact inward = exact_dot(n, before), keep = 1 - exact_real(material->friction) / EXACT_UNIT;
    exact change = inward < 0 ? (keep + exact_real(material->restitution) / EXACT_UNIT) * inward : 0;
    if (inward >= 0) keep = 1;
    return (exact2){ within_limit(keep * before.x - change * n.x), within_limit(keep * before.y - change * n.y) };
}

/* Off a wall in any direction: the velocity that the formula gives, to the bits that the build has of it, and no component
   above the limit. */
static void test_bounces_at_the_limit_follow_the_formula(void **state)
{
    static const int16_t signs[4][2] = { { 1, 1 }, { -1, 1 }, { -1, -1 }, { 1, -1 } };
    const double held = IS_FIXED ? 1 : 1024 * EXACT_UNIT * 1e-6;    /* rounded toward zero; float: eight roundings */
    double most = 0;
    (void)state;
    for (int i = 0; i < 4 * 360; i++) {
        tuff_contact contact = { 0, { 0, 0 } };
        tuff_material material = { TUFF_RATIO(i % 3, 2), TUFF_RATIO(i % 5, 4) };
        tuff_body body = { { 0, 0 }, { TUFF_WHOLE(1024 * signs[i % 4][0]), TUFF_WHOLE(1024 * signs[i % 4][1]) }, &material };
        (void)tuff_circle_circle(random_point_at(cos(i / 180.0 * TURN), sin(i / 180.0 * TURN)), TUFF_WHOLE(1), TUFF_WHOLE(1), &contact);
        exact2 wanted = bounce_by_formula(body.velocity, contact.normal, &material);
        tuff_bounce(&body, &contact);
        raise_to(&most, exact_abs(exact_real(body.velocity.x) - wanted.x));
        raise_to(&most, exact_abs(exact_real(body.velocity.y) - wanted.y));
    }
    printf("figures: bounces at the speed limit, " EXACT_BUILD ": within %.2g LSB of the formula\n", most);
    assert_true(most <= held);
}

/* ---- far from the origin ---- */

typedef struct far_figures { double naive, box2d, tuff, left; } far_figures;

/* The textbook with all vertices moved to world positions. */
static bool naive_world_hull(const twin *piece, tuff_vec2 at, const twin *hull, tuff_vec2 position, textbook_contact *contact)
{
    static random_shape rock, mover;
    naive_polygon rock_read, mover_read;
    for (int i = 0; i < piece->shape.polygon.count; i++) {
        tuff_vec2 v = piece->shape.vertices[i];
        rock.vertices[i] = (tuff_vec2){ naive_plus(v.x, at.x), naive_plus(v.y, at.y) };
    }
    for (int i = 0; i < hull->shape.polygon.count; i++) {
        tuff_vec2 v = hull->shape.vertices[i];
        mover.vertices[i] = (tuff_vec2){ naive_plus(v.x, position.x), naive_plus(v.y, position.y) };
    }
    naive_read(&rock_read, &piece->shape.polygon);
    naive_read(&mover_read, &hull->shape.polygon);
    rock_read.polygon.vertices = rock.vertices;
    mover_read.polygon.vertices = mover.vertices;
    return textbook_hull(&mover_read.polygon, (tuff_vec2){ 0, 0 }, &rock_read.polygon, contact);
}

static exact hull_depth(const twin *piece, tuff_vec2 at, const twin *hull, tuff_vec2 position)
{
    oracle_answer answer;
    oracle_hull(&piece->exact, &hull->exact, exact_sub(exact_vec2(position), exact_vec2(at)), &answer);
    return answer.depth;
}

/* Depths of two shapes about this far out, on a grid of 1/512 unit that float has to 32,768. Overlaps above 1/8 unit are asked:
   none is in doubt. */
static void measure_far(random_source *source, int32_t out, far_figures *most)
{
    twin piece, hull;
    twin_make(source, &piece, 24);
    twin_make(source, &hull, 12);
    tuff_vec2 at = { tuff_from_int(random_chance(source, 50) ? out : -out), tuff_from_int(random_chance(source, 50) ? out : -out) };
    int32_t x = random_between(source, -10000, 10000), y = random_between(source, -10000, 10000);
    tuff_vec2 position = { at.x + TUFF_RATIO(x, 512), at.y + TUFF_RATIO(y, 512) };
    exact truth = hull_depth(&piece, at, &hull, position);
    tuff_terrain rock = convex_piece(&piece.shape, at);
    textbook_contact rough = { 0, { 0, 0 } };
    box2d_contact box = { 0, { 0, 0 } };
    tuff_contact contact;
    if (truth > EXACT_UNIT / 8) {
        bool found = naive_world_hull(&piece, at, &hull, position, &rough);
        raise_to(&most->naive, exact_abs((found ? exact_real(rough.overlap) : 0) - truth));
        found = box2d_hull_polygon(piece.box, twin_vec(at), hull.box, twin_vec(position), &box);
        raise_to(&most->box2d, exact_abs((found ? (exact)box.overlap * EXACT_UNIT : 0) - truth));
        assert_true(tuff_terrain_overlap_hull(&rock, position, hull.shape.bounding_radius, &hull.shape.polygon, &contact));
        raise_to(&most->tuff, exact_abs(exact_real(contact.overlap) - truth));
        raise_to(&most->left, exact_abs(hull_depth(&piece, at, &hull, accuracy_pushed(position, &contact))));
    }
    twin_free(&piece);
    twin_free(&hull);
}

static far_figures figures_at(const random_run *run, int32_t out)
{
    far_figures most = { 0, 0, 0, 0 };
    for (uint32_t i = run->first; i < run->end; i++) {
        random_source source = random_stream(run->seed, i);
        measure_far(&source, out, &most);
    }
    return most;
}

/* Steps of a float position this far out, in steps of 1/65536. */
static double float_step(double units)
{
    float here = (float)units;
    return (double)(nextafterf(here, 1e9f) - here) * EXACT_UNIT;
}

static void table_far(const far_figures *most)
{
    table_row("depth error at 30,000 units, units");
    table_fails("world coordinates", "%.1e", most->naive / EXACT_UNIT);
    table_box2d("%.1e", most->box2d / EXACT_UNIT);
    table_tuff("%.1e", most->tuff / EXACT_UNIT);
    table_row("left over after a push at 30,000 units, units");
    table_tuff("%.1e", most->left / EXACT_UNIT);
}

/* The depth is as good there as at the origin; what a push leaves over is a step of the position. */
static void test_depths_far_from_the_origin_are_those_of_the_origin(void **state)
{
    static const int32_t places[3] = { 0, 16000, 30000 };
    random_run run = random_cases(__func__, 1602, 8000);
    const accuracy_bounds bounds = accuracy_bounds_of(64);
    far_figures most = { 0, 0, 0, 0 };
    (void)state;
    for (int i = 0; i < 3; i++) {
        most = figures_at(&run, places[i]);
        printf("figures: depth error at %ld units, " EXACT_BUILD ": world coordinates %.1e, Box2D %.1e, tuff %.1e; left over %.1e units\n",
               (long)places[i], most.naive / EXACT_UNIT, most.box2d / EXACT_UNIT, most.tuff / EXACT_UNIT, most.left / EXACT_UNIT);
        assert_true(most.tuff <= (double)bounds.depth);
        assert_true(most.left <= (double)bounds.left_over + (IS_FIXED ? 0 : float_step(places[i])));
        if (i > 0) assert_true(most.naive > 8 * most.tuff);
    }
    table_far(&most);
}

/* ---- what float's steps of position swallow ---- */

/* The least push, in steps of 1/65536, that moves a body from there. */
static int32_t least_push_at(int32_t units)
{
    tuff_contact contact = { 0, { TUFF_UNIT_RATIO(1, 1), 0 } };
    for (int32_t steps = 1;; steps++) {
        tuff_body body = { { tuff_from_int(units), 0 }, { 0, 0 }, NULL };
        contact.overlap = TUFF_REAL_RAW(steps);
        tuff_bounce(&body, &contact);
        if (body.position.x != tuff_from_int(units)) return steps;
    }
}

/* And no slower speed does either, which the game adds. Float: half a step of position, and 1 LSB. */
static void test_pushes_of_half_a_step_of_position_move_a_body(void **state)
{
    static const int32_t places[2] = { 16000, 30000 };
    (void)state;
    for (int i = 0; i < 2; i++) {
        int32_t least = least_push_at(places[i]);
        printf("figures: the smallest move of a body at %ld units, " EXACT_BUILD ": %.1e units\n", (long)places[i],
               (double)least / EXACT_UNIT);
        assert_true(least <= (IS_FIXED ? 1 : float_step(places[i]) / 2 + 1));
    }
}

/* Under gravity on a box, with a push a step: it neither sinks nor jumps, far out by a step of position. */
static void test_bodies_rest_far_from_the_origin(void **state)
{
    static const int32_t places[3] = { 0, 16000, 30000 };
    (void)state;
    for (int i = 0; i < 3; i++) {
        scene s;
        double lowest = 0, highest = 0;
        const double step = IS_FIXED ? 2 : float_step(places[i]) + 1e-4 * EXACT_UNIT;
        make_scene(&s, (tuff_vec2){ tuff_from_int(places[i]), tuff_from_int(-places[i]) });
        s.world.terrain_count = 1;
        tuff_body body = { { s.pieces[0].position.x + TUFF_WHOLE(1), s.pieces[0].position.y + TUFF_WHOLE(13) }, { 0, 0 }, NULL };
        const double rest = units_of(body.position.y);
        for (int k = 0; k < 1000; k++) {
            body_fall(&body, (tuff_vec2){ 0, -TUFF_RATIO(1, 20) });
            (void)tuff_terrain_collide_circle(&s.world, &body, TUFF_WHOLE(8));
            double height = (units_of(body.position.y) - rest) * EXACT_UNIT;
            if (k > 100 && height > highest) highest = height;
            if (height < lowest) lowest = height;
        }
        printf("figures: rest at %ld units, " EXACT_BUILD ": sinks by %.2g, rises by %.2g units\n", (long)places[i],
               fabs(lowest) / EXACT_UNIT, highest / EXACT_UNIT);
        assert_true(-lowest <= step);
        assert_true(highest <= step + 0.05 * EXACT_UNIT);
    }
}

/* ---- no numbers ---- */

/* NaN is neither less nor more: whoever asks only whether shapes are apart finds that they are not. In Q16.16 the same bits are far
   places. */
static void test_bits_of_NaN_and_infinity_touch_nothing(void **state)
{
    static const uint32_t bad[4] = { 0x7FC00000u, 0xFFC00001u, 0x7F800000u, 0xFF800000u };
    unsigned long naive = 0, tuff = 0;
    (void)state;
    for (int i = 0; i < 8; i++) {
        scene s;
        tuff_real odd;
        memcpy(&odd, &bad[i / 2], sizeof odd);
        tuff_vec2 at = { i % 2 ? odd : 1, i % 2 ? 1 : odd };
        naive_polygon box;
        textbook_contact contact;
        make_scene(&s, (tuff_vec2){ 0, 0 });
        naive_read(&box, &s.box.polygon);
        naive += textbook_circle(at, TUFF_WHOLE(8), &box.polygon, &contact);
        tuff += anything_touches(&s, at);
    }
    table_row("bits of NaN and infinity as positions: touching, of 8");
    table_fails("textbook", "%lu", naive);
    table_tuff("%lu", tuff);
    if (!IS_FIXED) assert_true(naive > 0);
    assert_int_equal(tuff, 0);
}

#if TUFF_SCALAR == TUFF_FLOAT
/* The sanitizers stop at 0 / 0. */
static float quotient(float a, float b)
{
    return b > 0 ? a / b : NAN;
}

/* Down to the smallest denormal number: too small to square, never too small for a contact. */
static void test_offsets_too_small_to_square_still_part(void **state)
{
    unsigned long naive = 0, tuff = 0, asked = 0;
    (void)state;
    for (float size = 1e-3f; size > 0; size *= 0.5f) {
        tuff_vec2 d = { size, -size };
        tuff_contact contact;
        float length = sqrtf(d.x * d.x + d.y * d.y), x = quotient(d.x, length), y = quotient(d.y, length);
        asked++;
        naive += !(fabsf(x * x + y * y - 1) < 1e-3f);
        tuff += !tuff_circle_circle(d, 2, 3, &contact) || !(fabsf(contact.overlap - 5) <= 2e-3f) ||
                !(fabsf(contact.normal.x * contact.normal.x + contact.normal.y * contact.normal.y - 1) < 1e-6f);
    }
    printf("figures: offsets from 1e-3 to 1e-45 without a unit normal: offset / length %.1f %%, tuff %.1f %%\n", percent(naive, asked),
           percent(tuff, asked));
    assert_true(naive > 0);
    assert_int_equal(tuff, 0);
}

static void test_minus_zero_is_zero(void **state)
{
    const float minus = -0.0f;
    scene s;
    (void)state;
    make_scene(&s, (tuff_vec2){ 0, 0 });
    for (int i = 0; i < 2; i++) {
        tuff_contact plus_contact, minus_contact;
        tuff_vec2 plus_at = { 0, i == 0 ? 0 : 10 }, minus_at = { minus, i == 0 ? minus : 10 };
        for (int piece = 0; piece < 2; piece++) {
            memset(&plus_contact, 0, sizeof plus_contact);
            memset(&minus_contact, 0, sizeof minus_contact);
            assert_true(tuff_terrain_overlap_circle(&s.pieces[piece], plus_at, 8, &plus_contact));
            assert_true(tuff_terrain_overlap_circle(&s.pieces[piece], minus_at, 8, &minus_contact));
            assert_true(same_overlap(&plus_contact, &minus_contact));
        }
        tuff_body plus_body = { plus_at, { 0, 0 }, NULL }, minus_body = { minus_at, { minus, minus }, NULL };
        uint16_t pushes = tuff_terrain_collide(&s.world, &plus_body, 8, &s.box.polygon);
        assert_int_equal(tuff_terrain_collide(&s.world, &minus_body, 8, &s.box.polygon), pushes);
        assert_true(same_body(&plus_body, &minus_body));
    }
}
#endif

/* ---- the picture ---- */

#define BANDS 24

static void draw_false_touches(picture_role role)
{
    box2d_polygon *box = box_of_box2d();
    picture_line(role, "");
    for (int band = 0; band < BANDS; band++) {
        double low = 20 * pow(2.0, band * 0.48), high = 20 * pow(2.0, (band + 1) * 0.48);
        far_count count = { 0, 0, 0, 0 };
        random_source source = random_stream(1603, (uint64_t)band);
        for (int i = 0; i < 2000; i++) count_far(&source, box, low, high, &count);
        picture_point(sqrt(low * high), percent(role == PICTURE_FAILS ? count.naive : count.tuff, count.pairs));
    }
    picture_line_end();
    box2d_polygon_free(box);
}

static void draw_far_depths(picture_role role, const char *label)
{
    static const int32_t places[7] = { 500, 1000, 2000, 4000, 8000, 16000, 30000 };
    const random_run run = { "", 1604, 0, 1000 };
    picture_line(role, label);
    for (int i = 0; i < 7; i++) {
        far_figures most = figures_at(&run, places[i]);
        double error = role == PICTURE_TRUTH ? float_step(places[i]) : role == PICTURE_BOX2D ? most.box2d : most.tuff;
        picture_point(places[i], error / EXACT_UNIT);
    }
    picture_line_end();
}

static void draw_picture(void)
{
    if (!picture_begin("numbers")) return;
    picture_chart("Circles apart, told as touching", "distance, units", "log", "of the pairs, %", "linear");
    draw_false_touches(PICTURE_FAILS);
    draw_false_touches(PICTURE_TUFF);
    picture_chart("Depth error far from the origin", "distance from the origin, units", "log", "largest error, units", "log");
    draw_far_depths(PICTURE_TUFF, "");
    draw_far_depths(PICTURE_BOX2D, "");
    draw_far_depths(PICTURE_TRUTH, "one step of a float position");
    picture_end();
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_distances_of_181_to_65535_units_never_touch),
        cmocka_unit_test(test_opposite_ends_of_the_range_do_not_touch),
        cmocka_unit_test(test_beams_from_end_to_end_of_the_range_hit_what_lies_on_them),
        cmocka_unit_test(test_contacts_at_every_end_of_the_range_are_those_of_the_origin),
        cmocka_unit_test(test_a_push_over_the_edge_of_the_range_stops_there),
        cmocka_unit_test(test_offsets_under_256_LSB_keep_their_direction),
        cmocka_unit_test(test_edges_under_256_LSB_have_normals),
        cmocka_unit_test(test_overlaps_of_1_LSB_are_seen_and_gaps_of_1_LSB_are_not),
        cmocka_unit_test(test_bumpers_end_at_the_speed_limit_and_never_turn_round),
        cmocka_unit_test(test_bounces_at_the_limit_follow_the_formula),
        cmocka_unit_test(test_depths_far_from_the_origin_are_those_of_the_origin),
        cmocka_unit_test(test_pushes_of_half_a_step_of_position_move_a_body),
        cmocka_unit_test(test_bodies_rest_far_from_the_origin),
        cmocka_unit_test(test_bits_of_NaN_and_infinity_touch_nothing),
#if TUFF_SCALAR == TUFF_FLOAT
        cmocka_unit_test(test_offsets_too_small_to_square_still_part),
        cmocka_unit_test(test_minus_zero_is_zero),
#endif
    };
    (void)argc;
    random_begin(argv);
    table_family(6, "Numbers");
    draw_picture();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
