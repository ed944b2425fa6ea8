# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The pictures of docs/charts, one room each: accuracy.py, scale.py, models.py, machines.py; look.py and tables.py serve them all.
