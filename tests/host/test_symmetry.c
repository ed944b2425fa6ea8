/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Mirrored and turned scenes give mirrored and turned answers: one contact, and whole calls that push deepest first. Mirrored means
   coordinates and normals negated in x, all indices kept. Bit for bit in the fixed build, within rounding in the float build. */
#include <string.h>

#include "rocks.h"
#include "same.h"
#include "turned.h"

#define MOST_PIECES 8

/* ---- comparing ---- */

/* Equal in the fixed build; within so many units, or parts of a unit vector, in the float build. */
static bool same_real(tuff_real a, tuff_real b, double tolerance)
{
    if (TUFF_SCALAR == TUFF_Q16_16) return a == b;
    return fabs((double)a - (double)b) <= tolerance;
}

static bool same_vec2(tuff_vec2 a, tuff_vec2 b, double tolerance)
{
    return same_real(a.x, b.x, tolerance) && same_real(a.y, b.y, tolerance);
}

static bool same_unit2(tuff_unit2 a, tuff_unit2 b, double tolerance)
{
    return same_vec2((tuff_vec2){ (tuff_real)a.x, (tuff_real)a.y }, (tuff_vec2){ (tuff_real)b.x, (tuff_real)b.y }, tolerance);
}

static bool same_contact(int transform, const tuff_contact *plain, const tuff_contact *turned)
{
    return same_real(plain->overlap, turned->overlap, 1e-4) && same_unit2(apply_unit(transform, plain->normal), turned->normal, 1e-4);
}

/* ---- scenes ---- */

typedef struct scene {
    random_shape shapes[MOST_PIECES];
    rock         rocks[2];
    random_shape hull;
    bool         with_hull;
    tuff_terrain pieces[MOST_PIECES];
    uint16_t     count;
    tuff_body    body;
    tuff_material material;
    tuff_real    radius;
} scene;

/* A box or another figure on whole units, which has many ties. */
static void make_tied_shape(random_source *source, random_shape *shape)
{
    tuff_real wide = TUFF_WHOLE(random_between(source, 1, 8)), high = TUFF_WHOLE(random_between(source, 1, 8));
    random_box_shape(shape, (tuff_vec2){ wide, high });
    random_renumber(source, shape->vertices, 4);
    random_bake(shape, 4);
}

static void make_shape(random_source *source, random_shape *shape)
{
    if (random_chance(source, 40)) make_tied_shape(source, shape);
    else random_rock_shape(source, shape, 12, random_magnitude(source, 2.0, 40.0));
}

static tuff_vec2 make_position(random_source *source, int extent)
{
    if (random_chance(source, 60)) return random_point(source, extent);
    return (tuff_vec2){ TUFF_WHOLE(random_between(source, -extent, extent)), TUFF_WHOLE(random_between(source, -extent, extent)) };
}

static tuff_terrain make_piece(random_source *source, scene *s, int i)
{
    tuff_vec2 position = make_position(source, 30);
    if (i < 2 && random_chance(source, 40)) {
        rock_make(source, &s->rocks[i], (int)random_below(source, ROCK_KINDS), random_magnitude(source, 6.0, 40.0));
        return rock_terrain(&s->rocks[i], position);
    }
    if (random_chance(source, 15)) {
        tuff_real radius = TUFF_WHOLE(random_between(source, 1, 20));
        return (tuff_terrain){ position, radius, radius, NULL, 0 };
    }
    make_shape(source, &s->shapes[i]);
    return (tuff_terrain){ position, s->shapes[i].bounding_radius, s->shapes[i].bounding_radius, &s->shapes[i].polygon, 1 };
}

