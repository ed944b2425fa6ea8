/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Butano: the hot functions as ARM code in IWRAM. The library itself is C, which Butano's header is not. */
#define TUFF_HOT __attribute__((section(".iwram"), long_call, target("arm")))
