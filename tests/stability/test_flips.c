/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Family 3, direction flips: places where the way out is a tie, or nearly: the push is the least that separates, it is never
   zero, and it does not change from step to step. */
#include "handed.h"
#include "naive.h"
#include "picture.h"
#include "pieces.h"
#include "same.h"
#include "table.h"

#define MOST_VERTICES 8                 /* that Box2D takes as well */
#define STEPS         1000

/* What a contact is allowed: the error of its depth, and what a push leaves; in steps of 1/65536 unit. */
static const double depth_bound = TUFF_SCALAR == TUFF_Q16_16 ? 1.0 : 5e-5 * EXACT_UNIT;
static const double left_bound = TUFF_SCALAR == TUFF_Q16_16 ? 2.0 : 1e-4 * EXACT_UNIT;
static const double angle_bound = 1e-6;

/* ---- places ---- */

enum { ON_EDGE, ON_VERTEX, AT_CENTROID, SQUARES, REGULARS, PARALLELS, PAST_HALF, INSIDE, AROUND, PLACES };

typedef struct place {                  /* not to be copied: the polygons point into it */
    random_shape rock, hull;
    bool      with_hull;
    tuff_real radius;                   /* of the circle, or about the hull */
    tuff_vec2 at;                       /* relative to the rock */
} place;

static tuff_vec2 sum_of(tuff_vec2 a, tuff_vec2 b)
{
    return (tuff_vec2){ a.x + b.x, a.y + b.y };
}

static void make_regular(random_shape *shape, int count, double size)
{
    for (int i = 0; i < count; i++) {
        double angle = TURN * i / count;
        shape->vertices[i] = grid_point(size * cos(angle), size * sin(angle));
    }
    random_bake(shape, count);
}

static void make_shape(random_source *source, random_shape *shape, double size)
{
    uint32_t kind = random_below(source, 3);
    tuff_real wide = TUFF_WHOLE(random_between(source, 1, (int)size)), high = TUFF_WHOLE(random_between(source, 1, (int)size));
    if (kind == 0) random_box_shape(shape, (tuff_vec2){ wide, high });
    if (kind == 1) make_regular(shape, random_between(source, 3, MOST_VERTICES), size);
    if (kind == 2) family_plain_shape(source, shape, MOST_VERTICES, size);
}

/* A circle or a hull. */
static void make_mover(random_source *source, place *p, double size)
{
    p->with_hull = random_chance(source, 50);
    make_shape(source, &p->hull, size);
    p->radius = p->with_hull ? p->hull.bounding_radius : grid_point(random_within(source, size / 4, size), 0).x;
}

static tuff_vec2 centroid_of(const random_shape *shape)
{
    double x = 0, y = 0;
    for (int i = 0; i < shape->polygon.count; i++) {
        x += units_of(shape->vertices[i].x);
        y += units_of(shape->vertices[i].y);
    }
    return grid_point(x / shape->polygon.count, y / shape->polygon.count);
}

/* Between the ends of an edge, at a quarter of its length or at its middle. */
static tuff_vec2 point_on_edge(random_source *source, const random_shape *shape)
{
    uint32_t edge = random_below(source, shape->polygon.count);
    tuff_vec2 a = shape->vertices[edge], b = shape->vertices[(edge + 1) % shape->polygon.count];
    double part = random_between(source, 1, 3) / 4.0;
    return random_point_at(units_of(a.x) + part * (units_of(b.x) - units_of(a.x)), units_of(a.y) + part * (units_of(b.y) - units_of(a.y)));
}

/* Squares one inside the other, with two, three or all four ways out alike. */
static void make_squares(random_source *source, place *p)
{
    int32_t wide = random_between(source, 4, 20), inner = random_between(source, 1, 3), aside = random_between(source, 0, 1);
    random_box_shape(&p->rock, (tuff_vec2){ TUFF_WHOLE(wide), TUFF_WHOLE(wide) });
    random_box_shape(&p->hull, (tuff_vec2){ TUFF_WHOLE(inner), TUFF_WHOLE(inner) });
    p->with_hull = random_chance(source, 70);
    p->radius = p->with_hull ? p->hull.bounding_radius : TUFF_WHOLE(inner);
    p->at = (tuff_vec2){ TUFF_WHOLE(aside), TUFF_WHOLE(random_chance(source, 50) ? aside : -aside) };
}

