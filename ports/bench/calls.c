/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The counted calls. */
#include "calls.h"

#include "count.h"

void count_bounce(tuff_body *body, const tuff_contact *contact)
{
    count_begin();
    tuff_bounce(body, contact);
    count_end();
}

uint16_t count_nearby(tuff_world *world, tuff_vec2 center, tuff_real radius)
{
    count_begin();
    uint16_t found = tuff_nearby_terrain(world, center, radius);
    count_end();
    return found;
}

uint16_t count_collide(const tuff_world *world, tuff_body *body, tuff_real radius)
{
    count_begin();
    uint16_t pushes = tuff_terrain_collide_circle(world, body, radius);
    count_end();
    return pushes;
}

bool count_beam(const tuff_world *world, tuff_vec2 a, tuff_vec2 b)
{
    count_begin();
    bool hit = tuff_segment_terrain_intersect(world, a, b);
    count_end();
    return hit;
}

uint16_t count_frame(const tuff_world *world, calls_frame *frame, const tuff_real *radii, const tuff_polygon *hull)
{
    uint16_t hits;
    count_begin();
    hits = tuff_terrain_collide(world, &frame->bodies[0], radii[0], hull);
    for (int i = 1; i < BENCH_BODIES; i++) hits = (uint16_t)(hits + tuff_terrain_collide_circle(world, &frame->bodies[i], radii[i]));
    for (int i = 0; i < BENCH_BEAMS; i++) {
        hits = (uint16_t)(hits + tuff_segment_terrain_intersect(world, frame->beams[i][0], frame->beams[i][1]));
    }
    count_end();
    return hits;
}
