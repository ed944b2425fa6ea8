/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Family 12, far cry from convex: outlines that are an L, a star, a crescent and a ring, cut into convex parts, and a circle
   and a hull at places all over them. What is empty must not block, what is full must not be entered, and a push must not lead
   through the rock. */
#include "handed.h"
#include "naive.h"
#include "picture.h"
#include "pieces.h"
#include "same.h"
#include "table.h"
#include "way_out.h"

#define SIZE        48.0            /* units that each outline reaches from its middle */
#define FIELD       64.0            /* bodies are placed within this square about it */
#define BODY        5.0             /* radius of the circle, and about the hull's; every pocket has room for it */
#define LONG_WAY    3.0             /* times the shortest way out: the bound of tests/host/test_concave.c */
#define MOST_CALLS  10
#define WEDGED      20              /* at most one of so many may be in a narrow notch after ten calls */
#define BOX2D_STEPS 120             /* two seconds: Box2D pushes out a fifth of an overlap each step */
#define BOX2D_SLOP  0.16            /* what Box2D leaves of an overlap on purpose */

/* touching: next to it both yes and no are right. left_over: what several pushes may leave of an overlap, one residue for each
   of two walls. */
#if TUFF_SCALAR == TUFF_Q16_16
static const double touching = 1.0 / 65536.0, left_over = 4.0 / 65536.0;
#else
static const double touching = 1e-4, left_over = 4e-4;
#endif

enum { ELL, STAR, CRESCENT, RING, OUTLINES };

typedef struct scene_pocket {       /* not to be copied: it points into itself */
    rock          made;
    random_shape  hull_shape, around;      /* around: the convex hull of the outline */
    tuff_terrain  piece;
    tuff_real     radius;
    const tuff_polygon *hull;              /* NULL: the circle */
    way_forbidden forbidden, bare;         /* to the body; to its middle */
} scene_pocket;

static const tuff_vec2 origin = { 0, 0 };

/* ---- the outlines ---- */

static rock_point at_angle(double turned, double radius)
{
    return (rock_point){ (int32_t)floor(cos(turned) * radius * ROCK_GRID + 0.5), (int32_t)floor(sin(turned) * radius * ROCK_GRID + 0.5) };
}

static int ell_points(rock_point *points)
{
    static const int8_t corners[6][2] = { { -32, -32 }, { 40, -32 }, { 40, -10 }, { -10, -10 }, { -10, 40 }, { -32, 40 } };
    for (int i = 0; i < 6; i++) points[i] = (rock_point){ corners[i][0] * ROCK_GRID, corners[i][1] * ROCK_GRID };
    return 6;
}

static int star_points(rock_point *points)
{
    for (int i = 0; i < 10; i++) points[i] = at_angle(TURN * (i + 0.3) / 10, i % 2 ? SIZE * 0.4 : SIZE);
    return 10;
}

/* Open to the right. */
static int crescent_points(rock_point *points)
{
    for (int i = 0; i < 9; i++) points[i] = at_angle(0.9 + (TURN - 1.8) * i / 8, SIZE);
    for (int i = 1; i < 8; i++) {
        double along = i / 4.0 - 1.0;
        points[8 + i] = at_angle(TURN - 0.9 - (TURN - 1.8) * i / 8, SIZE * (1.0 - 0.45 * (1.0 - along * along)));
    }
    return 16;
}

/* Eight trapezoids; no simple outline. */
static void make_ring(rock *made)
{
    const double hole = SIZE * 0.6;
    made->part_count = 8;
    for (int i = 0; i < 8; i++) {
        rock_point corners[4] = { at_angle(TURN * i / 8, SIZE), at_angle(TURN * (i + 1) / 8, SIZE),
                                  at_angle(TURN * (i + 1) / 8, hole), at_angle(TURN * i / 8, hole) };
        for (int k = 0; k < 4; k++) {
            made->vertices[i][k] = (tuff_vec2){ TUFF_RATIO(corners[k].x, ROCK_GRID), TUFF_RATIO(corners[k].y, ROCK_GRID) };
        }
        tuff_edge_normals(made->vertices[i], 4, made->normals[i]);
        made->parts[i] = (tuff_polygon){ made->vertices[i], made->normals[i], 2 | 8, 4 };
    }
    made->bounding_radius = TUFF_WHOLE((int)SIZE + 1);
}

static void make_rock(rock *made, int outline)
{
    rock_point points[ROCK_MAX_POINTS];
    random_source source = random_stream(1, (uint64_t)outline);
    if (outline == RING) {
        make_ring(made);
        return;
    }
    int count = outline == ELL ? ell_points(points) : outline == STAR ? star_points(points) : crescent_points(points);
    assert_true(rock_from_outline(&source, made, points, count, 100));
}

/* ---- a body at it ---- */

static bool is_among(const tuff_vec2 *points, int count, tuff_vec2 point)
{
    for (int i = 0; i < count; i++) {
        if (same_point(points[i], point)) return true;
    }
    return false;
}

