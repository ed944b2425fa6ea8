/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Steps the two scenes, takes the time, keeps the replay hashes. */
#include "game.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

const char *const side_names[SIDES] = {"float", "Q16.16"};

double clock_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec * 1e6 + (double)now.tv_nsec * 1e-3;
}

void game_check(const game *g)
{
    for (int i = 0; i < SIDES; i++) {
        uint16_t number;
        const char *fault = g->sides[i]->fault(&number);
        if (fault == NULL) continue;
        fprintf(stderr, "tuff-demo: %s build, frame %lu, number %u: %s\n", side_names[i], (unsigned long)g->frame, number, fault);
        exit(1);
    }
}

void game_start(game *g, const options *o)
{
    memset(g, 0, sizeof *g);
    g->sides[SIDE_FLOAT] = &tuff_float_side;
    g->sides[SIDE_Q16] = &tuff_q16_side;
    g->shown = o->build;
    g->split = o->split;
    g->autopilot = o->autopilot;
    g->show = o->show;
    for (int i = 0; i < SIDES; i++) g->sides[i]->start(o->seed);
    game_check(g);
}

static void step_side(game *g, int i, uint16_t buttons)
{
    double before = clock_now();
    g->sides[i]->step(buttons);
    double taken = clock_now() - before;
    g->total[i] += taken;
    g->microseconds[i] += (taken - g->microseconds[i]) / (g->frame < 16 ? 1.0 + (double)g->frame : 16.0);
    g->hashes[i] = g->sides[i]->hash(g->hashes[i]);
}

void game_step(game *g, uint16_t float_buttons, uint16_t q16_buttons)
{
    step_side(g, SIDE_FLOAT, float_buttons);
    step_side(g, SIDE_Q16, q16_buttons);
    g->frame++;
}

void game_step_together(game *g, uint16_t buttons)
{
    if (g->autopilot) buttons = g->sides[g->shown]->pilot();
    game_step(g, buttons, buttons);
}

double game_drift(const game *g)
{
    int32_t a[2], b[2];
    g->sides[SIDE_FLOAT]->ship(a);
    g->sides[SIDE_Q16]->ship(b);
    double dx = ((double)a[0] - (double)b[0]) / 65536.0, dy = ((double)a[1] - (double)b[1]) / 65536.0;
    return sqrt(dx * dx + dy * dy);
}
