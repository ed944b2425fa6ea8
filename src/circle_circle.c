/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Circle against circle: the fallback for pieces that are not baked. */
#include "inner.h"

bool tuff_circle_circle(tuff_vec2 center, tuff_real radius, tuff_real obstacle_radius, tuff_contact *contact)
{
    const tuff_vec2 origin = { TUFF_WHOLE(0), TUFF_WHOLE(0) };
    tuff_unit2 normal = { TUFF_UNIT_ONE, 0 };
    tuff_vec2 offset;
    TUFF_ASSERT(contact != NULL);
    if (!tuff_in_range(radius, TUFF_MAX_BOUNDING_RADIUS) || !tuff_in_range(obstacle_radius, TUFF_MAX_BOUNDING_RADIUS)) return false;

    tuff_real reach = tuff_flush(radius) + tuff_flush(obstacle_radius);
    if (!tuff_offset_within(tuff_vec2_flush(center), origin, reach, &offset)) return false;
    tuff_real overlap = reach - tuff_normalize(offset, &normal);
    if (!(overlap > TUFF_WHOLE(0))) return false;
    contact->overlap = overlap;
    contact->normal = normal;
    return true;
}
