/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Family 5, tunnelling: fast bodies and thin pieces. What a method without sub-steps lets through, what tuff_substeps makes of
   it, where its formula ends, and shots as segments. A miss: the body ends beyond a wall that its center's straight path
   crosses, or a push sends it on ahead. */
#include <string.h>

#include "handed.h"
#include "naive.h"
#include "picture.h"
#include "pieces.h"
#include "rocks.h"
#include "table.h"

#define RADIUS       2              /* of the flying body, units */
#define WALL_HEIGHT  400
#define SPEEDS       11             /* 1, 2, 4 .. 1024 units a step */
#define BOX2D_MOST   64             /* Box2D moves nothing farther in a step: 2 of its meters */

static const tuff_material dull = { TUFF_RATIO(9, 100), TUFF_RATIO(1, 100) };

/* ---- a wall and what flies at it ---- */

typedef struct wall {               /* upright, about the origin; not to be copied */
    random_shape shape;
    tuff_terrain piece;
    tuff_world   world;
} wall;

static tuff_real on_grid(double units)
{
    return tuff_from_q22_10((int32_t)floor(units * GRID));
}

static void make_wall(wall *made, tuff_real thickness)
{
    random_box_shape(&made->shape, (tuff_vec2){ thickness / 2, TUFF_WHOLE(WALL_HEIGHT / 2) });
    made->piece = convex_piece(&made->shape, (tuff_vec2){ 0, 0 });
    made->world = plain_world(&made->piece, 1, TUFF_ORDER_ITERATION);
}

typedef struct flight { tuff_vec2 position, velocity; } flight;

/* Toward the wall's middle at up to 45 degrees; the first step begins anywhere within one step of touching it. */
static flight some_flight(random_source *source, double thickness, double speed)
{
    double angle = random_within(source, -0.785, 0.785), gap = random_fraction(source) * speed * cos(angle);
    double x = -(thickness / 2 + RADIUS + gap) - 1.0 / GRID, y = tan(angle) * x + random_within(source, -10, 10);
    return (flight){ { on_grid(x), on_grid(y) }, { on_grid(speed * cos(angle)), on_grid(speed * sin(angle)) } };
}

static void move(tuff_body *body, uint16_t part)
{
    body->position.x += body->velocity.x / part;
    body->position.y += body->velocity.y / part;
}

/* Steps until the wall pushes, or the body is beyond it. True: a miss. */
typedef bool flies_through(const wall *w, const flight *f);

static bool is_beyond(const wall *w, const tuff_body *body)
{
    return units_of(body->position.x) > RADIUS + units_of(w->shape.vertices[1].x);
}

static bool textbook_flies(const wall *w, const flight *f, tuff_real radius)
{
    tuff_body body = { f->position, f->velocity, &dull };
    while (!is_beyond(w, &body)) {
        move(&body, 1);
        if (naive_collide(&w->piece, 1, &body, radius, NULL)) return body.position.x > 0;
    }
    return true;
}

static bool textbook_flies_through(const wall *w, const flight *f)
{
    return textbook_flies(w, f, TUFF_WHOLE(RADIUS));
}

static bool flies_through_in(const wall *w, const flight *f, uint16_t parts)
{
    tuff_body body = { f->position, f->velocity, &dull };
    while (!is_beyond(w, &body)) {
        move(&body, parts);
        if (tuff_terrain_collide_circle(&w->world, &body, TUFF_WHOLE(RADIUS))) return body.position.x > 0;
    }
    return true;
}

static bool tuff_flies_through(const wall *w, const flight *f)
{
    return flies_through_in(w, f, 1);
}

static bool tuff_flies_through_in_sub_steps(const wall *w, const flight *f)
{
    return flies_through_in(w, f, tuff_substeps(f->velocity, TUFF_WHOLE(RADIUS), tuff_polygon_thickness(&w->shape.polygon)));
}

