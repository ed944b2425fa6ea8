/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A segment as an obstacle sees it: what the tests against circles and polygons share. */
#include "inner.h"

tuff_beam tuff_beam_relative(tuff_vec2 a, tuff_vec2 b, tuff_vec2 origin)
{
    bool swap = b.x < a.x || (b.x == a.x && b.y < a.y);
    tuff_vec2 first = tuff_vec2_flush(swap ? b : a);
    tuff_vec2 last = tuff_vec2_flush(swap ? a : b);
    tuff_beam beam;
    beam.a = tuff_far_sub(first, origin);
    beam.b = tuff_far_sub(last, origin);
    beam.d = tuff_far_sub(last, first);
    beam.across = tuff_far_cross(beam.d, beam.a);
    return beam;
}
