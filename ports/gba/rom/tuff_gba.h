/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   tuff's options on a Game Boy Advance: hot functions are ARM code in the fast memory. gcc gives each function with the attribute hot a
   section of its own, .text.hot.NAME, which gba.ld puts there and --gc-sections drops if nobody calls it; a section named here would be one
   for all hot functions of a file. Given by TUFF_CONFIG_HEADER. */
#ifndef TUFF_GBA_H
#define TUFF_GBA_H

#define TUFF_HOT __attribute__((hot, target("arm")))

#endif
