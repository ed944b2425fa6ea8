/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Walks over the index: the chunks that a box or a line may touch, and the pieces in them. Chunks are found in whole units,
   rounded outward, so that both builds visit every piece they must. No list is followed for more steps than there are
   entries, so that overwritten storage cannot hang a game. */
#include "inner.h"

/* --- all walks --------------------------------------------------------------------------------------------- */

static inline bool is_near(const tuff_search *search, unsigned number)
{
    const tuff_world *world = search->world;
    const tuff_terrain *piece = &world->terrain[number];
    if (number >= world->terrain_count) return false;
    return tuff_squares_touch(search->center, search->radius, piece->position, piece->bounding_radius);
}

/* False: the visitor has had enough. */
static bool offer(tuff_search *search, unsigned number)
{
    return !is_near(search, number) || search->visit(search, (uint16_t)number);
}

/* All numbers, or all entries of the index. */
void tuff_walk_numbers(tuff_search *search, const tuff_chunks *chunks)
{
    const unsigned count = search->world->terrain_count;
    const unsigned end = chunks != NULL && chunks->capacity < count ? chunks->capacity : count;
    unsigned number;
    for (number = 0; number < end && number < TUFF_MAX_PIECES; ++number) {
        if (chunks != NULL && chunks->entries[number].next == 0) continue;
        if (!offer(search, number)) return;
    }
}

/* A link less 1 is a number below this, unless it ends a list; as an unsigned number, 0 less 1 is none either. */
static inline unsigned number_limit(const tuff_chunks *chunks)
{
    return chunks->capacity < TUFF_MAX_PIECES ? chunks->capacity : TUFF_MAX_PIECES;
}

/* Where a walk stands in it: between the pieces of chunk (x, y). */
typedef struct stand {
    int32_t  x, y;
    unsigned number;                /* the next in the chunk's bucket; TUFF_NO_PIECE or beyond the index: none */
    unsigned left;                  /* links that the bucket may still have */
} stand;

/* The next piece of the area that is near, by rows, then columns; TUFF_NO_PIECE: no more. A bucket may hold other chunks' pieces. Nothing
   is called in here, so that all of it stays in registers. */
static inline unsigned next_in_area(const tuff_search *search, stand *at)
{
    const tuff_chunks *const chunks = search->world->chunks;
    const uint16_t *const buckets = chunks->buckets;
    const tuff_chunk_entry *const entries = chunks->entries;
    const uint32_t mask = chunks->bucket_count - 1u;
    const unsigned limit = number_limit(chunks);
    uint32_t row = tuff_row_hash(at->y);
    for (;;) {
        while (at->number < limit && at->left > 0) {
            const unsigned found = at->number;
            const tuff_chunk_entry *entry = &entries[found];
            at->number = entry->next - 1u;
            --at->left;
            if (entry->x == at->x && entry->y == at->y && is_near(search, found)) return found;
        }
        if (at->x == search->area.high[0]) {
            if (at->y == search->area.high[1]) return TUFF_NO_PIECE;
            at->x = search->area.low[0] - 1;
            row = tuff_row_hash(++at->y);
        }
        ++at->x;
        at->number = buckets[(row + (uint32_t)at->x) & mask] - 1u;
        at->left = limit;
    }
}

TUFF_HOT bool tuff_walk_area(tuff_search *search)
{
    stand at = { search->area.low[0] - 1, search->area.low[1], TUFF_NO_PIECE, 0 };
    unsigned number;
    while ((number = next_in_area(search, &at)) != TUFF_NO_PIECE) {
        if (!search->visit(search, (uint16_t)number)) return false;
    }
    return true;
}

/* Where a walk stands in the list of large pieces, which is in the order of their chunks. */
typedef struct large_list {
    unsigned number;                /* from the limit on: the end */
    unsigned left;                  /* links that the list may still have */
} large_list;

static inline large_list large_pieces(const tuff_chunks *chunks)
{
    large_list list = { chunks->large - 1u, number_limit(chunks) };
    return list;
}

