/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The names of the Playdate SDK that a game of tuff meets. */
#ifndef PDEXT_H
#define PDEXT_H

#include <stddef.h>
#include <stdint.h>
#include <stdbool.h>

#define MIN(x, y) (((x) < (y)) ? (x) : (y))
#define MAX(x, y) (((x) > (y)) ? (x) : (y))

typedef uintptr_t LCDColor;
typedef enum { kColorBlack, kColorWhite, kColorClear, kColorXOR } LCDSolidColor;
typedef enum { kButtonLeft = 1, kButtonRight = 2, kButtonUp = 4, kButtonDown = 8, kButtonB = 16, kButtonA = 32 } PDButtons;
typedef enum { kEventInit, kEventInitLua, kEventLock } PDSystemEvent;
typedef int PDCallbackFunction(void *userdata);
typedef struct { int left, right, top, bottom; } LCDRect;
typedef struct { float x, y, width, height; } PDRect;

struct playdate_sys {
    void (*setUpdateCallback)(PDCallbackFunction *update, void *userdata);
    void (*getButtonState)(PDButtons *current, PDButtons *pushed, PDButtons *released);
};

struct playdate_graphics {
    void (*clear)(LCDColor color);
    void (*fillEllipse)(int x, int y, int width, int height, float startAngle, float endAngle, LCDColor color);
};

typedef struct PlaydateAPI {
    const struct playdate_sys *system;
    const struct playdate_graphics *graphics;
} PlaydateAPI;

#endif
