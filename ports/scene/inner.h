/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What the files of the scene share. Decisions and drawing count in integers, the same in both builds; only bodies and terrain
   count in tuff_real. */
#ifndef SCENE_INNER_H
#define SCENE_INNER_H

#include "scene.h"

#define scene_random         TUFF_LINK_NAME(scene_random)
#define scene_heading        TUFF_LINK_NAME(scene_heading)
#define scene_facing_of      TUFF_LINK_NAME(scene_facing_of)
#define scene_distance       TUFF_LINK_NAME(scene_distance)
#define scene_root           TUFF_LINK_NAME(scene_root)
#define scene_raw_unit2      TUFF_LINK_NAME(scene_raw_unit2)
#define scene_toward         TUFF_LINK_NAME(scene_toward)
#define scene_floor_divide   TUFF_LINK_NAME(scene_floor_divide)
#define scene_rock           TUFF_LINK_NAME(scene_rock)
#define scene_build_floor    TUFF_LINK_NAME(scene_build_floor)
#define scene_build_world    TUFF_LINK_NAME(scene_build_world)
#define scene_clear_spot     TUFF_LINK_NAME(scene_clear_spot)
#define scene_place_rock     TUFF_LINK_NAME(scene_place_rock)
#define scene_place_floater  TUFF_LINK_NAME(scene_place_floater)
#define scene_place_enemy    TUFF_LINK_NAME(scene_place_enemy)
#define scene_blow_up        TUFF_LINK_NAME(scene_blow_up)
#define scene_grow_rocks     TUFF_LINK_NAME(scene_grow_rocks)
#define scene_turn_hull      TUFF_LINK_NAME(scene_turn_hull)
#define scene_meet_terrain   TUFF_LINK_NAME(scene_meet_terrain)
#define scene_move_ship      TUFF_LINK_NAME(scene_move_ship)
#define scene_move_beam      TUFF_LINK_NAME(scene_move_beam)
#define scene_move_enemies   TUFF_LINK_NAME(scene_move_enemies)
#define scene_move_floaters  TUFF_LINK_NAME(scene_move_floaters)
#define scene_move_shots     TUFF_LINK_NAME(scene_move_shots)
#define scene_shoot          TUFF_LINK_NAME(scene_shoot)
#define scene_hit_enemy      TUFF_LINK_NAME(scene_hit_enemy)
#define scene_hit_rock       TUFF_LINK_NAME(scene_hit_rock)
#define scene_contain        TUFF_LINK_NAME(scene_contain)
#define scene_move_sparks    TUFF_LINK_NAME(scene_move_sparks)
#define scene_add_spark      TUFF_LINK_NAME(scene_add_spark)
#define scene_burst          TUFF_LINK_NAME(scene_burst)
#define scene_add_scar       TUFF_LINK_NAME(scene_add_scar)
#define scene_draw_overlays  TUFF_LINK_NAME(scene_draw_overlays)
#define scene_draw_line      TUFF_LINK_NAME(scene_draw_line)
#define scene_draw_round     TUFF_LINK_NAME(scene_draw_round)
#define scene_out_of_view    TUFF_LINK_NAME(scene_out_of_view)

/* Measures of the belt, in whole units; y grows downward. */
#define SCENE_SIDE        620    /* a soft field turns bodies back beyond |x| = SCENE_SIDE ... */
#define SCENE_TOP         (-250)   /* ... and above y = SCENE_TOP */
#define SCENE_FLOOR_PULL  90     /* below this y, the floor pulls */
#define SCENE_BOTTOM      290    /* the picture's end */
#define SCENE_START_X     0
#define SCENE_START_Y     (-40)

#define SCENE_ENEMY_RADIUS     6
#define SCENE_FLOATER_SHAPE    0     /* the first of the small ones */
#define SCENE_BEAM_LENGTH      220
#define SCENE_ROCK_HITS        4
#define SCENE_FIRST_TRIES      60    /* of a place for a thing, before the first step */
#define SCENE_ONE              ((int32_t)65536)   /* 1 in Q16.16 */

