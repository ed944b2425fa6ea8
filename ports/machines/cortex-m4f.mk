# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Cortex-M4 with a floating-point unit.
NAME   := Cortex-M4F
CORE   := -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard
BOARD  := mps2-an386
MEMORY := mps2
include ports/machines/cortex-m0.mk
