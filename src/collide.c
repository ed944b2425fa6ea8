/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The frame call: which pieces are near, which are touched, in which order they push. The only room that knows both the
   index and the shapes. */
#include "inner.h"

/* One push with its report. False: the body is where it was: in float an overlap may be less than a step of the position,
   and trying again would find it again. */
static bool resolve(tuff_collision *call, const tuff_touch *touch)
{
    tuff_vec2 before = call->body->position;
    tuff_touches *touches = call->touches;
    tuff_bounce(call->body, &touch->contact);
    if (touches != NULL) {
        if (touches->list != NULL && touches->count < touches->capacity) touches->list[touches->count] = *touch;
        ++touches->count;
    }
    ++call->pushes;
    call->search.center = tuff_vec2_flush(call->body->position);
    return call->body->position.x != before.x || call->body->position.y != before.y;
}

static bool touch_piece(tuff_collision *call, tuff_touch *touch)
{
    return tuff_piece_contact(&call->search.world->terrain[touch->piece], &call->search.center, call->shape, &touch->contact);
}

/* Each piece on its own. A convex piece is left after one push; the parts of others may need more. */
static bool push_out(tuff_search *search, uint16_t piece)
{
    tuff_collision *call = (tuff_collision *)search;
    tuff_touch touch;
    touch.piece = piece;
    while (touch_piece(call, &touch)) {
        bool moved = resolve(call, &touch);
        if (call->pushes == TUFF_MAX_PUSHES) return false;
        if (!moved || search->world->terrain[piece].part_count < 2) break;
    }
    return true;
}

/* One more piece met in this call; too many are as none. */
static void note_neighbor(tuff_mover *mover, const tuff_terrain *terrain, uint16_t piece)
{
    uint8_t *count = &mover->shape.neighbor_count;
    uint8_t i;
    for (i = 0; i < *count; ++i) {
        if (mover->neighbors[i] == piece) return;
    }
    if (i == TUFF_MOST_NEIGHBORS) *count = TUFF_NO_NEIGHBORS;
    else mover->neighbors[(*count)++] = piece;
    mover->terrain = terrain;
}

/* Does a contact come before another? The deeper, or the lower number. Where a hull meets several pieces, one by an outline edge
   comes before one that had to do without; of the latter the least, as between the parts of a piece. */
static bool comes_first(const tuff_touch *touch, const tuff_touch *best, bool by_outline, bool best_by_outline)
{
    tuff_real overlap = touch->contact.overlap;
    tuff_real least = best->contact.overlap;
    if (by_outline != best_by_outline) return by_outline;
    if (overlap != least) return (overlap > least) == by_outline;
    return touch->piece < best->piece;
}

static bool keep_deepest(tuff_search *search, uint16_t piece)
{
    tuff_collision *call = (tuff_collision *)search;
    tuff_shape *shape = call->shape;
    tuff_touch touch;
    touch.piece = piece;
    shape->by_outline = true;
    if (!touch_piece(call, &touch)) return true;
    if (!shape->seams && shape->neighbor_count != TUFF_NO_NEIGHBORS) note_neighbor((tuff_mover *)shape, search->world->terrain, piece);
    bool by_outline = !shape->seams || shape->by_outline;
    if (call->found && !comes_first(&touch, &call->deepest, by_outline, call->by_outline)) return true;
    call->deepest = touch;
    call->by_outline = by_outline;
    call->found = true;
    return true;
}

/* The deepest contact of all where the body is now; of equal ones the lowest number's. */
static bool scan_for_deepest(tuff_collision *call)
{
    call->found = false;
    tuff_walk_box(&call->search, false);
    return call->found;
}

/* Where a hull has met several pieces in this call, what was found is asked again with their seams in mind. Pieces are noted only
   without: what they tell must not depend on which of them is asked first. */
static bool find_deepest(tuff_collision *call)
{
    tuff_shape *shape = call->shape;
    shape->seams = false;
    bool found = scan_for_deepest(call);
    shape->seams = shape->neighbor_count > 1 && shape->neighbor_count != TUFF_NO_NEIGHBORS;
    return found && shape->seams ? scan_for_deepest(call) : found;
}

/* Not static: merged into tuff_collide its frame would be part of every call in the other order, too. */
void tuff_collide_deepest(tuff_collision *call)
{
    bool moved = true;
    call->search.visit = keep_deepest;
    while (moved && call->pushes < TUFF_MAX_PUSHES && find_deepest(call)) moved = resolve(call, &call->deepest);
}

TUFF_HOT void tuff_collide(tuff_collision *call, const tuff_world *world, tuff_body *body, tuff_touches *touches)
{
    TUFF_ASSERT(world != NULL && body != NULL);
    call->pushes = 0;
    if (world == NULL || world->terrain == NULL || body == NULL) return;
    if (!tuff_position_ok(body->position) || !tuff_velocity_ok(body->velocity)) return;
    call->search.world = world;
    call->search.visit = push_out;
    call->search.center = tuff_vec2_flush(body->position);
    call->search.radius = call->shape->radius;
    call->body = body;
    call->touches = touches;
    if (world->order == TUFF_ORDER_DEEPEST) tuff_collide_deepest(call);
    else tuff_walk_box(&call->search, true);
}
