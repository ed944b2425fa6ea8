/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Family 9, the index: every way in which a table of chunks loses a piece, finds one twice or brings one back. tests/host holds
   the index against random worlds; here are the hard places by name, the index that others write (naive_index, with one fault
   at a time), and Box2D's tree on the same queries. */
#include <string.h>

#include "handed.h"
#include "naive.h"
#include "picture.h"
#include "pieces.h"
#include "table.h"
#include "worlds.h"

typedef struct query { tuff_vec2 center; tuff_real radius; } query;

/* ---- the index that others write ---- */

typedef enum naive_fault {
    NAIVE_RIGHT,           /* none, so that the rest of it is known to be right */
    NAIVE_DIVISION,        /* keys made by a tool that rounds down, asked for with C's division */
    NAIVE_HALF_OPEN,       /* the last chunk is the one before the border, in a loop with < */
    NAIVE_BY_CENTER,       /* ceil(radius / chunk) + 1 chunks about the center's, whatever the pieces' size */
    NAIVE_TIGHT_KEYS,      /* keys just wide enough for the chunks of the range */
    NAIVE_SCANS,           /* an empty index means a search from end to end */
    NAIVE_COPIES           /* looks at the places that it was told, not at the pieces */
} naive_fault;

typedef struct naive_index {
    naive_fault fault;
    int       pitch;           /* binary logarithm */
    double    largest;         /* bounding radius, in units */
    int       held_count;
    bool      held[WORLD_MOST];
    int32_t   x[WORLD_MOST], y[WORLD_MOST];
    tuff_vec2 told[WORLD_MOST];
} naive_index;

typedef struct answer { uint16_t list[4 * WORLD_MOST]; int count; } answer;

static int32_t chunk_at(const naive_index *index, double units)
{
    double chunks = units / (double)(1 << index->pitch);
    return (int32_t)(index->fault == NAIVE_DIVISION ? trunc(chunks) : floor(chunks));
}

static void naive_insert(naive_index *index, const tuff_terrain *pieces, int i)
{
    double size = (double)(1 << index->pitch);
    index->held_count += !index->held[i];
    index->held[i] = true;
    index->x[i] = (int32_t)floor(units_of(pieces[i].position.x) / size);
    index->y[i] = (int32_t)floor(units_of(pieces[i].position.y) / size);
    index->told[i] = pieces[i].position;
    index->largest = fmax(index->largest, units_of(pieces[i].bounding_radius));
}

static void naive_remove(naive_index *index, int i)
{
    index->held_count -= index->held[i];
    index->held[i] = false;
}

static int32_t as_key(const naive_index *index, int32_t chunk)
{
    int32_t range = 65536 >> index->pitch, shifted = (chunk + range / 2) & (range - 1);
    return index->fault == NAIVE_TIGHT_KEYS ? shifted - range / 2 : chunk;
}

typedef struct span { int32_t low, high; } span;

static span chunks_about(const naive_index *index, double center, double radius)
{
    double reach = radius + index->largest, chunk = (double)(1 << index->pitch);
    span asked = { as_key(index, chunk_at(index, center - reach)), as_key(index, chunk_at(index, center + reach)) };
    int32_t more = (int32_t)ceil(radius / chunk) + 1;
    if (index->fault == NAIVE_HALF_OPEN) asked.high = (int32_t)ceil((center + reach) / chunk) - 1;
    return index->fault == NAIVE_BY_CENTER ? (span){ chunk_at(index, center) - more, chunk_at(index, center) + more } : asked;
}

static bool touches(const world_fixture *w, int i, query q)
{
    return world_gap(w, i, q.center, q.radius) <= 0;
}

static void offer(const world_fixture *w, int i, query q, answer *found)
{
    if (touches(w, i, q)) found->list[found->count++] = (uint16_t)i;
}

static void scan(const world_fixture *w, query q, answer *found)
{
    for (int i = 0; i < WORLD_MOST; i++) {
        if (w->pieces[i].bounding_radius > 0) offer(w, i, q, found);
    }
}

static void naive_nearby(const naive_index *index, const world_fixture *w, query q, answer *found)
{
    double radius = units_of(q.radius);
    span x = chunks_about(index, units_of(q.center.x), radius), y = chunks_about(index, units_of(q.center.y), radius);
    found->count = 0;
    if (index->fault == NAIVE_SCANS && index->held_count == 0) scan(w, q, found);
    for (int i = 0; i < WORLD_MOST; i++) {
        bool listed = index->held[i] && index->x[i] >= x.low && index->x[i] <= x.high && index->y[i] >= y.low && index->y[i] <= y.high;
        if (listed) offer(w, i, q, found);
    }
}