/* Box2D needs at most 1024 / 64 steps to the wall, and a few to be pushed out of it. */
static bool box2d_flies(const wall *w, const flight *f, bool continuous)
{
    yardstick *yard = yardstick_new((yardstick_vec){ 0, 0 }, continuous);
    assert_true(yard_add_piece(yard, &w->piece));
    yardstick_state start = { yard_vec(f->position), yard_vec(f->velocity) };
    int ball = yardstick_add_ball(yard, start, RADIUS, (yardstick_material){ 0.09, 0.0 });
    for (int i = 0; i < 24; i++) yardstick_step(yard);
    bool through = yardstick_body(yard, ball).position.x > 0;
    yardstick_free(yard);
    return through;
}

static bool box2d_flies_through(const wall *w, const flight *f)            { return box2d_flies(w, f, true); }
static bool plain_box2d_flies_through(const wall *w, const flight *f)      { return box2d_flies(w, f, false); }

/* ---- misses by speed ---- */

enum { TEXTBOOK, ONE_STEP, SUB_STEPS, BOX2D, BOX2D_PLAIN, METHODS };

static flies_through *const methods[METHODS] = {
    textbook_flies_through, tuff_flies_through, tuff_flies_through_in_sub_steps, box2d_flies_through, plain_box2d_flies_through
};

typedef struct rates { double percent[METHODS][SPEEDS]; } rates;

/* Of shots at a wall 1 unit thick. Every method has the same ones. */
static void measure_rates(const random_run *run, rates *r, bool with_box2d)
{
    static wall w;
    make_wall(&w, TUFF_WHOLE(1));
    memset(r, 0, sizeof *r);
    for (uint32_t i = run->first; i < run->end; i++) {
        random_source source = random_stream(run->seed, i);
        for (int speed = 0; speed < SPEEDS; speed++) {
            flight f = some_flight(&source, 1.0, (double)(1 << speed));
            for (int m = 0; m < METHODS; m++) {
                bool asked = m < BOX2D || (with_box2d && 1 << speed <= BOX2D_MOST);
                if (asked && methods[m](&w, &f)) r->percent[m][speed] += 100.0 / (run->end - run->first);
            }
        }
    }
}

static void draw_curve(const rates *r, int method, picture_role role, const char *label)
{
    picture_line(role, label);
    for (int speed = 0; speed < SPEEDS; speed++) {
        if (method < BOX2D || 1 << speed <= BOX2D_MOST) picture_point(1 << speed, r->percent[method][speed]);
    }
    picture_line_end();
}

static const flight drawn_flight = { { TUFF_RATIO(-47, 2), TUFF_WHOLE(-7) }, { TUFF_WHOLE(8), TUFF_RATIO(5, 2) } };

/* The body's places after each sub-step. */
static void draw_flight(picture_role role, const wall *w, uint16_t parts, int moves)
{
    tuff_body body = { drawn_flight.position, drawn_flight.velocity, &dull };
    picture_piece(&w->piece);
    for (int i = 0; i <= moves; i++) {
        picture_circle(role, body.position, TUFF_WHOLE(RADIUS));
        picture_dot(role, units_of(body.position.x), units_of(body.position.y));
        move(&body, parts);
        if (role == PICTURE_FAILS) naive_collide(&w->piece, 1, &body, TUFF_WHOLE(RADIUS), NULL);
        else tuff_terrain_collide_circle(&w->world, &body, TUFF_WHOLE(RADIUS));
    }
}

