/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What can be asked of a scene: a hash of its state, counts for a status line, and whether tuff's checks find it well. */
#include "inner.h"

/* FNV-1a over words instead of bytes, with the high half folded down so that it counts too. */
static uint32_t fold(uint32_t hash, uint32_t word)
{
    hash = (hash ^ word) * 16777619u;
    return hash ^ hash >> 15;
}

static uint32_t fold_vec2(uint32_t hash, tuff_vec2 v)
{
    scene_int2 raw = scene_raw(v);
    return fold(fold(hash, (uint32_t)raw.x), (uint32_t)raw.y);
}

static uint32_t fold_body(uint32_t hash, const tuff_body *body)
{
    return fold_vec2(fold_vec2(hash, body->position), body->velocity);
}

uint32_t scene_hash(const scene *s, uint32_t hash)
{
    hash = fold_body(fold(fold(hash ^ 2166136261u, s->frame), s->random), &s->ship);
    hash = fold(hash, (uint32_t)s->facing << 24 | (uint32_t)s->shield << 16 | (uint32_t)s->energy << 8 | s->safe);
    hash = fold_vec2(fold(hash, s->pushes), s->beam_end);
    for (uint8_t i = 0; i < SCENE_ENEMIES; i++) {
        const scene_enemy *enemy = &s->enemies[i];
        hash = fold_body(fold(hash, (uint32_t)enemy->hits << 8 | enemy->facing), &enemy->body);
    }
    for (uint8_t i = 0; i < SCENE_FLOATERS; i++) hash = fold_body(hash, &s->floater_bodies[i]);
    for (uint8_t i = 0; i < SCENE_SHOTS; i++) hash = fold_body(fold(hash, s->shots[i].life), &s->shots[i].body);
    for (uint8_t i = 0; i < SCENE_VOLATILE_COUNT; i++) {
        hash = fold_vec2(fold(hash, s->hits[i]), s->terrain[SCENE_FIRST_VOLATILE + i].position);
    }
    return hash;
}

static void count_body(scene *s, scene_counts *counts, tuff_vec2 at, tuff_real radius)
{
    uint16_t found = tuff_nearby_terrain(&s->world, at, radius);
    counts->bodies++;
    counts->candidates = (uint16_t)(counts->candidates + found);
    for (uint16_t i = 0; i < found && i < s->world.nearby_capacity; i++) {
        uint8_t parts = s->terrain[s->nearby[i]].part_count;
        counts->tests = (uint16_t)(counts->tests + (parts == 0 ? 1 : parts));
    }
}

void scene_count(scene *s, scene_counts *counts)
{
    counts->bodies = 0;
    counts->candidates = 0;
    counts->tests = 0;
    counts->contacts = s->pushes;
    counts->pieces = 0;
    counts->shield = s->shield;
    counts->energy = s->energy;
    counts->score = s->score;
    for (uint16_t i = 0; i < SCENE_PIECES; i++) {
        if (s->terrain[i].bounding_radius > 0) counts->pieces++;
    }
    count_body(s, counts, s->ship.position, SCENE_SHIP_RADIUS);
    for (uint8_t i = 0; i < SCENE_ENEMIES; i++) {
        if (s->enemies[i].hits != 0) count_body(s, counts, s->enemies[i].body.position, TUFF_WHOLE(SCENE_ENEMY_RADIUS));
    }
    for (uint8_t i = 0; i < SCENE_FLOATERS; i++) {
        if (s->floaters[i].part_count != 0) count_body(s, counts, s->floaters[i].position, s->floaters[i].radius);
    }
    for (uint8_t i = 0; i < SCENE_SHOTS; i++) {
        if (s->shots[i].life != 0) count_body(s, counts, s->shots[i].body.position, SCENE_SHOT_RADIUS);
    }
}

static tuff_fault floater_fault(const scene *s, uint16_t i)
{
    tuff_fault fault = tuff_check_terrain(&s->floaters[i]);
    return fault != TUFF_OK ? fault : tuff_check_body(&s->floater_bodies[i], s->floaters[i].radius, NULL);
}

const char *scene_fault(const scene *s, uint16_t *number)
{
    tuff_fault fault = tuff_check_world(&s->world, number);
    if (fault != TUFF_OK) return tuff_fault_text(fault);
    *number = 0;
    fault = tuff_check_body(&s->ship, SCENE_SHIP_RADIUS, &s->hull);
    if (fault != TUFF_OK) return tuff_fault_text(fault);
    for (uint16_t i = 0; i < SCENE_FLOATERS; i++) {
        *number = i;
        fault = floater_fault(s, i);
        if (fault != TUFF_OK) return tuff_fault_text(fault);
    }
    for (uint16_t i = 0; i < SCENE_ENEMIES; i++) {
        *number = i;
        fault = tuff_check_body(&s->enemies[i].body, TUFF_WHOLE(SCENE_ENEMY_RADIUS), NULL);
        if (fault != TUFF_OK) return tuff_fault_text(fault);
    }
    for (uint16_t i = 0; i < SCENE_SHOTS; i++) {
        *number = i;
        fault = tuff_check_body(&s->shots[i].body, SCENE_SHOT_RADIUS, NULL);
        if (fault != TUFF_OK) return tuff_fault_text(fault);
    }
    return NULL;
}
