/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Whole frames of the scene: a row for each method. */
#include "sets.h"

static const bench_scene_method *const methods[] = {
    &tuff_float_bench_scene, &tuff_q16_bench_scene, &tuff_float_bench_textbook_scene, &tuff_q16_bench_textbook_scene, &bench_box2d_scene,
    &bench_chipmunk_scene, &tuff_float_bench_linear_scene, &tuff_q16_bench_linear_scene,
};
#define METHODS (int)(sizeof methods / sizeof *methods)

void bench_scenes(void)
{
    static bench_scene scene;
    bench_trial trials[METHODS];
    uint16_t order[BENCH_FRAMES];
    bench_make_scene(&scene);
    for (uint16_t i = 0; i < BENCH_FRAMES; i++) order[i] = i;
    for (int i = 0; i < METHODS; i++) {
        methods[i]->prepare(&scene);
        trials[i] = (bench_trial){ "", methods[i]->run, methods[i]->what, NULL, 0.0 };
        snprintf(trials[i].key, sizeof trials[i].key, "%s,%s,%s", methods[i]->scene, methods[i]->name, methods[i]->build);
    }
    bench_measure(trials, METHODS, order, BENCH_FRAMES, "frames");
    for (int i = 0; i < METHODS && !bench_counts(); i++) {
        printf("%s %.0f %lu\n", trials[i].key, trials[i].ns, (unsigned long)methods[i]->bytes());
    }
}