static void draw_picture(const rates *r)
{
    static wall w;
    make_wall(&w, TUFF_WHOLE(1));
    uint16_t parts = tuff_substeps(drawn_flight.velocity, TUFF_WHOLE(RADIUS), TUFF_WHOLE(1));
    if (!picture_begin("tunnelling")) return;
    picture_panel("8.4 units a step: over the wall", -28, -14, 14, 12);
    draw_flight(PICTURE_FAILS, &w, 1, 4);
    picture_panel("the same in 4 sub-steps: stopped", -28, -14, 14, 12);
    draw_flight(PICTURE_TUFF, &w, parts, 14);
    picture_chart("Bodies through a wall of 1 unit", "speed, units a step", "log", "through, %", "linear");
    draw_curve(r, TEXTBOOK, PICTURE_FAILS, NULL);
    draw_curve(r, ONE_STEP, PICTURE_TUFF_OTHER, "tuff, one step a frame");
    draw_curve(r, BOX2D_PLAIN, PICTURE_TRUTH, "Box2D, not continuous");
    draw_curve(r, SUB_STEPS, PICTURE_TUFF, NULL);
    draw_curve(r, BOX2D, PICTURE_BOX2D, NULL);
    picture_end();
}

static void print_row(const rates *r, int speed, const char *measure)
{
    table_row(measure);
    table_fails("textbook, one step", "%.1f", r->percent[TEXTBOOK][speed]);
    if (1 << speed <= BOX2D_MOST) table_box2d("%.1f", r->percent[BOX2D][speed]);
    else table_box2d("%d at most", BOX2D_MOST);
    table_tuff("%.1f", r->percent[SUB_STEPS][speed]);
}

static void test_with_sub_steps_no_body_gets_through_a_thin_wall(void **state)
{
    static rates r;
    random_run run = random_cases(__func__, 5001, 2000);
    (void)state;
    measure_rates(&run, &r, true);
    for (int speed = 0; speed < SPEEDS; speed++) {
        printf("figures: " EXACT_BUILD " %4d units a step, through a wall of 1 unit: textbook %.1f %%, tuff in one step %.1f %%, in "
               "sub-steps %.1f %%\n", 1 << speed, r.percent[TEXTBOOK][speed], r.percent[ONE_STEP][speed], r.percent[SUB_STEPS][speed]);
        if (1 << speed <= BOX2D_MOST) {
            printf("figures: Box2D continuous %.1f %%, not continuous %.1f %%\n", r.percent[BOX2D][speed], r.percent[BOX2D_PLAIN][speed]);
        }
        assert_true(r.percent[SUB_STEPS][speed] == 0);
    }
    print_row(&r, 3, "bodies through a wall of 1 unit at 8 units a step, %");
    print_row(&r, 10, "the same at 1,024 units a step, %");
    draw_picture(&r);
}

/* At 2 units a step none, since that is below radius + thickness / 2; at 8 more than a third; at 1,024 nearly all. */
static void test_without_sub_steps_fast_bodies_get_through(void **state)
{
    static rates r;
    random_run run = random_cases(__func__, 5001, 2000);
    (void)state;
    measure_rates(&run, &r, false);
    for (int m = TEXTBOOK; m <= ONE_STEP; m++) {
        assert_true(r.percent[m][0] == 0 && r.percent[m][1] == 0);
        assert_true(r.percent[m][3] > 35 && r.percent[m][10] > 98);
    }
}

/* ---- the formula against a search ---- */

#define PHASES 32
#define NOTCHES 200                 /* the search goes up by this part of the formula's step */

/* A body of this hull (NULL: the circle) begins at a distance from the wall and makes one step. Does the collide call leave it
   beyond? */
static bool steps_over(const wall *w, const tuff_polygon *hull, double reach, double phase, double step, double angle)
{
    double x = units_of(w->shape.vertices[0].x) - reach - phase - 1.0 / GRID;
    double dx = step * cos(angle), dy = step * sin(angle);
    tuff_body body = { random_point_at(x + dx, dy), random_point_at(dx, dy), &dull };
    tuff_real radius = hull ? random_cover(hull->vertices, hull->count) : TUFF_WHOLE(RADIUS);
    tuff_terrain_collide(&w->world, &body, radius, hull);
    return body.position.x > 0;
}

static bool any_steps_over(const wall *w, const tuff_polygon *hull, double reach, double step, double angle)
{
    for (int phase = 0; phase < PHASES; phase++) {
        if (steps_over(w, hull, reach, step * cos(angle) * phase / PHASES, step, angle)) return true;
    }
    return false;
}