static void make_regulars(random_source *source, place *p)
{
    int count = random_between(source, 3, MOST_VERTICES);
    make_regular(&p->rock, count, random_between(source, 4, 40));
    make_regular(&p->hull, count, random_between(source, 4, 40));
    p->with_hull = true;
    p->radius = p->hull.bounding_radius;
    p->at = grid_point(0, 0);
}

/* Two boxes turned against each other by 1e-4 rad: each has a face by which the other leaves. */
static void make_parallels(random_source *source, place *p)
{
    random_shape straight;
    random_box_shape(&p->rock, (tuff_vec2){ TUFF_WHOLE(30), TUFF_WHOLE(random_between(source, 2, 8)) });
    random_box_shape(&straight, (tuff_vec2){ TUFF_WHOLE(random_between(source, 4, 20)), TUFF_WHOLE(3) });
    family_turned(&p->hull, &straight, random_chance(source, 50) ? 1e-4 : -1e-4);
    p->with_hull = true;
    p->radius = p->hull.bounding_radius;
    int32_t along = random_between(source, -8, 8);
    p->at = grid_point(along, units_of(p->rock.vertices[2].y) + random_within(source, 0, 2.9));
}

static void make_place(random_source *source, place *p, int kind)
{
    double size = random_between(source, 8, 40), mover = kind == INSIDE ? size / 4 : kind == AROUND ? size * 1.5 : size / 2;
    make_shape(source, &p->rock, size);
    make_mover(source, p, mover);
    tuff_vec2 middle = centroid_of(&p->rock);
    double near = kind == PAST_HALF ? size / 4 : size / 8;
    double right = random_within(source, -near, near), up = random_within(source, -near, near);
    p->at = kind == AT_CENTROID ? middle : sum_of(middle, grid_point(right, up));
    if (kind == ON_EDGE) p->at = point_on_edge(source, &p->rock);
    if (kind == ON_VERTEX) p->at = p->rock.vertices[random_below(source, p->rock.polygon.count)];
    if (kind == SQUARES) make_squares(source, p);
    if (kind == REGULARS) make_regulars(source, p);
    if (kind == PARALLELS) make_parallels(source, p);
}

static tuff_terrain piece_of(const place *p)
{
    return convex_piece(&p->rock, (tuff_vec2){ 0, 0 });
}

static const tuff_polygon *hull_of(const place *p)
{
    return p->with_hull ? &p->hull.polygon : NULL;
}

static bool contact_at(const place *p, tuff_vec2 at, tuff_contact *contact)
{
    tuff_terrain piece = piece_of(p);
    return tuff_terrain_overlap_hull(&piece, at, p->radius, hull_of(p), contact);
}

/* ---- what is true ---- */

static void truth_at(const place *p, exact2 at, oracle_answer *answer)
{
    oracle_polygon rock, hull;
    oracle_read_polygon(&rock, &p->rock.polygon);
    if (p->with_hull) oracle_read_polygon(&hull, &p->hull.polygon);
    if (p->with_hull) oracle_hull(&rock, &hull, at, answer);
    else oracle_circle(&rock, at, exact_real(p->radius), answer);
}

static double left_at(const place *p, exact2 at)
{
    oracle_answer answer;
    truth_at(p, at, &answer);
    return (double)answer.depth;
}

/* NULL: the contact is a least push. */
static const char *fault_of(const place *p, tuff_vec2 at)
{
    oracle_answer answer;
    tuff_contact contact;
    tuff_body body = body_at(at);
    truth_at(p, exact_vec2(at), &answer);
    if (!contact_at(p, at, &contact)) return answer.depth > (exact)depth_bound ? "no contact" : NULL;
    if (exact_abs(exact_real(contact.overlap) - answer.depth) > (exact)depth_bound) return "the depth is wrong";
    if (oracle_normal_error(&answer, (exact)depth_bound, exact_unit2(contact.normal)) > (exact)angle_bound) return "no least axis";
    tuff_bounce(&body, &contact);
    return left_at(p, exact_vec2(body.position)) > left_bound ? "the push leaves it inside" : NULL;
}

