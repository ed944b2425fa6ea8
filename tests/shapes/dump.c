/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Prints what a header holds, exactly, as hexadecimal floating point: SHAPES is the header, PIECES a pointer to its pieces, COUNT how
   many there are. A line for each piece, part and vertex. */
#include SHAPES
#include <stdio.h>

#if TUFF_SCALAR == TUFF_FLOAT
static double real(tuff_real value) { return (double)value; }
static double unit(tuff_unit value) { return (double)value; }
#else
static double real(tuff_real value) { return value / 65536.0; }
static double unit(tuff_unit value) { return value / 1073741824.0; }
#endif

static void print_part(const tuff_polygon *part)
{
    int i;
    printf("part %lx\n", (unsigned long)part->internal_edges);
    for (i = 0; i < part->count; ++i) {
        tuff_vec2 v = part->vertices[i];
        tuff_unit2 n = part->normals[i];
        printf("vertex %a %a %a %a\n", real(v.x), real(v.y), unit(n.x), unit(n.y));
    }
}

int main(void)
{
    int i, j;
    for (i = 0; i < COUNT; ++i) {
        const tuff_terrain *piece = &(PIECES)[i];
        printf("piece %a %a %a %a\n", real(piece->position.x), real(piece->position.y), real(piece->radius), real(piece->bounding_radius));
        for (j = 0; j < piece->part_count; ++j) print_part(&piece->parts[j]);
    }
    return 0;
}
