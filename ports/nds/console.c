/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Text on a Nintendo DS: pixels of the main screen (ports/nds/picture.h), which shows VRAM's bank A as it is. */
#include "../common/console.h"

#include <stdint.h>

#include "picture.h"

#define DISPCNT      (*(volatile uint32_t *)0x04000000)
#define VCOUNT       (*(volatile uint16_t *)0x04000006)
#define VRAMCNT_A    (*(volatile uint8_t *)0x04000240)
#define POWCNT1      (*(volatile uint16_t *)0x04000304)
#define BANK_A       ((volatile uint16_t *)0x06800000)
#define SHOW_BANK_A  0x00020000u
#define FOR_THE_CPU  0x80u
#define MAIN_ON_TOP  0x8003u
#define BLANK_LINE   192u
#define LEAST_UNSEEN (PICTURE_SIZE / 4u)

static uint32_t written;

static void open_screen(void)
{
    POWCNT1 = MAIN_ON_TOP;
    VRAMCNT_A = FOR_THE_CPU;
    DISPCNT = SHOW_BANK_A;
}

static void wait_for_blank(void)
{
    while (VCOUNT != BLANK_LINE) {}
    while (VCOUNT == BLANK_LINE) {}
}

/* Between two waits the whole picture is drawn once: what is not yet drawn is at most half a lap, and nothing is overwritten unseen. */
void console_put(char c)
{
    uint32_t byte = (uint8_t)c;
    uint32_t mark = PICTURE_MARK(written / PICTURE_SIZE);
    if (written == 0) open_screen();
    BANK_A[written % PICTURE_SIZE] = (uint16_t)((byte & 15u) << 1 | byte >> 4 << 6 | mark << 12);
    if (++written % LEAST_UNSEEN == 0) wait_for_blank();
}
