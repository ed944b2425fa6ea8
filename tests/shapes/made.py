# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Options, drawings and headers without pictures, for tests of the later rooms.
import io
from types import SimpleNamespace

import numpy as np
from tuff_shapes import header, pipeline
from tuff_shapes.faults import Journal
from tuff_shapes.model import Drawing, Region, Source


def options(**changes):
    defaults = {"alpha": 128, "key": None, "grid": None, "frame": None, "specks": 16, "tolerance": None, "vertices": None, "model": "parts",
                "scale": 1.0, "per_unit": 64, "y_up": False, "origin": "area", "name": "rock", "include": "<tuff/tuff.h>", "preview": None}
    return SimpleNamespace(**(defaults | changes))


def region(exterior, *holes):
    return Region(np.array(exterior, dtype=float), [np.array(hole, dtype=float) for hole in holes])


def square(x, y, side):
    return region([(x, y), (x + side, y), (x + side, y + side), (x, y + side)])


def drawing(*regions, name="", place="", size=(64, 64), exact=True):
    return Drawing(name, place, list(regions), size, exact=exact)


def bake(one, chosen):
    return pipeline.bake(one, chosen, Journal("rock.png", io.StringIO()))


def header_of(drawings, chosen, placements=None, command="python -m tuff_shapes rock.png"):
    """The text, and the pieces of each drawing."""
    source = Source(drawings, placements)
    pieces = [bake(one, chosen) for one in drawings]
    return header.text(pieces, source, chosen, command), pieces