/* ---- the hard places ---- */

typedef enum ground { AROUND_ZERO, LEFT_OF_ZERO, ON_BORDERS, END_OF_RANGE, LARGER_THAN_CHUNKS, GROUNDS } ground;

#define LARGE_PITCH_MOST 10        /* a piece may be 1,449 units: larger than these chunks */

static double piece_radius(random_source *source, ground where, double chunk)
{
    double most = where == LARGER_THAN_CHUNKS ? 6.0 : 1.0, least = where == LARGER_THAN_CHUNKS ? 1.0 : 0.05;
    double radius = fmin(chunk * random_within(source, least, most), 1400.0);
    return where == ON_BORDERS ? fmin(chunk * random_between(source, 1, 2) / 2.0, 1024.0) : fmax(radius, 1.0 / 64.0);
}

static double piece_place(random_source *source, const world_fixture *w, ground where, double middle, double chunk)
{
    double at = middle + random_within(source, -1.0, 1.0) * w->extent;
    return world_clamped(where == ON_BORDERS ? floor(at / chunk) * chunk : at);
}

/* Circles, so that the bounding circle is all there is; the index is empty. */
static void make_ground(random_source *source, world_fixture *w, ground where, int pitch, uint16_t *buckets, uint16_t bucket_count)
{
    double chunk = (double)(1 << pitch), sign_x = random_chance(source, 50) ? 1.0 : -1.0, sign_y = random_chance(source, 50) ? 1.0 : -1.0;
    w->extent = fmin(5.0 * chunk, 32767.0);
    w->middle_x = where == END_OF_RANGE ? sign_x * 32767.0 : where == LEFT_OF_ZERO ? -fmin(6.0 * chunk, 24000.0) : 0.0;
    w->middle_y = where == END_OF_RANGE ? sign_y * 32767.0 : where == LEFT_OF_ZERO ? -fmin(6.0 * chunk, 24000.0) : 0.0;
    for (int i = 0; i < WORLD_MOST; i++) {
        double x = piece_place(source, w, where, w->middle_x, chunk), y = piece_place(source, w, where, w->middle_y, chunk);
        tuff_real radius = random_point_at(grid_floor(piece_radius(source, where, chunk)), 0.0).x;
        tuff_vec2 position = random_point_at(grid_floor(x), grid_floor(y));
        w->pieces[i] = (tuff_terrain){ position, radius, radius, NULL, 0 };
    }
    w->chunks = (tuff_chunks){ buckets, w->entries, bucket_count, WORLD_MOST, (uint16_t)pitch, 0, 0, false };
    w->world = (tuff_world){ w->pieces, WORLD_MOST, &w->chunks, w->nearby, WORLD_MOST, TUFF_ORDER_DEEPEST };
    memset(w->shadows, 0, sizeof w->shadows);
    w->index_used = false;
    tuff_chunks_clear(&w->chunks);
}

/* Of a pitch in this range, in up to 64 buckets. */
static void make_sized_ground(random_source *source, world_fixture *w, ground where, int low, int high)
{
    uint16_t buckets = (uint16_t)(1u << random_below(source, 7));
    make_ground(source, w, where, random_between(source, low, high), w->buckets, buckets);
}

static void index_all(random_source *source, world_fixture *w, naive_index *index, naive_fault fault)
{
    *index = (naive_index){ .fault = fault, .pitch = w->chunks.pitch_log2 };
    for (int i = 0; i < WORLD_MOST; i++) {
        assert_true(world_tell(source, w, i));
        naive_insert(index, w->pieces, i);
    }
}

/* On borders: the center on one, or a step off it; the radius so that whole chunks are reached. */
static query make_query(random_source *source, const world_fixture *w, ground where)
{
    double chunk = (double)(1u << w->chunks.pitch_log2);
    double x = piece_place(source, w, where, w->middle_x, chunk), y = piece_place(source, w, where, w->middle_y, chunk);
    double radius = where == ON_BORDERS ? chunk * random_between(source, 0, 4) / 2.0 : chunk * random_within(source, 0.0, 2.0);
    double step = where == ON_BORDERS && chunk <= 64.0 ? random_between(source, -1, 1) / (double)GRID : 0.0;
    radius = fmin(floor(radius * 64.0) / 64.0, 32767.0);
    return (query){ random_point_at(grid_floor(x) + step, grid_floor(y)), random_point_at(radius, 0.0).x };
}

/* ---- right and wrong ---- */

static int times_in(const uint16_t *list, int count, int piece)
{
    int found = 0;
    for (int k = 0; k < count; k++) found += list[k] == piece;
    return found;
}