static void make_scene(random_source *source, scene *s, int pieces)
{
    s->count = (uint16_t)pieces;
    for (int i = 0; i < pieces; i++) s->pieces[i] = make_piece(source, s, i);
    s->with_hull = random_chance(source, 50);
    make_shape(source, &s->hull);
    if (random_chance(source, 50)) s->hull.polygon.normals = NULL;
    s->radius = s->with_hull ? s->hull.bounding_radius : random_point_at(random_magnitude(source, 0.5, 20.0), 0).x;
    s->material = (tuff_material){ random_point_at(random_within(source, 0.0, 1.5), 0).x, random_point_at(random_fraction(source), 0).x };
    s->body = (tuff_body){ make_position(source, 30), random_point(source, 10.0), random_chance(source, 50) ? &s->material : NULL };
}

/* Does some piece, or the hull's box, lie exactly about the body's position? There the push goes along +x, whichever way it is turned. */
static bool coincident(const scene *s)
{
    for (int i = 0; i < s->count; i++) {
        if (same_point(s->pieces[i].position, s->body.position)) return true;
    }
    return false;
}

/* Does the scene, mirrored or turned, give the mirrored or turned answer? Counts what the plain scene had to answer. */
typedef bool scene_judge(const scene *s, int transform, uint32_t *counted);

/* Scenes of one piece, or of up to most, in all transforms. What was counted. */
static uint32_t run_scenes(const random_run *run, int most, scene_judge *judge)
{
    static scene s;
    uint32_t counted = 0;
    for (uint32_t i = run->first; i < run->end; i++) {
        random_source source = random_stream(run->seed, i);
        make_scene(&source, &s, most > 1 ? random_between(&source, 1, most) : 1);
        if (coincident(&s)) continue;
        for (int transform = 0; transform < TRANSFORMS; transform++) {
            if (!judge(&s, transform, &counted)) random_fail(run, i, "the %s answer differs", transform_names[transform]);
        }
    }
    return counted;
}

/* ---- one contact ---- */

static bool contact_of(const tuff_terrain *piece, const scene *s, tuff_vec2 position, const tuff_polygon *hull, tuff_contact *contact)
{
    return hull ? tuff_terrain_overlap_hull(piece, position, s->radius, hull, contact)
                : tuff_terrain_overlap_circle(piece, position, s->radius, contact);
}

static bool contact_turns(const scene *s, int transform, uint32_t *overlaps)
{
    static copies made;
    made.count = 0;
    tuff_contact plain = { 0, { 0, 0 } }, turned = { 0, { 0, 0 } };
    tuff_terrain piece = copy_terrain(&made, transform, &s->pieces[0]);
    const tuff_polygon *hull = s->with_hull ? &s->hull.polygon : NULL;
    const tuff_polygon *turned_hull = hull ? copy_polygon(&made, transform, hull) : NULL;
    bool before = contact_of(&s->pieces[0], s, s->body.position, hull, &plain);
    bool after = contact_of(&piece, s, apply(transform, s->body.position), turned_hull, &turned);
    *overlaps += before;
    if (TUFF_SCALAR == TUFF_FLOAT && before != after) return plain.overlap < TUFF_RATIO(1, 10000) && turned.overlap < TUFF_RATIO(1, 10000);
    return before == after && (!before || same_contact(transform, &plain, &turned));
}

static void test_a_contact_mirrors_and_turns(void **state)
{
    random_run run = random_cases(__func__, 21, 60000);
    uint32_t overlaps = run_scenes(&run, 1, contact_turns);
    (void)state;
    print_message("figures: " EXACT_BUILD " symmetry: %lu overlapping contacts mirrored or turned\n", (unsigned long)overlaps);
    assert_true(overlaps > 0);
}

/* ---- normals ---- */

static void test_edge_normals_mirror_and_turn(void **state)
{
    static random_shape shape;
    static copies made;
    random_run run = random_cases(__func__, 22, 20000);
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        random_rock_shape(&source, &shape, TUFF_MAX_VERTICES, random_magnitude(&source, 0.01, 1000.0));
        for (int transform = 0; transform < TRANSFORMS; transform++) {
            tuff_unit2 normals[TUFF_MAX_VERTICES];
            made.count = 0;
            const tuff_polygon *turned = copy_polygon(&made, transform, &shape.polygon);
            tuff_edge_normals(turned->vertices, turned->count, normals);
            for (int k = 0; k < turned->count; k++) {
                if (same_unit2(turned->normals[k], normals[k], 3e-7)) continue;
                random_fail(&run, i, "the %s normal of edge %d differs", transform_names[transform], k);
            }
        }
    }
}

