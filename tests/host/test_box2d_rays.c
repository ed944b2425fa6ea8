/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Beams against one piece, next to Box2D's ray casts on the same segments, near the origin and far from it. Both are judged by the oracle:
   hit or not, the point of the hit, the normal. */
#include "accuracy.h"
#include "twin.h"

#define PLACES 8
#define AGREED (EXACT_UNIT / 1000.0)

typedef struct target {             /* piece NULL: a circle */
    const twin *piece;
    tuff_real  radius;
    tuff_vec2  at;
    double     size;                /* steps */
} target;

typedef struct tally {
    unsigned long rays, hits, inside, wrong, box_wrong, agreed, tuff_nearer, box_nearer, faults;
    double point, normal, box_point;
} tally;

typedef struct truth {              /* entered: fraction and normal are known; not so where the segment only grazes or begins inside */
    bool   hit, inside, entered;
    exact  margin, fraction, length;
    exact2 a, b, normal;
} truth;

/* ---- the three of them ---- */

static bool tuff_says(const target *t, tuff_vec2 a, tuff_vec2 b, tuff_beam_hit *hit)
{
    tuff_terrain piece = { t->at, t->radius, t->radius, NULL, 0 };
    tuff_world world = { &piece, 1, NULL, NULL, 0, TUFF_ORDER_ITERATION };
    if (t->piece) piece = (tuff_terrain){ t->at, 0, t->piece->shape.bounding_radius, &t->piece->shape.polygon, 1 };
    return tuff_segment_terrain_first_hit(&world, a, b, hit);
}

static bool box_says(const target *t, tuff_vec2 a, tuff_vec2 b, box2d_hit *hit)
{
    if (t->piece) return box2d_ray_polygon(t->piece->box, twin_vec(t->at), twin_vec(a), twin_vec(b), hit);
    return box2d_ray_circle(tuff_to_float(t->radius), twin_vec(t->at), twin_vec(a), twin_vec(b), hit);
}

static truth oracle_says(const target *t, tuff_vec2 from, tuff_vec2 to)
{
    exact2 at = exact_vec2(t->at), a = exact_sub(exact_vec2(from), at), b = exact_sub(exact_vec2(to), at);
    exact radius = exact_real(t->radius);
    truth is = { false, false, false, 0, 0, exact_length(exact_sub(b, a)), a, b, { 0, 0 } };
    if (t->piece) {
        is.hit = oracle_segment_polygon(&t->piece->exact, a, b);
        is.inside = oracle_segment_polygon(&t->piece->exact, a, a);
        is.margin = oracle_segment_polygon_margin(&t->piece->exact, a, b);
        is.entered = !is.inside && oracle_enter_polygon(&t->piece->exact, a, b, &is.fraction, &is.normal);
    } else {
        is.hit = oracle_segment_circle(a, b, radius);
        is.inside = oracle_segment_circle(a, a, radius);
        is.margin = oracle_segment_circle_margin(a, b, radius);
        is.entered = !is.inside && oracle_enter_circle(a, b, radius, &is.fraction, &is.normal);
    }
    return is;
}

/* ---- judging ---- */

static exact point_tolerance(exact length)
{
    return EXACT_WHOLE ? 2 + length / 268435456 : accuracy_float_beam_band(length);
}

static exact2 point_at(const truth *is, exact fraction)
{
    exact2 way = exact_sub(is->b, is->a);
    return (exact2){ is->a.x + way.x * fraction, is->a.y + way.y * fraction };
}

static exact outline_distance(const target *t, exact2 point)
{
    return t->piece ? oracle_outline_distance(&t->piece->exact, point) : exact_abs(exact_length(point) - exact_real(t->radius));
}

/* Fixed build: how far the point of the hit is from the true one. Circles and the float build: from the outline, since a grazing beam's
   point is not better known than that. */
static exact point_error(const target *t, const truth *is, exact fraction)
{
    if (EXACT_WHOLE && t->piece) return exact_abs(fraction - is->fraction) * is->length;
    return outline_distance(t, point_at(is, fraction));
}