/* ---- a place and its neighbors, to 3 steps of the fixed build ---- */

static tuff_vec2 neighbor_of(tuff_vec2 at, int number)
{
    static const int steps[] = { 0, -3, -1, 1, 3 };
    return sum_of(at, (tuff_vec2){ TUFF_REAL_RAW(steps[number % 5]), TUFF_REAL_RAW(steps[number / 5]) });
}

#define NEIGHBORS 25

static void check_places(const char *name, int kind, uint64_t seed)
{
    static place p;
    random_run run = random_cases(name, seed, 1000);
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        make_place(&source, &p, kind);
        for (int k = 0; k < NEIGHBORS; k++) {
            const char *fault = fault_of(&p, neighbor_of(p.at, k));
            if (fault) random_fail(&run, i, "%s, neighbor %d", fault, k);
        }
    }
}

static void test_a_center_on_an_edge_leaves_by_a_least_push(void **state)
{
    (void)state;
    check_places(__func__, ON_EDGE, 301);
}

static void test_a_center_on_a_vertex_leaves_by_a_least_push(void **state)
{
    (void)state;
    check_places(__func__, ON_VERTEX, 302);
}

static void test_a_center_at_the_centroid_leaves_by_a_least_push(void **state)
{
    (void)state;
    check_places(__func__, AT_CENTROID, 303);
}

static void test_a_square_in_a_square_leaves_by_a_least_push(void **state)
{
    (void)state;
    check_places(__func__, SQUARES, 304);
}

static void test_regular_polygons_leave_by_a_least_push(void **state)
{
    (void)state;
    check_places(__func__, REGULARS, 305);
}

static void test_nearly_parallel_faces_part_by_a_least_push(void **state)
{
    (void)state;
    check_places(__func__, PARALLELS, 306);
}

static void test_past_the_middle_the_push_is_still_the_least(void **state)
{
    (void)state;
    check_places(__func__, PAST_HALF, 307);
}

static void test_a_body_inside_a_piece_leaves_by_a_least_push(void **state)
{
    (void)state;
    check_places(__func__, INSIDE, 308);
}

static void test_a_body_around_a_piece_leaves_by_a_least_push(void **state)
{
    (void)state;
    check_places(__func__, AROUND, 309);
}

/* ---- the direction ---- */

static double turn_between(tuff_unit2 a, tuff_unit2 b)
{
    return (double)oracle_angle(exact_unit2(a), exact_unit2(b));
}

/* How far the body must move along a direction until it is out, in steps. */
static double way_out(const place *p, tuff_vec2 at, exact2 n)
{
    exact farthest = -(exact)1e18, nearest = p->with_hull ? (exact)1e18 : -exact_real(p->radius);
    for (int i = 0; i < p->rock.polygon.count; i++) {
        exact along = exact_dot(n, exact_vec2(p->rock.vertices[i]));
        farthest = along > farthest ? along : farthest;
    }
    for (int i = 0; p->with_hull && i < p->hull.polygon.count; i++) {
        exact along = exact_dot(n, exact_vec2(p->hull.vertices[i]));
        nearest = along < nearest ? along : nearest;
    }
    return (double)(farthest - nearest - exact_dot(n, exact_vec2(at)));
}

