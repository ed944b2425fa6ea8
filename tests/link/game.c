/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A game of one file: a ball falls on a rock and must have been pushed out of it. Linked with the library of its own
   build, and of the other. */
#include <tuff/tuff.h>

int main(void)
{
    static const tuff_terrain rock = { { TUFF_WHOLE(100), TUFF_WHOLE(100) }, TUFF_WHOLE(10), TUFF_WHOLE(10), NULL, 0 };
    const tuff_world world = { &rock, 1, NULL, NULL, 0, TUFF_ORDER_ITERATION };
    tuff_body ball = { { TUFF_WHOLE(100), TUFF_WHOLE(89) }, { 0, TUFF_WHOLE(1) }, NULL };
    uint16_t pushes = tuff_terrain_collide(&world, &ball, TUFF_WHOLE(2), NULL);
    return pushes == 1 && ball.position.y == TUFF_WHOLE(88) && ball.velocity.y < 0 ? 0 : 1;
}