/* The shortest step found to get over, as a multiple of radius + thickness / 2; searched from half of it to four times. */
static double shortest_over(const wall *w, const tuff_polygon *hull, double reach, double inner_radius, double angle)
{
    double formula = inner_radius + units_of(tuff_polygon_thickness(&w->shape.polygon)) / 2;
    for (int notch = NOTCHES / 2; notch < 4 * NOTCHES; notch++) {
        if (any_steps_over(w, hull, reach, formula * notch / NOTCHES, angle)) return (double)notch / NOTCHES;
    }
    return 4.0;
}

/* A hull's reach toward the wall, and the circle inside it. */
static double hull_shortest_over(const wall *w, const random_shape *hull, double angle)
{
    double reach = 0;
    for (int i = 0; i < hull->polygon.count; i++) reach = fmax(reach, units_of(hull->vertices[i].x));
    return shortest_over(w, &hull->polygon, reach, units_of(tuff_polygon_thickness(&hull->polygon)) / 2, angle);
}

/* Head-on the formula's step is the longest that is safe, to the search's notch; at an angle a longer one would do. */
static void test_the_longest_safe_step_is_radius_and_half_of_the_thickness(void **state)
{
    static const double angles[] = { 0, 0.3, 0.6, 1.0, -0.9 };
    static const int thicknesses[] = { 256, 64, 16 };       /* of 64 units: 1/4, 1 and 4 */
    static wall w;
    static random_shape box;
    double least = 4, head_on = 0;
    (void)state;
    random_box_shape(&box, (tuff_vec2){ TUFF_WHOLE(RADIUS), TUFF_WHOLE(3 * RADIUS) });
    for (unsigned t = 0; t < 3; t++) {
        make_wall(&w, TUFF_WHOLE(64) / (tuff_real)thicknesses[t]);
        for (unsigned a = 0; a < sizeof angles / sizeof *angles; a++) {
            double circle = shortest_over(&w, NULL, RADIUS, RADIUS, angles[a]), hull = hull_shortest_over(&w, &box, angles[a]);
            assert_true(circle > 1.0 && hull > 1.0);
            least = fmin(least, fmin(circle, hull));
            if (a == 0) head_on = fmax(head_on, fmax(circle, hull));
        }
    }
    printf("figures: " EXACT_BUILD " shortest step that gets over, by the formula's: %.3f, head-on at most %.3f\n", least, head_on);
    assert_true(head_on <= 1.03);
}

/* ---- any convex piece ---- */

typedef struct lunge {              /* one step of a body whose center's path leads over a point inside a piece; not to be copied */
    random_shape   piece, hull;
    oracle_polygon exact_piece;
    tuff_terrain   terrain;
    tuff_world     world;
    bool           is_hull;
    double         radius, middle_x, middle_y;      /* of the circle inside the body */
    double         x, y, dx, dy;                    /* the point, the way */
} lunge;

static void mean_of(const random_shape *shape, double *x, double *y)
{
    *x = *y = 0;
    for (int i = 0; i < shape->polygon.count; i++) {
        *x += units_of(shape->vertices[i].x) / shape->polygon.count;
        *y += units_of(shape->vertices[i].y) / shape->polygon.count;
    }
}

/* A point at least so deep inside, no more than half of the thickness: the mean of the vertices or, where luck will have it,
   another. */
static void choose_point(random_source *source, lunge *l, double depth)
{
    double size = units_of(l->piece.bounding_radius);
    mean_of(&l->piece, &l->x, &l->y);
    for (int i = 0; i < 8; i++) {
        exact2 p = { random_within(source, -size, size) * EXACT_UNIT, random_within(source, -size, size) * EXACT_UNIT };
        if (!oracle_segment_polygon(&l->exact_piece, p, p)) continue;
        if (oracle_outline_distance(&l->exact_piece, p) < (exact)(depth * EXACT_UNIT)) continue;
        l->x = (double)p.x / EXACT_UNIT;
        l->y = (double)p.y / EXACT_UNIT;
        return;
    }
}

