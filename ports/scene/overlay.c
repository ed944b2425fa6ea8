/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What the library sees: the index's chunks, bounding circles, normals, contacts. */
#include "inner.h"

#define PITCH (16 * ((int32_t)1 << SCENE_PITCH_LOG2))   /* 1/16 unit */

#define NORMAL_LENGTH   8    /* units */
#define INTERNAL_LENGTH 4

static scene_int2 raw_at(int32_t x, int32_t y)
{
    scene_int2 at;
    at.x = x * 4096;
    at.y = y * 4096;
    return at;
}

static void draw_grid(const scene_canvas *c)
{
    int32_t left = c->camera_x - c->half_width, right = c->camera_x + c->half_width;
    int32_t top = c->camera_y - c->half_height, bottom = c->camera_y + c->half_height;
    for (int32_t x = scene_floor_divide(left, PITCH) * PITCH; x <= right; x += PITCH) {
        scene_draw_line(c, raw_at(x, top), raw_at(x, bottom), SCENE_COLOR_CHUNK, 9, 0);
    }
    for (int32_t y = scene_floor_divide(top, PITCH) * PITCH; y <= bottom; y += PITCH) {
        scene_draw_line(c, raw_at(left, y), raw_at(right, y), SCENE_COLOR_CHUNK, 9, 0);
    }
}

static void tint_chunk(const scene_canvas *c, int32_t x, int32_t y)
{
    int16_t left = (int16_t)(x - c->camera_x), top = (int16_t)(y - c->camera_y);
    scene_mark mark;
    mark.kind = SCENE_POLYGON;
    mark.color = SCENE_COLOR_CHUNK_NEAR;
    mark.strength = 2;
    mark.size = 0;
    mark.count = 4;
    mark.points[0].x = mark.points[3].x = left;
    mark.points[1].x = mark.points[2].x = (int16_t)(left + PITCH);
    mark.points[0].y = mark.points[1].y = top;
    mark.points[2].y = mark.points[3].y = (int16_t)(top + PITCH);
    c->emit(c->context, &mark);
}

/* The chunk a point lies in, tinted and framed. */
static void frame_chunk(const scene_canvas *c, scene_int2 at)
{
    int32_t x = scene_floor_divide(at.x / 4096, PITCH) * PITCH, y = scene_floor_divide(at.y / 4096, PITCH) * PITCH;
    tint_chunk(c, x, y);
    scene_draw_line(c, raw_at(x, y), raw_at(x + PITCH, y), SCENE_COLOR_CHUNK_NEAR, 10, 8);
    scene_draw_line(c, raw_at(x + PITCH, y), raw_at(x + PITCH, y + PITCH), SCENE_COLOR_CHUNK_NEAR, 10, 8);
    scene_draw_line(c, raw_at(x + PITCH, y + PITCH), raw_at(x, y + PITCH), SCENE_COLOR_CHUNK_NEAR, 10, 8);
    scene_draw_line(c, raw_at(x, y + PITCH), raw_at(x, y), SCENE_COLOR_CHUNK_NEAR, 10, 8);
}

static bool is_near(const scene *s, uint16_t piece, uint16_t found)
{
    for (uint16_t i = 0; i < found && i < s->world.nearby_capacity; i++) {
        if (s->nearby[i] == piece) return true;
    }
    return false;
}

/* The grid, and the chunks that hold the ship and the pieces within 64 units of it. A piece is kept by its position. */
static void draw_chunks(scene *s, const scene_canvas *c)
{
    uint16_t found = tuff_nearby_terrain(&s->world, s->ship.position, TUFF_WHOLE(64));
    draw_grid(c);
    for (uint16_t i = 0; i < found && i < s->world.nearby_capacity; i++) {
        const tuff_terrain *piece = &s->terrain[s->nearby[i]];
        scene_int2 at = scene_raw(piece->position);
        if (piece->bounding_radius <= TUFF_WHOLE(1 << SCENE_PITCH_LOG2)) frame_chunk(c, at);
        scene_draw_line(c, scene_raw(s->ship.position), at, SCENE_COLOR_CHUNK_NEAR, 7, 0);
    }
    frame_chunk(c, scene_raw(s->ship.position));
}

static void draw_bound(const scene_canvas *c, tuff_vec2 position, tuff_real radius, bool reached)
{
    scene_int2 at = scene_raw(position);
    int32_t size = tuff_to_q16_16(radius) / 4096;
    if (scene_out_of_view(c, at, size)) return;
    scene_draw_round(c, SCENE_RING, at, size, reached ? SCENE_COLOR_BOUND_NEAR : SCENE_COLOR_BOUND, reached ? SCENE_SOLID : 13);
}

