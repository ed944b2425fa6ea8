/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Family 8, bounces: restitution up to 1 adds no speed, slow bodies neither stick nor jump, rest stays rest, friction and
   restitution have no order, what leaves is let go. tuff_bounce alone, and whole frames between walls, in a room and on a
   floor. The variants that fail are in naive_bounce. */
#include "handed.h"
#include "naive.h"
#include "picture.h"
#include "pieces.h"
#include "table.h"

static const tuff_real restitutions[] = {
    TUFF_RATIO(0, 1), TUFF_RATIO(9, 100), TUFF_RATIO(1, 4),    TUFF_RATIO(1, 2),
    TUFF_RATIO(3, 4), TUFF_RATIO(9, 10),  TUFF_RATIO(99, 100), TUFF_RATIO(1, 1)
};
#define RESTITUTIONS ((int)(sizeof restitutions / sizeof restitutions[0]))

/* The square of a baked normal is within this of 1, so (1 + e) times as much of the speed is the reflection's error; in float
   it is six roundings of 2^-24 and the normal's two. */
#define NORMAL_ERROR (EXACT_WHOLE ? 2.2e-9 : 5e-7)

/* Fixed: rounding toward zero takes up to a step from a component, and the change of speed is kept to a sixteenth of a step. */
#define ROUNDING (EXACT_WHOLE ? 1.0 + 1.0 / 16.0 : 0.0)

static const tuff_material elastic = { TUFF_WHOLE(1), 0 };

/* Speeds of up to this many steps are slow: a two-hundredth of a unit a step. */
#define SLOW 300

static double speed_of(tuff_vec2 v)                   { return (double)exact_length(exact_vec2(v)); }
static double along(tuff_vec2 v, tuff_unit2 n)        { return (double)exact_dot(exact_vec2(v), exact_unit2(n)); }

/* ---- bounces as others write them ---- */

typedef enum naive_rounding { NAIVE_NEAREST, NAIVE_FLOOR, NAIVE_TO_ZERO } naive_rounding;

typedef enum naive_form {
    NAIVE_USUAL,
    NAIVE_NO_QUESTION,     /* whether the body moves inwards is not asked */
    NAIVE_STALE,           /* in place: friction after restitution, by the normal speed from before it */
    NAIVE_FACTOR           /* the coefficient of restitution taken for the impulse factor, which is 1 more */
} naive_form;

#if TUFF_SCALAR == TUFF_Q16_16
static tuff_real narrowed(int64_t product, int bits, naive_rounding rounding)
{
    if (rounding == NAIVE_NEAREST) product += (int64_t)1 << (bits - 1);
    return (tuff_real)(rounding == NAIVE_TO_ZERO ? product / ((int64_t)1 << bits) : product >> bits);
}

static tuff_real part_along(tuff_vec2 v, tuff_unit2 n, naive_rounding rounding)
{
    return narrowed((int64_t)v.x * n.x, TUFF_UNIT_BITS, rounding) + narrowed((int64_t)v.y * n.y, TUFF_UNIT_BITS, rounding);
}

static tuff_vec2 turned(tuff_real length, tuff_unit2 n, naive_rounding rounding)
{
    int64_t x = (int64_t)length * n.x, y = (int64_t)length * n.y;
    return (tuff_vec2){ narrowed(x, TUFF_UNIT_BITS, rounding), narrowed(y, TUFF_UNIT_BITS, rounding) };
}

static tuff_real times(tuff_real a, tuff_real b, naive_rounding rounding)
{
    return narrowed((int64_t)a * b, TUFF_REAL_BITS, rounding);
}
#else
static tuff_real part_along(tuff_vec2 v, tuff_unit2 n, naive_rounding rounding)
{
    (void)rounding;
    return v.x * n.x + v.y * n.y;
}

static tuff_vec2 turned(tuff_real length, tuff_unit2 n, naive_rounding rounding)
{
    (void)rounding;
    return (tuff_vec2){ length * n.x, length * n.y };
}

static tuff_real times(tuff_real a, tuff_real b, naive_rounding rounding)
{
    (void)rounding;
    return a * b;
}
#endif

static tuff_vec2 naive_bounce(tuff_vec2 v, tuff_unit2 n, tuff_material material, naive_rounding rounding, naive_form form)
{
    tuff_real inward = part_along(v, n, rounding);
    tuff_real factor = form == NAIVE_FACTOR ? material.restitution : TUFF_WHOLE(1) + material.restitution;
    if (inward >= 0 && form != NAIVE_NO_QUESTION) return v;
    tuff_vec2 normal_part = turned(inward, n, rounding), change = turned(times(inward, factor, rounding), n, rounding);
    tuff_vec2 bounced = { v.x - change.x, v.y - change.y };
    tuff_vec2 from = form == NAIVE_STALE ? bounced : v;
    tuff_vec2 tangential = { from.x - normal_part.x, from.y - normal_part.y };
    tuff_vec2 rubbed = { times(tangential.x, material.friction, rounding), times(tangential.y, material.friction, rounding) };
    return (tuff_vec2){ bounced.x - rubbed.x, bounced.y - rubbed.y };
}

