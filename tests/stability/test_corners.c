/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Family 2, corners: bodies fall into them and stay for 10,000 steps. Do they come to rest, gain energy, sink through a wall? */
#include "handed.h"
#include "naive.h"
#include "oracle.h"
#include "picture.h"
#include "pieces.h"
#include "table.h"

#define DEGREE    0.017453292519943295
#define GRAVITY   0.125                 /* units a step, each step */
#define RADIUS    6                     /* of the ball; half a side of the box */
#define MOST      3                     /* walls */
#define THICK     24.0                  /* of a wall, in units */
#define WINDOWS   20                    /* in which energy is compared */

/* ---- scenes ---- */

enum { V_20, V_45, V_60, V_90, V_TILTED, V_120, V_150, U_WIDE, U_SNUG, SLOT, WEDGE, THREE, POCKET, CORNERS };

typedef struct corner {                 /* not to be copied: the pieces point into it */
    random_shape walls[MOST];
    tuff_polygon parts[MOST];
    tuff_terrain pieces[MOST];
    uint16_t     count;
    tuff_vec2    start;
} corner;

/* Along a line, solid to its right. */
static void add_wall(corner *c, double from_x, double from_y, double to_x, double to_y)
{
    random_shape *wall = &c->walls[c->count];
    double length = hypot(to_x - from_x, to_y - from_y);
    double across_x = (to_y - from_y) / length * THICK, across_y = (from_x - to_x) / length * THICK;
    wall->vertices[0] = grid_point(from_x, from_y);
    wall->vertices[1] = grid_point(from_x + across_x, from_y + across_y);
    wall->vertices[2] = grid_point(to_x + across_x, to_y + across_y);
    wall->vertices[3] = grid_point(to_x, to_y);
    random_bake(wall, 4);
    c->parts[c->count] = wall->polygon;
    c->pieces[c->count] = convex_piece(wall, (tuff_vec2){ 0, 0 });
    c->count++;
}

/* A body starts 4 units above its rest, a little beside the middle. */
static void make_vee(corner *c, double degrees, double tilt)
{
    double half = degrees / 2 * DEGREE, lean = tilt * DEGREE, length = degrees < 10 ? 160 : 96, height = RADIUS / sin(half) + 4;
    add_wall(c, length * sin(lean - half), length * cos(lean - half), 0, 0);
    add_wall(c, 0, 0, length * sin(lean + half), length * cos(lean + half));
    c->start = grid_point(0.25 + height * sin(lean), height * cos(lean));
}

static void make_pit(corner *c, double half, double beside)
{
    add_wall(c, -half, 40, -half, 0);
    add_wall(c, -half - THICK, 0, half + THICK, 0);
    add_wall(c, half, 0, half, 40);
    c->start = grid_point(beside, 20);
}

/* A gap narrower than the body, which starts too low to roll away. */
static void make_slot(corner *c)
{
    add_wall(c, -40, 0, -4, 0);
    add_wall(c, 4, 0, 40, 0);
    c->start = grid_point(0.25, 5.5);
}

/* A floor and two slopes that the ball touches all at once; it starts 3 units deep in all of them. */
static void make_three(corner *c)
{
    double half = RADIUS * tan(30 * DEGREE);
    add_wall(c, -half - 20, 40 * sin(60 * DEGREE), -half, 0);
    add_wall(c, -half, 0, half, 0);
    add_wall(c, half, 0, half + 20, 40 * sin(60 * DEGREE));
    c->start = grid_point(0.25, 3);
}

/* A triangle too small for the body: there is no rest. */
static void make_pocket(corner *c)
{
    for (int i = 0; i < MOST; i++) {
        double x = cos((120 * i - 90) * DEGREE), y = sin((120 * i - 90) * DEGREE);
        add_wall(c, 4 * x + 60 * y, 4 * y - 60 * x, 4 * x - 60 * y, 4 * y + 60 * x);
    }
    c->start = grid_point(0.25, 0.5);
}

static const double vee_degrees[] = { 20, 45, 60, 90, 90, 120, 150 };

