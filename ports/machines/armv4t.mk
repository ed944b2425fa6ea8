# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# ARMv4T, ARM code with software floating point: an ARM7 or ARM9 with an operating system.
NAME         ?= ARMv4T
PACKAGES     := gcc-arm-linux-gnueabi libc6-dev-armel-cross qemu-user
TARGET_CC    := arm-linux-gnueabi-gcc
TARGET_FLAGS := -march=armv4t -marm
TARGET_LINK  := -static
RUN          := qemu-arm
