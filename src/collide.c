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

/* The deepest contact of all where the body is now; of equal ones the lowest number's. */
static bool find_deepest(const tuff_world *world, const tuff_body *body, tuff_mover *mover, tuff_touch *deepest)
{
    bool found = false;
    tuff_touch touch;
    tuff_walk walk;
    tuff_walk_box(&walk, world, body->position, mover->radius, false);
    while ((touch.piece = tuff_walk_next(&walk)) != TUFF_NO_PIECE) {
        if (!touch_piece(world, body, mover, &touch)) continue;
        bool deeper = !found || touch.contact.overlap > deepest->contact.overlap;
        if (deeper || (touch.contact.overlap == deepest->contact.overlap && touch.piece < deepest->piece)) *deepest = touch;
        found = true;
    }
    return found;
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
