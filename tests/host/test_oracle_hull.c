/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Hulls against polygons, judged by the oracle: narrow phase and world positions, near and far, grazing and degenerate. */
#include "accuracy.h"
#include "families.h"

#define PLACES 6                    /* pairs of a case: two shapes, several offsets */

typedef struct pair {
    random_shape   piece_shape, hull_shape;
    oracle_polygon piece, hull;
    tuff_polygon   given_hull;      /* with or without normals */
    double         size;            /* units: the larger bounding radius */
} pair;

typedef struct place { tuff_terrain piece; tuff_vec2 position; bool in_world; } place;

/* A shape of its own; the piece itself; or the piece turned by almost nothing or almost half a turn, for nearly parallel faces. */
static void make_hull(random_source *source, pair *p, double largest)
{
    double angle = random_magnitude(source, 1e-6, 1e-4);
    switch (random_below(source, 8)) {
    case 0:  family_turned(&p->hull_shape, &p->piece_shape, 0); break;
    case 1:  family_turned(&p->hull_shape, &p->piece_shape, angle); break;
    case 2:  family_turned(&p->hull_shape, &p->piece_shape, 3.141592653589793 + angle); break;
    default: family_shape(source, &p->hull_shape, largest); break;
    }
}

static void make_pair(random_source *source, pair *p, double largest)
{
    family_shape(source, &p->piece_shape, largest);
    make_hull(source, p, largest);
    oracle_read_polygon(&p->piece, &p->piece_shape.polygon);
    oracle_read_polygon(&p->hull, &p->hull_shape.polygon);
    tuff_real piece = p->piece_shape.bounding_radius, hull = p->hull_shape.bounding_radius;
    p->size = units_of(piece > hull ? piece : hull);
    p->given_hull = p->hull_shape.polygon;
    if (random_chance(source, 50)) p->given_hull.normals = NULL;
}

/* How far the hull reaches back along a direction: what it needs to clear a face. */
static double reach_back(const oracle_polygon *hull, exact2 normal)
{
    exact most = -exact_dot(hull->vertices[0], normal);
    for (int i = 1; i < hull->count; i++) {
        exact reach = -exact_dot(hull->vertices[i], normal);
        if (reach > most) most = reach;
    }
    return (double)most;
}

/* This far off a face of the piece, or with the roles exchanged of the hull; anywhere along it. */
static tuff_vec2 off_face(random_source *source, const pair *p, double away)
{
    bool exchanged = random_chance(source, 50);
    const oracle_polygon *face_of = exchanged ? &p->hull : &p->piece, *other = exchanged ? &p->piece : &p->hull;
    int i = (int)random_below(source, (uint32_t)face_of->count);
    exact2 normal = face_of->normals[i];
    double out = away + (double)exact_dot(normal, face_of->vertices[i]) + reach_back(other, normal);
    double along = random_chance(source, 30) ? 0 : random_within(source, -p->size, p->size) * EXACT_UNIT;
    double x = (double)normal.x * out - (double)normal.y * along, y = (double)normal.y * out + (double)normal.x * along;
    return exchanged ? vec2_from_doubles(-x, -y) : vec2_from_doubles(x, y);
}

/* Two vertices on one another, or a few steps apart. */
static tuff_vec2 vertex_on_vertex(random_source *source, const pair *p)
{
    exact2 a = p->piece.vertices[random_below(source, (uint32_t)p->piece.count)];
    exact2 b = p->hull.vertices[random_below(source, (uint32_t)p->hull.count)];
    double x = family_steps(source);
    return vec2_from_doubles((double)(a.x - b.x) + x, (double)(a.y - b.y) + family_steps(source));
}

static tuff_vec2 some_offset(random_source *source, const pair *p)
{
    switch (random_below(source, 5)) {
    case 0:  return random_point(source, p->size * 2);
    case 1:  return off_face(source, p, family_steps(source));
    case 2:  return off_face(source, p, -p->size * EXACT_UNIT * random_fraction(source));
    case 3:  return vertex_on_vertex(source, p);
    default: return random_chance(source, 30) ? (tuff_vec2){ 0, 0 } : vec2_from_doubles(family_steps(source), family_steps(source));
    }
}

static bool overlap(const pair *p, const place *at, tuff_contact *contact)
{
    if (at->in_world) return tuff_terrain_overlap_hull(&at->piece, at->position, p->hull_shape.bounding_radius, &p->given_hull, contact);
    return tuff_polygon_polygon(&p->given_hull, at->position, &p->piece_shape.polygon, contact);
}

static const char *judge_left_over(accuracy *sum, const accuracy_bounds *bounds, const pair *p, const place *at,
                                   const tuff_contact *contact)
{
    tuff_vec2 pushed = accuracy_pushed(at->position, contact);
    oracle_answer answer;
    oracle_hull(&p->piece, &p->hull, exact_sub(exact_vec2(pushed), exact_vec2(at->piece.position)), &answer);
    return accuracy_judge_push(sum, bounds, answer.depth, pushed);
}

/* The gap along the best face is no more than the distance; the distance itself is looked at only where it matters. */
static exact margin_of(const pair *p, exact2 offset, const oracle_answer *answer, bool found)
{
    if (!found || answer->depth > 0) return exact_abs(answer->depth);
    return oracle_hull_distance(&p->piece, &p->hull, offset);
}

static void judge_place(accuracy *sum, const random_run *run, uint32_t index, const pair *p, const place *at)
{
    tuff_vec2 relative = { at->position.x - at->piece.position.x, at->position.y - at->piece.position.y };
    accuracy_bounds bounds = accuracy_bounds_of(p->size);
    tuff_contact contact = accuracy_untouched;
    oracle_answer answer;
    bool found = overlap(p, at, &contact);
    oracle_hull(&p->piece, &p->hull, exact_vec2(relative), &answer);
    exact margin = margin_of(p, exact_vec2(relative), &answer, found);
    const char *fault = accuracy_judge(sum, &bounds, &answer, margin, found, &contact);
    if (found && !fault) fault = judge_left_over(sum, &bounds, p, at, &contact);
    accuracy_report_fault(sum, run, index, fault, &answer, found, &contact);
}

static void hull_case(accuracy *sum, const random_run *run, uint32_t index, double largest)
{
    random_source source = random_stream(run->seed, index);
    pair p;
    make_pair(&source, &p, largest);
    for (int i = 0; i < PLACES; i++) {
        tuff_terrain piece = { { 0, 0 }, 0, p.piece_shape.bounding_radius, &p.piece_shape.polygon, 1 };
        place at = { piece, some_offset(&source, &p), random_chance(&source, 50) };
        if (at.in_world) at.piece.position = family_position(&source);
        at.position.x += at.piece.position.x;
        at.position.y += at.piece.position.y;
        judge_place(sum, run, index, &p, &at);
    }
}

static void hull_and_polygon_to_64_units(void **state)
{
    (void)state;
    accuracy_run(__func__, "hull and polygon, to 64 units", 201, 30000, hull_case, 64);
}

static void hull_and_polygon_to_1024_units(void **state)
{
    (void)state;
    accuracy_run(__func__, "hull and polygon, to 1024 units", 201, 30000, hull_case, 1024);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hull_and_polygon_to_64_units),
        cmocka_unit_test(hull_and_polygon_to_1024_units),
    };
    (void)argc;
    random_begin(argv);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
