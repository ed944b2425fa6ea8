/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What a call costs as the world grows, as it fills and as beams get longer. Columns: what,pieces,density,length,build. entity and
   circle: a hull's and a circle's collide call within 512 units of the origin, as on one screen; scattered: the hull's all over the
   world, where every call finds its pieces outside the cache; beam; index: moving a piece in the index, and the bytes the index has. */
#include "sets.h"

static const bench_scale_method *const methods[] = { &tuff_float_bench_scale, &tuff_q16_bench_scale };
#define METHODS (int)(sizeof methods / sizeof *methods)

typedef struct question {
    const char *what;
    bench_scale_kind kind;
    double density, length;
    bool near;
} question;

static bench_crowd crowd;

static void measure(const question *q)
{
    bench_trial trials[METHODS];
    uint16_t order[BENCH_CALLS];
    uint32_t count = q->kind == BENCH_INSERT && crowd.piece_count < BENCH_CALLS ? crowd.piece_count : BENCH_CALLS;
    char progress[48];
    snprintf(progress, sizeof progress, "%s %lu pieces", q->what, (unsigned long)crowd.piece_count);
    for (uint16_t i = 0; i < count; i++) order[i] = i;
    for (int i = 0; i < METHODS; i++) {
        trials[i] = (bench_trial){ "", methods[i]->run, (int)q->kind, methods[i]->reset, 0.0 };
        snprintf(trials[i].key, sizeof trials[i].key, "%s,%lu,%g,%g,%s", q->what, (unsigned long)crowd.piece_count, q->density, q->length,
                 methods[i]->build);
    }
    bench_measure(trials, METHODS, order, count, progress);
    for (int i = 0; i < METHODS && !bench_counts(); i++) {
        printf("%s %.1f %lu\n", trials[i].key, trials[i].ns, (unsigned long)methods[i]->bytes());
    }
}

static void prepare(uint32_t pieces, const question *q)
{
    bench_make_crowd(&crowd, pieces, q->density, q->length, q->near);
    for (int i = 0; i < METHODS; i++) methods[i]->prepare(&crowd);
}

static void measure_size(uint32_t pieces)
{
    static const question here[] = { { "entity", BENCH_ENTITY_HULL, 1.0, 0.0, true },
                                     { "circle", BENCH_ENTITY_CIRCLE, 1.0, 0.0, true },
                                     { "index", BENCH_INSERT, 1.0, 0.0, true } };
    static const question all_over = { "scattered", BENCH_ENTITY_HULL, 1.0, 0.0, false };
    prepare(pieces, &here[0]);
    for (int i = 0; i < 3; i++) measure(&here[i]);
    prepare(pieces, &all_over);
    measure(&all_over);
}

static void measure_density(double density)
{
    const question here[] = { { "entity", BENCH_ENTITY_HULL, density, 0.0, true }, { "circle", BENCH_ENTITY_CIRCLE, density, 0.0, true } };
    prepare(4096, &here[0]);
    for (int i = 0; i < 2; i++) measure(&here[i]);
}

static void measure_beams(double density)
{
    for (double length = 16.0; length <= 4096.0; length *= 4.0) {
        const question here = { "beam", BENCH_BEAM, density, length, true };
        prepare(16384, &here);
        measure(&here);
    }
}

void bench_scale(void)
{
    static const uint32_t sizes[] = { 64, 256, 1024, 4096, 16384, BENCH_MAX_PIECES };
    static const double densities[] = { 0.25, 1.0, 4.0 };
    for (unsigned i = 0; i < sizeof sizes / sizeof *sizes; i++) measure_size(sizes[i]);
    measure_density(0.25);
    measure_density(4.0);
    for (unsigned i = 0; i < 3; i++) measure_beams(densities[i]);
}
