/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Runs a Game Boy Advance program in libmgba without a window: run-gba ROM [FRAME:KEYS | FRAME:shot=FILE.ppm | FRAME:stop]... Prints the
   program's text; ends with the code of its line `@@EXIT code`, with 3 at a fatal error, with 124 after 36,000 frames, with 0 at stop.
   KEYS is a hexadecimal mask of the console's keys, held from that frame on. */
#include <mgba/flags.h>

#include <mgba-util/vfs.h>
#include <mgba/core/core.h>
#include <mgba/core/log.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WIDTH      240
#define HEIGHT     160
#define MOST       36000
#define RAN_ON     124
#define RUNNING    (-1)
#define FATAL_CODE 3

static color_t screen[WIDTH * HEIGHT];
static int code = RUNNING;

static void on_log(struct mLogger *logger, int category, enum mLogLevel level, const char *format, va_list values)
{
    char text[512];
    bool debug = strcmp(mLogCategoryId(category), "gba.debug") == 0;
    (void)logger;
    if (!debug && !(level & (mLOG_FATAL | mLOG_ERROR | mLOG_GAME_ERROR))) return;
    vsnprintf(text, sizeof text, format, values);
    if (level == mLOG_FATAL) code = FATAL_CODE;
    if (debug && strncmp(text, "@@EXIT ", 7) == 0) code = atoi(text + 7);
    else fprintf(debug ? stdout : stderr, "%s\n", text);
}

static int shoot(const char *path)
{
    FILE *file = fopen(path, "wb");
    if (!file) return perror(path), 1;
    fprintf(file, "P6\n%d %d\n255\n", WIDTH, HEIGHT);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        for (int shift = 0; shift < 24; shift += 8) fputc((int)(screen[i] >> shift & 255), file);
    }
    return fclose(file);
}

/* What the arguments want done before this frame. */
static int act(struct mCore *core, int frame, int count, char **actions)
{
    for (int i = 0; i < count; i++) {
        char *what;
        if (strtol(actions[i], &what, 10) != frame || *what++ != ':') continue;
        if (strcmp(what, "stop") == 0) code = 0;
        else if (strncmp(what, "shot=", 5) == 0 && shoot(what + 5) != 0) return 2;
        else if (strncmp(what, "shot=", 5) != 0) core->setKeys(core, (uint32_t)strtoul(what, NULL, 16));
    }
    return 0;
}

static struct mCore *load(const char *path)
{
    struct mCore *core = mCoreFind(path);
    if (!core || !core->init(core)) return NULL;
    mCoreInitConfig(core, NULL);
    core->setVideoBuffer(core, screen, WIDTH);
    if (!mCoreLoadFile(core, path)) return NULL;
    core->reset(core);
    return core;
}

int main(int argc, char **argv)
{
    static struct mLogger logger = { .log = on_log };
    mLogSetDefaultLogger(&logger);
    struct mCore *core = argc > 1 ? load(argv[1]) : NULL;
    if (!core) return fprintf(stderr, "usage: run-gba ROM [FRAME:KEYS | FRAME:shot=FILE.ppm | FRAME:stop]...\n"), 2;
    for (int frame = 0; frame < MOST && code == RUNNING; frame++) {
        if (act(core, frame, argc - 2, argv + 2) != 0) return 2;
        if (code == RUNNING) core->runFrame(core);
    }
    core->unloadROM(core);
    core->deinit(core);
    return code == RUNNING ? RAN_ON : code;
}