/* Moved by a hair, the way out may be another only if it was nearly as good before. */
static void test_a_hair_turns_the_push_only_between_ties(void **state)
{
    static place p;
    random_run run = random_cases(__func__, 310, 20000);
    tuff_contact here, there;
    uint32_t turned = 0;
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        make_place(&source, &p, (int)(i % PLACES));
        tuff_vec2 at = neighbor_of(p.at, (int)random_below(&source, NEIGHBORS));
        if (!contact_at(&p, p.at, &here) || !contact_at(&p, at, &there) || turn_between(there.normal, here.normal) < 0.001) continue;
        double slack = 2 * 3 * sqrt(2) + 2 * depth_bound;
        turned++;
        bool tied = way_out(&p, p.at, exact_unit2(there.normal)) <= left_at(&p, exact_vec2(p.at)) + slack;
        if (!tied) random_fail(&run, i, "no tie, but another direction");
    }
    print_message("figures: " EXACT_BUILD " flips: %lu directions changed by a hair\n", (unsigned long)turned);
    assert_true(turned > 0);
}

/* ---- from step to step ---- */

static tuff_touch collide_once(const place *p, tuff_body *body, uint16_t *pushes)
{
    tuff_terrain piece = piece_of(p);
    tuff_touch touch = { 0, { 0, { 0, 0 } } };
    tuff_touches touches = { &touch, 1, 0 };
    *pushes = tuff_floater_collide_report(body, p->radius, &piece, 1, hull_of(p), TUFF_ORDER_DEEPEST, &touches);
    return touch;
}

/* Each step 1/8 unit straight in, against the last push. How far the direction turned in one step, at the most; 4: a step
   without a push.
 */
static double pressed_in(const place *p)
{
    uint16_t pushes;
    double most = 0;
    tuff_body body = body_at(p->at);
    tuff_touch last = collide_once(p, &body, &pushes);
    for (int i = 0; i < STEPS; i++) {
        tuff_unit2 n = last.contact.normal;
        body.velocity = (tuff_vec2){ -tuff_scale(TUFF_RATIO(1, 8), n.x), -tuff_scale(TUFF_RATIO(1, 8), n.y) };
        body.position = sum_of(body.position, body.velocity);
        tuff_touch touch = collide_once(p, &body, &pushes);
        if (pushes == 0) return 4;
        most = fmax(most, turn_between(touch.contact.normal, last.contact.normal));
        last = touch;
    }
    return most;
}

/* A push is rounded to 1/65536 unit: that turns the direction from a vertex half a unit or more away by no more than this. */
static const double drift = 1e-4;

static void test_pressed_in_for_a_thousand_steps_the_direction_stays(void **state)
{
    static place p;
    random_run run = random_cases(__func__, 311, 2000);
    double most = 0;
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        tuff_contact contact;
        make_place(&source, &p, (int)(i % PLACES));
        if (!contact_at(&p, p.at, &contact)) continue;
        double turned = pressed_in(&p);
        most = fmax(most, turned);
        if (turned > drift) random_fail(&run, i, "the direction turned by %g", turned);
    }
    print_message("figures: " EXACT_BUILD " flips: pressed in, directions turned by %.9f rad a step at most\n", most);
}

/* After the first push there is at most its rounding to be pushed out of, and then nothing that moves the body. */
static bool stays_out(const place *p)
{
    uint16_t pushes;
    tuff_body body = body_at(p->at);
    (void)collide_once(p, &body, &pushes);
    exact2 out = exact_vec2(body.position);
    for (int i = 1; i < STEPS; i++) (void)collide_once(p, &body, &pushes);
    tuff_vec2 before = body.position;
    (void)collide_once(p, &body, &pushes);
    exact2 way = exact_sub(exact_vec2(body.position), out);
    return same_point(body.position, before) && exact_abs(way.x) <= (exact)left_bound && exact_abs(way.y) <= (exact)left_bound;
}

static void test_at_rest_the_first_push_is_the_last(void **state)
{
    static place p;
    random_run run = random_cases(__func__, 312, 5000);
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        make_place(&source, &p, (int)(i % PLACES));
        if (!stays_out(&p)) random_fail(&run, i, "it moves on");
    }
}

/* ---- coincident centers ---- */

/* Where is a ball of 3 units that began at the middle of a round piece? */
typedef tuff_vec2 circle_method(tuff_real obstacle_radius);

