/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What is written and painted over the scene: score, shield, beam, the meter; the title. */
#ifndef GBA_HUD_H
#define GBA_HUD_H

#include <stdbool.h>

#include "account.h"
#include "scene.h"

void hud_write(const scene *s, const account *spent, bool autopilot, bool title);

/* The strips above and below the view; once for each page. */
void hud_paint_strips(void);

/* The frame's cycles along the lower border, its full width a frame of the screen: collision, the rest of the step, drawing. */
void hud_paint(const account *spent);

#endif
