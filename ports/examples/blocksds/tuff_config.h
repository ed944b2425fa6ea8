/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   BlocksDS: the hot functions as ARM code in the ARM9's instruction memory. */
#include <nds.h>
#define TUFF_HOT ITCM_CODE ARM_CODE