/* A method that divides by the distance finds nothing where it is 0. */
static tuff_vec2 circles_by_division(tuff_real obstacle_radius)
{
    tuff_vec2 center = { TUFF_WHOLE(0), TUFF_WHOLE(0) };
    double x = units_of(center.x), y = units_of(center.y), distance = hypot(x, y), reach = 3 + units_of(obstacle_radius);
    if (distance > 0 && distance < reach) center = random_point_at(x / distance * reach, y / distance * reach);
    return center;
}

static tuff_vec2 circles_by_tuff(tuff_real obstacle_radius)
{
    tuff_terrain piece = { { 0, 0 }, obstacle_radius, obstacle_radius, NULL, 0 };
    tuff_body body = body_at((tuff_vec2){ 0, 0 });
    (void)tuff_floater_collide_circle(&body, TUFF_WHOLE(3), &piece, 1);
    return body.position;
}

/* Percent of eight sizes. */
static double coincident_left_by(circle_method *method)
{
    int left = 0;
    for (int radius = 1; radius <= 8; radius++) {
        tuff_vec2 at = method(TUFF_WHOLE(radius));
        left += hypot(units_of(at.x), units_of(at.y)) < 3 + radius;
    }
    return percent((unsigned long)left, 8);
}

static void test_coincident_circles_leave_along_x(void **state)
{
    (void)state;
    for (int i = 1; i <= 64; i++) {
        tuff_vec2 at = circles_by_tuff(TUFF_RATIO(i, 2));
        assert_true(at.x == TUFF_WHOLE(3) + TUFF_RATIO(i, 2) && at.y == 0);
    }
    assert_true(coincident_left_by(circles_by_division) == 100);
}

/* ---- methods, in units: the push, or false for none ---- */

typedef struct push { double x, y, overlap; } push;
typedef bool method(const place *p, push *out);

static bool by_tuff(const place *p, push *out)
{
    tuff_contact contact;
    if (!contact_at(p, p->at, &contact)) return false;
    *out = (push){ (double)exact_unit(contact.normal.x), (double)exact_unit(contact.normal.y), units_of(contact.overlap) };
    return true;
}

static bool by_textbook(const place *p, push *out)
{
    naive_polygon rock, hull;
    textbook_contact contact;
    naive_read(&rock, &p->rock.polygon);
    naive_read(&hull, &p->hull.polygon);
    bool found = p->with_hull ? textbook_hull(&hull.polygon, p->at, &rock.polygon, &contact)
                              : textbook_circle(p->at, p->radius, &rock.polygon, &contact);
    if (found) *out = (push){ units_of(contact.normal.x), units_of(contact.normal.y), units_of(contact.overlap) };
    return found;
}

static bool by_box2d(const place *p, push *out)
{
    const box2d_vec origin = { 0, 0 };
    box2d_contact contact;
    box2d_polygon *rock = box2d_of(&p->rock.polygon), *hull = box2d_of(&p->hull.polygon);
    bool found = p->with_hull ? box2d_hull_polygon(rock, origin, hull, twin_vec(p->at), &contact)
                              : box2d_circle_polygon(rock, origin, twin_vec(p->at), (float)units_of(p->radius), &contact);
    box2d_polygon_free(rock);
    box2d_polygon_free(hull);
    if (found) *out = (push){ (double)contact.normal.x, (double)contact.normal.y, (double)contact.overlap };
    return found;
}

/* Hulls only, in doubles. Two frequent shortcuts: what two spans have in common is taken for the way out, which it is not where
   one lies within the other; and the way is the one from center to center, which is none where they coincide. */
typedef struct span { double low, high; } span;

static span span_of(const random_shape *shape, tuff_vec2 at, exact2 axis)
{
    span s = { HUGE_VAL, -HUGE_VAL };
    for (int i = 0; i < shape->polygon.count; i++) {
        double along = (double)exact_dot(axis, exact_vec2(sum_of(shape->vertices[i], at))) / EXACT_UNIT;
        s = (span){ fmin(s.low, along), fmax(s.high, along) };
    }
    return s;
}

