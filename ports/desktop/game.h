/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Both builds' scenes run side by side, timed and compared. */
#ifndef DEMO_GAME_H
#define DEMO_GAME_H

#include <stdbool.h>

#include "options.h"
#include "side.h"

enum { SIDE_FLOAT, SIDE_Q16, SIDES };

typedef struct game {
    const side *sides[SIDES];
    double   microseconds[SIDES];   /* a step of the scene, lately */
    double   total[SIDES];          /* all steps, microseconds */
    uint32_t hashes[SIDES];
    uint32_t frame;
    int      shown;                 /* which side */
    bool     split, autopilot, paused;
    uint8_t  show;
} game;

extern const char *const side_names[SIDES];

/* Starts both belts; a fault in one is printed and ends the program. */
void game_start(game *g, const options *o);

/* One step of each side by its own buttons. */
void game_step(game *g, uint16_t float_buttons, uint16_t q16_buttons);

/* One step of both from the same input: the shown side's autopilot if it is on, else buttons. */
void game_step_together(game *g, uint16_t buttons);

/* Ends the program with the fault's text if tuff's checks find one. */
void game_check(const game *g);

/* How far the two ships are from each other, in units. */
double game_drift(const game *g);

/* Microseconds, from a clock that only goes forward. */
double clock_now(void);

#endif
