/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Where does a beam enter what it hits first? Each piece that the exact test finds hit is asked for its point of entry. */
#include "inner.h"

/* A beam from outside meets an outline edge before any internal one, whatever rounding makes of their fractions. */
static void keep_earliest(tuff_entry *entry, tuff_unit fraction, const tuff_unit2 *normal, bool internal)
{
    bool better = entry->internal != internal ? entry->internal : fraction < entry->fraction;
    if (entry->found && !better) return;
    entry->fraction = fraction;
    entry->normal = *normal;
    entry->internal = internal;
    entry->found = true;
}

/* At the start, which is inside. */
static void enter_at_once(tuff_entry *entry, const tuff_beam *beam)
{
    tuff_unit2 against = { TUFF_UNIT_ONE, 0 };
    if (beam->d.x != 0 || beam->d.y != 0) against = tuff_unit2_negate(tuff_far_direction(&beam->d));
    keep_earliest(entry, 0, &against, false);
}

/* The edge that is entered last (Cyrus and Beck); of those entered at once an outline edge. A start outside of no
   edge is inside. Not static: merged into its caller its frame would be there while the piece is tested, too. */
void tuff_beam_enter_part(tuff_entry *entry, const tuff_beam *beam, const tuff_polygon *polygon)
{
    const tuff_area seam = tuff_seam_margin(&beam->d);
    const bool forward = tuff_turns_forward(polygon);
    tuff_ratio_of last = { 0, 1 };
    uint8_t edge = TUFF_MAX_VERTICES;
    uint8_t i;
    for (i = 0; i < polygon->count; ++i) {
        tuff_ratio_of here;
        here.part = tuff_edge_outside(polygon, i, forward, &beam->a);
        if (here.part <= (tuff_edge_is_internal(polygon, i) ? seam : 0)) continue;
        here.whole = tuff_area_sub(here.part, tuff_edge_outside(polygon, i, forward, &beam->b));
        if (here.whole < here.part) here.whole = here.part;     /* b is within the margin of a seam */
        bool later = edge == TUFF_MAX_VERTICES || tuff_ratio_less(&last, &here);
        if (!later && (!tuff_edge_is_internal(polygon, edge) || tuff_ratio_less(&here, &last))) continue;
        last = here;
        edge = i;
    }
    if (edge == TUFF_MAX_VERTICES) {
        enter_at_once(entry, beam);
    } else {
        keep_earliest(entry, tuff_ratio(last.part, last.whole), &polygon->normals[edge], tuff_edge_is_internal(polygon, edge));
    }
}

static void enter_circle(tuff_entry *entry, const tuff_beam *beam, tuff_real radius)
{
    enter_at_once(entry, beam);
    if (tuff_far_inside(&beam->a, radius)) return;
    entry->fraction = tuff_circle_entry(&beam->a, &beam->d, radius);
    (void)tuff_normalize(tuff_along(&beam->a, &beam->d, entry->fraction), &entry->normal);
}

/* Of a piece that the beam is known to touch, and with it its part if it has but one. */
static void enter_piece(tuff_entry *entry, const tuff_beam *beam, const tuff_terrain *piece)
{
    static const tuff_entry none = { 0, { 0, 0 }, false, false };
    uint8_t i;
    *entry = none;
    if (!tuff_has_outline(piece)) {
        enter_circle(entry, beam, tuff_flush(piece->radius));
        return;
    }
    for (i = 0; i < piece->part_count; ++i) {
        const tuff_polygon *part = &piece->parts[i];
        if (piece->part_count == 1 || tuff_beam_touches_parts(beam, part, 1)) tuff_beam_enter_part(entry, beam, part);
    }
}

typedef struct first_hit { tuff_line_search walk; tuff_beam beam; tuff_vec2 a, b; tuff_beam_hit *hit; bool found; } first_hit;

static bool keep_first(tuff_search *search, uint16_t piece)
{
    first_hit *first = (first_hit *)search;
    tuff_beam_hit *hit = first->hit;
    const tuff_terrain *terrain = &search->world->terrain[piece];
    tuff_entry entry;
    if (!tuff_beam_aim(&first->beam, terrain, &first->a, &first->b) || !tuff_beam_touches_piece(&first->beam, terrain)) return true;
    enter_piece(&entry, &first->beam, terrain);
    if (first->found && (entry.fraction > hit->fraction || (entry.fraction == hit->fraction && piece > hit->piece))) return true;
    first->found = true;
    hit->fraction = entry.fraction;
    hit->normal = entry.normal;
    hit->piece = piece;
    return true;
}

bool tuff_segment_terrain_first_hit(const tuff_world *world, tuff_vec2 a, tuff_vec2 b, tuff_beam_hit *hit)
{
    first_hit first;
    TUFF_ASSERT(world != NULL && hit != NULL);
    if (world == NULL || world->terrain == NULL || !tuff_beam_ends_ok(a, b)) return false;
    first.walk.visit = keep_first;
    first.a = tuff_vec2_flush(a);
    first.b = tuff_vec2_flush(b);
    first.beam.d = tuff_far_sub(first.b, first.a);
    first.hit = hit;
    first.found = false;
    tuff_walk_line(&first.walk, world, first.a, first.b);
    return first.found;
}
