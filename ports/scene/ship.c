/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The ship: a polygon that turns, and its beam. */
#include "inner.h"

static const tuff_material ship_material = {TUFF_RATIO(1, 2), TUFF_RATIO(1, 50)};

/* Nose first; the heading is +x. */
static const int8_t hull_drawing[SCENE_HULL][2] = {{10, 0}, {-2, 6}, {-8, 5}, {-8, -5}, {-2, -6}};

/* Whole units times sines in steps of 2^-14: both builds hold the corners exactly. The library makes the normals when it needs them. */
void scene_turn_hull(scene *s)
{
    scene_int2 way = scene_heading(s->facing);
    for (uint8_t i = 0; i < SCENE_HULL; i++) {
        int32_t x = hull_drawing[i][0], y = hull_drawing[i][1];
        s->hull_vertices[i] = scene_vec2((x * way.x - y * way.y) * 4, (x * way.y + y * way.x) * 4);
    }
    s->hull.vertices = s->hull_vertices;
    s->hull.normals = NULL;
    s->hull.count = SCENE_HULL;
    s->ship.material = &ship_material;
}

static void exhaust(scene *s, scene_int2 way)
{
    scene_int2 at = scene_raw(s->ship.position), speed = scene_raw(s->ship.velocity);
    int32_t sway = (int32_t)scene_random(s, 25) - 12;
    at.x -= way.x * 36;
    at.y -= way.y * 36;
    speed.x -= way.x * 6 + way.y * sway / 8;
    speed.y -= way.y * 6 - way.x * sway / 8;
    scene_add_spark(s, at, speed, (uint8_t)(6 + scene_random(s, 8)), SCENE_COLOR_FLAME);
}

static void steer(scene *s)
{
    tuff_vec2 *v = &s->ship.velocity;
    if (s->buttons & SCENE_LEFT) s->facing = (uint8_t)(s->facing - 4);
    if (s->buttons & SCENE_RIGHT) s->facing = (uint8_t)(s->facing + 4);
    scene_turn_hull(s);
    scene_int2 way = scene_heading(s->facing);
    if (s->buttons & SCENE_THRUST) {
        tuff_vec2 push = scene_vec2(way.x / 4, way.y / 4);
        v->x += push.x;
        v->y += push.y;
        exhaust(s, way);
    }
    int16_t drag = s->buttons & SCENE_BRAKE ? 16 : 160;
    v->x -= drag == 16 ? v->x / 16 : v->x / 160;
    v->y -= drag == 16 ? v->y / 16 : v->y / 160;
}

static void hurt(scene *s, uint8_t damage)
{
    if (s->safe != 0) return;
    s->safe = 50;
    s->shield = (uint8_t)(s->shield > damage ? s->shield - damage : 0);
    if (s->shield != 0) return;
    scene_burst(s, scene_raw(s->ship.position), SCENE_SPARKS - 4, SCENE_COLOR_FLAME);
    s->events[SCENE_EVENT_SHIPS_LOST]++;
    s->ship.position = scene_vec2(SCENE_START_X * SCENE_ONE, SCENE_START_Y * SCENE_ONE);
    s->ship.velocity = scene_vec2(0, 0);
    s->shield = SCENE_SHIELD;
    s->safe = 120;
}

/* A moving obstacle: its velocity is taken from the ship's before the call and given back after; half of what the ship lost goes
   to the floater. */
static void meet_floater(scene *s, uint16_t i)
{
    tuff_vec2 *v = &s->ship.velocity, *other = &s->floater_bodies[i].velocity;
    tuff_vec2 carried = *other, before;
    tuff_touch touch;
    tuff_touches touches = {NULL, 1, 0};
    touches.list = &touch;
    v->x -= carried.x;
    v->y -= carried.y;
    before = *v;
    uint16_t pushes = tuff_floater_collide_report(&s->ship, SCENE_SHIP_RADIUS, &s->floaters[i], 1, &s->hull, s->world.order, &touches);
    if (pushes != 0) {
        s->events[SCENE_EVENT_FLOATER_BUMPS]++;
        other->x += (before.x - v->x) / 2;
        other->y += (before.y - v->y) / 2;
        scene_add_scar(s, &s->ship, SCENE_SHIP_RADIUS, &s->hull, &touch.contact);
    }
    v->x += carried.x;
    v->y += carried.y;
    s->pushes = (uint16_t)(s->pushes + pushes);
}