static void make_lunge(random_source *source, lunge *l, bool deep)
{
    double angle = random_within(source, 0, 6.2831853);
    family_plain_shape(source, &l->piece, 8, random_magnitude(source, 2, 100));
    family_plain_shape(source, &l->hull, 8, random_magnitude(source, 0.5, 30));
    oracle_read_polygon(&l->exact_piece, &l->piece.polygon);
    l->terrain = convex_piece(&l->piece, (tuff_vec2){ 0, 0 });
    l->world = plain_world(&l->terrain, 1, TUFF_ORDER_ITERATION);
    l->is_hull = random_chance(source, 50);
    l->radius = l->is_hull ? units_of(tuff_polygon_thickness(&l->hull.polygon)) / 2 : units_of(l->hull.bounding_radius);
    l->middle_x = l->middle_y = 0;
    if (l->is_hull) mean_of(&l->hull, &l->middle_x, &l->middle_y);
    choose_point(source, l, deep ? units_of(tuff_polygon_thickness(&l->piece.polygon)) / 2 : 0.0);
    l->dx = cos(angle);
    l->dy = sin(angle);
}

/* The body whose inner circle's center is so far before the point. */
static tuff_body body_before(const lunge *l, double distance)
{
    tuff_vec2 at = random_point_at(l->x - l->middle_x - l->dx * distance, l->y - l->middle_y - l->dy * distance);
    return (tuff_body){ at, { 0, 0 }, &dull };
}

static uint16_t meet(lunge *l, tuff_body *body, tuff_touch *touch)
{
    tuff_touches touches = { touch, 1, 0 };
    tuff_terrain_collide_report(&l->world, body, l->hull.bounding_radius, l->is_hull ? &l->hull.polygon : NULL, &touches);
    return touches.count;
}

/* The least distance at which it is outside. */
static double first_distance(lunge *l)
{
    double inside = 0, outside = 2 * (units_of(l->piece.bounding_radius) + units_of(l->hull.bounding_radius)) + 1;
    tuff_touch touch;
    for (int i = 0; i < 30; i++) {
        double middle = (inside + outside) / 2;
        tuff_body body = body_before(l, middle);
        if (meet(l, &body, &touch)) inside = middle;
        else outside = middle;
    }
    return outside;
}

typedef struct trial {              /* which lunges */
    bool   deep;                    /* paths lead over a point at least half of the thickness inside; else over any point */
    bool   with_thickness;          /* steps for the piece's thickness; else for thickness 0 */
    double factor;                  /* steps so many times as long as tuff_substeps says */
} trial;

/* Part of a motion so much longer that each step is nearly as long as it may be. */
static double step_of(const lunge *l, const trial *t)
{
    tuff_real thickness = t->with_thickness ? tuff_polygon_thickness(&l->piece.polygon) : 0;
    double way = fmin(30000.0, 2000.0 * (l->radius + units_of(thickness)));
    return way / tuff_substeps(random_point_at(way, 0), random_point_at(l->radius, 0).x, thickness) * t->factor;
}

/* One step, from anywhere within it outside. True: over, or sent on ahead. */
static bool lunges_over(random_source *source, lunge *l, const trial *t)
{
    double step = step_of(l, t), phase = random_chance(source, 50) ? 0 : random_fraction(source) * step;
    double distance = first_distance(l) + phase - step;
    tuff_body body = body_before(l, distance);
    tuff_touch touch;
    if (!meet(l, &body, &touch)) return distance < 0;
    return (double)exact_unit(touch.contact.normal.x) * l->dx + (double)exact_unit(touch.contact.normal.y) * l->dy > 1e-6;
}

