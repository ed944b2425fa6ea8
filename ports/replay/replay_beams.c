/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The golden replay of beams for machines with 2.5 KB of RAM and 32 KB of ROM, where it has no room beside the bodies: beams between
   points that drift among dying rocks for 3,600 steps, and the hash of every answer. */
#include "small_world.h"

/* From a point to the next. */
static void run_beam(uint8_t i)
{
    tuff_beam_hit hit = { 0, { 0, 0 }, 0 };
    tuff_vec2 from = bodies[i].position;
    tuff_vec2 to = bodies[i + 1 == MOVING ? 0 : i + 1].position;
    note(tuff_segment_terrain_intersect(&world, from, to));
    note(tuff_segment_terrain_first_hit(&world, from, to, &hit));
    note((uint32_t)tuff_unit_to_q2_30(hit.fraction) ^ hit.piece);
    note((uint32_t)tuff_unit_to_q2_30(hit.normal.x));
    note((uint32_t)tuff_unit_to_q2_30(hit.normal.y));
    histories[i] = fold(histories[i], (uint32_t)tuff_unit_to_q2_30(hit.fraction) ^ hit.piece);
    trace_hash(histories[i]);
}

int main(void)
{
    uint16_t step;
    uint8_t i;
    begin_world();
    trace_text("beam answer\n");
    for (step = 0; step < STEPS; ++step) {
        edit_world(step);
        for (i = 0; i < MOVING; ++i) move(&bodies[i]);
        for (i = 0; i < MOVING; ++i) run_beam(i);
        end_step();
    }
    print_hash();
    return 0;
}