TUFF_HOT static void draw_bounds(scene *s, const scene_canvas *c)
{
    uint16_t found = tuff_nearby_terrain(&s->world, s->ship.position, SCENE_SHIP_RADIUS);
    for (uint16_t i = 0; i < SCENE_PIECES; i++) {
        const tuff_terrain *piece = &s->terrain[i];
        if (piece->bounding_radius > 0) draw_bound(c, piece->position, piece->bounding_radius, is_near(s, i, found));
    }
    for (uint16_t i = 0; i < SCENE_FLOATERS; i++) {
        if (s->floaters[i].part_count != 0) draw_bound(c, s->floaters[i].position, s->floaters[i].bounding_radius, false);
    }
    draw_bound(c, s->ship.position, SCENE_SHIP_RADIUS, true);
}

static void draw_normal(const scene_canvas *c, scene_int2 from, scene_int2 to, tuff_unit2 normal, bool internal)
{
    scene_int2 middle, tip, way = scene_raw_unit2(normal);
    middle.x = from.x / 2 + to.x / 2;
    middle.y = from.y / 2 + to.y / 2;
    tip.x = middle.x + way.x * (internal ? INTERNAL_LENGTH : NORMAL_LENGTH);
    tip.y = middle.y + way.y * (internal ? INTERNAL_LENGTH : NORMAL_LENGTH);
    scene_draw_line(c, middle, tip, internal ? SCENE_COLOR_INTERNAL : SCENE_COLOR_NORMAL, SCENE_SOLID, 8);
}

static scene_int2 moved(scene_int2 at, tuff_vec2 by)
{
    scene_int2 offset = scene_raw(by);
    at.x += offset.x;
    at.y += offset.y;
    return at;
}

/* The most marks that a picture has. Internal edges are drawn too: they are there, and may separate, but push nobody. */
TUFF_HOT static void draw_part_normals(const scene_canvas *c, scene_int2 at, const tuff_polygon *part)
{
    for (uint8_t i = 0; i < part->count; i++) {
        bool internal = part->internal_edges >> i & 1;
        scene_int2 from = moved(at, part->vertices[i]), to = moved(at, part->vertices[i + 1 == part->count ? 0 : i + 1]);
        if (internal) scene_draw_line(c, from, to, SCENE_COLOR_INTERNAL, 10, 0);
        draw_normal(c, from, to, part->normals[i], internal);
    }
}

TUFF_HOT static void draw_piece_normals(const scene_canvas *c, const tuff_terrain *piece)
{
    scene_int2 at = scene_raw(piece->position);
    if (piece->part_count == 0 || scene_out_of_view(c, at, tuff_to_q16_16(piece->bounding_radius) / 4096 + NORMAL_LENGTH * 16)) return;
    for (uint8_t p = 0; p < piece->part_count; p++) draw_part_normals(c, at, &piece->parts[p]);
}

static void draw_normals(scene *s, const scene_canvas *c)
{
    tuff_unit2 hull_normals[SCENE_HULL];
    tuff_polygon hull = s->hull;
    for (uint16_t i = 0; i < SCENE_PIECES; i++) draw_piece_normals(c, &s->terrain[i]);
    for (uint16_t i = 0; i < SCENE_FLOATERS; i++) draw_piece_normals(c, &s->floaters[i]);
    tuff_edge_normals(hull.vertices, hull.count, hull_normals);
    hull.normals = hull_normals;
    draw_part_normals(c, scene_raw(s->ship.position), &hull);
}

/* A dot where the body was touched, a line along the normal: ten times the overlap, and 14 units more to be seen. */
static void draw_contacts(scene *s, const scene_canvas *c)
{
    for (uint8_t i = 0; i < SCENE_SCARS; i++) {
        const scene_scar *scar = &s->scars[i];
        scene_int2 at, tip;
        at.x = scar->x;
        at.y = scar->y;
        if (scar->life == 0 || scene_out_of_view(c, at, 16 * 30)) continue;
        int32_t length = 14 * 16 + (scar->overlap > 2 * SCENE_ONE ? 2 * SCENE_ONE : scar->overlap) / 4096 * 10;
        tip.x = at.x + scar->nx / 16 * length;
        tip.y = at.y + scar->ny / 16 * length;
        uint8_t strength = scar->life > 24 ? SCENE_SOLID : (uint8_t)(scar->life * 2 / 3 + 1);
        scene_draw_line(c, at, tip, SCENE_COLOR_CONTACT, strength, 16);
        scene_draw_round(c, SCENE_DISC, at, 28, SCENE_COLOR_CONTACT, strength);
        scene_draw_round(c, SCENE_RING, at, 16 * 5 + (40 - scar->life) * 3, SCENE_COLOR_CONTACT, (uint8_t)(strength / 2 + 1));
    }
}

void scene_draw_overlays(scene *s, const scene_canvas *c, uint8_t show)
{
    if (show & SCENE_SHOW_CHUNKS) draw_chunks(s, c);
    if (show & SCENE_SHOW_BOUNDS) draw_bounds(s, c);
    if (show & SCENE_SHOW_NORMALS) draw_normals(s, c);
    if (show & SCENE_SHOW_CONTACTS) draw_contacts(s, c);
}
