/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Text over the picture: a sprite a letter, so that it costs the painter nothing. */
#ifndef GBA_LETTERS_H
#define GBA_LETTERS_H

#include <stdint.h>

enum { LETTERS_WHITE, LETTERS_DIM, LETTERS_SHIELD, LETTERS_BEAM, LETTERS_METER, LETTERS_COLORS };

#define LETTER_PITCH 6

/* Tiles and colors of the letters. */
void letters_load(void);

/* No text. */
void letters_clear(void);

/* Adds a text whose upper left corner is at a pixel; returns the column after it. Letters beyond the 128th sprite are left out. */
int letters_add(int x, int y, uint8_t color, const char *text);
/* A letter four times as large: one of T, U, F. */
void letters_add_big(int x, int y, uint8_t color, char letter);
int letters_add_number(int x, int y, uint8_t color, uint32_t number);

/* Shows what was added; to be called in the vertical blank. */
void letters_show(void);

#endif
