/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The pairs as tables. */
#include "sets.h"

#include "count.h"
#include "pairs_data.h"

const uint8_t sets_cases = sizeof cases / sizeof *cases;
const uint16_t sets_pairs = PAIRS;

bench_kind sets_read_case(uint8_t number, char name[SETS_NAME])
{
    uint8_t kind;
    table_read(name, cases[number].name, SETS_NAME);
    table_read(&kind, &cases[number].kind, sizeof kind);
    return (bench_kind)kind;
}

void sets_read_pair(uint8_t number, uint16_t pair, sets_pair *out)
{
    table_read(out, &cases[number].pairs[pair], sizeof *out);
}

void sets_read_shapes(const sets_pair *pair, bench_shape *polygon, bench_shape *hull)
{
    table_read(polygon, &shapes[pair->shapes.polygon], sizeof *polygon);
    table_read(hull, &hulls[pair->shapes.hull], sizeof *hull);
}
