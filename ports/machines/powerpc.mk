# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# PowerPC, big endian: GameCube, Wii.
NAME        := PowerPC (GameCube, Wii)
PACKAGES    := gcc-powerpc-linux-gnu libc6-dev-powerpc-cross qemu-user
TARGET_CC   := powerpc-linux-gnu-gcc
TARGET_LINK := -static
RUN         := qemu-ppc
