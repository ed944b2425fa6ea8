/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What the families' scenes have in common: pieces of one convex shape, worlds without an index, bodies that fall freely. */
#ifndef TUFF_STABILITY_PIECES_H
#define TUFF_STABILITY_PIECES_H

#include "random.h"

#define TURN 6.283185307179586      /* once round, in radians */
#define GRID 1024                   /* steps of a unit that both builds and Box2D hold alike */

/* The nearest point of the grid; x and y in units. And the next number of the grid that is not above these units. */
tuff_vec2 grid_point(double x, double y);
double grid_floor(double units);

/* A piece of this one part; it points into the shape. */
tuff_terrain convex_piece(const random_shape *shape, tuff_vec2 at);

/* These pieces, with no index and no room for a nearby query. */
tuff_world plain_world(const tuff_terrain *pieces, uint16_t count, uint8_t order);

/* At rest, of tuff's default material. */
tuff_body body_at(tuff_vec2 position);

/* A game's free step: the velocity changes by gravity, then the position by the velocity. */
void body_fall(tuff_body *body, tuff_vec2 gravity);

/* In units, and in units a step. */
double units_apart(tuff_vec2 a, tuff_vec2 b);
double body_speed(const tuff_body *body);

/* 0 of nothing. */
double percent(unsigned long part, unsigned long whole);

#endif
