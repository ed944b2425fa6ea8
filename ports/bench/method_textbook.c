/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The textbook's tests. */
#include "textbook_tests.h"

#include "method_body.h"