/* Each piece that can be found and touches once, all others never. What touches but for so much may go either way. */
static bool is_wrong(const world_fixture *w, query q, double rounding, const uint16_t *list, int count)
{
    for (int i = 0; i < WORLD_MOST; i++) {
        int found = times_in(list, count, i);
        bool present = world_present(w, i);
        double gap = present ? world_gap(w, i, q.center, q.radius) : 1.0;
        if (found > 1 || (found == 1 && gap > rounding) || (found == 0 && gap <= -rounding)) return true;
    }
    return false;
}

static bool tuff_is_wrong(world_fixture *w, query q)
{
    int count = tuff_nearby_terrain(&w->world, q.center, q.radius);
    return count > WORLD_MOST || is_wrong(w, q, WORLD_GAP_ROUNDING, w->nearby, count);
}

static yardstick *make_yard(const world_fixture *w)
{
    yardstick *yard = yardstick_new((yardstick_vec){ 0.0, 0.0 }, false);
    for (int i = 0; i < WORLD_MOST; i++) {
        yardstick_add_circle(yard, yard_vec(w->pieces[i].position), units_of(w->pieces[i].radius), 0.0);
    }
    return yard;
}

/* What Box2D's tree offers, and after each was tested as everywhere here, what is left. */
static bool box_is_wrong(const yardstick *yard, const world_fixture *w, query q, unsigned long *offered)
{
    int list[WORLD_MOST];
    answer found = { .count = 0 };
    double x = units_of(q.center.x), y = units_of(q.center.y), r = units_of(q.radius);
    int count = yardstick_query(yard, (yardstick_vec){ x - r, y - r }, (yardstick_vec){ x + r, y + r }, list, WORLD_MOST);
    *offered += (unsigned long)count;
    for (int k = 0; k < count && k < WORLD_MOST; k++) offer(w, list[k], q, &found);
    return is_wrong(w, q, 0.0, found.list, found.count);
}

typedef struct tally {
    unsigned long queries;
    unsigned long naive, right, box, tuff;      /* wrong answers; right: of the naive index without its fault */
    unsigned long box_offered, tuff_found;
} tally;

#define QUERIES 10         /* of each world */

static void ask(random_source *source, world_fixture *w, ground where, naive_index *index, const yardstick *yard, tally *sum)
{
    query q = make_query(source, w, where);
    answer found;
    naive_fault fault = index->fault;
    naive_nearby(index, w, q, &found);
    sum->naive += is_wrong(w, q, 0.0, found.list, found.count);
    index->fault = NAIVE_RIGHT;
    naive_nearby(index, w, q, &found);
    index->fault = fault;
    sum->right += is_wrong(w, q, 0.0, found.list, found.count);
    sum->box += box_is_wrong(yard, w, q, &sum->box_offered);
    sum->tuff_found += tuff_nearby_terrain(&w->world, q.center, q.radius);
    sum->queries++;
}

/* Worlds of one ground, of the pitches 0 .. most; tuff's answers must be right. */
static tally survey(const random_run *run, ground where, naive_fault fault, int most)
{
    static world_fixture w;
    static naive_index index;
    tally sum = { 0 };
    for (uint32_t i = run->first; i < run->end; i++) {
        random_source source = random_stream(run->seed, i);
        make_sized_ground(&source, &w, where, 0, most);
        index_all(&source, &w, &index, fault);
        yardstick *yard = make_yard(&w);
        for (int k = 0; k < QUERIES; k++) {
            random_source same = source;
            ask(&source, &w, where, &index, yard, &sum);
            sum.tuff += tuff_is_wrong(&w, make_query(&same, &w, where));
            if (sum.tuff) random_fail(run, i, "query %d", k);
        }
        yardstick_free(yard);
    }
    return sum;
}

static double per_1000(unsigned long count, unsigned long queries)
{
    return 1000.0 * (double)count / (double)queries;
}

typedef struct naive_trial {
    ground      where;
    naive_fault fault;
    int         most_pitch;
    const char *measure, *method;      /* of the table */
} naive_trial;

/* This fault fails here, without it the naive index is right, and so are Box2D and tuff. */
static void assert_fails_here(const char *test, uint64_t seed, const naive_trial *t)
{
    random_run run = random_cases(test, seed, 1000);
    tally sum = survey(&run, t->where, t->fault, t->most_pitch);
    if (run.end - run.first >= 30) assert_true(sum.naive > sum.queries / 50);
    assert_true(sum.right == 0 && sum.box == 0 && sum.tuff == 0);
    table_row(t->measure);
    table_fails(t->method, "%.0f", per_1000(sum.naive, sum.queries));
    table_box2d("%.0f", per_1000(sum.box, sum.queries));
    table_tuff("%.0f", per_1000(sum.tuff, sum.queries));
}

