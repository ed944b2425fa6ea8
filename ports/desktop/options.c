/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Reads the command line: long options, each with its value in the next word or after '='. */
#include "options.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../scene/marks.h"

static const char help[] =
    "tuff-demo: an asteroid belt in the terminal, on both builds of tuff\n"
    "\n"
    "  --autopilot        the ship flies itself (any flying key takes over)\n"
    "  --seed N           another belt (default 1)\n"
    "  --frames N         stop after N steps of 1/60 second (default: --headless 3600, --ppm 600)\n"
    "  --build float|q16  the build shown at first (default q16); both always run\n"
    "  --split            both builds side by side, from the same input\n"
    "  --overlay LIST     any of chunks,bounds,normals,contacts or all\n"
    "  --fps N            pictures a second, 1 to 60 (default 30)\n"
    "  --headless         no display: a summary, and last the replay hashes. Each build flies by its own\n"
    "                     autopilot; with --split both get the input of the --build one\n"
    "  --ppm PREFIX       write pictures PREFIX00001.ppm ... instead of showing them\n"
    "  --from N           leave out the pictures before step N\n"
    "  --size WxH         size of those pictures, 80x45 to 4096x4096 (default 640x360)\n"
    "  --help             this\n"
    "\n"
    "Keys: arrows or WASD fly (down brakes), space shoots, B beam, Tab other build, V split view,\n"
    "1 chunks, 2 bounding circles, 3 normals, 4 contacts, O autopilot, P pause, R restart, ? help, Q quit.\n"
    "Candidates: pieces whose bounding circle a body reaches, over all bodies. Tests: their convex parts.\n"
    "Contacts: pushes made in the latest step. us: one whole step of the scene.\n";

static void complain(const char *what, const char *word)
{
    fprintf(stderr, "tuff-demo: %s: %s (--help lists the options)\n", what, word);
    exit(2);
}

static uint32_t number(const char *name, const char *text, unsigned long least, unsigned long most)
{
    char *end;
    errno = 0;
    unsigned long value = strtoul(text, &end, 10);
    if (text[0] < '0' || text[0] > '9' || *end != '\0' || errno != 0 || value < least || value > most) {
        fprintf(stderr, "tuff-demo: %s takes a number from %lu to %lu, not '%s'\n", name, least, most, text);
        exit(2);
    }
    return (uint32_t)value;
}

static void read_size(options *o, const char *text)
{
    unsigned width, height;
    char extra;
    if (sscanf(text, "%4ux%4u%c", &width, &height, &extra) != 2) complain("--size takes WxH", text);
    if (width < 80 || width > 4096 || height < 45 || height > 4096) complain("--size is 80x45 to 4096x4096", text);
    o->width = width;
    o->height = height;
}

static const struct { const char *name; uint8_t bits; } overlays[] = {
    {"chunks", SCENE_SHOW_CHUNKS}, {"bounds", SCENE_SHOW_BOUNDS}, {"normals", SCENE_SHOW_NORMALS}, {"contacts", SCENE_SHOW_CONTACTS},
    {"all", SCENE_SHOW_CHUNKS | SCENE_SHOW_BOUNDS | SCENE_SHOW_NORMALS | SCENE_SHOW_CONTACTS}
};

static uint8_t overlay_bits(const char *word, size_t length)
{
    for (size_t i = 0; i < sizeof overlays / sizeof overlays[0]; i++) {
        if (strlen(overlays[i].name) == length && strncmp(word, overlays[i].name, length) == 0) return overlays[i].bits;
    }
    complain("no such overlay (chunks, bounds, normals, contacts, all)", word);
    return 0;
}

static void read_overlays(options *o, const char *list)
{
    for (;;) {
        size_t length = strcspn(list, ",");
        o->show |= overlay_bits(list, length);
        if (list[length] == '\0') return;
        list += length + 1;
    }
}

static void read_build(options *o, const char *name)
{
    if (strcmp(name, "float") != 0 && strcmp(name, "q16") != 0) complain("--build is float or q16", name);
    o->build = strcmp(name, "q16") == 0;
}

/* Options without a value. */
static bool read_switch(options *o, const char *word)
{
    if (strcmp(word, "--autopilot") == 0) o->autopilot = true;
    else if (strcmp(word, "--headless") == 0) o->headless = true;
    else if (strcmp(word, "--split") == 0) o->split = true;
    else return false;
    return true;
}

static void read_valued(options *o, const char *name, const char *value)
{
    if (strcmp(name, "--seed") == 0) o->seed = number(name, value, 0, 4294967295ul);
    else if (strcmp(name, "--frames") == 0) o->frames = number(name, value, 1, 10000000);
    else if (strcmp(name, "--from") == 0) o->from = number(name, value, 0, 10000000);
    else if (strcmp(name, "--fps") == 0) o->fps = number(name, value, 1, 60);
    else if (strcmp(name, "--size") == 0) read_size(o, value);
    else if (strcmp(name, "--overlay") == 0) read_overlays(o, value);
    else if (strcmp(name, "--build") == 0) read_build(o, value);
    else o->ppm = value;
}

static const char *const valued[] = {"--seed", "--frames", "--from", "--fps", "--size", "--overlay", "--build", "--ppm"};

/* The name of an option that takes a value, and the value if it is in the same word. */
static const char *find_valued(const char *word, const char **value)
{
    size_t length = strcspn(word, "=");
    for (size_t i = 0; i < sizeof valued / sizeof valued[0]; i++) {
        if (strlen(valued[i]) != length || strncmp(word, valued[i], length) != 0) continue;
        *value = word[length] == '=' ? word + length + 1 : NULL;
        return valued[i];
    }
    return NULL;
}

static void check(const options *o)
{
    if (o->headless && o->ppm != NULL) complain("choose one", "--headless or --ppm");
    if (o->from != 0 && o->ppm == NULL) complain("only with --ppm", "--from");
    if (o->frames != 0 && o->from > o->frames) complain("beyond the last frame", "--from");
}

void options_read(options *o, int argc, char **argv)
{
    memset(o, 0, sizeof *o);
    o->seed = 1;
    o->fps = 30;
    o->width = 640;
    o->height = 360;
    o->build = 1;
    for (int i = 1; i < argc; i++) {
        const char *value, *name;
        if (strcmp(argv[i], "--help") == 0) {
            fputs(help, stdout);
            exit(0);
        }
        if (read_switch(o, argv[i])) continue;
        name = find_valued(argv[i], &value);
        if (name == NULL) complain("unknown option", argv[i]);
        if (value == NULL && i + 1 == argc) complain("a value is missing", name);
        read_valued(o, name, value != NULL ? value : argv[++i]);
    }
    check(o);
}
