/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The contracts between the rooms of src/. */
#ifndef TUFF_INNER_H
#define TUFF_INNER_H

#include "tuff/tuff.h"
#include "arith.h"

#define tuff_reach               TUFF_LINK_NAME(reach)
#define tuff_has_outline         TUFF_LINK_NAME(has_outline)
#define tuff_least_along         TUFF_LINK_NAME(least_along)
#define tuff_circle_part         TUFF_LINK_NAME(circle_part)
#define tuff_hull_part           TUFF_LINK_NAME(hull_part)
#define tuff_hull_mover          TUFF_LINK_NAME(hull_mover)
#define tuff_piece_contact       TUFF_LINK_NAME(piece_contact)
#define tuff_parts_contact       TUFF_LINK_NAME(parts_contact)
#define tuff_corner_is_internal  TUFF_LINK_NAME(corner_is_internal)
#define tuff_between_parts       TUFF_LINK_NAME(between_parts)
#define tuff_edge_beside         TUFF_LINK_NAME(edge_beside)
#define tuff_edge_buried         TUFF_LINK_NAME(edge_buried)
#define tuff_collide             TUFF_LINK_NAME(collide)
#define tuff_collide_deepest     TUFF_LINK_NAME(collide_deepest)
#define tuff_beam_aim            TUFF_LINK_NAME(beam_aim)
#define tuff_beam_touches_parts  TUFF_LINK_NAME(beam_touches_parts)
#define tuff_beam_touches_circle TUFF_LINK_NAME(beam_touches_circle)
#define tuff_beam_touches_piece  TUFF_LINK_NAME(beam_touches_piece)
#define tuff_beam_enter_part     TUFF_LINK_NAME(beam_enter_part)
#define tuff_walk_box            TUFF_LINK_NAME(walk_box)
#define tuff_walk_line           TUFF_LINK_NAME(walk_line)
#define tuff_walk_area           TUFF_LINK_NAME(walk_area)
#define tuff_walk_with_large     TUFF_LINK_NAME(walk_with_large)
#define tuff_walk_numbers        TUFF_LINK_NAME(walk_numbers)

/* --- shapes ------------------------------------------------------------------------------------------------ */

/* Has this polygon what an obstacle needs? */
static inline bool tuff_baked(const tuff_polygon *polygon)
{
    return polygon->count >= 3 && polygon->count <= TUFF_MAX_VERTICES && polygon->vertices != NULL && polygon->normals != NULL;
}

static inline bool tuff_is_hull(const tuff_polygon *hull)
{
    return hull != NULL && hull->count >= 3 && hull->count <= TUFF_MAX_VERTICES && hull->vertices != NULL;
}

/* Is every part of the piece baked, and is there one? */
static inline bool tuff_piece_baked(const tuff_terrain *piece)
{
    uint8_t i;
    if (piece->parts == NULL || piece->part_count == 0) return false;
    for (i = 0; i < piece->part_count; ++i) {
        if (!tuff_baked(&piece->parts[i])) return false;
    }
    return true;
}

static inline bool tuff_edge_is_internal(const tuff_polygon *polygon, uint32_t edge)
{
    return (polygon->internal_edges >> edge & 1u) != 0;
}

/* Would a push along the normal lead a shape at this offset nearer to its piece's position? */
static inline bool tuff_leads_back(tuff_unit2 normal, tuff_vec2 offset)
{
    return tuff_project(normal, offset) < 0;
}

static inline uint8_t tuff_next_index(uint8_t i, uint8_t count)     { return (uint8_t)(i + 1 == count ? 0 : i + 1); }
static inline uint8_t tuff_previous_index(uint8_t i, uint8_t count) { return (uint8_t)(i == 0 ? count - 1 : i - 1); }

/* How far a point lies beyond the line of an edge. */
static inline tuff_wide tuff_beyond_edge(const tuff_polygon *polygon, uint32_t edge, tuff_vec2 point)
{
    return tuff_project(polygon->normals[edge], tuff_vec2_sub(point, polygon->vertices[edge]));
}

/* tuff_project and tuff_piece_baked where they are asked so rarely that their size counts more. */
tuff_wide tuff_reach(tuff_unit2 axis, tuff_vec2 point);
bool tuff_has_outline(const tuff_terrain *piece);

/* The vertex that lies least far along an axis, the first of equals: where a call costs too much, and its number. Selections: which way a
   branch would go is as good as random. */