/* In percent. must_hold: the first lunge that leads over fails the test, and says how to repeat it. */
static double share_over(const random_run *run, const trial *t, bool must_hold)
{
    static lunge l;
    uint32_t over = 0;
    for (uint32_t i = run->first; i < run->end; i++) {
        random_source source = random_stream(run->seed, i);
        make_lunge(&source, &l, t->deep);
        if (!lunges_over(&source, &l, t)) continue;
        over++;
        if (must_hold) random_fail(run, i, "a safe step led over the piece");
    }
    return 100.0 * over / (run->end - run->first);
}

static void test_no_safe_step_leads_over_a_convex_piece(void **state)
{
    random_run run = random_cases(__func__, 5002, 10000);
    (void)state;
    double safe = share_over(&run, &(trial){ true, true, 1.0 }, true) + share_over(&run, &(trial){ false, false, 1.0 }, true);
    double longer = share_over(&run, &(trial){ true, true, 1.5 }, false);
    printf("figures: " EXACT_BUILD " steps 1.5 times as long as tuff_substeps says: %.1f %% get over a convex piece or are pushed on "
           "ahead\n", longer);
    if (run.end - run.first > 100) assert_true(longer > 5);
    table_row("steps pushed on over convex pieces, %");
    table_fails("steps 1.5 times as long", "%.1f", longer);
    table_tuff("%.1f", safe);
    assert_true(safe == 0);
}

/* The limit: where a path comes nowhere half of the thickness deep, a step for that thickness may cut the corner. */
static void test_steps_for_a_thickness_may_cut_corners(void **state)
{
    random_run run = random_cases(__func__, 5006, 10000);
    (void)state;
    double anywhere = share_over(&run, &(trial){ false, true, 1.0 }, false);
    printf("figures: " EXACT_BUILD " steps for the thickness, paths over any point of a convex piece: %.1f %% get over or are pushed on "
           "ahead\n", anywhere);
    if (run.end - run.first > 100) assert_true(anywhere > 0.5 && anywhere < 25);
    double for_0 = share_over(&run, &(trial){ false, false, 1.0 }, true);
    table_row("the same over any point, corners too, %");
    table_fails("tuff, thickness given", "%.1f", anywhere);
    table_tuff("%.1f (0 given)", for_0);
    assert_true(for_0 == 0);
}

/* ---- pieces of parts ---- */

static bool in_rock(const rock *made, tuff_vec2 p)
{
    oracle_polygon part;
    for (int k = 0; k < made->part_count; k++) {
        oracle_read_polygon(&part, &made->parts[k]);
        if (!oracle_segment_polygon(&part, exact_vec2(p), exact_vec2(p))) continue;
        if (oracle_outline_distance(&part, exact_vec2(p)) > (exact)(EXACT_UNIT / 100)) return true;
    }
    return false;
}

/* A body with a motor flies at the rock without giving way, in sub-steps for thickness 0. From where it is free, does a step
   take its center in? */
static bool center_enters(random_source *source, const rock *made, const tuff_world *world)
{
    double size = units_of(made->bounding_radius), angle = random_within(source, 0, 6.2831853), speed = random_magnitude(source, 1, 900);
    tuff_real radius = on_grid(random_magnitude(source, 0.25, 20) + 1.0 / GRID);
    tuff_vec2 velocity = { on_grid(speed * cos(angle)), on_grid(speed * sin(angle)) };
    tuff_vec2 aim = random_point(source, size);
    tuff_vec2 position = random_point_at(units_of(aim.x) - cos(angle) * 3 * size, units_of(aim.y) - sin(angle) * 3 * size);
    tuff_body body = { position, velocity, &dull };
    uint16_t parts = tuff_substeps(velocity, radius, 0);
    tuff_contact contact;
    for (int i = 0; i < 200; i++) {
        bool is_free = !tuff_terrain_overlap_circle(world->terrain, body.position, radius, &contact);
        body.velocity = velocity;
        move(&body, parts);
        if (is_free && in_rock(made, body.position)) return true;
        tuff_terrain_collide_circle(world, &body, radius);
    }
    return false;
}

