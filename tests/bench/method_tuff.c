/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   tuff's narrow phase; hulls with their normals given. */
#include "tuff/tuff.h"

#define method       TUFF_LINK_NAME(bench_tuff)
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

#include "pair_method.h"

const bench_method method = { "tuff", ADAPT_BUILD, BENCH_MAX_VERTICES, prepare, run, answer, bytes };