static void compare_spans(const place *p, exact2 axis, push *least)
{
    const tuff_vec2 origin = { 0, 0 };
    span rock = span_of(&p->rock, origin, axis), hull = span_of(&p->hull, p->at, axis);
    double common = fmin(rock.high, hull.high) - fmax(rock.low, hull.low), way = (double)exact_dot(axis, exact_vec2(p->at));
    double sign = (way > 0) - (way < 0);
    if (common < least->overlap) *least = (push){ sign * (double)axis.x, sign * (double)axis.y, common };
}

static bool by_common_spans(const place *p, push *out)
{
    *out = (push){ 0, 0, HUGE_VAL };
    for (int i = 0; i < p->rock.polygon.count; i++) compare_spans(p, exact_unit2(p->rock.normals[i]), out);
    for (int i = 0; i < p->hull.polygon.count; i++) compare_spans(p, exact_unit2(p->hull.normals[i]), out);
    return out->overlap > 0;
}

static const double close_enough = 0.01 * EXACT_UNIT;

static bool finds_the_least(const place *p, method *by)
{
    push out;
    double least = left_at(p, exact_vec2(p->at));
    if (!by(p, &out)) return least <= close_enough;
    if (out.overlap * EXACT_UNIT > least + close_enough) return false;
    exact2 way = { out.x * out.overlap * EXACT_UNIT, out.y * out.overlap * EXACT_UNIT };
    return left_at(p, exact_add(exact_vec2(p->at), way)) <= close_enough;
}

static void make_inner_hull(random_source *source, place *p, int kind)
{
    do make_place(source, p, kind);
    while (!p->with_hull);
}

/* Percent of the places at which a method fails. inner: only hulls one inside the other, or about the same center. */
static double failures_of(method *by, bool inner)
{
    static place p;
    static const int inner_kinds[] = { INSIDE, AROUND, SQUARES };
    int failed = 0;
    for (uint32_t i = 0; i < 9000; i++) {
        random_source source = random_stream(313, i);
        if (inner) make_inner_hull(&source, &p, inner_kinds[i % 3]);
        else make_place(&source, &p, (int)(i % PLACES));
        failed += !finds_the_least(&p, by);
    }
    return failed / 90.0;
}

static void test_common_spans_leave_hulls_inside_each_other(void **state)
{
    (void)state;
    assert_true(failures_of(by_common_spans, true) > 50);
    assert_true(failures_of(by_tuff, true) == 0);
}

/* A hull half a unit deep in the top of a rock whose origin lies above them both, as of a rock cut from a larger picture. */
static void make_aside(place *p)
{
    random_box_shape(&p->rock, (tuff_vec2){ TUFF_WHOLE(20), TUFF_WHOLE(5) });
    for (int i = 0; i < 4; i++) p->rock.vertices[i].y -= TUFF_WHOLE(12);
    random_bake(&p->rock, 4);
    random_box_shape(&p->hull, (tuff_vec2){ TUFF_WHOLE(3), TUFF_WHOLE(3) });
    p->with_hull = true;
    p->radius = p->hull.bounding_radius;
    p->at = (tuff_vec2){ TUFF_WHOLE(0), TUFF_RATIO(-9, 2) };
}

static void test_the_way_from_center_to_center_leads_down_into_a_rock(void **state)
{
    static place p;
    push out;
    (void)state;
    make_aside(&p);
    assert_true(by_common_spans(&p, &out) && out.y < 0);
    assert_true(by_tuff(&p, &out) && out.y > 0 && fabs(out.overlap - 0.5) * EXACT_UNIT <= depth_bound);
}

/* A ball close to the corner of a box, off both its edges by the same. */
static void make_near_vertex(place *p, double off)
{
    random_box_shape(&p->rock, (tuff_vec2){ TUFF_WHOLE(8), TUFF_WHOLE(8) });
    random_box_shape(&p->hull, (tuff_vec2){ TUFF_WHOLE(8), TUFF_WHOLE(8) });
    p->with_hull = false;
    p->radius = TUFF_WHOLE(1);
    p->at = grid_point(8 + off, 8 + off);
}

