/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Collide calls: deepest first and in turn, reports, materials, floaters, and the calls for circles only. Numbers are compared bit for bit
   in both builds: the same call on the same input is the same arithmetic. */
#define _GNU_SOURCE
#include <string.h>
#include <sys/mman.h>

#include "worlds.h"

/* ---- a body among pieces ---- */

static void make_mover(random_source *source, const world_fixture *w, world_mover *m)
{
    world_make_mover(source, w, m, 50);
    m->material.restitution = random_point_at(random_within(source, 0.0, 1.5), 0).x;
    m->material.friction = random_point_at(random_fraction(source), 0).x;
    m->body = (tuff_body){ world_point(source, w, 1.0), random_point(source, 20.0), random_chance(source, 50) ? &m->material : NULL };
}

typedef struct outcome {
    tuff_body    body;
    tuff_touch   list[TUFF_MAX_PUSHES];
    tuff_touches touches;
    uint16_t     pushes;
} outcome;

static outcome collide(const tuff_world *world, const world_mover *m)
{
    outcome o = { .body = m->body };
    o.touches = (tuff_touches){ o.list, TUFF_MAX_PUSHES, 12345 };
    o.pushes = tuff_terrain_collide_report(world, &o.body, m->radius, m->hull, &o.touches);
    return o;
}

static bool same_outcome(const outcome *a, const outcome *b)
{
    if (a->pushes != b->pushes || a->touches.count != b->touches.count || !same_body(&a->body, &b->body)) return false;
    for (int i = 0; i < a->touches.count; i++) {
        if (!same_touch(&a->list[i], &b->list[i])) return false;
    }
    return true;
}

/* Insert all pieces, in an order of its own. */
static void index_shuffled(random_source *source, world_fixture *w)
{
    int order[WORLD_MOST];
    tuff_chunks_clear(&w->chunks);
    w->chunks.capacity = WORLD_MOST;
    for (int i = 0; i < WORLD_MOST; i++) order[i] = i;
    for (int i = WORLD_MOST - 1; i > 0; i--) {
        int other = (int)random_below(source, (uint32_t)i + 1), swapped = order[i];
        order[i] = order[other];
        order[other] = swapped;
    }
    for (int i = 0; i < WORLD_MOST; i++) {
        const tuff_terrain *piece = &w->pieces[order[i]];
        assert_true(tuff_chunks_insert(&w->chunks, (uint16_t)order[i], piece->position, piece->bounding_radius));
    }
}

/* NULL: all is well. Otherwise what is wrong; counted is what the test counts. */
typedef const char *mover_judge(random_source *source, world_fixture *w, world_mover *m, uint32_t *counted);

/* A world for each case, without its index yet, and a mover for the judge to make. What was counted. */
static uint32_t run_movers(const random_run *run, mover_judge *judge)
{
    static world_fixture w;
    static world_mover m;
    uint32_t counted = 0;
    for (uint32_t i = run->first; i < run->end; i++) {
        random_source source = random_stream(run->seed, i);
        world_make(&source, &w);
        const char *fault = judge(&source, &w, &m, &counted);
        if (fault) random_fail(run, i, "%s", fault);
    }
    return counted;
}

/* A mover, an index in an order of its own, and either order of pushes. */
static void make_indexed(random_source *source, world_fixture *w, world_mover *m)
{
    make_mover(source, w, m);
    index_shuffled(source, w);
    w->world.order = (uint8_t)random_below(source, 2);
}

/* ---- deepest first ---- */

/* How many pieces the body meets, and the deepest contact of all, lowest number first. */
static int find_deepest(const world_fixture *w, const world_mover *m, const tuff_body *body, tuff_touch *deepest)
{
    int met = 0;
    for (int i = 0; i < WORLD_MOST; i++) {
        tuff_contact contact;
        if (!tuff_terrain_overlap_hull(&w->pieces[i], body->position, m->radius, m->hull, &contact)) continue;
        if (met++ == 0 || contact.overlap > deepest->contact.overlap) *deepest = (tuff_touch){ (uint16_t)i, contact };
    }
    return met;
}

/* The deepest contact of all, again and again; a push that moves the body nowhere, at the edge of the range or by less than its rounding,
   is the last. *seams: a hull met several pieces, where it is not the contacts with each that tell the way out. */
