/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   libtonc: the hot functions as ARM code in IWRAM, of which they take 5 KB. */
#include <tonc.h>
#define TUFF_HOT IWRAM_CODE __attribute__((target("arm")))