static void make_corner(corner *c, int kind)
{
    c->count = 0;
    if (kind <= V_150) make_vee(c, vee_degrees[kind], kind == V_TILTED ? 20 : 0);
    if (kind == U_WIDE) make_pit(c, 10, 1.25);
    if (kind == U_SNUG) make_pit(c, RADIUS, 0);
    if (kind == SLOT) make_slot(c);
    if (kind == WEDGE) make_vee(c, 5, 0);
    if (kind == THREE) make_three(c);
    if (kind == POCKET) make_pocket(c);
}

/* The walls as parts of one piece, with no edge in common. */
static void join_walls(corner *c)
{
    tuff_real cover = TUFF_WHOLE(0);
    for (int i = 0; i < c->count; i++) cover = c->pieces[i].bounding_radius > cover ? c->pieces[i].bounding_radius : cover;
    c->pieces[0] = (tuff_terrain){ { 0, 0 }, cover, cover, c->parts, (uint8_t)c->count };
    c->count = 1;
}

/* ---- methods ---- */

typedef struct mover {                  /* hull NULL: the ball */
    const tuff_polygon *hull;
    tuff_real radius;
} mover;

typedef uint16_t method(const corner *c, tuff_body *body, mover m);

static uint16_t collide(const corner *c, tuff_body *body, mover m, uint8_t order)
{
    tuff_world world = plain_world(c->pieces, c->count, order);
    return tuff_terrain_collide(&world, body, m.radius, m.hull);
}

static uint16_t in_turn(const corner *c, tuff_body *body, mover m)       { return collide(c, body, m, TUFF_ORDER_ITERATION); }
static uint16_t deepest_first(const corner *c, tuff_body *body, mover m) { return collide(c, body, m, TUFF_ORDER_DEEPEST); }

static uint16_t by_textbook(const corner *c, tuff_body *body, mover m)
{
    return naive_collide(c->pieces, c->count, body, m.radius, m.hull);
}

/* Another way that looks right: find all contacts where the body is, then add up their pushes. */
static uint16_t all_at_once(const corner *c, tuff_body *body, mover m)
{
    tuff_contact contacts[MOST];
    uint16_t count = 0;
    for (int i = 0; i < c->count; i++) {
        if (tuff_terrain_overlap_hull(&c->pieces[i], body->position, m.radius, m.hull, &contacts[count])) count++;
    }
    for (int i = 0; i < count; i++) tuff_bounce(body, &contacts[i]);
    return count;
}

/* ---- runs ---- */

typedef struct watch {                  /* in units */
    double low_x, high_x, low_y, high_y;
} watch;

typedef struct figures {
    double jitter;                      /* how far the body wanders in the last quarter of the run, and in the quarter before */
    double jitter_before;
    double growth;                      /* the most that a window's energy exceeds that of an earlier one */
    double sunk;                        /* the deepest in a wall at the end of a step, in the second half */
    double speed;                       /* the highest at the end of a step */
    uint16_t pushes;                    /* the most of a call */
    bool     fell;                      /* through */
} figures;

static int steps_of_run(void)
{
    int steps = (int)(100 * random_environment("TUFF_TEST_SCALE", 100));
    return (steps < 2000 ? 2000 : steps) / WINDOWS * WINDOWS;
}

static watch nothing_seen(void)
{
    return (watch){ HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL };
}

static void see(watch *w, double x, double y)
{
    w->low_x = fmin(w->low_x, x);
    w->high_x = fmax(w->high_x, x);
    w->low_y = fmin(w->low_y, y);
    w->high_y = fmax(w->high_y, y);
}

static double wandered(const watch *w)
{
    return fmax(w->high_x - w->low_x, w->high_y - w->low_y);
}

/* How deep the body is in its deepest wall, exactly, in units; 0: in none. */
static double depth_in_walls(const corner *c, tuff_vec2 at, mover m)
{
    double most = 0;
    for (int i = 0; i < c->count * c->pieces[0].part_count; i++) {
        oracle_polygon wall, hull;
        oracle_answer answer;
        oracle_read_polygon(&wall, &c->parts[i]);
        if (m.hull) oracle_read_polygon(&hull, m.hull);
        if (m.hull) oracle_hull(&wall, &hull, exact_vec2(at), &answer);
        else oracle_circle(&wall, exact_vec2(at), exact_real(m.radius), &answer);
        raise_to(&most, answer.depth);
    }
    return most / EXACT_UNIT;
}