typedef struct errors { double depth, degrees; } errors;

/* The largest, within 0.1 unit of the vertex and a little beyond. */
static errors errors_near_a_vertex(method *by)
{
    static place p;
    errors most = { 0, 0 };
    for (int i = 4; i <= 100; i++) {
        push out = { 0, 0, 0 };
        make_near_vertex(&p, i / 1024.0);
        by(&p, &out);
        most.depth = fmax(most.depth, fabs(out.overlap - left_at(&p, exact_vec2(p.at)) / EXACT_UNIT));
        most.degrees = fmax(most.degrees, fabs(atan2(out.y, out.x) * 57.29577951308232 - 45));
    }
    return most;
}

static void test_the_textbooks_guard_errs_near_a_vertex(void **state)
{
    errors textbook = errors_near_a_vertex(by_textbook), tuff = errors_near_a_vertex(by_tuff);
    (void)state;
    assert_true(textbook.depth > 0.02 && textbook.degrees > 40);
    assert_true(tuff.depth * EXACT_UNIT <= depth_bound && tuff.degrees < 1e-4);
}

/* ---- table and picture ---- */

/* Percent of coincident circles that Box2D does not part within a second, as a whole engine. */
static double coincident_left_by_box2d(void)
{
    int left = 0;
    for (int radius = 1; radius <= 8; radius++) {
        yardstick *yard = yardstick_new((yardstick_vec){ 0, 0 }, true);
        yardstick_add_circle(yard, (yardstick_vec){ 0, 0 }, radius, 0);
        int ball = yardstick_add_ball(yard, (yardstick_state){ { 0, 0 }, { 0, 0 } }, 3, (yardstick_material){ 0, 0 });
        for (int i = 0; i < 60; i++) yardstick_step(yard);
        yardstick_vec at = yardstick_body(yard, ball).position;
        left += hypot(at.x, at.y) < 3 + radius - 0.32;      /* twice Box2D's slop */
        yardstick_free(yard);
    }
    return percent((unsigned long)left, 8);
}

static void vertex_rows(void)
{
    errors textbook = errors_near_a_vertex(by_textbook), box2d = errors_near_a_vertex(by_box2d), tuff = errors_near_a_vertex(by_tuff);
    table_row("ball near a vertex, error of the depth in units");
    table_fails("textbook", "%.4f", textbook.depth);
    table_box2d("%.4f", box2d.depth);
    table_tuff("%.4f", tuff.depth);
    table_row("ball near a vertex, error of the direction in degrees");
    table_fails("textbook", "%.1f", textbook.degrees);
    table_box2d("%.1f", box2d.degrees);
    table_tuff("%.1f", tuff.degrees);
}

static void make_table(void)
{
    vertex_rows();
    table_row("one hull in another, pushes that leave it there, %");
    table_fails("common spans", "%.1f", failures_of(by_common_spans, true));
    table_box2d("%.1f", failures_of(by_box2d, true));
    table_tuff("%.1f", failures_of(by_tuff, true));
    table_row("coincident circles, left inside each other, %");
    table_fails("no way out at distance 0", "%.0f", coincident_left_by(circles_by_division));
    table_box2d("%.0f", coincident_left_by_box2d());
    table_tuff("%.0f", coincident_left_by(circles_by_tuff));
    print_message("figures: " EXACT_BUILD " flips: pushes off by more than 0.01 unit: textbook %.2f %%, Box2D %.2f %%, tuff %.2f %%\n",
                  failures_of(by_textbook, false), failures_of(by_box2d, false), failures_of(by_tuff, false));
}

static void draw_push(picture_role role, method *by, const place *p)
{
    push out;
    if (!by(p, &out)) return;
    double x = units_of(p->at.x), y = units_of(p->at.y);
    picture_arrow(role, x, y, x + out.x * out.overlap, y + out.y * out.overlap);
    tuff_vec2 to = random_point_at(x + out.x * out.overlap, y + out.y * out.overlap);
    if (p->with_hull) picture_polygon(role, &p->hull.polygon, to);
    else picture_circle(role, to, p->radius);
}

