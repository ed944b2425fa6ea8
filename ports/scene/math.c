/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Random numbers, headings and roots in integers; directions. */
#include "inner.h"

/* xorshift32 (Marsaglia, 2003); the low bits are the weaker ones. */
uint32_t scene_random(scene *s, uint32_t below)
{
    uint32_t x = s->random;
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    s->random = x;
    return (x >> 12) % below;
}

/* sin(i / 64 turn) for a quarter turn, in steps of 2^-14. */
static const int16_t quarter[17] = {
    0, 1606, 3196, 4756, 6270, 7723, 9102, 10394, 11585, 12665, 13623, 14449, 15137, 15679, 16069, 16305, 16384
};

static int32_t sine(uint8_t step)
{
    uint8_t in_half = (uint8_t)(step & 31);
    int16_t size = quarter[in_half <= 16 ? in_half : 32 - in_half];
    return step & 32 ? -(int32_t)size : size;
}

scene_int2 scene_heading(uint8_t facing)
{
    uint8_t step = (uint8_t)(facing >> 2);
    scene_int2 heading;
    heading.x = sine((uint8_t)((step + 16) & 63));
    heading.y = sine(step);
    return heading;
}

/* The nearest heading lies in the direction's own quadrant, its ends included; the first of two that are as near. */
uint8_t scene_facing_of(int32_t dx, int32_t dy)
{
    while (dx > 16383 || dx < -16383 || dy > 16383 || dy < -16383) {
        dx /= 2;
        dy /= 2;
    }
    uint8_t best = 0, first = (uint8_t)(dy >= 0 ? (dx >= 0 ? 0 : 16) : (dx < 0 ? 32 : 48));
    int32_t best_dot = dx * quarter[16];
    for (uint8_t step = first; step <= first + 16; step++) {
        int32_t dot = dx * sine((uint8_t)((step + 16) & 63)) + dy * sine(step);
        if (dot > best_dot) {
            best_dot = dot;
            best = step;
        }
    }
    return (uint8_t)(best << 2);
}

/* Digit by digit: n keeps what the square of the digits so far has left of it. */
uint32_t scene_root(uint32_t n)
{
    uint32_t root = 0;
    for (uint32_t bit = (uint32_t)1 << 30; bit != 0; bit >>= 2) {
        uint32_t tried = root | bit;
        root >>= 1;
        if (n < tried) continue;
        n -= tried;
        root |= bit;
    }
    return root;
}

int32_t scene_distance(int32_t dx, int32_t dy)
{
    return (int32_t)scene_root((uint32_t)(dx * dx) + (uint32_t)(dy * dy));
}

scene_int2 scene_raw_unit2(tuff_unit2 v)
{
    tuff_vec2 unit_long;
    unit_long.x = tuff_scale(TUFF_WHOLE(1), v.x);
    unit_long.y = tuff_scale(TUFF_WHOLE(1), v.y);
    return scene_raw(unit_long);
}

int32_t scene_floor_divide(int32_t n, int32_t d)
{
    return n >= 0 ? n / d : -((d - 1 - n) / d);
}

scene_int2 scene_toward(tuff_vec2 from, tuff_vec2 to)
{
    scene_int2 a = scene_raw(from), b = scene_raw(to), way;
    way.x = b.x / SCENE_ONE - a.x / SCENE_ONE;
    way.y = b.y / SCENE_ONE - a.y / SCENE_ONE;
    return way;
}
