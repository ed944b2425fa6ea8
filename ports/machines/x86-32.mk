# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# x86, 32 bits: old desktops. SSE, because the x87's registers have more digits than a float.
NAME         := x86-32
PACKAGES     := lib32gcc-12-dev libc6-dev-i386
TARGET_CC    := gcc
TARGET_FLAGS := -m32 -msse2 -mfpmath=sse
TARGET_LINK  := -static
RUN          :=