static void wrap_around(scene_pocket *p)
{
    tuff_vec2 all[TUFF_MAX_VERTICES], hull[TUFF_MAX_VERTICES + 2];
    int count = 0;
    for (int i = 0; i < p->made.part_count; i++) {
        for (int k = 0; k < p->made.parts[i].count && count < TUFF_MAX_VERTICES; k++) {
            if (!is_among(all, count, p->made.vertices[i][k])) all[count++] = p->made.vertices[i][k];
        }
    }
    count = random_hull_of(all, count, hull);
    for (int i = 0; i < count; i++) p->around.vertices[i] = hull[i];
    random_bake(&p->around, count);
}

static void give_body(scene_pocket *p, bool with_hull)
{
    static const double corners[5][2] = { { 6, 0 }, { -1.5, 4 }, { -5, 3 }, { -5, -3 }, { -1.5, -4 } };
    for (int i = 0; i < 5; i++) p->hull_shape.vertices[i] = random_point_at(corners[i][0], corners[i][1]);
    random_bake(&p->hull_shape, 5);
    p->hull = with_hull ? &p->hull_shape.polygon : NULL;
    p->radius = with_hull ? p->hull_shape.bounding_radius : TUFF_WHOLE((int)BODY);
    way_forbid(&p->forbidden, &p->made, units_of(p->radius), p->hull);
    way_forbid(&p->bare, &p->made, 0.0, NULL);
}

static void make_pocket(scene_pocket *p, int outline, bool with_hull)
{
    make_rock(&p->made, outline);
    p->piece = rock_terrain(&p->made, random_point_at(300.25, -117.5));
    assert_int_equal(tuff_check_terrain(&p->piece), TUFF_OK);
    give_body(p, with_hull);
    wrap_around(p);
}

static way_point offset_of(const scene_pocket *p, tuff_vec2 position)
{
    return way_between(way_point_of(position), way_point_of(p->piece.position));
}

static tuff_vec2 world_of(const scene_pocket *p, double x, double y)
{
    tuff_vec2 offset = random_point_at(x, y);
    return (tuff_vec2){ p->piece.position.x + offset.x, p->piece.position.y + offset.y };
}

static double clearance(const scene_pocket *p, tuff_vec2 position)
{
    return way_clearance(&p->forbidden, offset_of(p, position));
}

static bool overlaps(const scene_pocket *p, tuff_vec2 position)
{
    tuff_contact contact;
    return p->hull ? tuff_terrain_overlap_hull(&p->piece, position, p->radius, p->hull, &contact)
                   : tuff_terrain_overlap_circle(&p->piece, position, p->radius, &contact);
}

/* A collide call by some method. */
typedef void pusher(const scene_pocket *p, tuff_body *body);

static void push_out(const scene_pocket *p, tuff_body *body)
{
    const tuff_world world = plain_world(&p->piece, 1, TUFF_ORDER_DEEPEST);
    tuff_terrain_collide(&world, body, p->radius, p->hull);
}

static void push_out_naively(const scene_pocket *p, tuff_body *body)
{
    naive_collide(&p->piece, 1, body, p->radius, p->hull);
}

static way_point normal_of(const tuff_polygon *part, int edge)
{
    return (way_point){ (double)exact_unit(part->normals[edge].x), (double)exact_unit(part->normals[edge].y) };
}

/* How far beyond the line of an edge the body is: negative, so deep. */
static double beyond(const scene_pocket *p, const tuff_polygon *part, int edge, way_point at)
{
    way_point n = normal_of(part, edge);
    double least = p->hull ? HUGE_VAL : -units_of(p->radius);
    for (int i = 0; p->hull && i < p->hull->count; i++) least = fmin(least, way_dot(n, way_point_of(p->hull->vertices[i])));
    return way_dot(n, way_between(at, way_point_of(part->vertices[edge]))) + least;
}

/* Marks taken literally: each overlapped part pushes along its least outline edge, whatever the others say. */
static void push_out_by_marks_alone(const scene_pocket *p, tuff_body *body)
{
    for (int k = 0; k < p->made.part_count; k++) {
        const tuff_polygon *part = &p->made.parts[k];
        double best = -HUGE_VAL, separation = -HUGE_VAL;
        int edge = 0;
        for (int i = 0; i < part->count; i++) {
            double gap = beyond(p, part, i, offset_of(p, body->position));
            if (gap > separation) separation = gap;
            if ((part->internal_edges >> i & 1) || gap <= best) continue;
            best = gap;
            edge = i;
        }
        if (separation >= 0 || best == -HUGE_VAL) continue;
        way_point at = offset_of(p, body->position), n = normal_of(part, edge);
        body->position = world_of(p, at.x - best * n.x, at.y - best * n.y);
    }
}

/* ---- Box2D's side ---- */

static tuff_terrain piece_at_origin(const scene_pocket *p)
{
    tuff_terrain here = p->piece;
    here.position = origin;
    return here;
}