static outcome retell_deepest(const world_fixture *w, const world_mover *m, bool *seams)
{
    outcome o = { .body = m->body };
    bool moved = true;
    *seams = false;
    while (moved && o.pushes < TUFF_MAX_PUSHES) {
        int met = find_deepest(w, m, &o.body, &o.list[o.pushes]);
        if (met == 0) break;
        *seams = *seams || (m->hull && (met > 1 || o.list[o.pushes].piece != o.list[0].piece));
        tuff_vec2 before = o.body.position;
        tuff_bounce(&o.body, &o.list[o.pushes].contact);
        moved = !same_point(o.body.position, before);
        o.pushes++;
    }
    o.touches.count = o.pushes;
    return o;
}

static bool overlaps(const world_fixture *w, const world_mover *m, const tuff_body *body, uint16_t piece, tuff_contact *contact)
{
    return tuff_terrain_overlap_hull(&w->pieces[piece], body->position, m->radius, m->hull, contact);
}

/* What a push off a piece of one part may leave: 2 LSB, or float's steps of position and sizes here. */
static bool is_left_over(const tuff_contact *contact)
{
    return contact->overlap <= (TUFF_SCALAR == TUFF_Q16_16 ? TUFF_REAL_RAW(2) : TUFF_RATIO(1, 50));
}

/* Of the range, where a push stops short. */
static bool at_the_edge(tuff_vec2 position)
{
    return fabs(units_of(position.x)) > 32767.9 || fabs(units_of(position.y)) > 32767.9;
}

/* Where seams have a say: each push is off a piece that the body is in, by no less than the shortest way and far enough to leave it, if it
   is of one part; and the pushes told make the body's way. */
static bool ways_out(const world_fixture *w, const world_mover *m, const outcome *o)
{
    tuff_body body = m->body;
    for (int i = 0; i < o->touches.count; i++) {
        const tuff_touch *touch = &o->list[i];
        tuff_contact least, left;
        bool one_part = w->pieces[touch->piece].part_count == 1;
        if (!overlaps(w, m, &body, touch->piece, &least)) return false;
        if (one_part && touch->contact.overlap < least.overlap) return false;
        tuff_vec2 before = body.position;
        tuff_bounce(&body, &touch->contact);
        bool saturated = same_point(before, body.position) || at_the_edge(body.position);
        if (one_part && !saturated && overlaps(w, m, &body, touch->piece, &left) && !is_left_over(&left)) return false;
    }
    return same_body(&body, &o->body);
}

static bool deepest_right(random_source *source, world_fixture *w, const world_mover *m, uint32_t *pushes)
{
    w->world.order = TUFF_ORDER_DEEPEST;
    index_shuffled(source, w);
    bool seams;
    outcome told = retell_deepest(w, m, &seams), indexed = collide(&w->world, m);
    index_shuffled(source, w);
    outcome again = collide(&w->world, m);
    w->world.chunks = NULL;
    outcome linear = collide(&w->world, m);
    w->world.chunks = &w->chunks;
    *pushes += told.pushes;
    bool right = seams ? ways_out(w, m, &indexed) : same_outcome(&told, &indexed);
    return right && same_outcome(&indexed, &again) && same_outcome(&indexed, &linear);
}

static const char *judge_deepest(random_source *source, world_fixture *w, world_mover *m, uint32_t *pushes)
{
    world_add_twins(source, w, 6);
    make_mover(source, w, m);
    if (deepest_right(source, w, m, pushes)) return NULL;
    return "the deepest contact, lowest number first, was not taken, or the order of insertion shows";
}

static void test_deepest_first_depends_on_no_insertion_order(void **state)
{
    random_run run = random_cases(__func__, 51, 25000);
    uint32_t pushes = run_movers(&run, judge_deepest);
    (void)state;
    print_message("figures: " EXACT_BUILD " order: %lu calls deepest first, %lu pushes\n", (unsigned long)(run.end - run.first),
                  (unsigned long)pushes);
    assert_true(pushes > 0);
}

