# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Cortex-M0 with 16 KB of RAM: Thumby, PicoSystem, Pokitto.
NAME   ?= Cortex-M0 (Thumby, PicoSystem, Pokitto)
CORE   ?= -mcpu=cortex-m0
BOARD  ?= microbit
MEMORY ?= microbit

PACKAGES     := gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm
TARGET_CC    := arm-none-eabi-gcc
TARGET_FLAGS := -mthumb $(CORE)
TARGET_LINK  := --specs=rdimon.specs -nostartfiles -T ports/cortex-m/$(MEMORY).ld
START        := cortex-m/start
RUN          := qemu-system-arm -M $(BOARD) -nographic -monitor none -serial none -semihosting-config enable=on,target=native -kernel
BENCH_SCENE  := $(if $(filter mps2,$(MEMORY)),scene)
