# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# How far an outline and the border it stands for are apart, both ways, by branch and bound on the distance itself.
import numpy as np
import shapely

from .model import Deviation

EXACT = 1e-6      # pixels: where a bound is no more than this above what was found, the search ends
SPACING = 0.25    # pixels between the samples of the mean, each weighed by Simpson's rule


def deviation(region, outline, lattice):
    """The Deviation of an Outline from its Region: ring from ring, in the same order."""
    rings = [(ring, lattice.pixels(steps)) for ring, steps in zip(region.rings, outline.rings, strict=True)]
    found = [farther_way(border, ring) for border, ring in rings]
    largest, spot = max(found, key=lambda one: one[0])
    lengths, areas = zip(*(distance_integral(border, ring) for border, ring in rings))
    return Deviation(round(float(largest), 9), float(sum(areas) / sum(lengths)), (float(spot[0]), float(spot[1])))


def farther_way(ring, other):
    """The larger of the two directed distances between closed rings, and where it is."""
    return max(farthest(ring, Edges(other)), farthest(other, Edges(ring)), key=lambda one: one[0])


class Edges:
    """The edges of a closed ring, to be asked for the nearest to each of many points."""

    def __init__(self, ring):
        self.start = np.asarray(ring, dtype=np.float64)
        self.way = np.roll(self.start, -1, axis=0) - self.start
        self.square = np.maximum((self.way ** 2).sum(axis=1), 1e-300)
        self.tree = shapely.STRtree(shapely.linestrings(np.stack([self.start, self.start + self.way], axis=1)))

    def nearest(self, points):
        return self.tree.nearest(shapely.points(points))

    def distance(self, points, edges):
        """Of points[i] from edge edges[i]."""
        away = points - self.start[edges]
        part = np.clip((away * self.way[edges]).sum(axis=1) / self.square[edges], 0, 1)
        rest = away - part[:, None] * self.way[edges]
        return np.sqrt((rest ** 2).sum(axis=1))


def farthest(ring, edges):
    """(distance, point): the point of a closed ring that is farthest from all edges.

    Along a straight section the distance from one edge is convex, so the larger of its values at the section's ends
    bounds the distance from the nearest edge. Sections whose bound, for the edge nearest to either end, is above the
    farthest point so far are halved.
    """
    ends = np.asarray(ring, dtype=np.float64)
    near = edges.nearest(ends)
    apart = edges.distance(ends, near)
    worst = int(np.argmax(apart))
    best, spot = apart[worst], ends[worst]
    section = (ends, np.roll(ends, -1, axis=0), near, np.roll(near, -1), apart, np.roll(apart, -1))
    while True:
        section = [part[bound(edges, *section) > best + EXACT] for part in section]
        if not len(section[0]):
            return best, spot
        middle = (section[0] + section[1]) / 2
        near = edges.nearest(middle)
        apart = edges.distance(middle, near)
        worst = int(np.argmax(apart))
        if apart[worst] > best:
            best, spot = apart[worst], middle[worst]
        section = halves(section, middle, near, apart)


def bound(edges, start, end, near_start, near_end, apart_start, apart_end):
    """An upper bound of the distance along each section."""
    by_start = np.maximum(apart_start, edges.distance(end, near_start))
    by_end = np.maximum(apart_end, edges.distance(start, near_end))
    return np.minimum(by_start, by_end)


def halves(section, middle, near, apart):
    start, end, near_start, near_end, apart_start, apart_end = section
    pairs = ((start, middle), (middle, end), (near_start, near), (near, near_end), (apart_start, apart), (apart, apart_end))
    return [np.concatenate(pair) for pair in pairs]


def distance_integral(border, ring):
    """(length of the border, integral of its distance from the ring along it)."""
    start = np.asarray(border, dtype=np.float64)
    way = np.roll(start, -1, axis=0) - start
    length = np.hypot(*way.T)
    count = np.maximum(np.ceil(length / SPACING), 1).astype(np.int64)
    edge = np.repeat(np.arange(len(start)), count)
    first = np.arange(len(edge)) - np.repeat(np.cumsum(count) - count, count)
    edges = Edges(ring)
    total = 0.0
    for place, weight in ((0.0, 1 / 6), (0.5, 4 / 6), (1.0, 1 / 6)):
        points = start[edge] + way[edge] * ((first + place) / count[edge])[:, None]
        total += weight * (edges.distance(points, edges.nearest(points)) * (length / count)[edge]).sum()
    return length.sum(), total