/* Those whose chunk stands before (x, y). */
static bool visit_large(tuff_search *search, large_list *list, int32_t x, int32_t y)
{
    const tuff_chunks *chunks = search->world->chunks;
    const unsigned limit = number_limit(chunks);
    for (; list->left > 0 && list->number < limit; --list->left) {
        const unsigned number = list->number;
        const tuff_chunk_entry *entry = &chunks->entries[number];
        if (entry->y > y || (entry->y == y && entry->x >= x)) return true;
        list->number = entry->next - 1u;
        if (!offer(search, number)) return false;
    }
    return true;
}

/* --- boxes ------------------------------------------------------------------------------------------------- */

/* Large pieces take their turn after the others of their chunk, or if that is to the left of the area, before its row. Rows that have
   none are walked as a whole. */
void tuff_walk_with_large(tuff_search *search)
{
    const tuff_chunks *chunks = search->world->chunks;
    const tuff_chunk_area all = search->area;
    tuff_chunk_area *here = &search->area;
    large_list large = large_pieces(chunks);
    for (; here->low[1] <= all.high[1]; ++here->low[1]) {
        here->high[1] = here->low[1];
        for (here->low[0] = all.low[0]; here->low[0] <= all.high[0]; here->low[0] = here->high[0] + 1) {
            if (!visit_large(search, &large, here->low[0], here->low[1])) return;
            bool in_row = large.number < number_limit(chunks) && chunks->entries[large.number].y == here->low[1];
            here->high[0] = in_row ? here->low[0] : all.high[0];
            if (!tuff_walk_area(search)) return;
        }
    }
    (void)visit_large(search, &large, 0, TUFF_INT32_MAX);
}

/* Has the box more chunks than the index has entries? */
static bool more_than_entries(const tuff_chunk_area *all, uint32_t entries)
{
    uint32_t columns = (uint32_t)(all->high[0] - all->low[0]) + 1;
    uint32_t rows = (uint32_t)(all->high[1] - all->low[1]) + 1;
    return columns > entries || rows > entries || columns * rows > entries;
}

TUFF_HOT void tuff_walk_box(tuff_search *search, bool ordered)
{
    const tuff_chunks *chunks = search->world->chunks;
    if (!tuff_index_in_use(chunks)) {
        tuff_walk_numbers(search, NULL);
        return;
    }
    const uint16_t pitch = tuff_pitch(chunks);
    int32_t reach = tuff_ceil(search->radius) + chunks->reach;
    int32_t x = tuff_floor(search->center.x);
    int32_t y = tuff_floor(search->center.y);
    search->area.low[0] = (x - reach) >> pitch;
    search->area.low[1] = (y - reach) >> pitch;
    search->area.high[0] = (x + reach) >> pitch;
    search->area.high[1] = (y + reach) >> pitch;
    if (!ordered && more_than_entries(&search->area, chunks->capacity)) tuff_walk_numbers(search, chunks);
    else if (chunks->large == 0) (void)tuff_walk_area(search);
    else tuff_walk_with_large(search);
}

/* --- lines ------------------------------------------------------------------------------------------------- */

static inline int32_t lesser32(int32_t a, int32_t b)                 { return a < b ? a : b; }
static inline int32_t greater32(int32_t a, int32_t b)                { return a > b ? a : b; }
static inline int32_t size_of(int32_t a)                             { return a < 0 ? -a : a; }
static inline int32_t within(int32_t a, int32_t low, int32_t high)   { return lesser32(greater32(a, low), high); }

static inline int32_t minor_at(const tuff_track *line, int32_t major)
{
    return line->minor + (line->slope * (within(major, line->first, line->last) - line->first) >> 14);
}

/* How far from the line, along minor, the center of a circle may be that touches it. For a center c within R of a point x of the
   line, with u and w the components of x - c, c's minor is that of the line at c's major, plus m u - w, and |m u - w| <=
   R sqrt(1 + m^2) by Cauchy and Schwarz; beyond the ends the same holds of the end. */
