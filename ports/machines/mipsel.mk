# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# MIPS, little endian: PSP, PlayStation.
NAME        := MIPS, little endian (PSP, PlayStation)
PACKAGES    := gcc-mipsel-linux-gnu libc6-dev-mipsel-cross qemu-user
TARGET_CC   := mipsel-linux-gnu-gcc
TARGET_LINK := -static
RUN         := qemu-mipsel
