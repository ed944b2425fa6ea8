/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The demo's three ways to run: a game in the terminal, picture files, or a plain summary, also where the output is no terminal. */
#include "headless.h"
#include "pictures.h"
#include "play.h"
#include "terminal.h"

int main(int argc, char **argv)
{
    options o;
    options_read(&o, argc, argv);
    if (o.ppm != NULL) return pictures_run(&o);
    if (o.headless || !terminal_present()) return headless_run(&o);
    return play_run(&o);
}