/* What fell through a wall is followed no farther. Beyond 181 units from a vertex the textbook's squares would overflow. */
static const double lost = -12;

static uint16_t advance(const corner *c, method *step, tuff_body *body, mover m)
{
    if (units_of(body->position.y) < lost) return 0;
    body_fall(body, (tuff_vec2){ 0, -TUFF_RATIO(1, 8) });
    return step(c, body, m);
}

static double energy_of(const tuff_body *body)
{
    return body_speed(body) * body_speed(body) / 2 + GRAVITY * units_of(body->position.y);
}

/* The highest energy of one window's steps; the watch sees where the body is at the end of each. */
static double run_window(const corner *c, method *step, tuff_body *body, mover m, watch *seen, figures *f)
{
    double energy = -HUGE_VAL;
    for (int i = 0; i < steps_of_run() / WINDOWS; i++) {
        uint16_t pushes = advance(c, step, body, m);
        if (pushes > f->pushes) f->pushes = pushes;
        f->speed = fmax(f->speed, body_speed(body));
        energy = fmax(energy, energy_of(body));
        see(seen, units_of(body->position.x), units_of(body->position.y));
    }
    return energy;
}

static figures run_corner(const corner *c, method *step, mover m, const tuff_material *material)
{
    figures f = { 0, 0, 0, 0, 0, 0, false };
    tuff_body body = { c->start, { 0, 0 }, material };
    watch before = nothing_seen(), last = nothing_seen(), early = nothing_seen();
    double energy = HUGE_VAL;
    for (int i = 0; i < WINDOWS; i++) {
        watch *seen = i >= WINDOWS * 3 / 4 ? &last : i >= WINDOWS / 2 ? &before : &early;
        double highest = run_window(c, step, &body, m, seen, &f);
        f.growth = fmax(f.growth, highest - energy);     /* the first window is where it falls, or is pushed out of where it began */
        energy = fmin(energy, highest);
        if (i >= WINDOWS / 2) f.sunk = fmax(f.sunk, depth_in_walls(c, body.position, m));
    }
    f.fell = units_of(body.position.y) < lost;
    if (f.fell) f.sunk = HUGE_VAL;
    f.jitter = f.fell ? HUGE_VAL : wandered(&last);
    f.jitter_before = wandered(&before);
    return f;
}

/* ---- all corners, bodies, orders and materials ---- */

typedef struct setting {
    int  kind;
    bool box, deepest;
    int  restitution, friction;         /* numbers in the lists below */
} setting;

#define RESTITUTIONS 4
#define FRICTIONS    2

static const tuff_real restitutions[RESTITUTIONS] = { TUFF_WHOLE(0), TUFF_RATIO(9, 100), TUFF_RATIO(1, 2), TUFF_WHOLE(1) };
static const tuff_real frictions[FRICTIONS] = { TUFF_WHOLE(0), TUFF_RATIO(1, 100) };
static const char *const restitution_names[RESTITUTIONS] = { "0", "0.09", "0.5", "1" };
static const char *const corner_names[CORNERS] = { "V 20", "V 45", "V 60", "V 90", "V 90 tilted", "V 120", "V 150", "U", "snug U", "slot",
                                                   "wedge", "three at once", "pocket" };

#define SETTINGS (CORNERS * 2 * 2 * RESTITUTIONS * FRICTIONS)

static random_shape box;
static figures measured[SETTINGS];      /* by run_all, before the tests */

static setting setting_of(int number)
{
    return (setting){ number / (4 * RESTITUTIONS * FRICTIONS), number / (2 * RESTITUTIONS * FRICTIONS) % 2 == 1,
                      number / (RESTITUTIONS * FRICTIONS) % 2 == 1, number / FRICTIONS % RESTITUTIONS, number % FRICTIONS };
}

