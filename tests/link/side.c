/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   One build's half of a program that holds both: compiled once for each, with a name of its own each time. */
#include <tuff/tuff.h>

#define push_in_q16_16 TUFF_LINK_NAME(side_push_in_q16_16)

int32_t push_in_q16_16(void);

/* How far a ball of radius 2 is pushed out of a rock of radius 10, with its center 11.5 units away. */
int32_t push_in_q16_16(void)
{
    const tuff_vec2 center = { TUFF_RATIO(23, 2), 0 };
    tuff_contact contact;
    if (!tuff_circle_circle(center, TUFF_WHOLE(2), TUFF_WHOLE(10), &contact)) return 0;
    return tuff_to_q16_16(contact.overlap);
}
