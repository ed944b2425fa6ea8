/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The terminal: taken over for the game, given back however the program ends, and asked for keys. */
#ifndef DEMO_TERMINAL_H
#define DEMO_TERMINAL_H

#include <stdbool.h>
#include <stddef.h>

/* Keys beyond the letters. */
enum { KEY_NONE = 0, KEY_UP = 256, KEY_DOWN, KEY_LEFT, KEY_RIGHT };

/* Is there a terminal to draw on? */
bool terminal_present(void);

/* Takes the terminal; it is restored by terminal_close, and before any signal ends the program. False: it has no keys. */
bool terminal_open(void);
void terminal_close(void);

void terminal_size(unsigned *columns, unsigned *rows);

/* The next key pressed, KEY_NONE: none waits. */
int terminal_key(void);

/* False: the terminal is gone. */
bool terminal_write(const char *bytes, size_t count);

/* True once after the program was stopped and went on: the screen must be drawn afresh. */
bool terminal_resumed(void);

#endif
