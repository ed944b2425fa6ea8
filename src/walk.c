/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Walks over the index: the chunks that a box or a line may touch, and the pieces in them. All in whole units and
   rounded outward, so that both builds visit every piece they must. */
#include "inner.h"

static int32_t lesser32(int32_t a, int32_t b)                  { return a < b ? a : b; }
static int32_t greater32(int32_t a, int32_t b)                 { return a > b ? a : b; }
static int32_t within(int32_t a, int32_t low, int32_t high)  { return lesser32(greater32(a, low), high); }

/* Which columns of this row a line may touch. For a center c within R of a point x of the line, with u and w the
   components of x - c, c's minor is that of the line at c's major, plus m u - w, and |m u - w| <= R sqrt(1 + m^2) by
   Cauchy and Schwarz; beyond the ends the same holds of the end. */
static void find_columns(tuff_walk *walk)
{
    const tuff_track *track = &walk->track;
    uint16_t pitch = tuff_pitch(walk->chunks);
    int32_t enter = within(walk->row * ((int32_t)1 << pitch), track->first, track->last);
    int32_t leave = within((walk->row + 1) * ((int32_t)1 << pitch), track->first, track->last);
    int32_t at_enter = track->minor + (int32_t)(((int64_t)track->slope * (enter - track->major)) >> 15);
    int32_t at_leave = track->minor + (int32_t)(((int64_t)track->slope * (leave - track->major)) >> 15);
    walk->first_column = tuff_chunk_of(walk->chunks, greater32(lesser32(at_enter, at_leave) - track->margin, track->low));
    walk->last_column = tuff_chunk_of(walk->chunks, lesser32(greater32(at_enter, at_leave) + track->margin, track->high));
}

static void open_chunk(tuff_walk *walk)
{
    int32_t x = walk->along_x ? walk->row : walk->column;
    int32_t y = walk->along_x ? walk->column : walk->row;
    walk->left = walk->chunks->capacity;
    walk->link = walk->chunks->buckets[tuff_bucket(walk->chunks, x, y)];
}

static void open_row(tuff_walk *walk)
{
    if (walk->is_line) find_columns(walk);
    walk->column = walk->first_column;
    open_chunk(walk);
}

/* False: without an index in use, every number of the terrain is taken in turn. */
static bool has_index(tuff_walk *walk, const tuff_world *world)
{
    const tuff_walk fresh = { 0 };
    *walk = fresh;
    walk->count = world->terrain_count < TUFF_MAX_PIECES ? world->terrain_count : TUFF_MAX_PIECES;
    walk->step = 1;
    if (!tuff_index_in_use(world->chunks)) return false;
    walk->chunks = world->chunks;
    walk->large = world->chunks->large;
    return true;
}

void tuff_walk_box(tuff_walk *walk, const tuff_world *world, tuff_vec2 center, tuff_real radius, bool ordered)
{
    if (!has_index(walk, world)) return;
    int32_t x = tuff_floor(center.x);
    int32_t y = tuff_floor(center.y);
    int32_t reach = tuff_ceil(radius) + walk->chunks->reach;
    walk->first_column = tuff_chunk_of(walk->chunks, x - reach);
    walk->last_column = tuff_chunk_of(walk->chunks, x + reach);
    walk->row = tuff_chunk_of(walk->chunks, y - reach);
    walk->last_row = tuff_chunk_of(walk->chunks, y + reach);
    walk->large_now = !ordered;
    int64_t chunk_count = (int64_t)(walk->last_column - walk->first_column + 1) * (walk->last_row - walk->row + 1);
    walk->every = !ordered && chunk_count > walk->chunks->capacity;
    open_row(walk);
}

/* Ends in whole units are up to 1 unit off in each axis, the slope up to 2^-15 a unit: 3 units and a part of the
   length. sqrt(1 + m^2) is taken as 1 + 27/64 m, its chord over 0 .. 1 or a little more. */
