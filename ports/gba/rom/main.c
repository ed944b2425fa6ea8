/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The demo's belt on a Game Boy Advance: a step each sixtieth of a second, and a picture. Left, right turn; up thrusts, down brakes; A
   shoots, B beams; START hands the ship to the player and back to the autopilot; SELECT goes through the pictures of what the library
   sees. */
#include "account.h"
#include "hardware.h"
#include "hud.h"
#include "letters.h"
#include "meter.h"
#include "paint.h"
#include "scene.h"

#define SEED        1
#define TITLE_EVERY 900
#define TITLE_SHOWN 300
#define TEXT_EVERY  8   /* steps, not those of the pilot */
#define LATEST      (60 * (int32_t)(FRAME_CYCLES / 228))   /* in the blank, which has 68 lines: time to show a page */
#define PILOT_EVERY 4   /* steps: it looks along some twenty lines, half of them two steps before the others, then holds the buttons */

typedef struct console {
    scene    belt;
    account  spent;
    uint16_t held;            /* keys in the frame before */
    uint16_t buttons;         /* of the scene */
    uint16_t page;            /* the one to paint */
    scene_aim target;         /* of the autopilot */
    uint8_t  show;
    bool     title, autopilot;
    uint32_t blank_at;        /* the clock when the next one begins */
    uint32_t text, text_shown;    /* the number of the text that is written, that is on the screen */
} console;

static console all SLOW_MEMORY;

static uint16_t buttons_of(uint16_t keys)
{
    static const uint16_t meaning[][2] = {
        {KEY_LEFT, SCENE_LEFT}, {KEY_RIGHT, SCENE_RIGHT}, {KEY_UP, SCENE_THRUST}, {KEY_DOWN, SCENE_BRAKE},
        {KEY_A, SCENE_SHOOT}, {KEY_B, SCENE_BEAM}
    };
    uint16_t buttons = 0;
    for (unsigned i = 0; i < sizeof meaning / sizeof meaning[0]; i++) {
        if ((keys & meaning[i][0]) != 0) buttons = (uint16_t)(buttons | meaning[i][1]);
    }
    return buttons;
}

/* Nothing, each thing alone, nothing. */
static uint8_t next_show(uint8_t show)
{
    return show == 0 ? 1 : (uint8_t)(show * 2 & 15);
}

static void take_keys(console *c, uint16_t keys)
{
    uint16_t pressed = (uint16_t)(keys & ~c->held);
    c->held = keys;
    if ((pressed & KEY_SELECT) != 0) c->show = next_show(c->show);
    if ((pressed & KEY_START) == 0) return;
    c->autopilot = !c->autopilot;
    c->title = false;
}

/* Waits for the next blank, or takes the present one, which is long: a picture that comes a little late is not missed, and the work on the
   next one just begins later. Returns how many blanks have passed. */
static uint32_t await_blank(console *c)
{
    uint32_t passed = 1;
    for (; (int32_t)(clock_now() - c->blank_at) > LATEST; c->blank_at += FRAME_CYCLES) passed++;
    while ((int32_t)(clock_now() - c->blank_at) < 0) {}
    c->blank_at += FRAME_CYCLES;
    return passed;
}

static void show_page(console *c)
{
    DISPLAY = (uint16_t)(DISPLAY_BITMAP | DISPLAY_ROWS | DISPLAY_LAYERS | (c->page != 0 ? DISPLAY_PAGE : 0));
    if (c->text_shown != c->text) letters_show();
    c->text_shown = c->text;
    c->page ^= 1;
}

static void paint(console *c)
{
    static const scene_view plain = {PAGE_WIDTH / 2, PAINT_HEIGHT / 2, 0};
    scene_view view = plain;
    if (c->show != 0) view.show = (uint8_t)(c->show | SCENE_SHOW_PLAIN);   /* in the time, and on the rocks, that the others leave free */
    paint_begin(PAGE(c->page));
    scene_draw(&c->belt, &view, paint_mark, NULL);
    hud_paint(&c->spent);
    c->text = (c->belt.frame + TEXT_EVERY / 2) / TEXT_EVERY;
    if (c->text_shown == c->text) return;
    hud_write(&c->belt, &c->spent, c->autopilot, c->title && c->belt.frame % TITLE_EVERY < TITLE_SHOWN);
}

static void pilot(console *c)
{
    uint32_t phase = c->belt.frame % PILOT_EVERY;
    if (phase == PILOT_EVERY / 2) scene_take_aim(&c->belt, &c->target);
    if (phase == 0) c->buttons = scene_steer(&c->belt, &c->target);
}

static void step(console *c)
{
    uint32_t begun = clock_now(), piloted;
    uint16_t keys = (uint16_t)(~KEYS & KEYS_ALL);
    take_keys(c, keys);
    if (!c->autopilot) c->buttons = buttons_of(keys);
    else pilot(c);
    piloted = clock_now();
    meter_cycles = 0;
    scene_step(&c->belt, c->buttons);
    account_add(&c->spent, SPENT_COLLISION, meter_cycles);
    account_add(&c->spent, SPENT_PILOT, piloted - begun);
    account_add(&c->spent, SPENT_STEP, clock_now() - piloted);
}

/* A step for each of the screen's frames that have passed: the game keeps its pace when a picture does not. */
static void run_frame(console *c, uint32_t passed)
{
    uint32_t begun = clock_now(), stepped;
    for (; passed > 0; passed--) step(c);
    stepped = clock_now();
    paint(c);
    account_add(&c->spent, SPENT_DRAW, clock_now() - stepped);
    account_add(&c->spent, SPENT_ALL, clock_now() - begun);
}

int main(void)
{
    uint32_t passed = 1;
    paint_colors();
    paint_start();
    letters_load();
    for (int i = 0; i < 2; i++) {
        paint_begin(PAGE(i));
        hud_paint_strips();
    }
    clock_start();
    scene_init(&all.belt, SEED);
    all.title = true;
    all.autopilot = true;
    while (SCAN_LINE != VISIBLE_LINES) {}
    all.blank_at = clock_now() + FRAME_CYCLES;
    for (;;) {
        run_frame(&all, passed);
        passed = await_blank(&all);
        show_page(&all);
        account_shown(&all.spent, passed);
    }
}
