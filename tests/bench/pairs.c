/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Pairs measured and judged: a row for each method, number of vertices and class. */
#include "bench.h"
#include "random.h"

#include <string.h>

#define BAND 1e-4                   /* units; nearer to touching, yes and no are both right */

static const bench_method *const methods[] = {
    &tuff_float_bench_tuff, &tuff_q16_bench_tuff, &tuff_float_bench_textbook, &tuff_q16_bench_textbook, &bench_box2d, &bench_chipmunk,
};
#define METHODS (int)(sizeof methods / sizeof *methods)

static const char *const kind_names[] = { "circle", "hull", "segment" };
static const char *const class_names[] = { "overlap", "near", "far", "all" };

typedef struct verdict {
    unsigned long wrong, overlaps;
    double depth_max, squares;
} verdict;

static bool of_class(uint32_t pair, int class)
{
    return class == BENCH_ALL || (int)(pair % BENCH_CLASSES) == class;
}

static void judge_pair(verdict *sum, const bench_set *set, const bench_method *method, uint32_t pair)
{
    bench_answer answer;
    double depth = set->pairs[pair].depth;
    method->answer(set->kind, pair, &answer);
    if (answer.hit != (depth > 0.0) && fabs(depth) > BAND) sum->wrong++;
    if (!answer.hit || depth <= 0.0 || set->kind == BENCH_SEGMENT) return;
    double error = fabs(answer.depth - depth);
    sum->overlaps++;
    sum->squares += error * error;
    if (error > sum->depth_max) sum->depth_max = error;
}

/* The columns behind ns and instructions: wrong,depth_max,depth_rms,bytes. No depth where nothing overlaps. */
static void print_verdict(const bench_set *set, const bench_method *method, int class)
{
    verdict sum = { 0, 0, 0.0, 0.0 };
    double bytes = 0.0;
    for (uint32_t i = 0; i < set->count; i++) {
        if (of_class(i, class)) judge_pair(&sum, set, method, i);
    }
    for (int i = 0; i < BENCH_SHAPES; i++) bytes += method->bytes(set->shapes[i].count) / BENCH_SHAPES;
    printf("%lu,", sum.wrong);
    if (sum.overlaps) printf("%.3g,%.3g", sum.depth_max, sqrt(sum.squares / (double)sum.overlaps));
    else printf(",");
    printf(",%.0f\n", bytes);
}

static void name_vertices(char *name, size_t size, const bench_set *set)
{
    if (set->least == set->most) snprintf(name, size, "%d", set->least);
    else snprintf(name, size, "%d-%d", set->least, set->most);
}

static void measure_class(const bench_set *set, const bench_method *const *able, int able_count, int class)
{
    bench_trial trials[METHODS];
    uint16_t order[BENCH_TIMED_PAIRS];
    uint32_t count = 0;
    char vertices[16], progress[64];
    name_vertices(vertices, sizeof vertices, set);
    snprintf(progress, sizeof progress, "%s %s %s", kind_names[set->kind], vertices, class_names[class]);
    for (uint16_t i = 0; i < BENCH_TIMED_PAIRS; i++) {
        if (of_class(i, class)) order[count++] = i;
    }
    for (int i = 0; i < able_count; i++) {
        trials[i] = (bench_trial){ "", able[i]->run, (int)set->kind, NULL, 0.0 };
        snprintf(trials[i].key, sizeof trials[i].key, "%s,%s,%s,%s,%s", kind_names[set->kind], vertices, class_names[class], able[i]->name,
                 able[i]->build);
    }
    bench_measure(trials, able_count, order, count, progress);
    for (int i = 0; i < able_count && !bench_counts(); i++) {
        printf("%s %.2f ", trials[i].key, trials[i].ns);
        print_verdict(set, able[i], class);
    }
}

static void measure_set(bench_kind kind, int least, int most)
{
    static bench_set set;
    const bench_method *able[METHODS];
    int able_count = 0;
    bench_make_set(&set, kind, least, most, bench_counts() ? BENCH_TIMED_PAIRS : BENCH_PAIRS);
    for (int i = 0; i < METHODS; i++) {
        if (methods[i]->max_vertices < most) continue;
        methods[i]->prepare(&set);
        able[able_count++] = methods[i];
    }
    for (int class = 0; class <= BENCH_ALL; class++) measure_class(&set, able, able_count, class);
}

void bench_pairs(bench_kind kind)
{
    measure_set(kind, 3, 8);
    measure_set(kind, 9, 16);
    for (int count = 3; count <= BENCH_MAX_VERTICES; count++) measure_set(kind, count, count);
}
