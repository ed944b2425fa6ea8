/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Random worlds with an index, edited while they run, and a shadow that remembers where the index must have each piece. What the
   calls must find is then plain: every piece in turn, in exact numbers. */
#ifndef TUFF_TESTS_WORLDS_H
#define TUFF_TESTS_WORLDS_H

#include "rocks.h"
#include "same.h"

#define WORLD_MOST     40
#define WORLD_SHAPES   6
#define WORLD_ROCKS    2
#define WORLD_BUCKETS  64

typedef struct world_shadow {       /* what the index was told last */
    bool      held;
    bool      large;                /* larger than a chunk */
    int32_t   chunk_x, chunk_y;
    uint32_t  turn;                 /* grows with every entry */
    tuff_vec2 position;
    tuff_real bounding_radius;
} world_shadow;

typedef struct world_fixture {      /* not to be copied: its parts point at each other */
    random_shape     shapes[WORLD_SHAPES];
    rock             rocks[WORLD_ROCKS];
    double           size;          /* in units; no shape but a rock is larger */
    double           middle_x, middle_y, extent;
    tuff_terrain     pieces[WORLD_MOST];
    uint16_t         buckets[WORLD_BUCKETS];
    tuff_chunk_entry entries[WORLD_MOST];
    tuff_chunks      chunks;
    uint16_t         nearby[WORLD_MOST];
    tuff_world       world;
    world_shadow     shadows[WORLD_MOST];
    uint32_t         turns;
    bool             index_used;    /* something was inserted since it was cleared */
} world_fixture;

/* ---- making ---- */

static inline double world_clamped(double a)
{
    return a > 32767.99 ? 32767.99 : a < -32767.99 ? -32767.99 : a;
}

/* A point where the pieces are, within so many of their extents of the middle. */
static inline tuff_vec2 world_point(random_source *source, const world_fixture *w, double extents)
{
    double x = w->middle_x + random_within(source, -extents, extents) * w->extent;
    double y = w->middle_y + random_within(source, -extents, extents) * w->extent;
    if (random_chance(source, 20)) x = floor(x);
    if (random_chance(source, 20)) y = floor(y);
    return random_point_at(world_clamped(x), world_clamped(y));
}

static inline void world_make_piece(random_source *source, world_fixture *w, int i)
{
    tuff_vec2 position = world_point(source, w, 1.0);
    uint32_t kind = random_below(source, 100);
    if (kind < 20) {
        tuff_real radius = random_point_at(w->size * random_within(source, 0.1, 1.0), 0).x;
        w->pieces[i] = (tuff_terrain){ position, radius, radius, NULL, 0 };
    } else if (kind < 40) {
        w->pieces[i] = rock_terrain(&w->rocks[random_below(source, WORLD_ROCKS)], position);
    } else {
        const random_shape *shape = &w->shapes[random_below(source, WORLD_SHAPES)];
        w->pieces[i] = (tuff_terrain){ position, shape->bounding_radius, shape->bounding_radius, &shape->polygon, 1 };
    }
}

static inline void world_make_place(random_source *source, world_fixture *w)
{
    static const double corners[4][2] = { { 1, 1 }, { -1, 1 }, { 1, -1 }, { -1, -1 } };
    uint32_t kind = random_below(source, 4), corner = random_below(source, 4);
    w->extent = w->size * random_within(source, 0.5, 8.0);
    w->middle_x = w->middle_y = 0.0;
    if (kind == 1) {
        w->middle_x = random_within(source, -32000.0, 32000.0);
        w->middle_y = random_within(source, -32000.0, 32000.0);
    } else if (kind == 2) {
        w->middle_x = corners[corner][0] * 32767.0;
        w->middle_y = corners[corner][1] * 32767.0;
    } else if (kind == 3 && random_chance(source, 25)) {
        w->extent = 32767.0;
    }
}

