/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The separating-axis tests as the textbooks and the game that tuff comes from have them: all vertices of both shapes projected on every
   normal, for a circle also on the axis from the nearest vertex (left out within 0.1 unit of it); a segment against each edge, and the
   parity of the edges beside its start. In float, and in plain Q16.16: normals of 16 bits, products
   narrowed one by one but for those of which only the sign is wanted. */
#ifndef TUFF_BENCH_TEXTBOOK_H
#define TUFF_BENCH_TEXTBOOK_H

#include "tuff/tuff.h"

#define textbook_circle   TUFF_LINK_NAME(textbook_circle)
#define textbook_hull     TUFF_LINK_NAME(textbook_hull)
#define textbook_segment  TUFF_LINK_NAME(textbook_segment)
#define textbook_normals  TUFF_LINK_NAME(textbook_normals)
#define textbook_bounce   TUFF_LINK_NAME(textbook_bounce)

typedef struct textbook_polygon {
    const tuff_vec2 *vertices, *normals;
    int count;
} textbook_polygon;

typedef struct textbook_contact { tuff_real overlap; tuff_vec2 normal; } textbook_contact;

/* Positions relative to the polygon. */
bool textbook_circle(tuff_vec2 center, tuff_real radius, const textbook_polygon *polygon, textbook_contact *contact);
bool textbook_hull(const textbook_polygon *hull, tuff_vec2 offset, const textbook_polygon *polygon, textbook_contact *contact);
bool textbook_segment(tuff_vec2 a, tuff_vec2 b, const textbook_polygon *polygon);

/* The exact normals, rounded to a tuff_real. */
void textbook_normals(const tuff_vec2 *vertices, int count, tuff_vec2 *normals);

/* Out by the overlap; if it moves inwards, the velocity's normal part times -0.09 and the rest times 0.99. */
void textbook_bounce(tuff_body *body, const textbook_contact *contact);

#endif
