# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# 68000, big endian: Mega Drive. No float build: its floating point is not IEEE's single precision (68881), or differs in the last bit.
NAME         ?= 68000 (Mega Drive)
PACKAGES     := gcc-m68k-linux-gnu libc6-dev-m68k-cross qemu-user
TARGET_CC    := m68k-linux-gnu-gcc
TARGET_FLAGS := -m68000
TARGET_LINK  := -static
RUN          := qemu-m68k
BUILDS       := q16
