/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   tuff's shapes and bodies handed to Box2D: to the yardstick's engine, and to the bare narrow phase of tests/host/box2d_shim.h.
   Terrain is without friction. */
#ifndef TUFF_STABILITY_HANDED_H
#define TUFF_STABILITY_HANDED_H

#include "twin.h"
#include "yardstick.h"

yardstick_vec yard_vec(tuff_vec2 v);
yardstick_state yard_state(const tuff_body *body);

/* Every part of the piece. False: Box2D does not take one of them; those before it were added. */
bool yard_add_piece(yardstick *yard, const tuff_terrain *piece);

/* The body's number, or -1. */
int yard_add_hull(yardstick *yard, yardstick_state state, const tuff_polygon *hull, yardstick_material material);

/* For the narrow phase; NULL: Box2D does not take it. Free it with box2d_polygon_free. */
box2d_polygon *box2d_of(const tuff_polygon *polygon);

#endif