static void draw_place(const place *p)
{
    tuff_terrain piece = piece_of(p);
    picture_piece(&piece);
    if (p->with_hull) picture_polygon(PICTURE_BODY, &p->hull.polygon, p->at);
    else picture_circle(PICTURE_BODY, p->at, p->radius);
}

static void draw_coincident(void)
{
    const tuff_vec2 center = { TUFF_WHOLE(0), TUFF_WHOLE(0) }, out = { TUFF_WHOLE(9), TUFF_WHOLE(0) };
    picture_panel("Coincident circles: no push, or one", -8, -6.9, 14, 6.9);
    picture_circle(PICTURE_ROCK, center, TUFF_WHOLE(6));
    picture_circle(PICTURE_BODY, center, TUFF_WHOLE(3));
    picture_dot(PICTURE_FAILS, 0, 0);
    picture_circle(PICTURE_TUFF, out, TUFF_WHOLE(3));
    picture_arrow(PICTURE_TUFF, 0, 0, 9, 0);
}

static void draw_picture(void)
{
    static place p;
    if (!picture_begin("flips")) return;
    make_near_vertex(&p, 0.0625);
    picture_panel("A ball near a vertex", 6, 6.95, 11.2, 10.2);
    draw_place(&p);
    draw_push(PICTURE_FAILS, by_textbook, &p);
    draw_push(PICTURE_TUFF, by_tuff, &p);
    random_box_shape(&p.rock, (tuff_vec2){ TUFF_WHOLE(9), TUFF_WHOLE(9) });
    random_box_shape(&p.hull, (tuff_vec2){ TUFF_WHOLE(3), TUFF_RATIO(3, 2) });
    p.with_hull = true;
    p.at = grid_point(3, 1);
    picture_panel("One hull inside another: pushed out?", -12, -10, 20, 10);
    draw_place(&p);
    draw_push(PICTURE_FAILS, by_common_spans, &p);
    draw_push(PICTURE_TUFF, by_tuff, &p);
    draw_coincident();
    picture_end();
}

static void test_box2d_finds_nearly_all_least_pushes_and_tuff_finds_all(void **state)
{
    (void)state;
    make_table();
    draw_picture();
    assert_true(failures_of(by_box2d, false) < 2 && failures_of(by_tuff, false) == 0);     /* both agree on what is asked */
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_center_on_an_edge_leaves_by_a_least_push),
        cmocka_unit_test(test_a_center_on_a_vertex_leaves_by_a_least_push),
        cmocka_unit_test(test_a_center_at_the_centroid_leaves_by_a_least_push),
        cmocka_unit_test(test_a_square_in_a_square_leaves_by_a_least_push),
        cmocka_unit_test(test_regular_polygons_leave_by_a_least_push),
        cmocka_unit_test(test_nearly_parallel_faces_part_by_a_least_push),
        cmocka_unit_test(test_past_the_middle_the_push_is_still_the_least),
        cmocka_unit_test(test_a_body_inside_a_piece_leaves_by_a_least_push),
        cmocka_unit_test(test_a_body_around_a_piece_leaves_by_a_least_push),
        cmocka_unit_test(test_a_hair_turns_the_push_only_between_ties),
        cmocka_unit_test(test_pressed_in_for_a_thousand_steps_the_direction_stays),
        cmocka_unit_test(test_at_rest_the_first_push_is_the_last),
        cmocka_unit_test(test_coincident_circles_leave_along_x),
        cmocka_unit_test(test_common_spans_leave_hulls_inside_each_other),
        cmocka_unit_test(test_the_way_from_center_to_center_leads_down_into_a_rock),
        cmocka_unit_test(test_the_textbooks_guard_errs_near_a_vertex),
        cmocka_unit_test(test_box2d_finds_nearly_all_least_pushes_and_tuff_finds_all),
    };
    (void)argc;
    random_begin(argv);
    table_family(3, "Direction flips");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
