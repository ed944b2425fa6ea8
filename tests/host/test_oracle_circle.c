/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Circles against polygons and circles, judged by the oracle: narrow phase and world positions, near and far, grazing and degenerate. */
#include "accuracy.h"
#include "families.h"

#define PLACES 8                    /* pairs of a case: one shape, several circles */

typedef struct placed { tuff_vec2 center; tuff_real radius; } placed;

static double steps_of(tuff_real value)
{
    return (double)exact_real(value);
}

static tuff_real some_radius(random_source *source, double largest)
{
    if (random_chance(source, 5)) return random_chance(source, 50) ? TUFF_REAL_RAW(0) : TUFF_REAL_RAW(1);
    if (random_chance(source, 50)) return tuff_from_int(random_between(source, 1, (int32_t)largest));
    return real_from_double(EXACT_UNIT * random_magnitude(source, 1.0 / 64, largest));
}

static tuff_vec2 anywhere(random_source *source, const random_shape *shape, tuff_real radius)
{
    return random_point(source, (steps_of(shape->bounding_radius) + steps_of(radius)) / EXACT_UNIT);
}

/* Out from a random point of a random edge, or from the vertex at its start in a random direction between the two normals. */
static tuff_vec2 out_from_outline(random_source *source, const oracle_polygon *p, double away)
{
    int i = (int)random_below(source, (uint32_t)p->count), before = i == 0 ? p->count - 1 : i - 1, after = i + 1 == p->count ? 0 : i + 1;
    double share = random_fraction(source);
    exact2 normal = p->normals[i], from = p->vertices[i], along = exact_sub(p->vertices[after], from);
    if (random_chance(source, 50)) {
        exact2 other = p->normals[before];
        normal.x = normal.x * (exact)share + other.x * (exact)(1 - share);
        normal.y = normal.y * (exact)share + other.y * (exact)(1 - share);
        exact length = exact_length(normal);
        normal = (exact2){ normal.x / length, normal.y / length };
        share = 0;
    }
    double x = (double)(from.x + along.x * (exact)share), y = (double)(from.y + along.y * (exact)share);
    return vec2_from_doubles(x + (double)normal.x * away, y + (double)normal.y * away);
}

/* Along the border of two Voronoi regions: out from a vertex along an edge's normal, and a few steps aside. */
static tuff_vec2 between_regions(random_source *source, const oracle_polygon *p, double away)
{
    int i = (int)random_below(source, (uint32_t)p->count);
    double aside = family_steps(source), nx = (double)p->normals[i].x, ny = (double)p->normals[i].y;
    return vec2_from_doubles((double)p->vertices[i].x + nx * away - ny * aside, (double)p->vertices[i].y + ny * away + nx * aside);
}

/* On or a few steps off a vertex, the middle of an edge, the centroid of the vertices, the origin. */
static tuff_vec2 on_feature(random_source *source, const random_shape *shape)
{
    int count = shape->polygon.count, i = (int)random_below(source, (uint32_t)count);
    tuff_vec2 here = shape->vertices[i], next = shape->vertices[(i + 1) % count], point = { 0, 0 };
    uint32_t which = random_below(source, 4);
    if (which == 0) point = here;
    if (which == 1) point = (tuff_vec2){ here.x / 2 + next.x / 2, here.y / 2 + next.y / 2 };
    for (int k = 0; which == 2 && k < count; k++) {
        point.x += shape->vertices[k].x / (tuff_real)count;
        point.y += shape->vertices[k].y / (tuff_real)count;
    }
    if (random_chance(source, 50)) return point;
    return (tuff_vec2){ point.x + TUFF_REAL_RAW(random_between(source, -3, 3)), point.y + TUFF_REAL_RAW(random_between(source, -3, 3)) };
}

static placed place_circle(random_source *source, const random_shape *shape, const oracle_polygon *p, double largest)
{
    placed circle = { { 0, 0 }, some_radius(source, largest) };
    double radius = steps_of(circle.radius);
    switch (random_below(source, 6)) {
    case 0:  circle.center = anywhere(source, shape, circle.radius); break;
    case 1:  circle.center = out_from_outline(source, p, radius + family_steps(source)); break;
    case 2:  circle.center = out_from_outline(source, p, family_steps(source)); break;
    case 3:  circle.center = out_from_outline(source, p, radius * random_within(source, -1, 1)); break;
    case 4:  circle.center = between_regions(source, p, radius * random_fraction(source)); break;
    default: circle.center = on_feature(source, shape); break;
    }
    return circle;
}

