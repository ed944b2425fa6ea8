/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What a family's picture shows, as lines that tests/stability/draw.py draws. Written by the Q16.16 build's program, and only
   where TUFF_STABILITY_PICTURES names a folder; otherwise the calls do nothing. World units; y grows upwards in the picture. */
#ifndef TUFF_STABILITY_PICTURE_H
#define TUFF_STABILITY_PICTURE_H

#include "tuff/tuff.h"

/* Whose path, body or curve it is; each has a color and a dash of its own. */
typedef enum picture_role {
    PICTURE_ROCK,          /* terrain */
    PICTURE_SEAM,          /* an internal edge */
    PICTURE_BODY,          /* a body as it was placed */
    PICTURE_TUFF,
    PICTURE_TUFF_OTHER,    /* tuff with another option or build */
    PICTURE_FAILS,
    PICTURE_BOX2D,
    PICTURE_TRUTH,
    PICTURE_ROLES
} picture_role;

/* Begin the picture: the file name without extension, such as "seams". End it with picture_end. False: none is wanted, and what
   is costly to draw may be left out. */
bool picture_begin(const char *name);
void picture_end(void);

/* A panel of shapes that shows this part of the world; or one with axes for curves. A scale is "linear" or "log". */
void picture_panel(const char *title, double left, double bottom, double right, double top);
void picture_chart(const char *title, const char *x_label, const char *x_scale, const char *y_label, const char *y_scale);

/* Into the latest panel. */
void picture_polygon(picture_role role, const tuff_polygon *polygon, tuff_vec2 at);
void picture_piece(const tuff_terrain *piece);                      /* its parts, with internal edges; or its circle */
void picture_circle(picture_role role, tuff_vec2 center, tuff_real radius);
void picture_arrow(picture_role role, double x, double y, double to_x, double to_y);
void picture_dot(picture_role role, double x, double y);
void picture_note(double x, double y, const char *text);

/* A path in a panel, a curve in a chart. label: for the legend; "" for none, NULL is "". Between line and line_end only points. */
void picture_line(picture_role role, const char *label);
void picture_point(double x, double y);
void picture_line_end(void);

/* A line of two points. */
void picture_segment(picture_role role, const char *label, double x, double y, double to_x, double to_y);

#endif