/* The rock about the origin, and one body, number 0. NULL: Box2D does not take one of the shapes. */
static yardstick *yard_of(const scene_pocket *p)
{
    const yardstick_state nowhere = { { 500, 500 }, { 0, 0 } };
    const yardstick_material smooth = { 0, 0 };
    const tuff_terrain here = piece_at_origin(p);
    yardstick *yard = yardstick_new((yardstick_vec){ 0, 0 }, true);
    bool taken = yard_add_piece(yard, &here);
    int body = p->hull ? yard_add_hull(yard, nowhere, p->hull, smooth)
                       : yardstick_add_ball(yard, nowhere, units_of(p->radius), smooth);
    if (taken && body == 0) return yard;
    yardstick_free(yard);
    return NULL;
}

/* Where Box2D has the body after so many steps, or once it is out; *steps: how many. */
static way_point box2d_out(const scene_pocket *p, yardstick *yard, way_point from, int *steps)
{
    way_point at = from;
    yardstick_set(yard, 0, (yardstick_state){ { from.x, from.y }, { 0, 0 } });
    for (*steps = 0; *steps < BOX2D_STEPS && way_clearance(&p->forbidden, at) < -BOX2D_SLOP; ++*steps) {
        yardstick_step(yard);
        yardstick_vec now = yardstick_body(yard, 0).position;
        at = (way_point){ now.x, now.y };
    }
    return at;
}

/* ---- what is empty and what is full ---- */

typedef struct tally { uint32_t places, empty, wrong, hull_wrong, circle_wrong, box2d_wrong; double band; } tally;

static bool convex_hull_blocks(const scene_pocket *p, tuff_vec2 position)
{
    tuff_contact contact;
    tuff_vec2 offset = { position.x - p->piece.position.x, position.y - p->piece.position.y };
    return p->hull ? tuff_polygon_polygon(p->hull, offset, &p->around.polygon, &contact)
                   : tuff_circle_polygon(offset, p->radius, &p->around.polygon, &contact);
}

typedef struct box2d_parts { box2d_polygon *parts[ROCK_MAX_PARTS], *hull; } box2d_parts;

static box2d_parts box2d_parts_of(const scene_pocket *p)
{
    box2d_parts all = { { NULL }, box2d_of(&p->hull_shape.polygon) };
    for (int i = 0; i < p->made.part_count; i++) all.parts[i] = box2d_of(&p->made.parts[i]);
    return all;
}

static void free_parts(const scene_pocket *p, box2d_parts *all)
{
    for (int i = 0; i < p->made.part_count; i++) box2d_polygon_free(all->parts[i]);
    box2d_polygon_free(all->hull);
}

static bool box2d_blocks(const scene_pocket *p, const box2d_parts *all, way_point at)
{
    const box2d_vec nowhere = { 0, 0 };
    box2d_vec place = { (float)at.x, (float)at.y };
    for (int i = 0; i < p->made.part_count; i++) {
        if (p->hull ? box2d_hull_touches(all->parts[i], nowhere, all->hull, place)
                    : box2d_circle_touches(all->parts[i], nowhere, place, tuff_to_float(p->radius))) return true;
    }
    return false;
}

/* Is this answer wrong at a place with so much clearance, beyond what next to touching is granted? */
static bool is_wrong(bool blocked, double clear)
{
    return blocked ? clear > touching : clear < -touching;
}

static bool judge_place(const scene_pocket *p, tuff_vec2 position, tally *sum)
{
    double clear = clearance(p, position);
    bool blocked = overlaps(p, position), wrong = is_wrong(blocked, clear);
    sum->places++;
    if (wrong) sum->wrong++;
    if (blocked == (clear >= 0) && fabs(clear) > sum->band) sum->band = fabs(clear);
    return !wrong;
}

static void judge_others(const scene_pocket *p, const box2d_parts *box, tuff_vec2 position, tally *sum)
{
    double clear = clearance(p, position);
    way_point at = offset_of(p, position);
    if (is_wrong(box2d_blocks(p, box, at), clear)) sum->box2d_wrong++;
    if (clear <= touching) return;
    sum->empty++;
    if (convex_hull_blocks(p, position)) sum->hull_wrong++;
    if (hypot(at.x, at.y) < SIZE + units_of(p->radius)) sum->circle_wrong++;
}

#define ROWS    96
#define COLUMNS 96

static tuff_vec2 place_in_row(random_source *source, const scene_pocket *p, uint32_t row, int column)
{
    double x = -FIELD + 2 * FIELD * (column + random_fraction(source)) / COLUMNS;
    return world_of(p, x, -FIELD + 2 * FIELD * (row % ROWS + random_fraction(source)) / ROWS);
}

/* Case: one row of the field of one outline and body. */
static int outline_of(uint32_t index)    { return (int)(index / ROWS % OUTLINES); }
static bool hull_of(uint32_t index)      { return index / ROWS / OUTLINES % 2 != 0; }