static tuff_vec2 tuff_bounced(tuff_vec2 v, tuff_unit2 n, tuff_material material)
{
    tuff_contact contact = { TUFF_RATIO(1, 1024), n };
    tuff_body body = { { 0, 0 }, v, &material };
    tuff_bounce(&body, &contact);
    return body.velocity;
}

/* ---- random bounces ---- */

static tuff_unit2 any_normal(random_source *source)
{
    random_shape shape;
    random_rock_shape(source, &shape, TUFF_MAX_VERTICES, 100.0);
    return shape.normals[random_below(source, shape.polygon.count)];
}

static tuff_unit2 facing(tuff_unit2 n, tuff_vec2 v)
{
    return along(v, n) > 0 ? (tuff_unit2){ -n.x, -n.y } : n;
}

/* Within so many steps of 1/65536 unit in each axis; in float any numbers, in the fixed build whole steps. */
static tuff_vec2 any_velocity(random_source *source, double most)
{
    double x = random_within(source, -most, most), y = random_within(source, -most, most);
    return vec2_from_doubles(x, y);
}

/* ---- 100,000 slow bounces ---- */

#define NORMALS 32

static void make_normals(tuff_unit2 *normals)
{
    for (uint32_t i = 0; i < NORMALS; i++) {
        random_source source = random_stream(801, i);
        normals[i] = any_normal(&source);
    }
}

typedef tuff_vec2 bouncer(tuff_vec2 v, tuff_unit2 n, tuff_material material);

static tuff_vec2 to_nearest(tuff_vec2 v, tuff_unit2 n, tuff_material material)
{
    return naive_bounce(v, n, material, NAIVE_NEAREST, NAIVE_USUAL);
}

static tuff_vec2 to_floor(tuff_vec2 v, tuff_unit2 n, tuff_material material)
{
    return naive_bounce(v, n, material, NAIVE_FLOOR, NAIVE_USUAL);
}

typedef struct chain {
    double gain, last;     /* the most speed that one bounce added, and the speed at the end; in steps */
    uint32_t moving;       /* bounces until it was slower than 2 steps */
} chain;

/* A body that goes on bouncing off the walls of one set, from 300 steps a step; into a curve of the picture too, if traced. */
static chain bounce_on(bouncer *bounce, uint32_t count, bool traced)
{
    tuff_unit2 normals[NORMALS];
    uint32_t next = 1;
    tuff_vec2 v = { TUFF_REAL_RAW(240), TUFF_REAL_RAW(180) };
    random_source source = random_stream(802, 0);
    chain c = { -SLOW, 0, 0 };
    make_normals(normals);
    for (uint32_t i = 0; i < count; i++) {
        double before = speed_of(v);
        if (traced && i + 1 >= next) {
            picture_point(i + 1, before);
            next += next / 8 + 1;
        }
        v = bounce(v, facing(normals[random_below(&source, NORMALS)], v), elastic);
        c.gain = fmax(c.gain, speed_of(v) - before);
        if (speed_of(v) >= 2.0) c.moving = i + 1;
    }
    c.last = speed_of(v);
    return c;
}

static void test_slow_bounces_rounded_to_nearest_or_down_gain_speed_and_tuffs_do_not(void **state)
{
    random_run run = random_cases(__func__, 0, 100000);
    chain nearest = bounce_on(to_nearest, run.end, false), floored = bounce_on(to_floor, run.end, false);
    chain ours = bounce_on(tuff_bounced, run.end, false);
    (void)state;
    if (EXACT_WHOLE && run.end >= 5000) assert_true(nearest.gain > 1.0 && floored.gain > 1.0 && floored.last > 2.0 * SLOW);
    assert_true(ours.gain <= SLOW * 2.0 * NORMAL_ERROR);
    assert_true(ours.last <= SLOW * (1.0 + 2.0 * NORMAL_ERROR * run.end));
    table_row("speed after 100,000 slow bounces, from 300 LSB a step");
    table_fails("products rounded down", "%.0f", floored.last);
    table_tuff("%.0f", ours.last);
    printf("figures: most that a slow bounce adds, in steps: rounded down %.2f, to nearest %.2f (last speed %.0f), tuff %.2f "
           "(moving for %lu bounces)\n", floored.gain, nearest.gain, nearest.last, fmax(ours.gain, 0.0), (unsigned long)ours.moving);
}

