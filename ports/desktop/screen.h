/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A page of cells, of which only the changed ones are sent. */
#ifndef DEMO_SCREEN_H
#define DEMO_SCREEN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "raster.h"

typedef struct cell {
    uint32_t ink, ground;   /* 0xRRGGBB */
    char     letter;        /* 0: the upper half in ink, the lower in ground */
} cell;

typedef struct screen {
    unsigned columns, rows;
    cell *cells, *sent;
    char *bytes;            /* of the picture to send */
    size_t used, capacity;
} screen;

/* False: no memory. A new size is drawn afresh. */
bool screen_resize(screen *s, unsigned columns, unsigned rows);
void screen_free(screen *s);

/* Forget what was sent. */
void screen_forget(screen *s);

/* Two rows of pixels to a row of cells, from row top on. */
void screen_picture(screen *s, const raster *r, unsigned top);

/* Text over a picture, which is darkened, or over a bar. */
void screen_text(screen *s, unsigned column, unsigned row, const char *text, uint32_t ink);

/* A whole row of one ground. */
void screen_bar(screen *s, unsigned row, uint32_t ground);

/* Sends what has changed. False: the terminal is gone or memory is short. */
bool screen_send(screen *s);

#endif
