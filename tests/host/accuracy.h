/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The accuracy that the library is held to, as numbers, and the judge that compares a contact with the oracle's answer. */
#ifndef TUFF_TESTS_ACCURACY_H
#define TUFF_TESTS_ACCURACY_H

#include "oracle.h"
#include "random.h"
#include "same.h"

typedef struct accuracy_bounds {    /* in steps of 1/65536 unit, the normal in radians */
    exact band;                     /* within it of touching, yes and no are both right */
    exact depth, left_over, normal;
} accuracy_bounds;

/* For shapes and radii up to this many units. */
accuracy_bounds accuracy_bounds_of(double size);

/* Float build: within so many steps of touching, a beam of this length may be answered either way. */
exact accuracy_float_beam_band(exact length);

typedef struct accuracy {           /* the figures of a run */
    unsigned long pairs, overlaps, wrong, faults;
    double depth, normal, left_over; /* the largest errors */
} accuracy;

/* The contact before each call: whoever does not overlap must leave it so. */
extern const tuff_contact accuracy_untouched;

/* Counts the pair. margin: how far the shapes are from touching. NULL: the answer is right; otherwise what is wrong with it. */
const char *accuracy_judge(accuracy *sum, const accuracy_bounds *bounds, const oracle_answer *answer, exact margin, bool found,
                           const tuff_contact *contact);

/* Where the push that the contact asks for ends. */
tuff_vec2 accuracy_pushed(tuff_vec2 position, const tuff_contact *contact);

/* The depth that is left after a push to this position, or below 0 the gap; the position's own last digit is not counted. */
const char *accuracy_judge_push(accuracy *sum, const accuracy_bounds *bounds, exact depth, tuff_vec2 position);

/* Adds a fault if there is one (fault not NULL): prints the first three with the command that repeats them. */
void accuracy_report_fault(accuracy *sum, const random_run *run, uint32_t index, const char *fault, const oracle_answer *answer, bool found,
                           const tuff_contact *contact);

/* One line of figures; the errors in steps in the fixed build, in units in the float build. */
void accuracy_print(const accuracy *sum, const char *what);

/* One case of a test, with shapes and radii up to this many units. */
typedef void accuracy_case(accuracy *sum, const random_run *run, uint32_t index, double largest);

/* A whole test: runs all cases, prints the figures, and asserts that there was no fault. */
void accuracy_run(const char *name, const char *what, uint64_t seed, uint32_t count, accuracy_case *one, double largest);

#endif
