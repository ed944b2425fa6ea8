/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Both builds linked into one program, asked the same questions: they may differ by their rounding and by nothing else. */
#define TUFF_SCALAR TUFF_FLOAT      /* random.h counts in the float build's numbers; the shapes are on a grid that both builds hold */
#include "random.h"
#include "side.h"

#define NEAR 1e-4                   /* units: the sum of what both builds are allowed to be off for shapes of this size */
#define BEAM_NEAR 1e-3              /* units along the beam, which may meet the face at a small angle */

typedef struct tally { unsigned long asked, found, undecided, other_axis, faults; double depth, normal, place; } tally;

typedef struct scene { side_shape rock, hull; side_vec at, body; int32_t radius; } scene;

/* To a grid of 1/1024 unit, in steps. */
static int32_t on_grid(double units)
{
    return (int32_t)floor(units * 1024 + 0.5) * 64;
}

static side_vec grid_vec(random_source *source, double extent)
{
    int32_t x = on_grid(random_within(source, -extent, extent));
    return (side_vec){ x, on_grid(random_within(source, -extent, extent)) };
}

static void make_shape(random_source *source, side_shape *shape, double size)
{
    tuff_vec2 points[SIDE_VERTICES], hull[SIDE_VERTICES + 2];
    int kept = 0, count = random_between(source, 3, SIDE_VERTICES);
    while (kept < 3) {
        for (int i = 0; i < count; i++) {
            double angle = random_within(source, 0, 6.283185307179586);
            points[i].x = TUFF_REAL_RAW(on_grid(size * cos(angle)));
            points[i].y = TUFF_REAL_RAW(on_grid(size * 0.7 * sin(angle)));
        }
        kept = random_hull_of(points, count, hull);
    }
    random_renumber(source, hull, kept);
    shape->count = kept;
    for (int i = 0; i < kept; i++) shape->vertices[i] = (side_vec){ tuff_to_q16_16(hull[i].x), tuff_to_q16_16(hull[i].y) };
}

static void make_scene(random_source *source, scene *s)
{
    double rock = random_magnitude(source, 2, 60), hull = random_magnitude(source, 2, 60);
    make_shape(source, &s->rock, rock);
    make_shape(source, &s->hull, hull);
    s->radius = on_grid(hull);
    s->at = grid_vec(source, random_chance(source, 50) ? 100 : 8000);
    side_vec off = grid_vec(source, rock + hull);
    s->body = (side_vec){ s->at.x + off.x, s->at.y + off.y };
}

static double apart(double ax, double ay, double bx, double by)
{
    return hypot(ax - bx, ay - by);
}

/* Where two axes are equally good, each build may take its own. */
static const char *compare_contacts(tally *sum, side_contact f, side_contact q)
{
    sum->asked++;
    sum->found += q.found;
    if (f.found != q.found) {
        sum->undecided++;
        return f.overlap + q.overlap > NEAR ? "one build finds an overlap that the other does not" : NULL;
    }
    if (!f.found) return NULL;
    raise_to(&sum->depth, (exact)fabs(f.overlap - q.overlap));
    if (fabs(f.overlap - q.overlap) > NEAR) return "depths differ";
    double normal = apart(f.x, f.y, q.x, q.y);
    if (normal > 1e-3) sum->other_axis++;
    else raise_to(&sum->normal, (exact)normal);
    return normal > 3e-6 && normal <= 1e-3 ? "normals differ" : NULL;
}

static const char *compare_beams(tally *sum, const scene *s, side_vec a, side_vec b)
{
    side_hit f = side_float.beam(&s->rock, s->at, a, b), q = side_q16.beam(&s->rock, s->at, a, b);
    double length = apart(a.x, a.y, b.x, b.y) / 65536;
    sum->asked++;
    sum->found += q.found;
    sum->undecided += f.found != q.found;
    if (!f.found || !q.found) return NULL;
    if (apart(f.x, f.y, q.x, q.y) > 1e-3) {
        sum->other_axis++;
        return NULL;
    }
    raise_to(&sum->place, (exact)(fabs(f.fraction - q.fraction) * length));
    return fabs(f.fraction - q.fraction) * length > BEAM_NEAR ? "points of the hit differ" : NULL;
}

