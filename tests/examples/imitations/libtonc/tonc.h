/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The names of libtonc that a game of tuff meets: its types, its macros, and what the example calls. Bodies do nothing. */
#ifndef TONC_MAIN
#define TONC_MAIN

#define IWRAM_CODE __attribute__((section(".iwram"), long_call))
#define EWRAM_BSS  __attribute__((section(".sbss")))
#define INLINE     static inline
#define ALIGN(n)   __attribute__((aligned(n)))
#define PACKED     __attribute__((packed))
#define BIT(n)     (1 << (n))
#define MAX(a, b)  (((a) > (b)) ? (a) : (b))
#define MIN(a, b)  (((a) < (b)) ? (a) : (b))
#define ABS(x)     ((x) >= 0 ? (x) : -(x))
#define SGN(x)     ((x) >= 0 ? 1 : -1)

typedef unsigned char  u8, byte, uchar;
typedef unsigned short u16, hword;
typedef unsigned int   u32, word;
typedef signed char    s8;
typedef signed short   s16;
typedef signed int     s32, FIXED;
#ifndef __bool_true_false_are_defined
typedef enum { false, true } bool;
#endif
typedef u8 BOOL;
#define TRUE  1
#define FALSE 0
#ifndef NULL
#define NULL (void *)0
#endif

typedef struct { s32 x, y, z; } VECTOR;
typedef struct { int x, y; } POINT;
typedef struct ALIGN(4) { u16 attr0, attr1, attr2; s16 fill; } OBJ_ATTR;
typedef void (*fnptr)(void);

#define II_VBLANK   0
#define DCNT_MODE0  0
#define DCNT_OBJ    BIT(12)
#define REG_DISPCNT (*(volatile u32 *)0x04000000)
#define oam_mem     ((OBJ_ATTR *)0x07000000)

void irq_init(fnptr handler);
fnptr irq_add(int which, fnptr handler);
void VBlankIntrWait(void);
void key_poll(void);
int key_tri_horz(void);
int key_tri_vert(void);
INLINE FIXED float2fx(float value) { return (FIXED)(value * 256.0f); }
INLINE int fx2int(FIXED value)     { return value / 256; }
INLINE void obj_set_pos(OBJ_ATTR *object, int x, int y)
{
    object->attr1 = (u16)x;
    object->attr0 = (u16)y;
}

#endif
