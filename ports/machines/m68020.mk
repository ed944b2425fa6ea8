# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# 68020, big endian: Amiga. No float build, as on the 68000.
NAME := 68020 (Amiga)
include ports/machines/m68000.mk
TARGET_FLAGS := -m68020
