/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Collide calls over the chunk index, in random worlds that are edited while they run: each push must be the one that comes next
   when all pieces are taken in the promised order, chunk rows by ascending y, then x, within a chunk as inserted. */
#define _POSIX_C_SOURCE 200809L
#include <string.h>
#include <unistd.h>

#include "worlds.h"

/* ---- the promised order ---- */

/* Of the pieces of one chunk, those larger than a chunk come last. */

static int compare_turns(const world_shadow *a, const world_shadow *b)
{
    if (a->chunk_y != b->chunk_y) return a->chunk_y < b->chunk_y ? -1 : 1;
    if (a->chunk_x != b->chunk_x) return a->chunk_x < b->chunk_x ? -1 : 1;
    if (a->large != b->large) return a->large ? 1 : -1;
    return (a->turn > b->turn) - (a->turn < b->turn);
}

/* The pieces that can be found, in the order in which they must push. */
static int list_in_order(const world_fixture *w, int *list)
{
    int count = 0;
    for (int i = 0; i < WORLD_MOST; i++) {
        if (!world_present(w, i)) continue;
        int at = count++;
        while (w->index_used && at > 0 && compare_turns(&w->shadows[i], &w->shadows[list[at - 1]]) < 0) {
            list[at] = list[at - 1];
            at--;
        }
        list[at] = i;
    }
    return count;
}

/* ---- the call and its retelling ---- */

static void make_mover(random_source *source, const world_fixture *w, world_mover *m)
{
    world_make_mover(source, w, m, 40);
    m->body = (tuff_body){ world_point(source, w, 1.0), random_point(source, 20.0), NULL };
}

static bool overlap(const world_fixture *w, int piece, const world_mover *m, const tuff_body *body, tuff_contact *contact)
{
    return tuff_terrain_overlap_hull(&w->pieces[piece], body->position, m->radius, m->hull, contact);
}

/* A piece that touched nothing at the start, or that the index has elsewhere, may stay out of a call that came near it only by a push. */
static bool must_be_visited(const world_fixture *w, int piece, const world_mover *m)
{
    return !w->index_used || (world_told(w, piece) && world_gap(w, piece, m->body.position, m->radius) < -WORLD_GAP_ROUNDING);
}

/* Go through the report, push by push. A piece of one part, or a circle, is pushed once; others until they let go, or until a push
   moves the body nowhere, at the edge of the range or by less than its rounding. */
static bool retell(const world_fixture *w, const world_mover *m, const tuff_touches *told, const tuff_body *end)
{
    int order[WORLD_MOST], next = 0, count = list_in_order(w, order);
    tuff_body body = m->body;
    for (int k = 0; k < count; k++) {
        tuff_touch touch = { (uint16_t)order[k], { 0, { 0, 0 } } };
        while (next < TUFF_MAX_PUSHES && overlap(w, order[k], m, &body, &touch.contact)) {
            if (next >= told->count || !same_touch(&told->list[next], &touch)) {
                if (must_be_visited(w, order[k], m)) return false;
                break;
            }
            tuff_vec2 before = body.position;
            tuff_bounce(&body, &touch.contact);
            next++;
            if (w->pieces[order[k]].part_count < 2 || same_point(body.position, before)) break;
        }
    }
    return next == told->count && same_body(&body, end);
}

static bool collide_right(world_fixture *w, const world_mover *m, uint32_t *pushes)
{
    tuff_touch list[TUFF_MAX_PUSHES];
    tuff_touches touches = { list, TUFF_MAX_PUSHES, 0 };
    tuff_body body = m->body, plain = m->body;
    uint16_t count = tuff_terrain_collide_report(&w->world, &body, m->radius, m->hull, &touches);
    *pushes += count;
    if (count != touches.count || count > TUFF_MAX_PUSHES) return false;
    if (tuff_terrain_collide(&w->world, &plain, m->radius, m->hull) != count || !same_body(&plain, &body)) return false;
    return retell(w, m, &touches, &body);
}