/* Of a polygon the normal of any face that the point of the hit is on; of a circle the direction of the point that was reported. */
static exact normal_error(const target *t, const truth *is, const tuff_beam_hit *hit, exact tolerance)
{
    exact2 point = point_at(is, t->piece ? is->fraction : exact_unit(hit->fraction)), normal = exact_unit2(hit->normal);
    if (t->piece == NULL) return oracle_angle(point, normal);
    exact least = oracle_angle(normal, is->normal);
    for (int i = 0; i < t->piece->exact.count; i++) {
        exact error = oracle_angle(normal, t->piece->exact.normals[i]);
        if (error < least && oracle_face_distance(&t->piece->exact, i, point) <= tolerance) least = error;
    }
    return least;
}

/* A circle's normal is no better than the point of the hit. */
static exact normal_tolerance(const target *t, exact point_tolerance_here)
{
    return (exact)1e-6 + (t->piece ? 0 : point_tolerance_here / exact_real(t->radius));
}

static const char *judge_inside(const truth *is, const tuff_beam_hit *hit)
{
    exact2 against = { (is->a.x - is->b.x) / is->length, (is->a.y - is->b.y) / is->length };
    if (hit->fraction != 0) return "beam that begins inside: fraction not 0";
    return oracle_angle(exact_unit2(hit->normal), against) > (exact)1e-6 ? "beam that begins inside: normal not against it" : NULL;
}

static const char *judge_hit(tally *sum, const target *t, const truth *is, const tuff_beam_hit *hit)
{
    exact tolerance = point_tolerance(is->length);
    exact point = point_error(t, is, exact_unit(hit->fraction)), normal = normal_error(t, is, hit, tolerance);
    raise_to(&sum->point, point);
    raise_to(&sum->normal, normal);
    if (point > tolerance) return "point of the hit";
    return normal > normal_tolerance(t, tolerance) ? "normal of the hit" : NULL;
}

static const char *judge_tuff(tally *sum, const target *t, const truth *is, bool found, const tuff_beam_hit *hit)
{
    exact decided = EXACT_WHOLE ? -1 : point_tolerance(is->length);
    sum->rays++;
    sum->hits += is->hit;
    sum->inside += is->inside;
    if (found != is->hit && is->margin > decided) {
        sum->wrong++;
        return is->hit ? "hit missed" : "hit reported of a beam that passes";
    }
    if (found && is->inside) return judge_inside(is, hit);
    return found && is->entered ? judge_hit(sum, t, is, hit) : NULL;
}

/* Box2D has no answer for a ray that begins inside. */
static const char *judge_box(tally *sum, const target *t, const truth *is, bool found, const tuff_beam_hit *ours, bool box_found,
                             const box2d_hit *box)
{
    if (is->inside) return NULL;
    if (box_found != is->hit && is->margin > (exact)AGREED) sum->box_wrong++;
    if (!found || !box_found || !is->entered) {
        sum->agreed += found == box_found;
        return NULL;
    }
    exact our_error = point_error(t, is, exact_unit(ours->fraction)), box_error = point_error(t, is, (exact)box->fraction);
    raise_to(&sum->box_point, box_error);
    sum->tuff_nearer += our_error < box_error;
    sum->box_nearer += box_error < our_error;
    if (exact_abs(exact_unit(ours->fraction) - (exact)box->fraction) * is->length <= (exact)AGREED) {
        sum->agreed++;
        return NULL;
    }
    return our_error > box_error + point_tolerance(is->length) ? "point differs from Box2D's, which is nearer" : NULL;
}