static void lay_track(tuff_track *track, int32_t to_major, int32_t to_minor, int32_t reach)
{
    int32_t length = to_major - track->major;
    int32_t rise = to_minor - track->minor;
    int32_t steepness;
    track->slope = length == 0 ? 0 : (int32_t)((int64_t)rise * 32768 / length);
    steepness = track->slope < 0 ? -track->slope : track->slope;
    track->first = lesser32(track->major, to_major);
    track->last = greater32(track->major, to_major) + 1;
    track->low = lesser32(track->minor, to_minor) - reach;
    track->high = greater32(track->minor, to_minor) + 1 + reach;
    track->margin = reach + ((reach * steepness) >> 15) * 27 / 64 + 4 + ((track->last - track->first) >> 15);
}

void tuff_walk_line(tuff_walk *walk, const tuff_world *world, tuff_vec2 a, tuff_vec2 b)
{
    if (!has_index(walk, world)) return;
    int32_t ax = tuff_floor(a.x), ay = tuff_floor(a.y);
    int32_t bx = tuff_floor(b.x), by = tuff_floor(b.y);
    int32_t reach = walk->chunks->reach;
    tuff_track *track = &walk->track;
    walk->is_line = true;
    walk->large_now = true;
    walk->along_x = (bx < ax ? ax - bx : bx - ax) >= (by < ay ? ay - by : by - ay);
    track->major = walk->along_x ? ax : ay;
    track->minor = walk->along_x ? ay : ax;
    lay_track(track, walk->along_x ? bx : by, walk->along_x ? by : bx, reach);

    int32_t low_row = tuff_chunk_of(walk->chunks, track->first - reach);
    int32_t high_row = tuff_chunk_of(walk->chunks, track->last + reach);
    bool ascending = track->major == track->first;
    walk->step = ascending ? 1 : -1;
    walk->row = ascending ? low_row : high_row;
    walk->last_row = ascending ? high_row : low_row;
    open_row(walk);
}

/* The next of all numbers, or of all entries of the index. */
static uint16_t next_number(tuff_walk *walk)
{
    while (walk->number < walk->count) {
        uint16_t number = walk->number++;
        if (walk->chunks == NULL) return number;
        if (number >= walk->chunks->capacity) break;
        if (walk->chunks->entries[number].next != 0) return number;
    }
    return TUFF_NO_PIECE;
}

/* The next large piece whose turn has come: its chunk stands before this one. */
static uint16_t next_large(tuff_walk *walk)
{
    if (!tuff_link_valid(walk->chunks, walk->large) || walk->number >= walk->chunks->capacity) return TUFF_NO_PIECE;
    uint16_t number = (uint16_t)(walk->large - 1);
    const tuff_chunk_entry *entry = &walk->chunks->entries[number];
    bool due = walk->large_now || entry->y < walk->row || (entry->y == walk->row && entry->x < walk->column);
    if (!due) return TUFF_NO_PIECE;
    walk->large = entry->next;
    ++walk->number;
    return number;
}

/* The next piece of this chunk; a bucket may hold other chunks' pieces. */
static uint16_t next_in_chunk(tuff_walk *walk)
{
    int32_t x = walk->along_x ? walk->row : walk->column;
    int32_t y = walk->along_x ? walk->column : walk->row;
    while (tuff_link_valid(walk->chunks, walk->link) && walk->left > 0) {
        --walk->left;
        uint16_t number = (uint16_t)(walk->link - 1);
        const tuff_chunk_entry *entry = &walk->chunks->entries[number];
        walk->link = entry->next;
        if (entry->x == x && entry->y == y) return number;
    }
    return TUFF_NO_PIECE;
}

/* After the last chunk, the large pieces that are left are due. */
static void next_chunk(tuff_walk *walk)
{
    if (walk->column < walk->last_column) {
        ++walk->column;
        open_chunk(walk);
    } else if (walk->row != walk->last_row) {
        walk->row += walk->step;
        open_row(walk);
    } else {
        walk->large_now = true;
        walk->finished = true;
    }
}

TUFF_HOT uint16_t tuff_walk_next(tuff_walk *walk)
{
    uint16_t number;
    if (walk->chunks == NULL || walk->every) return next_number(walk);
    for (;;) {
        while ((number = next_large(walk)) != TUFF_NO_PIECE) {
            if (number < walk->count) return number;
        }
        while ((number = next_in_chunk(walk)) != TUFF_NO_PIECE) {
            if (number < walk->count) return number;
        }
        if (walk->finished) return TUFF_NO_PIECE;
        next_chunk(walk);
    }
}
