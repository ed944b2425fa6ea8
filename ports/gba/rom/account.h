/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Where the cycles go, and whether pictures come in time. */
#ifndef GBA_ACCOUNT_H
#define GBA_ACCOUNT_H

#include <stdint.h>

/* The first three are of a step, the others of a picture; collision is a part of step, all of them are parts of all. */
enum { SPENT_COLLISION, SPENT_STEP, SPENT_PILOT, SPENT_DRAW, SPENT_ALL, SPENT_KINDS };

typedef struct account {
    uint32_t latest[SPENT_KINDS], mean_collision;    /* of the 32 latest, roughly */
    uint32_t sum[SPENT_KINDS], worst[SPENT_KINDS], count[SPENT_KINDS];
    uint32_t frames, pictures;                       /* of the screen, each with its step; those that were new */
    uint32_t second_begun, second_pictures, rate;    /* pictures of the latest second */
} account;

void account_add(account *a, unsigned kind, uint32_t cycles);

/* A new picture, after so many of the screen's frames; a line to mGBA's console every 600. */
void account_shown(account *a, uint32_t screen_frames);

#endif
