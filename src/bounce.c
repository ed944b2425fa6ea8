/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What a contact does to a body: out by the overlap, then the speed by its material. */
#include "inner.h"

/* The impulse factor 1.09 less 1. */
const tuff_material tuff_default_material = { TUFF_RATIO(109 - 100, 100), TUFF_RATIO(1, 100) };

/* Within 0 .. limit whole units; NaN: 0. */
static tuff_real clamped(tuff_real a, int32_t limit)
{
    if (!(a > TUFF_WHOLE(0))) return TUFF_WHOLE(0);
    return a < TUFF_WHOLE(limit) ? tuff_flush(a) : TUFF_WHOLE(limit);
}

void tuff_bounce(tuff_body *body, const tuff_contact *contact)
{
    TUFF_ASSERT(body != NULL && contact != NULL);
    if (body == NULL || contact == NULL || !(contact->overlap > TUFF_WHOLE(0))) return;
    if (!tuff_position_ok(body->position) || !tuff_velocity_ok(body->velocity) || !tuff_number_ok(contact->overlap)) return;
    if (!tuff_normal_ok(contact->normal)) return;
    const tuff_material *material = body->material != NULL ? body->material : &tuff_default_material;
    body->position.x = tuff_pushed(body->position.x, contact->overlap, contact->normal.x);
    body->position.y = tuff_pushed(body->position.y, contact->overlap, contact->normal.y);
    tuff_reflect(&body->velocity, contact->normal, clamped(material->restitution, TUFF_MAX_RESTITUTION),
                 clamped(material->friction, TUFF_MAX_FRICTION));
}
