# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Where rings of lattice points cross or touch, in exact integers: a legal outline has rings that are simple, apart from
# each other, and turned the right way.
import numpy as np
import shapely


def shoelace(ring):
    """Twice the area of a ring of lattice points, signed; a Python int."""
    points = np.asarray(ring, dtype=np.int64) - np.asarray(ring[0], dtype=np.int64)
    after = np.roll(points, -1, axis=0)
    return int((points[:, 0] * after[:, 1] - points[:, 1] * after[:, 0]).sum())


def without_straight(ring):
    """The ring without repeated points and without those in the middle of a straight run."""
    points = [point for point, before in zip(ring, [*ring[-1:], *ring[:-1]]) if point != before]
    while len(points) >= 3:
        kept = [at for before, at, after in zip([points[-1], *points[:-1]], points, [*points[1:], points[0]])
                if not straight(before, at, after)]
        if len(kept) == len(points):
            break
        points = kept
    return points


def straight(before, at, after):
    """Whether at lies between its neighbors on one line."""
    x0, y0, x1, y1 = at[0] - before[0], at[1] - before[1], after[0] - at[0], after[1] - at[1]
    return x0 * y1 == y0 * x1 and x0 * x1 + y0 * y1 >= 0


def touching(rings):
    """[((ring, edge), (ring, edge), (x, y)), ...]: edges that share a point they should not, and about where it is."""
    start = np.concatenate([np.asarray(ring, dtype=np.int64) for ring in rings])
    end = np.concatenate([np.roll(np.asarray(ring, dtype=np.int64), -1, axis=0) for ring in rings])
    ring = np.repeat(np.arange(len(rings)), [len(one) for one in rings])
    edge = np.concatenate([np.arange(len(one)) for one in rings])
    lines = shapely.linestrings(np.stack([start, end], axis=1).astype(np.float64))
    one, other = shapely.STRtree(lines).query(lines)
    one, other = one[one < other], other[one < other]
    size = np.array([len(points) for points in rings])
    same = ring[one] == ring[other]
    onward = same & (edge[other] == (edge[one] + 1) % size[ring[one]])
    backward = same & (edge[one] == (edge[other] + 1) % size[ring[one]])
    bad = np.where(onward, folded(start[one], end[one], end[other]),
                   np.where(backward, folded(start[other], end[other], end[one]), meeting(start[one], end[one], start[other], end[other])))
    return [((int(ring[i]), int(edge[i])), (int(ring[j]), int(edge[j])), meeting_point(start[i], end[i], start[j], end[j]))
            for i, j in zip(one[bad], other[bad])]


def cross(origin, a, b):
    return (a[:, 0] - origin[:, 0]) * (b[:, 1] - origin[:, 1]) - (a[:, 1] - origin[:, 1]) * (b[:, 0] - origin[:, 0])


def folded(before, at, after):
    """Whether an edge runs back over the one before it."""
    return (cross(at, before, after) == 0) & (((before - at) * (after - at)).sum(axis=1) > 0)


def meeting(a, b, c, d):
    """Whether closed segments ab and cd share a point. Their bounding boxes are known to meet, which settles the
    collinear case."""
    return (np.sign(cross(a, b, c)) * np.sign(cross(a, b, d)) <= 0) & (np.sign(cross(c, d, a)) * np.sign(cross(c, d, b)) <= 0)


def meeting_point(a, b, c, d):
    """Where lines ab and cd cross; of parallel ones, the middle between b and c."""
    way, other = (b - a).astype(float), (d - c).astype(float)
    turn = way[0] * other[1] - way[1] * other[0]
    if turn == 0:
        return tuple(((b + c) / 2).tolist())
    part = ((c[0] - a[0]) * other[1] - (c[1] - a[1]) * other[0]) / turn
    return tuple((a + np.clip(part, 0, 1) * way).tolist())
