/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The command line. */
#ifndef DEMO_OPTIONS_H
#define DEMO_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

typedef struct options {
    uint32_t seed;
    uint32_t frames;       /* scene steps, 60 to the second; 0: until the player leaves */
    uint32_t from;         /* first step that --ppm writes */
    unsigned fps;          /* pictures a second */
    unsigned width, height;
    uint8_t  show;         /* SCENE_SHOW_... */
    int      build;        /* 0 float, 1 q16: the one shown, and the one whose autopilot steers */
    bool     autopilot, headless, split;
    const char *ppm;       /* prefix of file names; NULL: none */
} options;

/* Fills *o. Prints help or a complaint and leaves the program (status 0 or 2) where the line asks for it. */
void options_read(options *o, int argc, char **argv);

#endif
