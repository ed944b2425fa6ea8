/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   QEMU: instructions, by the plugin ports/qemu/count.c, which looks for these two names. */
#ifndef TUFF_PORTS_COUNT_QEMU_H
#define TUFF_PORTS_COUNT_QEMU_H

#ifdef __cplusplus
extern "C" {
#endif

void mark_begin(void);
void mark_end(void);

#ifdef __cplusplus
}
#endif

static inline void count_begin(void) { mark_begin(); }
static inline void count_end(void)   { mark_end(); }

#endif
