/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A small painter: convex polygons, thick lines, discs and rings, by rows of samples. */
#include "raster.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool raster_resize(raster *r, unsigned width, unsigned height)
{
    size_t pixels = (size_t)width * height;
    if (width != r->width || height != r->height) {
        raster_free(r);
        r->fine = malloc(pixels * RASTER_FINE * RASTER_FINE * 3);
        r->pixels = malloc(pixels * 3);
        if (r->fine == NULL || r->pixels == NULL) {
            raster_free(r);
            return false;
        }
        r->width = width;
        r->height = height;
    }
    memset(r->fine, 0, pixels * RASTER_FINE * RASTER_FINE * 3);
    return true;
}

void raster_free(raster *r)
{
    free(r->fine);
    free(r->pixels);
    memset(r, 0, sizeof *r);
}

/* A part of the picture that a scene is drawn into, measured in samples. */
typedef struct pane {
    raster *target;
    int left, right, bottom;    /* right and bottom: first ones outside */
    double middle_x, middle_y;
    double scale;               /* samples to 1/16 unit */
} pane;

typedef struct spot { double x, y; } spot;

static uint8_t mixed(uint8_t below, unsigned above, unsigned strength)
{
    return (uint8_t)((below * (SCENE_SOLID - strength) + above * strength) / SCENE_SOLID);
}

/* The samples of a row whose middles lie in from <= x < to. */
static void fill_row(const pane *p, int y, double from, double to, const scene_mark *mark)
{
    if (!(to > p->left && from < p->right)) return;
    int first = from <= p->left ? p->left : (int)ceil(from - 0.5), last = to >= p->right ? p->right : (int)ceil(to - 0.5);
    uint32_t color = scene_palette[mark->color];
    uint8_t *sample = p->target->fine + ((size_t)y * p->target->width * RASTER_FINE + (size_t)first) * 3;
    for (int x = first; x < last; x++, sample += 3) {
        sample[0] = mixed(sample[0], color >> 16 & 255, mark->strength);
        sample[1] = mixed(sample[1], color >> 8 & 255, mark->strength);
        sample[2] = mixed(sample[2], color & 255, mark->strength);
    }
}

static int row_within(const pane *p, double y)
{
    double row = ceil(y - 0.5);
    return row < 0 ? 0 : row > p->bottom ? p->bottom : (int)row;
}

/* Where the row at height y enters and leaves a convex outline. */
static void cross_row(const spot *corners, unsigned count, double y, double *from, double *to)
{
    *from = 1e9;
    *to = -1e9;
    for (unsigned i = 0; i < count; i++) {
        spot a = corners[i], b = corners[(i + 1) % count];
        if ((a.y <= y) == (b.y <= y)) continue;
        double x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
        if (x < *from) *from = x;
        if (x > *to) *to = x;
    }
}

static void fill_convex(const pane *p, const spot *corners, unsigned count, const scene_mark *mark)
{
    double top = 1e9, bottom = -1e9;
    for (unsigned i = 0; i < count; i++) {
        if (corners[i].y < top) top = corners[i].y;
        if (corners[i].y > bottom) bottom = corners[i].y;
    }
    for (int y = row_within(p, top), end = row_within(p, bottom); y < end; y++) {
        double from, to;
        cross_row(corners, count, y + 0.5, &from, &to);
        fill_row(p, y, from, to, mark);
    }
}

static double at_least(double value, double least)
{
    return value > least ? value : least;
}

static void draw_line(const pane *p, spot a, spot b, const scene_mark *mark)
{
    double half = at_least(mark->size * p->scale, (mark->size < 16 ? 0.65 : 0.9) * RASTER_FINE) / 2;
    double dx = b.x - a.x, dy = b.y - a.y, length = sqrt(dx * dx + dy * dy);
    if (length < 1e-6) return;
    dx *= half / length;
    dy *= half / length;
    spot corners[4] = {
        {a.x - dx - dy, a.y - dy + dx}, {b.x + dx - dy, b.y + dy + dx},
        {b.x + dx + dy, b.y + dy - dx}, {a.x - dx + dy, a.y - dy - dx}
    };
    fill_convex(p, corners, 4, mark);
}

static double half_chord(double radius, double dy)
{
    double square = radius * radius - dy * dy;
    return square > 0 ? sqrt(square) : 0;
}

