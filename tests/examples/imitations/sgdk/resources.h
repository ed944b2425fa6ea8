/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What SGDK's rescomp makes of the game's pictures. */
#include <genesis.h>
extern const SpriteDefinition ship_sprite;