static inline const tuff_vec2 *tuff_nearest_along(const tuff_polygon *polygon, tuff_unit2 axis)
{
    const tuff_vec2 *v = polygon->vertices;
    const tuff_vec2 *end = v + polygon->count;
    const tuff_vec2 *nearest = v;
    tuff_wide least = tuff_project(axis, *v);
    while (++v != end) {
        tuff_wide projection = tuff_project(axis, *v);
        nearest = projection < least ? v : nearest;
        least = projection < least ? projection : least;
    }
    return nearest;
}

TUFF_HOT uint8_t tuff_least_along(const tuff_polygon *polygon, tuff_unit2 axis);

/* Is this slot of the terrain array a piece? */
static inline bool tuff_is_piece(const tuff_terrain *piece)
{
    return piece->bounding_radius > TUFF_WHOLE(0) && piece->bounding_radius <= TUFF_WHOLE(TUFF_MAX_BOUNDING_RADIUS);
}

/* A number within 0 .. limit whole units; false for NaN. */
static inline bool tuff_in_range(tuff_real a, int32_t limit)
{
    return a >= TUFF_WHOLE(0) && a <= TUFF_WHOLE(limit);
}

/* --- contacts ---------------------------------------------------------------------------------------------- */

/* How a shape stands to one convex part: apart, or overlapping with its least axis an outline edge's or an internal
   edge's. */
typedef enum tuff_standing { TUFF_APART, TUFF_BY_OUTLINE, TUFF_BY_INTERNAL } tuff_standing;

typedef struct tuff_shape tuff_shape;

/* Which axes are no way out: those of internal edges; those that lead back to the piece's position. */
typedef enum tuff_skipped { TUFF_SKIP_NONE, TUFF_SKIP_INTERNAL, TUFF_SKIP_BACK } tuff_skipped;

/* Shape, where it is now, against part. If axes are skipped the shape is known to overlap, and the contact is the one along the
   least of the others; TUFF_APART: there is none. */
typedef tuff_standing tuff_part_test(tuff_shape *shape, const tuff_polygon *part, tuff_skipped skipped, tuff_contact *contact);

/* The shape that moves: a circle, or the first member of a hull's. The function pointer keeps hull code out of a game that has only
   circles. */
struct tuff_shape {
    tuff_part_test *test;
    tuff_real       radius;        /* of the circle, or of the circle about the hull */
    const tuff_terrain *piece;     /* whose parts are tested; NULL: a part of no piece */
    tuff_vec2       offset;        /* from there */
    uint8_t         neighbor_count;
    bool            seams;         /* the neighbors matter now */
    bool            by_outline;    /* made false by a contact with a piece that is by no outline edge, or a residue */
};

#define TUFF_MOST_NEIGHBORS 8     /* pieces whose seams a hull minds; it rarely meets more than three */
#define TUFF_NO_NEIGHBORS   255   /* as a count: seams between pieces do not matter, or there are too many */

/* A hull on its way. */
typedef struct tuff_mover {
    tuff_shape      shape;
    tuff_polygon    hull;          /* normals NULL: not needed yet */
    tuff_unit2     *scratch;       /* where they go then */
    const tuff_terrain *terrain;
    uint16_t        neighbors[TUFF_MOST_NEIGHBORS];    /* pieces of it met in this call */
} tuff_mover;

/* Has the outline of all parts, at this vertex of a part, no normal along the axis? The vertex is the part's farthest that way. */
bool tuff_between_parts(const tuff_mover *mover, const tuff_polygon *part, uint8_t vertex, tuff_unit2 axis);

/* The same of the outline of all parts and neighbors. */
bool tuff_corner_is_internal(const tuff_mover *mover, const tuff_polygon *part, uint8_t vertex, tuff_unit2 axis);

/* Is the hull wholly beyond an end of the edge, on the side where an internal edge goes on? */
bool tuff_edge_beside(const tuff_mover *mover, const tuff_polygon *part, uint8_t edge);

/* Does a neighbor cover the edge where the hull is? */
bool tuff_edge_buried(const tuff_mover *mover, const tuff_polygon *part, uint8_t edge);

TUFF_HOT tuff_part_test tuff_circle_part;
TUFF_HOT tuff_part_test tuff_hull_part;