static void test_with_thickness_0_no_center_enters_a_rock_of_parts(void **state)
{
    static rock made;
    random_run run = random_cases(__func__, 5003, 700);
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        rock_make(&source, &made, (int)random_below(&source, ROCK_KINDS), random_magnitude(&source, 8, 200));
        tuff_terrain piece = rock_terrain(&made, (tuff_vec2){ 0, 0 });
        tuff_world world = plain_world(&piece, 1, TUFF_ORDER_ITERATION);
        if (center_enters(&source, &made, &world)) random_fail(&run, i, "the center entered the rock");
    }
}

/* A wall of 10 units, cut along its diagonal. */
static const rock_point cut_wall_points[4] = { { -5 * ROCK_GRID, -50 * ROCK_GRID }, { 5 * ROCK_GRID, -50 * ROCK_GRID },
                                               { 5 * ROCK_GRID, 50 * ROCK_GRID }, { -5 * ROCK_GRID, 50 * ROCK_GRID } };

/* Bodies of radius 1 in steps for this thickness: how many of 400 are pushed on to the far side? */
static int through_cut_wall(tuff_real thickness)
{
    static rock made;
    random_source source = random_stream(1, 1);
    int through = 0;
    assert_true(rock_from_outline(&source, &made, cut_wall_points, 4, 0) && made.part_count == 2);
    tuff_terrain piece = rock_terrain(&made, (tuff_vec2){ 0, 0 });
    tuff_world world = plain_world(&piece, 1, TUFF_ORDER_ITERATION);
    for (int i = 0; i < 400; i++) {
        tuff_body body = { { on_grid(-6.001 - 0.1 * (i % 10)), on_grid(0.2 * (i - 200)) }, { TUFF_WHOLE(24), 0 }, &dull };
        uint16_t parts = tuff_substeps(body.velocity, TUFF_WHOLE(1), thickness);
        for (int k = 0; k < parts && body.velocity.x > 0; k++) {
            move(&body, parts);
            tuff_terrain_collide_circle(&world, &body, TUFF_WHOLE(1));
        }
        through += body.position.x > 0;
    }
    return through;
}

static void test_a_cut_wall_needs_thickness_0(void **state)
{
    (void)state;
    int with_its_own = through_cut_wall(TUFF_WHOLE(10));
    printf("figures: " EXACT_BUILD " of 400 bodies of radius 1, through a wall of 10 units in two parts: %d in steps for thickness 10, %d "
           "in steps for 0\n", with_its_own, through_cut_wall(0));
    assert_true(with_its_own > 40);
    assert_int_equal(through_cut_wall(0), 0);
}

/* ---- no more steps than needed ---- */

static void test_the_helper_asks_for_no_step_too_many(void **state)
{
    random_run run = random_cases(__func__, 5004, 50000);
    const exact margin = TUFF_SCALAR == TUFF_Q16_16 ? 4 : 256;              /* of the thickness: world.h */
    const exact rounding = TUFF_SCALAR == TUFF_Q16_16 ? 0 : (exact)1e-6;    /* of squares */
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        tuff_vec2 motion = random_point(&source, random_magnitude(&source, 0.01, 1024));
        tuff_real radius = random_point_at(random_magnitude(&source, 0.05, 1024), 0).x;
        tuff_real thickness = random_point_at(random_magnitude(&source, 0.05, 1024), 0).x;
        exact half = exact_real(thickness / 2) - margin, way = exact_length(exact_vec2(motion));
        exact step = exact_real(radius) + (half > 0 ? half : 0);
        uint16_t count = tuff_substeps(motion, radius, thickness);
        if (count == 65535) continue;
        if ((exact)count * step < way * (1 - rounding)) random_fail(&run, i, "%d steps are too few", count);
        if (count > 1 && (exact)(count - 1) * step >= way * (1 + rounding)) random_fail(&run, i, "%d steps are too many", count);
    }
}

/* ---- shots as segments ---- */

#define SHOT_WALL 0.125             /* units */

typedef struct shots { unsigned long fired, textbook, segment, box2d; } shots;

