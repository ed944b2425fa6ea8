/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The index: which pieces are near. A hash table over square chunks of the plane, unbounded in every direction, in
   static arrays of the caller: 2 bytes a bucket and 6 bytes a piece.

     static uint16_t         buckets[512];         // a power of two; about one for each piece is plenty
     static tuff_chunk_entry entries[256];         // one for each piece number
     static tuff_chunks chunks = TUFF_CHUNKS(buckets, entries, 6);   // pitch 64 units

   All zero is an empty index. The pitch should be no less than most pieces' bounding radius: a piece whose bounding
   radius exceeds the pitch goes to a list of large pieces that every query reads. */
#ifndef TUFF_CHUNKS_H
#define TUFF_CHUNKS_H

#include "shapes.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TUFF_MAX_PIECES      65534   /* pieces of a world; two values of uint16_t end lists */
#define TUFF_MAX_PITCH_LOG2  14      /* 16,384 units: two chunks on each side of the origin */

typedef struct tuff_chunk_entry {   /* where a piece was when it was inserted */
    int16_t  x, y;                  /* chunk coordinates */
    uint16_t next;                  /* 0: not in the index */
} tuff_chunk_entry;

typedef struct tuff_chunks {
    uint16_t         *buckets;
    tuff_chunk_entry *entries;
    uint16_t bucket_count;          /* a power of two, 1 .. 32768 */
    uint16_t capacity;              /* entries; piece numbers below it can be inserted */
    uint16_t pitch_log2;            /* 0 .. TUFF_MAX_PITCH_LOG2 */
    uint16_t large;                 /* the library's own, as all below: list of the pieces larger than a chunk */
    uint16_t reach;                 /* units, rounded up: largest bounding radius in the buckets */
    bool     used;                  /* something was inserted since the last clear */
} tuff_chunks;

/* Initializer for a tuff_chunks from two arrays (not pointers) and the binary logarithm of the pitch in units. */
#define TUFF_CHUNKS(bucket_array, entry_array, log2_of_pitch) \
    { (bucket_array), (entry_array), (uint16_t)(sizeof(bucket_array) / sizeof((bucket_array)[0])), \
      (uint16_t)(sizeof(entry_array) / sizeof((entry_array)[0])), (log2_of_pitch), 0, 0, false }

/* Forget every piece. Until the next insert, the world's calls scan the terrain array from end to end. */
void tuff_chunks_clear(tuff_chunks *chunks);

/* Put a piece into the index; one that is in it already is moved. False, and nothing changed: no such entry, or a
   position or bounding radius out of range. A bounding radius of 0 (an empty slot) is not entered: true. Time: the
   pieces of one bucket (a large piece: the large pieces). */
bool tuff_chunks_insert(tuff_chunks *chunks, uint16_t piece, tuff_vec2 position, tuff_real bounding_radius);

/* Tell the index that a piece has moved or changed its size. The same as insert, by the name a reader expects. */
bool tuff_chunks_move(tuff_chunks *chunks, uint16_t piece, tuff_vec2 position, tuff_real bounding_radius);

/* Take a piece out, whatever its position has become by now. False: it was not in. */
bool tuff_chunks_remove(tuff_chunks *chunks, uint16_t piece);

#ifdef __cplusplus
}
#endif

#endif
