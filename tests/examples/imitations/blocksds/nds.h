/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The names of BlocksDS's libnds that a game of tuff meets. */
#ifndef LIBNDS_NDS_H__
#define LIBNDS_NDS_H__

#include <stdbool.h>
#include <stdint.h>

#define ITCM_CODE __attribute__((section(".itcm.text"), long_call))
#define ARM_CODE  __attribute__((target("arm")))
#define ALIGN(m)  __attribute__((aligned(m)))
#define PACKED    __attribute__((packed))
#define BIT(n)    (1u << (n))
#ifndef TRUE
#define TRUE  1
#define FALSE 0
#endif

typedef uint8_t  uint8, u8, byte;
typedef uint16_t uint16, u16;
typedef uint32_t uint32, u32;
typedef int8_t   int8, s8;
typedef int16_t  int16, s16, v16, t16;
typedef int32_t  int32, s32;
typedef int64_t  int64, s64;
typedef float    float32;
typedef double   float64;
typedef void (*VoidFn)(void);

#define inttof32(n)   ((n) * (1 << 12))
#define f32toint(n)   ((n) / (1 << 12))
#define floattof32(n) ((int)((n) * (1 << 12)))

enum { KEY_RIGHT = BIT(4), KEY_LEFT = BIT(5), KEY_UP = BIT(6), KEY_DOWN = BIT(7) };
typedef enum { SpriteMapping_1D_32 } SpriteMapping;
typedef struct OamState OamState;
extern OamState oamMain;

void oamInit(OamState *oam, SpriteMapping mapping, bool extPalette);
void oamUpdate(OamState *oam);
void oamSetXY(OamState *oam, int id, int x, int y);
void swiWaitForVBlank(void);
void scanKeys(void);
uint32_t keysHeld(void);

#endif
