/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Counts tuff_bounce: bodies that move inwards, at the contacts of the circles that hit. Prints `case,bounce,,inwards` before
   the counts. */
#include <stdio.h>

#include "calls.h"
#include "sets.h"

#define SPEED 16                    /* the body was at the polygon's center so many steps ago, if it flew straight */

/* The case's circles are pushed out and bounce. */
static void run_case(uint8_t number)
{
    static tuff_vec2 corners[BENCH_MAX_VERTICES];
    static tuff_unit2 outward[BENCH_MAX_VERTICES];
    for (uint16_t i = 0; i < sets_pairs; i++) {
        adapt_pool pool = { corners, outward, 0 };
        sets_pair pair;
        bench_shape shape, hull;
        tuff_contact contact;
        sets_read_pair(number, i, &pair);
        sets_read_shapes(&pair, &shape, &hull);
        tuff_polygon polygon = adapt_polygon(&pool, &shape);
        bench_point inwards = { -pair.a.x / SPEED, -pair.a.y / SPEED };
        tuff_body body = adapt_body((bench_body){ pair.a, inwards });
        if (tuff_circle_polygon(body.position, tuff_from_q16_16(pair.radius), &polygon, &contact)) count_bounce(&body, &contact);
    }
}

int main(void)
{
    puts("case,bounce,,inwards");
    fflush(stdout);
    for (uint8_t i = 0; i < sets_cases; i++) {
        char name[SETS_NAME];
        if (sets_read_case(i, name) == BENCH_CIRCLE) run_case(i);
    }
    return 0;
}
