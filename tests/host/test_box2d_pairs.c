/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Overlap, depth and normal of circles and polygons, next to Box2D 2.4 on the same pairs, near the origin and far from it. Both are judged
   by the oracle. Where they differ, tuff must be the nearer one. */
#include "accuracy.h"
#include "twin.h"

#define PLACES 8
#define AGREED (EXACT_UNIT / 1000.0)    /* depths this close, and yes or no this close to touching, count as agreed */

typedef struct versus {             /* the figures of a run */
    accuracy tuff;
    unsigned long box_wrong, box_gjk_wrong, box_axis, agreed;
    unsigned long tuff_nearer, box_nearer, tuff_clearly, box_clearly;    /* clearly: by more than a step of 1/65536 */
    double box_depth, box_normal, box_left;     /* normal: among those whose axis is a least one */
} versus;

typedef struct pair {               /* hull NULL: the circle */
    const twin *piece, *hull;
    tuff_real  radius;
    tuff_vec2  at, position;
} pair;

/* ---- the three of them ---- */

static bool tuff_says(const pair *p, tuff_contact *contact)
{
    tuff_terrain piece = { p->at, 0, p->piece->shape.bounding_radius, &p->piece->shape.polygon, 1 };
    if (p->hull == NULL) return tuff_terrain_overlap_circle(&piece, p->position, p->radius, contact);
    return tuff_terrain_overlap_hull(&piece, p->position, p->hull->shape.bounding_radius, &p->hull->shape.polygon, contact);
}

static bool box_says(const pair *p, box2d_contact *contact)
{
    box2d_vec at = twin_vec(p->at), position = twin_vec(p->position);
    if (p->hull) return box2d_hull_polygon(p->piece->box, at, p->hull->box, position, contact);
    return box2d_circle_polygon(p->piece->box, at, position, tuff_to_float(p->radius), contact);
}

static bool box_gjk_says(const pair *p)
{
    box2d_vec at = twin_vec(p->at), position = twin_vec(p->position);
    if (p->hull) return box2d_hull_touches(p->piece->box, at, p->hull->box, position);
    return box2d_circle_touches(p->piece->box, at, position, tuff_to_float(p->radius));
}

static exact2 relative_of(const pair *p, tuff_vec2 position)
{
    return exact_sub(exact_vec2(position), exact_vec2(p->at));
}

static void oracle_says(const pair *p, exact2 relative, oracle_answer *answer)
{
    if (p->hull) oracle_hull(&p->piece->exact, &p->hull->exact, relative, answer);
    else oracle_circle(&p->piece->exact, relative, exact_real(p->radius), answer);
}

static exact margin_of(const pair *p, const oracle_answer *answer)
{
    if (p->hull == NULL || answer->depth > 0) return exact_abs(answer->depth);
    return oracle_hull_distance(&p->piece->exact, &p->hull->exact, relative_of(p, p->position));
}

/* ---- judging ---- */

static exact depth_at(const pair *p, exact2 relative)
{
    oracle_answer answer;
    oracle_says(p, relative, &answer);
    return answer.depth;
}

/* Box2D has no push of its own: it is moved without rounding. */
static void judge_box_contact(versus *sum, const oracle_answer *answer, const pair *p, const box2d_contact *contact)
{
    exact2 normal = { (exact)contact->normal.x, (exact)contact->normal.y };
    exact overlap = (exact)contact->overlap * EXACT_UNIT;
    double depth = fabs((double)(overlap - answer->depth)), error = (double)oracle_normal_error(answer, (exact)AGREED, normal);
    double left = (double)depth_at(p, exact_add(relative_of(p, p->position), (exact2){ normal.x * overlap, normal.y * overlap }));
    raise_to(&sum->box_depth, (exact)depth);
    raise_to(&sum->box_left, (exact)left);
    if (error > 0.001) sum->box_axis++;
    else raise_to(&sum->box_normal, (exact)error);
}

static const char *judge_push(accuracy *sum, const accuracy_bounds *bounds, const pair *p, const tuff_contact *contact)
{
    tuff_vec2 pushed = accuracy_pushed(p->position, contact);
    return accuracy_judge_push(sum, bounds, depth_at(p, relative_of(p, pushed)), pushed);
}

/* Of two that both found the overlap: who is nearer to the truth? NULL: all is well. */
static const char *compare_depths(versus *sum, const oracle_answer *answer, const tuff_contact *ours, const box2d_contact *box)
{
    double our_error = fabs((double)(exact_real(ours->overlap) - answer->depth));
    double box_error = fabs((double)((exact)box->overlap * EXACT_UNIT - answer->depth));
    sum->tuff_nearer += our_error < box_error;
    sum->box_nearer += box_error < our_error;
    sum->tuff_clearly += our_error + 1 < box_error;
    sum->box_clearly += box_error + 1 < our_error;
    if (fabs((double)(exact_real(ours->overlap) - (exact)box->overlap * EXACT_UNIT)) <= AGREED) {
        sum->agreed++;
        return NULL;
    }
    return our_error > box_error ? "depth differs from Box2D's, which is nearer" : NULL;
}