/* Rows in an order that spreads those of a short run over all outlines; the stride, a prime, passes each once. */
static uint32_t spread(uint32_t i)
{
    return (uint32_t)((uint64_t)i * 8191 % (2 * OUTLINES * ROWS));
}

static void test_all_that_is_empty_is_free_and_all_that_is_full_is_not(void **state)
{
    static scene_pocket p;
    tally sum = { 0 };
    random_run run = random_cases(__func__, 1201, 2 * OUTLINES * ROWS);
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        uint32_t row = spread(i);
        make_pocket(&p, outline_of(row), hull_of(row));
        box2d_parts box = box2d_parts_of(&p);
        for (int column = 0; column < COLUMNS; column++) {
            tuff_vec2 place = place_in_row(&source, &p, row, column);
            if (!judge_place(&p, place, &sum)) random_fail(&run, i, "wrong in column %d: %g units clear", column, clearance(&p, place));
            judge_others(&p, &box, place, &sum);
        }
        free_parts(&p, &box);
    }
    print_message("figures: " EXACT_BUILD " %lu places, %lu of them empty: wrong by the convex hull %lu, by the bounding circle %lu, "
                  "by Box2D %lu, by tuff %lu (nowhere farther than %.2f LSB from touching)\n", (unsigned long)sum.places,
                  (unsigned long)sum.empty, (unsigned long)sum.hull_wrong, (unsigned long)sum.circle_wrong,
                  (unsigned long)sum.box2d_wrong, (unsigned long)sum.wrong, sum.band * EXACT_UNIT);
    table_row("empty places that block, share");
    table_fails("convex hull", "%.0f %%", 100.0 * sum.hull_wrong / sum.empty);
    table_box2d("%.0f %%", 100.0 * sum.box2d_wrong / sum.empty);
    table_tuff("%.0f %%", 100.0 * sum.wrong / sum.empty);
    assert_true(sum.hull_wrong > sum.empty / 10 && sum.circle_wrong > sum.hull_wrong);
}

/* ---- touching, to the last bit ---- */

/* On the way from a free place to a blocked one, to within a thousandth of a step. */
static way_point border_between(const scene_pocket *p, way_point free_place, way_point blocked)
{
    for (int i = 0; i < 40; i++) {
        way_point middle = { (free_place.x + blocked.x) / 2, (free_place.y + blocked.y) / 2 };
        if (way_clearance(&p->forbidden, middle) >= 0) free_place = middle;
        else blocked = middle;
    }
    return free_place;
}

static way_point random_place(random_source *source, const scene_pocket *p, bool free_place)
{
    for (;;) {
        way_point at = { random_within(source, -FIELD, FIELD), random_within(source, -FIELD, FIELD) };
        if ((way_clearance(&p->forbidden, at) >= 0) == free_place) return at;
    }
}

static void test_a_step_before_touching_is_free_and_a_step_behind_it_is_not(void **state)
{
    static scene_pocket p;
    tally sum = { 0 };
    random_run run = random_cases(__func__, 1202, 12000);
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        make_pocket(&p, (int)(i % OUTLINES), i / OUTLINES % 2 != 0);
        way_point from = random_place(&source, &p, true), to = random_place(&source, &p, false);
        way_point border = border_between(&p, from, to), way = way_between(to, from);
        double step = 1.0 / EXACT_UNIT / hypot(way.x, way.y);
        for (int k = -3; k <= 3; k++) {
            tuff_vec2 place = world_of(&p, border.x + k * step * way.x, border.y + k * step * way.y);
            if (judge_place(&p, place, &sum)) continue;
            random_fail(&run, i, "wrong %d steps behind touching: %g units clear", k, clearance(&p, place));
        }
    }
    print_message("figures: " EXACT_BUILD " %lu places within 3 LSB of touching: none answered wrongly farther than %.2f LSB from it\n",
                  (unsigned long)sum.places, sum.band * EXACT_UNIT);
    table_row("farthest from touching that yes/no is wrong, LSB");
    table_tuff("%.2f", sum.band * EXACT_UNIT);
}

/* ---- the way out ---- */

typedef struct outs {
    double   shallow;               /* depth up to which the first call's way is compared with the shortest one */
    uint32_t placed, compared, far, after[MOST_CALLS + 1];
    double   worst;                 /* the way by the shortest way */
} outs;

static bool is_out(const scene_pocket *p, way_point at, double slack)
{
    return way_clearance(&p->forbidden, at) >= -slack;
}

static void add_way(outs *sum, double way, double least)
{
    sum->compared++;
    if (way / least > sum->worst) sum->worst = way / least;
    if (way > LONG_WAY * least + left_over) sum->far++;
}

