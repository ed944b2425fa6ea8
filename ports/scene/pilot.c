/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The autopilot: looks at the scene and presses buttons, in integers. It hunts, and now and then slides along the floor. */
#include "inner.h"

#define PATROL 1080u   /* steps */

/* Is nothing between the ship and a point short of the target's rim? */
static bool in_sight(const scene *s, scene_int2 way, int32_t distance)
{
    scene_int2 from = scene_raw(s->ship.position);
    int32_t part = distance > 40 ? 256 - 256 * 36 / distance : 32;
    tuff_vec2 to = scene_vec2(from.x + way.x * part * 256, from.y + way.y * part * 256);
    return !tuff_segment_terrain_intersect(&s->world, s->ship.position, to);
}

static void consider(const scene *s, scene_aim *best, tuff_vec2 at, bool enemy)
{
    scene_int2 way = scene_toward(s->ship.position, at);
    int32_t distance = scene_distance(way.x, way.y);
    if (distance >= best->distance || distance < 1 || !in_sight(s, way, distance)) return;
    best->way = way;
    best->distance = distance;
    best->enemy = enemy;
    best->rock = !enemy;
}

void scene_take_aim(const scene *s, scene_aim *best)
{
    int32_t goal = s->frame / PATROL % 2 == 0 ? 440 : -440;
    best->distance = 230;
    best->enemy = best->rock = false;
    for (uint16_t i = 0; i < SCENE_ENEMIES; i++) {
        if (s->enemies[i].hits != 0) consider(s, best, s->enemies[i].body.position, true);
    }
    for (uint16_t i = SCENE_FIRST_VOLATILE; i < SCENE_FIRST_PLAIN; i++) {
        if (s->terrain[i].part_count != 0) consider(s, best, s->terrain[i].position, false);
    }
    if (best->enemy || best->rock) return;
    best->way = scene_toward(s->ship.position, scene_vec2(goal * SCENE_ONE, -70 * SCENE_ONE));
    best->distance = scene_distance(best->way.x, best->way.y);
}

/* Each patrol from one end to the other ends on the floor, then climbs. */
static bool floor_time(const scene *s)
{
    return s->frame % PATROL >= PATROL - 440 && s->frame % PATROL < PATROL - 60;
}

static bool climb_time(const scene *s)
{
    return s->frame % PATROL >= PATROL - 60;
}

/* The heading nearest to the one wished that has 90 units of free way; each side comes first for a while. */
static uint8_t free_heading(const scene *s, uint8_t facing)
{
    scene_int2 from = scene_raw(s->ship.position);
    int16_t side = s->frame / 256 % 2 == 0 ? 18 : -18;
    for (int16_t turn = 0; turn < 12; turn++) {
        uint8_t tried = (uint8_t)(facing + (turn + 1) / 2 * (turn % 2 == 0 ? side : -side));
        scene_int2 way = scene_heading(tried);
        tuff_vec2 to = scene_vec2(from.x + way.x * 4 * 90, from.y + way.y * 4 * 90);
        if (!tuff_segment_terrain_intersect(&s->world, s->ship.position, to)) return tried;
    }
    return facing;
}

/* Down round the rocks, along the floor, up again. */
static scene_int2 floor_wish(const scene *s)
{
    scene_int2 want;
    want.x = s->frame / PATROL % 2 == 0 ? 120000 : -120000;
    want.y = floor_time(s) ? 70000 : -150000;
    if (floor_time(s) && s->ship.position.y > TUFF_WHOLE(110)) return want;
    want = scene_heading(free_heading(s, scene_facing_of(want.x / 4, want.y)));
    want.x *= 8;
    want.y *= 8;
    return want;
}

/* The velocity to have, in Q16.16. */
static scene_int2 wish(const scene *s, const scene_aim *target)
{
    uint8_t facing = scene_facing_of(target->way.x, target->way.y);
    bool hunting = target->rock || target->enemy;
    if (floor_time(s) || climb_time(s)) return floor_wish(s);
    scene_int2 want, way = scene_heading(hunting ? facing : free_heading(s, facing));
    int32_t pace = hunting ? (target->distance > 110 ? 6 : target->distance > 70 ? 1 : -5) : 7;
    want.x = way.x * pace;
    want.y = way.y * pace;
    return want;
}

/* Terrain within the next 25 steps turns the wish away from it. */
static void avoid(const scene *s, scene_int2 *want)
{
    tuff_beam_hit hit;
    scene_int2 from = scene_raw(s->ship.position), speed = scene_raw(s->ship.velocity);
    tuff_vec2 ahead = scene_vec2(from.x + speed.x * 25, from.y + speed.y * 25);
    if (floor_time(s) || climb_time(s) || !tuff_segment_terrain_first_hit(&s->world, s->ship.position, ahead, &hit)) return;
    scene_int2 normal = scene_raw_unit2(hit.normal);
    int32_t side = (int32_t)(((int64_t)speed.x * -normal.y + (int64_t)speed.y * normal.x) / SCENE_ONE);
    int32_t along = side < 0 ? -1 : 1;
    want->x = normal.x + normal.x / 4 - along * normal.y;
    want->y = normal.y + normal.y / 4 + along * normal.x;
}

static uint16_t turn_to(const scene *s, uint8_t facing)
{
    int8_t off = (int8_t)(facing - s->facing);
    if (off > 3) return SCENE_RIGHT;
    if (off < -3) return SCENE_LEFT;
    return 0;
}

static bool within(const scene *s, uint8_t facing, int8_t slack)
{
    int8_t off = (int8_t)(facing - s->facing);
    return off <= slack && off >= -slack;
}

static uint16_t fire(const scene *s, const scene_aim *target, uint8_t facing)
{
    if (!(target->enemy || target->rock) || target->distance > 200 || !within(s, facing, 6)) return 0;
    bool beaming = s->beam_on ? s->energy > 4 : s->energy > 100;
    if (beaming && (s->frame / 512) % 2 == 0) return SCENE_BEAM;
    return SCENE_SHOOT;
}

uint16_t scene_steer(const scene *s, const scene_aim *target)
{
    scene_int2 want = wish(s, target), speed = scene_raw(s->ship.velocity), change;
    uint8_t at_target = scene_facing_of(target->way.x, target->way.y);
    avoid(s, &want);
    change.x = (want.x - speed.x) / 64;
    change.y = (want.y - speed.y) / 64;
    uint8_t facing = scene_facing_of(change.x, change.y);
    int32_t lack = scene_distance(change.x, change.y) * 64;
    uint16_t buttons = fire(s, target, at_target);
    if (lack > 45000) {
        buttons = (uint16_t)(buttons | turn_to(s, facing));
        if (within(s, facing, 20)) buttons |= SCENE_THRUST;
    } else {
        buttons = (uint16_t)(buttons | turn_to(s, at_target));
    }
    return buttons;
}

uint16_t scene_pilot(const scene *s)
{
    scene_aim target;
    scene_take_aim(s, &target);
    return scene_steer(s, &target);
}
