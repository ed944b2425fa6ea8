/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The judge of contacts, and its bounds for both builds. */
#include "accuracy.h"

#if TUFF_SCALAR == TUFF_Q16_16

#define ERROR_UNIT 1
#define ERROR_NAME "LSB"

accuracy_bounds accuracy_bounds_of(double size)
{
    (void)size;
    return (accuracy_bounds){ 1, 1, 2, (exact)1e-6 };
}

static exact last_digit(tuff_vec2 position)
{
    (void)position;
    return 0;
}

#else

#define ERROR_UNIT EXACT_UNIT
#define ERROR_NAME "units"

/* Beyond 64 units only yes and no are promised; the depth is then held to the same band. */
accuracy_bounds accuracy_bounds_of(double size)
{
    exact unit = EXACT_UNIT;
    if (size <= 64) return (accuracy_bounds){ unit / 10000, unit / 20000, unit / 10000, (exact)1e-6 };
    return (accuracy_bounds){ unit / 1000, unit / 1000, unit / 500, (exact)1e-6 };
}

/* Of the larger coordinate, in steps. */
static exact last_digit(tuff_vec2 position)
{
    float x = fabsf(position.x), y = fabsf(position.y), most = x > y ? x : y;
    return (exact)(nextafterf(most, 1e9f) - most) * EXACT_UNIT;
}

#endif

const tuff_contact accuracy_untouched = { TUFF_REAL_RAW(-77), { TUFF_UNIT_RAW(5), TUFF_UNIT_RAW(-5) } };

exact accuracy_float_beam_band(exact length)
{
    exact least = (exact)EXACT_UNIT / 1000, share = length / 4194304;
    return share > least ? share : least;
}

static const char *judge_contact(accuracy *sum, const accuracy_bounds *bounds, const oracle_answer *answer, const tuff_contact *contact)
{
    exact depth = exact_abs(exact_real(contact->overlap) - answer->depth);
    exact normal = oracle_normal_error(answer, bounds->depth, exact_unit2(contact->normal));
    exact length = exact_abs(exact_length(exact_unit2(contact->normal)) - 1);
    raise_to(&sum->depth, depth);
    raise_to(&sum->normal, normal);
    if (contact->overlap <= 0) return "overlap not above zero";
    if (depth > bounds->depth) return "depth";
    if (normal > bounds->normal) return "normal";
    return length > bounds->normal ? "normal is no unit vector" : NULL;
}

const char *accuracy_judge(accuracy *sum, const accuracy_bounds *bounds, const oracle_answer *answer, exact margin, bool found,
                           const tuff_contact *contact)
{
    sum->pairs++;
    if (found == (answer->depth <= 0) && margin > bounds->band) {
        sum->wrong++;
        return found ? "overlap reported of shapes that are apart" : "overlap missed";
    }
    if (!found) return same_overlap(contact, &accuracy_untouched) ? NULL : "contact touched though there is no overlap";
    sum->overlaps++;
    return judge_contact(sum, bounds, answer, contact);
}

tuff_vec2 accuracy_pushed(tuff_vec2 position, const tuff_contact *contact)
{
    tuff_body body = { position, { 0, 0 }, NULL };
    tuff_bounce(&body, contact);
    return body.position;
}

const char *accuracy_judge_push(accuracy *sum, const accuracy_bounds *bounds, exact depth, tuff_vec2 position)
{
    exact left_over = exact_abs(depth) - last_digit(position);
    raise_to(&sum->left_over, left_over);
    return left_over > bounds->left_over ? "left over after the push, or pushed too far" : NULL;
}

void accuracy_report_fault(accuracy *sum, const random_run *run, uint32_t index, const char *fault, const oracle_answer *answer, bool found,
                           const tuff_contact *contact)
{
    if (!random_count_fault(&sum->faults, run, index, fault)) return;
    print_error("exact depth %.4f steps; found %d, overlap %.4f steps, normal (%.9f, %.9f)\n", (double)answer->depth, found,
                (double)exact_real(contact->overlap), (double)exact_unit(contact->normal.x), (double)exact_unit(contact->normal.y));
}

void accuracy_print(const accuracy *sum, const char *what)
{
    printf("figures: %s: tuff %s against the oracle: %lu pairs, %lu overlaps, %lu wrong; largest errors: depth %.3g %s, "
           "normal %.2g rad, left over %.3g %s\n", what, EXACT_BUILD, sum->pairs, sum->overlaps, sum->wrong, sum->depth / ERROR_UNIT,
           ERROR_NAME, sum->normal, sum->left_over / ERROR_UNIT, ERROR_NAME);
}

void accuracy_run(const char *name, const char *what, uint64_t seed, uint32_t count, accuracy_case *one, double largest)
{
    random_run run = random_cases(name, seed, count);
    accuracy sum = { 0 };
    for (uint32_t i = run.first; i < run.end; i++) one(&sum, &run, i, largest);
    accuracy_print(&sum, what);
    assert_int_equal(sum.faults, 0);
}
