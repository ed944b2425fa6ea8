# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Identifiers of C and C++ from the names of files, objects and frames. A picture may be called floor.png or new.png.
import re
from pathlib import PurePath

from .faults import ShapeFault

# Of C23 and C++23 together, with the alternative tokens such as `and`; and main.
KEYWORDS = frozenset("""
    alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t char32_t char8_t class co_await co_return
    co_yield compl concept const const_cast consteval constexpr constinit continue decltype default delete do double dynamic_cast else
    enum explicit export extern false float for friend goto if inline int long main mutable namespace new noexcept not not_eq nullptr
    operator or or_eq private protected public register reinterpret_cast requires restrict return short signed sizeof static
    static_assert static_cast struct switch template this thread_local throw true try typedef typeid typename typeof typeof_unqual union
    unsigned using virtual void volatile wchar_t while xor xor_eq
""".split())

# Of the headers of C99 and of <unistd.h>; compilers know some of the functions without a header.
LIBRARY = frozenset("""
    abort abs access acos acosh alarm alloca asctime asin asinh assert atan atan2 atanh atexit atof atoi atol atoll bcmp bcopy brk
    bsearch bzero cabs calloc carg cbrt ceil chdir chown clearerr clock close complex conj copysign cos cosh creal csin csqrt ctime
    daemon difftime div dup dup2 environ erf erfc errno exit exp exp2 expm1 fabs fclose fdim feof ferror fflush ffs fgetc fgetpos fgets
    floor fma fmax fmin fmod fopen fork fprintf fputc fputs fread free freopen frexp fscanf fseek fsetpos ftell fwrite gamma getc
    getchar getenv gets gmtime hypot ilogb imag imaginary index int16_t int32_t int64_t int8_t intptr_t isalnum isalpha isatty isblank
    iscntrl isdigit isfinite isgraph isgreater isinf isless islower isnan isnormal isprint ispunct isspace isupper isxdigit j0 j1 jn
    kill labs ldexp ldiv lgamma link llabs lldiv llrint llround localeconv localtime log log10 log1p log2 logb longjmp lrint lround
    lseek malloc mblen memchr memcmp memcpy memmove memset mktime modf nan nearbyint nextafter nice offsetof open pause perror pipe pow
    printf ptrdiff_t putc putchar puts pwrite qsort raise rand random read realloc remainder remove remquo rename rewind rindex rint
    round scalb scanf select setbuf setjmp setlocale setvbuf signal signbit significand sin sinh size_t sleep snprintf sprintf sqrt
    srand sscanf stderr stdin stdout strcat strchr strcmp strcoll strcpy strcspn strerror strftime strlen strncat strncmp strncpy
    strpbrk strrchr strspn strstr strtod strtof strtok strtol strtoul strxfrm swab sync system tan tanh tgamma time time_t tmpfile
    tmpnam tolower toupper trunc truncate uint16_t uint32_t uint64_t uint8_t ungetc unix unlink utime va_arg vfork vprintf wait write y0
    y1 yn
""".split())


def cleaned(text):
    """Lower case, digits and single underscores; empty if nothing is left."""
    return re.sub("[^a-z0-9]+", "_", text.lower()).strip("_")


def base(path, name=None):
    """The name of a header's shapes: as given, or from the file's name."""
    text = cleaned(name if name else PurePath(path).stem)
    if not text:
        raise ShapeFault(f"no identifier can be made of {(name or PurePath(path).stem)!r}: give --name")
    if text[0].isdigit() or text.startswith("tuff"):
        return f"shape_{text}"
    return f"{text}_shape" if text in KEYWORDS or text in LIBRARY else text


class Names:
    """What one header declares. Nothing is declared twice, whatever the objects of a map are called."""

    def __init__(self):
        self.taken = set()

    def claim(self, wish, endings):
        """wish, or wish_2, wish_3 ...: the first for which all of name + ending are free."""
        number, name = 1, wish
        while not self.taken.isdisjoint(name + ending for ending in endings):
            number += 1
            name = f"{wish}_{number}"
        self.taken.update(name + ending for ending in endings)
        return name
