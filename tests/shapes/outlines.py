# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Outlines for the tests of the cut into convex parts: set shapes, and random ones from a number; and the repetition of a
# random case by TUFF_TEST_SEED. TUFF_TEST_SCALE: percent of the random cases that are run.
import os
import random
import sys
from contextlib import contextmanager
from math import cos, pi, sin

import shapely
from shapely.geometry.polygon import orient
from tuff_shapes.model import Outline


def seeds(count):
    """The numbers of the random cases."""
    if "TUFF_TEST_SEED" in os.environ:
        return [int(os.environ["TUFF_TEST_SEED"])]
    return range(1, 1 + max(1, count * int(os.environ.get("TUFF_TEST_SCALE", "100")) // 100))


@contextmanager
def repeatable(test, seed):
    """A failure inside says how to see it again."""
    try:
        yield
    except BaseException:
        print(f"repeat: TUFF_TEST_SEED={seed} PYTHONPATH=tools/shapes python -m pytest -c tools/shapes/pyproject.toml "
              f"--rootdir=. {test}", file=sys.stderr)
        raise


def outline(exterior, *holes):
    """Whichever way round the rings are given."""
    return of(shapely.Polygon(exterior, holes))


def of(polygon):
    polygon = orient(polygon)
    return Outline(whole(polygon.exterior), [whole(ring) for ring in polygon.interiors])


def whole(ring):
    return [(int(x), int(y)) for x, y in ring.coords[:-1]]


def regular(count, radius, x=0, y=0):
    return [(x + round(radius * cos(2 * pi * i / count)), y + round(radius * sin(2 * pi * i / count))) for i in range(count)]


def star(points, outer, inner):
    radii = (outer, inner)
    turns = [pi * i / points for i in range(2 * points)]
    return outline([(round(radii[i % 2] * cos(turn)), round(radii[i % 2] * sin(turn))) for i, turn in enumerate(turns)])


def comb(teeth, pitch=128, tall=512, back=128):
    corners = [(0, 0), (pitch * (2 * teeth - 1), 0)]
    for tooth in reversed(range(teeth)):
        left = 2 * tooth * pitch
        corners += [(left + pitch, back + tall), (left, back + tall)]
        corners += [(left, back), (left - pitch, back)] if tooth else []
    return outline(corners)


def spiral(turns, pitch=256):
    """A square band that winds inwards."""
    way, x, y = [(0, 0)], 0, 0
    for i in range(4 * turns):
        reach = 2 * pitch * (2 * turns - i // 2)
        x, y = x + reach * (1, 0, -1, 0)[i % 4], y + reach * (0, 1, 0, -1)[i % 4]
        way.append((x, y))
    return of(shapely.LineString(way).buffer(pitch / 2, cap_style="flat", join_style="mitre"))


def boxes(*corners, unit=256):
    """The union of boxes (left, top, right, bottom): letters."""
    return of(shapely.unary_union([shapely.box(*(unit * edge for edge in box)) for box in corners]).normalize())


def blob(seed, count, radius=64 * 24, roughness=0.12):
    """A rock: a circle with a few waves round it, and a random step in or out at each vertex."""
    source = random.Random(seed)
    waves = [(k, source.uniform(-0.3, 0.3) / k ** 0.5, source.uniform(0, 2 * pi)) for k in range(2, 8)]
    corners = []
    for i in range(count):
        angle = 2 * pi * i / count
        reach = max(0.2, 1 + sum(size * sin(k * angle + phase) for k, size, phase in waves) + source.uniform(-roughness, roughness))
        corners.append((round(radius * reach * cos(angle)), round(radius * reach * sin(angle))))
    return outline(corners)


def tangle(seed, count, size):
    """A closed way through random points of a grid, untangled: crossing edges are swapped until none is left (2-opt).
    On a small grid many corners are in line."""
    source = random.Random(seed)
    while True:
        points = [(source.randrange(size), source.randrange(size)) for _ in range(count)]
        if len(set(points)) == count and (ring := untangled(points)) and strict(shapely.Polygon(ring)):
            return outline(ring)


def untangled(points):
    ring = list(points)
    for _ in range(200):
        crossing = next(((i, k) for k in range(2, len(ring)) for i in range(k - 1) if (i, k) != (0, len(ring) - 1)
                         and shapely.LineString(ring[i:i + 2]).intersects(shapely.LineString([ring[k], ring[(k + 1) % len(ring)]]))), None)
        if crossing is None:
            return ring
        i, k = crossing
        ring[i + 1:k + 1] = reversed(ring[i + 1:k + 1])
    return None


def with_holes(seed, corners, holes, hole_corners, size):
    """A tangle with smaller tangles cut out of it; or a square, where they do not fit into the tangle."""
    source = random.Random(seed)
    outer, inner = tangle(source.randrange(1 << 30), corners, size).exterior, []
    while len(inner) < holes:
        if not any(add_hole(source, outer, inner, hole_corners, size) for _ in range(60)):
            outer, inner = [(0, 0), (size, 0), (size, size), (0, size)], []
    return outline(outer, *inner)


def add_hole(source, outer, inner, corners, size):
    ring = tangle(source.randrange(1 << 30), corners, max(5, size // 3)).exterior
    x, y = source.randrange(size), source.randrange(size)
    ring = [(x + dx, y + dy) for dx, dy in ring]
    fits = strict(shapely.Polygon(outer, [*inner, ring]))
    inner += [ring] if fits else []
    return fits


def strict(polygon):
    """Valid, and no two rings touch."""
    rings = [polygon.exterior, *polygon.interiors]
    apart = all(rings[i].disjoint(rings[k]) for k in range(len(rings)) for i in range(k))
    return polygon.is_valid and polygon.area > 0 and apart