static const char *judge_box(versus *sum, const oracle_answer *answer, exact margin, const pair *p, bool found, const tuff_contact *contact)
{
    box2d_contact box;
    bool box_found = box_says(p, &box), truth = answer->depth > 0, decided = margin > (exact)AGREED;
    if (decided && box_found != truth) sum->box_wrong++;
    if (decided && box_gjk_says(p) != truth) sum->box_gjk_wrong++;
    if (box_found && truth) judge_box_contact(sum, answer, p, &box);
    if (found && box_found) return compare_depths(sum, answer, contact, &box);
    if (found == box_found) sum->agreed++;
    return found != truth && box_found == truth && decided ? "yes or no differs from Box2D's, which is right" : NULL;
}

static void judge_pair(versus *sum, const random_run *run, uint32_t index, const pair *p)
{
    accuracy_bounds bounds = accuracy_bounds_of(units_of(p->piece->shape.bounding_radius));
    tuff_contact contact = accuracy_untouched;
    oracle_answer answer;
    bool found = tuff_says(p, &contact);
    oracle_says(p, relative_of(p, p->position), &answer);
    exact margin = margin_of(p, &answer);
    const char *fault = accuracy_judge(&sum->tuff, &bounds, &answer, margin, found, &contact);
    if (found && !fault) fault = judge_push(&sum->tuff, &bounds, p, &contact);
    const char *box_fault = judge_box(sum, &answer, margin, p, found, &contact);
    accuracy_report_fault(&sum->tuff, run, index, fault ? fault : box_fault, &answer, found, &contact);
}

/* ---- where ---- */

/* Half of them anywhere in reach, half near the face of the piece, or the hull's, that would just touch. */
static tuff_vec2 some_offset(random_source *source, const pair *p)
{
    const oracle_polygon *piece = &p->piece->exact;
    double other = (double)exact_real(p->hull ? p->hull->shape.bounding_radius : p->radius);
    double reach = (double)exact_real(p->piece->shape.bounding_radius) + other;
    if (random_chance(source, 50)) {
        double x = random_within(source, -reach, reach);
        return (tuff_vec2){ twin_real(x), twin_real(random_within(source, -reach, reach)) };
    }
    int i = (int)random_below(source, (uint32_t)piece->count);
    double along = random_within(source, -reach, reach) / 4, nx = (double)piece->normals[i].x, ny = (double)piece->normals[i].y;
    double out = (double)exact_dot(piece->normals[i], piece->vertices[i]) + other * random_within(source, 0.9, 1.01);
    return (tuff_vec2){ twin_real(nx * out - ny * along), twin_real(ny * out + nx * along) };
}

static void versus_case(versus *sum, const random_run *run, uint32_t index, bool with_hull)
{
    random_source source = random_stream(run->seed, index);
    twin piece, hull;
    twin_make(&source, &piece, random_magnitude(&source, 1, 63));
    twin_make(&source, &hull, random_magnitude(&source, 1, 63));
    for (int i = 0; i < PLACES; i++) {
        tuff_real radius = twin_real(EXACT_UNIT * random_magnitude(&source, 0.25, 63));
        pair p = { &piece, with_hull ? &hull : NULL, radius, family_position(&source), { 0, 0 } };
        p.position = some_offset(&source, &p);
        p.position.x += p.at.x;
        p.position.y += p.at.y;
        judge_pair(sum, run, index, &p);
    }
    twin_free(&piece);
    twin_free(&hull);
}

static void print_versus(const versus *sum, const char *what)
{
    accuracy_print(&sum->tuff, what);
    printf("figures: %s: Box2D against the oracle on the same pairs: %lu wrong (%lu by b2TestOverlap), %lu not along a least axis; "
           "largest errors: depth %.3g units, normal %.2g rad, left over %.3g units\n", what, sum->box_wrong, sum->box_gjk_wrong,
           sum->box_axis, sum->box_depth / EXACT_UNIT, sum->box_normal, sum->box_left / EXACT_UNIT);
    printf("figures: %s: tuff %s and Box2D agree to 1e-3 units in %lu of %lu; nearer in depth: tuff %lu times, Box2D %lu; "
           "by more than 1/65536 unit: tuff %lu, Box2D %lu\n", what, EXACT_BUILD, sum->agreed, sum->tuff.pairs, sum->tuff_nearer,
           sum->box_nearer, sum->tuff_clearly, sum->box_clearly);
}

/* Box2D prefers the piece's face while the hull's is better by less than a tenth of its slop: agreement is not total. */
static void compare(const char *name, const char *what, uint64_t seed, bool with_hull)
{
    random_run run = random_cases(name, seed, 15000);
    versus sum = { 0 };
    for (uint32_t i = run.first; i < run.end; i++) versus_case(&sum, &run, i, with_hull);
    print_versus(&sum, what);
    assert_int_equal(sum.tuff.faults, 0);
    if (sum.tuff.pairs >= 1000) assert_true(sum.agreed >= sum.tuff.pairs / 100 * 99);
}

static void circle_and_polygon_as_in_box2d(void **state)
{
    (void)state;
    compare(__func__, "circle and polygon of 3 to 8 vertices", 401, false);
}

static void hull_and_polygon_as_in_box2d(void **state)
{
    (void)state;
    compare(__func__, "hull and polygon of 3 to 8 vertices", 402, true);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(circle_and_polygon_as_in_box2d),
        cmocka_unit_test(hull_and_polygon_as_in_box2d),
    };
    (void)argc;
    random_begin(argv);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