static mover mover_of(bool is_box)
{
    return is_box ? (mover){ &box.polygon, box.bounding_radius } : (mover){ NULL, TUFF_WHOLE(RADIUS) };
}

static figures figures_in(int kind, method *step, bool is_box, int restitution, int friction)
{
    static corner c;
    tuff_material material = { restitutions[restitution], frictions[friction] };
    make_corner(&c, kind);
    return run_corner(&c, step, mover_of(is_box), &material);
}

static int run_all(void **state)
{
    (void)state;
    random_box_shape(&box, (tuff_vec2){ TUFF_WHOLE(RADIUS), TUFF_WHOLE(RADIUS) });
    for (int i = 0; i < SETTINGS; i++) {
        setting s = setting_of(i);
        measured[i] = figures_in(s.kind, s.deepest ? deepest_first : in_turn, s.box, s.restitution, s.friction);
    }
    return 0;
}

static void print_setting(setting s, const figures *f)
{
    print_error("%s, %s, %s, restitution %s, friction %s: jitter %.6f, before %.6f, growth %.6f, sunk %.6f, speed %.3f, pushes %u\n",
                corner_names[s.kind], s.box ? "box" : "ball", s.deepest ? "deepest first" : "in turn", restitution_names[s.restitution],
                s.friction ? "0.01" : "0", f->jitter, f->jitter_before, f->growth, f->sunk, f->speed, f->pushes);
}

typedef bool setting_filter(setting s);
typedef double figure_of(const figures *f);

static double jitter_of(const figures *f) { return f->jitter; }
static double growth_of(const figures *f) { return f->growth; }

/* The largest figure of the settings that the filter takes; prints those above the bound. */
static double most_of(setting_filter *wanted, figure_of *figure, double bound)
{
    double most = 0;
    for (int i = 0; i < SETTINGS; i++) {
        if (!wanted(setting_of(i))) continue;
        if (figure(&measured[i]) > bound) print_setting(setting_of(i), &measured[i]);
        most = fmax(most, figure(&measured[i]));
    }
    return most;
}

/* ---- what is asked ---- */

static const double still = TUFF_SCALAR == TUFF_Q16_16 ? 2.0 / 65536 : 1e-4;     /* jitter of a body at rest */

static bool falls_through(setting s) { return s.kind == WEDGE && !s.deepest; }
static bool bounces_on(setting s)    { return s.restitution == RESTITUTIONS - 1; }

/* Walls that open by more than a right angle: a push out of one also leads away from the other. The slot's two corners are such
   for the ball. */
static bool is_obtuse(setting s)
{
    return s.kind == V_120 || s.kind == V_150 || (s.kind == SLOT && !s.box);
}

static bool can_rest(setting s)
{
    return !bounces_on(s) && !is_obtuse(s) && !falls_through(s) && s.kind != POCKET;
}

static void test_bodies_come_to_rest_in_corners_up_to_a_right_angle(void **state)
{
    double most = most_of(can_rest, jitter_of, still);
    (void)state;
    print_message("figures: " EXACT_BUILD " corners: jitter %.8f at rest\n", most);
    assert_true(most <= still);
}

static bool keeps_energy(setting s)
{
    return !falls_through(s) && !(s.kind == POCKET && bounces_on(s));
}

/* A step of free flight takes g^2 / 2, since the speed changes before the position does: so much may the highest of a window's
   samples miss. */
static const double sampling = GRAVITY * GRAVITY / 2;

static bool goes_on(setting s) { return keeps_energy(s) && !can_rest(s); }

static void test_energy_does_not_grow(void **state)
{
    double calm = most_of(can_rest, growth_of, still), lively = most_of(goes_on, growth_of, sampling);
    (void)state;
    print_message("figures: " EXACT_BUILD " corners: energy grows by %.8f at rest, by %.8f in motion\n", calm, lively);
    assert_true(calm <= still && lively <= sampling);
}

