/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Convex polygons by their two chains of edges, flat lines by the rows they cross, steep ones by pixels, circles by whole steps: no
   division but one a long edge. The picture's memory takes no single bytes: a pixel is half of a pair. */
#include "paint.h"

#include <stdbool.h>

#include "hardware.h"

#define PAIRS      (PAGE_WIDTH / 2)
#define RECIPROCALS 256
#define WHOLE_WORD  0x01010101u   /* times a color: four pixels of it */
#define WIDTH_16_16 (PAGE_WIDTH * 65536u)

/* fill.s */
void paint_fill(uint16_t *row, int twos, uint32_t ink);
void paint_rows(uint16_t *row, const int16_t *ends, int rows, uint32_t ink);
void paint_steep(uint16_t *row, int32_t x, int32_t slope, int rows, uint32_t ink);

static uint16_t *target;
static uint16_t reciprocals[RECIPROCALS] SLOW_MEMORY;   /* 65536 / n, rounded down; of 1 one less */
static int16_t ends[2][PAINT_HEIGHT];     /* of the rows to paint; of a polygon: where they cross the edges that lead down, and up */

typedef char fill_finds_the_other_end[sizeof ends[0] == 2 * 124 ? 1 : -1];

void paint_start(void)
{
    for (unsigned n = 1; n < RECIPROCALS; n++) reciprocals[n] = (uint16_t)(65535u / n);
}

void paint_begin(uint16_t *page)
{
    target = page + PAINT_TOP * PAIRS;
    paint_fill(target, PAINT_HEIGHT / 2, SCENE_COLOR_SPACE * WHOLE_WORD);
}

/* The rows whose ends are known. */
static void fill_rows(int top, int bottom, uint8_t color)
{
    if (top < 0) top = 0;
    if (bottom > PAINT_HEIGHT) bottom = PAINT_HEIGHT;
    if (top < bottom) paint_rows(target + top * PAIRS, ends[0] + top, bottom - top, color * WHOLE_WORD);
}

static inline void put(uint16_t *row, int x, uint32_t color)
{
    uint16_t *pair = row + (x >> 1);
    uint32_t both = *pair;
    *pair = (uint16_t)((x & 1) != 0 ? (both & 0x00FF) | color << 8 : (both & 0xFF00) | color);
}

static void put_if_seen(int x, int y, uint8_t color)
{
    if ((unsigned)x < PAGE_WIDTH && (unsigned)y < PAINT_HEIGHT) put(target + y * PAIRS, x, color);
}

void paint_box(int from, int top, int to, int bottom, uint8_t color)
{
    for (int i = 0; i < bottom - top; i++) {
        ends[0][i] = (int16_t)from;
        ends[1][i] = (int16_t)to;
    }
    paint_rows(target + top * PAIRS, ends[0], bottom - top, color * WHOLE_WORD);
}

/* ---- Polygons */

typedef struct pixel { int x, y; } pixel;

static pixel pixel_of(scene_point point)
{
    pixel at;
    at.x = ((point.x + 8) >> 4) + PAGE_WIDTH / 2;
    at.y = ((point.y + 8) >> 4) + PAINT_HEIGHT / 2;
    return at;
}

/* dx / dy in steps of 2^-16. */
static int32_t slope_of(int dx, int dy)
{
    return dy < RECIPROCALS ? dx * (int32_t)reciprocals[dy] : dx * 65536 / dy;
}

/* The numbers x, x + slope, ... in whole pixels, four a turn. */
static void follow(int16_t *at, const int16_t *last, int32_t x, int32_t slope)
{
    for (; last - at >= 4; at += 4) {
        at[0] = (int16_t)(x >> 16), x += slope;
        at[1] = (int16_t)(x >> 16), x += slope;
        at[2] = (int16_t)(x >> 16), x += slope;
        at[3] = (int16_t)(x >> 16), x += slope;
    }
    for (; at < last; x += slope) *at++ = (int16_t)(x >> 16);
}

/* The rows from high.y to the one before low.y. */
static void cross_rows(int16_t *side, pixel high, pixel low)
{
    if (low.y <= 0 || high.y >= PAINT_HEIGHT) return;
    int32_t slope = slope_of(low.x - high.x, low.y - high.y), x = high.x * 65536 + 32768;
    int y = high.y, end = low.y < PAINT_HEIGHT ? low.y : PAINT_HEIGHT;
    if (y < 0) {
        x -= slope * y;
        y = 0;
    }
    follow(side + y, side + end, x, slope);
}

static void cross_edge(pixel a, pixel b)
{
    if (a.y < b.y) cross_rows(ends[0], a, b);
    else if (b.y < a.y) cross_rows(ends[1], b, a);
}

static void fill_polygon(const scene_mark *mark, uint8_t color)
{
    pixel first = pixel_of(mark->points[0]), before = first;
    int top = first.y, bottom = first.y;
    for (unsigned i = 1; i < mark->count; i++) {
        pixel at = pixel_of(mark->points[i]);
        cross_edge(before, at);
        if (at.y < top) top = at.y;
        if (at.y > bottom) bottom = at.y;
        before = at;
    }
    cross_edge(before, first);
    fill_rows(top, bottom, color);
}

/* ---- Lines */

static bool beside(pixel a, pixel b)
{
    return (a.x < 0 && b.x < 0) || (a.y < 0 && b.y < 0) || (a.x >= PAGE_WIDTH && b.x >= PAGE_WIDTH)
        || (a.y >= PAINT_HEIGHT && b.y >= PAINT_HEIGHT);
}

static int size_of(int n)
{
    return n < 0 ? -n : n;
}

