/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The registers and memories of a Game Boy Advance that the ROM uses. */
#ifndef GBA_HARDWARE_H
#define GBA_HARDWARE_H

#include <stdint.h>

#define REGISTER(address) (*(volatile uint16_t *)(address))

#define DISPLAY        REGISTER(0x04000000)
#define DISPLAY_BITMAP 0x0004u   /* mode 4: a byte a pixel */
#define DISPLAY_PAGE   0x0010u   /* the second page is shown */
#define DISPLAY_ROWS   0x0040u   /* sprites' tiles in one row of numbers */
#define DISPLAY_LAYERS 0x1400u   /* the bitmap and the sprites */
#define SCAN_LINE      REGISTER(0x04000006)
#define VISIBLE_LINES  160

#define PAGE(n)        ((uint16_t *)(0x06000000 + (n) * 0xA000))
#define PAGE_WIDTH     240
#define PAGE_HEIGHT    160
#define COLORS         ((volatile uint16_t *)0x05000000)
#define SPRITE_COLORS  ((volatile uint16_t *)0x05000200)
#define SPRITE_TILES   ((volatile uint32_t *)0x06014000)   /* number 512 and up; the lower ones are the bitmap's */
#define SPRITE_TILE    512
#define SPRITES        ((volatile uint16_t *)0x07000000)
#define SPRITE_COUNT   128

#define TIMER_0        REGISTER(0x04000100)
#define TIMER_0_MODE   REGISTER(0x04000102)
#define TIMER_1        REGISTER(0x04000104)
#define TIMER_1_MODE   REGISTER(0x04000106)
#define TIMER_2_MODE   REGISTER(0x0400010A)
#define TIMER_ON       0x80u
#define TIMER_BY_1024  0x03u
#define TIMER_CASCADE  0x04u

#define KEYS           REGISTER(0x04000130)   /* 0: held */
enum {
    KEY_A = 1, KEY_B = 2, KEY_SELECT = 4, KEY_START = 8, KEY_RIGHT = 16, KEY_LEFT = 32, KEY_UP = 64, KEY_DOWN = 128,
    KEYS_ALL = 1023
};

/* The 256 KB, which take six cycles a word; what is not marked is in the 32 KB of one cycle. */
#define SLOW_MEMORY    __attribute__((section(".ewram")))

#define FRAME_CYCLES   280896u

/* 0xRRGGBB as the screen takes it. */
static inline uint16_t screen_color(uint32_t rgb)
{
    return (uint16_t)((rgb >> 19 & 31) | (rgb >> 11 & 31) << 5 | (rgb >> 3 & 31) << 10);
}

#endif
