/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The names of libdragon that a game of tuff meets. */
#ifndef __LIBDRAGON_LIBDRAGON_H
#define __LIBDRAGON_LIBDRAGON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MAX(a, b) ({ typeof(a) _a = a; typeof(b) _b = b; _a > _b ? _a : _b; })
#define MIN(a, b) ({ typeof(a) _a = a; typeof(b) _b = b; _a < _b ? _a : _b; })
#define CLAMP(x, min, max) (MIN(MAX((x), (min)), (max)))
#define SWAP(a, b) ({ typeof(a) t = a; a = b; b = t; })

typedef enum { JOYPAD_PORT_1, JOYPAD_PORT_2 } joypad_port_t;
typedef struct { uint16_t buttons; int8_t stick_x, stick_y, cstick_x, cstick_y; uint8_t analog_l, analog_r; } joypad_inputs_t;
typedef struct surface_s { uint16_t flags, width, height, stride; void *buffer; } surface_t;
typedef struct { int width, height; bool interlaced; } resolution_t;
typedef enum { DEPTH_16_BPP, DEPTH_32_BPP } bitdepth_t;
typedef enum { GAMMA_NONE, GAMMA_CORRECT } gamma_t;
typedef enum { FILTERS_DISABLED, FILTERS_RESAMPLE } filter_options_t;
static const resolution_t RESOLUTION_320x240 = { 320, 240, false };

void display_init(resolution_t res, bitdepth_t bit, uint32_t num_buffers, gamma_t gamma, filter_options_t filters);
surface_t *display_get(void);
void display_show(surface_t *surf);
void graphics_fill_screen(surface_t *surf, uint32_t c);
void graphics_draw_box(surface_t *surf, int x, int y, int width, int height, uint32_t color);
void joypad_init(void);
void joypad_poll(void);
joypad_inputs_t joypad_get_inputs(joypad_port_t port);

#endif
