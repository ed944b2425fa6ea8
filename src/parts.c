/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The rule for the parts of a piece: which of the contacts with them leads out of the whole outline. */
#include "inner.h"

/* The least outline axis of the parts that overlap by an internal edge, and by more than above; else the least internal axis
   that leads away from the piece's position: each such push takes the shape farther from there, never to and fro between inner
   parts. */
static void least_way_out(tuff_shape *shape, tuff_real above, tuff_contact *candidate, tuff_contact *contact)
{
    const tuff_polygon *part = shape->piece->parts;
    const tuff_polygon *end = part + shape->piece->part_count;
    tuff_standing best = TUFF_APART;
    for (; part != end; ++part) {
        tuff_standing standing = shape->test(shape, part, TUFF_SKIP_NONE, candidate);
        if (standing != TUFF_BY_INTERNAL || candidate->overlap <= above) continue;
        if (shape->test(shape, part, TUFF_SKIP_INTERNAL, candidate) != TUFF_APART) standing = TUFF_BY_OUTLINE;
        else if (best != TUFF_BY_OUTLINE) (void)shape->test(shape, part, TUFF_SKIP_BACK, candidate);
        else continue;
        if (best != standing || candidate->overlap < contact->overlap) *contact = *candidate;
        best = standing;
    }
}

/* The deepest of the contacts by outline edges; a part that overlaps by an internal edge gives none while another gives
   one. But what an earlier push may have left over decides nothing: as an outline contact it would hold back the way out
   of a body deep inside; as an internal one it would send a body that is out the long way round, so it is left by an
   outline axis if that is hardly farther, and otherwise, where seams between pieces matter, waits. No part is overlapped
   deeper than the whole outline, so beside an outline contact of a residue, a part overlapped by clearly more (4: the
   rounding of two axes, doubled) means that the body is inside. */
TUFF_HOT bool tuff_parts_contact(tuff_shape *shape, tuff_real residue, tuff_contact *contact)
{
    const tuff_polygon *part = shape->piece->parts;
    const tuff_polygon *end = part + shape->piece->part_count;
    tuff_real outline = 0;
    tuff_real internal = 0;
    tuff_contact candidate;
    tuff_contact inner;
    for (; part != end; ++part) {
        tuff_standing standing = shape->test(shape, part, TUFF_SKIP_NONE, &candidate);
        if (standing == TUFF_BY_INTERNAL && candidate.overlap > internal) {
            inner = candidate;
            internal = candidate.overlap;
        } else if (standing == TUFF_BY_OUTLINE && candidate.overlap > outline) {
            *contact = candidate;
            outline = candidate.overlap;
        }
    }
    if (outline > residue) return true;

    shape->by_outline = false;
    tuff_real above = outline > 0 ? 4 * residue : residue;
    if (internal > above) {
        least_way_out(shape, above, &candidate, contact);
    } else if (internal > 0 && !(outline > 0)) {
        least_way_out(shape, 0, &candidate, contact);
        if (contact->overlap > 4 * residue && shape->seams) return false;
        if (contact->overlap > 4 * residue) *contact = inner;
    }
    return outline > 0 || internal > 0;
}