typedef struct scene { const random_shape *shape; const oracle_polygon *polygon; tuff_terrain piece; bool in_world; } scene;

static bool overlap(const scene *s, tuff_vec2 position, tuff_real radius, tuff_contact *contact)
{
    if (s->in_world) return tuff_terrain_overlap_circle(&s->piece, position, radius, contact);
    return tuff_circle_polygon(position, radius, &s->shape->polygon, contact);
}

static exact depth_at(const scene *s, tuff_vec2 position, tuff_real radius)
{
    oracle_answer answer;
    oracle_circle(s->polygon, exact_sub(exact_vec2(position), exact_vec2(s->piece.position)), exact_real(radius), &answer);
    return answer.depth;
}

static const char *judge_left_over(accuracy *sum, const accuracy_bounds *bounds, const scene *s, tuff_vec2 position, tuff_real radius,
                                   const tuff_contact *contact)
{
    tuff_vec2 pushed = accuracy_pushed(position, contact);
    return accuracy_judge_push(sum, bounds, depth_at(s, pushed, radius), pushed);
}

/* The oracle is asked about the relative position as the build rounds it. */
static void judge_pair(accuracy *sum, const random_run *run, uint32_t index, const scene *s, const placed *circle)
{
    tuff_vec2 at = s->piece.position, position = { at.x + circle->center.x, at.y + circle->center.y };
    tuff_vec2 relative = { position.x - at.x, position.y - at.y };
    double size = steps_of(s->shape->bounding_radius > circle->radius ? s->shape->bounding_radius : circle->radius) / EXACT_UNIT;
    accuracy_bounds bounds = accuracy_bounds_of(size);
    tuff_contact contact = accuracy_untouched;
    oracle_answer answer;
    bool found = overlap(s, position, circle->radius, &contact);
    oracle_circle(s->polygon, exact_vec2(relative), exact_real(circle->radius), &answer);
    const char *fault = accuracy_judge(sum, &bounds, &answer, exact_abs(answer.depth), found, &contact);
    if (found && !fault) fault = judge_left_over(sum, &bounds, s, position, circle->radius, &contact);
    accuracy_report_fault(sum, run, index, fault, &answer, found, &contact);
}

static void circle_case(accuracy *sum, const random_run *run, uint32_t index, double largest)
{
    random_source source = random_stream(run->seed, index);
    random_shape shape;
    oracle_polygon polygon;
    family_shape(&source, &shape, largest);
    oracle_read_polygon(&polygon, &shape.polygon);
    for (int i = 0; i < PLACES; i++) {
        scene s = { &shape, &polygon, { { 0, 0 }, 0, shape.bounding_radius, &shape.polygon, 1 }, random_chance(&source, 50) };
        placed circle = place_circle(&source, &shape, &polygon, largest);
        if (s.in_world) s.piece.position = family_position(&source);
        judge_pair(sum, run, index, &s, &circle);
    }
}

static void circle_and_polygon_to_64_units(void **state)
{
    (void)state;
    accuracy_run(__func__, "circle and polygon, to 64 units", 101, 35000, circle_case, 64);
}

static void circle_and_polygon_to_1024_units(void **state)
{
    (void)state;
    accuracy_run(__func__, "circle and polygon, to 1024 units", 101, 35000, circle_case, 1024);
}

/* ---- circles against circles ---- */

static tuff_vec2 near_circle(random_source *source, tuff_real radius, tuff_real obstacle)
{
    double reach = steps_of(radius) + steps_of(obstacle), angle = random_within(source, 0, 6.283185307179586);
    double away = random_chance(source, 50) ? reach + family_steps(source) : reach * random_fraction(source);
    if (random_chance(source, 10)) away = fabs(family_steps(source));
    return vec2_from_doubles(away * cos(angle), away * sin(angle));
}

