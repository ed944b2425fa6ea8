/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Family 10, symmetry: bodies bounce about a walled yard of rocks for thousands of steps, and so do their images in the
   mirrored and the turned yard. One contact and one call are proven by tests/host/test_symmetry.c. */
#include "handed.h"
#include "naive.h"
#include "picture.h"
#include "pieces.h"
#include "rocks.h"
#include "same.h"
#include "table.h"
#include "turned.h"

#define ROCKS  6
#define PIECES (ROCKS + 4)
#define YARD   56                /* half of its width, units: the textbook's squares overflow beyond 181 */
#define STEPS  4000

static const tuff_material lively = { TUFF_RATIO(15, 16), TUFF_RATIO(1, 64) };

typedef struct yard_scene {      /* not to be copied: its pieces point into it */
    random_shape walls[2], shapes[ROCKS], hull;
    rock         concave[2];
    tuff_terrain pieces[PIECES];
    uint16_t     count;
    const tuff_polygon *body_hull;
    tuff_vec2    gravity;
    tuff_body    body;
    int          step;           /* what has been done */
} yard_scene;

/* ---- the yard ---- */

static void make_walls(yard_scene *s)
{
    tuff_real far = TUFF_WHOLE(YARD + 16);
    random_box_shape(&s->walls[0], (tuff_vec2){ far, TUFF_WHOLE(16) });
    random_box_shape(&s->walls[1], (tuff_vec2){ TUFF_WHOLE(16), far });
    for (int i = 0; i < 4; i++) {
        tuff_real out = i & 1 ? far : -far;
        s->pieces[i] = convex_piece(&s->walls[i / 2], i < 2 ? (tuff_vec2){ 0, out } : (tuff_vec2){ out, 0 });
    }
}

/* Of the hull of eight points about it; none is so near another that Box2D would weld them. */
static void make_octagon(random_source *source, random_shape *shape, double size)
{
    tuff_vec2 points[8];
    for (int i = 0; i < 8; i++) {
        double angle = 0.785398 * i + random_within(source, -0.2, 0.2), reach = size * random_within(source, 0.7, 1.0);
        points[i] = random_point_at(floor(reach * cos(angle) * 64) / 64, floor(reach * sin(angle) * 64) / 64);
    }
    random_bake(shape, random_hull_of(points, 8, shape->vertices));
}

/* Between so many units. */
static tuff_real on_grid(random_source *source, int low, int high)
{
    return TUFF_RATIO(random_between(source, low * GRID, high * GRID), GRID);
}

/* On the grid, as Box2D has to hold them too. */
static void make_rocks(random_source *source, yard_scene *s, bool concave)
{
    for (int i = 0; i < ROCKS; i++) {
        tuff_real x = on_grid(source, -40, 40);
        tuff_vec2 at = { x, on_grid(source, -50, 20) };
        make_octagon(source, &s->shapes[i], random_within(source, 7.0, 14.0));
        s->pieces[4 + i] = convex_piece(&s->shapes[i], at);
        if (!concave || i >= 2) continue;
        rock_make(source, &s->concave[i], (int)random_below(source, ROCK_KINDS), random_within(source, 8.0, 16.0));
        s->pieces[4 + i] = rock_terrain(&s->concave[i], at);
    }
}

static void make_yard(random_source *source, yard_scene *s, bool concave, bool hull)
{
    make_walls(s);
    make_rocks(source, s, concave);
    make_octagon(source, &s->hull, 5.0);
    s->count = PIECES;
    s->body_hull = hull ? &s->hull.polygon : NULL;
    s->gravity = (tuff_vec2){ 0, -TUFF_RATIO(1, 16) };
    tuff_real x = on_grid(source, -40, 40), sideways = on_grid(source, -3, 3);
    s->body = (tuff_body){ { x, TUFF_WHOLE(44) }, { sideways, on_grid(source, -1, 1) }, &lively };
    s->step = 0;
}

static void turn_yard(yard_scene *to, copies *made, int transform, const yard_scene *from)
{
    made->count = 0;
    to->count = from->count;
    to->step = 0;
    for (int i = 0; i < from->count; i++) to->pieces[i] = copy_terrain(made, transform, &from->pieces[i]);
    to->body_hull = from->body_hull ? copy_polygon(made, transform, from->body_hull) : NULL;
    to->gravity = apply(transform, from->gravity);
    to->body = (tuff_body){ apply(transform, from->body.position), apply(transform, from->body.velocity), from->body.material };
}

/* ---- methods ---- */

typedef void method(yard_scene *s);

static void fall(yard_scene *s)
{
    body_fall(&s->body, s->gravity);
    s->step++;
}

