/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Circles: enemies that drift and steer, floaters, shots that ricochet. */
#include "inner.h"

static const tuff_material enemy_material = {TUFF_RATIO(7, 10), TUFF_RATIO(1, 20)};
static const tuff_material floater_material = {TUFF_RATIO(4, 5), TUFF_RATIO(1, 100)};
static const tuff_material shot_material = {TUFF_WHOLE(1), 0};

static void advance(tuff_body *body)
{
    body->position.x += body->velocity.x;
    body->position.y += body->velocity.y;
}

/* Every 16 steps, at different times: after the ship if it is near and in sight, otherwise some other way. */
static void choose_way(scene *s, scene_enemy *enemy)
{
    scene_int2 way = scene_toward(enemy->body.position, s->ship.position);
    bool near = enemy->shy == 0 && scene_distance(way.x, way.y) < 150;
    if (near && !tuff_segment_terrain_intersect(&s->world, enemy->body.position, s->ship.position)) {
        enemy->facing = scene_facing_of(way.x, way.y);
    } else {
        enemy->facing = (uint8_t)(enemy->facing + scene_random(s, 64) - 32);
    }
}

static void move_enemy(scene *s, scene_enemy *enemy)
{
    tuff_body *body = &enemy->body;
    scene_int2 way = scene_heading(enemy->facing);
    if (enemy->shy != 0) enemy->shy--;
    tuff_vec2 push = scene_vec2(way.x / 8, way.y / 8);
    body->velocity.x += push.x - body->velocity.x / 32;
    body->velocity.y += push.y - body->velocity.y / 32;
    scene_contain(body);
    advance(body);
    scene_meet_terrain(s, body, TUFF_WHOLE(SCENE_ENEMY_RADIUS), NULL, NULL);
    s->pushes = (uint16_t)(s->pushes + tuff_floater_collide_circle(body, TUFF_WHOLE(SCENE_ENEMY_RADIUS), s->floaters, SCENE_FLOATERS));
}

void scene_move_enemies(scene *s)
{
    for (uint8_t i = 0; i < SCENE_ENEMIES; i++) {
        scene_enemy *enemy = &s->enemies[i];
        enemy->body.material = &enemy_material;
        if (enemy->hits == 0) {
            if (--enemy->return_in == 0) scene_place_enemy(s, enemy);
            continue;
        }
        if ((s->frame + i * 3u) % 16 == 0) choose_way(s, enemy);
        move_enemy(s, enemy);
    }
}

void scene_move_floaters(scene *s)
{
    for (uint8_t i = 0; i < SCENE_FLOATERS; i++) {
        tuff_body *body = &s->floater_bodies[i];
        if (s->floaters[i].part_count == 0) continue;
        body->material = &floater_material;
        body->velocity.x -= body->velocity.x / 512;
        body->velocity.y -= body->velocity.y / 512;
        scene_contain(body);
        advance(body);
        scene_meet_terrain(s, body, s->floaters[i].radius, NULL, NULL);
        s->floaters[i].position = body->position;
    }
}

void scene_shoot(scene *s)
{
    for (uint8_t i = 0; i < SCENE_SHOTS; i++) {
        scene_shot *shot = &s->shots[i];
        if (shot->life != 0) continue;
        scene_int2 way = scene_heading(s->facing), at = scene_raw(s->ship.position), speed = scene_raw(s->ship.velocity);
        shot->body.position = scene_vec2(at.x + way.x * 44, at.y + way.y * 44);
        shot->body.velocity = scene_vec2(speed.x + way.x * 17, speed.y + way.y * 17);
        shot->body.material = &shot_material;
        shot->life = 70;
        shot->bounces = 2;
        s->events[SCENE_EVENT_SHOTS]++;
        return;
    }
}

static void shot_meets_floaters(scene *s, scene_shot *shot)
{
    tuff_touch touch;
    tuff_touches touches = {NULL, 1, 0};
    touches.list = &touch;
    tuff_vec2 before = shot->body.velocity;
    if (!tuff_floater_collide_report(&shot->body, SCENE_SHOT_RADIUS, s->floaters, SCENE_FLOATERS, NULL, s->world.order, &touches)) return;
    tuff_body *struck = &s->floater_bodies[touch.piece];
    struck->velocity.x += before.x / 16;
    struck->velocity.y += before.y / 16;
    scene_burst(s, scene_raw(shot->body.position), 4, SCENE_COLOR_SPARK);
    shot->life = 0;
}

static void shot_meets_terrain(scene *s, scene_shot *shot)
{
    tuff_touch touch;
    tuff_touches touches = {NULL, 1, 0};
    touches.list = &touch;
    if (scene_meet_terrain(s, &shot->body, SCENE_SHOT_RADIUS, NULL, &touches) == 0) return;
    scene_burst(s, scene_raw(shot->body.position), 3, SCENE_COLOR_SPARK);
    if (touch.piece >= SCENE_FIRST_VOLATILE && touch.piece < SCENE_FIRST_PLAIN) {
        scene_hit_rock(s, touch.piece);
        shot->life = 0;
    } else if (shot->bounces-- == 0) {
        shot->life = 0;
    } else {
        s->events[SCENE_EVENT_RICOCHETS]++;
    }
}

static void shot_meets_enemies(scene *s, scene_shot *shot)
{
    for (uint8_t i = 0; i < SCENE_ENEMIES && shot->life != 0; i++) {
        tuff_contact contact;
        tuff_vec2 apart;
        scene_enemy *enemy = &s->enemies[i];
        if (enemy->hits == 0) continue;
        apart.x = enemy->body.position.x - shot->body.position.x;
        apart.y = enemy->body.position.y - shot->body.position.y;
        if (!tuff_circle_circle(apart, TUFF_WHOLE(SCENE_ENEMY_RADIUS), TUFF_WHOLE(3), &contact)) continue;
        tuff_bounce(&enemy->body, &contact);
        scene_hit_enemy(s, enemy);
        shot->life = 0;
    }
}

void scene_move_shots(scene *s)
{
    for (uint8_t i = 0; i < SCENE_SHOTS; i++) {
        scene_shot *shot = &s->shots[i];
        if (shot->life == 0) continue;
        shot->life--;
        advance(&shot->body);
        shot_meets_terrain(s, shot);
        if (shot->life != 0) shot_meets_floaters(s, shot);
        if (shot->life != 0) shot_meets_enemies(s, shot);
    }
}
