/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The belt: where things are put, and how rocks come and go while the index is in use. */
#include <string.h>

#include "inner.h"

/* A random place where a circle touches no bounding circle. False: none found in a few tries. */
bool scene_clear_spot(scene *s, tuff_real radius, int32_t from_ship, tuff_vec2 *spot)
{
    uint8_t tries = s->frame == 0 ? SCENE_FIRST_TRIES : SCENE_TRIES;
    for (uint8_t attempt = 0; attempt < tries; attempt++) {
        int32_t x = (int32_t)scene_random(s, 1240) - 620, y = (int32_t)scene_random(s, 320) - 215;
        tuff_vec2 place = scene_vec2(x * SCENE_ONE, y * SCENE_ONE);
        scene_int2 way = scene_toward(s->ship.position, place);
        if (scene_distance(way.x, way.y) < from_ship) continue;
        if (tuff_nearby_terrain(&s->world, place, radius) != 0) continue;
        *spot = place;
        return true;
    }
    return false;
}

bool scene_place_rock(scene *s, uint16_t piece, uint8_t shape, int32_t from_ship)
{
    const tuff_terrain *drawn = scene_rock(shape);
    tuff_terrain *rock = &s->terrain[piece];
    tuff_vec2 spot;
    if (!scene_clear_spot(s, drawn->bounding_radius + TUFF_WHOLE(9), from_ship, &spot)) return false;
    *rock = *drawn;
    rock->position = spot;
    return tuff_chunks_insert(&s->chunks, piece, rock->position, rock->bounding_radius);
}

static uint8_t medium_shape(uint32_t number)
{
    return (uint8_t)(SCENE_MEDIUM_SHAPES + number % SCENE_SIZE_SHAPES);
}

/* A ball without polygons that is larger than a chunk. */
static void place_moon(scene *s, uint16_t piece, int32_t x)
{
    tuff_terrain *moon = &s->terrain[piece];
    moon->position = scene_vec2(x * SCENE_ONE, -40 * SCENE_ONE);
    moon->radius = TUFF_WHOLE(300);
    moon->bounding_radius = TUFF_WHOLE(300);
}

static void place_rocks(scene *s)
{
    for (uint16_t i = 0; i < SCENE_CONCAVE_COUNT; i++) {
        scene_place_rock(s, (uint16_t)(SCENE_FIRST_CONCAVE + i), (uint8_t)(SCENE_CONVEX_SHAPES + i % SCENE_CONCAVE_SHAPES), 90);
    }
    for (uint16_t i = 0; i < SCENE_VOLATILE_COUNT; i++) {
        s->hits[i] = SCENE_ROCK_HITS;
        scene_place_rock(s, (uint16_t)(SCENE_FIRST_VOLATILE + i), medium_shape(i), 70);
    }
    for (uint16_t i = 0; i < SCENE_PLAIN_COUNT; i++) {
        scene_place_rock(s, (uint16_t)(SCENE_FIRST_PLAIN + i), (uint8_t)(SCENE_CONVEX_SHAPES - 1 - i % SCENE_CONVEX_SHAPES), 50);
    }
}

/* Against terrain and other bodies, a floater is the circle that covers it. */
void scene_place_floater(scene *s, uint16_t floater, tuff_vec2 position, tuff_vec2 velocity)
{
    tuff_terrain *piece = &s->floaters[floater];
    s->floater_bodies[floater].position = position;
    s->floater_bodies[floater].velocity = velocity;
    *piece = *scene_rock(SCENE_FLOATER_SHAPE);
    piece->position = position;
    piece->radius = piece->bounding_radius;
}

void scene_place_enemy(scene *s, scene_enemy *enemy)
{
    enemy->hits = 0;
    enemy->return_in = 60;
    if (!scene_clear_spot(s, TUFF_WHOLE(SCENE_ENEMY_RADIUS + 4), 170, &enemy->body.position)) return;
    enemy->hits = 2;
    enemy->facing = (uint8_t)scene_random(s, 256);
    enemy->body.velocity = scene_vec2(0, 0);
}

void scene_build_world(scene *s)
{
    s->chunks = (tuff_chunks)TUFF_CHUNKS(s->buckets, s->entries, SCENE_PITCH_LOG2);
    s->world.terrain = s->terrain;
    s->world.terrain_count = SCENE_PIECES;
    s->world.chunks = &s->chunks;
    s->world.nearby = s->nearby;
    s->world.nearby_capacity = SCENE_PIECES;
    s->world.order = TUFF_ORDER_DEEPEST;
    scene_build_floor(s);
    place_moon(s, SCENE_FIRST_MOON, -930);
    place_moon(s, SCENE_FIRST_MOON + 1, 930);
    tuff_world_index(&s->world);
    place_rocks(s);
    for (uint16_t i = 0; i < SCENE_FLOATERS / 2; i++) {
        tuff_vec2 spot;
        if (!scene_clear_spot(s, TUFF_WHOLE(18), 60, &spot)) continue;
        int32_t vx = (int32_t)scene_random(s, 50000) - 25000, vy = (int32_t)scene_random(s, 50000) - 25000;
        scene_place_floater(s, i, spot, scene_vec2(vx, vy));
    }
    for (uint16_t i = 0; i < SCENE_ENEMIES; i++) scene_place_enemy(s, &s->enemies[i]);
}

/* A free floater's slot, or the oldest debris'. */
static uint16_t debris_slot(const scene *s, uint16_t wish)
{
    for (uint16_t i = SCENE_FLOATERS / 2; i < SCENE_FLOATERS; i++) {
        if (s->floaters[i].part_count == 0) return i;
    }
    return (uint16_t)(SCENE_FLOATERS / 2 + wish % (SCENE_FLOATERS - SCENE_FLOATERS / 2));
}

/* The rock leaves the index and its slot becomes empty; two pieces of debris float away. */
void scene_blow_up(scene *s, uint16_t piece)
{
    scene_int2 at = scene_raw(s->terrain[piece].position);
    tuff_chunks_remove(&s->chunks, piece);
    memset(&s->terrain[piece], 0, sizeof s->terrain[piece]);
    s->grow_in[piece - SCENE_FIRST_VOLATILE] = 420;
    s->events[SCENE_EVENT_ROCKS_BLOWN]++;
    s->score += 50;
    scene_burst(s, at, 20, SCENE_COLOR_VOLATILE_LIT);
    for (uint8_t i = 0; i < 2; i++) {
        uint16_t slot = debris_slot(s, (uint16_t)(piece + i));
        scene_int2 way = scene_heading((uint8_t)(scene_random(s, 64) + (i == 0 ? 0 : 128)));
        scene_place_floater(s, slot, scene_vec2(at.x + way.x * 48, at.y + way.y * 48), scene_vec2(way.x * 3, way.y * 3));
    }
}

/* A blown-up rock comes back elsewhere, out of the ship's sight. */
void scene_grow_rocks(scene *s)
{
    for (uint16_t i = 0; i < SCENE_VOLATILE_COUNT; i++) {
        if (s->grow_in[i] == 0 || --s->grow_in[i] != 0) continue;
        uint16_t piece = (uint16_t)(SCENE_FIRST_VOLATILE + i);
        s->hits[i] = SCENE_ROCK_HITS;
        if (scene_place_rock(s, piece, medium_shape(scene_random(s, SCENE_SIZE_SHAPES)), 200)) s->events[SCENE_EVENT_ROCKS_GROWN]++;
        else s->grow_in[i] = 60;
    }
}