/* Both are entities; the scene makes them bounce with the same two calls that the library's own are made of. */
static void meet_enemy(scene *s, scene_enemy *enemy)
{
    tuff_contact contact;
    tuff_vec2 apart;
    if (enemy->hits == 0) return;
    apart.x = s->ship.position.x - enemy->body.position.x;
    apart.y = s->ship.position.y - enemy->body.position.y;
    if (!tuff_circle_circle(apart, TUFF_WHOLE(8), TUFF_WHOLE(SCENE_ENEMY_RADIUS), &contact)) return;
    tuff_bounce(&s->ship, &contact);
    contact.normal.x = -contact.normal.x;
    contact.normal.y = -contact.normal.y;
    tuff_bounce(&enemy->body, &contact);
    scene_int2 away = scene_toward(s->ship.position, enemy->body.position);
    enemy->facing = scene_facing_of(away.x, away.y);
    enemy->shy = 90;
    s->events[SCENE_EVENT_ENEMY_BUMPS]++;
    hurt(s, 1);
}

void scene_move_ship(scene *s)
{
    tuff_touch touch[4];
    tuff_touches touches = {NULL, 4, 0};
    touches.list = touch;
    steer(s);
    scene_contain(&s->ship);
    s->ship.position.x += s->ship.velocity.x;
    s->ship.position.y += s->ship.velocity.y;
    uint16_t pushes = scene_meet_terrain(s, &s->ship, SCENE_SHIP_RADIUS, &s->hull, &touches);
    for (uint16_t i = 0; i < pushes && i < touches.capacity; i++) {
        s->events[touch[i].piece < SCENE_FLOOR_COUNT ? SCENE_EVENT_FLOOR_TOUCHES : SCENE_EVENT_ROCK_BUMPS]++;
    }
    for (uint16_t i = 0; i < SCENE_FLOATERS; i++) meet_floater(s, i);
    for (uint16_t i = 0; i < SCENE_ENEMIES; i++) meet_enemy(s, &s->enemies[i]);
    if (s->safe != 0) s->safe--;
    if (++s->heal == 200) {
        s->heal = 0;
        if (s->shield < SCENE_SHIELD) s->shield++;
    }
}

/* How far the beam goes, in steps of 1/64 unit: to its first hit, or its full length. */
static int32_t beam_reach(scene *s, tuff_vec2 far_end, uint16_t *piece)
{
    tuff_beam_hit hit;
    *piece = SCENE_PIECES;
    if (!tuff_segment_terrain_first_hit(&s->world, s->ship.position, far_end, &hit)) return SCENE_BEAM_LENGTH * 64L;
    *piece = hit.piece;
    return tuff_to_q16_16(tuff_scale(TUFF_WHOLE(1), hit.fraction)) * SCENE_BEAM_LENGTH / 1024;
}

static void burn(scene *s, uint16_t piece)
{
    for (uint8_t i = 0; i < SCENE_ENEMIES; i++) {
        scene_enemy *enemy = &s->enemies[i];
        tuff_vec2 from = s->ship.position, to = s->beam_end, at = enemy->body.position;
        if (enemy->hits == 0 || s->frame % 12 != 0) continue;
        from.x -= at.x;
        from.y -= at.y;
        to.x -= at.x;
        to.y -= at.y;
        if (tuff_segment_circle(from, to, TUFF_WHOLE(SCENE_ENEMY_RADIUS))) scene_hit_enemy(s, enemy);
    }
    if (piece == SCENE_PIECES) return;
    s->events[SCENE_EVENT_BEAM_HITS]++;
    scene_burst(s, scene_raw(s->beam_end), 1, SCENE_COLOR_BEAM);
    if (s->frame % 12 == 0) scene_hit_rock(s, piece);
}

void scene_move_beam(scene *s)
{
    s->beam_on = (s->buttons & SCENE_BEAM) && s->energy >= 2;
    if (!s->beam_on) {
        if (s->energy < SCENE_ENERGY && s->frame % 2 == 0) s->energy++;
        return;
    }
    s->energy = (uint8_t)(s->energy - 2);
    uint16_t piece;
    scene_int2 from = scene_raw(s->ship.position), way = scene_heading(s->facing);
    int32_t reach = beam_reach(s, scene_vec2(from.x + way.x * 4 * SCENE_BEAM_LENGTH, from.y + way.y * 4 * SCENE_BEAM_LENGTH), &piece);
    s->beam_end = scene_vec2(from.x + way.x * reach / 16, from.y + way.y * reach / 16);
    burn(s, piece);
}
