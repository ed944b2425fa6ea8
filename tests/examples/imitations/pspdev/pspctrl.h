/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Of the PSP's SDK: in pspkernel.h. */
#include "pspkernel.h"
