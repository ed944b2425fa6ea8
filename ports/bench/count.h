/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Counting between two points of a program, by the kind of machine; the build names the header in BENCH_COUNTER. Each gives

     count_begin(), count_end()   around what is counted: a line `cycles N` or `instructions N` comes out for it, from here or the emulator

   and where tables do not lie in the address space of the data, TABLE and table_read, which are memcpy elsewhere. */
#ifndef TUFF_PORTS_COUNT_H
#define TUFF_PORTS_COUNT_H

#include <stdint.h>
#include <string.h>

#include BENCH_COUNTER

#ifndef TABLE
#define TABLE
#define table_read memcpy
#endif

#endif