/* Each restitution anew every 50 bounces, so that the bodies stay slow and do not come to rest. */
static void test_no_restitution_up_to_1_adds_speed(void **state)
{
    random_run run = random_cases(__func__, 803, 100000);
    tuff_unit2 normals[NORMALS];
    (void)state;
    make_normals(normals);
    for (int e = 0; e < RESTITUTIONS; e++) {
        tuff_vec2 v = { 0, 0 };
        for (uint32_t i = run.first; i < run.end; i++) {
            random_source source = random_stream(run.seed, i);
            if (i % 50 == 0 || i == run.first) v = any_velocity(&source, SLOW);
            tuff_material material = { restitutions[e], random_chance(&source, 30) ? TUFF_RATIO(1, 100) : 0 };
            tuff_vec2 before = v;
            v = tuff_bounced(v, normals[random_below(&source, NORMALS)], material);
            if (speed_of(v) > speed_of(before) * (1.0 + (EXACT_WHOLE ? 0.0 : 2.0 * NORMAL_ERROR))) random_fail(&run, i, "speed was added");
        }
    }
}

/* ---- one bounce against the exact law ---- */

typedef struct law { exact2 friction_first, restitution_first; } law;

static exact2 scaled(exact2 v, exact factor)
{
    return (exact2){ v.x * factor, v.y * factor };
}

/* In both orders: the tangential part shrunk before or after the normal part is turned. */
static law exact_bounced(tuff_vec2 velocity, tuff_unit2 normal, tuff_material material)
{
    exact2 v = exact_vec2(velocity), n = exact_unit2(normal);
    exact e = exact_real(material.restitution) / EXACT_UNIT, keep = 1 - exact_real(material.friction) / EXACT_UNIT;
    n = scaled(n, 1 / exact_length(n));
    exact2 rubbed = exact_add(scaled(n, exact_dot(v, n)), scaled(exact_sub(v, scaled(n, exact_dot(v, n))), keep));
    exact2 turned_back = exact_sub(v, scaled(n, (1 + e) * exact_dot(v, n)));
    exact2 left = scaled(n, exact_dot(turned_back, n));
    return (law){ .friction_first = exact_sub(rubbed, scaled(n, (1 + e) * exact_dot(rubbed, n))),
                  .restitution_first = exact_add(left, scaled(exact_sub(turned_back, left), keep)) };
}

static exact clamped(exact a)
{
    exact limit = (exact)TUFF_MAX_SPEED * EXACT_UNIT;
    return a > limit ? limit : a < -limit ? -limit : a;
}

static double error_of(tuff_vec2 v, exact2 truth)
{
    exact2 ours = exact_vec2(v);
    return fmax((double)exact_abs(ours.x - clamped(truth.x)), (double)exact_abs(ours.y - clamped(truth.y)));
}

static double error_allowed(tuff_vec2 v, tuff_material material)
{
    return ROUNDING + (1.0 + units_of(material.restitution)) * speed_of(v) * NORMAL_ERROR;
}

/* Restitution 0 to 4, half of the time one of those of the list; friction 0, 1 or between. */
static tuff_material any_material(random_source *source)
{
    bool listed = random_chance(source, 50);
    tuff_real e = listed ? restitutions[random_below(source, (uint32_t)RESTITUTIONS)] : tuff_from_q22_10(random_between(source, 0, 4096));
    uint32_t kind = random_below(source, 3);
    return (tuff_material){ e, kind == 0 ? 0 : kind == 1 ? TUFF_WHOLE(1) : tuff_from_q22_10(random_between(source, 0, 1024)) };
}

static void test_friction_and_restitution_have_no_order_and_e_above_1_gains_what_it_says(void **state)
{
    random_run run = random_cases(__func__, 804, 60000);
    double most = 0.0, gain = 0.0;
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        tuff_vec2 v = any_velocity(&source, random_magnitude(&source, 2.0, (double)TUFF_MAX_SPEED * EXACT_UNIT));
        tuff_unit2 n = facing(any_normal(&source), v);
        tuff_material material = any_material(&source);
        law truth = exact_bounced(v, n, material);
        tuff_vec2 ours = tuff_bounced(v, n, material);
        double error = fmax(error_of(ours, truth.friction_first), error_of(ours, truth.restitution_first));
        if (error > error_allowed(v, material)) random_fail(&run, i, "the speed is %g steps from the law", error);
        most = fmax(most, error);
        if (material.restitution > TUFF_WHOLE(1)) continue;
        if (speed_of(ours) > speed_of(v) * (1.0 + 2.0 * NORMAL_ERROR)) random_fail(&run, i, "a restitution up to 1 added speed");
        gain = fmax(gain, speed_of(ours) - speed_of(v));
    }
    printf("figures: any speed: largest error %.3f steps, largest gain up to restitution 1: %.3f steps\n", most, gain);
}

