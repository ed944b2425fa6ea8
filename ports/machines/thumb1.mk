# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# ARMv4T, Thumb code with software floating point.
NAME := ARMv4T, Thumb
include ports/machines/armv4t.mk
TARGET_FLAGS := -march=armv4t -mthumb
