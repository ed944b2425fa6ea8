/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A circle against a piece at world positions. */
#include "inner.h"

bool tuff_terrain_overlap_circle(const tuff_terrain *piece, tuff_vec2 center, tuff_real radius, tuff_contact *contact)
{
    tuff_shape shape;
    TUFF_ASSERT(piece != NULL && contact != NULL);
    if (piece == NULL || !tuff_position_ok(center) || !tuff_circle_shape(&shape, radius)) return false;
    center = tuff_vec2_flush(center);
    return tuff_piece_contact(piece, &center, &shape, contact);
}
