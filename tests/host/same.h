/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Results compared bit for bit, in both builds: the same call on the same input is the same arithmetic. */
#ifndef TUFF_TESTS_SAME_H
#define TUFF_TESTS_SAME_H

#include "tuff/tuff.h"

static inline bool same_point(tuff_vec2 a, tuff_vec2 b)
{
    return a.x == b.x && a.y == b.y;
}

static inline bool same_normal(tuff_unit2 a, tuff_unit2 b)
{
    return a.x == b.x && a.y == b.y;
}

static inline bool same_overlap(const tuff_contact *a, const tuff_contact *b)
{
    return a->overlap == b->overlap && same_normal(a->normal, b->normal);
}

static inline bool same_touch(const tuff_touch *a, const tuff_touch *b)
{
    return a->piece == b->piece && same_overlap(&a->contact, &b->contact);
}

static inline bool same_body(const tuff_body *a, const tuff_body *b)
{
    return same_point(a->position, b->position) && same_point(a->velocity, b->velocity) && a->material == b->material;
}

#endif
