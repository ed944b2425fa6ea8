/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Keys in, pictures out, in step with the clock. A terminal tells of keys pressed, never of keys released: a press counts as held for
   some steps, long enough for the keyboard's repeat to take over. */
#include "play.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "game.h"
#include "hud.h"
#include "raster.h"
#include "screen.h"
#include "terminal.h"

#define INK       0xe6eef6u
#define INK_DIM   0xa0b4c8u
#define INK_HELP  0xffe8a0u
#define BAR       0x141a2cu

/* Buttons, the keys that press them, and the steps a press lasts. */
static const struct control { int key, other_key; uint16_t button; unsigned steps; } controls[] = {
    {KEY_LEFT, 'a', SCENE_LEFT, 5}, {KEY_RIGHT, 'd', SCENE_RIGHT, 5}, {KEY_UP, 'w', SCENE_THRUST, 26}, {KEY_DOWN, 's', SCENE_BRAKE, 20},
    {' ', 'f', SCENE_SHOOT, 6}, {'b', 'e', SCENE_BEAM, 26}
};
#define CONTROLS (sizeof controls / sizeof controls[0])

static const char *const help[] = {
    "                                                ",
    "  arrows or WASD  turn, thrust, brake           ",
    "  space           shoot      B  beam            ",
    "  Tab             float / Q16.16                ",
    "  V               split view                    ",
    "  1 2 3 4         chunks, bounding circles,     ",
    "                  normals, contacts             ",
    "  O autopilot  P pause  R restart  Q quit       ",
    "                                                ",
    "  orange rocks can be blown up                  ",
    "  candidates: pieces whose circle a body reaches",
    "  tests: convex parts of the candidates         ",
    "                                                "
};

typedef struct player {
    game   g;
    screen s;
    raster r;
    unsigned held[CONTROLS];
    bool help, leave;
} player;

static bool press(player *p, int key)
{
    for (size_t i = 0; i < CONTROLS; i++) {
        if (key != controls[i].key && key != controls[i].other_key) continue;
        p->held[i] = controls[i].steps;
        p->g.autopilot = false;
        return true;
    }
    return false;
}

static void restart(player *p, const options *o)
{
    options again = *o;
    again.autopilot = p->g.autopilot;
    again.split = p->g.split;
    again.show = p->g.show;
    again.build = p->g.shown;
    game_start(&p->g, &again);
}

static void obey(player *p, int key, const options *o)
{
    if (key >= 'A' && key <= 'Z') key += 'a' - 'A';
    if (press(p, key)) return;
    switch (key) {
    case '1': case '2': case '3': case '4': p->g.show ^= (uint8_t)(1 << (key - '1')); break;
    case '\t': p->g.shown = !p->g.shown; break;
    case 'v': p->g.split = !p->g.split; break;
    case 'o': p->g.autopilot = !p->g.autopilot; break;
    case 'p': p->g.paused = !p->g.paused; break;
    case 'r': restart(p, o); break;
    case '?': case 'h': p->help = !p->help; break;
    case 'q': p->leave = true; break;
    default: break;
    }
}

static uint16_t buttons_now(player *p)
{
    uint16_t buttons = 0;
    for (size_t i = 0; i < CONTROLS; i++) {
        if (p->held[i] == 0) continue;
        p->held[i]--;
        buttons |= controls[i].button;
    }
    return buttons;
}

static void paint(player *p)
{
    const game *g = &p->g;
    unsigned width = p->r.width, half = width / 2;
    if (g->split) {
        raster_scene(&p->r, 0, half, g->sides[SIDE_FLOAT], g->show);
        raster_scene(&p->r, half + 1, width - half - 1, g->sides[SIDE_Q16], g->show);
    } else {
        raster_scene(&p->r, 0, width, g->sides[g->shown], g->show);
    }
    raster_finish(&p->r);
    screen_picture(&p->s, &p->r, 1);
}

static void write_words(player *p)
{
    char line[HUD_LENGTH];
    unsigned columns = p->s.columns, last = p->s.rows - 1;
    screen_bar(&p->s, 0, BAR);
    screen_bar(&p->s, last, BAR);
    hud_title(&p->g, columns - 2, line);
    screen_text(&p->s, 1, 0, line, INK);
    if (p->g.split) {
        hud_counts(&p->g, SIDE_FLOAT, columns / 2 - 2, line);
        screen_text(&p->s, 1, last, line, INK_DIM);
        hud_counts(&p->g, SIDE_Q16, columns / 2 - 2, line);
        screen_text(&p->s, columns / 2 + 1, last, line, INK_DIM);
        return;
    }
    hud_counts(&p->g, p->g.shown, columns - 9, line);
    screen_text(&p->s, 1, last, line, INK_DIM);
    screen_text(&p->s, columns - 7, last, "? help", INK_HELP);
}

static void write_help(player *p)
{
    unsigned count = sizeof help / sizeof help[0], left = p->s.columns > 50 ? (p->s.columns - 48) / 2 : 0;
    unsigned top = p->s.rows > count + 2 ? (p->s.rows - count) / 2 : 1;
    for (unsigned i = 0; i < count; i++) screen_text(&p->s, left, top + i, help[i], INK_HELP);
}

/* At least 20 x 6 cells, at most 500 x 200: smaller terminals clip, larger ones leave a margin. */
static bool fit(player *p)
{
    unsigned columns, rows;
    terminal_size(&columns, &rows);
    columns = columns < 20 ? 20 : columns > 500 ? 500 : columns;
    rows = rows < 6 ? 6 : rows > 200 ? 200 : rows;
    if (terminal_resumed() && p->s.cells != NULL) screen_forget(&p->s);
    return screen_resize(&p->s, columns, rows) && raster_resize(&p->r, columns, (rows - 2) * 2);
}

static bool show(player *p)
{
    if (!fit(p)) return false;
    paint(p);
    write_words(p);
    if (p->help) write_help(p);
    return screen_send(&p->s);
}

static void sleep_until(double when)
{
    double rest = when - clock_now();
    struct timespec pause;
    if (rest <= 0) return;
    pause.tv_sec = (time_t)(rest / 1e6);
    pause.tv_nsec = (long)((rest - (double)pause.tv_sec * 1e6) * 1e3);
    nanosleep(&pause, NULL);
}

/* The steps of one picture. */
static void advance(player *p, const options *o, uint32_t *due)
{
    for (*due += 60; *due >= o->fps; *due -= o->fps) {
        uint16_t buttons = buttons_now(p);
        if (p->g.paused || (o->frames != 0 && p->g.frame >= o->frames)) continue;
        game_step_together(&p->g, buttons);
    }
}

static void play(player *p, const options *o)
{
    uint32_t due = 0;
    double next = clock_now();
    while (!p->leave && (o->frames == 0 || p->g.frame < o->frames)) {
        for (int key = terminal_key(); key != KEY_NONE; key = terminal_key()) obey(p, key, o);
        advance(p, o, &due);
        if (!show(p)) return;
        next += 1e6 / o->fps;
        if (next < clock_now() - 250e3) next = clock_now();
        sleep_until(next);
    }
}

int play_run(const options *o)
{
    static player p;
    game_start(&p.g, o);
    if (!terminal_open()) p.g.autopilot = true;
    play(&p, o);
    terminal_close();
    screen_free(&p.s);
    raster_free(&p.r);
    printf("%lu frames, the two builds' ships %.5f units apart\n", (unsigned long)p.g.frame, game_drift(&p.g));
    return 0;
}
