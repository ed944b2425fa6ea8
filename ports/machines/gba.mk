# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Game Boy Advance, in libmgba: Thumb code in ROM, hot code as ARM code in IWRAM.
NAME         := Game Boy Advance
PACKAGES     := gcc-arm-none-eabi libnewlib-arm-none-eabi libmgba-dev
TARGET_CC    := arm-none-eabi-gcc
TARGET_FLAGS := -mcpu=arm7tdmi -mthumb -mthumb-interwork
# -marm when linking takes libgcc's ARM code, whose 64-bit multiplication takes a third of the cycles of the Thumb one.
TARGET_LINK  := -marm -nostartfiles -T ports/gba/gba.ld
START        := gba/start gba/console common/newlib
IMAGE        := .gba
MAKE_IMAGE    = arm-none-eabi-objcopy -O binary $< $@
RUNNER       := gba/run
RUNNER_LINK  := -lmgba
RUN           = $(OUT)/gba/run
BENCH_COUNTER := gba
