/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   tuff's narrow phase; hulls with their normals given.
   For the files that measure a narrow phase: pair_method.h here, method_body.h of ports/bench. */
#ifndef TUFF_BENCH_TUFF_TESTS_H
#define TUFF_BENCH_TUFF_TESTS_H

#include "tuff/tuff.h"

#define hits_circle  tuff_circle_polygon
#define hits_hull    tuff_polygon_polygon
#define hits_segment tuff_segment_polygon

typedef tuff_polygon polygon_type;
typedef tuff_unit2 normal_type;
typedef tuff_contact contact_type;

static polygon_type polygon_of(tuff_vec2 *corners, normal_type *outward, int count)
{
    tuff_edge_normals(corners, (uint8_t)count, outward);
    return (polygon_type){ corners, outward, 0, (uint8_t)count };
}

#endif
