/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The golden replay: the demo's belt (hull, enemies, shots, beams, floaters, rocks that leave the index and come back) flown by its
   autopilot for 3,600 steps, and the hash of every body and answer. */
#include <stdio.h>

#include "scene.h"
#include "trace.h"

#define STEPS 3600
#define SEED  1

#if TUFF_SCALAR == TUFF_Q16_16
#define BUILD "q16"
#else
#define BUILD "float"
#endif

static scene belt;
static uint32_t ship, enemies[SCENE_ENEMIES], floaters[SCENE_FLOATERS], shots[SCENE_SHOTS];    /* their histories */

static void trace(uint32_t hash)
{
    unsigned i;
    trace_body(&ship, &belt.ship);
    trace_text(" ");
    for (i = 0; i < SCENE_ENEMIES; i++) trace_body(&enemies[i], &belt.enemies[i].body);
    trace_text(" ");
    for (i = 0; i < SCENE_FLOATERS; i++) trace_body(&floaters[i], &belt.floater_bodies[i]);
    trace_text(" ");
    for (i = 0; i < SCENE_SHOTS; i++) trace_body(&shots[i], &belt.shots[i].body);
    trace_text(" ");
    trace_hash(hash);
    trace_text("\n");
}

int main(void)
{
    uint32_t hash = 0;
    uint16_t step;
    scene_init(&belt, SEED);
    trace_text("ship enemy floater shot answer\n");
    for (step = 0; step < STEPS; step++) {
        scene_step(&belt, scene_pilot(&belt));
        hash = scene_hash(&belt, hash);
        trace(hash);
    }
    printf("replay " BUILD " %08lX\n", (unsigned long)hash);
    return 0;
}