/* Calls until the body is out, at most MOST_CALLS. */
static void count_calls(const scene_pocket *p, tuff_vec2 place, pusher *push, outs *sum)
{
    tuff_body body = body_at(place);
    way_point from = offset_of(p, place);
    bool shallow = way_clearance(&p->forbidden, from) >= -sum->shallow;
    sum->placed++;
    for (int call = 1; call <= MOST_CALLS && !is_out(p, offset_of(p, body.position), left_over); call++) {
        push(p, &body);
        if (call == 1 && shallow) add_way(sum, way_length(offset_of(p, body.position), from), way_shortest(&p->forbidden, from));
        if (!is_out(p, offset_of(p, body.position), left_over)) sum->after[call]++;
    }
}

static void count_box2d(const scene_pocket *p, yardstick *yard, tuff_vec2 place, outs *sum)
{
    int steps;
    way_point from = offset_of(p, place), to = box2d_out(p, yard, from, &steps);
    bool shallow = way_clearance(&p->forbidden, from) >= -sum->shallow;
    sum->placed++;
    if (shallow && way_clearance(&p->forbidden, from) < -BOX2D_SLOP) add_way(sum, way_length(to, from), way_shortest(&p->forbidden, from));
    if (steps > 1) sum->after[1]++;
    if (!is_out(p, to, BOX2D_SLOP)) sum->after[MOST_CALLS]++;
}

static void print_outs(const char *who, const outs *sum)
{
    print_message("figures: " EXACT_BUILD " %s: %lu bodies in the rock, inside after 1, 2, 5, 10 calls: %lu, %lu, %lu, %lu; of %lu "
                  "shallow ones %lu went more than %g times the shortest way, at worst %.2f times\n", who, (unsigned long)sum->placed,
                  (unsigned long)sum->after[1], (unsigned long)sum->after[2], (unsigned long)sum->after[5],
                  (unsigned long)sum->after[10], (unsigned long)sum->compared, (unsigned long)sum->far, LONG_WAY, sum->worst);
}

static void write_inside_row(const char *measure, const outs *naive, const outs *box, const outs *tuff)
{
    table_row(measure);
    table_fails("textbook", "%.1f %%", 100.0 * naive->after[MOST_CALLS] / naive->placed);
    table_box2d("%.1f %%", 100.0 * box->after[MOST_CALLS] / box->placed);
    table_tuff("%.1f %%", 100.0 * tuff->after[MOST_CALLS] / tuff->placed);
}

/* Shallow: the middle of the body is outside. */
static void test_bodies_leave_every_outline_by_a_short_way(void **state)
{
    static scene_pocket p;
    outs naive = { .shallow = BODY }, box = naive, tuff = naive;
    random_run run = random_cases(__func__, 1203, 2 * OUTLINES * ROWS);
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        uint32_t row = spread(i), before = tuff.after[2] + tuff.far;
        make_pocket(&p, outline_of(row), hull_of(row));
        yardstick *yard = yard_of(&p);
        assert_non_null(yard);
        for (int column = 0; column < COLUMNS; column++) {
            tuff_vec2 place = place_in_row(&source, &p, row, column);
            if (clearance(&p, place) >= -left_over) continue;
            count_calls(&p, place, push_out, &tuff);
            if (column % 4 != 0) continue;
            count_calls(&p, place, push_out_naively, &naive);
            count_box2d(&p, yard, place, &box);
        }
        yardstick_free(yard);
        if (tuff.after[2] + tuff.far > before) random_fail(&run, i, "a body was left inside by two calls, or went out the long way round");
    }
    print_outs("textbook", &naive);
    print_outs("Box2D (1 step, 120 steps)", &box);
    print_outs("tuff", &tuff);
    write_inside_row("inside after 10 calls (Box2D: 2 s)", &naive, &box, &tuff);
    assert_true(naive.after[MOST_CALLS] > naive.placed / 50);
}

/* At the border of a random rock, up to a fifth of the body's radius inside. */
static way_point grazing_place(random_source *source, const scene_pocket *p)
{
    way_point from = random_place(source, p, true), to = random_place(source, p, false);
    way_point border = border_between(p, from, to), way = way_between(to, from);
    double in = units_of(p->radius) * random_magnitude(source, 1e-3, 0.2) / hypot(way.x, way.y);
    return (way_point){ border.x + in * way.x, border.y + in * way.y };
}

static void random_pocket(random_source *source, scene_pocket *p)
{
    double size = random_magnitude(source, 1.0, SIZE / 2);
    rock_make(source, &p->made, (int)random_below(source, ROCK_KINDS), SIZE);
    p->piece = rock_terrain(&p->made, random_point_at(300.25, -117.5));
    random_rock_shape(source, &p->hull_shape, 8, size);
    p->hull = random_chance(source, 50) ? &p->hull_shape.polygon : NULL;
    p->radius = p->hull ? p->hull_shape.bounding_radius : random_point_at(size, 0).x;
    way_forbid(&p->forbidden, &p->made, units_of(p->radius), p->hull);
}

