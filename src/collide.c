/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The frame call: which pieces are near, which are touched, in which order they push. The only room that knows both the
   index and the shapes. */
#include "inner.h"

/* One push with its report. False: the body is where it was: in float an overlap may be less than a step of the position,
   and trying again would find it again. */
static bool resolve(tuff_body *body, const tuff_touch *touch, tuff_touches *touches)
{
    tuff_vec2 before = body->position;
    tuff_bounce(body, &touch->contact);
    if (touches != NULL) {
        if (touches->list != NULL && touches->count < touches->capacity) touches->list[touches->count] = *touch;
        ++touches->count;
    }
    return body->position.x != before.x || body->position.y != before.y;
}

static bool touch_piece(const tuff_world *world, const tuff_body *body, tuff_mover *mover, tuff_touch *touch)
{
    return tuff_piece_contact(&world->terrain[touch->piece], tuff_vec2_flush(body->position), mover, &touch->contact);
}

/* Each piece on its own. A convex piece is left after one push; the parts of others may need more. */
static uint16_t collide_in_turn(const tuff_world *world, tuff_body *body, tuff_mover *mover, tuff_touches *touches)
{
    uint16_t pushes = 0;
    tuff_touch touch;
    tuff_walk walk;
    tuff_walk_box(&walk, world, body->position, mover->radius, true);
    while ((touch.piece = tuff_walk_next(&walk)) != TUFF_NO_PIECE) {
        while (touch_piece(world, body, mover, &touch)) {
            bool moved = resolve(body, &touch, touches);
            if (++pushes == TUFF_MAX_PUSHES) return pushes;
            if (!moved || world->terrain[touch.piece].part_count < 2) break;
        }
    }
    return pushes;
}

/* One more piece met in this call; too many are as none. */
static void note_neighbor(tuff_mover *mover, const tuff_terrain *piece)
{
    uint8_t i;
    for (i = 0; i < mover->neighbor_count; ++i) {
        if (mover->neighbors[i] == piece) return;
    }
    if (i == TUFF_MOST_NEIGHBORS) mover->neighbor_count = TUFF_NO_NEIGHBORS;
    else mover->neighbors[mover->neighbor_count++] = piece;
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

/* The deepest contact of all where the body is now; of equal ones the lowest number's. */
static bool scan_for_deepest(const tuff_world *world, const tuff_body *body, tuff_mover *mover, tuff_touch *deepest)
{
    bool found = false;
    bool found_by_outline = false;
    tuff_touch touch;
    tuff_walk walk;
    tuff_walk_box(&walk, world, body->position, mover->radius, false);
    while ((touch.piece = tuff_walk_next(&walk)) != TUFF_NO_PIECE) {
        mover->by_outline = true;
        if (!touch_piece(world, body, mover, &touch)) continue;
        if (!mover->seams && mover->neighbor_count != TUFF_NO_NEIGHBORS) note_neighbor(mover, &world->terrain[touch.piece]);
        bool by_outline = !mover->seams || mover->by_outline;
        if (found && !comes_first(&touch, deepest, by_outline, found_by_outline)) continue;
        *deepest = touch;
        found_by_outline = by_outline;
        found = true;
    }
    return found;
}

/* Where a hull has met several pieces in this call, what was found is asked again with their seams in mind. Pieces are noted only
   without: what they tell must not depend on which of them is asked first. */
static bool find_deepest(const tuff_world *world, const tuff_body *body, tuff_mover *mover, tuff_touch *deepest)
{
    mover->seams = false;
    bool found = scan_for_deepest(world, body, mover, deepest);
    mover->seams = mover->neighbor_count > 1 && mover->neighbor_count != TUFF_NO_NEIGHBORS;
    return found && mover->seams ? scan_for_deepest(world, body, mover, deepest) : found;
}

static uint16_t collide_deepest_first(const tuff_world *world, tuff_body *body, tuff_mover *mover, tuff_touches *touches)
{
    uint16_t pushes = 0;
    bool moved = true;
    tuff_touch touch;
    while (moved && pushes < TUFF_MAX_PUSHES && find_deepest(world, body, mover, &touch)) {
        moved = resolve(body, &touch, touches);
        ++pushes;
    }
    return pushes;
}

uint16_t tuff_collide(const tuff_world *world, tuff_body *body, tuff_mover *mover, tuff_touches *touches)
{
    TUFF_ASSERT(world != NULL && body != NULL);
    if (touches != NULL) touches->count = 0;
    if (world == NULL || world->terrain == NULL || body == NULL) return 0;
    if (!tuff_position_ok(body->position) || !tuff_velocity_ok(body->velocity)) return 0;
    if (world->order == TUFF_ORDER_DEEPEST) return collide_deepest_first(world, body, mover, touches);
    return collide_in_turn(world, body, mover, touches);
}
