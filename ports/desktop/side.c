/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Compiled once for each number type: the scene of that build and the table that leads to it. */
#include <string.h>

#include "../scene/scene.h"
#include "side.h"

#define this_side TUFF_LINK_NAME(side)

static scene belt;

static void start(uint32_t seed)
{
    scene_init(&belt, seed);
}

static void step(uint16_t buttons)
{
    scene_step(&belt, buttons);
}

static uint16_t pilot(void)
{
    return scene_pilot(&belt);
}

static void draw(const scene_view *view, scene_emit emit, void *context)
{
    scene_draw(&belt, view, emit, context);
}

static uint32_t hash(uint32_t before)
{
    return scene_hash(&belt, before);
}

static void count(scene_counts *counts)
{
    scene_count(&belt, counts);
}

static void events(uint16_t list[SCENE_EVENTS])
{
    memcpy(list, belt.events, sizeof belt.events);
}

static void ship(int32_t at[2])
{
    at[0] = tuff_to_q16_16(belt.ship.position.x);
    at[1] = tuff_to_q16_16(belt.ship.position.y);
}

static const char *fault(uint16_t *number)
{
    return scene_fault(&belt, number);
}

const side this_side = {start, step, pilot, draw, hash, count, events, ship, fault, sizeof belt};
