/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A run without a display. */
#ifndef DEMO_HEADLESS_H
#define DEMO_HEADLESS_H

#include "options.h"

int headless_run(const options *o);

#endif