static void test_cs_division_misses_pieces_left_of_zero(void **state)
{
    const naive_trial trial = { LEFT_OF_ZERO, NAIVE_DIVISION, TUFF_MAX_PITCH_LOG2,
                                "wrong answers at negative coordinates, per 1,000", "C's division" };
    (void)state;
    assert_fails_here(__func__, 901, &trial);
}

static void test_asking_by_center_misses_pieces_larger_than_a_chunk(void **state)
{
    const naive_trial trial = { LARGER_THAN_CHUNKS, NAIVE_BY_CENTER, LARGE_PITCH_MOST,
                                "wrong answers, pieces larger than a chunk, per 1,000", "ceil(r / chunk) + 1" };
    (void)state;
    assert_fails_here(__func__, 902, &trial);
}

static void test_tight_keys_wrap_at_the_end_of_the_range(void **state)
{
    const naive_trial trial = { END_OF_RANGE, NAIVE_TIGHT_KEYS, TUFF_MAX_PITCH_LOG2 - 4,
                                "wrong answers at the end of the range, per 1,000", "keys just wide enough" };
    (void)state;
    assert_fails_here(__func__, 903, &trial);
}

static void test_a_loop_up_to_the_border_misses_what_touches_there(void **state)
{
    const naive_trial trial = { ON_BORDERS, NAIVE_HALF_OPEN, TUFF_MAX_PITCH_LOG2,
                                "wrong answers on chunk borders, per 1,000", "a loop up to the border" };
    (void)state;
    assert_fails_here(__func__, 904, &trial);
}

/* Box2D's boxes are a little larger than the pieces; each piece that it offers must be tested, while tuff's answer has been. */
static void test_box2ds_tree_offers_more_than_touches(void **state)
{
    random_run run = random_cases(__func__, 910, 1000);
    (void)state;
    tally sum = survey(&run, AROUND_ZERO, NAIVE_RIGHT, TUFF_MAX_PITCH_LOG2);
    assert_true(sum.box == 0 && sum.box_offered > sum.tuff_found);
    printf("figures: pieces handed out by a query: Box2D %.2f, tuff %.2f\n", (double)sum.box_offered / (double)sum.queries,
           (double)sum.tuff_found / (double)sum.queries);
}

/* ---- every pitch, every number of buckets ---- */

static bool same_as_linear(random_source *source, world_fixture *w)
{
    tuff_body body = { make_query(source, w, AROUND_ZERO).center, random_point(source, 3.0), NULL }, linear = body;
    tuff_real radius = random_point_at(random_within(source, 0.5, 30.0), 0.0).x;
    uint16_t pushes = tuff_terrain_collide_circle(&w->world, &body, radius);
    bool used = world_index_off(w);
    bool same = tuff_terrain_collide_circle(&w->world, &linear, radius) == pushes && same_body(&body, &linear);
    world_index_on(w, used);
    return same;
}

static void test_every_pitch_and_number_of_buckets_gives_the_same_answers(void **state)
{
    static uint16_t buckets[32768];
    static const uint16_t counts[] = { 1, 2, 64, 32768 };
    static world_fixture w;
    static naive_index index;
    random_run run = random_cases(__func__, 905, 3000);
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        ground where = (ground)(i % GROUNDS);
        int pitch = (int)(i / GROUNDS % (TUFF_MAX_PITCH_LOG2 + 1));
        make_ground(&source, &w, where, pitch, buckets, counts[random_below(&source, 4)]);
        index_all(&source, &w, &index, NAIVE_RIGHT);
        for (int k = 0; k < QUERIES; k++) {
            if (tuff_is_wrong(&w, make_query(&source, &w, where))) random_fail(&run, i, "pitch %d, query %d", pitch, k);
            if (!same_as_linear(&source, &w)) random_fail(&run, i, "pitch %d: the index moved a body elsewhere than the array", pitch);
        }
    }
}

/* ---- stale and missing entries ---- */

static void naive_nearby_by_copies(const naive_index *index, const world_fixture *w, query q, answer *found)
{
    found->count = 0;
    for (int i = 0; i < WORLD_MOST; i++) {
        exact2 d = exact_sub(exact_vec2(q.center), exact_vec2(index->told[i]));
        exact reach = exact_real(q.radius) + exact_real(w->pieces[i].bounding_radius);
        if (index->held[i] && exact_dot(d, d) <= reach * reach) found->list[found->count++] = (uint16_t)i;
    }
}

