/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   AVR: cycles, by the runner ports/avr/run.c. Tables stay in flash: there are 2.5 KB of RAM. */
#ifndef TUFF_PORTS_COUNT_AVR_H
#define TUFF_PORTS_COUNT_AVR_H

#include <avr/io.h>
#include <avr/pgmspace.h>

#define TABLE      PROGMEM
#define table_read memcpy_P

static inline void count_begin(void) { GPIOR1 = 1; }
static inline void count_end(void)   { GPIOR1 = 0; }

#endif
