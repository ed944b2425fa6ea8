/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The lines of text over the picture, for screen and files alike. */
#ifndef DEMO_HUD_H
#define DEMO_HUD_H

#include "game.h"

#define HUD_LENGTH 256

/* Each fills a line of at most columns letters, cut where it does not fit. */
void hud_title(const game *g, unsigned columns, char line[HUD_LENGTH]);
void hud_counts(const game *g, int which, unsigned columns, char line[HUD_LENGTH]);

#endif
