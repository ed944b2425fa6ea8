# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The least number of convex parts by exhaustive search, for small outlines, with holes too; and what the libraries make
# of the same outlines. Nothing of the tool is used.
from functools import cmp_to_key
from itertools import combinations

import shapely


def fewest_parts(outline):
    """Parts are diagonals + 1 - holes: each diagonal divides a part, but for those that join the holes to the rest.
    Numbers of diagonals are tried from the least on."""
    scene = Scene(outline)
    number = 0
    while not scene.can_be_convex(frozenset(), number, set()):
        number += 1
    return number + 1 - len(outline.holes)


class Scene:
    def __init__(self, outline):
        self.rings = outline.rings
        self.edges = [(a, b) for ring in self.rings for a, b in zip(ring, [*ring[1:], ring[0]])]
        self.next = dict(self.edges)
        self.previous = {b: a for a, b in self.edges}
        self.diagonals = [pair for pair in combinations(self.next, 2) if self.is_diagonal(*pair)]
        self.at = {v: [pair for pair in self.diagonals if v in pair] for v in self.next}
        self.reflex = [v for v in self.next if turn(self.previous[v], v, self.next[v]) < 0]

    def is_diagonal(self, a, b):
        if self.next[a] == b or self.next[b] == a or any(between(a, v, b) for v in self.next):
            return False
        return not any(crosses(a, b, *edge) for edge in self.edges) and self.holds_middle(a, b)

    def holds_middle(self, a, b):
        """Is the middle inside? Edges to its right are counted, all coordinates doubled; it is on no edge."""
        x, y = a[0] + b[0], a[1] + b[1]
        inside = False
        for (px, py), (qx, qy) in self.edges:
            if (2 * py > y) != (2 * qy > y):
                ahead = (2 * px - x) * (2 * qy - 2 * py) - (2 * py - y) * (2 * qx - 2 * px)
                inside ^= (ahead > 0) == (qy > py)
        return inside

    def can_be_convex(self, chosen, number, failed):
        """Can so many diagonals more do it? One of them has to go into the first angle above 180 degrees that is left."""
        angle = next(filter(None, (self.wide_angle(v, chosen) for v in self.reflex)), None)
        if angle is None:
            return True
        if number == 0 or chosen in failed:
            return False
        failed.add(chosen)
        v, first, last = angle
        for pair in self.at[v]:
            other = pair[0] if pair[1] == v else pair[1]
            if strictly_within(v, first, last, other) and not any(crosses(*pair, *cut) for cut in chosen):
                if self.can_be_convex(chosen | {pair}, number - 1, failed):
                    return True
        return False

    def wide_angle(self, v, chosen):
        """(v, one neighbor, the other) of an angle above 180 degrees between edges and chosen diagonals, or None."""
        first, last = self.next[v], self.previous[v]
        others = [pair[0] if pair[1] == v else pair[1] for pair in chosen if v in pair]
        in_front = cmp_to_key(lambda a, b: -1 if strictly_within(v, first, b, a) else 1)
        rays = [first, *sorted(others, key=in_front), last]
        return next(((v, a, b) for a, b in zip(rays, rays[1:]) if turn(a, v, b) > 0), None)


def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def between(a, v, b):
    return turn(a, v, b) == 0 and (a[0] - v[0]) * (b[0] - v[0]) + (a[1] - v[1]) * (b[1] - v[1]) < 0


def crosses(a, b, c, d):
    return turn(a, b, c) * turn(a, b, d) < 0 and turn(c, d, a) * turn(c, d, b) < 0


def strictly_within(v, first, last, ray):
    """Is the ray met on the way round v from first to last, in the direction of positive turns?"""
    if turn(v, first, last) > 0:
        return turn(v, first, ray) > 0 and turn(v, ray, last) > 0
    return turn(v, first, ray) > 0 or turn(v, ray, last) > 0


def merged_triangles(outline):
    """Hertel and Mehlhorn over shapely's constrained Delaunay triangles: the number of parts."""
    polygon = shapely.Polygon(outline.exterior, outline.holes)
    parts = list(shapely.constrained_delaunay_triangles(polygon).geoms)
    merged = True
    while merged:
        merged = False
        for one, other in combinations(parts, 2):
            both = one.union(other)
            if both.geom_type == "Polygon" and abs(both.convex_hull.area - both.area) < 1e-6:
                parts = [part for part in parts if part is not one and part is not other] + [both]
                merged = True
                break
    return len(parts)
