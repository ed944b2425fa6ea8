/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Family 11, long runs: a million steps. The demo's belt with everything in it, flown by its autopilot: nobody is lost in a
   rock, the checks find nothing, and both builds move alike. And a belt of balls that lose nothing at a bounce: what a million
   steps make of their energy and where they end. */
#include "handed.h"
#include "naive.h"
#include "picture.h"
#include "pieces.h"
#include "scene.h"
#include "table.h"

#define STEPS 1000000

/* ---- the belt of the demo ---- */

#define ENEMY_RADIUS TUFF_WHOLE(6)         /* ports/scene/inner.h has these three */
#define SHIP_RADIUS  TUFF_RATIO(41, 4)
#define SHOT_RADIUS  TUFF_RATIO(3, 2)
#define BODIES       (1 + SCENE_ENEMIES + SCENE_FLOATERS + SCENE_SHOTS)
#define LOOK_EVERY   64                    /* steps */
#define NEAR         TUFF_RATIO(1, 16)     /* a body this near to a piece is in contact */

/* How deep a body may be in a rock after its collide call, in units: what TUFF_MAX_PUSHES leave where two rocks make a wedge.
   Bodies bring at most 5 units a step, and 16 pushes take all but a hundredth of it from a wedge of 40 degrees. */
#define LOST (1.0 / 16)

/* Wedged bodies use up all their pushes between two pieces or more: a floater in a gap that a regrown rock made too narrow for
   it; a shot, which brings up to 8 units, more than twice its radius, at a seam of two flush pieces that do not know of each
   other. One look in so many may find one. */
#define WEDGED_RARE 1000

enum { SHIP, ENEMIES, FLOATERS, SHOTS, KINDS };
static const char *const kind_names[KINDS] = { "ship", "enemies", "floaters", "shots" };

/* A body of the belt. */
typedef struct member { const tuff_body *body; tuff_real radius; const tuff_polygon *hull; int kind; } member;

typedef struct figures {
    uint64_t seen, contacts;               /* bodies looked at; near a piece */
    uint64_t squeezed;                     /* with their middle in a rock before the call */
    uint64_t wedged, lost;                 /* deeper than LOST after it: between several pieces, or otherwise */
    double   energy;                       /* sum of v * v / 2 */
    double   deepest, exact;               /* the deepest overlap of bodies not wedged after the call, by tuff and by the oracle */
} figures;

typedef struct belt_run {
    scene    belt;
    figures  of[KINDS];
    uint64_t pushes;
    uint32_t steps, looks, hash, faults;
} belt_run;

static belt_run million;

static bool is_finite_body(const tuff_body *body)
{
    double sum = units_of(body->position.x) + units_of(body->position.y) + units_of(body->velocity.x) + units_of(body->velocity.y);
    return isfinite(sum);
}

/* The bodies that are there now. */
static int bodies_of(const scene *s, member *list)
{
    int count = 0;
    list[count++] = (member){ &s->ship, SHIP_RADIUS, &s->hull, SHIP };
    for (int i = 0; i < SCENE_ENEMIES; i++) {
        if (s->enemies[i].hits) list[count++] = (member){ &s->enemies[i].body, ENEMY_RADIUS, NULL, ENEMIES };
    }
    for (int i = 0; i < SCENE_FLOATERS; i++) {
        if (s->floaters[i].part_count) list[count++] = (member){ &s->floater_bodies[i], s->floaters[i].radius, NULL, FLOATERS };
    }
    for (int i = 0; i < SCENE_SHOTS; i++) {
        if (s->shots[i].life) list[count++] = (member){ &s->shots[i].body, SHOT_RADIUS, NULL, SHOTS };
    }
    return count;
}

/* The deepest overlap with any piece, in units; 0: none. */
static double depth_at(const scene *s, tuff_vec2 position, tuff_real radius, const tuff_polygon *hull)
{
    double deepest = 0;
    tuff_contact contact;
    for (int i = 0; i < SCENE_PIECES; i++) {
        bool touched = hull ? tuff_terrain_overlap_hull(&s->terrain[i], position, radius, hull, &contact)
                            : tuff_terrain_overlap_circle(&s->terrain[i], position, radius, &contact);
        if (touched && units_of(contact.overlap) > deepest) deepest = units_of(contact.overlap);
    }
    return deepest;
}

