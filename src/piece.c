/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A shape against one piece of terrain: bounding circles, then the parts of its outline, or its circle while it is
   not baked. */
#include "inner.h"

/* No part gives a contact of its own: the least outline axis of the overlapped parts, else the least internal axis. */
static void least_way_out(const tuff_terrain *piece, tuff_vec2 offset, tuff_mover *mover, tuff_contact *contact)
{
    bool outline_found = false;
    bool found = false;
    tuff_contact candidate;
    uint8_t i;
    for (i = 0; i < piece->part_count; ++i) {
        if (mover->test(mover, offset, &piece->parts[i], false, &candidate) == TUFF_APART) continue;
        bool outline = mover->test(mover, offset, &piece->parts[i], true, &candidate) != TUFF_APART;
        if (outline_found && !outline) continue;
        if (!found || outline != outline_found || candidate.overlap < contact->overlap) *contact = candidate;
        outline_found = outline;
        found = true;
    }
}

/* The deepest of the contacts by outline edges. A part that overlaps by an internal edge only says that there is
   something to resolve. */
static bool parts_contact(const tuff_terrain *piece, tuff_vec2 offset, tuff_mover *mover, tuff_contact *contact)
{
    bool by_outline = false;
    bool by_internal = false;
    tuff_contact candidate;
    uint8_t i;
    for (i = 0; i < piece->part_count; ++i) {
        tuff_standing standing = mover->test(mover, offset, &piece->parts[i], false, &candidate);
        if (standing == TUFF_BY_INTERNAL) by_internal = true;
        if (standing != TUFF_BY_OUTLINE || (by_outline && candidate.overlap <= contact->overlap)) continue;
        *contact = candidate;
        by_outline = true;
    }
    if (!by_outline && by_internal) least_way_out(piece, offset, mover, contact);
    return by_outline || by_internal;
}

TUFF_HOT bool tuff_piece_contact(const tuff_terrain *piece, tuff_vec2 position, tuff_mover *mover, tuff_contact *contact)
{
    tuff_vec2 offset;
    if (!tuff_is_piece(piece)) return false;
    if (!tuff_offset_within(position, piece->position, piece->bounding_radius + mover->radius, &offset)) return false;
    if (!tuff_piece_baked(piece)) return tuff_circle_circle(offset, mover->radius, piece->radius, contact);
    return parts_contact(piece, offset, mover, contact);
}
