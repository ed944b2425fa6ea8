/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The golden replay for machines with 2.5 KB of RAM: a ship, enemies and shots among drifting and dying rocks for 3,600 steps, and the
   hash of every body and answer. */
#include "small_world.h"

#define FLOATERS 2

static const tuff_vec2 hull_corners[3] = { AT(9, 0), AT(-6, 6), AT(-6, -6) };
static const tuff_polygon hull = { hull_corners, NULL, 0, 3 };
static tuff_terrain floaters[FLOATERS];

/* The ship is the first, then three enemies; the others are shots. */
static void run_body(uint8_t i)
{
    tuff_real radius = i == 0 ? TUFF_WHOLE(9) : i < 4 ? TUFF_WHOLE(6) : TUFF_WHOLE(2);
    const tuff_polygon *shape = i == 0 ? &hull : NULL;
    move(&bodies[i]);
    note(tuff_terrain_collide(&world, &bodies[i], radius, shape));
    note(tuff_floater_collide(&bodies[i], radius, floaters, FLOATERS, shape));
    hash = fold_body(hash, &bodies[i]);
    trace_body(&histories[i], &bodies[i]);
}

int main(void)
{
    uint16_t step;
    uint8_t i;
    begin_world();
    for (i = 0; i < FLOATERS; ++i) floaters[i] = rock_at(i, (int16_t)(i * 100 - 50), 50);
    trace_text("body answer\n");
    for (step = 0; step < STEPS; ++step) {
        edit_world(step);
        for (i = 0; i < FLOATERS; ++i) floaters[i].position.x += step % 512 < 256 ? TUFF_RATIO(1, 8) : -TUFF_RATIO(1, 8);
        for (i = 0; i < MOVING; ++i) run_body(i);
        end_step();
    }
    print_hash();
    return 0;
}
