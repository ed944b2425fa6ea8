/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The start, and one step of everything in its order. */
#include <string.h>

#include "inner.h"

void scene_init(scene *s, uint32_t seed)
{
    memset(s, 0, sizeof *s);
    s->random = seed * 2654435769u ^ 0x7f4a7c15u;
    if (s->random == 0) s->random = 1;
    s->ship.position = scene_vec2(SCENE_START_X * SCENE_ONE, SCENE_START_Y * SCENE_ONE);
    s->shield = SCENE_SHIELD;
    s->energy = SCENE_ENERGY;
    s->camera_y = SCENE_START_Y * SCENE_ONE;
    scene_build_world(s);
    scene_turn_hull(s);
}

static tuff_real limited(tuff_real v)
{
    if (v > TUFF_WHOLE(3)) return TUFF_WHOLE(3);
    if (v < TUFF_WHOLE(-3)) return TUFF_WHOLE(-3);
    return v;
}

/* Soft fields at the belt's edges, the floor's weak pull, and a limit of speed. */
void scene_contain(tuff_body *body)
{
    tuff_vec2 *v = &body->velocity;
    if (body->position.x > TUFF_WHOLE(SCENE_SIDE)) v->x -= TUFF_RATIO(1, 10);
    if (body->position.x < TUFF_WHOLE(-SCENE_SIDE)) v->x += TUFF_RATIO(1, 10);
    if (body->position.y < TUFF_WHOLE(SCENE_TOP)) v->y += TUFF_RATIO(1, 10);
    if (body->position.y > TUFF_WHOLE(SCENE_FLOOR_PULL)) v->y += TUFF_RATIO(1, 80);
    v->x = limited(v->x);
    v->y = limited(v->y);
}

/* touches may be NULL: then only the picture hears of the first push. */
uint16_t scene_meet_terrain(scene *s, tuff_body *body, tuff_real radius, const tuff_polygon *hull, tuff_touches *touches)
{
    tuff_touch first;
    tuff_touches own = {NULL, 1, 0};
    own.list = &first;
    if (touches == NULL) touches = &own;
    uint16_t pushes = tuff_terrain_collide_report(&s->world, body, radius, hull, touches);
    for (uint16_t i = 0; i < touches->count && i < touches->capacity; i++) {
        scene_add_scar(s, body, radius, hull, &touches->list[i].contact);
    }
    s->pushes = (uint16_t)(s->pushes + pushes);
    return pushes;
}

void scene_hit_enemy(scene *s, scene_enemy *enemy)
{
    scene_burst(s, scene_raw(enemy->body.position), 5, SCENE_COLOR_ENEMY);
    if (--enemy->hits != 0) return;
    scene_burst(s, scene_raw(enemy->body.position), 10, SCENE_COLOR_ENEMY_EDGE);
    enemy->return_in = 240;
    s->events[SCENE_EVENT_ENEMIES_DOWN]++;
    s->score += 20;
}

/* Only some rocks can be blown up. */
void scene_hit_rock(scene *s, uint16_t piece)
{
    if (piece < SCENE_FIRST_VOLATILE || piece >= SCENE_FIRST_PLAIN) return;
    uint8_t *hits = &s->hits[piece - SCENE_FIRST_VOLATILE];
    if (--*hits == 0) scene_blow_up(s, piece);
}

/* The picture's middle follows the ship and looks ahead a little. */
static void move_camera(scene *s)
{
    scene_int2 at = scene_raw(s->ship.position), speed = scene_raw(s->ship.velocity);
    s->camera_x += (at.x + speed.x * 20 - s->camera_x) / 16;
    s->camera_y += (at.y + speed.y * 12 - s->camera_y) / 16;
}

void scene_step(scene *s, uint16_t buttons)
{
    s->frame++;
    s->pushes = 0;
    s->buttons = buttons;
    if (s->reload != 0) s->reload--;
    scene_move_ship(s);
    scene_move_enemies(s);
    scene_move_floaters(s);
    if ((buttons & SCENE_SHOOT) && s->reload == 0) {
        s->reload = 9;
        scene_shoot(s);
    }
    scene_move_shots(s);
    scene_move_beam(s);
    scene_grow_rocks(s);
    scene_move_sparks(s);
    move_camera(s);
}