static bool linear_right(world_fixture *w, const world_mover *m, uint32_t *pushes)
{
    bool used = world_index_off(w), right = collide_right(w, m, pushes);
    world_index_on(w, used);
    return right;
}

/* The calls of a frame leave index and terrain alone. */
typedef struct untouched {
    tuff_terrain     pieces[WORLD_MOST];
    uint16_t         buckets[WORLD_BUCKETS];
    tuff_chunk_entry entries[WORLD_MOST];
    tuff_chunks      chunks;
} untouched;

static void remember(const world_fixture *w, untouched *u)
{
    memcpy(u->pieces, w->pieces, sizeof u->pieces);
    memcpy(u->buckets, w->buckets, sizeof u->buckets);
    memcpy(u->entries, w->entries, sizeof u->entries);
    memcpy(&u->chunks, &w->chunks, sizeof u->chunks);
}

static bool is_untouched(const world_fixture *w, const untouched *u)
{
    return memcmp(u->pieces, w->pieces, sizeof u->pieces) == 0 && memcmp(u->buckets, w->buckets, sizeof u->buckets) == 0 &&
           memcmp(u->entries, w->entries, sizeof u->entries) == 0 && memcmp(&u->chunks, &w->chunks, sizeof u->chunks) == 0;
}

static const char *judge_pushes(random_source *source, world_fixture *w, uint32_t *pushes)
{
    static untouched before;
    static world_mover m;
    make_mover(source, w, &m);
    remember(w, &before);
    if (!collide_right(w, &m, pushes) || !linear_right(w, &m, pushes)) return "the pushes are not those of the promised order";
    return is_untouched(w, &before) ? NULL : "the calls changed the index or the terrain";
}

static void test_pushes_come_in_the_promised_order(void **state)
{
    random_run run = random_cases(__func__, 41, 2500);
    uint32_t pushes = world_run(&run, 60, judge_pushes), calls = (run.end - run.first) * 60;
    (void)state;
    print_message("figures: " EXACT_BUILD " chunks: %lu collide calls, %lu pushes\n", (unsigned long)calls, (unsigned long)pushes);
    assert_true(pushes > 0);
}

/* ---- the checks find what the shadow knows ---- */

/* What the checks must say of the index, apart from faults of other kinds, which these worlds do not have. */
static bool index_fault_right(const world_fixture *w, tuff_fault fault)
{
    bool stale = false, missing = false, moved = false, elsewhere = false;
    for (int i = 0; i < WORLD_MOST; i++) {
        bool there = i < w->world.terrain_count && w->pieces[i].bounding_radius > 0;
        stale |= w->index_used && w->shadows[i].held && !there;
        missing |= w->index_used && there && !w->shadows[i].held;
        if (!w->index_used || !there || !w->shadows[i].held) continue;
        const tuff_terrain *piece = &w->pieces[i];
        moved |= !world_told(w, i);
        elsewhere |= world_chunk(w, piece->position.x) != w->shadows[i].chunk_x;
        elsewhere |= world_chunk(w, piece->position.y) != w->shadows[i].chunk_y;
    }
    if (fault == TUFF_FAULT_INDEX_STALE) return stale;
    if (fault == TUFF_FAULT_INDEX_MISSING) return missing;
    if (fault == TUFF_FAULT_INDEX_MOVED) return moved;
    return fault == TUFF_OK && !stale && !missing && !elsewhere;
}

static const char *judge_check(random_source *source, world_fixture *w, uint32_t *counted)
{
    uint16_t piece;
    tuff_fault fault = tuff_check_world(&w->world, &piece);
    (void)source;
    (void)counted;
    if (index_fault_right(w, fault)) return NULL;
    print_error("the check says: %s\n", tuff_fault_text(fault));
    return "the check is wrong about the index";
}

static void test_the_checks_name_what_is_wrong_with_the_index(void **state)
{
    random_run run = random_cases(__func__, 42, 1000);
    (void)state;
    world_run(&run, 100, judge_check);
}