/* A pixel a row: those that the page has, which follow each other. */
static void draw_steep(pixel high, pixel low, int32_t slope, uint8_t color)
{
    int y = high.y < 0 ? 0 : high.y, end = low.y < PAINT_HEIGHT ? low.y + 1 : PAINT_HEIGHT;
    int32_t x = high.x * 65536 + 32768 + slope * (y - high.y), last = x + slope * (end - 1 - y);
    for (; y < end && (uint32_t)x >= WIDTH_16_16; x += slope) y++;
    for (; y < end && (uint32_t)last >= WIDTH_16_16; last -= slope) end--;
    if (y < end) paint_steep(target + y * PAIRS, x, slope, end - y, color * WHOLE_WORD);
}

/* A row's pixels lie between the places where the line enters and leaves the row; from the first to the last. */
static void draw_flat(pixel high, pixel low, int32_t slope, uint8_t color)
{
    int leftward = low.x < high.x, top = high.y < 0 ? 0 : high.y, end = low.y < PAINT_HEIGHT ? low.y : PAINT_HEIGHT - 1;
    int32_t x = high.x * 65536 + 32768 - slope / 2 + slope * (top - high.y);
    if (top > end) return;
    if (slope != 0) {
        follow(ends[0] + top, ends[0] + end + 1, x, slope);
        follow(ends[1] + top, ends[1] + end + 1, x + slope, slope);
    }
    if (top == high.y) ends[0][top] = (int16_t)(high.x + leftward);
    if (end == low.y) ends[1][end] = (int16_t)(low.x + 1 - leftward);
    fill_rows(top, end + 1, color);
}

/* A wide one is thin ones side by side across the major axis. */
static void draw_line(const scene_mark *mark, uint8_t color)
{
    pixel high = pixel_of(mark->points[0]), low = pixel_of(mark->points[1]);
    int width = mark->size < 32 ? 1 : mark->size >> 4, aside = width / 2;
    if (beside(high, low)) return;
    if (high.y > low.y) {
        pixel kept = high;
        high = low;
        low = kept;
    }
    int dx = low.x - high.x, dy = low.y - high.y;
    int32_t slope = dy == 0 ? 0 : slope_of(dx, dy);
    if (size_of(dx) < dy) {
        for (high.x -= aside, low.x -= aside; width > 0; high.x++, low.x++, width--) draw_steep(high, low, slope, color);
        return;
    }
    for (high.y -= aside, low.y -= aside; width > 0; high.y++, low.y++, width--) draw_flat(high, low, slope, color);
}

/* ---- Circles, from the widest row outward; the squares are of whole pixels, and beyond is wide * wide + dy * dy - square */

static int32_t square_of_radius(const scene_mark *mark)
{
    int32_t square = (int32_t)mark->size * mark->size >> 8;
    return square < 1 ? 1 : square;
}

static void set_row(int y, int from, int to)
{
    if ((unsigned)y >= PAINT_HEIGHT) return;
    ends[0][y] = (int16_t)from;
    ends[1][y] = (int16_t)to;
}

static void draw_disc(const scene_mark *mark, uint8_t color)
{
    pixel at = pixel_of(mark->points[0]);
    int32_t square = square_of_radius(mark);
    int wide = (mark->size >> 4) + 1, dy = 0, beyond = wide * wide - square, seen = at.y > PAINT_HEIGHT / 2 ? at.y : PAINT_HEIGHT - at.y;
    for (; dy <= seen && dy * dy <= square; beyond += 2 * dy + 1, dy++) {
        for (; beyond > 0; wide--) beyond -= 2 * wide - 1;
        set_row(at.y + dy, at.x - wide, at.x + wide + 1);
        set_row(at.y - dy, at.x - wide, at.x + wide + 1);
    }
    fill_rows(at.y - dy + 1, at.y + dy, color);
}

/* The pixels at two columns of a row. */
static void put_both(int y, int left, int right, uint8_t color)
{
    if ((unsigned)y >= PAINT_HEIGHT) return;
    uint16_t *row = target + y * PAIRS;
    if ((unsigned)left < PAGE_WIDTH) put(row, left, color);
    if ((unsigned)right < PAGE_WIDTH) put(row, right, color);
}

static void draw_ring(const scene_mark *mark, uint8_t color)
{
    pixel at = pixel_of(mark->points[0]);
    int32_t square = square_of_radius(mark);
    int wide = (mark->size >> 4) + 1, beyond = wide * wide - square;
    for (int dy = 0; dy <= wide; beyond += 2 * dy + 1, dy++) {
        for (; beyond > 0; wide--) beyond -= 2 * wide - 1;
        put_both(at.y + dy, at.x - wide, at.x + wide, color);
        put_both(at.y - dy, at.x - wide, at.x + wide, color);
        put_both(at.y + wide, at.x - dy, at.x + dy, color);
        put_both(at.y - wide, at.x - dy, at.x + dy, color);
    }
}

static void draw_dot(const scene_mark *mark, uint8_t color)
{
    pixel at = pixel_of(mark->points[0]);
    put_if_seen(at.x, at.y, color);
}

/* ---- Marks */

typedef void painter(const scene_mark *mark, uint8_t color);

static painter *const painters[] = {fill_polygon, draw_line, draw_disc, draw_ring, draw_dot};   /* by SCENE_POLYGON ... SCENE_DOT */

/* Strengths 1 and 2 are washes over whatever is there, which a palette cannot mix. */
void paint_mark(void *context, const scene_mark *mark)
{
    unsigned mixture = mark->strength == SCENE_SOLID ? 0 : (mark->strength + 1u) / 3u;
    (void)context;
    if (mark->strength < 3) return;
    uint8_t color = (uint8_t)(mark->color + (mixture < PAINT_MIXTURES ? mixture : PAINT_MIXTURES) * SCENE_COLORS);
    painters[mark->kind](mark, color);
}
