/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Paints the scene's marks into a page of a byte a pixel, one unit a pixel. */
#ifndef GBA_PAINT_H
#define GBA_PAINT_H

#include <stdint.h>

#include "marks.h"

#define PAINT_MIXTURES 5   /* of each color; number k has 3 k of 16 parts of it */

/* The palette: color + k * SCENE_COLORS is mixture k of a color. */
void paint_colors(void);

/* Once, before the first page. */
void paint_start(void);

/* The view's first line, and its height: a multiple of 4 lines. Above and below it are the strips of the page that only paint_box paints.
   */
#define PAINT_TOP    12
#define PAINT_HEIGHT 124

/* The page that is painted from now on; its view is all space. */
void paint_begin(uint16_t *page);

/* For scene_draw. */
void paint_mark(void *context, const scene_mark *mark);

/* from <= x < to, top <= y < bottom, where y counts from the view's first line; cut at the page's sides. */
void paint_box(int from, int top, int to, int bottom, uint8_t color);

#endif
