# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Where a piece's position lies in its picture, and the circles about it. Whole numbers and fractions throughout: a radius that is
# rounded down somewhere on the way would not cover its outline.
from fractions import Fraction
from math import ceil, floor, isqrt, log10

import numpy as np

from .faults import ShapeFault
from .model import Piece

MAX_EXTENT = 1024       # units, as TUFF_MAX_EXTENT
MAX_RADIUS = 1024       # units, as TUFF_MAX_RADIUS
RAW_PER_UNIT = 65536    # radii are written in the steps of Q16.16
FLOAT_BITS = 24         # significant bits of a float

# Bytes of ROM where pointers have 32 bits: a vertex with its edge's normal, a tuff_polygon, a tuff_terrain.
VERTEX_BYTES = 16
PART_BYTES = 16
PIECE_BYTES = 24

PI = Fraction(31415926535897932384626433832795028841971, 10 ** 40)


def vertex_count(piece):
    return sum(len(part.vertices) for part in piece.parts)


def array_bytes(piece):
    return VERTEX_BYTES * vertex_count(piece) + PART_BYTES * len(piece.parts)


def rom_bytes(piece):
    return array_bytes(piece) + PIECE_BYTES


# ---- Areas

def ring_moments(ring):
    """Twice the area, and six times the area's first moments."""
    area = x_moment = y_moment = 0
    for (x0, y0), (x1, y1) in zip(ring, ring[1:] + ring[:1]):
        cross = x0 * y1 - x1 * y0
        area += cross
        x_moment += (x0 + x1) * cross
        y_moment += (y0 + y1) * cross
    return area, x_moment, y_moment


def moments(outlines):
    """Holes count for themselves: their rings go the other way round."""
    return [sum(column) for column in zip(*(ring_moments(ring) for outline in outlines for ring in outline.rings))]


def nearest(fraction):
    return floor(fraction + Fraction(1, 2))


def center_of_area(outlines):
    """To the nearest lattice point."""
    area, x_moment, y_moment = moments(outlines)
    return nearest(Fraction(x_moment, 3 * area)), nearest(Fraction(y_moment, 3 * area))


def origin(choice, size, outlines, lattice):
    """The lattice point of a picture that the author chose: "area", "center" or a pivot in pixels."""
    if choice == "area":
        return center_of_area(outlines)
    pixels = (size[0] / 2, size[1] / 2) if choice == "center" else choice
    return tuple(int(step) for step in lattice.nearest(pixels))


# ---- Radii

def to_float_grid(raw, round_up):
    """A radius that both builds hold: at most 24 significant bits."""
    shift = max(0, raw.bit_length() - FLOAT_BITS)
    return raw + (((1 << shift) - 1) if round_up else (1 << shift >> 1)) >> shift << shift


def circle_raw(outline, per_unit):
    """The radius of the circle that has the outline's area: sqrt(area / pi), to nearest."""
    raw_per_step = Fraction(RAW_PER_UNIT, per_unit)
    doubled_square = 4 * Fraction(moments([outline])[0], 2) / PI * raw_per_step ** 2
    return to_float_grid((isqrt(floor(doubled_square)) + 1) >> 1, round_up=False)


def reach_raw(points, per_unit):
    """The least radius that covers the points, as integers reckon it and as the float build does."""
    square = max(x * x + y * y for x, y in points)
    exact = isqrt(square * (RAW_PER_UNIT // per_unit) ** 2 - 1) + 1
    units = np.array(points, dtype=np.float32) / np.float32(per_unit)
    reckoned = np.sqrt(units[:, 0] * units[:, 0] + units[:, 1] * units[:, 1]).max()
    return max(exact, ceil(float(reckoned) * RAW_PER_UNIT))


def relative(points, center):
    return [(x - center[0], y - center[1]) for x, y in points]


def bounding_raw(parts, center, circle, per_unit):
    points = [point for part in parts for point in relative(part.vertices, center)]
    return to_float_grid(max(circle, reach_raw(points, per_unit)) if points else circle, round_up=True)


# ---- Limits

def check_span(region, scale):
    """No position suits a shape that is wider than two extents; seen before anything slow."""
    low, high = np.min(region.exterior, axis=0), np.max(region.exterior, axis=0)
    span = float(max(high - low)) * scale
    if span > 2 * MAX_EXTENT:
        raise ShapeFault(f"the shape is {span:.1f} units across, more than {2 * MAX_EXTENT}: {advice(scale * 2 * MAX_EXTENT / span)}")


def check_extent(outline, center, lattice):
    reach = max(max(abs(x), abs(y)) for x, y in relative(outline.exterior, center)) / lattice.per_unit
    if reach > MAX_EXTENT:
        raise ShapeFault(f"a corner lies {reach:.1f} units from the position, more than {MAX_EXTENT}: "
                         f"{advice(lattice.scale * MAX_EXTENT / reach)}, or another --origin")


def advice(scale):
    """Rounded down to two digits, so that it fits."""
    step = 10.0 ** (floor(log10(scale)) - 1)
    return f"--scale {floor(scale / step) * step:.2g} fits"


# ---- The piece

def fit(name, place, region, outline, parts, center, deviation, lattice):
    """A Piece with its circles. deviation: of what the game collides with, from the region."""
    circle = min(circle_raw(outline, lattice.per_unit), MAX_RADIUS * RAW_PER_UNIT)
    bounding = bounding_raw(parts, center, circle, lattice.per_unit)
    return Piece(name, place, region, outline, parts, center, circle, bounding, deviation)
