# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Borders for the tests of simplification: traced blobs, thin and small shapes, and what must hold of every outline.
import io

import blobs
import numpy as np
import shapely
from tuff_shapes import measure, trace
from tuff_shapes.faults import Journal


def regions(mask, specks=1):
    return trace.regions(mask, specks, Journal("mask", io.StringIO()), "")


def largest(mask):
    return max(regions(mask), key=lambda region: len(region.exterior))


def blob(seed, size):
    return largest(blobs.blob(seed, size))


def small(seed):
    """A lump of a few pixels: its border is about 24 long."""
    random = np.random.Generator(np.random.PCG64(seed))
    return largest(blobs.star(random, 11, harmonics=3, roughness=0.6))


def rows(*text):
    """A mask from rows of '#' and '.', with an empty rim."""
    return np.pad(np.array([[letter == "#" for letter in row] for row in text]), 1)


def thin():
    """{name: mask} of shapes that are thinner than a tolerance of one pixel."""
    line, comb, frame = np.zeros((3, 60), bool), np.zeros((24, 60), bool), np.zeros((40, 40), bool)
    line[1, 2:-2] = True
    comb[18:22, 2:-2] = comb[2:18, 2:-2:2] = True
    frame[4:-4, 4:-4] = True
    frame[5:-5, 5:-5] = False
    steps = np.eye(40, dtype=bool) | np.eye(40, k=1, dtype=bool)
    ring = blobs.disc(64, 32, 32, 28) & ~blobs.disc(64, 32, 32, 26.7)
    needle = blobs.disc(64, 20, 32, 12) | blobs.spike(np.random.Generator(np.random.PCG64(4)), 64)
    return {"line": line, "comb": comb, "frame": frame, "steps": np.pad(steps, 1), "ring": ring, "needle": needle,
            "spiral": spiral(41), "pixel": rows("#"), "corner": rows("##", "#.")}


def spiral(size):
    mask = np.zeros((size, size), bool)
    low, high = 1, size - 2
    while low < high:
        mask[low, low - (low > 1) * 2:high + 1] = mask[low:high + 1, high] = True
        mask[high, low:high + 1] = mask[low + 2:high + 1, low] = True
        low, high = low + 2, high - 2
    return mask


def verify(region, outline, tolerance, lattice):
    """The promises of simplify: within the tolerance, simple, apart, nested, turned and counted right."""
    assert len(outline.holes) == len(region.holes)
    rings = [shapely.LinearRing(lattice.pixels(ring)) for ring in outline.rings]
    for ring, steps in zip(rings, outline.rings):
        assert len(steps) >= 3 and all(isinstance(step, int) for point in steps for step in point)
        assert ring.is_simple and ring.is_ccw == (ring is rings[0])
        assert not any(on_one_line(steps[i - 2], steps[i - 1], steps[i]) for i in range(len(steps)))
    assert all(one.distance(other) > 0 for i, one in enumerate(rings) for other in rings[:i])
    assert shapely.Polygon(rings[0], rings[1:]).is_valid
    assert measure.deviation(region, outline, lattice).largest <= tolerance
    for ring, border in zip(rings, region.rings):
        assert shapely.hausdorff_distance(ring, shapely.LinearRing(border), densify=0.02) <= tolerance + 1e-9


def on_one_line(a, b, c):
    return (b[0] - a[0]) * (c[1] - b[1]) == (b[1] - a[1]) * (c[0] - b[0])