/* ---- single facts ---- */

#define ROOM 4
typedef struct small_index {
    uint16_t         buckets[2];
    tuff_chunk_entry entries[ROOM];
    tuff_chunks      chunks;
    tuff_terrain     pieces[ROOM];
    uint16_t         nearby[ROOM];
    tuff_world       world;
} small_index;

static void make_small(small_index *s)
{
    *s = (small_index){ .chunks = { s->buckets, s->entries, 2, ROOM, 4, 0, 0, false } };
    for (int i = 0; i < ROOM; i++) s->pieces[i] = (tuff_terrain){ { TUFF_WHOLE(i), 0 }, TUFF_WHOLE(1), TUFF_WHOLE(1), NULL, 0 };
    s->world = (tuff_world){ s->pieces, ROOM, &s->chunks, s->nearby, ROOM, TUFF_ORDER_ITERATION };
    assert_int_equal(tuff_world_index(&s->world), 0);
}

static void test_a_refused_entry_changes_nothing(void **state)
{
    small_index s;
    tuff_chunk_entry entries[ROOM];
    (void)state;
    make_small(&s);
    memcpy(entries, s.entries, sizeof entries);
    assert_false(tuff_chunks_insert(&s.chunks, ROOM, (tuff_vec2){ 0, 0 }, TUFF_WHOLE(1)));
    assert_false(tuff_chunks_insert(&s.chunks, 65535, (tuff_vec2){ 0, 0 }, TUFF_WHOLE(1)));
    assert_false(tuff_chunks_move(&s.chunks, 1, (tuff_vec2){ 0, 0 }, -TUFF_WHOLE(1)));
    assert_false(tuff_chunks_move(&s.chunks, 1, (tuff_vec2){ 0, 0 }, TUFF_WHOLE(TUFF_MAX_BOUNDING_RADIUS + 1)));
    assert_false(tuff_chunks_remove(&s.chunks, ROOM));
    assert_false(tuff_chunks_remove(&s.chunks, 65535));
    assert_false(tuff_chunks_insert(NULL, 0, (tuff_vec2){ 0, 0 }, TUFF_WHOLE(1)));
    assert_false(tuff_chunks_remove(NULL, 0));
    tuff_chunks_clear(NULL);
    assert_memory_equal(entries, s.entries, sizeof entries);
    assert_int_equal(tuff_nearby_terrain(&s.world, (tuff_vec2){ 0, 0 }, TUFF_WHOLE(9)), ROOM);
}

static void test_world_index_counts_what_it_could_not_hold(void **state)
{
    small_index s;
    (void)state;
    make_small(&s);
    s.chunks.capacity = 1;
    assert_int_equal(tuff_world_index(&s.world), ROOM - 1);
    assert_int_equal(tuff_nearby_terrain(&s.world, (tuff_vec2){ 0, 0 }, TUFF_WHOLE(9)), 1);
    s.chunks.capacity = ROOM - 1;
    s.pieces[2] = (tuff_terrain){ .part_count = 0 };
    assert_int_equal(tuff_world_index(&s.world), 1);
    assert_int_equal(tuff_nearby_terrain(&s.world, (tuff_vec2){ 0, 0 }, TUFF_WHOLE(9)), ROOM - 2);
}

static void test_an_index_without_room_scans(void **state)
{
    small_index s;
    (void)state;
    make_small(&s);
    s.chunks = (tuff_chunks){ NULL, NULL, 0, 0, 4, 0, 0, false };
    assert_false(tuff_chunks_insert(&s.chunks, 0, (tuff_vec2){ 0, 0 }, TUFF_WHOLE(1)));
    assert_int_equal(tuff_nearby_terrain(&s.world, (tuff_vec2){ 0, 0 }, TUFF_WHOLE(9)), ROOM);
}