static exact exact_part_depth(const tuff_polygon *part, exact2 offset, tuff_real radius, const tuff_polygon *hull)
{
    oracle_polygon rock, own;
    oracle_answer answer;
    oracle_read_polygon(&rock, part);
    if (hull) {
        oracle_read_polygon(&own, hull);
        oracle_hull(&rock, &own, offset, &answer);
    } else {
        oracle_circle(&rock, offset, exact_real(radius), &answer);
    }
    return answer.depth;
}

/* The same by the exact oracle, from vertices alone. Moons are circles: not asked. */
static double exact_depth_at(const scene *s, tuff_vec2 position, tuff_real radius, const tuff_polygon *hull)
{
    double deepest = 0;
    for (int i = 0; i < SCENE_PIECES; i++) {
        const tuff_terrain *piece = &s->terrain[i];
        exact2 offset = exact_sub(exact_vec2(position), exact_vec2(piece->position));
        exact reach = exact_real(radius) + exact_real(piece->bounding_radius);
        if (exact_dot(offset, offset) >= reach * reach) continue;
        for (int k = 0; k < piece->part_count; k++) {
            raise_to(&deepest, exact_part_depth(&piece->parts[k], offset, radius, hull) / EXACT_UNIT);
        }
    }
    return deepest;
}

/* Makes the body's call. Did it take all pushes, off more than one piece? */
static bool is_wedged(const tuff_world *world, tuff_body *body, const member *seen)
{
    tuff_touch list[TUFF_MAX_PUSHES];
    tuff_touches touches = { list, TUFF_MAX_PUSHES, 0 };
    bool several = false;
    uint16_t pushes = tuff_terrain_collide_report(world, body, seen->radius, seen->hull, &touches);
    for (uint16_t i = 1; i < pushes; i++) several = several || list[i].piece != list[0].piece;
    return several && pushes == TUFF_MAX_PUSHES;
}

/* After the belt's step a floater may have pressed the body into a rock; its next collide call is made here, on a copy. */
static void look_at(belt_run *r, const member *seen)
{
    figures *f = &r->of[seen->kind];
    tuff_body body = *seen->body;
    double x = units_of(body.velocity.x), y = units_of(body.velocity.y);
    f->seen++;
    f->energy += (x * x + y * y) / 2;
    if (!is_finite_body(&body)) r->faults++;
    if (depth_at(&r->belt, body.position, seen->radius + NEAR, NULL) > 0) f->contacts++;
    if (depth_at(&r->belt, body.position, seen->radius, seen->hull) > units_of(seen->radius)) f->squeezed++;
    bool wedged = is_wedged(&r->belt.world, &body, seen);
    double depth = depth_at(&r->belt, body.position, seen->radius, seen->hull);
    if (depth > LOST && wedged) {
        f->wedged++;
        return;
    }
    if (depth > f->deepest) f->deepest = depth;
    if (depth > LOST) f->lost++;
    if (r->looks % 64 == 0) raise_to(&f->exact, exact_depth_at(&r->belt, body.position, seen->radius, seen->hull));
}

static void look(belt_run *r)
{
    member list[BODIES];
    uint16_t number;
    int count = bodies_of(&r->belt, list);
    for (int i = 0; i < count; i++) look_at(r, &list[i]);
    if (r->looks++ % 64 == 0 && scene_fault(&r->belt, &number)) r->faults++;
}

static void fly(belt_run *r, uint32_t seed, uint32_t steps)
{
    scene_init(&r->belt, seed);
    for (uint32_t i = 0; i < steps; i++) {
        scene_step(&r->belt, scene_pilot(&r->belt));
        r->hash = scene_hash(&r->belt, r->hash);
        r->pushes += r->belt.pushes;
        r->steps++;
        if (i % LOOK_EVERY == 0) look(r);
    }
}

