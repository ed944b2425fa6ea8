/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What ports/common/newlib.c asks of a console without an operating system. */

/* One character of the program's text. The last line is `@@EXIT code`. */
void console_put(char c);

/* From the linker script: newlib's heap. */
extern char end, heap_end;