static void test_no_call_makes_more_pushes_than_allowed(void **state)
{
    uint16_t most = 0;
    (void)state;
    for (int i = 0; i < SETTINGS; i++) most = measured[i].pushes > most ? measured[i].pushes : most;
    assert_int_equal(most, TUFF_MAX_PUSHES);
}

/* Between walls that meet at an angle, each push of a call but the first makes speed and overlap smaller by its cosine, q in
   all. Falling, that allows a speed of g / (1 - q) and an overlap of twice what that speed adds to it each step, over 1 - q.
   For small angles: 4 g / (m^2 angle^3), m pushes. */
static double sunk_at_most(double angle, int pushes)
{
    double q = pow(fmax(cos(angle), 0), pushes);
    return 2 * GRAVITY * sin(angle / 2) / ((1 - q) * (1 - q));
}

static double angle_of(int kind)
{
    return DEGREE * (kind <= V_150 ? vee_degrees[kind] : kind == WEDGE ? 5 : kind == THREE ? 60 : 90);
}

static bool sinks_too_deep(int number)
{
    setting s = setting_of(number);
    if (s.kind == POCKET || falls_through(s)) return false;
    return measured[number].sunk > sunk_at_most(angle_of(s.kind), s.deepest ? TUFF_MAX_PUSHES : 2);
}

static void test_no_body_sinks_deeper_than_the_pushes_of_a_call_allow(void **state)
{
    double most = 0;
    int faults = 0;
    (void)state;
    for (int i = 0; i < SETTINGS; i++) {
        if (sinks_too_deep(i)) print_setting(setting_of(i), &measured[i]);
        faults += sinks_too_deep(i);
        if (setting_of(i).kind == WEDGE && setting_of(i).deepest) most = fmax(most, measured[i].sunk);
    }
    print_message("figures: " EXACT_BUILD " corners: in a wedge of 5 degrees, deepest first, at most %.3f units deep\n", most);
    assert_int_equal(faults, 0);
    assert_true(most < THICK / 2);
}

/* ---- what is left ---- */

static bool is_obtuse_by_depth(setting s)   { return is_obtuse(s) && s.deepest && !bounces_on(s); }
static bool is_obtuse_in_turn(setting s)    { return is_obtuse(s) && !s.deepest && !bounces_on(s); }

static double jitter_growth_of(const figures *f) { return f->jitter - f->jitter_before; }

/* The second push of a call goes past the corner by the cosine of the angle times its own length, a step's fall at most, and
   the next step's comes from the other side. In turn the side does not change, but what is left of the speed along the walls
   swings to and fro. */
static void test_beyond_a_right_angle_bodies_tremble_and_no_more(void **state)
{
    const double shake = GRAVITY / 2, swing = 4 * GRAVITY;
    double by_depth = most_of(is_obtuse_by_depth, jitter_of, shake), by_turn = most_of(is_obtuse_in_turn, jitter_of, swing);
    (void)state;
    print_message("figures: " EXACT_BUILD " corners: wider than 90 degrees, jitter %.4f deepest first, %.4f in turn\n", by_depth, by_turn);
    assert_true(by_depth <= shake && by_turn <= swing);
    assert_true(most_of(is_obtuse_by_depth, jitter_growth_of, GRAVITY / 8) <= GRAVITY / 8);
    assert_true(most_of(is_obtuse_in_turn, jitter_growth_of, GRAVITY / 8) <= GRAVITY / 8);
}

static bool has_no_room(setting s)         { return s.kind == POCKET && !bounces_on(s); }
static bool has_no_room_in_turn(setting s) { return has_no_room(s) && !s.deepest; }

static double speed_figure(const figures *f) { return f->speed; }

/* Without room there is no rest to come to: in turn the body stays where it is, deepest first it goes from corner to corner of
   the pocket, whose inner radius is 4: no farther than a body is wide. */
static void test_a_pocket_too_small_neither_speeds_up_nor_lets_go(void **state)
{
    (void)state;
    assert_true(most_of(has_no_room, speed_figure, 1) <= 1);
    assert_true(most_of(has_no_room_in_turn, jitter_of, still) <= still);
    assert_true(most_of(has_no_room, jitter_of, 2 * RADIUS) <= 2 * RADIUS);
}

