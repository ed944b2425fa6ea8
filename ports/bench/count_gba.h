/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Game Boy Advance: cycles by its timers 0 and 1 in cascade. The instruction that stops them is counted, too. */
#ifndef TUFF_PORTS_COUNT_GBA_H
#define TUFF_PORTS_COUNT_GBA_H

#include <stdint.h>

#define TIMER_LOW     (*(volatile uint16_t *)0x04000100)
#define TIMER_LOW_ON  (*(volatile uint16_t *)0x04000102)
#define TIMER_HIGH    (*(volatile uint16_t *)0x04000104)
#define TIMER_HIGH_ON (*(volatile uint16_t *)0x04000106)
#define TIMER_RUN     0x80
#define TIMER_CASCADE 0x04

#ifdef __cplusplus
extern "C" {
#endif

void count_print(uint32_t cycles);

#ifdef __cplusplus
}
#endif

static inline void count_begin(void)
{
    TIMER_LOW_ON = 0;
    TIMER_HIGH_ON = 0;
    TIMER_LOW = 0;
    TIMER_HIGH = 0;
    TIMER_HIGH_ON = TIMER_RUN | TIMER_CASCADE;
    TIMER_LOW_ON = TIMER_RUN;
}

static inline void count_end(void)
{
    TIMER_LOW_ON = 0;
    count_print((uint32_t)TIMER_HIGH << 16 | TIMER_LOW);
}

#endif
