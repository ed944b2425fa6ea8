# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The outlines whose models are measured, 60 to 80 pixels across, in three groups: the demo's rocks, and pictures drawn here.
import io

import numpy as np
from PIL import Image

from tuff_shapes import pictures
from tuff_shapes.faults import Journal
from tuff_shapes.options import parser

SIDE = 88          # pixels of a drawn picture
GROUPS = ("round", "cornered", "concave")

# Lobes of round rocks: (how often round, how high in pixels, where in radians).
ROUND = {
    "ball": [],
    "egg": [(2, 3.0, 0.4)],
    "boulder": [(2, 1.5, 1.0), (3, 1.2, 0.2), (5, 0.6, 2.0)],
    "potato": [(2, 4.0, 2.1), (3, 1.0, 1.0)],
}
RADIUS = 34        # pixels

# Circles taken out of round rocks: (x, y, radius) from the middle.
CRATERS = {"crater": [(30, -14, 17)], "bites": [(-36, 8, 14), (20, 34, 12), (18, -36, 15)]}
TEETH = (11, 28, 37)    # of a jagged rock: how many, inner and outer radius


def plane():
    """The middles of the pixels, from the picture's middle: x right, y down."""
    steps = np.arange(SIDE) + 0.5 - SIDE / 2
    return np.meshgrid(steps, steps)


def lobed(lobes):
    x, y = plane()
    turn = np.arctan2(y, x)
    return np.hypot(x, y) <= RADIUS + sum(height * np.cos(times * turn + start) for times, height, start in lobes)


def cratered(craters):
    x, y = plane()
    return lobed(ROUND["boulder"]) & np.all([np.hypot(x - cx, y - cy) > radius for cx, cy, radius in craters], axis=0)


def jagged():
    """Straight flanks between points at the inner and the outer radius in turn."""
    count, inner, outer = TEETH
    x, y = plane()
    turn = np.arctan2(y, x) / (2 * np.pi) * count
    flank = np.abs(turn - np.rint(turn)) * 2
    return np.hypot(x, y) <= outer + (inner - outer) * flank


def sheet(path, frames):
    """The drawings of a strip of pictures, as the tool cuts it."""
    options = parser().parse_args([str(path), "--strip", str(frames)])
    return pictures.read(str(path), options, Journal(str(path), io.StringIO())).drawings


def saved(mask, path):
    """A picture like any other: drawn, saved, read again."""
    pixels = np.zeros((SIDE, SIDE, 4), dtype=np.uint8)
    pixels[mask] = (154, 141, 132, 255)
    Image.fromarray(pixels).save(path)
    return sheet(path, 1)[0]


def drawn(folder):
    masks = {f"round {name}": lobed(lobes) for name, lobes in ROUND.items()}
    masks |= {f"concave {name}": cratered(craters) for name, craters in CRATERS.items()}
    masks["concave teeth"] = jagged()
    return {name: saved(mask, folder / f"outline-{name.replace(' ', '-')}.png") for name, mask in masks.items()}


def all_outlines(rocks, folder):
    """{"group name": Drawing} of one island each. rocks: where the demo's pictures are; folder: where those drawn here go."""
    found = {f"cornered rock {i}": drawing for i, drawing in enumerate(sheet(rocks / "large.png", 5))}
    found |= {f"concave {name}": drawing for name, drawing in zip(("ell", "star", "crescent"), sheet(rocks / "concave.png", 3))}
    found |= drawn(folder)
    return dict(sorted(found.items(), key=lambda item: GROUPS.index(item[0].split()[0])))
