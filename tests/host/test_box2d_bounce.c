/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A circle that runs into a fixed polygon, over restitutions 0 to 1, without friction: the velocity after tuff_bounce next to the velocity
   after one step of Box2D, and both next to v - (1 + e) (v . n) n with the exact normal. */
#include "twin.h"

#define STEPS_A_SECOND 64           /* Box2D thinks in seconds, tuff in steps */

typedef struct tally { unsigned long bounces, outwards, faults; double tuff, box, apart; } tally;

typedef struct impact {
    twin      rock;
    tuff_vec2 at, position, velocity;      /* velocity in units a step */
    tuff_real radius, restitution;
} impact;

/* A sixteenth of a unit or less into a face or a corner of the rock. */
static void place_ball(random_source *source, impact *it)
{
    const oracle_polygon *p = &it->rock.exact;
    int i = (int)random_below(source, (uint32_t)p->count), next = (i + 1) % p->count;
    exact share = (exact)random_within(source, 0, 1), out = exact_real(it->radius) - (exact)random_within(source, 64, 4096);
    exact2 along = exact_sub(p->vertices[next], p->vertices[i]), normal = p->normals[i];
    double x = (double)(p->vertices[i].x + along.x * share + normal.x * out);
    double y = (double)(p->vertices[i].y + along.y * share + normal.y * out);
    it->position = (tuff_vec2){ it->at.x + twin_real(x), it->at.y + twin_real(y) };
}

/* Velocities on the grid of the fixed build; 2 units a step is the fastest that Box2D goes. */
static void make_impact(random_source *source, impact *it)
{
    twin_make(source, &it->rock, random_magnitude(source, 2, 30));
    it->at = family_position(source);
    it->radius = twin_real(EXACT_UNIT * random_magnitude(source, 0.5, 16));
    it->restitution = tuff_from_q22_10(random_between(source, 0, 1024));
    place_ball(source, it);
    it->velocity.x = TUFF_REAL_RAW(random_between(source, -80000, 80000));
    it->velocity.y = TUFF_REAL_RAW(random_between(source, -80000, 80000));
}

static tuff_vec2 tuff_bounced(const impact *it, const tuff_contact *contact)
{
    tuff_material material = { it->restitution, 0 };
    tuff_body body = { it->position, it->velocity, &material };
    tuff_bounce(&body, contact);
    return body.velocity;
}

/* In units a step. */
static exact2 box_bounced(const impact *it)
{
    box2d_world *world = box2d_world_new();
    box2d_vec velocity = twin_vec(it->velocity), position = twin_vec(it->position);
    velocity = (box2d_vec){ velocity.x * STEPS_A_SECOND, velocity.y * STEPS_A_SECOND };
    box2d_world_add_rock(world, it->rock.box, twin_vec(it->at));
    int ball = box2d_world_add_ball(world, position, velocity, tuff_to_float(it->radius), tuff_to_float(it->restitution));
    box2d_world_step(world, 1.0f / STEPS_A_SECOND);
    box2d_world_ball(world, ball, &position, &velocity);
    box2d_world_free(world);
    exact scale = (exact)EXACT_UNIT / STEPS_A_SECOND;
    return (exact2){ (exact)velocity.x * scale, (exact)velocity.y * scale };
}

/* The least axis; the next best must be clearly worse, or two right answers would be compared. */
static bool only_axis(const oracle_answer *answer, exact2 *normal)
{
    int found = 0;
    for (int i = 0; i < answer->count; i++) {
        if (answer->axes[i].depth > answer->depth + 66) continue;
        *normal = answer->axes[i].normal;
        found++;
    }
    return found == 1;
}

static exact2 exact_bounced(const impact *it, exact2 normal)
{
    exact2 v = exact_vec2(it->velocity);
    exact inwards = exact_dot(v, normal);
    if (inwards >= 0) return v;
    exact change = -(1 + exact_real(it->restitution) / EXACT_UNIT) * inwards;
    return (exact2){ v.x + normal.x * change, v.y + normal.y * change };
}

static double larger_part(exact2 v)
{
    exact x = exact_abs(v.x), y = exact_abs(v.y);
    return (double)(x > y ? x : y);
}

/* Units a second. Within a hundredth of 0, in or out is a matter of rounding. */
static double outwards_of(const impact *it, exact2 normal)
{
    return (double)exact_dot(exact_vec2(it->velocity), normal) * STEPS_A_SECOND / EXACT_UNIT;
}

/* Moving out, nothing may change at all. Fixed build: rounding toward zero, and the normal's own. */
static double error_allowed(const impact *it, exact2 normal)
{
    if (outwards_of(it, normal) > 0) return 0;
    return EXACT_WHOLE ? 1.25 : (double)exact_length(exact_vec2(it->velocity)) * 1e-6;
}

static const char *judge(tally *sum, const impact *it, exact2 normal, tuff_vec2 ours)
{
    exact2 truth = exact_bounced(it, normal), tuff = exact_vec2(ours), box = box_bounced(it);
    double our_error = larger_part(exact_sub(tuff, truth)), box_error = larger_part(exact_sub(box, truth));
    double apart = larger_part(exact_sub(tuff, box));
    sum->bounces += outwards_of(it, normal) < 0;
    sum->outwards += outwards_of(it, normal) > 0;
    raise_to(&sum->tuff, (exact)our_error);
    raise_to(&sum->box, (exact)box_error);
    raise_to(&sum->apart, (exact)apart);
    if (our_error > error_allowed(it, normal)) return "velocity after the bounce";
    return apart > 2 + (double)exact_length(tuff) * 1e-5 ? "velocity differs from Box2D's" : NULL;
}

static void bounce_case(tally *sum, const random_run *run, uint32_t index)
{
    random_source source = random_stream(run->seed, index);
    impact it;
    oracle_answer answer;
    tuff_contact contact;
    exact2 normal = { 0, 0 };
    make_impact(&source, &it);
    tuff_terrain piece = { it.at, 0, it.rock.shape.bounding_radius, &it.rock.shape.polygon, 1 };
    bool found = tuff_terrain_overlap_circle(&piece, it.position, it.radius, &contact);
    oracle_circle(&it.rock.exact, exact_sub(exact_vec2(it.position), exact_vec2(it.at)), exact_real(it.radius), &answer);
    const char *fault = NULL;
    if (found && only_axis(&answer, &normal) && fabs(outwards_of(&it, normal)) > 0.01) {
        fault = judge(sum, &it, normal, tuff_bounced(&it, &contact));
    }
    twin_free(&it.rock);
    random_count_fault(&sum->faults, run, index, fault);
}

static void speed_after_a_bounce_as_in_box2d(void **state)
{
    random_run run = random_cases(__func__, 601, 30000);
    tally sum = { 0 };
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) bounce_case(&sum, &run, i);
    printf("figures: bounce: %lu bounces and %lu moving out; largest error of a velocity: tuff %s %.3g units a step, Box2D %.3g; largest "
           "difference %.3g\n", sum.bounces, sum.outwards, EXACT_BUILD, sum.tuff / EXACT_UNIT, sum.box / EXACT_UNIT,
           sum.apart / EXACT_UNIT);
    assert_int_equal(sum.faults, 0);
    if (run.end - run.first >= 1000) assert_true(sum.bounces >= (run.end - run.first) / 4);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(speed_after_a_bounce_as_in_box2d),
    };
    (void)argc;
    random_begin(argv);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