static int fly_a_million_steps(void **state)
{
    random_run run = random_cases("the belt", 1, STEPS);
    (void)state;
    fly(&million, (uint32_t)run.seed, run.end);
    print_message("figures: " EXACT_BUILD " %lu steps of the belt: hash %08lX, %.2f pushes a step\n", (unsigned long)million.steps,
                  (unsigned long)million.hash, (double)million.pushes / million.steps);
    return 0;
}

static void test_the_checks_find_nothing_in_a_million_steps(void **state)
{
    (void)state;
    assert_int_equal(million.faults, 0);
    assert_true(million.of[SHIP].seen == million.looks && million.pushes > million.steps);
}

static void print_kind(int kind, const figures *f)
{
    print_message("figures: " EXACT_BUILD " %s: looked at %lu, near a rock %lu, middle in a rock before the call %lu, wedged %lu, "
                  "lost %lu; deepest after it %.5f units, by the oracle %.5f\n", kind_names[kind], (unsigned long)f->seen,
                  (unsigned long)f->contacts, (unsigned long)f->squeezed, (unsigned long)f->wedged, (unsigned long)f->lost, f->deepest,
                  f->exact);
}

static void test_no_body_is_lost_in_a_rock(void **state)
{
    double deepest = 0;
    (void)state;
    for (int k = 0; k < KINDS; k++) {
        const figures *f = &million.of[k];
        print_kind(k, f);
        deepest = fmax(deepest, f->deepest);
        assert_true(f->lost == 0 && f->exact <= LOST && f->wedged * WEDGED_RARE <= f->seen + WEDGED_RARE);
    }
    table_row("belt, a million steps: deepest in a rock, units");
    table_tuff("%.4f", deepest);
}

/* ---- both builds alike ---- */

#define BELTS      32
#define BELT_STEPS 8000

/* Means of 128 belts with other seeds, half of them of each build. From one set of 32 belts to the next they vary by 5 %. */
static const double usual_energy[KINDS] = { 0.477, 0.191, 0.0323, 11.9 };
static const double usual_contacts = 4.2;
#define ALIKE 0.10

static bool is_alike(double mean, double usual)
{
    return fabs(mean - usual) <= ALIKE * usual;
}

static void test_both_builds_move_alike(void **state)
{
    static belt_run many;
    random_run run = random_cases(__func__, 100, BELTS);
    uint64_t contacts = 0;
    bool alike = true;
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) fly(&many, (uint32_t)run.seed + i, BELT_STEPS);
    for (int k = 0; k < KINDS; k++) {
        double energy = many.of[k].energy / (double)many.of[k].seen;
        contacts += many.of[k].contacts;
        alike = alike && is_alike(energy, usual_energy[k]);
        print_message("figures: " EXACT_BUILD " %s: mean energy %.4f, contacts a step %.3f\n", kind_names[k], energy,
                      (double)many.of[k].contacts / many.looks);
        if (k == FLOATERS || k == SHOTS) continue;
        table_row(k == SHIP ? "belt: mean energy of the ship" : "belt: mean energy of an enemy");
        table_tuff("%.3f", energy);
    }
    double mean = (double)contacts / many.looks;
    print_message("figures: " EXACT_BUILD " contacts a step %.3f, pushes a step %.3f\n", mean, (double)many.pushes / many.steps);
    table_row("belt: bodies in contact, a step");
    table_tuff("%.2f", mean);
    if (run.end - run.first < BELTS) return;
    assert_true(alike && is_alike(mean, usual_contacts));
}

/* ---- balls in a room of rocks ---- */

#define BALLS   6
#define ROCKS   9
#define PIECES  (ROCKS + 4)
#define ROOM    56.0                /* from the middle to the walls: the textbook's squares overflow beyond 181 */
#define RADIUS  2.0

typedef struct balls {
    random_shape shapes[PIECES];
    tuff_terrain pieces[PIECES];
    tuff_body    start[BALLS];
    naive_polygon naive[PIECES];
} balls;

/* What they run under: both ways of a wall are bounced off without loss, or with tuff's default material and a pull downward. */
typedef struct law { const tuff_material *material; double pull; } law;
static const tuff_material elastic = { TUFF_WHOLE(1), 0 };
static const law without_loss = { &elastic, 0 }, heavy = { NULL, -1.0 / 64 };

