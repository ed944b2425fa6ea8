/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Counts one call on each pair of each case. Prints `case,KIND,VERTICES,CLASS` before the counts of a case, and after each count
   `hit` or `miss`. Without printf, which is too large for an AVR. */
#include <stdio.h>

#include "method.h"

typedef struct shapes { bench_shape polygon, hull; } shapes;

static void read_pair(uint8_t number, uint16_t i, sets_pair *pair, shapes *both)
{
    sets_read_pair(number, i, pair);
    sets_read_shapes(pair, &both->polygon, &both->hull);
}

static bool is_able(uint8_t number)
{
    sets_pair pair;
    shapes both;
    read_pair(number, 0, &pair, &both);
    return both.polygon.count <= method_max_vertices;
}

static void run_case(uint8_t number)
{
    char name[SETS_NAME];
    bench_kind kind = sets_read_case(number, name);
    fputs("case,", stdout);
    puts(name);
    fflush(stdout);
    for (uint16_t i = 0; i < sets_pairs; i++) {
        sets_pair pair;
        shapes both;
        read_pair(number, i, &pair, &both);
        method_load(&both.polygon, &both.hull);
        puts(method_count(kind, &pair) ? "hit" : "miss");
        fflush(stdout);
    }
}

int main(void)
{
    for (uint8_t i = 0; i < sets_cases; i++) {
        if (is_able(i)) run_case(i);
    }
    return 0;
}
