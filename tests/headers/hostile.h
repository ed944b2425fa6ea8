/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The names that console SDKs take as macros; SGDK, libnds, libtonc and PSPSDK each have some of them. */
#define min(a, b) ((a) < (b) ? (a) : (b))
#define max(a, b) ((a) > (b) ? (a) : (b))
#define abs(x)    ((x) < 0 ? -(x) : (x))
#define sgn(x)    ((x) < 0 ? -1 : 1)
#define clamp(x, a, b) min(max(x, a), b)
#define MIN(a, b) ((a) < (b) ? (a) : (b))
#define MAX(a, b) ((a) > (b) ? (a) : (b))
#define ABS(x)    ((x) < 0 ? -(x) : (x))
#define SGN(x)    ((x) < 0 ? -1 : 1)
#define CLAMP(x, a, b) MIN(MAX(x, a), b)
#define SWAP(a, b) swap(a, b)
#define BIT(n)    (1 << (n))
#define INLINE    static inline
#define ALIGN(n)  __attribute__((aligned(n)))
#define PACKED    __attribute__((packed))
#define PI        3.14159265358979323846
#define FIXED     long
#define VECTOR    long *
#define FIX16(x)  ((x) * 64)
#define FIX32(x)  ((x) * 1024)
#define fix16     short
#define fix32     long
#define bool_     int
#define TRUE      1
#define FALSE     0
#define OK        0
#define ERROR     1
#define swap(a, b) do { (a) ^= (b); (b) ^= (a); (a) ^= (b); } while (0)
