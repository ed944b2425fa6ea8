/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Text on a Game Boy Advance: mGBA's debug console, line by line. */
#include "../common/console.h"

#include <stdint.h>

#define CONSOLE_TEXT   ((volatile char *)0x04FFF600)
#define CONSOLE_SEND   (*(volatile uint16_t *)0x04FFF700)
#define CONSOLE_ENABLE (*(volatile uint16_t *)0x04FFF780)
#define LEVEL_INFO     0x103
#define LINE           255

static unsigned used;

static void send(void)
{
    CONSOLE_TEXT[used] = '\0';
    CONSOLE_ENABLE = 0xC0DE;
    CONSOLE_SEND = LEVEL_INFO;
    used = 0;
}

void console_put(char c)
{
    if (c != '\n') CONSOLE_TEXT[used++] = c;
    if (c == '\n' || used == LINE) send();
}