/* inner 0: a disc. */
static void draw_round(const pane *p, spot at, double outer, double inner, const scene_mark *mark)
{
    for (int y = row_within(p, at.y - outer), end = row_within(p, at.y + outer); y < end; y++) {
        double dy = y + 0.5 - at.y, wide = half_chord(outer, dy), narrow = half_chord(inner, dy);
        if (narrow > 0) {
            fill_row(p, y, at.x - wide, at.x - narrow, mark);
            fill_row(p, y, at.x + narrow, at.x + wide, mark);
        } else {
            fill_row(p, y, at.x - wide, at.x + wide, mark);
        }
    }
}

static void draw_dot(const pane *p, spot at, const scene_mark *mark)
{
    double half = RASTER_FINE * (0.5 + p->bottom / (RASTER_FINE * 1200.0));
    spot corners[4] = {{at.x - half, at.y - half}, {at.x + half, at.y - half}, {at.x + half, at.y + half}, {at.x - half, at.y + half}};
    fill_convex(p, corners, 4, mark);
}

static void draw_mark(void *context, const scene_mark *mark)
{
    const pane *p = context;
    spot spots[SCENE_MARK_POINTS];
    double radius = mark->size * p->scale, thin = 0.8 * RASTER_FINE;
    for (unsigned i = 0; i < mark->count; i++) {
        spots[i].x = p->middle_x + mark->points[i].x * p->scale;
        spots[i].y = p->middle_y + mark->points[i].y * p->scale;
    }
    switch (mark->kind) {
    case SCENE_POLYGON: fill_convex(p, spots, mark->count, mark); break;
    case SCENE_LINE: draw_line(p, spots[0], spots[1], mark); break;
    case SCENE_DISC: draw_round(p, spots[0], at_least(radius, 0.6 * RASTER_FINE), 0, mark); break;
    case SCENE_RING: draw_round(p, spots[0], radius + thin / 2, at_least(radius - thin / 2, 0), mark); break;
    default: draw_dot(p, spots[0], mark); break;
    }
}

static void fill_space(const pane *p)
{
    scene_mark space;
    space.color = SCENE_COLOR_SPACE;
    space.strength = SCENE_SOLID;
    for (int y = 0; y < p->bottom; y++) fill_row(p, y, p->left, p->right, &space);
}

/* The larger the picture the more it shows: 256 units across on 80 pixels, 368 on 640. */
void raster_scene(raster *r, unsigned left, unsigned width, const side *from, uint8_t show)
{
    double across = 240.0 + (r->width < 700 ? r->width : 700) / 5.0;
    double by_width = width / across, by_height = r->height / (across * 0.65);
    double pixels = by_width > by_height ? by_width : by_height;
    scene_view view;
    pane p;
    view.half_width = (int16_t)(width / pixels / 2 + 2);
    view.half_height = (int16_t)(r->height / pixels / 2 + 1);
    view.show = show;
    p.target = r;
    p.left = (int)left * RASTER_FINE;
    p.right = (int)(left + width) * RASTER_FINE;
    p.bottom = (int)r->height * RASTER_FINE;
    p.middle_x = (p.left + p.right) / 2.0;
    p.middle_y = p.bottom / 2.0;
    p.scale = pixels * RASTER_FINE / 16;
    fill_space(&p);
    from->draw(&view, draw_mark, &p);
}

void raster_finish(raster *r)
{
    size_t row = (size_t)r->width * RASTER_FINE * 3;
    for (unsigned y = 0; y < r->height; y++) {
        for (unsigned x = 0; x < r->width * 3; x++) {
            const uint8_t *sample = r->fine + (size_t)y * RASTER_FINE * row + (size_t)(x / 3) * RASTER_FINE * 3 + x % 3;
            unsigned sum = 0;
            for (unsigned k = 0; k < RASTER_FINE * RASTER_FINE; k++) sum += sample[k / RASTER_FINE * row + k % RASTER_FINE * 3];
            r->pixels[(size_t)y * r->width * 3 + x] = (uint8_t)(sum / (RASTER_FINE * RASTER_FINE));
        }
    }
}

uint32_t raster_pixel(const raster *r, unsigned x, unsigned y)
{
    const uint8_t *at = r->pixels + ((size_t)y * r->width + x) * 3;
    return (uint32_t)at[0] << 16 | (uint32_t)at[1] << 8 | at[2];
}