/* ---- inside three pieces at once ---- */

static double left_after_one_call(method *step, bool is_box)
{
    static corner c;
    make_corner(&c, THREE);
    tuff_body body = body_at(c.start);
    step(&c, &body, mover_of(is_box));
    return depth_in_walls(&c, body.position, mover_of(is_box));
}

/* The ball touches all three walls where it belongs. The box only the slopes: what is left halves with each push at the least. */
static void test_one_call_leads_out_of_three_pieces_at_once(void **state)
{
    const double residue = TUFF_SCALAR == TUFF_Q16_16 ? 2.0 / 65536 : 1e-4, share = pow(0.5, TUFF_MAX_PUSHES - MOST);
    (void)state;
    assert_true(left_after_one_call(by_textbook, true) > 2);
    assert_true(left_after_one_call(deepest_first, true) <= residue + 2 * RADIUS * share);
    assert_true(left_after_one_call(deepest_first, false) <= residue);
}

/* ---- methods that fail ---- */

static const int default_restitution = 1, half_restitution = 2, no_friction = 0, some_friction = 1;     /* numbers in the lists */

static void test_the_textbook_falls_through_a_wedge(void **state)
{
    (void)state;
    for (int is_box = 0; is_box < 2; is_box++) {
        assert_true(figures_in(WEDGE, by_textbook, is_box, default_restitution, some_friction).fell);
        assert_true(figures_in(WEDGE, deepest_first, is_box, default_restitution, some_friction).jitter <= still);
    }
}

static void test_the_textbook_rests_deep_in_a_narrow_corner(void **state)
{
    (void)state;
    for (int is_box = 0; is_box < 2; is_box++) {
        assert_true(figures_in(V_20, by_textbook, is_box, default_restitution, some_friction).sunk > 2);
        assert_true(figures_in(V_20, deepest_first, is_box, default_restitution, some_friction).sunk < 0.1);
    }
}

static void test_all_pushes_at_once_never_come_to_rest(void **state)
{
    (void)state;
    assert_true(figures_in(V_20, all_at_once, false, half_restitution, some_friction).jitter > 1);
    assert_true(figures_in(V_20, deepest_first, false, half_restitution, some_friction).jitter <= still);
}

/* In turn, two pieces are left by one push each; the parts of one piece are tested again. */
static void test_a_wedge_of_one_piece_holds_in_either_order(void **state)
{
    static corner c;
    tuff_material material = { restitutions[default_restitution], frictions[no_friction] };
    (void)state;
    for (int is_box = 0; is_box < 2; is_box++) {
        make_corner(&c, WEDGE);
        join_walls(&c);
        figures f = run_corner(&c, in_turn, mover_of(is_box), &material);
        assert_true(f.jitter <= still && f.sunk <= sunk_at_most(5 * DEGREE, TUFF_MAX_PUSHES));
        assert_true(figures_in(WEDGE, in_turn, is_box, default_restitution, no_friction).fell);
    }
}

/* ---- Box2D ---- */

static yardstick *yard_of(const corner *c)
{
    yardstick *yard = yardstick_new((yardstick_vec){ 0, -GRAVITY }, true);
    for (int i = 0; i < c->count; i++) assert_true(yard_add_piece(yard, &c->pieces[i]));
    return yard;
}

typedef struct yard_run {
    corner     c;
    yardstick *yard;
    int        body;
} yard_run;

/* Without friction. */
static void begin_box2d(yard_run *run, int kind, bool is_box, int restitution)
{
    yardstick_material material = { units_of(restitutions[restitution]), 0 };
    make_corner(&run->c, kind);
    run->yard = yard_of(&run->c);
    yardstick_state start = { yard_vec(run->c.start), { 0, 0 } };
    run->body = is_box ? yard_add_hull(run->yard, start, &box.polygon, material)
                       : yardstick_add_ball(run->yard, start, RADIUS, material);
}

static yardstick_vec step_box2d(yard_run *run)
{
    yardstick_step(run->yard);
    return yardstick_body(run->yard, run->body).position;
}