static void test_grazing_bodies_leave_random_outlines_by_a_short_way(void **state)
{
    static scene_pocket p;
    outs marks = { .shallow = SIZE }, box = marks, tuff = marks;
    random_run run = random_cases(__func__, 1207, 4000);
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        uint32_t before = tuff.far;
        random_pocket(&source, &p);
        way_point at = grazing_place(&source, &p);
        tuff_vec2 place = world_of(&p, at.x, at.y);
        if (clearance(&p, place) >= -left_over) continue;
        count_calls(&p, place, push_out, &tuff);
        count_calls(&p, place, push_out_by_marks_alone, &marks);
        yardstick *yard = i % 4 == 0 ? yard_of(&p) : NULL;
        if (yard) count_box2d(&p, yard, place, &box);
        if (yard) yardstick_free(yard);
        if (tuff.far > before) random_fail(&run, i, "a grazing body went out the long way round");
    }
    print_outs("marks alone, random outlines", &marks);
    print_outs("Box2D (1 step, 120 steps), random outlines", &box);
    print_outs("tuff, random outlines", &tuff);
    table_row("grazing: pushed over 3 times the shortest way out");
    table_fails("marks alone", "%.1f %%", 100.0 * marks.far / marks.compared);
    table_box2d("%.1f %%", 100.0 * box.far / box.compared);
    table_tuff("%.1f %%", 100.0 * tuff.far / tuff.compared);
    if (tuff.placed > 2000) assert_true(marks.far > 0);
}

/* ---- sliding ---- */

#define SLIDE_STEPS 2000
#define PULL        (1.0 / 16)      /* units a step, each step */
#define FASTEST     4.0             /* units a step: less than the radius */

typedef struct slides { uint32_t steps, touching, inside, far; double deepest; } slides;

static void limit_speed(tuff_body *body)
{
    double speed = body_speed(body);
    if (speed <= FASTEST) return;
    body->velocity = random_point_at(units_of(body->velocity.x) * FASTEST / speed, units_of(body->velocity.y) * FASTEST / speed);
}

/* Did the middle go through rock on its straight way from a to b? */
static bool went_through(const scene_pocket *p, way_point a, way_point b)
{
    for (int i = 0; i <= 8; i++) {
        way_point at = { a.x + (b.x - a.x) * i / 8, a.y + (b.y - a.y) * i / 8 };
        if (way_clearance(&p->bare, at) < 0) return true;
    }
    return false;
}

static void slide_a_step(const scene_pocket *p, tuff_body *body, pusher *push, slides *sum)
{
    way_point before = offset_of(p, body->position);
    double speed = body_speed(body);
    body_fall(body, origin);
    way_point moved = offset_of(p, body->position);
    push(p, body);
    way_point after = offset_of(p, body->position);
    double clear = way_clearance(&p->forbidden, after);
    sum->steps++;
    if (after.x != moved.x || after.y != moved.y) sum->touching++;
    if (clear < -left_over) sum->inside++;
    if (-clear > sum->deepest) sum->deepest = -clear;
    if (way_length(after, moved) > LONG_WAY * speed + left_over || went_through(p, before, after)) sum->far++;
}

/* From a free place, pulled to the middle of the rock as it was seen from there, and thrown about every 200 steps. Ends when
   the body has left. */
static void slide(random_source *source, const scene_pocket *p, pusher *push, slides *sum)
{
    way_point start = random_place(source, p, true);
    double far = hypot(start.x, start.y), x = -start.x / far * PULL, y = -start.y / far * PULL;
    tuff_body body = body_at(world_of(p, start.x, start.y));
    for (int step = 0; step < SLIDE_STEPS; step++) {
        way_point at = offset_of(p, body.position);
        tuff_vec2 pull = step % 200 ? random_point_at(x, y) : random_point(source, 2.0);
        body.velocity.x += pull.x;
        body.velocity.y += pull.y;
        limit_speed(&body);
        if (hypot(at.x, at.y) > 2 * FIELD - BODY) return;
        slide_a_step(p, &body, push, sum);
    }
}

static void test_bodies_slide_in_the_pockets_and_never_through_the_rock(void **state)
{
    static scene_pocket p;
    slides naive = { 0 }, tuff = { 0 };
    random_run run = random_cases(__func__, 1204, 240);
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i), again = source;
        uint32_t before = tuff.inside + tuff.far;
        make_pocket(&p, (int)(i % OUTLINES), i / OUTLINES % 2 != 0);
        slide(&source, &p, push_out, &tuff);
        slide(&again, &p, push_out_naively, &naive);
        if (tuff.inside + tuff.far > before) random_fail(&run, i, "deepest %g: %lu steps inside, %lu through the rock", tuff.deepest,
                                                         (unsigned long)tuff.inside, (unsigned long)tuff.far);
    }
    print_message("figures: " EXACT_BUILD " sliding: tuff %lu steps, %lu touching, deepest after a step %.2f LSB; textbook %lu steps, "
                  "%lu inside, %lu through the rock or pushed too far\n", (unsigned long)tuff.steps, (unsigned long)tuff.touching,
                  tuff.deepest * EXACT_UNIT, (unsigned long)naive.steps, (unsigned long)naive.inside, (unsigned long)naive.far);
    table_row("sliding: steps that end in the rock");
    table_fails("textbook", "%.1f %%", 100.0 * naive.inside / naive.steps);
    table_tuff("%.1f %%", 100.0 * tuff.inside / tuff.steps);
    if (tuff.steps < 50000) return;
    assert_true(tuff.touching > tuff.steps / 10);
    assert_true(naive.inside > naive.steps / 1000);
}

