/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Ground of an AVR program in simavr: text goes out by GPIOR0, main's result by GPIOR2; writing 0xFF to GPIOR1 ends the run. */
#include <avr/io.h>
#include <avr/sleep.h>
#include <stdio.h>
#include <stdlib.h>

#define END 0xFF

static int put(char c, FILE *stream)
{
    (void)stream;
    GPIOR0 = (uint8_t)c;
    return 0;
}

static FILE console = FDEV_SETUP_STREAM(put, NULL, _FDEV_SETUP_WRITE);

/* Before main, after the data. */
__attribute__((naked, used, section(".init8"))) static void open_console(void)
{
    stdout = &console;
}

/* Instead of avr-libc's, which keeps main's result to itself. */
void exit(int code)
{
    GPIOR2 = (uint8_t)code;
    GPIOR1 = END;
    for (;;) sleep_cpu();
}