static void test_equal_depths_go_to_the_lowest_number(void **state)
{
    tuff_terrain pieces[3];
    tuff_touch list[2];
    tuff_touches touches = { list, 2, 0 };
    tuff_chunk_entry entries[3];
    uint16_t buckets[2];
    tuff_chunks chunks = TUFF_CHUNKS(buckets, entries, 5);
    tuff_world world = { pieces, 3, &chunks, NULL, 0, TUFF_ORDER_DEEPEST };
    tuff_body body = { { 0, 0 }, { 0, 0 }, NULL };
    (void)state;
    for (int i = 0; i < 3; i++) {
        tuff_vec2 position = { TUFF_WHOLE(i == 1 ? 0 : 6), TUFF_WHOLE(i == 1 ? 6 : 0) };
        pieces[i] = (tuff_terrain){ position, TUFF_WHOLE(5), TUFF_WHOLE(5), NULL, 0 };
    }
    for (uint16_t i = 3; i-- > 0;) assert_true(tuff_chunks_insert(&chunks, i, pieces[i].position, pieces[i].bounding_radius));
    assert_in_range(tuff_terrain_collide_report(&world, &body, TUFF_WHOLE(2), NULL, &touches), 2, 4);
    assert_int_equal(list[0].piece, 0);
    assert_int_equal(list[1].piece, 1);
    assert_true(list[0].contact.overlap == TUFF_WHOLE(1));
}

/* ---- the limit of pushes ---- */

/* Two slabs, sloping by 5 degrees, meet below the body: pushes from wall to wall would go on and on. */
static void test_a_wedge_takes_no_more_than_the_most_pushes(void **state)
{
    tuff_vec2 vertices[2][3] = { { { 0, 0 }, { TUFF_WHOLE(23), TUFF_WHOLE(500) }, { TUFF_WHOLE(500), 0 } },
                                 { { 0, 0 }, { -TUFF_WHOLE(500), 0 }, { -TUFF_WHOLE(23), TUFF_WHOLE(500) } } };
    tuff_unit2 normals[2][3];
    tuff_polygon parts[2];
    tuff_terrain pieces[2];
    tuff_touch list[TUFF_MAX_PUSHES + 1];
    (void)state;
    for (int i = 0; i < 2; i++) {
        tuff_edge_normals(vertices[i], 3, normals[i]);
        parts[i] = (tuff_polygon){ vertices[i], normals[i], 0, 3 };
        pieces[i] = (tuff_terrain){ { 0, 0 }, TUFF_WHOLE(501), TUFF_WHOLE(501), &parts[i], 1 };
        assert_int_equal(tuff_check_terrain(&pieces[i]), TUFF_OK);
    }
    tuff_touches touches = { list, TUFF_MAX_PUSHES + 1, 0 };
    tuff_body body = { { 0, TUFF_WHOLE(100) }, { 0, -TUFF_WHOLE(1) }, NULL };
    uint16_t pushes = tuff_floater_collide_report(&body, TUFF_WHOLE(20), pieces, 2, NULL, TUFF_ORDER_DEEPEST, &touches);
    assert_int_equal(pushes, TUFF_MAX_PUSHES);
    assert_int_equal(touches.count, TUFF_MAX_PUSHES);
    assert_true(body.position.y > TUFF_WHOLE(100));
}

/* ---- reports ---- */

/* What a report with less room, none, or no report at all must have in common with a whole one. */
static bool report_right(random_source *source, const world_fixture *w, const world_mover *m, uint32_t *cut_off)
{
    outcome whole = collide(&w->world, m);
    tuff_touch list[TUFF_MAX_PUSHES];
    uint16_t room = (uint16_t)random_below(source, 4);
    tuff_touches touches = { room ? list : NULL, room, 777 };
    tuff_body body = m->body, plain = m->body, replayed = m->body;
    memset(list, 0, sizeof list);
    if (whole.pushes != whole.touches.count || whole.pushes > TUFF_MAX_PUSHES) return false;
    if (tuff_terrain_collide_report(&w->world, &body, m->radius, m->hull, &touches) != whole.pushes) return false;
    if (touches.count != whole.pushes || !same_body(&body, &whole.body)) return false;
    for (int i = 0; i < TUFF_MAX_PUSHES; i++) {
        bool fits = i < room && i < touches.count;
        if (!(fits ? same_touch(&list[i], &whole.list[i]) : list[i].contact.overlap == 0)) return false;
    }
    for (int i = 0; i < whole.pushes; i++) tuff_bounce(&replayed, &whole.list[i].contact);
    *cut_off += whole.pushes > room;
    return tuff_terrain_collide(&w->world, &plain, m->radius, m->hull) == whole.pushes && same_body(&plain, &whole.body) &&
           same_body(&replayed, &whole.body);
}

static const char *judge_report(random_source *source, world_fixture *w, world_mover *m, uint32_t *cut_off)
{
    make_indexed(source, w, m);
    return report_right(source, w, m, cut_off) ? NULL : "the report does not fit the pushes";
}