/* A world of WORLD_MOST pieces; the index is empty. Mostly a pitch that suits the pieces; sometimes any. */
static inline void world_make(random_source *source, world_fixture *w)
{
    int suiting;
    w->size = random_magnitude(source, 0.3, 400.0);
    frexp(w->size, &suiting);
    for (int i = 0; i < WORLD_SHAPES; i++) random_rock_shape(source, &w->shapes[i], 10, w->size * random_within(source, 0.1, 1.0));
    for (int i = 0; i < WORLD_ROCKS; i++) rock_make(source, &w->rocks[i], (int)random_below(source, ROCK_KINDS), fmax(w->size, 4.0));
    world_make_place(source, w);
    for (int i = 0; i < WORLD_MOST; i++) world_make_piece(source, w, i);
    int pitch = random_chance(source, 90) ? suiting + random_between(source, -3, 2) : random_between(source, 0, TUFF_MAX_PITCH_LOG2);
    w->chunks = (tuff_chunks){ w->buckets, w->entries, (uint16_t)(1u << random_below(source, 7)),
                               (uint16_t)(random_chance(source, 80) ? WORLD_MOST : random_below(source, WORLD_MOST)),
                               (uint16_t)(pitch < 0 ? 0 : pitch), 0, 0, false };
    tuff_chunks_clear(&w->chunks);
    w->world = (tuff_world){ w->pieces, WORLD_MOST, &w->chunks, w->nearby, WORLD_MOST, TUFF_ORDER_ITERATION };
    for (int i = 0; i < WORLD_MOST; i++) w->shadows[i] = (world_shadow){ .held = false };
    w->turns = 0;
    w->index_used = false;
}

/* Some pieces become copies of others, at the same place: they tie. */
static inline void world_add_twins(random_source *source, world_fixture *w, int count)
{
    for (int i = 0; i < count; i++) {
        uint32_t from = random_below(source, WORLD_MOST);
        w->pieces[random_below(source, WORLD_MOST)] = w->pieces[from];
    }
}

typedef struct world_mover {        /* a body among the pieces, a circle or a hull; the hull points into it */
    random_shape  shape;
    const tuff_polygon *hull;
    tuff_real     radius;
    tuff_material material;
    tuff_body     body;
} world_mover;

/* Hull and radius: so many percent are hulls. The body is the caller's. */
static inline void world_make_mover(random_source *source, const world_fixture *w, world_mover *m, uint32_t hulls)
{
    double size = w->size * random_magnitude(source, 0.02, 2.0);
    m->hull = NULL;
    m->radius = random_point_at(size, 0).x;
    if (random_chance(source, hulls)) {
        random_rock_shape(source, &m->shape, 8, size);
        m->hull = &m->shape.polygon;
        m->radius = m->shape.bounding_radius;
    }
}

/* ---- editing ---- */

/* floor(a / pitch), from exact numbers. */
static inline int32_t world_chunk(const world_fixture *w, tuff_real a)
{
    double steps = (double)exact_real(a);
    return (int32_t)floor(steps / ((double)EXACT_UNIT * (double)(1u << w->chunks.pitch_log2)));
}

/* What the index must have after it was told of piece i. One that stays in its chunk, and as large or small as it was, keeps its turn. */
static inline void world_shadow_enter(world_fixture *w, int i)
{
    const tuff_terrain *piece = &w->pieces[i];
    world_shadow now = { true, exact_real(piece->bounding_radius) > (exact)EXACT_UNIT * (1u << w->chunks.pitch_log2),
                         world_chunk(w, piece->position.x), world_chunk(w, piece->position.y), w->turns++,
                         piece->position, piece->bounding_radius };
    w->shadows[i] = now;
    w->index_used = true;
}

/* Tell the index of piece i, by insert or by move. */
static inline bool world_tell(random_source *source, world_fixture *w, int i)
{
    const tuff_terrain *piece = &w->pieces[i];
    bool told = random_chance(source, 50) ? tuff_chunks_insert(&w->chunks, (uint16_t)i, piece->position, piece->bounding_radius)
                                          : tuff_chunks_move(&w->chunks, (uint16_t)i, piece->position, piece->bounding_radius);
    bool slot = piece->bounding_radius == 0;
    if (i < w->chunks.capacity && !slot) world_shadow_enter(w, i);
    if (i < w->chunks.capacity && slot) w->shadows[i].held = false;
    return told == (i < w->chunks.capacity);
}

