/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   One build's scene behind a table of functions that speak in plain integers; one table for float, one for Q16.16. */
#ifndef DEMO_SIDE_H
#define DEMO_SIDE_H

#include <stddef.h>
#include <stdint.h>

#include "../scene/marks.h"

typedef struct side {
    void        (*start)(uint32_t seed);
    void        (*step)(uint16_t buttons);
    uint16_t    (*pilot)(void);
    void        (*draw)(const scene_view *view, scene_emit emit, void *context);
    uint32_t    (*hash)(uint32_t before);
    void        (*count)(scene_counts *counts);
    void        (*events)(uint16_t events[SCENE_EVENTS]);
    void        (*ship)(int32_t at[2]);            /* Q16.16 */
    const char *(*fault)(uint16_t *number);        /* NULL: none */
    size_t      bytes;                             /* of the scene's state */
} side;

extern const side tuff_float_side, tuff_q16_side;

#endif
