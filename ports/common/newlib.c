/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   newlib's ground on a console without an operating system: text goes to console_put, the exit code as its last line, the heap is what the
   linker script leaves. */
#include "console.h"

#include <errno.h>
#include <sys/stat.h>

static char last = '\n';

int _write(int file, const char *text, int length)
{
    int i;
    (void)file;
    for (i = 0; i < length; ++i) console_put(last = text[i]);
    return length;
}

void _exit(int code)
{
    const char *text = "@@EXIT ";
    if (last != '\n') console_put('\n');
    while (*text != '\0') console_put(*text++);
    console_put((char)('0' + code / 100 % 10));
    console_put((char)('0' + code / 10 % 10));
    console_put((char)('0' + code % 10));
    console_put('\n');
    for (;;) {}
}

void *_sbrk(int more)
{
    static char *top = &end;
    char *before = top;
    if (more > &heap_end - top) {
        errno = ENOMEM;
        return (void *)-1;
    }
    top += more;
    return before;
}

/* There are no files. */
int _close(int file)                          { (void)file; return -1; }
int _isatty(int file)                         { (void)file; return 1; }
int _lseek(int file, int offset, int whence)  { (void)file; (void)offset; (void)whence; return 0; }
int _read(int file, char *text, int length)   { (void)file; (void)text; (void)length; return 0; }
int _kill(int process, int signal)            { (void)process; (void)signal; return -1; }
int _getpid(void)                             { return 1; }
int _fstat(int file, struct stat *status)
{
    (void)file;
    status->st_mode = S_IFCHR;
    return 0;
}

void _init(void) {}
void _fini(void) {}
