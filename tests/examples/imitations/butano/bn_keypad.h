/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Of Butano: in bn_core.h. */
#include "bn_core.h"