#define SCENE_SHIP_RADIUS  TUFF_RATIO(41, 4)   /* covers the hull at every heading, the sine table's rounding included */
#define SCENE_SHOT_RADIUS  TUFF_RATIO(3, 2)

/* From tuff's numbers to Q16.16 and back. */
static inline scene_int2 scene_raw(tuff_vec2 v)
{
    scene_int2 raw;
    raw.x = tuff_to_q16_16(v.x);
    raw.y = tuff_to_q16_16(v.y);
    return raw;
}

static inline tuff_vec2 scene_vec2(int32_t raw_x, int32_t raw_y)
{
    tuff_vec2 v;
    v.x = tuff_from_q16_16(raw_x);
    v.y = tuff_from_q16_16(raw_y);
    return v;
}

/* math.c */
uint32_t   scene_random(scene *s, uint32_t below);                /* 0 .. below - 1 */
scene_int2 scene_heading(uint8_t facing);                         /* unit vector in steps of 2^-14, one of 64 */
uint8_t    scene_facing_of(int32_t dx, int32_t dy);               /* the heading nearest to a direction */
int32_t    scene_distance(int32_t dx, int32_t dy);                /* |dx|, |dy| up to 32767; rounded down */
uint32_t   scene_root(uint32_t n);                                /* rounded down */
int32_t    scene_floor_divide(int32_t n, int32_t d);              /* d > 0 */
scene_int2 scene_raw_unit2(tuff_unit2 v);                         /* Q16.16 */
scene_int2 scene_toward(tuff_vec2 from, tuff_vec2 to);            /* whole units */

/* shapes.c */
const tuff_terrain *scene_rock(uint8_t shape);
void scene_build_floor(scene *s);

/* belt.c */
void scene_build_world(scene *s);
bool scene_clear_spot(scene *s, tuff_real radius, int32_t from_ship, tuff_vec2 *spot);
bool scene_place_rock(scene *s, uint16_t piece, uint8_t shape, int32_t from_ship);
void scene_place_floater(scene *s, uint16_t floater, tuff_vec2 position, tuff_vec2 velocity);
void scene_place_enemy(scene *s, scene_enemy *enemy);
void scene_blow_up(scene *s, uint16_t piece);
void scene_grow_rocks(scene *s);

/* step.c */
void     scene_contain(tuff_body *body);
uint16_t scene_meet_terrain(scene *s, tuff_body *body, tuff_real radius, const tuff_polygon *hull, tuff_touches *touches);
void     scene_hit_enemy(scene *s, scene_enemy *enemy);
void     scene_hit_rock(scene *s, uint16_t piece);

/* ship.c */
void scene_turn_hull(scene *s);
void scene_move_ship(scene *s);
void scene_move_beam(scene *s);

/* bodies.c */
void scene_move_enemies(scene *s);
void scene_move_floaters(scene *s);
void scene_move_shots(scene *s);
void scene_shoot(scene *s);

/* sparks.c */
void scene_add_spark(scene *s, scene_int2 at, scene_int2 speed, uint8_t life, uint8_t color);
void scene_burst(scene *s, scene_int2 at, uint8_t number, uint8_t color);
void scene_move_sparks(scene *s);
void scene_add_scar(scene *s, const tuff_body *body, tuff_real radius, const tuff_polygon *hull, const tuff_contact *contact);

/* draw.c and overlay.c */
typedef struct scene_canvas {
    scene_emit emit;
    void      *context;
    int32_t camera_x, camera_y;        /* 1/16 unit */
    int32_t half_width, half_height;   /* 1/16 unit */
    bool    plain;
} scene_canvas;

/* Positions in Q16.16, sizes in 1/16 unit. */
bool scene_out_of_view(const scene_canvas *c, scene_int2 at, int32_t reach);
void scene_draw_line(const scene_canvas *c, scene_int2 from, scene_int2 to, uint8_t color, uint8_t strength, int16_t width);
void scene_draw_round(const scene_canvas *c, uint8_t kind, scene_int2 at, int32_t radius, uint8_t color, uint8_t strength);
void scene_draw_overlays(scene *s, const scene_canvas *c, uint8_t show);

#endif