/* None that is gone or elsewhere, none twice; those that the index was told of, all. */
static bool tuff_knows_better(world_fixture *w, query q)
{
    int count = tuff_nearby_terrain(&w->world, q.center, q.radius);
    if (count > WORLD_MOST) return false;
    for (int i = 0; i < WORLD_MOST; i++) {
        int found = times_in(w->nearby, count, i);
        double gap = world_present(w, i) ? world_gap(w, i, q.center, q.radius) : 1.0;
        if (found > 1 || (found == 1 && gap > WORLD_GAP_ROUNDING)) return false;
        if (found == 0 && world_told(w, i) && gap <= -WORLD_GAP_ROUNDING) return false;
    }
    return true;
}

/* Untold: some pieces move, some become empty slots, some are taken out, and the array is cut short. */
static void make_stale(random_source *source, world_fixture *w, naive_index *index)
{
    for (int k = 0; k < WORLD_MOST / 2; k++) {
        int i = (int)random_below(source, WORLD_MOST);
        uint32_t what = random_below(source, 3);
        if (what == 0) w->pieces[i].position = make_query(source, w, AROUND_ZERO).center;
        if (what == 1) w->pieces[i] = (tuff_terrain){ .part_count = 0 };
        if (what != 2) continue;
        assert_true(world_forget(w, i));
        naive_remove(index, i);
    }
    w->world.terrain_count = (uint16_t)random_between(source, WORLD_MOST / 2, WORLD_MOST);
}

static bool tell_all(random_source *source, world_fixture *w)
{
    w->world.terrain_count = WORLD_MOST;
    for (int i = 0; i < WORLD_MOST; i++) {
        if (!world_tell(source, w, i)) return false;
    }
    return true;
}

static void test_stale_and_missing_entries_show_nothing_that_is_not_there(void **state)
{
    static world_fixture w;
    static naive_index index;
    random_run run = random_cases(__func__, 906, 1000);
    unsigned long ghosts = 0, queries = 0;
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        uint16_t entries[WORLD_MOST];
        answer found;
        make_sized_ground(&source, &w, AROUND_ZERO, 2, 9);
        index_all(&source, &w, &index, NAIVE_COPIES);
        make_stale(&source, &w, &index);
        for (int k = 0; k < WORLD_MOST; k++) entries[k] = w.entries[k].next;
        for (int k = 0; k < QUERIES; k++, queries++) {
            query q = make_query(&source, &w, AROUND_ZERO);
            naive_nearby_by_copies(&index, &w, q, &found);
            ghosts += is_wrong(&w, q, 0.0, found.list, found.count);
            if (!tuff_knows_better(&w, q)) random_fail(&run, i, "query %d", k);
        }
        for (int k = 0; k < WORLD_MOST; k++) assert_int_equal(entries[k], w.entries[k].next);
        assert_true(tell_all(&source, &w));
        if (tuff_is_wrong(&w, make_query(&source, &w, AROUND_ZERO))) random_fail(&run, i, "told of everything, it is wrong");
    }
    if (run.end - run.first >= 30) assert_true(ghosts > queries / 10);
    printf("figures: an index that trusts its copies is wrong in %.0f of 1,000 queries after untold changes\n", per_1000(ghosts, queries));
}

/* ---- removal while the answer is in use ---- */

/* The list itself is walked, and what is removed moves the rest up: the next one is skipped. The pieces left behind. */
static int naive_blast(const world_fixture *w, query q)
{
    int list[WORLD_MOST], count = WORLD_MOST, left = 0;
    for (int i = 0; i < WORLD_MOST; i++) list[i] = i;
    for (int k = 0; k < count; k++) {
        if (!touches(w, list[k], q)) continue;
        memmove(&list[k], &list[k + 1], (size_t)(count - k - 1) * sizeof *list);
        count--;
    }
    for (int k = 0; k < count; k++) left += touches(w, list[k], q);
    return left;
}

/* Each piece of the answer is taken out, and in between others are moved; the answer stays as it was. */
static int tuff_blast(random_source *source, world_fixture *w, query q)
{
    uint16_t before[WORLD_MOST];
    int count = tuff_nearby_terrain(&w->world, q.center, q.radius);
    memcpy(before, w->nearby, sizeof before);
    for (int k = 0; k < count; k++) {
        assert_true(world_forget(w, w->nearby[k]));
        int other = (int)random_below(source, WORLD_MOST);
        if (w->shadows[other].held) assert_true(world_tell(source, w, other));
    }
    assert_memory_equal(before, w->nearby, sizeof before);
    return tuff_nearby_terrain(&w->world, q.center, q.radius);
}

