/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What goes into the scene and what comes out of it, in plain integers: the same for both builds of tuff, so that a program that
   talks to a scene need not know which number the scene counts with. */
#ifndef SCENE_MARKS_H
#define SCENE_MARKS_H

/* tuff's config.h, where it came first, has chosen the integer types already. */
#ifndef TUFF_CONFIG_H
#include <stdint.h>
#endif

/* Input of a step: a sum of these. */
enum {
    SCENE_LEFT   = 1,
    SCENE_RIGHT  = 2,
    SCENE_THRUST = 4,
    SCENE_BRAKE  = 8,
    SCENE_SHOOT  = 16,
    SCENE_BEAM   = 32
};

/* What scene_draw adds to the picture, and leaves out: a sum of these. */
enum {
    SCENE_SHOW_CHUNKS   = 1,   /* the index's grid, and the chunks about the ship */
    SCENE_SHOW_BOUNDS   = 2,   /* bounding circles; bright: those that the ship's circle reaches */
    SCENE_SHOW_NORMALS  = 4,   /* edge normals of parts, floaters and hull; internal edges in their own color */
    SCENE_SHOW_CONTACTS = 8,   /* the latest pushes: where, which way, and how deep (ten times) */
    SCENE_SHOW_PLAIN    = 16   /* less: no stars, no facets on the rocks */
};

/* Colors are numbers; scene_palette has a proposal for each. */
enum {
    SCENE_COLOR_SPACE, SCENE_COLOR_STAR_FAR, SCENE_COLOR_STAR_NEAR,
    SCENE_COLOR_FLOOR, SCENE_COLOR_FLOOR_EDGE, SCENE_COLOR_GROUND,
    SCENE_COLOR_ROCK, SCENE_COLOR_ROCK_LIT, SCENE_COLOR_ROCK_DARK,
    SCENE_COLOR_CONCAVE, SCENE_COLOR_CONCAVE_LIT, SCENE_COLOR_CONCAVE_DARK,
    SCENE_COLOR_VOLATILE, SCENE_COLOR_VOLATILE_LIT, SCENE_COLOR_VOLATILE_DARK,
    SCENE_COLOR_MOON, SCENE_COLOR_MOON_EDGE,
    SCENE_COLOR_FLOATER, SCENE_COLOR_FLOATER_LIT, SCENE_COLOR_FLOATER_DARK,
    SCENE_COLOR_SHIP, SCENE_COLOR_SHIP_EDGE, SCENE_COLOR_SHIELD, SCENE_COLOR_FLAME,
    SCENE_COLOR_SHOT, SCENE_COLOR_BEAM, SCENE_COLOR_SPARK,
    SCENE_COLOR_ENEMY, SCENE_COLOR_ENEMY_EDGE, SCENE_COLOR_ENEMY_EYE,
    SCENE_COLOR_CHUNK, SCENE_COLOR_CHUNK_NEAR,
    SCENE_COLOR_BOUND, SCENE_COLOR_BOUND_NEAR,
    SCENE_COLOR_NORMAL, SCENE_COLOR_INTERNAL,
    SCENE_COLOR_CONTACT,
    SCENE_COLORS
};

extern const uint32_t scene_palette[SCENE_COLORS];   /* 0xRRGGBB */

/* One thing to draw, over all that came before. Coordinates, radii and widths: 1/16 unit, from the middle of the view. */
enum { SCENE_POLYGON, SCENE_LINE, SCENE_DISC, SCENE_RING, SCENE_DOT };

#define SCENE_MARK_POINTS 32   /* as many as a part of a piece can have */
#define SCENE_SOLID       16   /* the strength of a mark that hides what is below */

typedef struct scene_point { int16_t x, y; } scene_point;

typedef struct scene_mark {
    uint8_t kind;
    uint8_t color;
    uint8_t strength;   /* 1 .. SCENE_SOLID: how much of what is below it hides */
    uint8_t count;      /* points: polygon 3 .. SCENE_MARK_POINTS and convex, line 2, others 1 */
    int16_t size;       /* radius of disc and ring; width of a line, 0: as thin as can be */
    scene_point points[SCENE_MARK_POINTS];
} scene_mark;

typedef void (*scene_emit)(void *context, const scene_mark *mark);

/* What to draw. */
typedef struct scene_view {
    int16_t half_width, half_height;   /* units; 16 .. 1024 */
    uint8_t show;                      /* SCENE_SHOW_... */
} scene_view;

/* What has happened since the start. */
enum {
    SCENE_EVENT_SHOTS, SCENE_EVENT_RICOCHETS, SCENE_EVENT_BEAM_HITS, SCENE_EVENT_ROCKS_BLOWN, SCENE_EVENT_ROCKS_GROWN,
    SCENE_EVENT_ENEMIES_DOWN, SCENE_EVENT_ROCK_BUMPS, SCENE_EVENT_FLOOR_TOUCHES, SCENE_EVENT_FLOATER_BUMPS,
    SCENE_EVENT_ENEMY_BUMPS, SCENE_EVENT_SHIPS_LOST,
    SCENE_EVENTS
};

/* What to show in a status line. */
typedef struct scene_counts {
    uint16_t bodies;       /* ship, enemies, floaters, shots */
    uint16_t candidates;   /* pieces whose bounding circle a body's circle reaches, summed over the bodies */
    uint16_t tests;        /* convex parts of the candidates, a circle counting as one */
    uint16_t contacts;     /* pushes made in the latest step */
    uint16_t pieces;       /* in the world */
    uint8_t  shield;       /* 0 .. SCENE_SHIELD */
    uint8_t  energy;       /* of the beam: 0 .. SCENE_ENERGY */
    uint32_t score;
} scene_counts;

#define SCENE_SHIELD 8
#define SCENE_ENERGY 120

#endif
