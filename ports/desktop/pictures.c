/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Writes what the terminal would show as numbered PPM files (binary, 8 bits a color). */
#include "pictures.h"

#include <stdio.h>
#include <string.h>

#include "game.h"
#include "hud.h"
#include "raster.h"

#define INK      0xe6eef6u
#define INK_DIM  0xa0b4c8u

static void paint(raster *r, const game *g)
{
    unsigned half = r->width / 2;
    if (g->split) {
        raster_scene(r, 0, half - 1, g->sides[SIDE_FLOAT], g->show);
        raster_scene(r, half + 1, r->width - half - 1, g->sides[SIDE_Q16], g->show);
    } else {
        raster_scene(r, 0, r->width, g->sides[g->shown], g->show);
    }
    raster_finish(r);
}

static void write_words(raster *r, const game *g)
{
    char line[HUD_LENGTH];
    unsigned scale = r->height / 180 + (r->height < 180), letters = r->width / (6 * scale) - 1, bottom = r->height - 11 * scale;
    hud_title(g, letters, line);
    raster_text(r, 0, 0, scale, line, INK);
    if (g->split) {
        hud_counts(g, SIDE_FLOAT, letters / 2, line);
        raster_text(r, 0, bottom, scale, line, INK_DIM);
        hud_counts(g, SIDE_Q16, letters / 2, line);
        raster_text(r, r->width / 2 + 1, bottom, scale, line, INK_DIM);
    } else {
        hud_counts(g, g->shown, letters, line);
        raster_text(r, 0, bottom, scale, line, INK_DIM);
    }
}

static bool write_file(const raster *r, const char *name)
{
    FILE *file = fopen(name, "wb");
    if (file == NULL) return false;
    size_t bytes = (size_t)r->width * r->height * 3;
    bool well = fprintf(file, "P6\n%u %u\n255\n", r->width, r->height) > 0 && fwrite(r->pixels, 1, bytes, file) == bytes;
    return (fclose(file) == 0) && well;
}

static bool write_picture(raster *r, const game *g, const options *o, unsigned number)
{
    char name[4096];
    int length = snprintf(name, sizeof name, "%s%05u.ppm", o->ppm, number);
    if (!raster_resize(r, o->width, o->height)) {
        fprintf(stderr, "tuff-demo: no memory for a picture\n");
        return false;
    }
    paint(r, g);
    write_words(r, g);
    if (length > 0 && (size_t)length < sizeof name && write_file(r, name)) return true;
    fprintf(stderr, "tuff-demo: cannot write %s\n", name);
    return false;
}

int pictures_run(const options *o)
{
    game g;
    raster r = {0, 0, NULL, NULL};
    uint32_t frames = o->frames != 0 ? o->frames : 600, due = 0;
    unsigned written = 0;
    game_start(&g, o);
    g.autopilot = true;
    while (g.frame < frames) {
        game_step_together(&g, 0);
        due += o->fps;
        if (due < 60) continue;
        due -= 60;
        if (g.frame <= o->from) continue;
        if (!write_picture(&r, &g, o, ++written)) {
            raster_free(&r);
            return 1;
        }
    }
    raster_free(&r);
    printf("tuff-demo: %u pictures %s00001.ppm ...\n", written, o->ppm);
    return 0;
}
