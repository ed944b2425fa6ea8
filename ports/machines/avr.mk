# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# AVR ATmega32U4, in libsimavr: Arduboy. int has 16 bits, double 32; 32 KB of flash, 2.5 KB of RAM.
NAME         := ATmega32U4 (Arduboy)
PACKAGES     := gcc-avr avr-libc binutils-avr libsimavr-dev libelf-dev
TARGET_CC    := avr-gcc
TARGET_FLAGS := -mmcu=atmega32u4 -DTEST_NAMES_OFF
# The whole library, a test and Unity have to fit.
OPTIMIZE     := -Os -mcall-prologues -mrelax -mstrict-X -fno-inline -flto
START        := avr/start
RUNNER       := avr/run
RUNNER_LINK  := -lsimavr -lelf
RUN           = $(OUT)/avr/run
REPLAY       := replay_small replay_beams
SLICES       := 0 1 2 3 4
BENCH_COUNTER := avr
# As many as fit into 32 KB of flash.
BENCH_PAIRS   := 8 8
BENCH_SIZES   := -DBENCH_MAX_VERTICES=8
BENCH_SCENE   :=
