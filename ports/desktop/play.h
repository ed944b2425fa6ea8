/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The game in the terminal. */
#ifndef DEMO_PLAY_H
#define DEMO_PLAY_H

#include "options.h"

int play_run(const options *o);

#endif
