/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The contracts between the rooms of src/. */
#ifndef TUFF_INNER_H
#define TUFF_INNER_H

#include "tuff/tuff.h"
#include "arith.h"

#define tuff_circle_part         TUFF_LINK_NAME(circle_part)
#define tuff_hull_part           TUFF_LINK_NAME(hull_part)
#define tuff_circle_mover        TUFF_LINK_NAME(circle_mover)
#define tuff_hull_mover          TUFF_LINK_NAME(hull_mover)
#define tuff_piece_contact       TUFF_LINK_NAME(piece_contact)
#define tuff_parts_contact       TUFF_LINK_NAME(parts_contact)
#define tuff_corner_is_internal  TUFF_LINK_NAME(corner_is_internal)
#define tuff_edge_beside         TUFF_LINK_NAME(edge_beside)
#define tuff_edge_buried         TUFF_LINK_NAME(edge_buried)
#define tuff_collide             TUFF_LINK_NAME(collide)
#define tuff_beam_touches_part   TUFF_LINK_NAME(beam_touches_part)
#define tuff_beam_touches_circle TUFF_LINK_NAME(beam_touches_circle)
#define tuff_beam_touches_piece  TUFF_LINK_NAME(beam_touches_piece)
#define tuff_walk_box            TUFF_LINK_NAME(walk_box)
#define tuff_walk_line           TUFF_LINK_NAME(walk_line)
#define tuff_walk_next           TUFF_LINK_NAME(walk_next)

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

typedef struct tuff_mover tuff_mover;

/* Which axes are no way out: those of internal edges; those that lead back to the piece's position. */
typedef enum tuff_skipped { TUFF_SKIP_NONE, TUFF_SKIP_INTERNAL, TUFF_SKIP_BACK } tuff_skipped;

/* Shape against part at this offset. If axes are skipped the shape is known to overlap, and the contact is the one along the
   least of the others; TUFF_APART: there is none. */
typedef tuff_standing tuff_part_test(tuff_mover *mover, tuff_vec2 offset, const tuff_polygon *part, tuff_skipped skipped,
                                     tuff_contact *contact);

#define TUFF_MOST_NEIGHBORS 8     /* pieces whose seams a hull minds; it rarely meets more than three */
#define TUFF_NO_NEIGHBORS   255   /* as a count: seams between pieces do not matter, or there are too many */

/* The shape that moves. The function pointer keeps hull code out of a game that has only circles. */
struct tuff_mover {
    tuff_part_test *test;
    tuff_real       radius;        /* of the circle, or of the circle about the hull */
    tuff_polygon    hull;          /* normals NULL: not needed yet */
    tuff_unit2     *scratch;       /* where they go then */
    const tuff_terrain *piece;     /* whose parts are tested; NULL: a part of no piece */
    const tuff_terrain *neighbors[TUFF_MOST_NEIGHBORS];    /* pieces met in this call */
    uint8_t         neighbor_count;
    bool            seams;         /* the neighbors matter now */
    bool            by_outline;    /* made false by a contact with a piece that is by no outline edge, or a residue */
};

/* Has the outline of all parts and neighbors, at this vertex of a part, no normal along the axis? The vertex is the part's
   farthest that way. */
bool tuff_corner_is_internal(const tuff_mover *mover, const tuff_polygon *part, uint8_t vertex, tuff_unit2 axis);

/* Is the hull wholly beyond an end of the edge, on the side where an internal edge goes on? */
bool tuff_edge_beside(const tuff_mover *mover, tuff_vec2 offset, const tuff_polygon *part, uint8_t edge);

/* Does a neighbor cover the edge where the hull is? */
bool tuff_edge_buried(const tuff_mover *mover, tuff_vec2 offset, const tuff_polygon *part, uint8_t edge);

TUFF_HOT tuff_part_test tuff_circle_part;
TUFF_HOT tuff_part_test tuff_hull_part;

/* Fill in a mover. False: a radius out of range. For tuff_hull_mover hull must be one (tuff_is_hull), scratch has
   its count of normals. */
bool tuff_circle_mover(tuff_mover *mover, tuff_real radius);
bool tuff_hull_mover(tuff_mover *mover, tuff_real radius, const tuff_polygon *hull, tuff_unit2 *scratch);

/* The contact of a mover with a piece, by the rule for parts. */
TUFF_HOT bool tuff_piece_contact(const tuff_terrain *piece, tuff_vec2 position, tuff_mover *mover, tuff_contact *contact);

/* The same with the parts of a baked piece whose bounding circle is reached. residue: what an earlier push may have left
   of an overlap. */
