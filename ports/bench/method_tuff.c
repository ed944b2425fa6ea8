/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   tuff's narrow phase. */
#include "tuff_tests.h"

#include "method_body.h"