static void test_pieces_may_be_removed_while_the_answer_is_read(void **state)
{
    static world_fixture w;
    static naive_index index;
    random_run run = random_cases(__func__, 907, 2000);
    unsigned long left = 0;
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        make_sized_ground(&source, &w, AROUND_ZERO, 2, 9);
        index_all(&source, &w, &index, NAIVE_RIGHT);
        query q = make_query(&source, &w, AROUND_ZERO);
        left += naive_blast(&w, q) > 0;
        if (tuff_blast(&source, &w, q) != 0) random_fail(&run, i, "a removed piece is still found");
        if (tuff_is_wrong(&w, make_query(&source, &w, AROUND_ZERO))) random_fail(&run, i, "the rest is not found any more");
    }
    if (run.end - run.first >= 30) assert_true(left > 0);
    printf("figures: removals in a walk of the list itself leave pieces behind in %.0f of 1,000 queries\n",
           per_1000(left, run.end - run.first));
}

/* ---- an emptied index ---- */

/* No call of a frame finds anything where this piece was. */
static bool all_quiet(world_fixture *w, int i)
{
    tuff_vec2 at = w->pieces[i].position;
    tuff_body body = body_at(at);
    tuff_beam_hit hit;
    if (tuff_nearby_terrain(&w->world, at, TUFF_WHOLE(100)) > 0) return false;
    if (tuff_terrain_collide_circle(&w->world, &body, TUFF_WHOLE(4)) > 0) return false;
    return !tuff_segment_terrain_intersect(&w->world, at, (tuff_vec2){ 0, 0 }) && !tuff_segment_terrain_first_hit(&w->world, at, at, &hit);
}

static void test_an_emptied_index_brings_nothing_back(void **state)
{
    static world_fixture w;
    static naive_index index;
    random_run run = random_cases(__func__, 908, 1000);
    unsigned long back = 0;
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        answer found;
        int last = (int)random_below(&source, WORLD_MOST);
        make_sized_ground(&source, &w, (ground)(i % GROUNDS), 2, 9);
        index_all(&source, &w, &index, NAIVE_SCANS);
        for (int k = 0; k < WORLD_MOST; k++) {
            int gone = (last + 1 + k * 7) % WORLD_MOST;
            assert_true(world_forget(&w, gone));
            naive_remove(&index, gone);
            if (k % 8 != 0) continue;
            if (tuff_is_wrong(&w, make_query(&source, &w, AROUND_ZERO))) random_fail(&run, i, "wrong after %d removals", k + 1);
        }
        naive_nearby(&index, &w, (query){ w.pieces[last].position, TUFF_WHOLE(100) }, &found);
        back += found.count > 0;
        if (!all_quiet(&w, last)) random_fail(&run, i, "a removed piece came back");
        assert_true(world_tell(&source, &w, last));
        if (tuff_nearby_terrain(&w.world, w.pieces[last].position, 0) != 1) random_fail(&run, i, "the first piece after that is not alone");
    }
    assert_int_equal(back, run.end - run.first);
    printf("figures: an emptied index that searches all brings pieces back in %.0f of 1,000 worlds\n", per_1000(back, run.end - run.first));
}

/* ---- the order of insertion ---- */

#define CLUSTER 12
#define FRAMES  40

typedef struct cluster {     /* not to be copied: the pieces point into it */
    random_shape shapes[CLUSTER];
    tuff_terrain pieces[CLUSTER];
    int          order[CLUSTER];
} cluster;

/* Regular, in any position: Box2D takes no thin ones. */
static void make_regular(random_source *source, random_shape *shape)
{
    int count = random_between(source, 3, YARDSTICK_VERTICES);
    double radius = random_within(source, 6.0, 14.0), turn = random_within(source, 0.0, TURN);
    for (int i = 0; i < count; i++) {
        double angle = turn + TURN * i / count;
        shape->vertices[i] = random_point_at(radius * cos(angle), radius * sin(angle));
    }
    random_bake(shape, count);
}

static void make_cluster(random_source *source, cluster *c)
{
    for (int i = 0; i < CLUSTER; i++) {
        make_regular(source, &c->shapes[i]);
        c->pieces[i] = convex_piece(&c->shapes[i], random_point(source, 24.0));
        c->order[i] = i;
    }
}

static void shuffle(random_source *source, int *order)
{
    for (int i = CLUSTER - 1; i > 0; i--) {
        int other = (int)random_below(source, (uint32_t)i + 1), swapped = order[i];
        order[i] = order[other];
        order[other] = swapped;
    }
}

typedef struct path { tuff_vec2 points[FRAMES + 1]; } path;

/* naive NULL: tuff's frame in this world. */
static path follow(const tuff_world *world, const tuff_terrain *naive, tuff_body body)
{
    path p = { { body.position } };
    for (int i = 0; i < FRAMES; i++) {
        body_fall(&body, (tuff_vec2){ 0, -TUFF_RATIO(1, 16) });
        if (naive) naive_collide(naive, CLUSTER, &body, TUFF_WHOLE(4), NULL);
        else tuff_terrain_collide_circle(world, &body, TUFF_WHOLE(4));
        p.points[i + 1] = body.position;
    }
    return p;
}

