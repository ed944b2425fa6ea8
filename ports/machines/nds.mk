# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Nintendo DS, in libretro's DeSmuME: ARM code of the ARM946E-S in main RAM.
NAME         := Nintendo DS
PACKAGES     := gcc-arm-none-eabi libnewlib-arm-none-eabi
TARGET_CC    := arm-none-eabi-gcc
TARGET_FLAGS := -mcpu=arm946e-s -marm
TARGET_LINK  := -nostartfiles -T ports/nds/nds.ld
START        := nds/start nds/console common/newlib
IMAGE        := .nds
MAKE_IMAGE    = arm-none-eabi-objcopy -O binary $< $@
RUNNER       := nds/run
RUNNER_LINK  := -Lbuild/desmume -l:desmume_libretro.so -Wl,-rpath-link,build/desmume
RUN           = env LD_LIBRARY_PATH=build/desmume $(OUT)/nds/run
FETCH        := scripts/get-desmume build/desmume
