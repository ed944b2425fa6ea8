/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The picture as a list of marks, from back to front: stars, ground, rocks, bodies, then what was asked to be shown on top. */
#include "inner.h"

static int32_t to_view(int32_t raw, int32_t camera)
{
    return raw / 4096 - camera;
}

bool scene_out_of_view(const scene_canvas *c, scene_int2 at, int32_t reach)
{
    int32_t x = to_view(at.x, c->camera_x), y = to_view(at.y, c->camera_y);
    return x - reach > c->half_width || x + reach < -c->half_width || y - reach > c->half_height || y + reach < -c->half_height;
}

static scene_point point_at(const scene_canvas *c, scene_int2 at)
{
    scene_point p;
    p.x = (int16_t)to_view(at.x, c->camera_x);
    p.y = (int16_t)to_view(at.y, c->camera_y);
    return p;
}

void scene_draw_line(const scene_canvas *c, scene_int2 from, scene_int2 to, uint8_t color, uint8_t strength, int16_t width)
{
    scene_mark mark;
    mark.kind = SCENE_LINE;
    mark.color = color;
    mark.strength = strength;
    mark.count = 2;
    mark.size = width;
    mark.points[0] = point_at(c, from);
    mark.points[1] = point_at(c, to);
    c->emit(c->context, &mark);
}

/* A disc, ring or dot. */
void scene_draw_round(const scene_canvas *c, uint8_t kind, scene_int2 at, int32_t radius, uint8_t color, uint8_t strength)
{
    scene_mark mark;
    mark.kind = kind;
    mark.color = color;
    mark.strength = strength;
    mark.count = 1;
    mark.size = (int16_t)radius;
    mark.points[0] = point_at(c, at);
    c->emit(c->context, &mark);
}

static scene_int2 corner_at(tuff_vec2 position, tuff_vec2 vertex)
{
    scene_int2 at = scene_raw(position), offset = scene_raw(vertex);
    at.x += offset.x;
    at.y += offset.y;
    return at;
}

static void fill_polygon(const scene_canvas *c, tuff_vec2 position, const tuff_polygon *polygon, uint8_t color)
{
    scene_mark mark;
    mark.kind = SCENE_POLYGON;
    mark.color = color;
    mark.strength = SCENE_SOLID;
    mark.size = 0;
    mark.count = polygon->count;
    for (uint8_t i = 0; i < polygon->count; i++) mark.points[i] = point_at(c, corner_at(position, polygon->vertices[i]));
    c->emit(c->context, &mark);
}

/* Light comes from the upper left. */
static bool lit(tuff_unit2 normal)
{
    return normal.x + normal.y < TUFF_UNIT_RATIO(-1, 4);
}

/* A smaller copy of the part, toward the light, takes the flatness away. */
static void draw_facet(const scene_canvas *c, tuff_vec2 position, const tuff_polygon *part, uint8_t color)
{
    scene_mark mark;
    mark.kind = SCENE_POLYGON;
    mark.color = color;
    mark.strength = 3;
    mark.size = 0;
    mark.count = part->count;
    for (uint8_t i = 0; i < part->count; i++) {
        scene_int2 at = scene_raw(position), corner = scene_raw(part->vertices[i]);
        at.x += corner.x / 8 * 5 - 2 * SCENE_ONE;
        at.y += corner.y / 8 * 5 - 2 * SCENE_ONE;
        mark.points[i] = point_at(c, at);
    }
    c->emit(c->context, &mark);
}

/* Outline edges only: internal ones do not exist for who looks from outside. colors: fill, lit edge, dark edge. */
static void draw_piece(const scene_canvas *c, const tuff_terrain *piece, uint8_t colors)
{
    for (uint8_t p = 0; p < piece->part_count; p++) fill_polygon(c, piece->position, &piece->parts[p], colors);
    if (piece->part_count == 1) draw_facet(c, piece->position, &piece->parts[0], (uint8_t)(colors + 1));
    for (uint8_t p = 0; p < piece->part_count; p++) {
        const tuff_polygon *part = &piece->parts[p];
        for (uint8_t i = 0; i < part->count; i++) {
            if (part->internal_edges >> i & 1) continue;
            scene_int2 from = corner_at(piece->position, part->vertices[i]);
            scene_int2 to = corner_at(piece->position, part->vertices[i + 1 == part->count ? 0 : i + 1]);
            scene_draw_line(c, from, to, (uint8_t)(colors + (lit(part->normals[i]) ? 1 : 2)), SCENE_SOLID, 18);
        }
    }
}