static void add_piece(balls *b, int i, double x, double y)
{
    b->pieces[i] = convex_piece(&b->shapes[i], random_point_at(x, y));
    naive_read(&b->naive[i], &b->shapes[i].polygon);
}

static void make_room(balls *b)
{
    random_source source = random_stream(7, 0);
    for (int i = 0; i < ROCKS; i++) {
        random_rock_shape(&source, &b->shapes[i], 8, 9.0);
        add_piece(b, i, i % 3 * 36 - 36.0, i / 3 * 36 - 36.0);
    }
    for (int i = 0; i < 4; i++) {
        random_box_shape(&b->shapes[ROCKS + i], i < 2 ? random_point_at(ROOM + 8, 8) : random_point_at(8, ROOM + 8));
        double away = i % 2 ? ROOM + 8 : -ROOM - 8;
        add_piece(b, ROCKS + i, i < 2 ? 0 : away, i < 2 ? away : 0);
    }
    for (int i = 0; i < BALLS; i++) {
        double way = random_within(&source, 0, TURN);
        b->start[i] = (tuff_body){ random_point_at(i % 3 * 36 - 36.0, i / 3 * 36 - 18.0), random_point_at(cos(way), sin(way)), NULL };
    }
}

static double energy_of(const tuff_body *body)
{
    double x = units_of(body->velocity.x), y = units_of(body->velocity.y);
    return x * x + y * y;
}

/* Where is the middle: in a rock or beyond a wall? */
static bool is_lost(const balls *b, double x, double y)
{
    if (fabs(x) > ROOM || fabs(y) > ROOM) return true;
    for (int i = 0; i < ROCKS; i++) {
        oracle_polygon rock;
        oracle_answer answer;
        tuff_vec2 at = random_point_at(x, y);
        oracle_read_polygon(&rock, &b->shapes[i].polygon);
        oracle_circle(&rock, exact_sub(exact_vec2(at), exact_vec2(b->pieces[i].position)), 0, &answer);
        if (answer.depth > 0) return true;
    }
    return false;
}

#define MARKS 10                    /* looks at the energy in a run */
typedef struct outcome { double energy[MARKS + 1]; int lost; } outcome;

#if TUFF_SCALAR == TUFF_Q16_16
static tuff_real times(tuff_real a, tuff_real b) { return (tuff_real)(((int64_t)a * b) >> 16); }
#else
static tuff_real times(tuff_real a, tuff_real b) { return a * b; }
#endif

/* The textbook's bounce, for e = 1: v - 2 (v . n) n, product by product. */
static void bounce_naively(tuff_body *body, const textbook_contact *contact)
{
    tuff_vec2 n = contact->normal;
    tuff_real speed = times(body->velocity.x, n.x) + times(body->velocity.y, n.y);
    body->position.x += times(contact->overlap, n.x);
    body->position.y += times(contact->overlap, n.y);
    if (speed >= 0) return;
    body->velocity.x -= 2 * times(speed, n.x);
    body->velocity.y -= 2 * times(speed, n.y);
}

static void meet_naively(const balls *b, tuff_body *body)
{
    textbook_contact contact;
    for (int i = 0; i < PIECES; i++) {
        tuff_vec2 offset = { body->position.x - b->pieces[i].position.x, body->position.y - b->pieces[i].position.y };
        tuff_real reach = b->pieces[i].bounding_radius + TUFF_WHOLE((int)RADIUS);
        if (offset.x > reach || offset.x < -reach || offset.y > reach || offset.y < -reach) continue;
        if (textbook_circle(offset, TUFF_WHOLE((int)RADIUS), &b->naive[i].polygon, &contact)) bounce_naively(body, &contact);
    }
}

static void meet(const balls *b, tuff_body *body)
{
    const tuff_world world = plain_world(b->pieces, PIECES, TUFF_ORDER_DEEPEST);
    tuff_terrain_collide_circle(&world, body, TUFF_WHOLE((int)RADIUS));
}

