/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Letters of 5 x 7 dots. */
#ifndef SCENE_FONT_H
#define SCENE_FONT_H

#include <stdint.h>

#define FONT_WIDTH  5
#define FONT_HEIGHT 7

/* Seven rows; bit 4 is the leftmost dot. Small letters look like capitals, unknown ones are blank. */
const uint8_t *font_rows(char c);

#endif
