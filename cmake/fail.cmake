# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# cmake -DMESSAGE=text -P fail.cmake: a test that fails with a message.
message(FATAL_ERROR "${MESSAGE}")
