/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What only the eye needs: sparks, and the marks that pushes leave. Integers throughout. */
#include "inner.h"

void scene_add_spark(scene *s, scene_int2 at, scene_int2 speed, uint8_t life, uint8_t color)
{
    scene_spark *spark = &s->sparks[s->next_spark];
    s->next_spark = (uint8_t)((s->next_spark + 1) % SCENE_SPARKS);
    spark->x = at.x;
    spark->y = at.y;
    spark->vx = speed.x;
    spark->vy = speed.y;
    spark->life = life;
    spark->color = color;
}

void scene_burst(scene *s, scene_int2 at, uint8_t number, uint8_t color)
{
    for (uint8_t i = 0; i < number; i++) {
        scene_int2 way = scene_heading((uint8_t)scene_random(s, 256)), speed;
        int32_t pace = 1 + (int32_t)scene_random(s, 6);
        speed.x = way.x * pace;
        speed.y = way.y * pace;
        scene_add_spark(s, at, speed, (uint8_t)(14 + scene_random(s, 16)), color);
    }
}

void scene_move_sparks(scene *s)
{
    for (uint8_t i = 0; i < SCENE_SPARKS; i++) {
        scene_spark *spark = &s->sparks[i];
        if (spark->life == 0) continue;
        spark->life--;
        spark->x += spark->vx;
        spark->y += spark->vy;
        spark->vx -= spark->vx / 32;
        spark->vy -= spark->vy / 32;
    }
    for (uint8_t i = 0; i < SCENE_SCARS; i++) {
        if (s->scars[i].life != 0) s->scars[i].life--;
    }
}

/* The corner of the hull that lies farthest against the normal. */
static scene_int2 deepest_corner(const tuff_polygon *hull, scene_int2 normal)
{
    scene_int2 deepest = {0, 0};
    int64_t least = INT64_MAX;
    for (uint8_t i = 0; i < hull->count; i++) {
        scene_int2 corner = scene_raw(hull->vertices[i]);
        int64_t along = (int64_t)corner.x * normal.x + (int64_t)corner.y * normal.y;
        if (along < least) {
            least = along;
            deepest = corner;
        }
    }
    return deepest;
}

static bool within_three_units(int32_t a, int32_t b)
{
    return a - b < 3 * SCENE_ONE && b - a < 3 * SCENE_ONE;
}

/* A push where one was marked lately renews that mark: a body that slides would leave a blot. */
static scene_scar *scar_slot(scene *s, int32_t x, int32_t y)
{
    for (uint8_t i = 0; i < SCENE_SCARS; i++) {
        scene_scar *scar = &s->scars[i];
        if (scar->life != 0 && within_three_units(scar->x, x) && within_three_units(scar->y, y)) return scar;
    }
    scene_scar *next = &s->scars[s->next_scar];
    s->next_scar = (uint8_t)((s->next_scar + 1) % SCENE_SCARS);
    return next;
}

/* Where the body was touched: on its circle, or the hull's corner that was deepest inside. */
void scene_add_scar(scene *s, const tuff_body *body, tuff_real radius, const tuff_polygon *hull, const tuff_contact *contact)
{
    scene_int2 normal = scene_raw_unit2(contact->normal), at = scene_raw(body->position), touch;
    int32_t sixteenths = tuff_to_q16_16(radius) / 4096;
    if (hull != NULL) touch = deepest_corner(hull, normal);
    else {
        touch.x = -(normal.x / 16) * sixteenths;
        touch.y = -(normal.y / 16) * sixteenths;
    }
    at.x += touch.x;
    at.y += touch.y;
    scene_scar *scar = scar_slot(s, at.x, at.y);
    scar->x = at.x;
    scar->y = at.y;
    scar->nx = normal.x;
    scar->ny = normal.y;
    scar->overlap = tuff_to_q16_16(contact->overlap);
    scar->life = 40;
}
