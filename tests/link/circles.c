/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A game that has only circles: nothing of hulls, beams or the checks may come along. */
#include <tuff/tuff.h>

int main(void)
{
    static const tuff_terrain rock = { { 0, 0 }, TUFF_WHOLE(10), TUFF_WHOLE(10), NULL, 0 };
    tuff_world world = { &rock, 1, NULL, NULL, 0, TUFF_ORDER_ITERATION };
    tuff_body ball = { { TUFF_WHOLE(12), 0 }, { 0, 0 }, NULL };
    return tuff_terrain_collide_circle(&world, &ball, TUFF_WHOLE(4)) == 1 ? 0 : 1;
}
