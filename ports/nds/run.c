/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Runs a Nintendo DS program in libretro's DeSmuME without a window: run PROGRAM.nds. Prints the text in its picture (picture.h); ends
   with the code of its line `@@EXIT code`, with 124 after 12,000 frames. The core's package has no header of libretro's interface: here is
   what this core asks for. */
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "picture.h"

#define MOST    12000
#define RAN_ON  124
#define RUNNING (-1)

/* libretro's RETRO_ENVIRONMENT_... and RETRO_PIXEL_FORMAT_RGB565. */
#define SET_PIXEL_FORMAT 10u
#define GET_VARIABLE     15u
#define RGB565           2u

/* Places in the header. */
#define HEADER     0x200
#define LOGO       0xC0
#define LOGO_SUM   0x15C
#define HEADER_SUM 0x15E

struct variable { const char *key, *value; };
struct game     { const char *path; const void *data; size_t size; const char *meta; };

void retro_set_environment(bool (*)(unsigned, void *));
void retro_set_video_refresh(void (*)(const void *, unsigned, unsigned, size_t));
void retro_set_audio_sample(void (*)(int16_t, int16_t));
void retro_set_audio_sample_batch(size_t (*)(const int16_t *, size_t));
void retro_set_input_poll(void (*)(void));
void retro_set_input_state(int16_t (*)(unsigned, unsigned, unsigned, unsigned));
void retro_init(void);
void retro_deinit(void);
bool retro_load_game(const struct game *);
void retro_unload_game(void);
void retro_run(void);

static FILE *text;
static int code = RUNNING;
static char line[256];
static unsigned length;
static unsigned long shown;

/* The interpreter has all of the ARM9's instructions; the recompiler, twice as fast, has not. */
static bool environment(unsigned command, void *data)
{
    if (command == SET_PIXEL_FORMAT) return *(unsigned *)data == RGB565;
    if (command == GET_VARIABLE && strcmp(((struct variable *)data)->key, "desmume_cpu_mode") == 0) {
        ((struct variable *)data)->value = "interpreter";
        return true;
    }
    return false;
}

static void end_line(void)
{
    line[length] = '\0';
    if (strncmp(line, "@@EXIT ", 7) == 0) code = atoi(line + 7);
    else fprintf(text, "%s\n", line);
    length = 0;
}

static void take(char c)
{
    if (c != '\n') line[length++] = c;
    if (c == '\n' || length == sizeof line - 1) end_line();
}

static void show(const void *picture, unsigned width, unsigned height, size_t pitch)
{
    if (!picture || width != PICTURE_WIDTH || height < PICTURE_HEIGHT) return;
    for (; code == RUNNING; shown++) {
        unsigned long place = shown % PICTURE_SIZE;
        uint16_t pixel = ((const uint16_t *)((const char *)picture + place / PICTURE_WIDTH * pitch))[place % PICTURE_WIDTH];
        if ((pixel >> 2 & 7u) != PICTURE_MARK(shown / PICTURE_SIZE)) return;
        take((char)((pixel >> 7 & 15) << 4 | pixel >> 12));
    }
}

static void play_one(int16_t left, int16_t right)
{
    (void)left;
    (void)right;
}

static size_t play(const int16_t *samples, size_t count)
{
    (void)samples;
    return count;
}

static void look_at_keys(void) {}

static int16_t key(unsigned port, unsigned device, unsigned index, unsigned which)
{
    (void)port;
    (void)device;
    (void)index;
    (void)which;
    return 0;
}

/* CRC-16 as in MODBUS. */
static unsigned checksum(const unsigned char *bytes, size_t count)
{
    unsigned sum = 0xFFFF;
    for (size_t i = 0; i < count; i++) {
        sum ^= bytes[i];
        for (int bit = 0; bit < 8; bit++) sum = sum >> 1 ^ (sum & 1 ? 0xA001 : 0);
    }
    return sum;
}

static bool has_sum(const unsigned char *header, size_t from, size_t place)
{
    unsigned sum = checksum(header + from, place - from);
    bool same = sum == (unsigned)(header[place] | header[place + 1] << 8);
    if (!same) fprintf(stderr, "the checksum at 0x%X of the header should be 0x%04X\n", (unsigned)place, sum);
    return same;
}

static bool header_holds(const char *path)
{
    unsigned char header[HEADER];
    FILE *file = fopen(path, "rb");
    if (!file) return perror(path), false;
    bool whole = fread(header, 1, HEADER, file) == HEADER;
    fclose(file);
    return whole && has_sum(header, LOGO, LOGO_SUM) && has_sum(header, 0, HEADER_SUM);
}

static bool load(const char *path)
{
    struct game game = { path, NULL, 0, NULL };
    retro_set_environment(environment);
    retro_set_video_refresh(show);
    retro_set_audio_sample(play_one);
    retro_set_audio_sample_batch(play);
    retro_set_input_poll(look_at_keys);
    retro_set_input_state(key);
    retro_init();
    return retro_load_game(&game);
}

/* The core chats on the standard output, which is the program's. */
static bool silence_core(void)
{
    text = fdopen(dup(STDOUT_FILENO), "w");
    return text && freopen("/dev/null", "w", stdout);
}

int main(int argc, char **argv)
{
    if (argc != 2) return fprintf(stderr, "usage: run PROGRAM.nds\n"), 2;
    if (!header_holds(argv[1]) || !silence_core()) return 2;
    if (!load(argv[1])) return fprintf(stderr, "DeSmuME does not load %s\n", argv[1]), 2;
    for (int frame = 0; frame < MOST && code == RUNNING; frame++) retro_run();
    retro_unload_game();
    retro_deinit();
    return code == RUNNING ? RAN_ON : code;
}