static void report(tally *sum, const random_run *run, uint32_t index, const char *fault, const truth *is, bool found,
                   const tuff_beam_hit *hit)
{
    if (!random_count_fault(&sum->faults, run, index, fault)) return;
    print_error("from (%.3f, %.3f) to (%.3f, %.3f) steps from the piece; exact: hit %d at %.12f; found %d at %.12f, "
                "normal (%.9f, %.9f)\n", (double)is->a.x, (double)is->a.y, (double)is->b.x, (double)is->b.y, is->hit,
                (double)is->fraction, found, (double)exact_unit(hit->fraction), (double)exact_unit(hit->normal.x),
                (double)exact_unit(hit->normal.y));
}

static void judge_ray(tally *sum, const random_run *run, uint32_t index, const target *t, tuff_vec2 a, tuff_vec2 b)
{
    tuff_beam_hit hit = { 0, { 0, 0 }, 77 };
    box2d_hit box = { 0, { 0, 0 } };
    truth is = oracle_says(t, a, b);
    bool found = tuff_says(t, a, b, &hit), box_found = box_says(t, a, b, &box);
    const char *fault = judge_tuff(sum, t, &is, found, &hit);
    const char *box_fault = judge_box(sum, t, &is, found, &hit, box_found, &box);
    if (hit.piece != (found ? 0 : 77)) fault = "piece of the hit";
    report(sum, run, index, fault ? fault : box_fault, &is, found, &hit);
}

/* ---- where ---- */

static double off(random_source *source, const target *t, double most)
{
    return t->size * random_within(source, -most, most);
}

static void ray_case(tally *sum, const random_run *run, uint32_t index, bool circle)
{
    random_source source = random_stream(run->seed, index);
    double size = random_magnitude(&source, 1, 63);
    twin piece;
    twin_make(&source, &piece, size);
    target t = { circle ? NULL : &piece, circle ? twin_real(size * EXACT_UNIT) : 0, family_position(&source), size * EXACT_UNIT };
    double x = (double)exact_real(t.at.x), y = (double)exact_real(t.at.y);
    for (int i = 0; i < PLACES; i++) {
        double far_off = random_chance(&source, 20) ? 1 : random_magnitude(&source, 1.5, random_chance(&source, 10) ? 150 : 12);
        tuff_vec2 a = { twin_real(x + off(&source, &t, far_off)), twin_real(y + off(&source, &t, far_off)) };
        tuff_vec2 b = { twin_real(x + off(&source, &t, 1.5)), twin_real(y + off(&source, &t, 1.5)) };
        judge_ray(sum, run, index, &t, a, b);
    }
    twin_free(&piece);
}

static void rays(const char *name, const char *what, uint32_t cases, bool circle)
{
    random_run run = random_cases(name, 501, cases);
    tally sum = { 0 };
    for (uint32_t i = run.first; i < run.end; i++) ray_case(&sum, &run, i, circle);
    printf("figures: %s: tuff %s against the oracle: %lu rays, %lu hits (%lu from inside), %lu wrong; largest errors: point %.3g units, "
           "normal %.2g rad\n", what, EXACT_BUILD, sum.rays, sum.hits, sum.inside, sum.wrong, sum.point / EXACT_UNIT, sum.normal);
    printf("figures: %s: Box2D against the oracle on those from outside: %lu wrong, point %.3g units; tuff %s and Box2D agree to 1e-3 "
           "units in %lu; nearer: tuff %lu times, Box2D %lu\n", what, sum.box_wrong, sum.box_point / EXACT_UNIT, EXACT_BUILD, sum.agreed,
           sum.tuff_nearer, sum.box_nearer);
    assert_int_equal(sum.faults, 0);
    if (sum.rays >= 1000) assert_true(sum.agreed + sum.inside >= sum.rays / 100 * 95);
}

static void beam_and_polygon_as_in_box2d(void **state)
{
    (void)state;
    rays(__func__, "beam and polygon of 3 to 8 vertices", 15000, false);
}

static void beam_and_circle_as_in_box2d(void **state)
{
    (void)state;
    rays(__func__, "beam and circle", 8000, true);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(beam_and_polygon_as_in_box2d),
        cmocka_unit_test(beam_and_circle_as_in_box2d),
    };
    (void)argc;
    random_begin(argv);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
