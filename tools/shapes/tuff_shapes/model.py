# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The nouns that the rooms of this package hand to each other, in the order of the way:
# file -> Drawing (pixels) -> Region -> Outline (lattice) -> Part -> Piece -> header.
#
# Coordinates. Pixels: x right, y down, (0, 0) is the upper left corner of the picture; a pixel is a unit square.
# Lattice: whole steps, x right, y down, step (0, 0) at pixel (0, 0); Lattice.step is one step's length in pixels.
# Rings are closed without repeating the first point. The solid side is the same everywhere: the shoelace sum
# (x0 * y1 - x1 * y0 + ...) of an exterior is positive, that of a hole negative.
from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np


@dataclass(frozen=True)
class Lattice:
    """The grid that both builds hold exactly: units are cut into per_unit steps (a power of two)."""

    scale: float = 1.0    # world units per pixel
    per_unit: int = 64

    @property
    def step(self):
        """Pixels per step."""
        return 1.0 / (self.scale * self.per_unit)

    def nearest(self, pixels):
        """The lattice points (int64 array) nearest to points in pixels."""
        return np.rint(np.asarray(pixels, dtype=np.float64) / self.step).astype(np.int64)

    def pixels(self, steps):
        """Points in pixels (float64 array) of lattice points."""
        return np.asarray(steps, dtype=np.float64) * self.step


@dataclass
class Region:
    """One island of solid ground, in pixels: rings are float64 arrays of shape (n, 2)."""

    exterior: np.ndarray
    holes: list[np.ndarray] = field(default_factory=list)

    @property
    def rings(self):
        return [self.exterior, *self.holes]


@dataclass
class Drawing:
    """One thing to bake: a picture, a frame of a sheet, an object of a map."""

    name: str                # what the file's name is followed by: "" for a whole picture, "3", "door"
    place: str               # for messages: "", "frame 3", "object 17 (door)"
    regions: list[Region]    # islands in reading order of their uppermost, then leftmost point
    size: tuple[float, float]           # of the picture or object, in pixels
    image: object = None     # a PIL image (RGBA) to show under the outline; None where there are no pixels
    exact: bool = False      # corners were set by hand: they are kept unless a tolerance or a budget is given


@dataclass(frozen=True)
class Placement:
    """A drawing put somewhere on a map: its pixel (0, 0) lies at (x, y), in map pixels."""

    drawing: int
    x: float
    y: float


@dataclass
class Source:
    """What one input file holds."""

    drawings: list[Drawing]
    placements: list[Placement] | None = None    # maps only


@dataclass
class Outline:
    """A Region after simplification: rings are lists of (x, y), Python ints, in lattice steps."""

    exterior: list[tuple[int, int]]
    holes: list[list[tuple[int, int]]] = field(default_factory=list)

    @property
    def rings(self):
        return [self.exterior, *self.holes]


@dataclass(frozen=True)
class Part:
    """A convex part; bit i of internal: the edge from vertex i to vertex i + 1 is shared with another part."""

    vertices: tuple[tuple[int, int], ...]
    internal: int = 0


@dataclass(frozen=True)
class Deviation:
    """How far an outline and the picture's border are apart, in pixels, measured both ways."""

    largest: float
    mean: float                       # over the length of the border
    spot: tuple[float, float]         # where the largest is


@dataclass
class Piece:
    """Everything the header says of one tuff_terrain. Lengths are lattice steps but for radii (units / 65536)."""

    name: str
    place: str
    region: Region
    outline: Outline
    parts: list[Part]
    origin: tuple[int, int]           # the piece's position in the picture, lattice steps
    radius_raw: int                   # 1/65536 units; the circle of the same area
    bounding_raw: int                 # 1/65536 units; the smallest that covers every vertex and the circle
    deviation: Deviation
