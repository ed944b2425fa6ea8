/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Cells into escape sequences: 24-bit colors, U+2580 for two pixels, the cursor moved only over gaps. */
#include "screen.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "terminal.h"

#define NEVER_SENT 0xffffffffu
#define CELL_BYTES 64   /* at most: a move, two colors, a letter */

void screen_free(screen *s)
{
    free(s->cells);
    free(s->sent);
    free(s->bytes);
    memset(s, 0, sizeof *s);
}

void screen_forget(screen *s)
{
    for (size_t i = 0; i < (size_t)s->columns * s->rows; i++) s->sent[i].ink = NEVER_SENT;
}

bool screen_resize(screen *s, unsigned columns, unsigned rows)
{
    if (columns == s->columns && rows == s->rows) return true;
    size_t count = (size_t)columns * rows;
    screen_free(s);
    s->cells = calloc(count, sizeof *s->cells);
    s->sent = calloc(count, sizeof *s->sent);
    s->capacity = count * CELL_BYTES + 256;
    s->bytes = malloc(s->capacity);
    if (s->cells == NULL || s->sent == NULL || s->bytes == NULL) {
        screen_free(s);
        return false;
    }
    s->columns = columns;
    s->rows = rows;
    screen_forget(s);
    return true;
}

void screen_picture(screen *s, const raster *r, unsigned top)
{
    for (unsigned y = 0; y + 1 < r->height && top + y / 2 < s->rows; y += 2) {
        for (unsigned x = 0; x < r->width && x < s->columns; x++) {
            cell *at = &s->cells[(size_t)(top + y / 2) * s->columns + x];
            at->ink = raster_pixel(r, x, y);
            at->ground = raster_pixel(r, x, y + 1);
            at->letter = 0;
        }
    }
}

void screen_text(screen *s, unsigned column, unsigned row, const char *text, uint32_t ink)
{
    for (unsigned x = column; *text != '\0' && x < s->columns && row < s->rows; x++, text++) {
        cell *at = &s->cells[(size_t)row * s->columns + x];
        if (at->letter == 0) at->ground = at->ground >> 2 & 0x3f3f3fu;
        at->letter = *text;
        at->ink = ink;
    }
}

void screen_bar(screen *s, unsigned row, uint32_t ground)
{
    for (unsigned x = 0; x < s->columns && row < s->rows; x++) {
        cell *at = &s->cells[(size_t)row * s->columns + x];
        at->letter = ' ';
        at->ink = at->ground = ground;
    }
}

static void put(screen *s, const char *text)
{
    size_t length = strlen(text);
    memcpy(s->bytes + s->used, text, length);
    s->used += length;
}

static void put_color(screen *s, int layer, uint32_t color)
{
    char text[32];
    unsigned red = color >> 16 & 255, green = color >> 8 & 255, blue = color & 255;
    snprintf(text, sizeof text, "\033[%d;2;%u;%u;%um", layer, red, green, blue);
    put(s, text);
}

static bool same(const cell *a, const cell *b)
{
    return a->ink == b->ink && a->ground == b->ground && a->letter == b->letter;
}

typedef struct pen { uint32_t ink, ground; size_t next; } pen;

/* A cell of one color is a space: half the bytes. */
static void put_cell(screen *s, size_t i, pen *p)
{
    const cell *at = &s->cells[i];
    bool blank = at->letter == ' ' || (at->letter == 0 && at->ink == at->ground);
    if (p->next != i || i % s->columns == 0) {
        char move[32];
        snprintf(move, sizeof move, "\033[%u;%uH", (unsigned)(i / s->columns) + 1, (unsigned)(i % s->columns) + 1);
        put(s, move);
    }
    if (p->ground != at->ground) put_color(s, 48, at->ground);
    if (!blank && p->ink != at->ink) put_color(s, 38, at->ink);
    p->ground = at->ground;
    if (!blank) p->ink = at->ink;
    p->next = i + 1;
    if (blank) put(s, " ");
    else if (at->letter == 0) put(s, "\342\226\200");
    else put(s, (char[]){at->letter, '\0'});
    s->sent[i] = *at;
}

bool screen_send(screen *s)
{
    pen p = {NEVER_SENT, NEVER_SENT, (size_t)-1};
    s->used = 0;
    put(s, "\033[?2026h");
    for (size_t i = 0; i < (size_t)s->columns * s->rows; i++) {
        if (!same(&s->cells[i], &s->sent[i])) put_cell(s, i, &p);
    }
    put(s, "\033[0m\033[?2026l");
    return terminal_write(s->bytes, s->used);
}
