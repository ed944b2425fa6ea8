/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A hull against a piece at world positions. */
#include "inner.h"

bool tuff_terrain_overlap_hull(const tuff_terrain *piece, tuff_vec2 position, tuff_real radius, const tuff_polygon *hull,
                               tuff_contact *contact)
{
    tuff_unit2 scratch[TUFF_MAX_VERTICES];
    tuff_mover mover;
    if (!tuff_is_hull(hull)) return tuff_terrain_overlap_circle(piece, position, radius, contact);
    TUFF_ASSERT(piece != NULL && contact != NULL);
    if (piece == NULL || !tuff_position_ok(position) || !tuff_hull_mover(&mover, radius, hull, scratch)) return false;
    position = tuff_vec2_flush(position);
    return tuff_piece_contact(piece, &position, &mover.shape, contact);
}