static void test_friction_by_the_speed_from_before_drives_bodies_in(void **state)
{
    const tuff_unit2 up = { 0, TUFF_UNIT_RATIO(1, 1) };
    const tuff_vec2 v = { TUFF_WHOLE(3), TUFF_WHOLE(-2) };
    const tuff_material sticky = { TUFF_RATIO(1, 2), TUFF_WHOLE(1) };
    tuff_vec2 stale = naive_bounce(v, up, sticky, NAIVE_NEAREST, NAIVE_STALE), ours = tuff_bounced(v, up, sticky);
    (void)state;
    assert_true(stale.y < -TUFF_WHOLE(1));
    assert_true(ours.x == 0 && ours.y == TUFF_WHOLE(1));
    printf("figures: out of a hit at 2 a step, restitution 0.5, friction 1: by the old v . n %.2f, tuff %.2f\n",
           units_of(stale.y), units_of(ours.y));
}

static void test_a_coefficient_taken_for_the_impulse_factor_does_not_bounce(void **state)
{
    random_run run = random_cases(__func__, 805, 5000);
    const tuff_material half = { TUFF_RATIO(1, 2), 0 };
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        tuff_vec2 v = any_velocity(&source, 200000.0);
        tuff_unit2 n = facing(any_normal(&source), v);
        if (along(v, n) > -16.0) continue;
        if (along(naive_bounce(v, n, half, NAIVE_NEAREST, NAIVE_FACTOR), n) >= 0) random_fail(&run, i, "the factor bounced");
        if (along(tuff_bounced(v, n, half), n) <= 0) random_fail(&run, i, "tuff did not bounce");
    }
}

static void test_a_body_that_leaves_is_let_go(void **state)
{
    random_run run = random_cases(__func__, 806, 20000);
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        tuff_vec2 v = any_velocity(&source, random_magnitude(&source, 2.0, (double)TUFF_MAX_SPEED * EXACT_UNIT));
        tuff_unit2 n = facing(any_normal(&source), (tuff_vec2){ -v.x, -v.y });
        tuff_material material = any_material(&source);
        material.restitution += TUFF_RATIO(1, 16);
        if (along(v, n) < 64.0 + speed_of(v) * NORMAL_ERROR) continue;
        tuff_vec2 ours = tuff_bounced(v, n, material);
        if (ours.x != v.x || ours.y != v.y) random_fail(&run, i, "a body that leaves was changed");
        if (along(naive_bounce(v, n, material, NAIVE_NEAREST, NAIVE_NO_QUESTION), n) > 0) random_fail(&run, i, "unasked, it was let go");
    }
}

/* ---- slow bodies at a wall ---- */

typedef struct slow_count { unsigned long bounces, jumps, stuck; } slow_count;

/* A jump: more than 2 steps faster outwards than the law. Stuck: inwards by more than 2 steps still. Two components of less
   than a step each are less than 2 along any normal. */
static void count_slow(slow_count *count, tuff_vec2 v, tuff_vec2 after, tuff_unit2 n)
{
    count->bounces++;
    count->jumps += along(after, n) > -along(v, n) + 2.0;
    count->stuck += along(after, n) < -2.0;
}

static void print_slow(const char *name, const slow_count *count)
{
    printf("figures: %s: %lu slow bounces, %lu jumps, %lu stuck\n", name, count->bounces, count->jumps, count->stuck);
}

/* Narrowing v . n loses up to 2 steps of it, and what is then made of it twice as many. */
static void test_a_narrowed_speed_jumps_off_the_wall_and_tuffs_does_not(void **state)
{
    random_run run = random_cases(__func__, 807, 100000);
    slow_count floored = { 0 }, nearest = { 0 }, ours = { 0 };
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        tuff_vec2 v = any_velocity(&source, SLOW);
        tuff_unit2 n = facing(any_normal(&source), v);
        count_slow(&floored, v, to_floor(v, n, elastic), n);
        count_slow(&nearest, v, to_nearest(v, n, elastic), n);
        count_slow(&ours, v, tuff_bounced(v, n, elastic), n);
    }
    print_slow("rounded down", &floored);
    print_slow("to nearest", &nearest);
    print_slow("tuff", &ours);
    if (EXACT_WHOLE) assert_true(floored.jumps > floored.bounces / 10);
    assert_true(ours.jumps == 0 && ours.stuck == 0);
}

/* ---- whole frames ---- */

#define WALLS 8

typedef struct scene {       /* not to be copied: the pieces point into it */
    random_shape shapes[WALLS];
    tuff_terrain pieces[WALLS];
    tuff_world   world;
    yardstick   *yard;
} scene;

static void make_scene(scene *s, double gravity)
{
    s->world = plain_world(s->pieces, 0, TUFF_ORDER_DEEPEST);
    s->yard = yardstick_new((yardstick_vec){ 0.0, -gravity }, true);
}

/* In units, on the grid. */
static void add_wall(scene *s, const double (*corners)[2])
{
    random_shape *shape = &s->shapes[s->world.terrain_count];
    tuff_terrain *piece = &s->pieces[s->world.terrain_count++];
    for (int i = 0; i < 4; i++) shape->vertices[i] = random_point_at(grid_floor(corners[i][0]), grid_floor(corners[i][1]));
    random_bake(shape, 4);
    *piece = convex_piece(shape, (tuff_vec2){ 0, 0 });
    assert_true(yard_add_piece(s->yard, piece));
}

