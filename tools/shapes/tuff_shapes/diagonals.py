# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Which vertices of an outline see each other: its diagonals, by signs of exact integers. A diagonal runs inside and
# meets the border at its two ends only, so that no vertex lies on it and no cut ends in the middle of an edge.
from collections import Counter
from functools import cached_property

import numpy as np
import shapely

from .faults import ShapeFault

# Cross products of differences below 2^30 stay below 2^62: int64 holds them.
WIDEST = 1 << 30


class Ground:
    """The vertices of an outline, by number: rings one after the other, the exterior first."""

    def __init__(self, outline):
        self.points = [tuple(map(int, point)) for ring in outline.rings for point in ring]
        self.rings = _numbered(outline.rings)
        self.after = {a: b for ring in self.rings for a, b in zip(ring, ring[1:] + ring[:1])}
        self.before = {b: a for a, b in self.after.items()}
        self._refuse_unfit(outline)
        self.array = np.array(self.points, dtype=np.int64) - np.array(self.points, dtype=np.int64).min(axis=0)
        self._refuse_touching()

    def is_border(self, a, b):
        return self.after[a] == b

    def is_reflex(self, a):
        return cross(self.points[self.before[a]], self.points[a], self.points[self.after[a]]) < 0

    def signs(self, a, b):
        """Of all vertices: 1 to the side where the solid lies along a border from a to b, -1 to the other, 0 in line."""
        return np.sign(_crosses(self.array[a], self.array[b], self.array))

    def _refuse_unfit(self, outline):
        for ring in outline.rings:
            if len(ring) < 3:
                raise ShapeFault(f"a ring of {len(ring)} vertices has no area")
            if len(set(map(tuple, ring))) < len(ring):
                raise ShapeFault("the outline visits a vertex twice")
        spans = [max(axis) - min(axis) for axis in zip(*self.points)]
        if max(spans) >= WIDEST:
            raise ShapeFault(f"the outline is {max(spans)} lattice steps wide; fewer steps a unit or a smaller scale is needed")
        polygon = shapely.Polygon(outline.exterior, outline.holes)
        if not polygon.is_valid:
            raise ShapeFault(f"the outline crosses itself or a hole ({shapely.is_valid_reason(polygon)}, in lattice steps)")
        if doubled_area(outline.exterior) <= 0 or any(doubled_area(hole) >= 0 for hole in outline.holes):
            raise ShapeFault("the outline runs the wrong way round")

    def _refuse_touching(self):
        """Rings that touch in a point are valid to shapely, but leave a piece that hangs together by that point."""
        touched = [point for point, times in Counter(self.points).items() if times > 1]
        for a, b in self.after.items():
            inside = _on_open_segment(self.array[a], self.array[b], self.array, self.signs(a, b))
            touched += [self.points[number] for number in np.flatnonzero(inside)]
        if touched:
            raise ShapeFault(f"the outline touches itself at {touched[0]}, in lattice steps")

    @cached_property
    def sees(self):
        """sees[a, b]: the segment from a to b is a diagonal."""
        starts = np.array(list(self.after))
        ends = np.array(list(self.after.values()))
        edges = np.array([self.signs(a, b) for a, b in self.after.items()])
        sees = np.array([self.within(self.before[a], a, self.after[a]) for a in range(len(self.points))])
        sees = np.triu(sees & sees.T)
        for a in range(len(self.points)):
            others = np.flatnonzero(sees[a])
            side = np.sign(_crosses(self.array[a], self.array[others, None], self.array))
            crossed = (side[:, starts] * side[:, ends] < 0) & (edges[:, a] * edges[:, others].T < 0)
            blocked = _on_open_segment(self.array[a], self.array[others, None], self.array, side)
            sees[a, others] = ~crossed.any(axis=1) & ~blocked.any(axis=1)
        return sees | sees.T

    def within(self, before, a, after):
        """Of all vertices: seen from a, do they lie strictly between the borders that come from before and go on to after?"""
        left_of_leaving, left_of_coming = self.signs(a, after) > 0, self.signs(before, a) > 0
        if cross(self.points[before], self.points[a], self.points[after]) >= 0:
            return left_of_leaving & left_of_coming
        return ~((self.signs(a, after) <= 0) & (self.signs(before, a) <= 0))

    def crossing(self, a, b, numbers):
        """Which diagonals between the given vertices cross the diagonal from a to b? A square array."""
        side = self.signs(a, b)[numbers]
        points = self.array[numbers]
        of_a = np.sign(_crosses(points[:, None], points[None, :], self.array[a]))
        of_b = np.sign(_crosses(points[:, None], points[None, :], self.array[b]))
        return (side[:, None] * side[None, :] < 0) & (of_a * of_b < 0)


def cross(a, b, c):
    """Twice the area of the triangle; positive for a turn towards the solid side."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def doubled_area(ring):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, [*ring[1:], ring[0]]))


def _numbered(rings):
    numbered, first = [], 0
    for ring in rings:
        numbered.append(list(range(first, first + len(ring))))
        first += len(ring)
    return numbered


def _crosses(a, b, c):
    along, to = b - a, c - a
    return along[..., 0] * to[..., 1] - along[..., 1] * to[..., 0]


def _on_open_segment(a, b, points, side):
    """Points in line with a and b are between them where the directions to a and b are opposite."""
    to_a, to_b = a - points, b - points
    return (side == 0) & (to_a[..., 0] * to_b[..., 0] + to_a[..., 1] * to_b[..., 1] < 0)