/* A beginner's way: the velocity is mirrored, and nobody is pushed out. */
static void meet_without_push(const balls *b, tuff_body *body)
{
    tuff_body bounced = *body;
    meet(b, &bounced);
    body->velocity = bounced.velocity;
}

static double energy_of_all(const tuff_body *bodies)
{
    double sum = 0;
    for (int i = 0; i < BALLS; i++) sum += energy_of(&bodies[i]);
    return sum;
}

typedef void meeting(const balls *b, tuff_body *body);

static void step_balls(const balls *b, tuff_body *now, double pull, meeting *collide)
{
    for (int i = 0; i < BALLS; i++) {
        if (now[i].position.y < TUFF_WHOLE(-1000)) continue;     /* fallen out of the room */
        body_fall(&now[i], random_point_at(0, pull));
        collide(b, &now[i]);
    }
}

static outcome run_balls(const balls *b, uint32_t steps, law rule, meeting *collide)
{
    tuff_body now[BALLS];
    outcome end = { { 1.0 }, 0 };
    for (int i = 0; i < BALLS; i++) {
        now[i] = b->start[i];
        now[i].material = rule.material;
    }
    for (int mark = 1; mark <= MARKS; mark++) {
        for (uint32_t step = 0; step < steps / MARKS; step++) step_balls(b, now, rule.pull, collide);
        end.energy[mark] = energy_of_all(now) / energy_of_all(b->start);
    }
    for (int i = 0; i < BALLS; i++) end.lost += is_lost(b, units_of(now[i].position.x), units_of(now[i].position.y));
    return end;
}

static yardstick *yard_of(const balls *b, law rule)
{
    yardstick *yard = yardstick_new((yardstick_vec){ 0, rule.pull }, true);
    for (int i = 0; i < PIECES; i++) assert_true(yard_add_piece(yard, &b->pieces[i]));
    for (int i = 0; i < BALLS; i++) {
        yardstick_material material = { rule.material ? 1 : 0.09, 0 };
        assert_int_equal(yardstick_add_ball(yard, yard_state(&b->start[i]), RADIUS, material), i);
    }
    return yard;
}

static double box2d_energy(const yardstick *yard)
{
    double sum = 0;
    for (int i = 0; i < BALLS; i++) {
        yardstick_vec v = yardstick_body(yard, i).velocity;
        sum += v.x * v.x + v.y * v.y;
    }
    return sum;
}

static outcome run_box2d(const balls *b, uint32_t steps, law rule)
{
    yardstick *yard = yard_of(b, rule);
    outcome end = { { 1.0 }, 0 };
    for (int mark = 1; mark <= MARKS; mark++) {
        for (uint32_t step = 0; step < steps / MARKS; step++) yardstick_step(yard);
        end.energy[mark] = box2d_energy(yard) / energy_of_all(b->start);
    }
    for (int i = 0; i < BALLS; i++) {
        yardstick_vec at = yardstick_body(yard, i).position;
        end.lost += is_lost(b, at.x, at.y);
    }
    yardstick_free(yard);
    return end;
}

static void print_outcome(const char *who, const outcome *o)
{
    print_message("figures: " EXACT_BUILD " balls, %s: %d of %d lost, energy", who, o->lost, BALLS);
    for (int i = 0; i <= MARKS; i++) print_message(" %.4f", o->energy[i]);
    print_message("\n");
}

static void draw_energy(picture_role role, const char *label, const outcome *o)
{
    picture_line(role, label);
    for (int i = 0; i <= MARKS; i++) picture_point(i, o->energy[i]);
    picture_line_end();
}

static void draw_room(const balls *b)
{
    tuff_body body = b->start[0];
    body.material = &elastic;
    picture_panel("The room: 500 steps of one of six balls", -66, -60, 66, 60);
    for (int i = 0; i < PIECES; i++) picture_piece(&b->pieces[i]);
    for (int i = 0; i < BALLS; i++) picture_circle(PICTURE_BODY, b->start[i].position, TUFF_WHOLE((int)RADIUS));
    picture_line(PICTURE_TUFF, NULL);
    for (int step = 0; step < 500; step++) {
        picture_point(units_of(body.position.x), units_of(body.position.y));
        body_fall(&body, (tuff_vec2){ 0, 0 });
        meet(b, &body);
    }
    picture_line_end();
}