/* Eight walls about a round room, none of them along an axis. */
static void make_room(scene *s, double across)
{
    make_scene(s, 0.0);
    for (int i = 0; i < WALLS; i++) {
        double from = 0.2 + i * 0.7853981633974483, to = from + 0.7853981633974483, out = across + 12.0;
        double corners[4][2] = { { across * cos(from), across * sin(from) }, { out * cos(from), out * sin(from) },
                                 { out * cos(to), out * sin(to) }, { across * cos(to), across * sin(to) } };
        add_wall(s, (const double (*)[2])corners);
    }
}

static void make_floor(scene *s, double gravity)
{
    static const double corners[4][2] = { { -256.0, -64.0 }, { 256.0, -64.0 }, { 256.0, 0.0 }, { -256.0, 0.0 } };
    make_scene(s, gravity);
    add_wall(s, corners);
}

static uint16_t frame(const scene *s, tuff_body *body, tuff_real radius)
{
    body_fall(body, (tuff_vec2){ 0, 0 });
    return tuff_terrain_collide_circle(&s->world, body, radius);
}

#define BALL TUFF_WHOLE(2)
static const double ball_radius = 2.0;

static double box_speed(const scene *s, int ball)
{
    yardstick_state state = yardstick_body(s->yard, ball);
    return hypot(state.velocity.x, state.velocity.y);
}

/* Box2D's speed after so many bounces: a bounce is a step that turns the ball by more than a hundredth of its speed. */
static double box_speed_after(const scene *s, const tuff_body *body, uint32_t bounces)
{
    int ball = yardstick_add_ball(s->yard, yard_state(body), ball_radius, (yardstick_material){ 1.0, 0.0 });
    while (bounces > 0) {
        yardstick_state before = yardstick_body(s->yard, ball), after;
        yardstick_step(s->yard);
        after = yardstick_body(s->yard, ball);
        double turn = hypot(after.velocity.x - before.velocity.x, after.velocity.y - before.velocity.y);
        if (turn > 0.01 * hypot(before.velocity.x, before.velocity.y)) bounces--;
    }
    return box_speed(s, ball);
}

/* Speed after so many bounces in the room; no call adds any. */
static double speed_in_room(const scene *s, tuff_body body, uint32_t bounces)
{
    while (bounces > 0) {
        double before = speed_of(body.velocity);
        uint16_t pushes = frame(s, &body, BALL);
        if (speed_of(body.velocity) > before * (1.0 + pushes * 2.0 * NORMAL_ERROR)) fail_msg("a frame added speed");
        if (exact_length(exact_vec2(body.position)) > 8 * EXACT_UNIT) fail_msg("the ball left the room");
        bounces -= pushes < bounces ? pushes : bounces;
    }
    return speed_of(body.velocity) / EXACT_UNIT;
}

/* What rounding toward zero may take: less than 1.42 LSB of speed a bounce, 2.2 units in 100,000. */
#define MOST_LOSS (EXACT_WHOLE ? 1.42 / EXACT_UNIT : 8.0 * NORMAL_ERROR)

static void test_a_ball_in_a_room_never_gains_speed(void **state)
{
    static scene s;
    random_run run = random_cases(__func__, 0, 100000);
    tuff_body body = { { TUFF_RATIO(1, 8), 0 }, { TUFF_RATIO(3, 2), TUFF_WHOLE(2) }, &elastic };
    (void)state;
    make_room(&s, 8.0);
    double ours = speed_in_room(&s, body, run.end), box = box_speed_after(&s, &body, run.end);
    yardstick_free(s.yard);
    assert_true(ours >= 2.5 - run.end * MOST_LOSS);
    table_row("speed after 100,000 bounces in a room, from 2.5 a step");
    table_box2d("%.3f", box);
    table_tuff("%.3f", ours);
}

/* ---- a ball between two walls, at the slowest ---- */

/* A 1,024th of a unit to either side: 128 steps from wall to wall. */
static void make_gap(scene *s)
{
    const double face = ball_radius + 1.0 / 1024.0, out = face + 32.0;
    const double left[4][2] = { { -out, -32.0 }, { -face, -32.0 }, { -face, 32.0 }, { -out, 32.0 } };
    const double right[4][2] = { { face, -32.0 }, { out, -32.0 }, { out, 32.0 }, { face, 32.0 } };
    make_scene(s, 0.0);
    add_wall(s, left);
    add_wall(s, right);
}

