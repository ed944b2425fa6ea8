/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The nearby query against brute force, in random worlds that are edited while they run. */
#include <string.h>

#include "worlds.h"

typedef struct query { tuff_vec2 center; tuff_real radius; } query;

static query make_query(random_source *source, const world_fixture *w)
{
    query q = { world_point(source, w, 1.3), random_point_at(w->size * random_magnitude(source, 0.05, 10.0), 0).x };
    uint32_t kind = random_below(source, 100);
    if (kind < 5) q.radius = 0;
    else if (kind < 8) q.radius = random_point_at(random_within(source, 0.0, 32767.0), 0).x;
    else if (kind < 20) q.center = w->pieces[random_below(source, WORLD_MOST)].position;
    return q;
}

/* A query of a radius that exactly touches some piece's bounding circle: straight along an axis, in whole steps. */
static query make_touching_query(random_source *source, const world_fixture *w)
{
    const tuff_terrain *piece = &w->pieces[random_below(source, WORLD_MOST)];
    tuff_real away = TUFF_WHOLE(random_between(source, 1, 100));
    double x = (double)(exact_real(piece->position.x) - exact_real(away) - exact_real(piece->bounding_radius));
    if (x < -2147483647.0) return make_query(source, w);
    return (query){ { real_from_double(x), piece->position.y }, away };
}

static int count_of(const uint16_t *list, int count, int piece)
{
    int found = 0;
    for (int k = 0; k < count; k++) found += list[k] == piece;
    return found;
}

/* Is piece i in the answer as often as it must be? */
static bool piece_right(const world_fixture *w, int i, query q, int count)
{
    int found = count_of(w->nearby, count, i);
    if (!world_present(w, i)) return found == 0;
    double gap = world_gap(w, i, q.center, q.radius);
    if (gap > WORLD_GAP_ROUNDING) return found == 0;
    if (!world_told(w, i) || gap > -WORLD_GAP_ROUNDING) return found <= 1 && (TUFF_SCALAR == TUFF_FLOAT || !world_told(w, i) || found == 1);
    return found == 1;
}

static bool answer_right(world_fixture *w, query q, uint32_t *found)
{
    w->world.nearby = w->nearby;
    w->world.nearby_capacity = WORLD_MOST;
    int count = tuff_nearby_terrain(&w->world, q.center, q.radius);
    *found += (uint32_t)count;
    if (count > WORLD_MOST) return false;
    for (int i = 0; i < WORLD_MOST; i++) {
        if (!piece_right(w, i, q, count)) return false;
    }
    return true;
}

/* With less room the same count is needed, what fits is the same, and nothing beyond is written. */
static bool short_buffer_right(random_source *source, world_fixture *w, query q)
{
    uint16_t whole[WORLD_MOST];
    uint16_t count = tuff_nearby_terrain(&w->world, q.center, q.radius);
    uint16_t room = (uint16_t)random_below(source, WORLD_MOST);
    memcpy(whole, w->nearby, sizeof whole);
    for (int i = 0; i < WORLD_MOST; i++) w->nearby[i] = 40000;
    w->world.nearby_capacity = room;
    if (tuff_nearby_terrain(&w->world, q.center, q.radius) != count) return false;
    for (int i = 0; i < WORLD_MOST; i++) {
        if (w->nearby[i] != (i < room && i < count ? whole[i] : 40000)) return false;
    }
    w->world.nearby = NULL;
    w->world.nearby_capacity = random_chance(source, 50) ? room : 0;
    return tuff_nearby_terrain(&w->world, q.center, q.radius) == count;
}

/* Without its index the world is searched from end to end: every piece of the array is found. */
static bool linear_right(world_fixture *w, query q)
{
    uint32_t found = 0;
    bool used = world_index_off(w), right = answer_right(w, q, &found);
    world_index_on(w, used);
    return right;
}

static const char *judge_nearby(random_source *source, world_fixture *w, uint32_t *found)
{
    query q = random_chance(source, 20) ? make_touching_query(source, w) : make_query(source, w);
    if (answer_right(w, q, found) && short_buffer_right(source, w, q) && linear_right(w, q)) return NULL;
    return "the nearby pieces are not those that touch";
}

static void test_nearby_finds_exactly_the_pieces_that_touch(void **state)
{
    random_run run = random_cases(__func__, 31, 3000);
    uint32_t found = world_run(&run, 60, judge_nearby), queries = (run.end - run.first) * 60;
    (void)state;
    print_message("figures: " EXACT_BUILD " nearby: %lu queries, %lu pieces found\n", (unsigned long)queries, (unsigned long)found);
    assert_true(found > 0);
}

/* ---- single facts ---- */

/* One piece in an index of this pitch. */
typedef struct single {
    tuff_terrain     piece;
    uint16_t         buckets[2];
    tuff_chunk_entry entries[1];
    tuff_chunks      chunks;
    uint16_t         nearby[1];
    tuff_world       world;
} single;