/* ---- inner parts ---- */

static bool in_inner_parts_only(const scene_pocket *p, way_point at)
{
    way_forbidden one = { .count = 1, .radius = p->forbidden.radius };
    bool any = false;
    for (int k = 0; k < p->made.part_count; k++) {
        const tuff_polygon *part = &p->made.parts[k];
        one.counts[0] = p->forbidden.counts[k];
        for (int i = 0; i < one.counts[0]; i++) one.corners[0][i] = p->forbidden.corners[k][i];
        if (way_clearance(&one, at) >= 0) continue;
        if (part->internal_edges != (uint32_t)((UINT64_C(1) << part->count) - 1)) return false;
        any = true;
    }
    return any;
}

/* Small enough for the textbook, which cannot hold squares of more than 181 units. */
static void star_with_a_core(random_source *source, scene_pocket *p)
{
    rock_make(source, &p->made, random_chance(source, 50) ? ROCK_STAR : ROCK_SPIKES, 90.0);
    p->piece = rock_terrain(&p->made, random_point_at(300.25, -117.5));
    give_body(p, random_chance(source, 50));
}

/* The core of a star has no outline of its own: pushes out of its parts by their least axes lead to and fro. A few bodies come
   out into a notch that is a wedge for them, where ten calls do not suffice. */
static void test_bodies_in_inner_parts_only_find_a_way_out(void **state)
{
    static scene_pocket p;
    random_run run = random_cases(__func__, 1205, 8000);
    outs naive = { 0 }, box = { 0 }, tuff = { 0 };
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        star_with_a_core(&source, &p);
        way_point at = { random_within(&source, -45, 45), random_within(&source, -45, 45) };
        if (!in_inner_parts_only(&p, at)) continue;
        tuff_vec2 place = world_of(&p, at.x, at.y);
        count_calls(&p, place, push_out, &tuff);
        count_calls(&p, place, push_out_naively, &naive);
        yardstick *yard = yard_of(&p);
        if (yard) count_box2d(&p, yard, place, &box);
        if (yard) yardstick_free(yard);
    }
    print_outs("textbook, in inner parts", &naive);
    print_outs("Box2D (1 step, 120 steps), in inner parts", &box);
    print_outs("tuff, in inner parts", &tuff);
    write_inside_row("from inner parts: inside after 10 calls (Box2D: 2 s)", &naive, &box, &tuff);
    if (tuff.placed < 400) return;
    assert_true(tuff.after[MOST_CALLS] * WEDGED < tuff.placed && naive.after[MOST_CALLS] * 10 > naive.placed);
}

/* ---- what cannot be solved ---- */

/* Each push out of one wall leads into the other; pushes do not see that the way out is through the rock. */
static void test_a_ring_whose_hole_is_narrower_than_the_body_keeps_it_in_the_hole(void **state)
{
    static scene_pocket p;
    random_run run = random_cases(__func__, 1206, 400);
    uint32_t kept = 0, tried = 0;
    (void)state;
    make_pocket(&p, RING, false);
    p.radius = TUFF_WHOLE(30);
    way_forbid(&p.forbidden, &p.made, 30.0, NULL);
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        tuff_body body = body_at(world_of(&p, random_within(&source, -6, 6), random_within(&source, -6, 6)));
        for (int call = 0; call < 100; call++) push_out(&p, &body);
        way_point at = offset_of(&p, body.position);
        tried++;
        if (!is_out(&p, at, left_over)) kept++;
        if (hypot(at.x, at.y) > 12.0) random_fail(&run, i, "thrown to %g, %g", at.x, at.y);
    }
    print_message("figures: " EXACT_BUILD " a circle of radius 30 in a hole of 26.6 to 28.8: %lu of %lu still there after 100 calls\n",
                  (unsigned long)kept, (unsigned long)tried);
    assert_int_equal(kept, tried);
}

/* ---- the picture ---- */

static void draw_rock(const scene_pocket *p)
{
    tuff_terrain here = piece_at_origin(p);
    picture_piece(&here);
}

static void draw_body(const scene_pocket *p, picture_role role, way_point at)
{
    tuff_vec2 place = random_point_at(at.x, at.y);
    if (p->hull) picture_polygon(role, p->hull, place);
    else picture_circle(role, place, p->radius);
}