/* Fill in a shape, a mover. False: a radius out of range. For tuff_hull_mover hull must be one (tuff_is_hull), scratch has
   its count of normals. */
static inline bool tuff_circle_shape(tuff_shape *shape, tuff_real radius)
{
    shape->test = tuff_circle_part;
    shape->seams = false;
    shape->neighbor_count = TUFF_NO_NEIGHBORS;
    TUFF_ASSERT(tuff_in_range(radius, TUFF_MAX_BOUNDING_RADIUS));
    shape->radius = tuff_flush(radius);
    return tuff_in_range(radius, TUFF_MAX_BOUNDING_RADIUS);
}

bool tuff_hull_mover(tuff_mover *mover, tuff_real radius, const tuff_polygon *hull, tuff_unit2 *scratch);

/* The contact of a shape with a piece, by the rule for parts. */
TUFF_HOT bool tuff_piece_contact(const tuff_terrain *piece, const tuff_vec2 *position, tuff_shape *shape, tuff_contact *contact);

/* The same with the parts of a baked piece whose bounding circle is reached: the shape knows which, and at which offset. residue: what an
   earlier push may have left of an overlap. */
TUFF_HOT bool tuff_parts_contact(tuff_shape *shape, tuff_real residue, tuff_contact *contact);

/* --- searches ---------------------------------------------------------------------------------------------- */

/* A rectangle of chunks: x and y of its first and its last. */
typedef struct tuff_chunk_area { int32_t low[2], high[2]; } tuff_chunk_area;

typedef struct tuff_search tuff_search;

/* Called for each piece of a walk, once. False: enough. */
typedef bool tuff_visit(tuff_search *search, uint16_t piece);

/* What a walk goes by. The first member of whatever else the visitor needs. */
struct tuff_search {
    const tuff_world *world;
    tuff_visit *visit;
    tuff_vec2   center;     /* flushed; of a box. Where it is by now: the visitor may change it, the walk's chunks stay */
    tuff_real   radius;
    tuff_chunk_area area;   /* the walk's own */
};

/* The frame call behind all collide calls. */
typedef struct tuff_collision {
    tuff_search    search;
    tuff_body     *body;
    tuff_touches  *touches;        /* may be NULL */
    tuff_shape    *shape;
    uint16_t       pushes;
    bool           found, by_outline;
    tuff_touch     deepest;        /* if found; by_outline: how, as in the shape */
} tuff_collision;

/* The shape is filled in. The pushes are in *call. */
TUFF_HOT void tuff_collide(tuff_collision *call, const tuff_world *world, tuff_body *body, tuff_touches *touches);

/* The same in the order TUFF_ORDER_DEEPEST; the body is in *call, too. */
void tuff_collide_deepest(tuff_collision *call);

/* --- beams ------------------------------------------------------------------------------------------------- */

/* A segment with ends relative to an obstacle. With the ends swapped, d changes its sign and nothing else. */
typedef struct tuff_beam {
    tuff_far2 a, b;
    tuff_far2 d;         /* b - a, the same for all obstacles */
} tuff_beam;

/* False: an end is out of range. */
static inline bool tuff_beam_ends_ok(tuff_vec2 a, tuff_vec2 b)
{
    return tuff_position_ok(a) && tuff_position_ok(b);
}

/* Flushed ends; d stays. */
static inline void tuff_beam_relative(tuff_beam *beam, tuff_vec2 a, tuff_vec2 b, tuff_vec2 origin)
{
    beam->a = tuff_far_sub(a, origin);
    beam->b = tuff_far_sub(b, origin);
}

/* About an obstacle at the origin. */
static inline void tuff_beam_between(tuff_beam *beam, tuff_vec2 a, tuff_vec2 b)
{
    const tuff_vec2 origin = { TUFF_WHOLE(0), TUFF_WHOLE(0) };
    tuff_vec2 first = tuff_vec2_flush(a);
    tuff_vec2 last = tuff_vec2_flush(b);
    beam->d = tuff_far_sub(last, first);
    tuff_beam_relative(beam, first, last, origin);
}

/* Does the segment touch one of the closed polygons (baked), the closed disc about the origin? */
TUFF_HOT bool tuff_beam_touches_parts(const tuff_beam *beam, const tuff_polygon *parts, uint8_t count);
bool tuff_beam_touches_circle(const tuff_beam *beam, tuff_real radius);