static void collide(yard_scene *s, uint8_t order)
{
    tuff_world world = plain_world(s->pieces, s->count, order);
    fall(s);
    tuff_terrain_collide(&world, &s->body, TUFF_WHOLE(6), s->body_hull);
}

static void step_tuff(yard_scene *s) { collide(s, TUFF_ORDER_DEEPEST); }

static int by_x(const void *left, const void *right)
{
    const tuff_terrain *a = (const tuff_terrain *)left, *b = (const tuff_terrain *)right;
    return (a->position.x > b->position.x) - (a->position.x < b->position.x);
}

/* As a game has them from its chunks: from left to right. */
static void step_naive(yard_scene *s)
{
    if (s->step == 0) qsort(s->pieces, s->count, sizeof *s->pieces, by_x);
    fall(s);
    naive_collide(s->pieces, s->count, &s->body, TUFF_WHOLE(6), s->body_hull);
}

/* ---- how far the image is from the image ---- */

static double apart(int transform, const yard_scene *plain, const yard_scene *turned)
{
    return units_apart(apply(transform, plain->body.position), turned->body.position);
}

static bool coincident(const yard_scene *s)
{
    for (int i = 0; i < s->count; i++) {
        if (same_point(s->pieces[i].position, s->body.position)) return true;
    }
    return false;
}

/* Two bodies that go the same way, one in a mirror or turned. */
typedef struct twins { int transform; bool concave, hull; method *step; } twins;

/* The step at which the two are over this far apart, or steps. *most: their greatest distance. */
static int steps_together(random_source *source, const twins *both, int steps, double limit, double *most)
{
    static yard_scene plain, turned;
    static copies made;
    int together = steps;
    make_yard(source, &plain, both->concave, both->hull);
    turn_yard(&turned, &made, both->transform, &plain);
    for (int i = 0; i < steps && !coincident(&plain); i++) {
        both->step(&plain);
        both->step(&turned);
        double now = apart(both->transform, &plain, &turned);
        raise_to(most, now);
        if (now > limit && together == steps) together = i;
    }
    return together;
}

typedef struct verdict { int ways, parted; double most; } verdict;

static verdict judge(uint64_t seed, int ways, bool concave, method *step, int steps)
{
    verdict v = { ways, 0, 0.0 };
    for (int i = 0; i < ways; i++) {
        random_source source = random_stream(seed, (uint64_t)i);
        twins both = { i & 1, concave, i >> 1 & 1, step };
        if (steps_together(&source, &both, steps, 1.0 / EXACT_UNIT / 2, &v.most) < steps) v.parted++;
    }
    return v;
}

/* ---- Box2D ---- */

/* False: Box2D does not take one of the shapes. */
static bool fill(yardstick *yard, const yard_scene *s)
{
    const yardstick_material smooth = { 0.9375, 0.0 };
    for (int i = 0; i < s->count; i++) {
        if (!yard_add_piece(yard, &s->pieces[i])) return false;
    }
    if (!s->body_hull) return yardstick_add_ball(yard, yard_state(&s->body), 6.0, smooth) == 0;
    return yard_add_hull(yard, yard_state(&s->body), s->body_hull, smooth) == 0;
}

static void run_box2d(const yard_scene *s, int steps, yardstick_vec *way)
{
    yardstick *yard = yardstick_new(yard_vec(s->gravity), true);
    bool taken = fill(yard, s);
    for (int i = 0; i < steps; i++) {
        if (taken) yardstick_step(yard);
        way[i] = taken ? yardstick_body(yard, 0).position : (yardstick_vec){ 0, 0 };
    }
    yardstick_free(yard);
}

/* Raises most[step] to the distance of one way from its image. */
static void measure_box2d_way(uint64_t seed, int number, int steps, double *most)
{
    static yard_scene plain, turned;
    static copies made;
    static yardstick_vec way[STEPS], image[STEPS];
    random_source source = random_stream(seed, (uint64_t)number);
    make_yard(&source, &plain, false, number >> 1 & 1);
    turn_yard(&turned, &made, number & 1, &plain);
    run_box2d(&plain, steps, way);
    run_box2d(&turned, steps, image);
    for (int k = 0; k < steps; k++) {
        yardstick_vec at = (number & 1) == MIRROR ? (yardstick_vec){ -way[k].x, way[k].y } : (yardstick_vec){ -way[k].y, way[k].x };
        raise_to(&most[k], hypot(at.x - image[k].x, at.y - image[k].y));
    }
}

static verdict judge_box2d(uint64_t seed, int ways, int steps)
{
    verdict v = { ways, 0, 0.0 };
    for (int i = 0; i < ways; i++) {
        double distances[STEPS] = { 0 }, most = 0;
        measure_box2d_way(seed, i, steps, distances);
        for (int k = 0; k < steps; k++) raise_to(&most, distances[k]);
        v.parted += most > 1.0 / EXACT_UNIT / 2;
        raise_to(&v.most, most);
    }
    return v;
}

