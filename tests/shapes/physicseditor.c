/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What the template of tools/physicseditor writes for a body of an L in two parts and a circle, and the library's opinion of it.
   EXPORTED is a header with a body called rock. Prints a line for each fault. */
#include EXPORTED
#include <stdio.h>

static uint32_t internal_edges;

int main(void)
{
    tuff_contact contact;
    tuff_vec2 notch = { TUFF_REAL(8.0), TUFF_REAL(-8.0) };
    tuff_vec2 corner = { TUFF_REAL(-8.0), TUFF_REAL(-8.0) };
    uint16_t i;
    tuff_pe_prepare(rock, TUFF_PE_COUNT(rock));
    for (i = 0; i < TUFF_PE_COUNT(rock); ++i) {
        tuff_fault fault = tuff_check_terrain(&rock[i]);
        if (fault != TUFF_OK) puts(tuff_fault_text(fault));
    }
    for (i = 0; i < rock[0].part_count; ++i) internal_edges |= rock[0].parts[i].internal_edges << (8 * i);
    printf("pieces %d parts %d internal %lx\n", TUFF_PE_COUNT(rock), rock[0].part_count, (unsigned long)internal_edges);
    printf("notch %d corner %d circle %d\n", tuff_terrain_overlap_circle(&rock[0], notch, TUFF_REAL(1.0), &contact),
           tuff_terrain_overlap_circle(&rock[0], corner, TUFF_REAL(1.0), &contact),
           tuff_terrain_overlap_circle(&rock[1], rock[1].position, TUFF_REAL(1.0), &contact));
    return 0;
}