static void test_reports_tell_each_push_and_how_many_there_were(void **state)
{
    random_run run = random_cases(__func__, 52, 20000);
    uint32_t cut_off = run_movers(&run, judge_report);
    (void)state;
    if (run.end - run.first > 1) assert_true(cut_off > 0);
}

/* ---- other ways to say the same ---- */

/* NULL is the default material; a circle is a hull of NULL or of fewer than 3 vertices; floaters are a world without an index. */
static bool ways_agree(const world_fixture *w, const world_mover *m)
{
    tuff_world linear = w->world;
    linear.chunks = NULL;
    outcome o = collide(&linear, m);
    tuff_body named = m->body, floating = m->body;
    tuff_touch list[TUFF_MAX_PUSHES];
    tuff_touches touches = { list, TUFF_MAX_PUSHES, 0 };
    if (named.material == NULL) named.material = &tuff_default_material;
    if (tuff_terrain_collide(&linear, &named, m->radius, m->hull) != o.pushes) return false;
    named.material = m->body.material;
    if (!same_body(&named, &o.body)) return false;
    if (tuff_floater_collide_report(&floating, m->radius, w->pieces, WORLD_MOST, m->hull, linear.order, &touches) != o.pushes) return false;
    if (!same_body(&floating, &o.body) || touches.count != o.pushes) return false;
    floating = m->body;
    if (linear.order != TUFF_ORDER_ITERATION) return true;
    return tuff_floater_collide(&floating, m->radius, w->pieces, WORLD_MOST, m->hull) == o.pushes && same_body(&floating, &o.body);
}

static bool circle_ways_agree(const world_fixture *w, const world_mover *m)
{
    tuff_vec2 vertices[2] = { { 0, 0 }, { TUFF_WHOLE(1), 0 } };
    tuff_polygon stick = { vertices, NULL, 0, 2 };
    world_mover circle = { .hull = NULL, .radius = m->radius, .body = m->body };
    outcome o = collide(&w->world, &circle);
    tuff_body body = m->body, other = m->body, floating = m->body, floating_circle = m->body;
    if (tuff_terrain_collide_circle(&w->world, &body, m->radius) != o.pushes || !same_body(&body, &o.body)) return false;
    if (tuff_terrain_collide(&w->world, &other, m->radius, &stick) != o.pushes || !same_body(&other, &o.body)) return false;
    uint16_t pushes = tuff_floater_collide(&floating, m->radius, w->pieces, WORLD_MOST, NULL);
    if (tuff_floater_collide_circle(&floating_circle, m->radius, w->pieces, WORLD_MOST) != pushes) return false;
    return same_body(&floating, &floating_circle);
}

/* A hull's normals, made by the call or given. */
static bool normals_agree(const world_fixture *w, const world_mover *m)
{
    tuff_polygon bare = m->shape.polygon;
    world_mover other = *m;
    if (m->hull == NULL) return true;
    bare.normals = NULL;
    other.hull = &bare;
    outcome given = collide(&w->world, m), made = collide(&w->world, &other);
    return same_outcome(&given, &made);
}

static const char *judge_ways(random_source *source, world_fixture *w, world_mover *m, uint32_t *counted)
{
    (void)counted;
    make_indexed(source, w, m);
    if (!ways_agree(w, m)) return "floaters or the default material differ";
    if (!circle_ways_agree(w, m)) return "the circle calls differ";
    return normals_agree(w, m) ? NULL : "normals made by the call differ from given ones";
}

static void test_the_same_call_in_other_words_gives_the_same_bits(void **state)
{
    random_run run = random_cases(__func__, 53, 20000);
    (void)state;
    run_movers(&run, judge_ways);
}

static void test_a_material_of_the_bodys_own_is_used(void **state)
{
    tuff_terrain ball = { { 0, 0 }, TUFF_WHOLE(5), TUFF_WHOLE(5), NULL, 0 };
    tuff_material bumper = { TUFF_WHOLE(2), 0 };
    tuff_body plain = { { TUFF_WHOLE(6), 0 }, { -TUFF_WHOLE(3), TUFF_WHOLE(4) }, NULL }, bouncing = plain;
    (void)state;
    bouncing.material = &bumper;
    assert_int_equal(tuff_floater_collide_circle(&plain, TUFF_WHOLE(2), &ball, 1), 1);
    assert_int_equal(tuff_floater_collide_circle(&bouncing, TUFF_WHOLE(2), &ball, 1), 1);
    assert_true(bouncing.velocity.x == TUFF_WHOLE(6) && bouncing.velocity.y == TUFF_WHOLE(4));
    assert_true(plain.velocity.x > TUFF_RATIO(26, 100) && plain.velocity.x < TUFF_RATIO(28, 100));
    assert_true(plain.velocity.y > TUFF_RATIO(395, 100) && plain.velocity.y < TUFF_RATIO(397, 100));
}