static const char *compare_states(tally *sum, side_state f, side_state q)
{
    sum->asked++;
    sum->found += q.pushes > 0;
    if (f.pushes != q.pushes || apart(f.vx, f.vy, q.vx, q.vy) > 1e-2) {
        sum->other_axis++;
        return NULL;
    }
    raise_to(&sum->place, (exact)apart(f.x, f.y, q.x, q.y));
    if (apart(f.x, f.y, q.x, q.y) > 0.002) return "places after the push differ";
    return apart(f.vx, f.vy, q.vx, q.vy) > 1e-4 ? "velocities after the bounce differ" : NULL;
}

static const char *ask_circle(tally *sum, random_source *source, const scene *s)
{
    (void)source;
    return compare_contacts(sum, side_float.circle(&s->rock, s->at, s->body, s->radius),
                            side_q16.circle(&s->rock, s->at, s->body, s->radius));
}

static const char *ask_hull(tally *sum, random_source *source, const scene *s)
{
    (void)source;
    return compare_contacts(sum, side_float.hull(&s->rock, s->at, &s->hull, s->body), side_q16.hull(&s->rock, s->at, &s->hull, s->body));
}

static const char *ask_beam(tally *sum, random_source *source, const scene *s)
{
    side_vec to = grid_vec(source, 100);
    return compare_beams(sum, s, s->body, (side_vec){ s->at.x + to.x, s->at.y + to.y });
}

static const char *ask_collide(tally *sum, random_source *source, const scene *s)
{
    side_vec velocity = grid_vec(source, 8);
    return compare_states(sum, side_float.collide(&s->rock, s->at, &s->hull, s->body, velocity),
                          side_q16.collide(&s->rock, s->at, &s->hull, s->body, velocity));
}

static void compare(const char *name, const char *what, uint32_t count, const char *(*ask)(tally *, random_source *, const scene *))
{
    random_run run = random_cases(name, 801, count);
    tally sum = { 0 };
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        scene s;
        make_scene(&source, &s);
        random_count_fault(&sum.faults, &run, i, ask(&sum, &source, &s));
    }
    printf("figures: both builds, %s: %lu asked, %lu found, %lu undecided, %lu on another axis; largest differences: depth %.3g "
           "units, normal %.2g rad, place %.3g units\n", what, sum.asked, sum.found, sum.undecided, sum.other_axis, sum.depth, sum.normal,
           sum.place);
    assert_int_equal(sum.faults, 0);
    assert_true(sum.undecided + sum.other_axis <= sum.asked / 200 + 1);
}

static void both_builds_agree_on_circles(void **state)
{
    (void)state;
    compare(__func__, "circle and polygon", 40000, ask_circle);
}

static void both_builds_agree_on_hulls(void **state)
{
    (void)state;
    compare(__func__, "hull and polygon", 40000, ask_hull);
}

static void both_builds_agree_on_beams(void **state)
{
    (void)state;
    compare(__func__, "beam and polygon", 40000, ask_beam);
}

static void both_builds_agree_on_pushes_and_bounces(void **state)
{
    (void)state;
    compare(__func__, "push and bounce", 40000, ask_collide);
}

static void the_builds_are_two(void **state)
{
    (void)state;
    assert_string_equal(side_float.name, "float");
    assert_string_equal(side_q16.name, "q16");
    assert_ptr_not_equal(side_float.circle, side_q16.circle);
    assert_int_equal(side_float.real_size, side_q16.real_size);
    assert_int_equal(side_float.polygon_size, side_q16.polygon_size);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_builds_are_two),
        cmocka_unit_test(both_builds_agree_on_circles),
        cmocka_unit_test(both_builds_agree_on_hulls),
        cmocka_unit_test(both_builds_agree_on_beams),
        cmocka_unit_test(both_builds_agree_on_pushes_and_bounces),
    };
    (void)argc;
    random_begin(argv);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
