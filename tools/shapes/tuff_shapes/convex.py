# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# From an Outline to convex parts that fill it exactly: cuts from vertex to vertex, the fewest that do it.
# Without holes the minimum is found; holes and outlines too large for that are cut somehow first, and then over and
# over in groups of neighboring parts. Also the hull of points, and the check of what comes out.
from collections import deque
from itertools import accumulate, islice, product
from math import dist

import numpy as np
import shapely

from . import partition
from .diagonals import Ground, cross, doubled_area
from .faults import ShapeFault
from .model import Part

MOST_VERTICES = 32
MOST_PARTS = 255
MOST_WORK = 60_000      # steps of the program in partition.py for an outline as a whole, see Polygon.work: about 0.7 s
OPENING_WORK = 20_000   # and for all the ways to lay holes open: about 0.3 s
GROUP_VERTICES = 40     # of a group of parts that are cut anew


def decompose(outline, max_vertices=MOST_VERTICES, thin=32):
    """The convex parts of an outline. thin: a part of less width is a sliver, in lattice steps (half a pixel at 64 a pixel);
    0: the fewest parts, whatever their form."""
    ground = Ground(outline)
    reflex = sum(map(ground.is_reflex, range(len(ground.points))))
    _refuse_many((reflex + 1) // 2 + 1 - len(outline.holes), "at least ")    # a diagonal ends at two, and joins or divides
    parts = _fewest(ground, partition.Costs(thin)) if reflex else ground.rings
    parts = [piece for part in parts for piece in _split(ground, part, max_vertices)]
    _refuse_many(len(parts))
    return _marked(ground, parts)


def _refuse_many(count, least=""):
    if count > MOST_PARTS:
        raise ShapeFault(f"{least}{count} convex parts, and a piece has at most {MOST_PARTS}; a larger tolerance leaves fewer")


# ---- The whole outline

def _fewest(ground, costs):
    """Exact without holes, and with holes as far as there is time for all ways to lay them open; improved by groups else."""
    openings = _openings(ground)
    walks = [next(openings)]
    work = partition.Polygon(ground, walks[0]).work
    if work > MOST_WORK:
        return _improved(ground, costs, _merged_triangles(ground))
    walks += islice(openings, OPENING_WORK // (work + 1))
    is_exact = next(openings, None) is None
    parts = _cheapest(ground, costs, walks, is_exact)
    slivers = sum(costs.is_sliver([ground.points[number] for number in part]) for part in parts)
    return _with_fewer_slivers(ground, costs, walks, is_exact, parts, slivers) if slivers and len(parts) >= 3 else parts


def _cheapest(ground, costs, walks, is_exact):
    results = [partition.cheapest(partition.Polygon(ground, walk), costs) for walk in walks]
    parts = min(results, key=lambda result: result[0])[1]
    return parts if is_exact else _improved(ground, costs, parts)


def _with_fewer_slivers(ground, costs, walks, is_exact, parts, slivers):
    """A part more is better than a sliver, but no more than a third above the fewest: a sliver's price is set so that
    getting rid of all of them cannot cost more than that."""
    price = min(1.5, (len(parts) // 3 + 0.5) / slivers)
    costs = partition.Costs(costs.thin, int(price * partition.PART))
    return min(parts, _cheapest(ground, costs, walks, is_exact), key=lambda parts: _cost(ground, costs, parts))


def _openings(ground):
    """Walks round the outline that pass a diagonal to each hole there and back, the nearest ways first.

    The solid reaches more than half round the leftmost vertex of a hole (the upper one of two), so every convex
    decomposition has a diagonal from there to a vertex farther left (or straight above): to the exterior, or to a hole
    whose own leftmost vertex is farther left. One such diagonal for each hole opens them all."""
    holes = sorted(([_rotated(hole, min(hole, key=ground.points.__getitem__)) for hole in ground.rings[1:]]),
                   key=lambda hole: ground.points[hole[0]])
    for ways in _ways(ground, [hole[0] for hole in holes], []):
        yield _opened(ground, holes, ways)


def _ways(ground, starts, chosen):
    """Lists of diagonals to the left, one from each start, that do not cross. However the first ones are chosen, the
    next start has one: the solid cut open along them still reaches more than half round it."""
    if len(chosen) == len(starts):
        yield chosen
        return
    a = starts[len(chosen)]
    left = [b for b in np.flatnonzero(ground.sees[a]).tolist() if ground.points[b] < ground.points[a]]
    for b in sorted(left, key=lambda b: (dist(ground.points[b], ground.points[a]), b)):
        if not any(ground.crossing(a, b, way)[0, 1] for way in chosen):
            yield from _ways(ground, starts, [*chosen, [a, b]])


def _rotated(ring, first):
    place = ring.index(first)
    return [*ring[place:], *ring[:place]]


def _opened(ground, holes, ways):
    walk = list(ground.rings[0])
    for hole, (a, b) in zip(holes, ways):
        place = next(i for i, passed in enumerate(walk)
                     if passed == b and ground.within(walk[i - 1], b, walk[(i + 1) % len(walk)])[a])
        walk[place + 1:place + 1] = [*hole, a, b]
    return walk


# ---- Groups of parts

def _improved(ground, costs, parts):
    """Join neighboring parts and cut them anew, from every part on, until nothing gets better. A group that lies round
    a hole keeps a cut that closes the ring, another one each time."""
    parts = dict(enumerate(parts))
    waiting = deque(product(parts, (deque.pop, deque.popleft)))
    tried = set()
    while waiting:
        start, take = waiting.popleft()
        if start not in parts:
            continue
        members, walk = _group(parts, start, take)
        border = frozenset(_edges(walk))
        if len(members) < 2 or border in tried:
            continue
        tried.add(border)
        cost, better = partition.cheapest(partition.Polygon(ground, walk), costs)
        if cost < _cost(ground, costs, [parts[member] for member in members], border):
            fresh = {max(parts) + 1 + i: part for i, part in enumerate(better)}
            parts = {number: part for number, part in parts.items() if number not in members} | fresh
            waiting.extend(product(fresh, (deque.pop, deque.popleft)))
    return list(parts.values())


def _group(parts, start, take):
    """A part joined with its neighbors, theirs and so on, and the walk round them all. take: the next edge to look over,
    the newest (a long arm) or the oldest (a round group)."""
    owner = {edge: number for number, part in parts.items() for edge in _edges(part)}
    members, walk = [start], list(parts[start])
    waiting = deque(_edges(walk))
    while waiting:
        a, b = take(waiting)
        number = owner.get((b, a), start)
        if number in members or len(walk) + len(parts[number]) - 2 > GROUP_VERTICES:
            continue
        other = _rotated(parts[number], a)
        place = _edges(walk).index((a, b))
        walk[place + 1:place + 1] = other[1:-1]
        members.append(number)
        waiting.extend(_edges(other)[:-1])
    return members, walk


def _edges(ring):
    return list(zip(ring, [*ring[1:], ring[0]]))


def _merged_triangles(ground):
    """Hertel and Mehlhorn: a triangulation without the diagonals that no corner needs."""
    number_of = {point: number for number, point in enumerate(ground.points)}
    rings = [[ground.points[number] for number in ring] for ring in ground.rings]
    triangles = shapely.constrained_delaunay_triangles(shapely.Polygon(rings[0], rings[1:]))
    corners = [[(int(x), int(y)) for x, y in triangle.exterior.coords[:3]] for triangle in triangles.geoms]
    parts = {i: [number_of[corner] for corner in _positive(three)] for i, three in enumerate(corners)}
    owner = {edge: i for i, part in parts.items() for edge in _edges(part)}
    for a, b in sorted(owner, key=lambda edge: (-dist(ground.points[edge[0]], ground.points[edge[1]]), edge)):
        if (b, a) not in owner or a > b:
            continue
        one, other = owner[a, b], owner[b, a]
        joined = [*_rotated(parts[one], b), *_rotated(parts[other], a)[1:-1]]
        if one != other and _is_convex_at(ground, joined, a) and _is_convex_at(ground, joined, b):
            parts[one] = joined
            owner.update((edge, one) for edge in _edges(joined))
            del parts[other]
    return list(parts.values())


def _positive(ring):
    return ring if doubled_area(ring) > 0 else ring[::-1]


def _is_convex_at(ground, ring, number):
    place = ring.index(number)
    return cross(*(ground.points[ring[i % len(ring)]] for i in (place - 1, place, place + 1))) >= 0


def _cost(ground, costs, parts, kept=()):
    """Of a whole decomposition, or of parts with the cuts that they keep among them: as partition.cheapest counts it."""
    edges = {edge for part in parts for edge in _edges(part)}
    cuts = [(a, b) for a, b in edges if a < b and (b, a) in edges and (a, b) not in kept]
    length = sum(round(dist(ground.points[a], ground.points[b])) for a, b in cuts)
    return length + sum(costs.of_part([ground.points[number] for number in part]) for part in parts)


# ---- The parts

def _split(ground, part, most):
    """Halve a part of too many vertices, where the halves need the fewest cuts more, then by the shortest cut."""
    if len(part) <= most:
        return [part]
    corners = [ground.points[number] for number in part]
    swept = [0, *accumulate(a[0] * b[1] - a[1] * b[0] for a, b in _edges(corners))]
    best = (len(part),)
    for k in range(2, len(part)):
        for i in range(k - 1):
            (x, y), (to_x, to_y) = corners[k], corners[i]
            area = swept[k] - swept[i] + x * to_y - y * to_x
            if 0 < area < swept[-1]:
                cuts = (k - i - 2) // (most - 2) + (len(part) - k + i - 2) // (most - 2)
                best = min(best, (cuts, dist(corners[i], corners[k]), i, k))
    _, _, i, k = best
    return [piece for half in (part[i:k + 1], [*part[k:], *part[:i + 1]]) for piece in _split(ground, half, most)]


def _marked(ground, parts):
    """In reading order of the first vertices, each the uppermost, then leftmost of its part."""
    edges = {edge for part in parts for edge in _edges(part)}
    marked = []
    for part in parts:
        ring = _rotated(part, min(part, key=lambda number: ground.points[number][::-1]))
        internal = sum(1 << i for i, (a, b) in enumerate(_edges(ring)) if (b, a) in edges)
        marked.append(Part(tuple(ground.points[number] for number in ring), internal))
    return sorted(marked, key=lambda part: [vertex[::-1] for vertex in part.vertices])


# ---- Hulls, and what can be said of parts

def hull(points):
    """The convex hull of lattice points."""
    shell = shapely.MultiPoint(points).convex_hull
    if shell.geom_type != "Polygon":
        raise ShapeFault("the points lie in one line")
    ring = _positive([(int(x), int(y)) for x, y in shell.exterior.coords[:-1]])
    return Part(tuple(_rotated(ring, min(ring, key=lambda vertex: vertex[::-1]))))


def width(part):
    """The least distance of two parallel lines with the part between them, in lattice steps."""
    return partition.width(part.vertices)


def check(outline, parts, max_vertices=MOST_VERTICES):
    """AssertionError, with what and where, unless the parts are convex, fill the outline exactly and are marked rightly.

    Every edge of the outline is in one part, every other edge of a part is in another one with its ends swapped. So the
    parts' borders add up to the outline's, and with them how often each point is gone round: once inside, never
    outside. No part goes round a point less than 0 times, so they do not overlap."""
    for part in parts:
        _check_part(part, max_vertices)
    border = {edge for ring in outline.rings for edge in _edges(ring)}
    marks = {}
    for part in parts:
        for i, edge in enumerate(_edges(part.vertices)):
            assert edge not in marks, f"edge {edge} is in two parts"
            marks[edge] = bool(part.internal >> i & 1)
    assert border <= marks.keys(), f"edges of the outline without a part: {sorted(border - marks.keys())}"
    for (a, b), marked in marks.items():
        assert marked == ((a, b) not in border), f"edge {(a, b)} is marked {marked}"
        assert not marked or (b, a) in marks, f"internal edge {(a, b)} has no other side"
    for a, b in marks:
        for vertex in (vertex for ring in outline.rings for vertex in ring):
            assert not _is_between(a, vertex, b), f"vertex {vertex} lies on the edge {(a, b)}"
    total = sum(doubled_area(ring) for ring in outline.rings)
    assert sum(doubled_area(part.vertices) for part in parts) == total, "the areas do not add up"


def _check_part(part, max_vertices):
    corners = part.vertices
    assert 3 <= len(set(corners)) == len(corners) <= max_vertices, f"{len(corners)} vertices: {corners}"
    assert part.internal >> len(corners) == 0, f"marks beyond the last edge: {part}"
    assert doubled_area(corners) > 0, f"no area, or the wrong way round: {corners}"
    for a, b in _edges(corners):
        assert all(cross(a, b, c) >= 0 for c in corners), f"not convex at the edge {(a, b)}: {corners}"
    for a, b, c in zip(corners, [*corners[1:], *corners[:1]], [*corners[2:], *corners[:2]]):
        assert cross(a, b, c) > 0 or _is_between(a, b, c), f"turns back at {b}: {corners}"


def _is_between(a, b, c):
    return cross(a, b, c) == 0 and (a[0] - b[0]) * (c[0] - b[0]) + (a[1] - b[1]) * (c[1] - b[1]) < 0
