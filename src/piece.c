/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A shape against one piece of terrain: bounding circles, then the parts of its outline (parts.c), or its circle while it is
   not baked. */
#include "inner.h"

TUFF_HOT bool tuff_piece_contact(const tuff_terrain *piece, tuff_vec2 position, tuff_mover *mover, tuff_contact *contact)
{
    tuff_vec2 offset;
    if (!tuff_is_piece(piece)) return false;
    tuff_real reach = tuff_flush(piece->bounding_radius + mover->radius);
    if (!tuff_offset_within(position, piece->position, reach, &offset)) return false;
    if (!tuff_piece_baked(piece)) return tuff_circle_circle(offset, mover->radius, piece->radius, contact);
    return tuff_parts_contact(piece, offset, mover, tuff_residue(position, reach), contact);
}
