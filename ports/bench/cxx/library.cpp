/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The rest of what Box2D needs of the C++ library: nothing is ever deleted. */
#include <stdlib.h>

void operator delete(void *) noexcept              { abort(); }
void operator delete(void *, unsigned) noexcept    { abort(); }
extern "C" void __cxa_pure_virtual()               { abort(); }
