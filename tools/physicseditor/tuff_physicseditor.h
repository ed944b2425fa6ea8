/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What the headers include that PhysicsEditor exports. C99 only: compound literals hold the arrays, so that the template needs to
   count nothing. What the template cannot compute (normals, inner edges, bounding radii) is made once at the start of the game;
   the arrays therefore lie in RAM. */
#ifndef TUFF_PHYSICSEDITOR_H
#define TUFF_PHYSICSEDITOR_H

#include <tuff/tuff.h>

#define TUFF_PE_COUNT(array) ((uint16_t)(sizeof(array) / sizeof((array)[0])))

/* Arguments end with a comma: initializers may. */
#define TUFF_PE_POINT(x, y)    { TUFF_REAL(x), TUFF_REAL(y) }
#define TUFF_PE_VERTICES(...)  ((const tuff_vec2[]){ __VA_ARGS__ })
#define TUFF_PE_PART(...) \
    { TUFF_PE_VERTICES(__VA_ARGS__), (tuff_unit2[TUFF_PE_COUNT(TUFF_PE_VERTICES(__VA_ARGS__))]){ { 0, 0 } }, 0, \
      (uint8_t)TUFF_PE_COUNT(TUFF_PE_VERTICES(__VA_ARGS__)) }
#define TUFF_PE_PARTS(...)     ((tuff_polygon[]){ __VA_ARGS__ })
#define TUFF_PE_OUTLINE(...) \
    { { 0, 0 }, 0, 0, TUFF_PE_PARTS(__VA_ARGS__), (uint8_t)TUFF_PE_COUNT(TUFF_PE_PARTS(__VA_ARGS__)) }
#define TUFF_PE_CIRCLE(x, y, radius) { TUFF_PE_POINT(x, y), TUFF_REAL(radius), TUFF_REAL(radius), NULL, 0 }

static inline bool tuff_pe_same(tuff_vec2 a, tuff_vec2 b) { return a.x == b.x && a.y == b.y; }

/* Has another part of the piece the edge from a to b, ends swapped? */
static inline bool tuff_pe_is_internal(const tuff_terrain *piece, const tuff_polygon *part, tuff_vec2 a, tuff_vec2 b)
{
    uint8_t i, j;
    for (i = 0; i < piece->part_count; ++i) {
        const tuff_polygon *other = &piece->parts[i];
        for (j = 0; other != part && j < other->count; ++j) {
            tuff_vec2 next = other->vertices[j + 1 < other->count ? j + 1 : 0];
            if (tuff_pe_same(other->vertices[j], b) && tuff_pe_same(next, a)) return true;
        }
    }
    return false;
}

/* No less than the length of v, and at most 9 % more: the longer component and sqrt(2) - 1 of the shorter. */
static inline tuff_real tuff_pe_reach(tuff_vec2 v)
{
    tuff_real x = v.x < 0 ? -v.x : v.x;
    tuff_real y = v.y < 0 ? -v.y : v.y;
    return (x < y ? y : x) + tuff_scale(x < y ? x : y, TUFF_UNIT(0.41422)) + TUFF_REAL_RAW(1);
}

static inline void tuff_pe_prepare_part(tuff_terrain *piece, tuff_polygon *part)
{
    uint8_t i;
    tuff_edge_normals(part->vertices, part->count, (tuff_unit2 *)part->normals);
    for (i = 0; i < part->count; ++i) {
        tuff_vec2 next = part->vertices[i + 1 < part->count ? i + 1 : 0];
        tuff_real reach = tuff_pe_reach(part->vertices[i]);
        if (tuff_pe_is_internal(piece, part, part->vertices[i], next)) part->internal_edges |= (uint32_t)1 << i;
        if (reach > piece->bounding_radius) piece->bounding_radius = reach;
    }
}

/* Completes an exported array. */
static inline void tuff_pe_prepare(tuff_terrain *pieces, uint16_t count)
{
    uint16_t i;
    uint8_t j;
    for (i = 0; i < count; ++i) {
        for (j = 0; j < pieces[i].part_count; ++j) tuff_pe_prepare_part(&pieces[i], (tuff_polygon *)&pieces[i].parts[j]);
    }
}

#endif
