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

static void join(const scene_canvas *c, scene_point from, scene_point to, uint8_t color, uint8_t strength, int16_t width)
{
    scene_mark mark;
    mark.kind = SCENE_LINE;
    mark.color = color;
    mark.strength = strength;
    mark.count = 2;
    mark.size = width;
    mark.points[0] = from;
    mark.points[1] = to;
    c->emit(c->context, &mark);
}

void scene_draw_line(const scene_canvas *c, scene_int2 from, scene_int2 to, uint8_t color, uint8_t strength, int16_t width)
{
    join(c, point_at(c, from), point_at(c, to), color, strength, width);
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

static void place_outline(const scene_canvas *c, tuff_vec2 position, const tuff_polygon *polygon, scene_mark *mark)
{
    for (uint8_t i = 0; i < polygon->count; i++) mark->points[i] = point_at(c, corner_at(position, polygon->vertices[i]));
}

/* Leaves the outline's points in the mark. */
static void fill_polygon(const scene_canvas *c, tuff_vec2 position, const tuff_polygon *polygon, uint8_t color, scene_mark *mark)
{
    mark->kind = SCENE_POLYGON;
    mark->color = color;
    mark->strength = SCENE_SOLID;
    mark->size = 0;
    mark->count = polygon->count;
    place_outline(c, position, polygon, mark);
    c->emit(c->context, mark);
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

/* Outline edges only: internal ones do not exist for who looks from outside. */
static void draw_edges(const scene_canvas *c, const scene_mark *outline, const tuff_polygon *part, uint8_t colors)
{
    for (uint8_t i = 0; i < part->count; i++) {
        if (part->internal_edges >> i & 1) continue;
        uint8_t next = (uint8_t)(i + 1 == part->count ? 0 : i + 1);
        join(c, outline->points[i], outline->points[next], (uint8_t)(colors + (lit(part->normals[i]) ? 1 : 2)), SCENE_SOLID, 18);
    }
}

/* colors: fill, lit edge, dark edge. */
static void draw_piece(const scene_canvas *c, const tuff_terrain *piece, uint8_t colors)
{
    scene_mark mark;
    for (uint8_t p = 0; p < piece->part_count; p++) fill_polygon(c, piece->position, &piece->parts[p], colors, &mark);
    if (piece->part_count == 1 && !c->plain) draw_facet(c, piece->position, &piece->parts[0], (uint8_t)(colors + 1));
    for (uint8_t p = 0; p < piece->part_count; p++) {
        if (piece->part_count != 1) place_outline(c, piece->position, &piece->parts[p], &mark);
        draw_edges(c, &mark, &piece->parts[p], colors);
    }
}

#define FAR_CELL  (16 * 26)   /* 1/16 unit */
#define NEAR_CELL (16 * 44)

/* A remainder of a constant takes no division. */
static int32_t place_in_cell(uint32_t chance, int32_t cell)
{
    return (int32_t)(cell == FAR_CELL ? chance % (uint32_t)FAR_CELL : chance % (uint32_t)NEAR_CELL);
}

/* A star at the place that a hash of its cell gives; one cell in four has none. */
static void draw_star(const scene_canvas *c, int32_t x, int32_t y, int32_t cell, uint8_t color)
{
    uint32_t chance = ((uint32_t)x * 2654435761u ^ (uint32_t)y * 2246822519u ^ color) * 3266489917u;
    scene_int2 at;
    if (chance >> 30 == 0) return;
    at.x = (x * cell + place_in_cell(chance >> 8, cell)) * 4096;
    at.y = (y * cell + place_in_cell(chance >> 20, cell)) * 4096;
    scene_draw_round(c, SCENE_DOT, at, 0, color, (uint8_t)(8 + (chance >> 28) % 9));
}

/* They move at a fraction of the ship's pace. */
static void draw_star_layer(const scene_canvas *c, int32_t pace, int32_t cell, uint8_t color)
{
    scene_canvas far_away = *c;
    far_away.camera_x = c->camera_x / pace;
    far_away.camera_y = c->camera_y / pace;
    int32_t first = scene_floor_divide(far_away.camera_x - c->half_width, cell);
    int32_t last = scene_floor_divide(far_away.camera_x + c->half_width, cell);
    int32_t bottom = scene_floor_divide(far_away.camera_y + c->half_height, cell);
    for (int32_t y = scene_floor_divide(far_away.camera_y - c->half_height, cell); y <= bottom; y++) {
        for (int32_t x = first; x <= last; x++) draw_star(&far_away, x, y, cell, color);
    }
}

/* From two upper corners down to a height. */
static void fill_ground(const scene_canvas *c, scene_point left, scene_point right, int16_t bottom)
{
    scene_mark mark;
    mark.kind = SCENE_POLYGON;
    mark.color = SCENE_COLOR_GROUND;
    mark.strength = SCENE_SOLID;
    mark.size = 0;
    mark.count = 4;
    mark.points[0] = left;
    mark.points[1] = right;
    mark.points[2].x = right.x;
    mark.points[3].x = left.x;
    mark.points[2].y = mark.points[3].y = bottom;
    c->emit(c->context, &mark);
}

static bool column_in_view(const scene_canvas *c, const tuff_terrain *piece)
{
    int32_t x = to_view(scene_raw(piece->position).x, c->camera_x), reach = tuff_to_q16_16(piece->bounding_radius) / 4096 + 32;
    return x - reach <= c->half_width && x + reach >= -c->half_width;
}

static int16_t lower(int16_t a, int16_t b)
{
    return a > b ? a : b;
}

/* Each piece with the ground that its lower edge leaves above the common ground. */
static void draw_floor_pieces(scene *s, const scene_canvas *c, uint16_t first, uint16_t end, int16_t common)
{
    for (uint16_t i = first; i < end; i++) {
        scene_mark mark;
        place_outline(c, s->terrain[i].position, &s->terrain[i].parts[0], &mark);
        if (mark.points[0].y - 32 > c->half_height && mark.points[1].y - 32 > c->half_height) continue;
        if (mark.points[2].y < common || mark.points[3].y < common) fill_ground(c, mark.points[0], mark.points[1], common);
        fill_polygon(c, s->terrain[i].position, &s->terrain[i].parts[0], SCENE_COLOR_FLOOR, &mark);
        join(c, mark.points[0], mark.points[1], SCENE_COLOR_FLOOR_EDGE, SCENE_SOLID, 26);
    }
}

/* The pieces stand in a row. The ground, which is only drawn, is one rectangle where it lies below all of their upper edges and not
   behind all of them: rows of short fills cost a small machine more than the long ones do. */
static void draw_floor(scene *s, const scene_canvas *c)
{
    uint16_t first = 0, end;
    scene_mark mark;
    while (first < SCENE_FLOOR_COUNT && !column_in_view(c, &s->terrain[first])) first++;
    if (first == SCENE_FLOOR_COUNT) return;
    place_outline(c, s->terrain[first].position, &s->terrain[first].parts[0], &mark);
    scene_point left = mark.points[0], right = left;
    int16_t upper = left.y, under = mark.points[3].y;
    for (end = first; end < SCENE_FLOOR_COUNT && column_in_view(c, &s->terrain[end]); end++) {
        place_outline(c, s->terrain[end].position, &s->terrain[end].parts[0], &mark);
        right = mark.points[1];
        upper = lower(upper, right.y);
        if (mark.points[2].y < under) under = mark.points[2].y;
    }
    left.y = right.y = lower(upper, under);
    fill_ground(c, left, right, (int16_t)(SCENE_BOTTOM * 16 - c->camera_y));
    draw_floor_pieces(s, c, first, end, left.y);
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

/* Its lines and facet stay within two units of its bounding circle. */
static bool piece_out_of_view(const scene_canvas *c, const tuff_terrain *piece)
{
    return scene_out_of_view(c, scene_raw(piece->position), tuff_to_q16_16(piece->bounding_radius) / 4096 + 32);
}

static void draw_rocks(scene *s, const scene_canvas *c)
{
    for (uint16_t i = SCENE_FIRST_CONCAVE; i < SCENE_PIECES; i++) {
        const tuff_terrain *piece = &s->terrain[i];
        uint8_t colors = i < SCENE_FIRST_VOLATILE ? SCENE_COLOR_CONCAVE : i < SCENE_FIRST_PLAIN ? SCENE_COLOR_VOLATILE : SCENE_COLOR_ROCK;
        if (piece->part_count == 0 || piece_out_of_view(c, piece)) continue;
        draw_piece(c, piece, colors);
        if (colors != SCENE_COLOR_VOLATILE) continue;
        int32_t glow = 24 * s->hits[i - SCENE_FIRST_VOLATILE] + (int32_t)(s->frame / 8 % 4) * 8;
        scene_draw_round(c, SCENE_DISC, scene_raw(piece->position), glow, SCENE_COLOR_VOLATILE_LIT, 10);
    }
}

static void draw_floaters(scene *s, const scene_canvas *c)
{
    for (uint16_t i = 0; i < SCENE_FLOATERS; i++) {
        if (s->floaters[i].part_count == 0 || piece_out_of_view(c, &s->floaters[i])) continue;
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
    scene_mark mark;
    if (s->beam_on) {
        scene_draw_line(c, nose, scene_raw(s->beam_end), SCENE_COLOR_BEAM, 6, 64);
        scene_draw_line(c, nose, scene_raw(s->beam_end), SCENE_COLOR_BEAM, SCENE_SOLID, 18);
        scene_draw_round(c, SCENE_DISC, scene_raw(s->beam_end), 40, SCENE_COLOR_BEAM, 12);
    }
    fill_polygon(c, s->ship.position, &s->hull, SCENE_COLOR_SHIP, &mark);
    for (uint8_t i = 0; i < s->hull.count; i++) {
        join(c, mark.points[i], mark.points[i + 1 == s->hull.count ? 0 : i + 1], SCENE_COLOR_SHIP_EDGE, SCENE_SOLID, 16);
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
    c.plain = view->show & SCENE_SHOW_PLAIN;
    if (!c.plain) {
        draw_star_layer(&c, 4, FAR_CELL, SCENE_COLOR_STAR_FAR);
        draw_star_layer(&c, 2, NEAR_CELL, SCENE_COLOR_STAR_NEAR);
    }
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
