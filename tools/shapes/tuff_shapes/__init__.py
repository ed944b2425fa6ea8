# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# From picture to terrain: see cli.py for the command, pipeline.py for the way a drawing goes.
"""Traces pictures into collision outlines for tuff."""
