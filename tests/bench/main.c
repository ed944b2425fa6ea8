/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Usage: tuff-bench time|count circle|hull|segment|scenes|scale. time prints lines `key ns other-columns`; count, under callgrind, leaves
   a dump for each key. scripts/run-bench joins them to the CSV files. */
#include "bench.h"

#include <stdio.h>
#include <string.h>

static void run_circles(void)  { bench_pairs(BENCH_CIRCLE); }
static void run_hulls(void)    { bench_pairs(BENCH_HULL); }
static void run_segments(void) { bench_pairs(BENCH_SEGMENT); }

static const struct { const char *name; void (*run)(void); unsigned steps; } parts[] = {
    { "circle", run_circles, BENCH_PAIR_STEPS },
    { "hull", run_hulls, BENCH_PAIR_STEPS },
    { "segment", run_segments, BENCH_PAIR_STEPS },
    { "scenes", bench_scenes, BENCH_SCENE_STEPS },
    { "scale", bench_scale, BENCH_SCALE_STEPS },
};

int main(int argc, char **argv)
{
    bool count = argc == 3 && !strcmp(argv[1], "count");
    if (argc == 3 && (count || !strcmp(argv[1], "time"))) {
        for (unsigned i = 0; i < sizeof parts / sizeof *parts; i++) {
            if (strcmp(argv[2], parts[i].name)) continue;
            bench_begin(count, parts[i].steps);
            parts[i].run();
            return 0;
        }
    }
    fprintf(stderr, "usage: tuff-bench time|count circle|hull|segment|scenes|scale\n");
    return 2;
}
