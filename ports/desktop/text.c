/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Writes into finished pictures. */
#include <string.h>

#include "font.h"
#include "raster.h"

static void darken(raster *r, unsigned left, unsigned top, unsigned width, unsigned height)
{
    for (unsigned y = top; y < top + height && y < r->height; y++) {
        for (unsigned x = left; x < left + width && x < r->width; x++) {
            uint8_t *at = r->pixels + ((size_t)y * r->width + x) * 3;
            for (unsigned k = 0; k < 3; k++) at[k] /= 4;
        }
    }
}

static void put_dot(raster *r, unsigned left, unsigned top, unsigned scale, uint32_t color)
{
    for (unsigned y = top; y < top + scale && y < r->height; y++) {
        for (unsigned x = left; x < left + scale && x < r->width; x++) {
            uint8_t *at = r->pixels + ((size_t)y * r->width + x) * 3;
            at[0] = (uint8_t)(color >> 16);
            at[1] = (uint8_t)(color >> 8);
            at[2] = (uint8_t)color;
        }
    }
}

static void put_letter(raster *r, unsigned left, unsigned top, unsigned scale, const uint8_t *letter, uint32_t color)
{
    for (unsigned y = 0; y < FONT_HEIGHT; y++) {
        for (unsigned x = 0; x < FONT_WIDTH; x++) {
            if (letter[y] >> (FONT_WIDTH - 1 - x) & 1) put_dot(r, left + x * scale, top + y * scale, scale, color);
        }
    }
}

void raster_text(raster *r, unsigned left, unsigned top, unsigned scale, const char *text, uint32_t color)
{
    unsigned length = (unsigned)strlen(text), step = (FONT_WIDTH + 1) * scale;
    darken(r, left, top, length * step + 3 * scale, (FONT_HEIGHT + 4) * scale);
    for (unsigned i = 0; i < length; i++) put_letter(r, left + 2 * scale + i * step, top + 2 * scale, scale, font_rows(text[i]), color);
}