TUFF_HOT bool tuff_parts_contact(const tuff_terrain *piece, tuff_vec2 offset, tuff_mover *mover, tuff_real residue,
                                 tuff_contact *contact);

/* The frame call behind all collide calls. touches may be NULL. */
uint16_t tuff_collide(const tuff_world *world, tuff_body *body, tuff_mover *mover, tuff_touches *touches);

/* --- beams ------------------------------------------------------------------------------------------------- */

/* A segment with ends relative to an obstacle. With the ends swapped, d and across change their signs and nothing else. */
typedef struct tuff_beam {
    tuff_far2 a, b;
    tuff_far2 d;         /* b - a, the same for all obstacles */
    tuff_area across;    /* d x a: the line is where d x p == across */
} tuff_beam;

/* False: an end is out of range. */
static inline bool tuff_beam_ends_ok(tuff_vec2 a, tuff_vec2 b)
{
    return tuff_position_ok(a) && tuff_position_ok(b);
}

static inline tuff_beam tuff_beam_relative(tuff_vec2 a, tuff_vec2 b, tuff_vec2 origin)
{
    tuff_vec2 first = tuff_vec2_flush(a);
    tuff_vec2 last = tuff_vec2_flush(b);
    tuff_beam beam;
    beam.a = tuff_far_sub(first, origin);
    beam.b = tuff_far_sub(last, origin);
    beam.d = tuff_far_sub(last, first);
    beam.across = tuff_line_across(beam.d, beam.a, beam.b);
    return beam;
}

/* Does the segment touch the closed polygon (baked), the closed disc about the origin? */
TUFF_HOT bool tuff_beam_touches_part(const tuff_beam *beam, const tuff_polygon *polygon);
bool tuff_beam_touches_circle(const tuff_beam *beam, tuff_real radius);

/* Does the segment touch the piece? *beam is then the segment relative to it. */
bool tuff_beam_touches_piece(const tuff_terrain *piece, tuff_vec2 a, tuff_vec2 b, tuff_beam *beam);

/* --- the index --------------------------------------------------------------------------------------------- */

#define TUFF_NO_PIECE 65535   /* no number of a piece: TUFF_MAX_PIECES is less */
#define TUFF_LIST_END 65535   /* ends a list; a link is a piece's number + 1, and 0 in an empty bucket ends it too */

/* Bucket of a chunk. Along a row neighbors are neighbors; rows are spread by the golden ratio of 2^16. */
static inline uint16_t tuff_bucket(const tuff_chunks *chunks, int32_t x, int32_t y)
{
    uint32_t hash = (uint32_t)x + (uint32_t)y * 40503u;
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

/* A line of a walk, in whole units. Major is the axis along which it is longer. */
typedef struct tuff_track {
    int32_t major, minor;           /* the beam's start */
    int32_t first, last;            /* its ends along major, ascending */
    int32_t low, high;              /* what it and the reach cover in minor */
    int32_t slope;                  /* minor by major, Q15, -1 .. 1 */
    int32_t margin;                 /* how far beside it, in minor, a piece of a chunk may lie */
} tuff_track;

/* A walk over the pieces that may touch a box or a line, each once. */
typedef struct tuff_walk {
    const tuff_chunks *chunks;      /* NULL: no index, every number below count */
    uint16_t count;                 /* of the terrain: numbers from here on are skipped */
    uint16_t number;                /* the next number, where all are taken; else large pieces so far */
    uint16_t link;                  /* the next piece in this chunk's bucket */
    uint16_t left;                  /* links that this bucket may still have */
    uint16_t large;                 /* the next large piece */
    int32_t  row, last_row;         /* chunk coordinates; of a line along x, rows are columns */
    int32_t  column, first_column, last_column;
    int8_t   step;                  /* to the next row */
    bool     every;                 /* every entry of the index: it has fewer than the box has chunks */
    bool     large_now;             /* large pieces are due, whatever their chunk */
    bool     finished;              /* the last chunk is done */
    bool     is_line, along_x;
    tuff_track track;
} tuff_walk;

/* Pieces whose bounding circle may touch the circle. ordered: chunk rows by ascending y, then x; otherwise in any order. */
void tuff_walk_box(tuff_walk *walk, const tuff_world *world, tuff_vec2 center, tuff_real radius, bool ordered);

/* Pieces whose bounding circle may touch the segment, roughly from a to b. */
void tuff_walk_line(tuff_walk *walk, const tuff_world *world, tuff_vec2 a, tuff_vec2 b);

/* The next piece's number, below world->terrain_count; TUFF_NO_PIECE: no more. */
TUFF_HOT uint16_t tuff_walk_next(tuff_walk *walk);

#endif