/* ---- the tests ---- */

/* What float may differ in by its rounding, units. None was seen: sums of two products round the same with either sign, in
   either order. */
#define MOST_APART (TUFF_SCALAR == TUFF_Q16_16 ? 0.0 : 1e-3)

static void test_long_ways_mirror_and_turn(void **state)
{
    random_run run = random_cases(__func__, 101, 120);
    double most = 0;
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        twins both = { (int)(i & 1), i >> 1 & 1, i >> 2 & 1, step_tuff };
        int together = steps_together(&source, &both, STEPS, MOST_APART, &most);
        if (together < STEPS) random_fail(&run, i, "the %s way parts in step %d", transform_names[both.transform], together);
    }
    print_message("figures: " EXACT_BUILD " symmetry: %lu ways of %d steps, mirrored or turned; most apart %g units\n",
                  (unsigned long)(run.end - run.first), STEPS, most);
}

#define WAYS 40
#define SHORT 1000

static void test_the_textbook_drifts_from_its_image(void **state)
{
    verdict naive = judge(102, WAYS, false, step_naive, SHORT), tuff = judge(102, WAYS, false, step_tuff, SHORT);
    verdict box2d = judge_box2d(102, WAYS, SHORT);
    (void)state;
    table_row("mirrored or turned ways that part in 1000 steps, of 40");
    table_fails("textbook", "%d", naive.parted);
    table_box2d("%d", box2d.parted);
    table_tuff("%d", tuff.parted);
    table_row("greatest distance of a body from its image, units");
    table_fails("textbook", "%.1f", naive.most);
    table_box2d("%.1f", box2d.most);
    table_tuff("%g", tuff.most);
    assert_in_range(naive.parted, WAYS / 8, WAYS);
    assert_int_equal(tuff.parted, 0);
}

/* ---- the picture ---- */

#define DRAWN 300                /* steps */
#define ZERO  1e-5               /* units: half a step of Q16.16, drawn for what is less */

static void draw_yard(void)
{
    static yard_scene s;
    random_source source = random_stream(102, 1);
    make_yard(&source, &s, false, false);
    picture_panel("A circle bounces about a yard of rocks", -YARD - 4, -YARD - 4, YARD + 4, YARD + 4);
    for (int i = 0; i < s.count; i++) picture_piece(&s.pieces[i]);
    picture_circle(PICTURE_BODY, s.body.position, TUFF_WHOLE(6));
    picture_line(PICTURE_TUFF, NULL);
    for (int i = 0; i < DRAWN; i++) {
        picture_point(units_of(s.body.position.x), units_of(s.body.position.y));
        step_tuff(&s);
    }
    picture_line_end();
}

static void draw_growth(picture_role role, const char *label, const double *most)
{
    picture_line(role, label);
    for (int i = 0; i < DRAWN; i += 5) picture_point(i, fmax(most[i], ZERO));
    picture_line_end();
}

/* The greatest distance in each step, of all ways. */
static void measure_growth(method *step, double *most)
{
    static yard_scene plain, turned;
    static copies made;
    for (int way = 0; way < WAYS; way++) {
        random_source source = random_stream(102, (uint64_t)way);
        make_yard(&source, &plain, false, way >> 1 & 1);
        turn_yard(&turned, &made, way & 1, &plain);
        for (int i = 0; i < DRAWN; i++) {
            step(&plain);
            step(&turned);
            raise_to(&most[i], apart(way & 1, &plain, &turned));
        }
    }
}

static void draw_picture(void)
{
    double naive[DRAWN] = { 0 }, tuff[DRAWN] = { 0 }, box2d[DRAWN] = { 0 };
    if (!picture_begin("symmetry")) return;
    for (int i = 0; i < WAYS; i++) measure_box2d_way(102, i, DRAWN, box2d);
    measure_growth(step_naive, naive);
    measure_growth(step_tuff, tuff);
    draw_yard();
    picture_chart("How far a body gets from its image, of 40 ways", "steps", "linear", "units (1e-5 and less: none)", "log");
    draw_growth(PICTURE_FAILS, "textbook, Q16.16", naive);
    draw_growth(PICTURE_BOX2D, NULL, box2d);
    draw_growth(PICTURE_TUFF, NULL, tuff);
    picture_end();
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_textbook_drifts_from_its_image),
        cmocka_unit_test(test_long_ways_mirror_and_turn),
    };
    (void)argc;
    random_begin(argv);
    table_family(10, "Symmetry");
    draw_picture();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
