/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The line of a count; without printf, which takes 6 KB of IWRAM. */
#include "count_gba.h"

#include <stdio.h>

void count_print(uint32_t cycles)
{
    char digits[11];
    char *first = digits + sizeof digits - 1;
    *first = '\0';
    do {
        *--first = (char)('0' + cycles % 10);
        cycles /= 10;
    } while (cycles != 0);
    fputs("cycles ", stdout);
    puts(first);
}
