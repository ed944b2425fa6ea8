# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Cortex-M7 with a floating-point unit: Playdate.
NAME   := Cortex-M7F (Playdate)
CORE   := -mcpu=cortex-m7 -mfpu=fpv5-sp-d16 -mfloat-abi=hard
BOARD  := mps2-an500
MEMORY := mps2
include ports/machines/cortex-m0.mk