static path naive_path(const cluster *c, tuff_body body)
{
    tuff_terrain inserted[CLUSTER];
    for (int i = 0; i < CLUSTER; i++) inserted[i] = c->pieces[c->order[i]];
    return follow(NULL, inserted, body);
}

static path tuff_path(const cluster *c, tuff_body body, uint8_t order)
{
    uint16_t buckets[8];
    tuff_chunk_entry entries[CLUSTER];
    tuff_chunks chunks = TUFF_CHUNKS(buckets, entries, 4);
    tuff_world world = { c->pieces, CLUSTER, &chunks, NULL, 0, order };
    tuff_chunks_clear(&chunks);
    for (int i = 0; i < CLUSTER; i++) {
        const tuff_terrain *piece = &c->pieces[c->order[i]];
        assert_true(tuff_chunks_insert(&chunks, (uint16_t)c->order[i], piece->position, piece->bounding_radius));
    }
    return follow(&world, NULL, body);
}

static yardstick_vec box_end(const cluster *c, tuff_body body)
{
    yardstick *yard = yardstick_new((yardstick_vec){ 0.0, -1.0 / 16.0 }, true);
    for (int i = 0; i < CLUSTER; i++) assert_true(yard_add_piece(yard, &c->pieces[c->order[i]]));
    int ball = yardstick_add_ball(yard, yard_state(&body), 4.0, (yardstick_material){ 0.09, 0.0 });
    for (int i = 0; i < FRAMES; i++) yardstick_step(yard);
    yardstick_vec end = yardstick_body(yard, ball).position;
    yardstick_free(yard);
    return end;
}

static bool same_path(const path *a, const path *b)
{
    for (int i = 0; i <= FRAMES; i++) {
        if (!same_point(a->points[i], b->points[i])) return false;
    }
    return true;
}

typedef struct outcome { path naive, in_turn, deepest; yardstick_vec box; } outcome;

static void run_all(const cluster *c, tuff_body body, outcome *o)
{
    o->naive = naive_path(c, body);
    o->in_turn = tuff_path(c, body, TUFF_ORDER_ITERATION);
    o->deepest = tuff_path(c, body, TUFF_ORDER_DEEPEST);
    o->box = box_end(c, body);
}

static tuff_body falling_body(random_source *source)
{
    tuff_vec2 position = random_point(source, 20.0), velocity = random_point(source, 1.0);
    return (tuff_body){ { position.x, position.y + TUFF_WHOLE(20) }, velocity, NULL };
}

static void test_deepest_first_does_not_show_the_order_of_insertion(void **state)
{
    static cluster c;
    static outcome a, b;
    random_run run = random_cases(__func__, 909, 1000);
    unsigned long naive = 0, in_turn = 0, box = 0, deepest = 0, count = run.end - run.first;
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        make_cluster(&source, &c);
        tuff_body body = falling_body(&source);
        run_all(&c, body, &a);
        shuffle(&source, c.order);
        run_all(&c, body, &b);
        naive += !same_path(&a.naive, &b.naive);
        in_turn += !same_path(&a.in_turn, &b.in_turn);
        box += a.box.x != b.box.x || a.box.y != b.box.y;
        deepest += !same_path(&a.deepest, &b.deepest);
        if (deepest) random_fail(&run, i, "another order of insertion, another path");
    }
    if (count >= 30) assert_true(naive > count / 20 && in_turn > 0);
    printf("figures: by the order of insertion %.0f of 1,000 paths differ in iteration order\n", per_1000(in_turn, count));
    table_row("paths that the order of insertion changes, per 1,000");
    table_fails("textbook", "%.0f", per_1000(naive, count));
    table_box2d("%.0f", per_1000(box, count));
    table_tuff("%.0f", per_1000(deepest, count));
    assert_int_equal(deepest, 0);
}

/* ---- the picture ---- */

static void draw_grid(int left, int bottom, int right, int top)
{
    for (int x = left; x <= right; x += 64) picture_segment(PICTURE_SEAM, "chunks", x, bottom, x, top);
    for (int y = bottom; y <= top; y += 64) picture_segment(PICTURE_SEAM, "chunks", left, y, right, y);
}

