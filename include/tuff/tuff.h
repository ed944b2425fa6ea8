/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   tuff ("terrain collision using fixed or float"): keeps a game's ships, enemies and shots out of its asteroids.

   Conventions
     Units      world units, such as pixels; speeds in units a step. y grows the way the game says.
     Numbers    tuff_real and tuff_unit: float, or Q16.16 and Q2.30, chosen by -DTUFF_SCALAR=TUFF_FLOAT or
                -DTUFF_SCALAR=TUFF_Q16_16 (config.h). Write TUFF_REAL(12.5); convert with tuff_from_... and tuff_to_....
     Ranges     shapes.h, TUFF_MAX_...: vertices within 1024 units of their owner, positions anywhere within 32,768.
     Memory     the caller's, all of it. The library keeps nothing between calls and allocates nothing.
     Zero       a zeroed tuff_terrain is an empty slot, a zeroed tuff_world an empty world, a zeroed index an empty index.
     NULL       a world, body, hull or terrain array that is NULL: no contact. Bad numbers: no contact, body unchanged.
     Misuse     never reads out of bounds, loops for ever or divides by zero; TUFF_ASSERT may stop at it in a debug build; the
                calls of check.h name it.
     Threads    no shared state: calls on different bodies may run at once while nobody edits terrain or index.

   A frame of a game:

     static const tuff_terrain rocks[] = { ... };
     static tuff_world world = { rocks, 40, &chunks, NULL, 0, TUFF_ORDER_ITERATION };

     tuff_world_index(&world);                                   // once
     ...
     ship.position.x += ship.velocity.x;                         // every step
     ship.position.y += ship.velocity.y;
     if (tuff_terrain_collide(&world, &ship, TUFF_REAL(8), &ship_hull)) play_thud();

   Where the numbers break down. A body that moves farther in a step than it and a piece are thick jumps over the
   piece: there is no swept motion; tuff_substeps tells in how many steps to move it. Float positions lose digits far
   from the origin: at 16,384 units a step of position is 0.002. Q16.16 does not, but stops at 32,768. */
#ifndef TUFF_TUFF_H
#define TUFF_TUFF_H

#define TUFF_VERSION_MAJOR 0
#define TUFF_VERSION_MINOR 1
#define TUFF_VERSION_PATCH 0

#include "check.h"
#include "chunks.h"
#include "convert.h"
#include "narrow.h"
#include "scalar.h"
#include "shapes.h"
#include "world.h"

#endif
