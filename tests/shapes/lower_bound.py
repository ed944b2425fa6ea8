# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# How few edges an outline could have at the very least. Each edge passes within the tolerance of a run of consecutive
# corners of the border, so these lie in a strip of twice the tolerance, and all runs together cover the ring.
import numpy as np
import shapely


def lower_bound(ring, tolerance):
    """Fewest runs of consecutive corners, each in one strip, that cover a closed ring; at least 3."""
    corners = np.asarray(ring, dtype=np.float64)
    after = run_ends(corners, tolerance)
    return max(3, min(runs_from(start, after, len(corners)) for start in range(after[0] + 1)))


def run_ends(corners, tolerance):
    """For each corner the first one (counted on, past the ring's end) that no longer fits a strip with it."""
    twice = np.concatenate([corners, corners])
    after, end = [], 1
    for start in range(len(corners)):
        end = max(end, start + 1)
        while end < start + len(corners) and width(twice[start:end + 1]) <= 2 * tolerance + 1e-9:
            end += 1
        after.append(end)
    return after


def width(points):
    """Least width of a strip that holds the points: across one of the edges of their convex hull."""
    hull = shapely.convex_hull(shapely.multipoints(points))
    if hull.geom_type != "Polygon":
        return 0.0
    corners = shapely.get_coordinates(hull)
    way = np.diff(corners, axis=0)
    normal = np.stack([way[:, 1], -way[:, 0]], axis=1) / np.hypot(*way.T)[:, None]
    height = normal @ corners.T
    return float((height.max(axis=1) - height.min(axis=1)).min())


def runs_from(start, after, count):
    place, runs = start, 0
    while place < start + count:
        place = after[place % count] + place // count * count
        runs += 1
    return runs