/* Make the beam, whose d is there, the segment (flushed) relative to the piece. False: there is none, or the segment passes its
   bounding circle by far. */
TUFF_HOT bool tuff_beam_aim(tuff_beam *beam, const tuff_terrain *piece, const tuff_vec2 *a, const tuff_vec2 *b);

/* The earliest entry found in a piece. */
typedef struct tuff_entry {
    tuff_unit  fraction;
    tuff_unit2 normal;
    bool       internal;      /* the normal is an internal edge's */
    bool       found;
} tuff_entry;

/* Note where the beam enters a part that it touches. */
void tuff_beam_enter_part(tuff_entry *entry, const tuff_beam *beam, const tuff_polygon *polygon);

/* Does the segment touch the piece at which it was aimed? */
bool tuff_beam_touches_piece(const tuff_beam *beam, const tuff_terrain *piece);

/* --- the index --------------------------------------------------------------------------------------------- */

#define TUFF_NO_PIECE 65535   /* no number of a piece: TUFF_MAX_PIECES is less */
#define TUFF_LIST_END 65535   /* ends a list; a link is a piece's number + 1, and 0 in an empty bucket ends it too */

/* Bucket of a chunk. Along a row neighbors are neighbors; rows are spread by the golden ratio of 2^16. */
static inline uint32_t tuff_row_hash(int32_t y)
{
    return (uint32_t)y * 40503u;
}

static inline uint16_t tuff_bucket(const tuff_chunks *chunks, int32_t x, int32_t y)
{
    uint32_t hash = (uint32_t)x + tuff_row_hash(y);
    return (uint16_t)(hash & (uint32_t)(chunks->bucket_count - 1));
}

static inline bool tuff_link_valid(const tuff_chunks *chunks, uint16_t link)
{
    return link != 0 && link <= chunks->capacity && link != TUFF_LIST_END;
}

/* Has the index storage, and was something inserted? */
static inline bool tuff_index_in_use(const tuff_chunks *chunks)
{
    return chunks != NULL && chunks->used && chunks->buckets != NULL && chunks->entries != NULL && chunks->bucket_count != 0;
}

static inline uint16_t tuff_pitch(const tuff_chunks *chunks)
{
    return chunks->pitch_log2 < TUFF_MAX_PITCH_LOG2 ? chunks->pitch_log2 : TUFF_MAX_PITCH_LOG2;
}

/* Chunk of a coordinate in whole units. No piece lies in chunks beyond the ends of the range. */
static inline int32_t tuff_chunk_of(const tuff_chunks *chunks, int32_t units)
{
    int32_t last = (int32_t)TUFF_MAX_POSITION - 1;
    return (units > last ? last : units < -last - 1 ? -last - 1 : units) >> tuff_pitch(chunks);
}

/* Pieces whose square about the bounding circle touches the square about the circle. ordered: chunk rows by ascending y, then x;
   otherwise in any order. */
TUFF_HOT void tuff_walk_box(tuff_search *search, bool ordered);

/* A line in whole units, by ascending major, the axis along which it is longer. */
typedef struct tuff_track {
    int32_t first, last;            /* its ends along major */
    int32_t minor;                  /* of the first end */
    int32_t slope;                  /* minor by major, Q14, -1 .. 1: times a length of 2^16 it fits 32 bits */
    int32_t secant;                 /* how much farther than square to the line something lies along minor: the part above 1, Q14 */
    int32_t slack;
    unsigned axis;                  /* major is x: 0, y: 1 */
} tuff_track;

/* What a walk along a line goes by. The first member of whatever else the visitor needs. */
typedef struct tuff_line_search {
    tuff_search search;             /* the walk's own, as the line */
    tuff_visit *visit;
    tuff_track  line;
} tuff_line_search;

/* Pieces whose bounding circle may touch the segment from a to b, in any order. */
TUFF_HOT void tuff_walk_line(tuff_line_search *walk, const tuff_world *world, tuff_vec2 a, tuff_vec2 b);

/* Parts of those walks. False: the visitor has had enough. All pieces in a rectangle of chunks but large ones, by rows, then columns; the
   same with large ones; and all that the terrain, or the index if it is not NULL, has. */
TUFF_HOT bool tuff_walk_area(tuff_search *search);
void tuff_walk_with_large(tuff_search *search);
void tuff_walk_numbers(tuff_search *search, const tuff_chunks *chunks);

#endif
