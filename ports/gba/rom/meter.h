/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A clock that counts the processor's cycles, and the meter of those that the scene spends in calls of tuff. */
#ifndef GBA_METER_H
#define GBA_METER_H

#include "hardware.h"

/* Cycles spent in the library since the one who reads it set it to 0. meter.s adds to it. */
extern uint32_t meter_cycles;

/* The low half of the clock is timer 0, whose overflows timer 1 counts. meter.s reads timer 0 too, and timer 2, which takes 1024 cycles
   a count. */
static inline void clock_start(void)
{
    TIMER_1_MODE = TIMER_ON | TIMER_CASCADE;
    TIMER_2_MODE = TIMER_ON | TIMER_BY_1024;
    TIMER_0_MODE = TIMER_ON;
}

static inline uint32_t clock_now(void)
{
    uint32_t high, low;
    do {
        high = TIMER_1;
        low = TIMER_0;
    } while (high != TIMER_1);
    return high << 16 | low;
}

#endif
