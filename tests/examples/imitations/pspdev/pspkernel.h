/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The names of the PSP's SDK that a game of tuff meets; the headers beside this one lead here. */
#ifndef PSPKERNEL_H
#define PSPKERNEL_H

#include <stdint.h>

typedef uint8_t  u8;
typedef uint16_t u16;
typedef uint32_t u32, SceUInt32;
typedef int8_t   s8;
typedef int16_t  s16;
typedef int32_t  s32, SceInt32;
typedef int      SceUID, SceMode, SceBool;
typedef unsigned int SceSize, SceUInt;
typedef unsigned char SceUChar, SceUChar8;
typedef struct { float x, y; } ScePspFVector2;
#ifndef NULL
#define NULL ((void *)0)
#endif

#define PSP_MODULE_INFO(name, attributes, major, minor) \
    const char module_info[] __attribute__((section(".rodata.sceModuleInfo"))) = name
#define PSP_MAIN_THREAD_ATTR(attribute) unsigned int sce_newlib_attribute = (attribute)
enum { THREAD_ATTR_USER = (int)0x80000000, THREAD_ATTR_VFPU = 0x00004000 };

enum PspCtrlMode { PSP_CTRL_MODE_DIGITAL, PSP_CTRL_MODE_ANALOG };
typedef struct SceCtrlData {
    unsigned int TimeStamp;
    unsigned int Buttons;
    unsigned char Lx, Ly, Rsrv[6];
} SceCtrlData;

int sceCtrlSetSamplingCycle(int cycle);
int sceCtrlSetSamplingMode(int mode);
int sceCtrlReadBufferPositive(SceCtrlData *pad_data, int count);
int sceDisplayWaitVblankStart(void);
void pspDebugScreenInit(void);
void pspDebugScreenClear(void);
void pspDebugScreenSetXY(int x, int y);
void pspDebugScreenPrintf(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
