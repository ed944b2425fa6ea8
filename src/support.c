/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   How far a polygon reaches along an axis; and what is long enough to be there once. */
#include "inner.h"

TUFF_HOT uint8_t tuff_least_along(const tuff_polygon *polygon, tuff_unit2 axis)
{
    return (uint8_t)(tuff_nearest_along(polygon, axis) - polygon->vertices);
}

tuff_wide tuff_reach(tuff_unit2 axis, tuff_vec2 point)
{
    return tuff_project(axis, point);
}

bool tuff_has_outline(const tuff_terrain *piece)
{
    return tuff_piece_baked(piece);
}