static void make_single(single *s, tuff_vec2 position, tuff_real bounding_radius, uint16_t pitch)
{
    s->piece = (tuff_terrain){ position, bounding_radius, bounding_radius, NULL, 0 };
    s->chunks = (tuff_chunks){ s->buckets, s->entries, 2, 1, pitch, 0, 0, false };
    s->world = (tuff_world){ &s->piece, 1, &s->chunks, s->nearby, 1, TUFF_ORDER_ITERATION };
    assert_int_equal(tuff_world_index(&s->world), 0);
}

static void test_every_corner_of_the_range_is_found_at_every_pitch(void **state)
{
    static const int signs[4][2] = { { 1, 1 }, { 1, -1 }, { -1, 1 }, { -1, -1 } };
    single s;
    (void)state;
    for (uint16_t pitch = 0; pitch <= TUFF_MAX_PITCH_LOG2; pitch++) {
        for (int k = 0; k < 4; k++) {
            tuff_vec2 corner = random_point_at(32767.0 * signs[k][0], 32767.0 * signs[k][1]);
            tuff_vec2 opposite = { -corner.x, -corner.y };
            make_single(&s, corner, TUFF_WHOLE(3), pitch);
            assert_int_equal(tuff_nearby_terrain(&s.world, corner, 0), 1);
            assert_int_equal(s.nearby[0], 0);
            assert_int_equal(tuff_nearby_terrain(&s.world, opposite, TUFF_WHOLE(32767)), 0);
            assert_int_equal(tuff_nearby_terrain(&s.world, (tuff_vec2){ 0, corner.y }, TUFF_WHOLE(32767)), 1);
        }
    }
}

#if TUFF_SCALAR == TUFF_FLOAT
static void test_the_last_positions_of_the_range_are_found(void **state)
{
    single s;
    (void)state;
    for (uint16_t pitch = 0; pitch <= TUFF_MAX_PITCH_LOG2; pitch++) {
        tuff_vec2 end = { TUFF_MAX_POSITION, -TUFF_MAX_POSITION };
        make_single(&s, end, 1.0f, pitch);
        assert_int_equal(tuff_nearby_terrain(&s.world, end, 1.0f), 1);
        assert_int_equal(tuff_nearby_terrain(&s.world, (tuff_vec2){ 32766.5f, -32766.5f }, 2.0f), 1);
    }
}
#else
static void test_the_last_positions_of_the_range_are_found(void **state)
{
    single s;
    (void)state;
    for (uint16_t pitch = 0; pitch <= TUFF_MAX_PITCH_LOG2; pitch++) {
        tuff_vec2 end = { INT32_MAX, INT32_MIN };
        make_single(&s, end, TUFF_WHOLE(1), pitch);
        assert_int_equal(tuff_nearby_terrain(&s.world, end, 1), 1);
        assert_int_equal(tuff_nearby_terrain(&s.world, (tuff_vec2){ INT32_MIN, INT32_MIN }, INT32_MAX), 0);
    }
}

static void test_a_step_of_distance_decides_over_the_whole_range(void **state)
{
    single s;
    (void)state;
    make_single(&s, (tuff_vec2){ INT32_MAX, 0 }, TUFF_WHOLE(1000), 6);
    assert_int_equal(tuff_nearby_terrain(&s.world, (tuff_vec2){ 0, 0 }, INT32_MAX - TUFF_WHOLE(1000)), 1);
    assert_int_equal(tuff_nearby_terrain(&s.world, (tuff_vec2){ 0, 0 }, INT32_MAX - TUFF_WHOLE(1000) - 1), 0);
    assert_int_equal(tuff_nearby_terrain(&s.world, (tuff_vec2){ -1, 0 }, INT32_MAX - TUFF_WHOLE(1000)), 0);
    assert_int_equal(tuff_nearby_terrain(&s.world, (tuff_vec2){ INT32_MAX, INT32_MIN }, INT32_MAX), 1);
}
#endif

static void test_an_emptied_index_finds_nothing_and_a_cleared_one_scans(void **state)
{
    single s;
    (void)state;
    make_single(&s, (tuff_vec2){ 0, 0 }, TUFF_WHOLE(3), 5);
    assert_true(tuff_chunks_remove(&s.chunks, 0));
    assert_int_equal(tuff_nearby_terrain(&s.world, s.piece.position, 0), 0);
    tuff_chunks_clear(&s.chunks);
    assert_int_equal(tuff_nearby_terrain(&s.world, s.piece.position, 0), 1);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_nearby_finds_exactly_the_pieces_that_touch),
        cmocka_unit_test(test_every_corner_of_the_range_is_found_at_every_pitch),
        cmocka_unit_test(test_the_last_positions_of_the_range_are_found),
#if TUFF_SCALAR == TUFF_Q16_16
        cmocka_unit_test(test_a_step_of_distance_decides_over_the_whole_range),
#endif
        cmocka_unit_test(test_an_emptied_index_finds_nothing_and_a_cleared_one_scans),
    };
    (void)argc;
    random_begin(argv);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
