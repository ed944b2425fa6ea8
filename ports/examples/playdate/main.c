/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Playdate: the float build; a float is a tuff_real. */
#include "pd_api.h"
#include "belt.h"

static float thrust_of(PDButtons held, PDButtons plus, PDButtons minus)
{
    return ((held & plus) ? 0.0625f : 0.0f) - ((held & minus) ? 0.0625f : 0.0f);
}

static int update(void *userdata)
{
    PlaydateAPI *pd = (PlaydateAPI *)userdata;
    PDButtons held;
    pd->system->getButtonState(&held, NULL, NULL);
    fly(thrust_of(held, kButtonRight, kButtonLeft), thrust_of(held, kButtonDown, kButtonUp));
    pd->graphics->clear(kColorWhite);
    pd->graphics->fillEllipse((int)ship.position.x - 6, (int)ship.position.y - 6, 12, 12, 0.0f, 0.0f, kColorBlack);
    return 1;
}

int eventHandler(PlaydateAPI *pd, PDSystemEvent event, uint32_t arg);

int eventHandler(PlaydateAPI *pd, PDSystemEvent event, uint32_t arg)
{
    (void)arg;
    if (event == kEventInit) pd->system->setUpdateCallback(update, pd);
    return 0;
}