static void cross_the_gap(const scene *s, int speed, uint32_t bounces)
{
    tuff_body body = { { 0, 0 }, { TUFF_REAL_RAW(speed), 0 }, &elastic };
    uint32_t done = 0, frames = 0, most = bounces * (uint32_t)(128 / speed + 2);
    for (; done < bounces && frames < most; frames++) {
        uint16_t pushes = frame(s, &body, BALL);
        done += pushes;
        if (pushes > 1) fail_msg("one wall pushed twice");
    }
    if (done < bounces || frames < (done - 1) * (uint32_t)(128 / speed)) fail_msg("%d steps a step: the ball stuck to a wall", speed);
    assert_true(body.velocity.y == 0 && exact_abs(exact_real(body.velocity.x)) == speed);
}

static void test_the_slowest_bounce_for_ever_between_walls_at_their_speed(void **state)
{
    static const int speeds[] = { 1, 2, 3, 7, 30, 100, 128, 300 };
    static scene s;
    random_run run = random_cases(__func__, 0, 100000);
    (void)state;
    make_gap(&s);
    for (int i = 0; i < (int)(sizeof speeds / sizeof speeds[0]); i++) {
        cross_the_gap(&s, speeds[i], speeds[i] < 7 ? run.end / 10 + 1 : run.end);
    }
    yardstick_free(s.yard);
}

/* ---- slow balls at a slanted wall ---- */

/* A frame with another bounce; the push is tuff's. */
static uint16_t frame_by(const scene *s, tuff_body *body, bouncer *bounce)
{
    tuff_contact contact;
    uint16_t pushes = 0;
    body_fall(body, (tuff_vec2){ 0, 0 });
    for (int i = 0; i < s->world.terrain_count; i++) {
        if (!tuff_terrain_overlap_circle(&s->pieces[i], body->position, BALL, &contact)) continue;
        tuff_body still = body_at(body->position);
        tuff_bounce(&still, &contact);
        body->position = still.position;
        body->velocity = bounce(body->velocity, contact.normal, elastic);
        pushes++;
    }
    return pushes;
}

static tuff_vec2 to_zero(tuff_vec2 v, tuff_unit2 n, tuff_material material)
{
    return naive_bounce(v, n, material, NAIVE_TO_ZERO, NAIVE_USUAL);
}

#define WATCHED 64          /* frames */

/* Pushes in the frames that follow; bounce NULL: tuff's frame. */
static uint32_t pushes_of(const scene *s, tuff_body body, bouncer *bounce)
{
    uint32_t pushes = 0;
    for (int i = 0; i < WATCHED; i++) pushes += bounce ? frame_by(s, &body, bounce) : frame(s, &body, BALL);
    return pushes;
}

/* Against one of the room's walls, with this speed inwards at most. */
static tuff_body slow_ball(random_source *source, const scene *s, double most, tuff_unit2 *n)
{
    const tuff_terrain *wall = &s->pieces[random_below(source, WALLS)];
    exact2 from = exact_vec2(wall->parts[0].vertices[3]), to = exact_vec2(wall->parts[0].vertices[0]);
    *n = wall->parts[0].normals[3];
    exact2 out = scaled(exact_unit2(*n), exact_real(BALL)), at = exact_add(scaled(exact_add(from, to), 0.5), out);
    tuff_body body = { vec2_from_doubles((double)at.x, (double)at.y), { 0, 0 }, &elastic };
    do {
        body.velocity = any_velocity(source, SLOW);
    } while (along(body.velocity, *n) >= 0 || along(body.velocity, *n) < -most);
    return body;
}

/* In float a position 8 units from the origin has a sixteenth of a step; what is slower than a step may wait for it. */
#define LEAST_INWARD (EXACT_WHOLE ? 0.0 : 1.0)
#define MOST_PUSHES  3     /* of one slow bounce: where rounding leaves it inwards by a step or two, the next two frames take that too */

static void test_slow_balls_do_not_stick_to_a_slanted_wall(void **state)
{
    static scene s;
    random_run run = random_cases(__func__, 808, 4000);
    unsigned long others = 0, ours = 0, count = run.end - run.first;
    tuff_unit2 n;
    (void)state;
    make_room(&s, 8.0);
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        tuff_body body = slow_ball(&source, &s, 8.0, &n);
        others += pushes_of(&s, body, to_zero) > MOST_PUSHES;
        if (along(body.velocity, n) > -LEAST_INWARD) continue;
        uint32_t pushes = pushes_of(&s, body, NULL);
        ours += pushes > MOST_PUSHES;
        if (pushes > MOST_PUSHES) random_fail(&run, i, "%u pushes in %d frames", (unsigned)pushes, WATCHED);
    }
    yardstick_free(s.yard);
    if (EXACT_WHOLE && count >= 100) assert_true(others > count / 50);
    table_row("balls slower than 8 LSB that stick to a wall, per 1,000");
    table_fails("v.n rounded to 0", "%.0f", 1000.0 * (double)others / (double)count);
    table_tuff("%.0f", 1000.0 * (double)ours / (double)count);
    assert_int_equal(ours, 0);
}

/* ---- a ball on a floor ---- */