/* Stars on a grid, at places that a hash of the cell gives; they move at a fraction of the ship's pace. */
static void draw_star_layer(const scene_canvas *c, int32_t pace, int32_t cell, uint8_t color)
{
    scene_canvas far_away = *c;
    far_away.camera_x = c->camera_x / pace;
    far_away.camera_y = c->camera_y / pace;
    int32_t first_x = (far_away.camera_x - c->half_width) / cell - 1, last_x = (far_away.camera_x + c->half_width) / cell + 1;
    int32_t first_y = (far_away.camera_y - c->half_height) / cell - 1, last_y = (far_away.camera_y + c->half_height) / cell + 1;
    for (int32_t y = first_y; y <= last_y; y++) {
        for (int32_t x = first_x; x <= last_x; x++) {
            uint32_t chance = ((uint32_t)x * 2654435761u ^ (uint32_t)y * 2246822519u ^ color) * 3266489917u;
            scene_int2 at;
            at.x = (x * cell + (int32_t)((chance >> 8) % (uint32_t)cell)) * 4096;
            at.y = (y * cell + (int32_t)((chance >> 20) % (uint32_t)cell)) * 4096;
            if (chance >> 30 != 0) scene_draw_round(&far_away, SCENE_DOT, at, 0, color, (uint8_t)(8 + (chance >> 28) % 9));
        }
    }
}

/* Each piece with the ground below it, which is only drawn. */
static void draw_floor(scene *s, const scene_canvas *c)
{
    for (uint16_t i = 0; i < SCENE_FLOOR_COUNT; i++) {
        const tuff_terrain *piece = &s->terrain[i];
        scene_mark mark;
        if (scene_out_of_view(c, scene_raw(piece->position), 16 * 160)) continue;
        mark.kind = SCENE_POLYGON;
        mark.color = SCENE_COLOR_GROUND;
        mark.strength = SCENE_SOLID;
        mark.size = 0;
        mark.count = 4;
        for (uint8_t k = 0; k < 2; k++) mark.points[k] = point_at(c, corner_at(piece->position, piece->parts[0].vertices[k]));
        mark.points[2].x = mark.points[1].x;
        mark.points[3].x = mark.points[0].x;
        mark.points[2].y = mark.points[3].y = (int16_t)(SCENE_BOTTOM * 16 - c->camera_y);
        c->emit(c->context, &mark);
        fill_polygon(c, piece->position, &piece->parts[0], SCENE_COLOR_FLOOR);
        scene_int2 left = corner_at(piece->position, piece->parts[0].vertices[0]);
        scene_int2 right = corner_at(piece->position, piece->parts[0].vertices[1]);
        scene_draw_line(c, left, right, SCENE_COLOR_FLOOR_EDGE, SCENE_SOLID, 26);
    }
}

static void draw_moons(scene *s, const scene_canvas *c)
{
    for (uint16_t i = SCENE_FIRST_MOON; i < SCENE_FIRST_CONCAVE; i++) {
        scene_int2 at = scene_raw(s->terrain[i].position);
        int32_t radius = tuff_to_q16_16(s->terrain[i].radius) / 4096;
        if (scene_out_of_view(c, at, radius)) continue;
        scene_draw_round(c, SCENE_DISC, at, radius, SCENE_COLOR_MOON_EDGE, SCENE_SOLID);
        scene_draw_round(c, SCENE_DISC, at, radius - 32, SCENE_COLOR_MOON, SCENE_SOLID);
    }
}

static void draw_rocks(scene *s, const scene_canvas *c)
{
    for (uint16_t i = SCENE_FIRST_CONCAVE; i < SCENE_PIECES; i++) {
        const tuff_terrain *piece = &s->terrain[i];
        uint8_t colors = i < SCENE_FIRST_VOLATILE ? SCENE_COLOR_CONCAVE : i < SCENE_FIRST_PLAIN ? SCENE_COLOR_VOLATILE : SCENE_COLOR_ROCK;
        if (piece->part_count == 0 || scene_out_of_view(c, scene_raw(piece->position), 16 * 60)) continue;
        draw_piece(c, piece, colors);
        if (colors != SCENE_COLOR_VOLATILE) continue;
        int32_t glow = 24 * s->hits[i - SCENE_FIRST_VOLATILE] + (int32_t)(s->frame / 8 % 4) * 8;
        scene_draw_round(c, SCENE_DISC, scene_raw(piece->position), glow, SCENE_COLOR_VOLATILE_LIT, 10);
    }
}

static void draw_floaters(scene *s, const scene_canvas *c)
{
    for (uint16_t i = 0; i < SCENE_FLOATERS; i++) {
        if (s->floaters[i].part_count == 0 || scene_out_of_view(c, scene_raw(s->floaters[i].position), 16 * 20)) continue;
        draw_piece(c, &s->floaters[i], SCENE_COLOR_FLOATER);
    }
}

