/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Segment against circle: either end inside, or the line passes near enough between the ends. Exact in the fixed build. */
#include "inner.h"

bool tuff_beam_touches_circle(const tuff_beam *beam, tuff_real radius)
{
    if (tuff_far_inside(&beam->a, radius) || tuff_far_inside(&beam->b, radius)) return true;
    if (tuff_far_dot(&beam->d, &beam->a) >= 0 || tuff_far_dot(&beam->d, &beam->b) <= 0) return false;
    return tuff_chord_reaches(tuff_line_across(&beam->d, &beam->a, &beam->b), &beam->d, radius);
}

bool tuff_segment_circle(tuff_vec2 a, tuff_vec2 b, tuff_real radius)
{
    if (!tuff_in_range(radius, TUFF_MAX_BOUNDING_RADIUS) || !tuff_beam_ends_ok(a, b)) return false;
    tuff_beam beam;
    tuff_beam_between(&beam, a, b);
    return tuff_beam_touches_circle(&beam, tuff_flush(radius));
}
