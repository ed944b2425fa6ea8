/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Where does a beam enter what it hits first? Each piece that the exact test finds hit is asked for its point of entry. */
#include "inner.h"

/* A directed beam relative to a piece, and the earliest entry found in it. */
typedef struct tuff_entry {
    tuff_far2 a, b;
    tuff_far2 d;
    tuff_unit  fraction;
    tuff_unit2 normal;
    bool       internal;      /* the normal is an internal edge's */
    bool       found;
} tuff_entry;

static tuff_unit2 against(tuff_far2 d)
{
    tuff_unit2 plus_x = { TUFF_UNIT_ONE, 0 };
    return d.x == 0 && d.y == 0 ? plus_x : tuff_unit2_negate(tuff_far_direction(d));
}

/* A beam from outside meets an outline edge before any internal one, whatever rounding makes of their fractions. */
static void keep_earliest(tuff_entry *entry, tuff_unit fraction, tuff_unit2 normal, bool internal)
{
    bool better = entry->internal != internal ? entry->internal : fraction < entry->fraction;
    if (entry->found && !better) return;
    entry->fraction = fraction;
    entry->normal = normal;
    entry->internal = internal;
    entry->found = true;
}

/* The edge that is entered last (Cyrus and Beck); of those entered at once an outline edge. A start outside of no
   edge is inside. */
static void enter_part(tuff_entry *entry, const tuff_polygon *polygon)
{
    const tuff_area seam = tuff_seam_margin(entry->d);
    const bool forward = tuff_turns_forward(polygon);
    tuff_area outside_last = 0;
    tuff_area travel_last = 1;
    uint8_t edge = TUFF_MAX_VERTICES;
    uint8_t i;
    for (i = 0; i < polygon->count; ++i) {
        tuff_area outside = tuff_edge_outside(polygon, i, forward, entry->a);
        tuff_area travel = tuff_area_sub(outside, tuff_edge_outside(polygon, i, forward, entry->b));
        if (outside <= (tuff_edge_is_internal(polygon, i) ? seam : 0)) continue;
        if (travel < outside) travel = outside;     /* b is within the margin of a seam */
        bool later = edge == TUFF_MAX_VERTICES || tuff_ratio_less(outside_last, travel_last, outside, travel);
        bool better = !later && tuff_edge_is_internal(polygon, edge) && !tuff_ratio_less(outside, travel, outside_last, travel_last);
        if (!later && !better) continue;
        outside_last = outside;
        travel_last = travel;
        edge = i;
    }
    if (edge == TUFF_MAX_VERTICES) {
        keep_earliest(entry, 0, against(entry->d), false);
    } else {
        keep_earliest(entry, tuff_ratio(outside_last, travel_last), polygon->normals[edge], tuff_edge_is_internal(polygon, edge));
    }
}

static void enter_circle(tuff_entry *entry, tuff_real radius)
{
    tuff_unit2 normal = against(entry->d);
    tuff_unit fraction = 0;
    if (!tuff_far_inside(entry->a, radius)) {
        fraction = tuff_circle_entry(entry->a, entry->d, radius);
        (void)tuff_normalize(tuff_along(entry->a, entry->d, fraction), &normal);
    }
    keep_earliest(entry, fraction, normal, false);
}

/* Of a piece that beam, the same segment with its ends in order, is known to touch. */
static tuff_entry enter_piece(const tuff_terrain *piece, tuff_vec2 a, tuff_vec2 b, const tuff_beam *beam)
{
    tuff_entry entry = {
        tuff_far_sub(a, piece->position), tuff_far_sub(b, piece->position), tuff_far_sub(b, a), 0, { 0, 0 }, false, false
    };
    uint8_t i;
    if (!tuff_piece_baked(piece)) {
        enter_circle(&entry, tuff_flush(piece->radius));
        return entry;
    }
    for (i = 0; i < piece->part_count; ++i) {
        if (tuff_beam_touches_part(beam, &piece->parts[i])) enter_part(&entry, &piece->parts[i]);
    }
    return entry;
}

bool tuff_segment_terrain_first_hit(const tuff_world *world, tuff_vec2 a, tuff_vec2 b, tuff_beam_hit *hit)
{
    uint16_t piece;
    uint16_t first = TUFF_NO_PIECE;
    tuff_beam beam;
    tuff_walk walk;
    TUFF_ASSERT(world != NULL && hit != NULL);
    if (world == NULL || world->terrain == NULL || !tuff_beam_ends_ok(a, b)) return false;
    a = tuff_vec2_flush(a);
    b = tuff_vec2_flush(b);
    tuff_walk_line(&walk, world, a, b);
    while ((piece = tuff_walk_next(&walk)) != TUFF_NO_PIECE) {
        const tuff_terrain *terrain = &world->terrain[piece];
        if (!tuff_beam_touches_piece(terrain, a, b, &beam)) continue;
        tuff_entry entry = enter_piece(terrain, a, b, &beam);
        bool later = first != TUFF_NO_PIECE &&
                     (entry.fraction > hit->fraction || (entry.fraction == hit->fraction && piece > first));
        if (later) continue;
        first = piece;
        hit->fraction = entry.fraction;
        hit->normal = entry.normal;
        hit->piece = piece;
    }
    return first != TUFF_NO_PIECE;
}
