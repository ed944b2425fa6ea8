/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The textbook's tests; the normals of hulls are given here, too, which the game it comes from makes anew at each call.
   For the files that measure a narrow phase: pair_method.h here, method_body.h of ports/bench. */
#ifndef TUFF_BENCH_TEXTBOOK_TESTS_H
#define TUFF_BENCH_TEXTBOOK_TESTS_H

#include "textbook.h"

#define hits_circle  textbook_circle
#define hits_hull    textbook_hull
#define hits_segment textbook_segment

typedef textbook_polygon polygon_type;
typedef tuff_vec2 normal_type;
typedef textbook_contact contact_type;

static polygon_type polygon_of(tuff_vec2 *corners, normal_type *outward, int count)
{
    textbook_normals(corners, count, outward);
    return (polygon_type){ corners, outward, count };
}

#endif