#define GRAVITY TUFF_RATIO(1, 64)
static const double gravity = 1.0 / 64.0;

/* Above the floor, in units. */
typedef struct fall {
    double highest;            /* after the first hit */
    double last_top, rise;     /* tops of its path after that: by how much one was above the one before, at most */
    double low, high;          /* in the last thousand steps */
    double before;
    bool   rising;
} fall;

static const fall fall_begun = { 0.0, 1e9, 0.0, 1e9, -1e9, 0.0, false };

static void watch(fall *seen, double height, bool hit, bool late)
{
    bool rising = height > seen->before;
    if (hit && seen->rising && !rising) {
        seen->rise = fmax(seen->rise, seen->before - seen->last_top);
        seen->last_top = seen->before;
    }
    if (hit) seen->highest = fmax(seen->highest, height);
    if (late) seen->low = fmin(seen->low, height);
    if (late) seen->high = fmax(seen->high, height);
    seen->rising = rising;
    seen->before = height;
}

/* The game's step: by the new speed; or by the old one, as the formula is often written down. */
typedef enum step_order { SPEED_FIRST, PLACE_FIRST } step_order;

static uint16_t fall_step(const scene *s, tuff_body *body, step_order order)
{
    if (order == SPEED_FIRST) body->velocity.y -= GRAVITY;
    body->position.x += body->velocity.x;
    body->position.y += body->velocity.y;
    if (order == PLACE_FIRST) body->velocity.y -= GRAVITY;
    return tuff_terrain_collide_circle(&s->world, body, BALL);
}

static tuff_body ball_above_floor(double height)
{
    return body_at((tuff_vec2){ 0, BALL + random_point_at(height, 0.0).x });
}

/* trace: every so many steps a point of the picture's curve; 0: none. */
static fall drop_ball(const scene *s, tuff_real restitution, double height, uint32_t steps, step_order order, uint32_t trace)
{
    tuff_material material = { restitution, 0 };
    tuff_body body = ball_above_floor(height);
    fall seen = fall_begun;
    bool hit = false;
    body.material = &material;
    for (uint32_t i = 0; i < steps; i++) {
        hit |= fall_step(s, &body, order) > 0;
        double now = units_of(body.position.y) - ball_radius;
        watch(&seen, now, hit, i + 1000 >= steps);
        if (trace && i % trace == 0) picture_point(i, now);
    }
    return seen;
}

static fall drop_box(double restitution, double height, uint32_t steps, uint32_t trace)
{
    static scene s;
    tuff_body body = ball_above_floor(height);
    fall seen = fall_begun;
    bool hit = false;
    make_floor(&s, gravity);
    int ball = yardstick_add_ball(s.yard, yard_state(&body), ball_radius, (yardstick_material){ restitution, 0.0 });
    for (uint32_t i = 0; i < steps; i++) {
        yardstick_step(s.yard);
        yardstick_state now = yardstick_body(s.yard, ball);
        hit |= now.velocity.y > 0;
        watch(&seen, now.position.y - ball_radius, hit, i + 1000 >= steps);
        if (trace && i % trace == 0) picture_point(i, now.position.y - ball_radius);
    }
    yardstick_free(s.yard);
    return seen;
}

/* A push is rounded to a step; in float, at 2 to 16 units, positions have an eighth of one. */
static const double still = 2.0 / EXACT_UNIT;

static void test_a_ball_on_a_floor_rises_no_higher_and_comes_to_rest(void **state)
{
    static scene s;
    random_run run = random_cases(__func__, 0, 100000);
    uint32_t steps = run.end > 20000 ? run.end : 20000;
    (void)state;
    make_floor(&s, gravity);
    for (int e = 0; e < RESTITUTIONS; e++) {
        fall dropped = drop_ball(&s, restitutions[e], 8.0, steps, SPEED_FIRST, 0);
        fall laid = drop_ball(&s, restitutions[e], 0.0, 10000, SPEED_FIRST, 0);
        double share = units_of(restitutions[e]);
        assert_true(dropped.highest <= 8.0 * share * share + units_of(GRAVITY) && dropped.rise <= still);
        assert_true(laid.highest <= still && laid.high - laid.low <= still);
        if (share < 1.0) assert_true(dropped.high - dropped.low <= still);
    }
    yardstick_free(s.yard);
}

