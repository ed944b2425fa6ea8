/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A shape against one piece of terrain: bounding circles, then the parts of its outline (parts.c), or its circle while it is
   not baked. */
#include "inner.h"

/* A piece of one part leaves nothing to choose, but for what an earlier push left over and for a side that a neighbor covers. */
static inline bool baked_contact(tuff_shape *shape, tuff_real residue, tuff_contact *contact)
{
    const tuff_terrain *piece = shape->piece;
    if (piece->part_count == 1) {
        tuff_standing standing = shape->test(shape, piece->parts, TUFF_SKIP_NONE, contact);
        if (standing == TUFF_APART) return false;
        if (standing == TUFF_BY_OUTLINE && contact->overlap > residue) return true;
    }
    return tuff_parts_contact(shape, residue, contact);
}

TUFF_HOT bool tuff_piece_contact(const tuff_terrain *piece, const tuff_vec2 *position, tuff_shape *shape, tuff_contact *contact)
{
    if (!tuff_is_piece(piece)) return false;
    tuff_real reach = tuff_flush(piece->bounding_radius + shape->radius);
    if (!tuff_offset_within(*position, piece->position, reach, &shape->offset)) return false;
    if (!tuff_piece_baked(piece)) return tuff_circle_circle(shape->offset, shape->radius, piece->radius, contact);
    shape->piece = piece;
    return baked_contact(shape, tuff_residue(*position, reach), contact);
}
