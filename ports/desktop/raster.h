/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Pictures in memory: marks drawn finely, then averaged down to pixels. */
#ifndef DEMO_RASTER_H
#define DEMO_RASTER_H

#include <stdbool.h>
#include <stdint.h>

#include "side.h"

#define RASTER_FINE 3   /* samples along a pixel's side */

typedef struct raster {
    unsigned width, height;   /* pixels */
    uint8_t *fine;            /* 3 bytes a sample */
    uint8_t *pixels;          /* 3 bytes a pixel: red, green, blue */
} raster;

/* Size it, and black it out. False: no memory. */
bool raster_resize(raster *r, unsigned width, unsigned height);
void raster_free(raster *r);

/* Draws a scene into the pixels left .. left + width of each row. */
void raster_scene(raster *r, unsigned left, unsigned width, const side *from, uint8_t show);

/* Averages the samples into pixels. */
void raster_finish(raster *r);

/* A finished pixel as 0xRRGGBB. */
uint32_t raster_pixel(const raster *r, unsigned x, unsigned y);

/* Text over finished pixels, on a darkened ground; capital letters, 6 x 8 pixels each times scale. */
void raster_text(raster *r, unsigned left, unsigned top, unsigned scale, const char *text, uint32_t color);

#endif