static void test_moving_before_gravity_makes_balls_rise_and_hop(void **state)
{
    static scene s;
    random_run run = random_cases(__func__, 0, 100000);
    uint32_t steps = run.end > 20000 ? run.end : 20000;
    const tuff_real lively = TUFF_RATIO(9, 10);
    (void)state;
    make_floor(&s, gravity);
    fall late = drop_ball(&s, TUFF_WHOLE(1), 8.0, steps, PLACE_FIRST, 0), ours = drop_ball(&s, TUFF_WHOLE(1), 8.0, steps, SPEED_FIRST, 0);
    fall hopping = drop_ball(&s, lively, 8.0, steps, PLACE_FIRST, 0), resting = drop_ball(&s, lively, 8.0, steps, SPEED_FIRST, 0);
    fall box = drop_box(1.0, 8.0, steps, 0), box_resting = drop_box(0.9, 8.0, steps, 0);
    yardstick_free(s.yard);
    assert_true(late.highest > 9.0 && hopping.high - hopping.low > 0.1);
    assert_true(ours.highest < 8.0 && resting.high - resting.low <= still);
    table_row("ball dropped from 8, restitution 1: highest, 100,000 steps");
    table_fails("step by the old speed", "%.1f", late.highest);
    table_box2d("%.1f", box.highest);
    table_tuff("%.2f", ours.highest);
    table_row("hop of that ball at rest, restitution 0.9, units");
    table_fails("step by the old speed", "%.2f", hopping.high - hopping.low);
    table_box2d("%.2f", box_resting.high - box_resting.low);
    table_tuff("%.5f", resting.high - resting.low);
}

/* ---- the picture ---- */

static void draw_slow_bounces(void)
{
    picture_chart("Slow bounces, restitution 1", "bounces", "log", "speed, LSB a step", "log");
    picture_line(PICTURE_FAILS, NULL);
    bounce_on(to_floor, 100000, true);
    picture_line_end();
    picture_line(PICTURE_TUFF, NULL);
    bounce_on(tuff_bounced, 434, true);
    picture_line_end();
}

static void draw_distance(const scene *s, picture_role role, tuff_body body, tuff_unit2 n, bouncer *bounce)
{
    exact2 start = exact_vec2(body.position);
    picture_line(role, NULL);
    for (int i = 0; i < WATCHED; i++) {
        picture_point(i, (double)exact_dot(exact_sub(exact_vec2(body.position), start), exact_unit2(n)));
        if (bounce) frame_by(s, &body, bounce);
        else frame(s, &body, BALL);
    }
    picture_line_end();
}

static void draw_slow_ball(void)
{
    static scene s;
    random_source source = random_stream(809, 0);
    tuff_unit2 n;
    tuff_body body;
    make_room(&s, 8.0);
    do {
        body = slow_ball(&source, &s, 1.9, &n);
    } while (along(body.velocity, n) > -1.8 || pushes_of(&s, body, to_zero) < WATCHED / 2);
    picture_chart("1.9 LSB a step into a slanted wall", "frames", "linear", "from the wall, LSB", "linear");
    draw_distance(&s, PICTURE_FAILS, body, n, to_zero);
    draw_distance(&s, PICTURE_TUFF, body, n, NULL);
    yardstick_free(s.yard);
}

static void draw_floor(void)
{
    static scene s;
    make_floor(&s, gravity);
    picture_chart("Dropped from 8, restitution 0.9", "steps", "linear", "height, units", "linear");
    picture_line(PICTURE_FAILS, NULL);
    drop_ball(&s, TUFF_RATIO(9, 10), 8.0, 1000, PLACE_FIRST, 2);
    picture_line_end();
    picture_line(PICTURE_BOX2D, NULL);
    drop_box(0.9, 8.0, 1000, 2);
    picture_line_end();
    picture_line(PICTURE_TUFF, NULL);
    drop_ball(&s, TUFF_RATIO(9, 10), 8.0, 1000, SPEED_FIRST, 2);
    picture_line_end();
    yardstick_free(s.yard);
}

static void draw_picture(void)
{
    if (!picture_begin("bounce")) return;
    draw_slow_bounces();
    draw_slow_ball();
    draw_floor();
    picture_end();
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_slow_bounces_rounded_to_nearest_or_down_gain_speed_and_tuffs_do_not),
        cmocka_unit_test(test_no_restitution_up_to_1_adds_speed),
        cmocka_unit_test(test_friction_and_restitution_have_no_order_and_e_above_1_gains_what_it_says),
        cmocka_unit_test(test_friction_by_the_speed_from_before_drives_bodies_in),
        cmocka_unit_test(test_a_coefficient_taken_for_the_impulse_factor_does_not_bounce),
        cmocka_unit_test(test_a_body_that_leaves_is_let_go),
        cmocka_unit_test(test_a_narrowed_speed_jumps_off_the_wall_and_tuffs_does_not),
        cmocka_unit_test(test_a_ball_in_a_room_never_gains_speed),
        cmocka_unit_test(test_the_slowest_bounce_for_ever_between_walls_at_their_speed),
        cmocka_unit_test(test_slow_balls_do_not_stick_to_a_slanted_wall),
        cmocka_unit_test(test_a_ball_on_a_floor_rises_no_higher_and_comes_to_rest),
        cmocka_unit_test(test_moving_before_gravity_makes_balls_rise_and_hop),
    };
    (void)argc;
    random_begin(argv);
    table_family(8, "Bounce");
    draw_picture();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
