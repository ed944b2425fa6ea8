# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# WebAssembly, in node: a page. wasi-libc of this age has no setjmp, with which Unity leaves a failed test: it goes on instead, and the
# failure counts.
NAME         := WebAssembly (a page)
PACKAGES     := clang-14 lld-14 wasi-libc libclang-rt-14-dev-wasm32 nodejs
TARGET_CC    := clang-14
TARGET_FLAGS := --target=wasm32-wasi -DUNITY_EXCLUDE_SETJMP_H
RUN          := node ports/wasm/run.mjs