/* ---- a hull is read only where it is needed ---- */

/* Its vertices lie in a page that may not be read. */
static void test_a_hull_far_from_all_pieces_is_not_read(void **state)
{
    void *page = mmap(NULL, 4096, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    tuff_polygon hull = { (const tuff_vec2 *)page, NULL, 0, 5 };
    tuff_terrain ball = { { 0, 0 }, TUFF_WHOLE(5), TUFF_WHOLE(5), NULL, 0 };
    tuff_body body = { { TUFF_WHOLE(20), 0 }, { -TUFF_WHOLE(3), 0 }, NULL };
    (void)state;
    assert_true(page != MAP_FAILED);
    assert_int_equal(tuff_floater_collide(&body, TUFF_WHOLE(8), &ball, 1, &hull), 0);
    assert_int_equal(tuff_floater_collide_report(&body, TUFF_WHOLE(8), &ball, 1, &hull, TUFF_ORDER_DEEPEST, NULL), 0);
    assert_int_equal(munmap(page, 4096), 0);
}

/* ---- flush seams ---- */

/* A ball slides along a floor of flush boxes, a little into it all the time: deepest first, every push is straight up. Over a seam the
   two boxes may tie, and the corner of one tilt the push by less than shows. */
static void test_deepest_first_slides_over_flush_seams(void **state)
{
    static random_shape boxes[WORLD_MOST];
    tuff_terrain floor_pieces[WORLD_MOST];
    random_run run = random_cases(__func__, 54, 300);
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        int left = -200;
        for (int k = 0; k < WORLD_MOST; k++) {
            int wide = random_between(&source, 1, 12);
            tuff_vec2 corners[4] = { { TUFF_WHOLE(-wide), TUFF_WHOLE(-20) }, { TUFF_WHOLE(wide), TUFF_WHOLE(-20) },
                                     { TUFF_WHOLE(wide), 0 }, { TUFF_WHOLE(-wide), 0 } };
            memcpy(boxes[k].vertices, corners, sizeof corners);
            random_renumber(&source, boxes[k].vertices, 4);
            random_bake(&boxes[k], 4);
            tuff_real cover = boxes[k].bounding_radius;
            floor_pieces[k] = (tuff_terrain){ { TUFF_WHOLE(left + wide), 0 }, cover, cover, &boxes[k].polygon, 1 };
            left += 2 * wide;
        }
        tuff_real speed = random_point_at(random_within(&source, 0.1, 3.0), 0).x;
        tuff_real radius = random_point_at(random_within(&source, 4.0, 8.0), 0).x;
        tuff_real slowest = speed - speed / 256;
        tuff_material ice = { 0, 0 };
        tuff_body body = { { TUFF_WHOLE(-190), radius }, { speed, 0 }, &ice };
        uint32_t pushes = 0;
        while (body.position.x < TUFF_WHOLE(left - 10)) {
            body.velocity.y -= TUFF_RATIO(1, 8);
            body.position.x += body.velocity.x;
            body.position.y += body.velocity.y;
            pushes += tuff_floater_collide_report(&body, radius, floor_pieces, WORLD_MOST, NULL, TUFF_ORDER_DEEPEST, NULL);
            if (body.velocity.x > slowest && body.position.y >= radius - TUFF_RATIO(1, 1000)) continue;
            random_fail(&run, i, "the ball was held up at a seam");
        }
        assert_true(pushes > 0);
    }
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_deepest_first_depends_on_no_insertion_order),
        cmocka_unit_test(test_equal_depths_go_to_the_lowest_number),
        cmocka_unit_test(test_a_wedge_takes_no_more_than_the_most_pushes),
        cmocka_unit_test(test_reports_tell_each_push_and_how_many_there_were),
        cmocka_unit_test(test_the_same_call_in_other_words_gives_the_same_bits),
        cmocka_unit_test(test_a_material_of_the_bodys_own_is_used),
        cmocka_unit_test(test_a_hull_far_from_all_pieces_is_not_read),
        cmocka_unit_test(test_deepest_first_slides_over_flush_seams),
    };
    (void)argc;
    random_begin(argv);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
