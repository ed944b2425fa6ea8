/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Usage, under callgrind: tuff-gate. Leaves a dump `function,build count` for each public function of the frame and each build. */
#include "gate.h"

#include "sets.h"

static const char *const names[GATE_FUNCTIONS] = {
    "circle_circle", "circle_polygon", "polygon_polygon", "segment_circle", "segment_polygon", "terrain_overlap_circle",
    "terrain_overlap_hull", "bounce", "terrain_collide_circle", "terrain_collide", "terrain_collide_bare_hull",
    "floater_collide_circle", "floater_collide", "segment_terrain_intersect", "segment_terrain_first_hit", "nearby_terrain", "chunks_move",
};

static const gate_side *const sides[] = { &tuff_float_gate_side, &tuff_q16_gate_side };

static void count_side(const gate_side *side, uint16_t *order)
{
    for (int i = 0; i < GATE_FUNCTIONS; i++) {
        bench_trial trial = { "", side->run, i, side->reset, 0.0 };
        snprintf(trial.key, sizeof trial.key, "%s,%s", names[i], side->build);
        bench_measure(&trial, 1, order, BENCH_TIMED_PAIRS, names[i]);
    }
}

int main(void)
{
    static bench_set sets[BENCH_KINDS];
    static bench_crowd crowd;
    uint16_t order[BENCH_TIMED_PAIRS];
    for (uint16_t i = 0; i < BENCH_TIMED_PAIRS; i++) order[i] = i;
    for (int kind = 0; kind < BENCH_KINDS; kind++) bench_make_set(&sets[kind], (bench_kind)kind, 3, 8, BENCH_TIMED_PAIRS);
    bench_make_crowd(&crowd, GATE_PIECES, 1.0, 256.0, true);
    bench_begin(true, 2 * GATE_FUNCTIONS);
    for (int side = 0; side < 2; side++) {
        sides[side]->prepare(sets, &crowd);
        count_side(sides[side], order);
    }
    return 0;
}