static figures box2d_in(int kind, int restitution)
{
    static yard_run run;
    figures f = { 0, 0, 0, 0, 0, 0, false };
    watch seen = nothing_seen();
    int steps = steps_of_run();
    begin_box2d(&run, kind, false, restitution);
    for (int i = 0; i < steps; i++) {
        yardstick_vec at = step_box2d(&run);
        if (i < steps * 3 / 4) continue;
        see(&seen, at.x, at.y);
        if (i % 100 == 0) f.sunk = fmax(f.sunk, depth_in_walls(&run.c, random_point_at(at.x, at.y), mover_of(false)));
    }
    yardstick_free(run.yard);
    f.jitter = wandered(&seen);
    return f;
}

static double box2d_after_one_step(int kind)
{
    static yard_run run;
    begin_box2d(&run, kind, true, default_restitution);
    yardstick_vec at = step_box2d(&run);
    yardstick_free(run.yard);
    return depth_in_walls(&run.c, random_point_at(at.x, at.y), mover_of(true));
}

/* ---- table ---- */

static void sunk_row(const char *measure, int kind)
{
    figures f = figures_in(kind, by_textbook, false, default_restitution, some_friction);
    table_row(measure);
    if (f.fell) table_fails("textbook", "falls through");
    else table_fails("textbook", "%.2f", f.sunk);
    table_box2d("%.2f", box2d_in(kind, default_restitution).sunk);
    table_tuff("%.2f", figures_in(kind, deepest_first, false, default_restitution, no_friction).sunk);
}

static void jitter_row(const char *measure, int kind, const char *name, method *step, int restitution)
{
    table_row(measure);
    table_fails(name, "%.4f", figures_in(kind, step, false, restitution, some_friction).jitter);
    table_box2d("%.4f", box2d_in(kind, restitution).jitter);
    table_tuff("%.4f", figures_in(kind, deepest_first, false, restitution, no_friction).jitter);
}

static void make_table(void)
{
    sunk_row("wedge of 5 degrees, at rest, units deep in a wall", WEDGE);
    sunk_row("V of 20 degrees, at rest, units deep in a wall", V_20);
    table_row("box in three pieces at once, after a step, units deep");
    table_fails("textbook", "%.2f", left_after_one_call(by_textbook, true));
    table_box2d("%.2f", box2d_after_one_step(THREE));
    table_tuff("%.2f", left_after_one_call(deepest_first, true));
    print_message("figures: " EXACT_BUILD " corners: in the wedge Box2D's ball wanders by %.4f units\n",
                  box2d_in(WEDGE, default_restitution).jitter);
    jitter_row("V of 20 degrees, restitution 0.5, jitter in units", V_20, "all at once", all_at_once, half_restitution);
    jitter_row("V of 120 degrees, jitter in units", V_120, "textbook", by_textbook, default_restitution);
}

/* ---- picture ---- */

static const char *const label_in_turn = "textbook, and tuff in turn", *const label_deepest = "tuff, deepest first";

/* Where the ball rests, and how deep in a wall. */
static double draw_rest(const corner *c, method *step, picture_role role, const char *label)
{
    tuff_material material = { restitutions[default_restitution], frictions[some_friction] };
    tuff_body body = { c->start, { 0, 0 }, &material };
    for (int i = 0; i < 1000; i++) advance(c, step, &body, mover_of(false));
    picture_line(role, label);
    for (int i = 0; i <= 360; i += 5) {
        picture_point(units_of(body.position.x) + RADIUS * cos(i * DEGREE), units_of(body.position.y) + RADIUS * sin(i * DEGREE));
    }
    picture_line_end();
    return depth_in_walls(c, body.position, mover_of(false));
}

