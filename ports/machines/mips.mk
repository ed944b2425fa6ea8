# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# MIPS, big endian: Nintendo 64.
NAME        := MIPS, big endian (Nintendo 64)
PACKAGES    := gcc-mips-linux-gnu libc6-dev-mips-cross qemu-user
TARGET_CC   := mips-linux-gnu-gcc
TARGET_LINK := -static
RUN         := qemu-mips