/* ---- whole calls, deepest first ---- */

typedef struct outcome {
    tuff_body    body;
    tuff_touch   list[TUFF_MAX_PUSHES];
    tuff_touches touches;
} outcome;

static void collide(outcome *o, const tuff_terrain *pieces, const scene *s, tuff_body body, const tuff_polygon *hull)
{
    uint16_t buckets[4];
    tuff_chunk_entry entries[MOST_PIECES];
    tuff_chunks chunks = TUFF_CHUNKS(buckets, entries, 5);
    tuff_world world = { pieces, s->count, &chunks, NULL, 0, TUFF_ORDER_DEEPEST };
    memset(o->list, 0, sizeof o->list);
    o->body = body;
    o->touches = (tuff_touches){ o->list, TUFF_MAX_PUSHES, 0 };
    assert_int_equal(tuff_world_index(&world), 0);
    (void)tuff_terrain_collide_report(&world, &o->body, s->radius, hull, &o->touches);
}

static bool same_touches(int transform, const outcome *plain, const outcome *turned)
{
    if (plain->touches.count != turned->touches.count) return false;
    for (int i = 0; i < plain->touches.count; i++) {
        if (plain->list[i].piece != turned->list[i].piece) return false;
        if (!same_contact(transform, &plain->list[i].contact, &turned->list[i].contact)) return false;
    }
    return true;
}

/* In the float build a rounded tie may send the two ways apart, so that only the first push is held to be the same. */
static bool same_outcome(int transform, const outcome *plain, const outcome *turned)
{
    if (TUFF_SCALAR == TUFF_FLOAT && (plain->touches.count == 0 || turned->touches.count == 0)) return true;
    if (TUFF_SCALAR == TUFF_FLOAT) return same_real(plain->list[0].contact.overlap, turned->list[0].contact.overlap, 1e-4);
    return same_touches(transform, plain, turned) && same_vec2(apply(transform, plain->body.position), turned->body.position, 0.0) &&
           same_vec2(apply(transform, plain->body.velocity), turned->body.velocity, 0.0);
}

static bool scene_turns(const scene *s, int transform, uint32_t *pushes)
{
    static copies made;
    static outcome plain, turned;
    tuff_terrain pieces[MOST_PIECES];
    tuff_body body = { apply(transform, s->body.position), apply(transform, s->body.velocity), s->body.material };
    made.count = 0;
    for (int i = 0; i < s->count; i++) pieces[i] = copy_terrain(&made, transform, &s->pieces[i]);
    const tuff_polygon *hull = s->with_hull ? &s->hull.polygon : NULL;
    collide(&plain, s->pieces, s, s->body, hull);
    collide(&turned, pieces, s, body, hull ? copy_polygon(&made, transform, hull) : NULL);
    *pushes += plain.touches.count;
    return same_outcome(transform, &plain, &turned);
}

static void test_scenes_pushed_deepest_first_mirror_and_turn(void **state)
{
    random_run run = random_cases(__func__, 23, 30000);
    uint32_t pushes = run_scenes(&run, MOST_PIECES, scene_turns);
    (void)state;
    print_message("figures: " EXACT_BUILD " symmetry: %lu pushes, deepest first, mirrored or turned\n", (unsigned long)pushes);
    assert_true(pushes > 0);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_contact_mirrors_and_turns),
        cmocka_unit_test(test_edge_normals_mirror_and_turn),
        cmocka_unit_test(test_scenes_pushed_deepest_first_mirror_and_turn),
    };
    (void)argc;
    random_begin(argv);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