static void draw_narrow_corner(void)
{
    static corner c;
    char note[40];
    make_corner(&c, V_20);
    picture_panel("V of 20 degrees: where a ball rests", -16, 10, 16, 44);
    for (int i = 0; i < c.count; i++) picture_piece(&c.pieces[i]);
    snprintf(note, sizeof note, "%.1f deep", draw_rest(&c, by_textbook, PICTURE_FAILS, label_in_turn));
    picture_note(-4.3, 26.5, note);
    snprintf(note, sizeof note, "%.2f deep", draw_rest(&c, deepest_first, PICTURE_TUFF, label_deepest));
    picture_note(-3.9, 41, note);
}

static void draw_fall(const corner *c, method *step, picture_role role, const char *label)
{
    tuff_material material = { restitutions[default_restitution], frictions[some_friction] };
    tuff_body body = { c->start, { 0, 0 }, &material };
    picture_line(role, label);
    for (int i = 0; i < 300 && units_of(body.position.y) > lost; i += 2) {
        picture_point(i, units_of(body.position.y));
        advance(c, step, &body, mover_of(false));
        advance(c, step, &body, mover_of(false));
    }
    picture_line_end();
}

static void draw_wedge(void)
{
    static yard_run run;
    picture_chart("Wedge of 5 degrees: height of the ball", "steps", "linear", "units above the point", "linear");
    begin_box2d(&run, WEDGE, false, default_restitution);
    draw_fall(&run.c, by_textbook, PICTURE_FAILS, label_in_turn);
    draw_fall(&run.c, deepest_first, PICTURE_TUFF, label_deepest);
    picture_line(PICTURE_BOX2D, "");
    for (int i = 0; i < 300; i++) picture_point(i, step_box2d(&run).y);
    picture_line_end();
    yardstick_free(run.yard);
}

static void draw_depth(method *step, picture_role role, const char *label, double from)
{
    static corner c;
    tuff_material material = { restitutions[default_restitution], frictions[some_friction] };
    picture_line(role, label);
    for (double degrees = from; degrees <= 60; degrees += 5) {
        c.count = 0;
        make_vee(&c, degrees, 0);
        picture_point(degrees, fmax(run_corner(&c, step, mover_of(false), &material).sunk, 1e-5));
    }
    picture_line_end();
}

static void draw_picture(void)
{
    if (!picture_begin("corners")) return;
    draw_narrow_corner();
    draw_wedge();
    picture_chart("At rest: how deep in a wall", "degrees between the walls", "linear", "units deep", "log");
    draw_depth(by_textbook, PICTURE_FAILS, label_in_turn, 15);
    draw_depth(deepest_first, PICTURE_TUFF, label_deepest, 5);
    picture_end();
}

static void test_narrow_corners_hold_a_ball_at_their_walls_and_box2d_within_its_slop(void **state)
{
    (void)state;
    make_table();
    draw_picture();
    assert_true(figures_in(V_20, deepest_first, false, default_restitution, no_friction).sunk < 0.1);
    assert_true(box2d_in(WEDGE, default_restitution).sunk <= 0.16);     /* Box2D's slop: the yardstick measures Box2D */
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bodies_come_to_rest_in_corners_up_to_a_right_angle),
        cmocka_unit_test(test_energy_does_not_grow),
        cmocka_unit_test(test_no_call_makes_more_pushes_than_allowed),
        cmocka_unit_test(test_no_body_sinks_deeper_than_the_pushes_of_a_call_allow),
        cmocka_unit_test(test_beyond_a_right_angle_bodies_tremble_and_no_more),
        cmocka_unit_test(test_a_pocket_too_small_neither_speeds_up_nor_lets_go),
        cmocka_unit_test(test_one_call_leads_out_of_three_pieces_at_once),
        cmocka_unit_test(test_the_textbook_falls_through_a_wedge),
        cmocka_unit_test(test_the_textbook_rests_deep_in_a_narrow_corner),
        cmocka_unit_test(test_all_pushes_at_once_never_come_to_rest),
        cmocka_unit_test(test_a_wedge_of_one_piece_holds_in_either_order),
        cmocka_unit_test(test_narrow_corners_hold_a_ball_at_their_walls_and_box2d_within_its_slop),
    };
    (void)argc;
    random_begin(argv);
    table_family(2, "Corners");
    return cmocka_run_group_tests(tests, run_all, NULL);
}
