/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The calls of a frame. None changes terrain or index. A NULL world, body or terrain array, a body with NaN,
   infinity or (float build) a number beyond its limit, a radius that is negative or too large: nothing happens and
   the answer is 0 or false. */
#ifndef TUFF_WORLD_H
#define TUFF_WORLD_H

#include "chunks.h"
#include "shapes.h"

#ifdef __cplusplus
extern "C" {
#endif

/* TUFF_ORDER_ITERATION: each piece on its own: chunk rows by ascending y, then x, within a chunk as inserted (pieces
   larger than a chunk last); without an index by ascending number. The cheapest.

   TUFF_ORDER_DEEPEST: the deepest contact of all first (ties: the lowest number), and all again after each push.
   Costs at least one more pass; does not snag on flush seams and does not depend on the order of insertion. A hull that
   has met 2 .. 8 pieces in the call is not pushed off a side that another of them covers, nor off a corner that another
   rises from; it costs one more pass. */
enum { TUFF_ORDER_ITERATION = 0, TUFF_ORDER_DEEPEST = 1 };

/* Plain data, all of it the caller's. All zero: an empty world. */
typedef struct tuff_world {
    const tuff_terrain *terrain;    /* the pieces, empty slots among them */
    uint16_t     terrain_count;     /* to TUFF_MAX_PIECES */
    tuff_chunks *chunks;            /* NULL, or nothing inserted since it was cleared: linear scan */
    uint16_t    *nearby;            /* what tuff_nearby_terrain fills; may be NULL */
    uint16_t     nearby_capacity;
    uint8_t      order;             /* TUFF_ORDER_... */
} tuff_world;

/* One push of a collide call. */
typedef struct tuff_touch {
    uint16_t     piece;             /* index into the terrain or floater array */
    tuff_contact contact;
} tuff_touch;

/* The report of a collide call: one touch a push, in order. */
typedef struct tuff_touches {
    tuff_touch *list;
    uint16_t    capacity;
    uint16_t    count;              /* set by the call; may exceed capacity: the list holds what fits */
} tuff_touches;

/* Where a beam is stopped. */
typedef struct tuff_beam_hit {
    tuff_unit  fraction;            /* 0 .. 1 of the way from a to b */
    tuff_unit2 normal;              /* of the piece; a start inside: fraction 0, normal against the beam (+x if it has no length) */
    uint16_t   piece;               /* ties: the lowest */
} tuff_beam_hit;

/* Clear the index and insert every piece of the world's array. Returns how many could not be inserted (0: all is well,
   or there is no index). */
uint16_t tuff_world_index(tuff_world *world);

/* Push the body out of the obstacle by overlap * normal (saturating at the edge of the range); then, if it moves
   inwards (v . n < 0), reflect the velocity by its material. Fixed build: v . n is kept in 64 bits, each new
   component is rounded toward zero, so that restitution up to 1 never adds energy. Speeds are clamped to
   TUFF_MAX_SPEED, material values to their limits. */
void tuff_bounce(tuff_body *body, const tuff_contact *contact);

/* Keep a body out of the terrain: push it out of each piece that it overlaps, and bounce. Returns the number of
   pushes, at most TUFF_MAX_PUSHES; 0: none. A push too small to move the body (float, far from the origin) is the
   last one. hull NULL or with fewer than 3 vertices: the circle. radius covers the hull. A hull without normals has
   them made once a call, and only if some piece's bounding circle is reached. */
uint16_t tuff_terrain_collide(const tuff_world *world, tuff_body *body, tuff_real radius, const tuff_polygon *hull);
uint16_t tuff_terrain_collide_circle(const tuff_world *world, tuff_body *body, tuff_real radius);
uint16_t tuff_terrain_collide_report(const tuff_world *world, tuff_body *body, tuff_real radius, const tuff_polygon *hull,
                                     tuff_touches *touches);

/* The same against an array of the caller's, in ascending order; no index. */
uint16_t tuff_floater_collide(tuff_body *body, tuff_real radius, const tuff_terrain *floaters, uint16_t count,
                              const tuff_polygon *hull);
uint16_t tuff_floater_collide_circle(tuff_body *body, tuff_real radius, const tuff_terrain *floaters, uint16_t count);
uint16_t tuff_floater_collide_report(tuff_body *body, tuff_real radius, const tuff_terrain *floaters, uint16_t count,
                                     const tuff_polygon *hull, uint8_t order, tuff_touches *touches);

/* In how many equal steps must a body make this motion, with a collide call after each, so that it gets over no piece?
   1 for a slow one; never more than needed.

     count = tuff_substeps(ship.velocity, TUFF_REAL(8), TUFF_REAL(6));
     for (i = 0; i < count; ++i) {
         ship.position.x += ship.velocity.x / count;
         ship.position.y += ship.velocity.y / count;
         tuff_terrain_collide(&world, &ship, TUFF_REAL(12), &hull);
     }

   radius: the circle's; of a hull the radius of a circle inside it, tuff_polygon_thickness(&hull) / 2. thickness: of the
   thinnest piece, tuff_polygon_thickness of its one part, or twice the radius of its circle.

   A step may be as long as radius + thickness / 2, less 4 LSB (fixed) or 2^-8 units (float) for what a push leaves over,
   but need not be shorter than radius. Why: let the center's straight path lead over a point c, thickness / 2 inside a convex
   piece, so that c is radius + thickness / 2 from the nearest way out for the body. The body begins outside, and from
   there it is no farther into the piece than it has moved, while it has at least that far to go to any side that lies
   ahead until it has come to c. So the nearest way out never leads on ahead, and a longer step may end beyond c, where it
   does; one of more than 2 * radius + thickness may not meet the piece at all.

   What the promise leaves out: paths that come nowhere thickness / 2 deep may cut a corner. With thickness 0 there are
   none: the center then enters no piece. That is the number to give for pieces of several parts, too: a center that lies
   within one part may find the way out of that part alone. The body must begin outside, and a restitution above 1 makes
   steps longer while they are made.

   At most 65535, which a radius and thickness near 0 reach: a point is kept out by no number of steps, but by
   tuff_segment_terrain_first_hit from where it was to where it is. Negative or too large numbers, NaN, and motions
   beyond TUFF_MAX_POSITION: 1, as the collide calls do nothing with them either. */
uint16_t tuff_substeps(tuff_vec2 motion, tuff_real radius, tuff_real thickness);

/* The diameter of a circle inside a convex polygon: the one about the mean of its vertices. A box's lesser side; of a
   triangle two thirds of its least height. Normals are not needed. 0: no polygon, or none with an area. */
tuff_real tuff_polygon_thickness(const tuff_polygon *polygon);

/* Is anything between a and b? Touching counts. Stops at the first piece found. */
bool tuff_segment_terrain_intersect(const tuff_world *world, tuff_vec2 a, tuff_vec2 b);

/* What does a beam from a to b hit first? False: nothing, *hit is untouched. The point of the hit is within 2 LSB +
   length * 2^-28 (fixed) of the polygon's edge or the circle's surface that it lies on. */
bool tuff_segment_terrain_first_hit(const tuff_world *world, tuff_vec2 a, tuff_vec2 b, tuff_beam_hit *hit);

/* Which pieces' bounding circles overlap or touch this circle? Exactly those, each once. Indices go to
   world->nearby; the count needed is returned: read at most the lesser of it and world->nearby_capacity. radius: 0
   or more, any. */
uint16_t tuff_nearby_terrain(tuff_world *world, tuff_vec2 center, tuff_real radius);

#ifdef __cplusplus
}
#endif

#endif
