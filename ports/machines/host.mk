# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The machine that the others are built on.
NAME      := the host
TARGET_CC := $(CC)
RUN       :=
REPLAY    := replay replay_small replay_beams
