# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Cortex-M3.
NAME   := Cortex-M3
CORE   := -mcpu=cortex-m3
BOARD  := mps2-an385
MEMORY := mps2
include ports/machines/cortex-m0.mk