static inline int32_t margin_of(const tuff_track *line, int32_t reach)
{
    return reach + ((reach * line->secant) >> 14) + line->slack;
}

/* sqrt(1 + m^2) is taken as 1 + 27/64 m, its chord over 0 .. 1 or a little more. Slack: whole units put the ends, and a
   center, off by less than 1 in each axis, and in their differences less than 1 in minor and less than 1 along the slope;
   the slope is off by up to 2^-14 a unit, products by 1, the ends that they are held within by 1. */
static void track_of(tuff_track *line, tuff_vec2 a, tuff_vec2 b)
{
    const int32_t ax = tuff_floor(a.x);
    const int32_t ay = tuff_floor(a.y);
    const int32_t x = tuff_floor(b.x) - ax;
    const int32_t y = tuff_floor(b.y) - ay;
    const bool swapped = size_of(x) < size_of(y);
    const int32_t way = swapped ? y : x;
    const int32_t aside = swapped ? x : y;
    const int32_t length = size_of(way);
    line->axis = swapped;
    line->first = swapped ? ay : ax;
    line->minor = swapped ? ax : ay;
    if (way < 0) {
        line->first += way;
        line->minor += aside;
    }
    line->last = line->first + length;
    line->slope = length == 0 ? 0 : aside * 16384 / way;
    line->secant = size_of(line->slope) * 27 / 64 + 1;
    line->slack = 6 + (length >> 14);
}

/* The walk along a line looks for what is near its middle, and hands on what is near the line. */
static bool visit_near_line(tuff_search *search, uint16_t number)
{
    const tuff_line_search *walk = (const tuff_line_search *)search;
    const tuff_track *line = &walk->line;
    const tuff_terrain *piece = &search->world->terrain[number];
    const tuff_real major = line->axis == 0 ? piece->position.x : piece->position.y;
    const tuff_real minor = line->axis == 0 ? piece->position.y : piece->position.x;
    int32_t aside = tuff_floor(minor) - minor_at(line, tuff_floor(major));
    int32_t margin = margin_of(line, tuff_ceil(piece->bounding_radius));
    return aside > margin || aside < -margin || walk->visit(search, number);
}

/* Row by row; of a line along x, rows are columns. */
static void visit_rows(tuff_line_search *walk, const tuff_chunks *chunks)
{
    const tuff_track *line = &walk->line;
    tuff_chunk_area *area = &walk->search.area;
    const uint16_t pitch = tuff_pitch(chunks);
    const int32_t margin = margin_of(line, chunks->reach);
    const int32_t last_row = (line->last + chunks->reach) >> pitch;
    int32_t row = (line->first - chunks->reach) >> pitch;
    int32_t enter = line->minor;
    large_list large = large_pieces(chunks);
    for (; row <= last_row; ++row) {
        int32_t leave = minor_at(line, (row + 1) * ((int32_t)1 << pitch));
        area->low[line->axis] = row;
        area->high[line->axis] = row;
        area->low[!line->axis] = (lesser32(enter, leave) - margin) >> pitch;
        area->high[!line->axis] = (greater32(enter, leave) + margin) >> pitch;
        if (!tuff_walk_area(&walk->search)) return;
        enter = leave;
    }
    (void)visit_large(&walk->search, &large, 0, TUFF_INT32_MAX);
}

TUFF_HOT void tuff_walk_line(tuff_line_search *walk, const tuff_world *world, tuff_vec2 a, tuff_vec2 b)
{
    walk->search.world = world;
    walk->search.visit = visit_near_line;
    walk->search.radius = tuff_middle(a, b, &walk->search.center);
    track_of(&walk->line, a, b);
    if (tuff_index_in_use(world->chunks)) visit_rows(walk, world->chunks);
    else tuff_walk_numbers(&walk->search, NULL);
}
