/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The font as sprites' tiles of 16 colors: 1 is the letter's color, 2 its shadow, to the right and below. */
#include "letters.h"

#include <stdbool.h>

#include "font.h"
#include "hardware.h"

#define FIRST_CHARACTER ' '
#define LAST_CHARACTER  'Z'
#define HIDDEN          0x0200u
#define ATTRIBUTES      4
#define BIG_SIDE        4          /* tiles */
#define BIG_TILES       (BIG_SIDE * BIG_SIDE)
#define FIRST_BIG       64         /* the tile after the small letters, which are fewer */
#define SIZE_32         0x8000u

static uint16_t sprites[SPRITE_COUNT][ATTRIBUTES] SLOW_MEMORY;
static unsigned used;

static const char big_ones[] = "TUF";

static const uint32_t colors[LETTERS_COLORS] = {0xffffff, 0x9aa8c8, 0x5ac8ff, 0x5affc8, 0xffe03c};

/* The dots of a row, bit 0 the leftmost. */
static uint32_t row_of(const uint8_t *rows, int y)
{
    uint32_t dots = 0;
    if (y < 0 || y >= FONT_HEIGHT) return 0;
    for (int x = 0; x < FONT_WIDTH; x++) dots |= (uint32_t)(rows[y] >> (FONT_WIDTH - 1 - x) & 1) << x;
    return dots;
}

/* Four bits a dot. */
static uint32_t spread(uint32_t ink, uint32_t shadow)
{
    uint32_t row = 0;
    for (unsigned x = 0; x < 8; x++) row |= ((ink >> x & 1) != 0 ? 1u : (shadow >> x & 1) * 2u) << 4 * x;
    return row;
}

/* A dot is four pixels wide and high. */
static uint32_t big_row_of(const uint8_t *rows, int y)
{
    uint32_t dots = row_of(rows, y >> 2), pixels = 0;
    for (int x = 0; x < FONT_WIDTH; x++) pixels |= (dots >> x & 1) * 15u << 4 * x;
    return pixels;
}

static void load_big(char letter, volatile uint32_t *tiles)
{
    const uint8_t *rows = font_rows(letter);
    for (int y = 0; y < BIG_SIDE * 8; y++) {
        uint32_t ink = big_row_of(rows, y), shadow = big_row_of(rows, y - 2) << 2;
        volatile uint32_t *row = tiles + y / 8 * BIG_SIDE * 8 + y % 8;
        for (unsigned x = 0; x < BIG_SIDE; x++) row[8 * x] = spread(ink >> 8 * x, shadow >> 8 * x);
    }
}

void letters_load(void)
{
    for (unsigned i = 0; big_ones[i] != '\0'; i++) load_big(big_ones[i], SPRITE_TILES + 8 * (FIRST_BIG + i * BIG_TILES));
    for (int c = FIRST_CHARACTER; c <= LAST_CHARACTER; c++) {
        const uint8_t *rows = font_rows((char)c);
        for (int y = 0; y < 8; y++) {
            uint32_t above = row_of(rows, y - 1);
            SPRITE_TILES[(c - FIRST_CHARACTER) * 8 + y] = spread(row_of(rows, y), above | above << 1 | row_of(rows, y) << 1);
        }
    }
    for (unsigned i = 0; i < LETTERS_COLORS; i++) {
        SPRITE_COLORS[16 * i + 1] = screen_color(colors[i]);
        SPRITE_COLORS[16 * i + 2] = 0;
    }
}

void letters_clear(void)
{
    used = 0;
}

static void add_sprite(int x, int y, uint16_t tile, unsigned size)
{
    uint16_t *sprite = sprites[used];
    if (used == SPRITE_COUNT) return;
    used++;
    sprite[0] = (uint16_t)y;
    sprite[1] = (uint16_t)((unsigned)x | size);
    sprite[2] = tile;
}

int letters_add(int x, int y, uint8_t color, const char *text)
{
    for (; *text != '\0'; text++, x += LETTER_PITCH) {
        if (*text != ' ') add_sprite(x, y, (uint16_t)((SPRITE_TILE + *text - FIRST_CHARACTER) | color << 12), 0);
    }
    return x;
}

void letters_add_big(int x, int y, uint8_t color, char letter)
{
    unsigned number = 0;
    while (big_ones[number] != letter) number++;
    add_sprite(x, y, (uint16_t)((SPRITE_TILE + FIRST_BIG + number * BIG_TILES) | color << 12), SIZE_32);
}

int letters_add_number(int x, int y, uint8_t color, uint32_t number)
{
    char text[11], *at = text + sizeof text - 1;
    *at = '\0';
    do {
        *--at = (char)('0' + number % 10);
        number /= 10;
    } while (number != 0);
    return letters_add(x, y, color, at);
}

void letters_show(void)
{
    for (unsigned i = 0; i < SPRITE_COUNT; i++) {
        SPRITES[ATTRIBUTES * i] = i < used ? sprites[i][0] : HIDDEN;
        SPRITES[ATTRIBUTES * i + 1] = sprites[i][1];
        SPRITES[ATTRIBUTES * i + 2] = sprites[i][2];
    }
}
