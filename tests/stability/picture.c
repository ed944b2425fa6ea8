/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The lines of a picture: a word for what it is, then its fields, separated by tabs. */
#include "picture.h"

#include <stdio.h>
#include <stdlib.h>

#include "exact.h"

static const char *const role_names[PICTURE_ROLES] = { "rock", "seam", "body", "tuff", "other", "fails", "box2d", "truth" };
static FILE *file;

bool picture_begin(const char *name)
{
    char path[512];
    const char *folder = getenv("TUFF_STABILITY_PICTURES");
    if (folder == NULL || TUFF_SCALAR != TUFF_Q16_16) return false;
    snprintf(path, sizeof path, "%s/%s.picture", folder, name);
    file = fopen(path, "w");
    if (file == NULL) perror(path);
    return file != NULL;
}

void picture_end(void)
{
    if (file) fclose(file);
    file = NULL;
}

void picture_panel(const char *title, double left, double bottom, double right, double top)
{
    if (file) fprintf(file, "panel\t%s\t%g\t%g\t%g\t%g\n", title, left, bottom, right, top);
}

void picture_chart(const char *title, const char *x_label, const char *x_scale, const char *y_label, const char *y_scale)
{
    if (file) fprintf(file, "chart\t%s\t%s\t%s\t%s\t%s\n", title, x_label, x_scale, y_label, y_scale);
}

void picture_polygon(picture_role role, const tuff_polygon *polygon, tuff_vec2 at)
{
    if (!file) return;
    fprintf(file, "polygon\t%s", role_names[role]);
    for (int i = 0; i < polygon->count; i++) {
        fprintf(file, "\t%.6f\t%.6f", units_of(at.x) + units_of(polygon->vertices[i].x), units_of(at.y) + units_of(polygon->vertices[i].y));
    }
    fprintf(file, "\n");
}

static void seams_of(const tuff_polygon *part, tuff_vec2 at)
{
    double x = units_of(at.x), y = units_of(at.y);
    for (int i = 0; i < part->count; i++) {
        tuff_vec2 from = part->vertices[i], to = part->vertices[(i + 1) % part->count];
        if (!(part->internal_edges >> i & 1)) continue;
        picture_segment(PICTURE_SEAM, NULL, x + units_of(from.x), y + units_of(from.y), x + units_of(to.x), y + units_of(to.y));
    }
}

void picture_piece(const tuff_terrain *piece)
{
    for (int i = 0; i < piece->part_count; i++) picture_polygon(PICTURE_ROCK, &piece->parts[i], piece->position);
    for (int i = 0; i < piece->part_count; i++) seams_of(&piece->parts[i], piece->position);
    if (piece->part_count == 0) picture_circle(PICTURE_ROCK, piece->position, piece->radius);
}

void picture_circle(picture_role role, tuff_vec2 center, tuff_real radius)
{
    if (file) fprintf(file, "circle\t%s\t%.6f\t%.6f\t%.6f\n", role_names[role], units_of(center.x), units_of(center.y), units_of(radius));
}

void picture_arrow(picture_role role, double x, double y, double to_x, double to_y)
{
    if (file) fprintf(file, "arrow\t%s\t%.6f\t%.6f\t%.6f\t%.6f\n", role_names[role], x, y, to_x, to_y);
}

void picture_dot(picture_role role, double x, double y)
{
    if (file) fprintf(file, "dot\t%s\t%.6f\t%.6f\n", role_names[role], x, y);
}

void picture_note(double x, double y, const char *text)
{
    if (file) fprintf(file, "note\t%.6f\t%.6f\t%s\n", x, y, text);
}

void picture_line(picture_role role, const char *label)
{
    if (file) fprintf(file, "line\t%s\t%s", role_names[role], label ? label : "");
}

void picture_point(double x, double y)
{
    if (file) fprintf(file, "\t%.9g\t%.9g", x, y);
}

void picture_line_end(void)
{
    if (file) fprintf(file, "\n");
}

void picture_segment(picture_role role, const char *label, double x, double y, double to_x, double to_y)
{
    picture_line(role, label);
    picture_point(x, y);
    picture_point(to_x, to_y);
    picture_line_end();
}