static bool segment_misses(const wall *w, tuff_vec2 from, tuff_vec2 to)
{
    tuff_beam_hit hit;
    if (!tuff_segment_terrain_first_hit(&w->world, from, to, &hit)) return true;
    double x = units_of(from.x) + (units_of(to.x) - units_of(from.x)) * (double)exact_unit(hit.fraction);
    double tolerance = TUFF_SCALAR == TUFF_Q16_16 ? 3.0 / EXACT_UNIT : 1e-3;     /* 2 LSB + length * 2^-28; the band of float beams */
    return fabs(x - units_of(w->shape.vertices[0].x)) > tolerance || hit.normal.x >= 0;
}

static bool ray_misses(const box2d_polygon *box, tuff_vec2 from, tuff_vec2 to)
{
    box2d_hit hit;
    return !box2d_ray_polygon(box, (box2d_vec){ 0, 0 }, twin_vec(from), twin_vec(to), &hit);
}

/* A shot at up to 1,024 units a step: by the textbook's circle of 1/4 unit, and by the segment and Box2D's ray of the step that
   leads over the wall. */
static void fire(shots *sum, const random_run *run, uint32_t index, const wall *w, const box2d_polygon *box)
{
    random_source source = random_stream(run->seed, index);
    flight f = some_flight(&source, SHOT_WALL, random_magnitude(&source, 4, 1024));
    tuff_body shot = { f.position, f.velocity, &dull };
    tuff_vec2 from = shot.position;
    while (shot.position.x <= w->shape.vertices[0].x) {
        from = shot.position;
        move(&shot, 1);
    }
    sum->fired++;
    sum->textbook += textbook_flies(w, &f, TUFF_RATIO(1, 4));
    sum->box2d += ray_misses(box, from, shot.position);
    sum->segment += segment_misses(w, from, shot.position);
    if (sum->segment) random_fail(run, index, "a shot passed the wall");
}

static void test_a_shot_as_a_segment_misses_at_no_speed(void **state)
{
    static wall w;
    random_run run = random_cases(__func__, 5005, 50000);
    shots sum = { 0, 0, 0, 0 };
    (void)state;
    make_wall(&w, TUFF_RATIO(1, 8));
    box2d_polygon *box = box2d_of(&w.shape.polygon);
    for (uint32_t i = run.first; i < run.end; i++) fire(&sum, &run, i, &w, box);
    box2d_polygon_free(box);
    printf("figures: " EXACT_BUILD " %lu shots at a wall of 1/8 unit: textbook misses %lu, Box2D's ray %lu, tuff's segment %lu\n",
           sum.fired, sum.textbook, sum.box2d, sum.segment);
    assert_true(sum.fired > 0 && sum.textbook * 2 > sum.fired);
    table_row("shots at a wall of 1/8 unit, missed, %");
    table_fails("textbook circle", "%.1f", percent(sum.textbook, sum.fired));
    table_box2d("%.2f (ray)", percent(sum.box2d, sum.fired));
    table_tuff("%.1f (segment)", percent(sum.segment, sum.fired));
    assert_int_equal(sum.segment, 0);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_with_sub_steps_no_body_gets_through_a_thin_wall),
        cmocka_unit_test(test_without_sub_steps_fast_bodies_get_through),
        cmocka_unit_test(test_the_longest_safe_step_is_radius_and_half_of_the_thickness),
        cmocka_unit_test(test_no_safe_step_leads_over_a_convex_piece),
        cmocka_unit_test(test_steps_for_a_thickness_may_cut_corners),
        cmocka_unit_test(test_with_thickness_0_no_center_enters_a_rock_of_parts),
        cmocka_unit_test(test_a_cut_wall_needs_thickness_0),
        cmocka_unit_test(test_the_helper_asks_for_no_step_too_many),
        cmocka_unit_test(test_a_shot_as_a_segment_misses_at_no_speed),
    };
    (void)argc;
    random_begin(argv);
    table_family(5, "Tunnelling");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