/* Insert, move and remove of most piece numbers that there are. */
static void test_the_largest_world_fits(void **state)
{
    static tuff_terrain pieces[TUFF_MAX_PIECES];
    static tuff_chunk_entry entries[TUFF_MAX_PIECES];
    static uint16_t buckets[32768];
    static uint16_t nearby[4];
    tuff_chunks chunks = TUFF_CHUNKS(buckets, entries, 6);
    tuff_world world = { pieces, TUFF_MAX_PIECES, &chunks, nearby, 4, TUFF_ORDER_ITERATION };
    uint16_t fault;
    (void)state;
    for (int i = 0; i < TUFF_MAX_PIECES; i++) {
        tuff_vec2 position = { TUFF_WHOLE(i % 256 * 200 - 25600), TUFF_WHOLE(i / 256 * 200 - 25600) };
        pieces[i] = (tuff_terrain){ position, TUFF_WHOLE(20), TUFF_WHOLE(20), NULL, 0 };
    }
    assert_int_equal(tuff_world_index(&world), 0);
    assert_int_equal(tuff_check_world(&world, &fault), TUFF_OK);
    for (int i = 0; i < TUFF_MAX_PIECES; i += 97) {
        assert_int_equal(tuff_nearby_terrain(&world, pieces[i].position, TUFF_WHOLE(100)), 1);
        assert_int_equal(nearby[0], i);
        assert_true(tuff_chunks_remove(&chunks, (uint16_t)i));
        assert_int_equal(tuff_nearby_terrain(&world, pieces[i].position, TUFF_WHOLE(100)), 0);
    }
    assert_true(tuff_chunks_move(&chunks, TUFF_MAX_PIECES - 1, (tuff_vec2){ 0, 0 }, TUFF_WHOLE(20)));
    assert_int_equal(tuff_check_world(&world, &fault), TUFF_FAULT_INDEX_MISSING);
}

/* An array may be larger than there can be pieces: the number that ends lists is no link then either. A walk without end is ended by the
   alarm, and the program with it. */
static void test_more_entries_than_pieces_do_no_harm(void **state)
{
    static tuff_chunk_entry entries[65535];
    static uint16_t buckets[1];
    static uint16_t nearby[4];
    tuff_terrain pieces[3];
    tuff_chunks chunks = TUFF_CHUNKS(buckets, entries, 4);
    tuff_world world = { pieces, 3, &chunks, nearby, 4, TUFF_ORDER_ITERATION };
    uint16_t fault;
    (void)state;
    alarm(20);
    for (int i = 0; i < 3; i++) pieces[i] = (tuff_terrain){ { 0, 0 }, TUFF_WHOLE(2), TUFF_WHOLE(i == 1 ? 200 : 2), NULL, 0 };
    assert_int_equal(tuff_world_index(&world), 0);
    assert_int_equal(tuff_check_world(&world, &fault), TUFF_OK);
    assert_int_equal(tuff_nearby_terrain(&world, pieces[0].position, 0), 3);
    assert_int_equal(nearby[0] + nearby[1] + nearby[2], 3);
    assert_false(tuff_chunks_insert(&chunks, TUFF_MAX_PIECES, pieces[0].position, TUFF_WHOLE(2)));
    for (uint16_t i = 0; i < 3; i++) assert_true(tuff_chunks_remove(&chunks, i));
    assert_false(tuff_chunks_remove(&chunks, 1));
    assert_int_equal(tuff_nearby_terrain(&world, pieces[0].position, 0), 0);
    alarm(0);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pushes_come_in_the_promised_order),
        cmocka_unit_test(test_the_checks_name_what_is_wrong_with_the_index),
        cmocka_unit_test(test_a_refused_entry_changes_nothing),
        cmocka_unit_test(test_world_index_counts_what_it_could_not_hold),
        cmocka_unit_test(test_an_index_without_room_scans),
        cmocka_unit_test(test_the_largest_world_fits),
        cmocka_unit_test(test_more_entries_than_pieces_do_no_harm),
    };
    (void)argc;
    random_begin(argv);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
