# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
import sys

from .cli import main

sys.exit(main())
