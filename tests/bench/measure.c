/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Time and instructions. Times: each pass shuffles the items, or a branch predictor would learn them by heart, and begins with another
   trial, so that whatever the machine does besides meets all alike; the median of the passes counts. Instructions: callgrind
   counts what lies between the client requests, after a first run that has bound the shared libraries' symbols. */
#include "bench.h"
#include "random.h"

#include <time.h>
#include <unistd.h>

#include <valgrind/callgrind.h>

#define PASSES      300
#define MAX_TRIALS  8

static bool counting;
static unsigned steps_done, steps_due;
static volatile uint32_t hits;      /* keeps the runs' results alive */

void bench_begin(bool count, unsigned steps)
{
    counting = count;
    steps_done = 0;
    steps_due = steps;
}

bool bench_counts(void)
{
    return counting;
}

static void show_progress(const char *what)
{
    unsigned percent = ++steps_done * 100 / steps_due;
    if (!isatty(STDERR_FILENO)) return;
    fprintf(stderr, "\r  %s %-28s %3u %%%s", counting ? "counting" : "timing  ", what, percent > 100 ? 100 : percent,
            steps_done >= steps_due ? "\n" : "");
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

static void shuffle(random_source *source, uint16_t *order, uint32_t count)
{
    for (uint32_t i = count; i > 1; i--) {
        uint32_t j = random_below(source, i);
        uint16_t kept = order[i - 1];
        order[i - 1] = order[j];
        order[j] = kept;
    }
}

static double time_once(const bench_trial *trial, const uint16_t *order, uint32_t count)
{
    if (trial->reset) trial->reset();
    double start = now();
    hits = trial->run(trial->what, order, count);
    return (now() - start) / count;
}

static void count_trial(const bench_trial *trial, const uint16_t *order, uint32_t count)
{
    char label[96];
    snprintf(label, sizeof label, "%s %lu", trial->key, (unsigned long)count);
    time_once(trial, order, count);
    if (trial->reset) trial->reset();
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
    hits = trial->run(trial->what, order, count);
    CALLGRIND_DUMP_STATS_AT(label);
    CALLGRIND_STOP_INSTRUMENTATION;
}

static int compare_doubles(const void *left, const void *right)
{
    double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

static void time_trials(bench_trial *trials, int trial_count, uint16_t *order, uint32_t count)
{
    static double times[MAX_TRIALS][PASSES];
    random_source source = random_stream(count, 0);
    for (int pass = 0; pass < PASSES; pass++) {
        shuffle(&source, order, count);
        for (int i = 0; i < trial_count; i++) {
            int turn = (i + pass) % trial_count;
            times[turn][pass] = time_once(&trials[turn], order, count);
        }
    }
    for (int i = 0; i < trial_count; i++) {
        qsort(times[i], PASSES, sizeof times[i][0], compare_doubles);
        trials[i].ns = times[i][PASSES / 2];
    }
}

void bench_measure(bench_trial *trials, int trial_count, uint16_t *order, uint32_t count, const char *progress)
{
    if (counting) {
        for (int i = 0; i < trial_count; i++) count_trial(&trials[i], order, count);
    } else {
        time_trials(trials, trial_count, order, count);
    }
    show_progress(progress);
}