static void draw_picture(const balls *b, const outcome *naive, const outcome *box, const outcome *tuff)
{
    if (!picture_begin("long")) return;
    draw_room(b);
    picture_chart("Energy of balls that bounce without loss", "hundred thousand steps", "linear", "energy, 1 at the start", "linear");
    draw_energy(PICTURE_FAILS, "textbook, Q16.16", naive);
    draw_energy(PICTURE_BOX2D, NULL, box);
    draw_energy(PICTURE_TUFF, NULL, tuff);
    picture_end();
}

/* Each product of the textbook is rounded on its own, and always downward: in Q16.16 that feeds the balls. tuff's fixed build
   rounds what is left of a velocity toward zero: it may lose, a bounce at most 1 LSB of each component. */
#if TUFF_SCALAR == TUFF_Q16_16
#define TEXTBOOK_FEEDS 1.1
#define LEAST_LEFT     0.25        /* 1 LSB a bounce, one bounce in 30 steps: half of the 65,536 LSB of the speed */
#define MOST_LEFT      1.0
#else
#define TEXTBOOK_FEEDS 0.0         /* in float the textbook holds as well */
#define LEAST_LEFT     0.999       /* 33,000 bounces, each within 2^-23 of the speed at random: 2e-5, and room for a bias */
#define MOST_LEFT      1.001
#endif

static void test_balls_without_loss_keep_their_energy(void **state)
{
    static balls b;
    random_run run = random_cases(__func__, 1, STEPS);
    (void)state;
    make_room(&b);
    outcome naive = run_balls(&b, run.end, without_loss, meet_naively), tuff = run_balls(&b, run.end, without_loss, meet);
    outcome box = run_box2d(&b, run.end, without_loss);
    print_outcome("textbook", &naive);
    print_outcome("Box2D", &box);
    print_outcome("tuff", &tuff);
    draw_picture(&b, &naive, &box, &tuff);
    table_row("restitution 1, a million steps: change of energy");
    table_fails("textbook", "%+.2f %%", 100.0 * (naive.energy[MARKS] - 1));
    table_box2d("%+.2f %%", 100.0 * (box.energy[MARKS] - 1));
    table_tuff("%+.2f %%", 100.0 * (tuff.energy[MARKS] - 1));
    assert_int_equal(tuff.lost, 0);
    assert_true(tuff.energy[MARKS] >= LEAST_LEFT && tuff.energy[MARKS] <= MOST_LEFT);
    if (run.end == STEPS) assert_true(naive.energy[MARKS] > TEXTBOOK_FEEDS);
}

static void test_heavy_balls_stay_out_of_the_rocks(void **state)
{
    static balls b;
    random_run run = random_cases(__func__, 1, STEPS / 5);
    (void)state;
    make_room(&b);
    outcome naive = run_balls(&b, run.end, heavy, meet_without_push), tuff = run_balls(&b, run.end, heavy, meet);
    outcome box = run_box2d(&b, run.end, heavy);
    print_outcome("mirrored velocity only, heavy", &naive);
    print_outcome("Box2D, heavy", &box);
    print_outcome("tuff, heavy", &tuff);
    table_row("heavy balls, 200,000 steps: sunk into rock, of 6");
    table_fails("no push-out", "%d", naive.lost);
    table_box2d("%d", box.lost);
    table_tuff("%d", tuff.lost);
    assert_int_equal(tuff.lost, 0);
    assert_int_equal(naive.lost, BALLS);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_checks_find_nothing_in_a_million_steps),
        cmocka_unit_test(test_no_body_is_lost_in_a_rock),
        cmocka_unit_test(test_both_builds_move_alike),
        cmocka_unit_test(test_balls_without_loss_keep_their_energy),
        cmocka_unit_test(test_heavy_balls_stay_out_of_the_rocks),
    };
    (void)argc;
    random_begin(argv);
    table_family(11, "Long runs");
    return cmocka_run_group_tests(tests, fly_a_million_steps, NULL);
}
