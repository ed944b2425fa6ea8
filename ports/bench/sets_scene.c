/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The scene as tables. */
#include "sets.h"

#include "count.h"
#include "scene_data.h"

const struct sets_scene sets_scene = { octagons, hulls, radii, pieces, frames, sizeof frames / sizeof *frames };
