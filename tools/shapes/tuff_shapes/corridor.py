# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Where the vertices of an outline may lie, and which straight edges between them follow the border. Every corner of
# the border has a radius; an edge may replace a stretch of border if it meets the discs of the stretch's corners in
# order: its Frechet distance from the stretch is then within the radii (the distance is convex between corners).
import numpy as np

from .cycles import Ring

OFFSETS = (0.0, 1.0, -1.0, 0.5, -0.5, 0.75, -0.75, 0.25, -0.25)     # of candidate vertices across the border, in radii
FINE = ((200, 9), (350, 7))     # so many of them where there are no more columns than that; otherwise:
COARSE = 5
COARSE_STEP = 0.2         # of the lattice, in radii: above it the lattice points about a column are candidates too
DENSITY = 16              # columns along the longest chord that fits, where the border is smooth
LEAST = 0.5               # pixels between columns at least, but for corners with a radius of no more than that
SURVEY = 1500             # places at which the longest chord is looked for
BLOCK = 24                # corners that one round of the sweep takes in
SLACK = 1e-9              # pixels, radians: the sweep proposes, follows() decides


class Corridor:
    """Columns of candidate vertices along one closed border, and the edges allowed between them.

    points, radii   the border's corners and the columns' places in order, as x + iy in pixels, with their radii
    column          index in points of each column
    steps, spots    candidates of each column: lattice points (columns, candidates, 2), the same in pixels, complex
    edges           the cycles.Ring of them
    """

    def __init__(self, corners, radii, lattice):
        self.points, self.radii, self.column = with_columns(corners, radii)
        self.steps, self.spots, self.usable = candidates(self.points, self.radii, self.column, lattice)
        self.moments = prefix_moments(self.points)
        self.edges = allowed_edges(self)

    def place(self, node):
        """(index in points of the column, the candidate's spot) of nodes."""
        return self.column[node // self.edges.width], self.spots.ravel()[node]

    def follows(self, source, target):
        """Which edges meet the discs of their stretch in order, exactly. All go from one column to one other."""
        (first, start), (last, end) = self.place(source), self.place(target)
        between = np.arange(first[0] + 1, last[0] + (len(self.points) if last[0] <= first[0] else 0)) % len(self.points)
        length = np.abs(end - start)[:, None]
        along = (self.points[between] - start[:, None]) * np.conj(end - start)[:, None] / length
        chord = np.sqrt(np.maximum(self.radii[between] ** 2 - along.imag ** 2, 0))
        entry = np.maximum.accumulate(np.maximum(along.real - chord, 0), axis=1)
        leave = np.minimum(along.real + chord, length)
        close = np.abs(along.imag) <= self.radii[between] + SLACK / 8
        return (close & (entry <= leave + SLACK / 8)).all(axis=1)

    def squared_error(self, source, target):
        """Integral of the squared distance between the border from source to target and the line of each edge."""
        middle = self.points.mean()
        (i, start), (j, end) = self.place(source), self.place(target)
        normal = 1j * (end - start) / np.abs(end - start)
        one, x, y, xx, xy, yy = self.moments[:, j + len(self.points) * (j <= i)] - self.moments[:, i]
        start = start - middle
        offset = normal.real * start.real + normal.imag * start.imag
        square = normal.real ** 2 * xx + 2 * normal.real * normal.imag * xy + normal.imag ** 2 * yy
        return np.maximum(square - 2 * offset * (normal.real * x + normal.imag * y) + offset ** 2 * one, 0)


def with_columns(corners, radii):
    """(points, radii, column): corners and columns in one list, columns closer together where chords are short."""
    lengths = np.abs(np.roll(corners, -1) - corners)
    ends = np.concatenate([[0.0], np.cumsum(lengths)])
    place = column_places(corners, radii, ends)
    merged = np.union1d(ends[:-1], place)
    radius = np.interp(merged, ends, np.append(radii, radii[0]))
    return at(corners, ends, merged), radius, np.searchsorted(merged, place)


def at(corners, ends, place):
    """Points at places along the border."""
    closed = np.append(corners, corners[0])
    return np.interp(place, ends, closed.real) + 1j * np.interp(place, ends, closed.imag)


def column_places(corners, radii, ends):
    """Places of the columns: a sixteenth of the local chord apart, on corners where one is near enough."""
    survey = np.linspace(0, ends[-1], min(SURVEY, max(len(corners), int(ends[-1])) + 1))
    spacing = np.maximum(chords(corners, radii, ends, survey) / DENSITY, np.interp(survey, ends, np.append(radii, radii[0])) / 2)
    density = 1 / np.maximum(spacing, LEAST)
    counted = np.concatenate([[0.0], np.cumsum((density[1:] + density[:-1]) / 2 * np.diff(survey))])
    wanted = np.linspace(0, counted[-1], max(int(np.ceil(counted[-1])), 3), endpoint=False)
    corner_count = np.interp(ends, survey, counted)
    nearest = nearest_index(corner_count, wanted)
    place = np.where(np.abs(corner_count[nearest] - wanted) < 0.5, ends[nearest], np.interp(wanted, counted, survey))
    tight = ends[:-1][radii <= LEAST]
    return np.unique(np.concatenate([place[place < ends[-1]], [0.0], tight]))


def nearest_index(ascending, wanted):
    right = np.clip(np.searchsorted(ascending, wanted), 1, len(ascending) - 1)
    return np.where(wanted - ascending[right - 1] < ascending[right] - wanted, right - 1, right)


def chords(corners, radii, ends, survey):
    """At each place of the survey: how far a straight line from there follows the border, the shorter of both ways."""
    origins = at(corners, ends, survey)
    before = np.searchsorted(ends[1:], survey, side="right") % len(corners)
    ahead = reach(corners, radii, before, origins)
    behind = reach(np.conj(corners[::-1]), radii[::-1], (len(corners) - 2 - before) % len(corners), np.conj(origins))
    return np.minimum(ahead, behind)


def reach(corners, radii, start, origins):
    """Distance from each origin, on the border after corner start, to the last corner that the longest chord meets."""
    farthest = np.zeros(len(origins))
    for row, index, cone in sweep(corners, radii, start, origins):
        last = np.where(cone.alive, np.arange(index.shape[1]), 0).max(axis=1)
        apart = np.abs(corners[index[np.arange(len(row)), last]] - origins[row])
        farthest[row] = np.maximum(farthest[row], apart)
    return farthest


class Cone:
    """What the sweep knows before each corner of a block: one row per origin, one column per corner."""

    def __init__(self, low, high, passed, alive, axis):
        self.low, self.high = low, high     # directions (radians from axis) that meet all discs so far
        self.passed = passed                # no disc so far can be entered nearer than this
        self.alive = alive                  # the cone is not empty
        self.axis = axis                    # conjugate of the direction that angles are counted from


def sweep(points, radii, start, origins):
    """Follows the border onward from each origin, disc after disc: yields (rows, indices of points, Cone).

    The cone of lines through a point that stab a row of discs is kept as two angles (Imai and Iri; Guibas et al.,
    "Approximating polygons and subdivisions with minimum link paths"); the order of the discs is kept by bounds, which
    are necessary only.
    """
    row = np.arange(len(origins))
    low, high, passed = np.full(len(row), -np.inf), np.full(len(row), np.inf), np.full(len(row), -np.inf)
    axis = np.zeros(len(row), dtype=np.complex128)
    for first in range(1, len(points), BLOCK):
        index = (start[row, None] + np.arange(first, min(first + BLOCK, len(points)))) % len(points)
        away = points[index] - origins[row, None]
        apart = np.sqrt(away.real ** 2 + away.imag ** 2)
        radius = radii[index]
        outside = apart > radius
        axis = np.where(axis == 0, first_direction(away, outside), axis)
        angle = np.angle(away * axis[:, None])
        half = np.arcsin(np.divide(radius, apart, out=np.ones_like(apart), where=outside))
        low = running(np.maximum, low, np.where(outside, angle - half, -np.inf))
        high = running(np.minimum, high, np.where(outside, angle + half, np.inf))
        enter, leave = crossing(apart, radius, np.where(outside, np.maximum(low[:, 1:] - angle, angle - high[:, 1:]), 0))
        entered = running(np.maximum, passed, enter)
        met = (low[:, 1:] <= high[:, 1:] + SLACK) & (leave >= entered[:, :-1] - SLACK)
        alive = running(np.logical_and, np.ones(len(row), dtype=bool), met)
        yield row, index, Cone(low[:, :-1], high[:, :-1], entered[:, :-1], alive[:, :-1], axis)
        left = alive[:, -1]
        row, axis, low, high, passed = row[left], axis[left], low[left, -1], high[left, -1], entered[left, -1]
        if not len(row):
            return


def running(operation, before, values):
    """Accumulated along the rows, what came before in front."""
    return operation.accumulate(np.concatenate([before[:, None], values], axis=1), axis=1)


def crossing(apart, radius, turn):
    """(enter, leave): bounds of the distances at which a line meets a disc that it passes turned off by that angle at
    least. Straight through its center it would enter soonest and leave last."""
    turn = np.clip(turn, 0, np.pi / 2)
    chord = np.sqrt(np.maximum(radius ** 2 - (apart * np.sin(turn)) ** 2, 0))
    middle = apart * np.cos(turn)
    return middle - chord, middle + chord


def first_direction(away, outside):
    """Conjugate of the direction of the first disc that does not hold the origin; 0 where there is none."""
    first = np.argmax(outside, axis=1)
    rows = np.arange(len(away))
    return np.where(outside[rows, first], np.conj(away[rows, first]), 0)


def candidates(points, radii, column, lattice):
    """(steps, spots, usable): lattice points near offsets across the border, and the four round the column's place."""
    place, radius = points[column], radii[column]
    across = normals(points, column, np.maximum(2.0, 2 * radius))
    room = np.maximum(radius - 0.7072 * lattice.step, 0)
    offsets = np.array(OFFSETS[:next((count for columns, count in FINE if len(column) <= columns), COARSE)])
    spots = place[:, None] + (room[:, None] * offsets) * across[:, None]
    steps = lattice.nearest(np.stack([spots.real, spots.imag], axis=-1))
    if lattice.step > COARSE_STEP * radii.min():
        steps = np.concatenate([steps, cell(place, lattice)], axis=1)
    exact = lattice.pixels(steps)
    spots = exact[..., 0] + 1j * exact[..., 1]
    usable = (np.abs(spots - place[:, None]) <= radius[:, None] + SLACK / 8) & first_of_its_kind(spots)
    usable[:, len(offsets):] &= (lattice.step > COARSE_STEP * radius)[:, None]
    return steps, spots, usable


def first_of_its_kind(spots):
    """False where a column has the same spot before."""
    same = spots[:, :, None] == spots[:, None, :]
    return ~np.tril(same, -1).any(axis=2)


def cell(place, lattice):
    """The lattice points at the corners of the cell that holds each place."""
    low = np.floor(np.stack([place.real, place.imag], axis=-1) / lattice.step).astype(np.int64)
    return low[:, None, :] + np.array([(0, 0), (0, 1), (1, 0), (1, 1)])


def normals(points, column, reach):
    """Unit normals of the border as seen from reach pixels to either side."""
    lengths = np.abs(np.roll(points, -1) - points)
    ends = np.concatenate([[0.0], np.cumsum(lengths)])
    place = ends[column]
    along = at(points, ends, (place + reach) % ends[-1]) - at(points, ends, (place - reach) % ends[-1])
    return 1j * along / np.maximum(np.abs(along), 1e-300)


def allowed_edges(corridor):
    """The Ring of columns and of edges that may follow the border: every one that does, and a few that do not."""
    columns, width = corridor.usable.shape
    node = np.flatnonzero(corridor.usable)
    origins = corridor.spots.ravel()[node]
    number = np.full(len(corridor.points), -1)
    number[corridor.column] = np.arange(columns)
    source, target = [], []
    for row, index, cone in sweep(corridor.points, corridor.radii, corridor.column[node // width], origins):
        pair = np.nonzero(cone.alive & (number[index] >= 0))
        column, rows = number[index[pair]], row[pair[0]]
        which, candidate = np.nonzero(hits(corridor, cone, pair, column, origins[rows]))
        source.append(node[rows[which]])
        target.append(column[which] * width + candidate)
    source, target = np.concatenate(source), np.concatenate(target)
    order = np.argsort(source, kind="stable")
    return Ring(columns, width, source[order], target[order])


def hits(corridor, cone, pair, target, origins):
    """Which candidates of the target columns lie in the cones, beyond every disc's entry."""
    away = corridor.spots[target] - origins[:, None]
    angle = np.angle(away * cone.axis[pair[0]][:, None])
    far = away.real ** 2 + away.imag ** 2 >= np.maximum(cone.passed[pair] - SLACK, SLACK)[:, None] ** 2
    inside = (angle >= cone.low[pair][:, None] - SLACK) & (angle <= cone.high[pair][:, None] + SLACK)
    return inside & far & corridor.usable[target]


def prefix_moments(points):
    """Integrals of 1, x, y, xx, xy, yy along the border, twice round, before each point."""
    start = points - points.mean()
    end = np.roll(start, -1)
    length = np.abs(end - start)
    x0, y0, x1, y1 = start.real, start.imag, end.real, end.imag
    pieces = length * np.array([np.ones(len(points)), (x0 + x1) / 2, (y0 + y1) / 2, (x0 * x0 + x0 * x1 + x1 * x1) / 3,
                                (2 * x0 * y0 + x0 * y1 + x1 * y0 + 2 * x1 * y1) / 6, (y0 * y0 + y0 * y1 + y1 * y1) / 3])
    return np.concatenate([np.zeros((6, 1)), np.cumsum(np.tile(pieces, 2), axis=1)], axis=1)
