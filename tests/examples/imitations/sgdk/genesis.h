/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The names of SGDK that a game of tuff meets: its own integers as macros, its own bool, its own NULL, and min, max, abs. */
#ifndef _GENESIS_H_
#define _GENESIS_H_

#ifndef FALSE
#define FALSE 0
#endif
#ifndef TRUE
#define TRUE 1
#endif
#ifndef NULL
#define NULL 0
#endif

typedef char           s8;
typedef short          s16, fix16, f16, fastfix16;
typedef long           s32, fix32, f32, fastfix32;
typedef unsigned char  u8;
typedef unsigned short u16;
typedef unsigned long  u32;
typedef u8 bool;
#ifndef false
#define false FALSE
#endif
#ifndef true
#define true TRUE
#endif
#if !defined(uint8_t) && !defined(__int8_t_defined)
#define uint8_t  u8
#define int8_t   s8
#endif
#if !defined(uint16_t) && !defined(__int16_t_defined)
#define uint16_t u16
#define int16_t  s16
#endif
#if !defined(uint32_t) && !defined(__int32_t_defined)
#define uint32_t u32
#define int32_t  s32
#endif
#if !defined(size_t)
#define size_t   u32
#endif

#define min(X, Y) (((X) < (Y)) ? (X) : (Y))
#define max(X, Y) (((X) > (Y)) ? (X) : (Y))
#define abs(X)    (((X) < 0) ? -(X) : (X))
#define clamp(X, L, H) (min(max((X), (L)), (H)))
#define PI 3.14159265358979323846
#define FASTCALL
#define FIX16(value)     ((fix16)((value) * (1 << 6)))
#define FIX32(value)     ((fix32)((value) * (1 << 10)))
#define F32_toInt(value) ((s16)((value) >> 10))

#define JOY_1        0x0000
#define BUTTON_UP    0x0001
#define BUTTON_DOWN  0x0002
#define BUTTON_LEFT  0x0004
#define BUTTON_RIGHT 0x0008
#define PAL0         0
#define TILE_ATTR(pal, prio, flipV, flipH) (((flipH) << 11) | ((flipV) << 12) | ((pal) << 13) | ((prio) << 15))

typedef struct { s16 x, y; u16 w, h; } Box;
typedef struct { s16 x, y; u16 ray; } Circle;
typedef struct { fix32 x, y; } V2f32;
typedef struct Sprite Sprite;
typedef struct SpriteDefinition SpriteDefinition;

void SPR_init(void);
Sprite *SPR_addSprite(const SpriteDefinition *spriteDef, s16 x, s16 y, u16 attribut);
void SPR_setPosition(Sprite *sprite, s16 x, s16 y);
void SPR_update(void);
u16 JOY_readJoypad(u16 joy);
bool SYS_doVBlankProcess(void);

#endif
