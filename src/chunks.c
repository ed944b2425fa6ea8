/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The index of chunks: where pieces go in and out. It knows positions and bounding radii, not shapes. No list is
   followed for more steps than there are entries, so that overwritten storage cannot hang a game. */
#include "inner.h"

void tuff_chunks_clear(tuff_chunks *chunks)
{
    uint16_t i;
    if (chunks == NULL) return;
    for (i = 0; chunks->buckets != NULL && i < chunks->bucket_count; ++i) chunks->buckets[i] = 0;
    for (i = 0; chunks->entries != NULL && i < chunks->capacity; ++i) chunks->entries[i].next = 0;
    chunks->large = 0;
    chunks->reach = 0;
    chunks->used = false;
}

/* Take a piece out of the list that starts at *link. */
static bool unlink_from(tuff_chunks *chunks, uint16_t *link, uint16_t piece)
{
    uint16_t left;
    for (left = chunks->capacity; left > 0 && tuff_link_valid(chunks, *link); --left) {
        tuff_chunk_entry *entry = &chunks->entries[*link - 1];
        if (*link == piece + 1) {
            *link = entry->next;
            entry->next = 0;
            return true;
        }
        link = &entry->next;
    }
    return false;
}

bool tuff_chunks_remove(tuff_chunks *chunks, uint16_t piece)
{
    if (!tuff_index_in_use(chunks) || piece >= chunks->capacity || chunks->entries[piece].next == 0) return false;
    const tuff_chunk_entry *entry = &chunks->entries[piece];
    uint16_t *bucket = &chunks->buckets[tuff_bucket(chunks, entry->x, entry->y)];
    return unlink_from(chunks, bucket, piece) || unlink_from(chunks, &chunks->large, piece);
}

/* At the end of a bucket: within a chunk the order is that of insertion. */
static uint16_t *end_of_bucket(tuff_chunks *chunks, int32_t x, int32_t y)
{
    uint16_t *link = &chunks->buckets[tuff_bucket(chunks, x, y)];
    uint16_t left;
    for (left = chunks->capacity; left > 0 && tuff_link_valid(chunks, *link); --left) link = &chunks->entries[*link - 1].next;
    return link;
}

/* Large pieces are kept by rows, then columns, then insertion: the order in which a walk meets their chunks. */
static uint16_t *place_among_large(tuff_chunks *chunks, int32_t x, int32_t y)
{
    uint16_t *link = &chunks->large;
    uint16_t left;
    for (left = chunks->capacity; left > 0 && tuff_link_valid(chunks, *link); --left) {
        tuff_chunk_entry *entry = &chunks->entries[*link - 1];
        if (entry->y > y || (entry->y == y && entry->x > x)) break;
        link = &entry->next;
    }
    return link;
}

bool tuff_chunks_insert(tuff_chunks *chunks, uint16_t piece, tuff_vec2 position, tuff_real bounding_radius)
{
    TUFF_ASSERT(chunks != NULL);
    if (chunks == NULL || chunks->buckets == NULL || chunks->entries == NULL || chunks->bucket_count == 0) return false;
    if (piece >= chunks->capacity || piece >= TUFF_MAX_PIECES) return false;
    if (!tuff_position_ok(position) || !tuff_in_range(bounding_radius, TUFF_MAX_BOUNDING_RADIUS)) return false;
    (void)tuff_chunks_remove(chunks, piece);
    if (!(bounding_radius > TUFF_WHOLE(0))) return true;

    int32_t x = tuff_chunk_of(chunks, tuff_floor(position.x));
    int32_t y = tuff_chunk_of(chunks, tuff_floor(position.y));
    int32_t reach = tuff_ceil(bounding_radius);
    bool large = reach > (int32_t)1 << tuff_pitch(chunks);
    uint16_t *link = large ? place_among_large(chunks, x, y) : end_of_bucket(chunks, x, y);
    tuff_chunk_entry *entry = &chunks->entries[piece];
    entry->x = (int16_t)x;
    entry->y = (int16_t)y;
    entry->next = *link != 0 ? *link : TUFF_LIST_END;
    *link = (uint16_t)(piece + 1);
    if (!large && chunks->reach < reach) chunks->reach = (uint16_t)reach;
    chunks->used = true;
    return true;
}

bool tuff_chunks_move(tuff_chunks *chunks, uint16_t piece, tuff_vec2 position, tuff_real bounding_radius)
{
    return tuff_chunks_insert(chunks, piece, position, bounding_radius);
}
