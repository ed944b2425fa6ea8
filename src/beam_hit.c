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

static void keep_earliest(tuff_entry *entry, tuff_unit fraction, tuff_unit2 normal, bool internal)
{
    bool earlier = !entry->found || fraction < entry->fraction;
    if (!earlier && !(fraction == entry->fraction && entry->internal && !internal)) return;
    entry->fraction = fraction;
    entry->normal = normal;
    entry->internal = internal;
    entry->found = true;
}

/* The edge that is entered last (Cyrus and Beck); of those entered at once an outline edge. A start outside of no edge is inside. */
static void enter_part(tuff_entry *entry, const tuff_polygon *polygon)
{
    bool forward = tuff_goes_forward(polygon);
    tuff_area outside_last = 0;
    tuff_area travel_last = 1;
    uint8_t edge = TUFF_MAX_VERTICES;
    uint8_t i;
    for (i = 0; i < polygon->count; ++i) {
        uint8_t next = tuff_next_index(i, polygon->count);
        tuff_vec2 from = polygon->vertices[forward ? i : next];
        tuff_vec2 to = polygon->vertices[forward ? next : i];
        tuff_area outside = -tuff_edge_side(entry->a, from, to);
        tuff_area travel = outside + tuff_edge_side(entry->b, from, to);
        if (outside <= 0 || travel < outside) continue;
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

static void enter_piece(tuff_entry *entry, const tuff_terrain *piece, const tuff_beam *beam)
{
    uint8_t i;
    if (!tuff_piece_baked(piece)) {
        enter_circle(entry, tuff_flush(piece->radius));
        return;
    }
    for (i = 0; i < piece->part_count; ++i) {
        if (tuff_beam_touches_part(beam, &piece->parts[i])) enter_part(entry, &piece->parts[i]);
    }
}

bool tuff_segment_terrain_first_hit(const tuff_world *world, tuff_vec2 a, tuff_vec2 b, tuff_beam_hit *hit)
{
    uint16_t piece;
    uint16_t first = TUFF_NO_PIECE;
    tuff_beam beam;
    tuff_walk walk;
    if (world == NULL || world->terrain == NULL || !tuff_beam_ends_ok(a, b)) return false;
    a = tuff_vec2_flush(a);
    b = tuff_vec2_flush(b);
    tuff_walk_line(&walk, world, a, b);
    while ((piece = tuff_walk_next(&walk)) != TUFF_NO_PIECE) {
        const tuff_terrain *terrain = &world->terrain[piece];
        if (!tuff_beam_touches_piece(terrain, a, b, &beam)) continue;
        tuff_entry entry = { tuff_far_sub(a, terrain->position), tuff_far_sub(b, terrain->position), tuff_far_sub(b, a), 0, { 0, 0 }, false, false };
        enter_piece(&entry, terrain, &beam);
        if (first != TUFF_NO_PIECE && (entry.fraction > hit->fraction || (entry.fraction == hit->fraction && piece > first))) continue;
        first = piece;
        hit->fraction = entry.fraction;
        hit->normal = entry.normal;
        hit->piece = piece;
    }
    return first != TUFF_NO_PIECE;
}