static const char *judge_circles_push(accuracy *sum, const accuracy_bounds *bounds, tuff_vec2 center, exact reach,
                                      const tuff_contact *contact)
{
    tuff_vec2 pushed = accuracy_pushed(center, contact);
    return accuracy_judge_push(sum, bounds, reach - exact_length(exact_vec2(pushed)), pushed);
}

/* The header's own bounds are narrower than the contract's: half a step, 1e-8 rad; float 2e-7 rad. */
static void circles_case(accuracy *sum, const random_run *run, uint32_t index, double largest)
{
    random_source source = random_stream(run->seed, index);
    tuff_real radius = some_radius(&source, 64), obstacle = some_radius(&source, index % 2 ? largest : 64);
    tuff_vec2 center = near_circle(&source, radius, obstacle);
    accuracy_bounds bounds = accuracy_bounds_of(steps_of(obstacle) / EXACT_UNIT);
    oracle_answer answer;
    tuff_contact contact = accuracy_untouched;
    bool found = tuff_circle_circle(center, radius, obstacle, &contact);
    oracle_circles(exact_vec2(center), exact_real(radius), exact_real(obstacle), &answer);
    bounds.normal = EXACT_WHOLE ? (exact)1e-8 : (exact)2e-7;
    if (EXACT_WHOLE) bounds.depth = bounds.band = (exact)0.5;
    const char *fault = accuracy_judge(sum, &bounds, &answer, exact_abs(answer.depth), found, &contact);
    if (found && !fault) fault = judge_circles_push(sum, &bounds, center, exact_real(radius) + exact_real(obstacle), &contact);
    accuracy_report_fault(sum, run, index, fault, &answer, found, &contact);
}

static void circle_and_circle(void **state)
{
    (void)state;
    accuracy_run(__func__, "circle and circle", 102, 100000, circles_case, 1024);
}

/* ---- far apart ---- */

/* Anywhere in the range of the numbers: the difference of two of these has 33 bits. */
static tuff_vec2 anywhere_at_all(random_source *source)
{
    const double most = 2147483000.0;
    double x = random_within(source, -most, most), y = random_within(source, -most, most);
    if (random_chance(source, 20)) return vec2_from_doubles(x < 0 ? -most : most, y < 0 ? -most : most);
    return vec2_from_doubles(x, y);
}

static bool is_far(tuff_vec2 a, tuff_vec2 b)
{
    exact2 gap = exact_sub(exact_vec2(a), exact_vec2(b));
    return exact_length(gap) > (exact)2 * TUFF_MAX_BOUNDING_RADIUS * EXACT_UNIT;
}

static void far_pieces_never_meet(void **state)
{
    random_run run = random_cases(__func__, 103, 20000);
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        random_shape shape;
        tuff_contact contact = accuracy_untouched;
        family_shape(&source, &shape, 1024);
        tuff_terrain piece = { anywhere_at_all(&source), TUFF_WHOLE(1), shape.bounding_radius, &shape.polygon, 1 };
        tuff_vec2 position = anywhere_at_all(&source);
        bool met = tuff_terrain_overlap_circle(&piece, position, TUFF_WHOLE(TUFF_MAX_RADIUS), &contact) ||
                   tuff_terrain_overlap_hull(&piece, position, shape.bounding_radius, &shape.polygon, &contact);
        piece.parts = NULL;
        met = met || tuff_terrain_overlap_circle(&piece, position, TUFF_WHOLE(TUFF_MAX_RADIUS), &contact);
        if (is_far(piece.position, position) && met) random_fail(&run, i, "an overlap over more than twice the largest radius");
    }
}

static void coincident_circles_part_along_x(void **state)
{
    tuff_contact contact = accuracy_untouched;
    (void)state;
    assert_true(tuff_circle_circle((tuff_vec2){ 0, 0 }, TUFF_WHOLE(3), TUFF_WHOLE(5), &contact));
    assert_true(contact.overlap == TUFF_WHOLE(8));
    assert_true(contact.normal.x == TUFF_UNIT_RATIO(1, 1) && contact.normal.y == 0);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(circle_and_polygon_to_64_units),
        cmocka_unit_test(circle_and_polygon_to_1024_units),
        cmocka_unit_test(circle_and_circle),
        cmocka_unit_test(far_pieces_never_meet),
        cmocka_unit_test(coincident_circles_part_along_x),
    };
    (void)argc;
    random_begin(argv);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
