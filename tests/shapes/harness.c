/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A game that includes a header made by the tool and asks the library what it hits. Compiled with SHAPES, the header; SHAPE and
   MACRO, the name of its shapes in small and capital letters; and one of OF_FRAMES, OF_MAP, OF_ISLANDS for what the header holds (none: a
   single piece). Prints a line for each piece, 0 or the text of its fault, and then a 0 or 1 for each line of the input:
   "frame x y radius", a circle about a point of the picture, in 1/65536 units to the right of and below the upper left corner. */
#include SHAPES
#include <stdio.h>

#define JOIN(a, b)  a##b
#define NAMED(a, b) JOIN(a, b)

#if defined OF_FRAMES
#define PIECES        SHAPE
#define COUNT         NAMED(MACRO, _COUNT)
#define FIRST(frame)  NAMED(SHAPE, _first)[frame]
#define ORIGIN(frame) NAMED(SHAPE, _origins)[frame]
#elif defined OF_MAP
#define PIECES        SHAPE
#define COUNT         NAMED(MACRO, _COUNT)
#elif defined OF_ISLANDS
#define PIECES        SHAPE
#define COUNT         NAMED(MACRO, _COUNT)
static const tuff_vec2 origin = { NAMED(MACRO, _ORIGIN_X), NAMED(MACRO, _ORIGIN_Y) };
#define ORIGIN(frame) origin
#else
#define PIECES        (&SHAPE)
#define COUNT         1
static const tuff_vec2 origin = { NAMED(MACRO, _ORIGIN_X), NAMED(MACRO, _ORIGIN_Y) };
#define ORIGIN(frame) origin
#endif

#ifndef FIRST
#define FIRST(frame) ((frame) * COUNT)
#endif
#ifndef ORIGIN
static const tuff_vec2 corner;
#define ORIGIN(frame) corner
#endif
#ifdef Y_UP
#define UP(y) (-(y))
#else
#define UP(y) (y)
#endif

/* What the index of the whole array says, with the pitch that the header advises. */
static uint16_t buckets[1024];
static tuff_chunk_entry entries[COUNT];
static tuff_chunks chunks = TUFF_CHUNKS(buckets, entries, NAMED(MACRO, _PITCH_LOG2));
static tuff_world world = { PIECES, COUNT, &chunks, NULL, 0, TUFF_ORDER_ITERATION };

static bool hits(int frame, tuff_vec2 center, tuff_real radius)
{
    tuff_contact contact;
    int i;
    for (i = FIRST(frame); i < FIRST(frame + 1); ++i) {
        if (tuff_terrain_overlap_circle(&PIECES[i], center, radius, &contact)) return true;
    }
    return false;
}

static void print_fault(tuff_fault fault)
{
    puts(fault == TUFF_OK ? "0" : tuff_fault_text(fault));
}

int main(void)
{
    int frame;
    long x, y, radius;
    int i;
    for (i = 0; i < COUNT; ++i) print_fault(tuff_check_terrain(&PIECES[i]));
    if (tuff_world_index(&world) != 0) puts("not indexed");
    print_fault(tuff_check_world(&world, NULL));
    while (scanf("%d %ld %ld %ld", &frame, &x, &y, &radius) == 4) {
        tuff_vec2 origin_of_frame = ORIGIN(frame);
        tuff_vec2 center = { tuff_real_from_fixed((int32_t)x, 16) - origin_of_frame.x,
                             UP(tuff_real_from_fixed((int32_t)y, 16) - origin_of_frame.y) };
        putchar(hits(frame, center, tuff_real_from_fixed((int32_t)radius, 16)) ? '1' : '0');
    }
    putchar('\n');
    return 0;
}
