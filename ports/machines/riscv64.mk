# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# RISC-V, 64 bits: new handhelds.
NAME        := RISC-V 64
PACKAGES    := gcc-riscv64-linux-gnu libc6-dev-riscv64-cross qemu-user
TARGET_CC   := riscv64-linux-gnu-gcc
TARGET_LINK := -static
RUN         := qemu-riscv64