static void draw_enemies(scene *s, const scene_canvas *c)
{
    for (uint8_t i = 0; i < SCENE_ENEMIES; i++) {
        const scene_enemy *enemy = &s->enemies[i];
        scene_int2 at = scene_raw(enemy->body.position), way = scene_heading(enemy->facing);
        if (enemy->hits == 0 || scene_out_of_view(c, at, 16 * 10)) continue;
        scene_draw_round(c, SCENE_DISC, at, SCENE_ENEMY_RADIUS * 16, SCENE_COLOR_ENEMY_EDGE, SCENE_SOLID);
        scene_draw_round(c, SCENE_DISC, at, SCENE_ENEMY_RADIUS * 16 - 20, SCENE_COLOR_ENEMY, SCENE_SOLID);
        at.x += way.x * 10;
        at.y += way.y * 10;
        scene_draw_round(c, SCENE_DISC, at, 30, SCENE_COLOR_ENEMY_EYE, SCENE_SOLID);
    }
}

static void draw_shots(scene *s, const scene_canvas *c)
{
    for (uint8_t i = 0; i < SCENE_SHOTS; i++) {
        const scene_shot *shot = &s->shots[i];
        scene_int2 at = scene_raw(shot->body.position), tail = at, speed = scene_raw(shot->body.velocity);
        if (shot->life == 0 || scene_out_of_view(c, at, 16 * 8)) continue;
        tail.x -= speed.x;
        tail.y -= speed.y;
        scene_draw_line(c, tail, at, SCENE_COLOR_SHOT, 8, 24);
        scene_draw_round(c, SCENE_DISC, at, 28, SCENE_COLOR_SHOT, SCENE_SOLID);
    }
}

static void draw_sparks(scene *s, const scene_canvas *c)
{
    for (uint8_t i = 0; i < SCENE_SPARKS; i++) {
        const scene_spark *spark = &s->sparks[i];
        scene_int2 at;
        at.x = spark->x;
        at.y = spark->y;
        if (spark->life == 0 || scene_out_of_view(c, at, 16)) continue;
        scene_draw_round(c, SCENE_DISC, at, spark->color == SCENE_COLOR_FLAME ? 12 + spark->life : 16, spark->color,
                         spark->life > 15 ? SCENE_SOLID : (uint8_t)(spark->life + 1));
    }
}

static void draw_ship(scene *s, const scene_canvas *c)
{
    scene_int2 nose = corner_at(s->ship.position, s->hull.vertices[0]);
    if (s->beam_on) {
        scene_draw_line(c, nose, scene_raw(s->beam_end), SCENE_COLOR_BEAM, 6, 64);
        scene_draw_line(c, nose, scene_raw(s->beam_end), SCENE_COLOR_BEAM, SCENE_SOLID, 18);
        scene_draw_round(c, SCENE_DISC, scene_raw(s->beam_end), 40, SCENE_COLOR_BEAM, 12);
    }
    fill_polygon(c, s->ship.position, &s->hull, SCENE_COLOR_SHIP);
    for (uint8_t i = 0; i < s->hull.count; i++) {
        scene_int2 from = corner_at(s->ship.position, s->hull.vertices[i]);
        scene_int2 to = corner_at(s->ship.position, s->hull.vertices[i + 1 == s->hull.count ? 0 : i + 1]);
        scene_draw_line(c, from, to, SCENE_COLOR_SHIP_EDGE, SCENE_SOLID, 16);
    }
    if (s->safe == 0) return;
    scene_draw_round(c, SCENE_RING, scene_raw(s->ship.position), 16 * 14, SCENE_COLOR_SHIELD, s->safe > 28 ? 14 : s->safe / 2);
}

/* The camera's middle in 1/16 unit, held so that the view stays between the belt's upper edge and the bottom. */
static int32_t held(int32_t middle, int32_t half, int32_t low, int32_t high)
{
    if (high - low <= 2 * half) return (low + high) / 2;
    if (middle < low + half) return low + half;
    return middle > high - half ? high - half : middle;
}

void scene_draw(scene *s, const scene_view *view, scene_emit emit, void *context)
{
    scene_canvas c;
    c.emit = emit;
    c.context = context;
    c.half_width = (int32_t)view->half_width * 16;
    c.half_height = (int32_t)view->half_height * 16;
    c.camera_x = s->camera_x / 4096;
    c.camera_y = held(s->camera_y / 4096, c.half_height, -400 * 16, (SCENE_BOTTOM - 20) * 16);
    draw_star_layer(&c, 4, 16 * 26, SCENE_COLOR_STAR_FAR);
    draw_star_layer(&c, 2, 16 * 44, SCENE_COLOR_STAR_NEAR);
    draw_moons(s, &c);
    draw_floor(s, &c);
    draw_rocks(s, &c);
    draw_floaters(s, &c);
    draw_sparks(s, &c);
    draw_shots(s, &c);
    draw_enemies(s, &c);
    draw_ship(s, &c);
    scene_draw_overlays(s, &c, view->show);
}