/* The chunks that this index asks, a little inside their borders. */
static void draw_asked(naive_index *index, naive_fault fault, query q, picture_role role, double inset)
{
    index->fault = fault;
    double radius = units_of(q.radius);
    span x = chunks_about(index, units_of(q.center.x), radius), y = chunks_about(index, units_of(q.center.y), radius);
    double left = x.low * 64 + inset, right = (x.high + 1) * 64 - inset, bottom = y.low * 64 + inset, top = (y.high + 1) * 64 - inset;
    picture_line(role, role == PICTURE_TUFF ? "chunks that tuff asks" : "chunks that the method asks");
    picture_point(left, bottom);
    picture_point(right, bottom);
    picture_point(right, top);
    picture_point(left, top);
    picture_point(left, bottom);
    picture_line_end();
}

/* tuff keeps large pieces in a list of their own, which every query reads. */
static void draw_missed(naive_fault fault, tuff_terrain piece, query q, bool listed)
{
    naive_index index = { .pitch = 6 };
    naive_insert(&index, &piece, 0);
    draw_asked(&index, fault, q, PICTURE_FAILS, 6.0);
    if (!listed) draw_asked(&index, NAIVE_RIGHT, q, PICTURE_TUFF, 2.0);
    picture_piece(&piece);
    picture_dot(PICTURE_ROCK, units_of(piece.position.x), units_of(piece.position.y));
    picture_circle(PICTURE_BODY, q.center, q.radius);
}

static void draw_path(picture_role role, const path *p, const char *label)
{
    picture_line(role, label);
    for (int i = 0; i <= FRAMES; i++) picture_point(units_of(p->points[i].x), units_of(p->points[i].y));
    picture_line_end();
}

#define SHOWN_CLUSTER 3366     /* the body starts clear of the pieces, and the paths part for good */

static void draw_orders(void)
{
    static cluster c;
    static outcome a, b;
    tuff_body body;
    random_source source = random_stream(911, SHOWN_CLUSTER);
    make_cluster(&source, &c);
    body = falling_body(&source);
    run_all(&c, body, &a);
    shuffle(&source, c.order);
    run_all(&c, body, &b);
    picture_panel("Falling, two orders of insertion", -60.0, -38.0, 60.0, 44.0);
    for (int i = 0; i < CLUSTER; i++) picture_piece(&c.pieces[i]);
    picture_circle(PICTURE_BODY, body.position, TUFF_WHOLE(4));
    draw_path(PICTURE_FAILS, &a.naive, "textbook, either order");
    draw_path(PICTURE_FAILS, &b.naive, "textbook, either order");
    draw_path(PICTURE_TUFF, &a.deepest, "tuff, both orders");
    draw_path(PICTURE_TUFF, &b.deepest, "tuff, both orders");
}

static void draw_picture(void)
{
    const tuff_terrain small = { { TUFF_WHOLE(-86), TUFF_WHOLE(10) }, TUFF_WHOLE(20), TUFF_WHOLE(20), NULL, 0 };
    const tuff_terrain large = { { TUFF_WHOLE(225), TUFF_WHOLE(20) }, TUFF_WHOLE(200), TUFF_WHOLE(200), NULL, 0 };
    if (!picture_begin("index")) return;
    picture_panel("C's division left of zero", -150.0, -78.0, 84.0, 80.0);
    draw_grid(-192, -128, 128, 128);
    draw_missed(NAIVE_DIVISION, small, (query){ { TUFF_WHOLE(-40), TUFF_WHOLE(10) }, TUFF_WHOLE(30) }, false);
    picture_panel("A piece larger than a chunk", -160.0, -184.0, 446.0, 226.0);
    draw_grid(-192, -256, 512, 256);
    draw_missed(NAIVE_BY_CENTER, large, (query){ { TUFF_WHOLE(20), TUFF_WHOLE(20) }, TUFF_WHOLE(16) }, true);
    picture_note(-140.0, -170.0, "tuff: in the list of large ones");
    draw_orders();
    picture_end();
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cs_division_misses_pieces_left_of_zero),
        cmocka_unit_test(test_asking_by_center_misses_pieces_larger_than_a_chunk),
        cmocka_unit_test(test_tight_keys_wrap_at_the_end_of_the_range),
        cmocka_unit_test(test_a_loop_up_to_the_border_misses_what_touches_there),
        cmocka_unit_test(test_box2ds_tree_offers_more_than_touches),
        cmocka_unit_test(test_every_pitch_and_number_of_buckets_gives_the_same_answers),
        cmocka_unit_test(test_stale_and_missing_entries_show_nothing_that_is_not_there),
        cmocka_unit_test(test_pieces_may_be_removed_while_the_answer_is_read),
        cmocka_unit_test(test_an_emptied_index_brings_nothing_back),
        cmocka_unit_test(test_deepest_first_does_not_show_the_order_of_insertion),
    };
    (void)argc;
    random_begin(argv);
    table_family(9, "Index");
    draw_picture();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
