/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A shape against one piece of terrain: bounding circles, then the parts of its outline, or its circle while it is
   not baked. */
#include "inner.h"

/* The least outline axis of the parts that overlap by an internal edge, and by more than above; else the least
   internal axis. */
static void least_way_out(const tuff_terrain *piece, tuff_vec2 offset, tuff_mover *mover, tuff_real above, tuff_contact *contact)
{
    bool outline_found = false;
    bool found = false;
    tuff_contact candidate;
    uint8_t i;
    for (i = 0; i < piece->part_count; ++i) {
        tuff_standing standing = mover->test(mover, offset, &piece->parts[i], false, &candidate);
        if (standing != TUFF_BY_INTERNAL || candidate.overlap <= above) continue;
        bool outline = mover->test(mover, offset, &piece->parts[i], true, &candidate) != TUFF_APART;
        if (outline_found && !outline) continue;
        if (!found || outline != outline_found || candidate.overlap < contact->overlap) *contact = candidate;
        outline_found = outline;
        found = true;
    }
}

/* The deepest of the contacts by outline edges; a part that overlaps by an internal edge gives none while another gives
   one. But what an earlier push may have left over decides nothing: as an outline contact it would hold back the way out
   of a body deep inside, as an internal one it would send a body that is out the long way round. No part is overlapped
   deeper than the whole outline, so beside an outline contact of a residue, a part overlapped by clearly more (4: the
   rounding of two axes, doubled) means that the body is inside. */
static bool parts_contact(const tuff_terrain *piece, tuff_vec2 offset, tuff_mover *mover, tuff_real residue, tuff_contact *contact)
{
    tuff_real outline = 0;
    tuff_real internal = 0;
    tuff_contact candidate;
    tuff_contact inner;
    uint8_t i;
    for (i = 0; i < piece->part_count; ++i) {
        tuff_standing standing = mover->test(mover, offset, &piece->parts[i], false, &candidate);
        if (standing == TUFF_BY_INTERNAL && candidate.overlap > internal) {
            inner = candidate;
            internal = candidate.overlap;
        } else if (standing == TUFF_BY_OUTLINE && candidate.overlap > outline) {
            *contact = candidate;
            outline = candidate.overlap;
        }
    }
    tuff_real above = outline > 0 ? 4 * residue : residue;
    if (outline <= residue && internal > above) {
        least_way_out(piece, offset, mover, above, contact);
    } else if (internal > 0 && !(outline > 0)) {
        *contact = inner;
    }
    return outline > 0 || internal > 0;
}

TUFF_HOT bool tuff_piece_contact(const tuff_terrain *piece, tuff_vec2 position, tuff_mover *mover, tuff_contact *contact)
{
    tuff_vec2 offset;
    if (!tuff_is_piece(piece)) return false;
    tuff_real reach = tuff_flush(piece->bounding_radius + mover->radius);
    if (!tuff_offset_within(position, piece->position, reach, &offset)) return false;
    if (!tuff_piece_baked(piece)) return tuff_circle_circle(offset, mover->radius, piece->radius, contact);
    return parts_contact(piece, offset, mover, tuff_residue(position, reach), contact);
}
