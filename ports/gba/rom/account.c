/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Means, the worst ones, and a line of them. */
#include "account.h"

#include <stdbool.h>
#include <string.h>

#define LINE_EVERY 600
#define SECOND     60

int _write(int file, const char *text, int length);   /* console.c */

static void print(const char *text)
{
    _write(1, text, (int)strlen(text));
}

static void print_number(const char *name, uint32_t number)
{
    char digits[11], *at = digits + sizeof digits - 1;
    *at = '\0';
    do {
        *--at = (char)('0' + number % 10);
        number /= 10;
    } while (number != 0);
    print(name);
    print(at);
}

static void print_line(const account *a)
{
    static const char *const names[SPENT_KINDS] = {" collision ", " step ", " pilot ", " draw ", " all "};
    print_number("frames ", a->frames);
    print_number(" missed ", a->frames - a->pictures);
    for (unsigned i = 0; i < SPENT_KINDS; i++) {
        print_number(names[i], a->count[i] == 0 ? 0 : a->sum[i] / a->count[i]);
        print_number(" ", a->worst[i]);
    }
    print("\n");
}

void account_add(account *a, unsigned kind, uint32_t cycles)
{
    a->latest[kind] = cycles;
    a->sum[kind] += cycles;
    a->count[kind]++;
    if (cycles > a->worst[kind]) a->worst[kind] = cycles;
    if (kind == SPENT_COLLISION) a->mean_collision = a->mean_collision - a->mean_collision / 32 + cycles / 32;
}

void account_shown(account *a, uint32_t screen_frames)
{
    bool line = a->frames % LINE_EVERY + screen_frames >= LINE_EVERY;
    a->frames += screen_frames;
    a->pictures++;
    if (a->frames - a->second_begun >= SECOND) {
        a->rate = a->pictures - a->second_pictures;
        a->second_begun = a->frames;
        a->second_pictures = a->pictures;
    }
    if (!line) return;
    print_line(a);
    memset(a->sum, 0, sizeof a->sum);
    memset(a->count, 0, sizeof a->count);
    memset(a->worst, 0, sizeof a->worst);
}
