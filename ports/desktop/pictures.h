/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A run into picture files. */
#ifndef DEMO_PICTURES_H
#define DEMO_PICTURES_H

#include "options.h"

int pictures_run(const options *o);

#endif