static void draw_arrow(picture_role role, way_point from, way_point to)
{
    picture_arrow(role, from.x, from.y, to.x, to.y);
}

static void panel(const char *title)
{
    picture_panel(title, -60, -54, 60, 54);
}

static void draw_blocked(scene_pocket *p)
{
    panel("Empty, but a convex hull blocks");
    make_pocket(p, CRESCENT, false);
    draw_rock(p);
    picture_polygon(PICTURE_FAILS, &p->around.polygon, origin);
    for (int i = 0; i < 64 * 64; i++) {
        way_point at = { -55 + 110 * (i % 64 + 0.5) / 64, -55 + 110 * (i / 64 + 0.5) / 64 };
        tuff_vec2 place = world_of(p, at.x, at.y);
        if (i % 64 % 3 != 0 || i / 64 % 3 != 0 || overlaps(p, place)) continue;
        if (convex_hull_blocks(p, place)) picture_dot(PICTURE_FAILS, at.x, at.y);
    }
    draw_body(p, PICTURE_BODY, (way_point){ 12, 0 });
}

static void draw_push(scene_pocket *p, way_point from)
{
    tuff_body ours = body_at(world_of(p, from.x, from.y)), theirs = ours;
    push_out(p, &ours);
    push_out_by_marks_alone(p, &theirs);
    draw_body(p, PICTURE_BODY, from);
    draw_body(p, PICTURE_FAILS, offset_of(p, theirs.position));
    draw_arrow(PICTURE_FAILS, from, offset_of(p, theirs.position));
    draw_body(p, PICTURE_TUFF, offset_of(p, ours.position));
    draw_arrow(PICTURE_TUFF, from, offset_of(p, ours.position));
}

/* The grazing place from which marks alone push the farthest. */
static way_point worst_for_marks_alone(scene_pocket *p)
{
    way_point worst = { 0, 0 };
    double most = 0;
    for (int i = 0; i < 128 * 128; i++) {
        way_point at = { -50 + 100 * (i % 128 + 0.5) / 128, -50 + 100 * (i / 128 + 0.5) / 128 };
        tuff_body body = body_at(world_of(p, at.x, at.y));
        double clear = clearance(p, body.position);
        if (clear > -0.3 || clear < -BODY / 5) continue;
        push_out_by_marks_alone(p, &body);
        double way = way_length(offset_of(p, body.position), at);
        if (way <= most) continue;
        most = way;
        worst = at;
    }
    return worst;
}

static void draw_line(picture_role role, const way_point *path, int count)
{
    picture_line(role, NULL);
    for (int i = 0; i < count; i++) picture_point(path[i].x, path[i].y);
    picture_line_end();
}

static void draw_ways_out(scene_pocket *p, way_point from)
{
    way_point path[BOX2D_STEPS + 1] = { from };
    yardstick *yard = yard_of(p);
    tuff_body body = body_at(world_of(p, from.x, from.y));
    yardstick_set(yard, 0, (yardstick_state){ { from.x, from.y }, { 0, 0 } });
    for (int i = 1; i <= BOX2D_STEPS; i++) {
        yardstick_step(yard);
        path[i] = (way_point){ yardstick_body(yard, 0).position.x, yardstick_body(yard, 0).position.y };
    }
    yardstick_free(yard);
    draw_body(p, PICTURE_BODY, from);
    draw_line(PICTURE_BOX2D, path, BOX2D_STEPS + 1);
    draw_body(p, PICTURE_BOX2D, path[BOX2D_STEPS]);
    push_out(p, &body);
    draw_body(p, PICTURE_TUFF, offset_of(p, body.position));
    draw_arrow(PICTURE_TUFF, from, offset_of(p, body.position));
}

static void draw_picture(void)
{
    static scene_pocket p;
    if (!picture_begin("pockets")) return;
    draw_blocked(&p);
    panel("Grazing: where one call leaves it");
    make_pocket(&p, CRESCENT, false);
    draw_rock(&p);
    draw_push(&p, worst_for_marks_alone(&p));
    panel("In the core: the way out");
    make_pocket(&p, STAR, true);
    draw_rock(&p);
    draw_ways_out(&p, (way_point){ 3, -2 });
    picture_end();
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_all_that_is_empty_is_free_and_all_that_is_full_is_not),
        cmocka_unit_test(test_a_step_before_touching_is_free_and_a_step_behind_it_is_not),
        cmocka_unit_test(test_bodies_leave_every_outline_by_a_short_way),
        cmocka_unit_test(test_grazing_bodies_leave_random_outlines_by_a_short_way),
        cmocka_unit_test(test_bodies_slide_in_the_pockets_and_never_through_the_rock),
        cmocka_unit_test(test_bodies_in_inner_parts_only_find_a_way_out),
        cmocka_unit_test(test_a_ring_whose_hole_is_narrower_than_the_body_keeps_it_in_the_hole),
    };
    (void)argc;
    random_begin(argv);
    table_family(12, "Far cry from convex");
    draw_picture();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
