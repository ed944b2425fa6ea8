/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   PSP with pspdev: the float build; the stick gives -128 .. 127. */
#include <pspkernel.h>
#include <pspdebug.h>
#include <pspdisplay.h>
#include <pspctrl.h>
#include "belt.h"

PSP_MODULE_INFO("belt", 0, 1, 0);
PSP_MAIN_THREAD_ATTR(THREAD_ATTR_USER | THREAD_ATTR_VFPU);

int main(void)
{
    SceCtrlData pad;
    pspDebugScreenInit();
    sceCtrlSetSamplingCycle(0);
    sceCtrlSetSamplingMode(PSP_CTRL_MODE_ANALOG);
    while (1) {
        sceCtrlReadBufferPositive(&pad, 1);
        fly((float)(pad.Lx - 128) / 2048.0f, (float)(pad.Ly - 128) / 2048.0f);
        sceDisplayWaitVblankStart();
        pspDebugScreenClear();
        pspDebugScreenSetXY((int)ship.position.x / 7, (int)ship.position.y / 8);
        pspDebugScreenPrintf("A");
    }
    return 0;
}