static inline bool world_forget(world_fixture *w, int i)
{
    bool held = w->shadows[i].held;
    w->shadows[i].held = false;
    return tuff_chunks_remove(&w->chunks, (uint16_t)i) == held;
}

/* One random change to the world, told to the index or not. False: the index answered wrongly. */
static inline bool world_edit(random_source *source, world_fixture *w)
{
    int i = (int)random_below(source, WORLD_MOST);
    uint32_t what = random_below(source, 100);
    if (what < 50) {
        if (random_chance(source, 60)) world_make_piece(source, w, i);
        return world_tell(source, w, i);
    }
    if (what < 70) return world_forget(w, i);
    if (what < 80) w->pieces[i].position = world_point(source, w, 1.0);
    else if (what < 90) w->pieces[i] = (tuff_terrain){ .part_count = 0 };
    else if (what < 97) w->world.terrain_count = (uint16_t)(random_chance(source, 60) ? WORLD_MOST : random_below(source, WORLD_MOST + 1));
    else if (what < 98) {
        tuff_chunks_clear(&w->chunks);
        for (int k = 0; k < WORLD_MOST; k++) w->shadows[k].held = false;
        w->index_used = false;
    } else {
        for (int k = 0; k < WORLD_MOST; k++) {
            if (!world_forget(w, k)) return false;
        }
    }
    return true;
}

/* NULL: all is well. Otherwise what is wrong; counted is what the test counts. */
typedef const char *world_judge(random_source *source, world_fixture *w, uint32_t *counted);

/* In the world of each case so many steps, each an edit and a question for the judge. What was counted. */
static inline uint32_t world_run(const random_run *run, int steps, world_judge *judge)
{
    static world_fixture w;
    uint32_t counted = 0;
    for (uint32_t i = run->first; i < run->end; i++) {
        random_source source = random_stream(run->seed, i);
        world_make(&source, &w);
        for (int step = 0; step < steps; step++) {
            const char *fault = world_edit(&source, &w) ? judge(&source, &w, &counted) : "the index answered an edit wrongly";
            if (fault) random_fail(run, i, "step %d: %s", step, fault);
        }
    }
    return counted;
}

/* Take the index away, for a search from end to end; give back what world_index_on needs. */
static inline bool world_index_off(world_fixture *w)
{
    bool used = w->index_used;
    w->world.chunks = NULL;
    w->index_used = false;
    return used;
}

static inline void world_index_on(world_fixture *w, bool used)
{
    w->world.chunks = &w->chunks;
    w->index_used = used;
}

/* ---- what must be found ---- */

/* Can piece i be found at all: within the array, no empty slot, and in the index if that is in use? */
static inline bool world_present(const world_fixture *w, int i)
{
    return i < w->world.terrain_count && w->pieces[i].bounding_radius > 0 && (!w->index_used || w->shadows[i].held);
}

/* Does the index, if it is in use, have piece i as it is? */
static inline bool world_told(const world_fixture *w, int i)
{
    const tuff_terrain *piece = &w->pieces[i];
    const world_shadow *shadow = &w->shadows[i];
    return !w->index_used || (same_point(shadow->position, piece->position) && shadow->bounding_radius == piece->bounding_radius);
}

/* How far the circle about center is from the bounding circle of piece i: d * d - r * r, as a part of r * r. At most 0: they touch. */
static inline double world_gap(const world_fixture *w, int i, tuff_vec2 center, tuff_real radius)
{
    exact2 d = exact_sub(exact_vec2(center), exact_vec2(w->pieces[i].position));
    exact reach = exact_real(radius) + exact_real(w->pieces[i].bounding_radius);
    return (double)((exact_dot(d, d) - reach * reach) / (reach * reach));
}

/* Below this a gap may be rounded away. */
#define WORLD_GAP_ROUNDING (TUFF_SCALAR == TUFF_Q16_16 ? 0.0 : 2e-6)

#endif
