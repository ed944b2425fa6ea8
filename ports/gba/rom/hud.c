/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Words and bars. */
#include "hud.h"

#include "hardware.h"
#include "letters.h"
#include "paint.h"

#define TOP_LINE    2
#define METER_LINE  139
#define FRAME_LINE  149
#define BAR_TOP     157    /* the share of the frame, in color */
#define BEAM_BLOCKS 6
#define STRIP_COLOR SCENE_COLOR_GROUND

/* As many of the blocks as the value's share of the most. */
static int write_bar(int x, uint8_t color, unsigned value, unsigned most, unsigned blocks)
{
    unsigned full = (value * blocks + most - 1) / most;
    for (unsigned i = 0; i < blocks; i++) x = letters_add(x, TOP_LINE, i < full ? color : LETTERS_DIM, i < full ? "#" : "-");
    return x;
}

static void write_state(const scene *s)
{
    int x = letters_add(3, TOP_LINE, LETTERS_DIM, "SCORE ");
    letters_add_number(x, TOP_LINE, LETTERS_WHITE, s->score);
    x = letters_add(78, TOP_LINE, LETTERS_DIM, "SHIELD ");
    write_bar(x, LETTERS_SHIELD, s->shield, SCENE_SHIELD, SCENE_SHIELD);
    x = letters_add(174, TOP_LINE, LETTERS_DIM, "BEAM ");
    write_bar(x, LETTERS_BEAM, s->energy, SCENE_ENERGY, BEAM_BLOCKS);
}

/* Tenths of a percent of a frame of the screen. */
static int write_share(int x, uint32_t cycles)
{
    uint32_t tenths = cycles * 125 / (FRAME_CYCLES / 8);
    x = letters_add_number(x, METER_LINE, LETTERS_METER, tenths / 10);
    x = letters_add(x, METER_LINE, LETTERS_METER, ".");
    x = letters_add_number(x, METER_LINE, LETTERS_METER, tenths % 10);
    return letters_add(x, METER_LINE, LETTERS_METER, "%");
}

static void write_meter(const account *spent, bool autopilot)
{
    int x = letters_add_number(3, FRAME_LINE, LETTERS_METER, spent->rate);
    letters_add(x, FRAME_LINE, LETTERS_DIM, " FPS");
    if (autopilot) letters_add(183, FRAME_LINE, LETTERS_BEAM, "AUTOPILOT");
    x = letters_add(3, METER_LINE, LETTERS_DIM, "COLLISION ");
    x = letters_add_number(x, METER_LINE, LETTERS_METER, spent->mean_collision);
    x = letters_add(x, METER_LINE, LETTERS_DIM, " CYCLES, ");
    x = write_share(x, spent->mean_collision);
    letters_add(x, METER_LINE, LETTERS_DIM, " OF FRAME");
}

/* Above and below the ship, which the camera keeps near the middle. */
static void write_title(void)
{
    static const char name[] = "TUFF";
    for (int i = 0; name[i] != '\0'; i++) letters_add_big(70 + 26 * i, 15, LETTERS_SHIELD, name[i]);
    letters_add(69, 47, LETTERS_WHITE, "TERRAIN COLLISION");
    letters_add(63, 98, LETTERS_WHITE, "PAD: TURN, THRUST");
    letters_add(63, 107, LETTERS_WHITE, "A: SHOOT, B: BEAM");
    letters_add(63, 116, LETTERS_WHITE, "SELECT: LOOK INSIDE");
    letters_add(63, 127, LETTERS_BEAM, "PRESS START TO FLY");
}

void hud_write(const scene *s, const account *spent, bool autopilot, bool title)
{
    letters_clear();
    write_meter(spent, autopilot);
    if (title) write_title();
    else write_state(s);
}

static int paint_part(int x, uint32_t cycles, uint8_t color)
{
    int end = x + (int)(cycles / (FRAME_CYCLES / PAGE_WIDTH));
    paint_box(x, BAR_TOP - PAINT_TOP, end, PAGE_HEIGHT - PAINT_TOP, color);
    return end;
}

void hud_paint_strips(void)
{
    paint_box(0, -PAINT_TOP, PAGE_WIDTH, 0, STRIP_COLOR);
    paint_box(0, PAINT_HEIGHT, PAGE_WIDTH, PAGE_HEIGHT - PAINT_TOP, STRIP_COLOR);
}

void hud_paint(const account *spent)
{
    int x = paint_part(0, spent->latest[SPENT_COLLISION], SCENE_COLOR_BOUND_NEAR);
    x = paint_part(x, spent->latest[SPENT_STEP] - spent->latest[SPENT_COLLISION], SCENE_COLOR_SHIELD);
    x = paint_part(x, spent->latest[SPENT_DRAW], SCENE_COLOR_MOON_EDGE);
    paint_part(x, FRAME_CYCLES, STRIP_COLOR);
}
