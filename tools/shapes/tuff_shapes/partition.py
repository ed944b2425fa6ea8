# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The cheapest cut of a polygon without holes into convex parts, by dynamic programming over its diagonals (after
# Keil, "Decomposing a polygon into simpler components", 1985). The polygon may pass a line twice, there and back:
# that is how one with holes is laid open. Fewest parts come first, then fewest slivers, then the least length of cuts.
import bisect
from dataclasses import dataclass
from math import dist
from typing import NamedTuple

import numpy as np

from .diagonals import cross

PART = 1 << 44      # the cost of one part; a length of cuts, in whole steps, stays far below
SLIVER = 1 << 36    # what a sliver adds where a part more is no way out of it
SLENDER = 48        # a part longer than so many times its width is a sliver


@dataclass(frozen=True)
class Costs:
    """What makes one cut dearer than another. Lengths are lattice steps."""

    thin: float               # a part of less width is a sliver; 0: none is, whatever its form
    sliver: int = SLIVER

    def of_part(self, corners):
        return PART + (self.sliver if self.is_sliver(corners) else 0)

    def is_sliver(self, corners):
        if not self.thin:
            return False
        longest = max(dist(a, b) for a, b in zip(corners, [*corners[1:], corners[0]]))
        return width(corners) < max(self.thin, longest / SLENDER)


def width(corners):
    """The least distance of two parallel lines with a convex polygon between them: one of them lies along an edge."""
    edges = zip(corners, [*corners[1:], corners[0]])
    return min(max(cross(a, b, c) for c in corners) / dist(a, b) for a, b in edges)


class Chain(NamedTuple):
    """A convex run of a part's vertices, from its first place i on; the rest of the part is still open."""

    cost: int            # of everything that its edges cut off
    end: int             # its last place
    back: "Chain | None"
    dx: int              # its last edge
    dy: int
    first_dx: int        # its first edge; (0, 0) where i is not reflex, so that no angle there is too large
    first_dy: int


class Polygon:
    """A closed walk along border and cuts with the solid on one side, by the vertices' numbers in their Ground."""

    def __init__(self, ground, walk):
        self.count = len(walk)
        self.walk = walk
        self.corners = [ground.points[number] for number in walk]
        self.is_reflex = [cross(self.corners[i - 1], self.corners[i], self.corners[(i + 1) % self.count]) < 0 for i in range(self.count)]
        self.sees = _visibility(ground, walk)
        self.useful = self.sees & (np.array(self.is_reflex)[:, None] | np.array(self.is_reflex)[None, :])
        self.reaches = _reach(self.corners, self.sees)

    @property
    def work(self):
        """Steps of the program below: triples of places in a row that may be vertices of one part."""
        reaches = np.triu(self.reaches, 1).astype(np.float32)
        useful = np.triu(self.useful | np.eye(self.count, k=1, dtype=bool)).astype(np.float32)
        return int(((reaches @ useful) * reaches).sum())


def _visibility(ground, walk):
    """A vertex that the walk passes twice has two places; each sees only what lies between its own two borders."""
    numbers = np.array(walk)
    sees = ground.sees[np.ix_(numbers, numbers)]
    places = range(len(walk))
    between = np.array([ground.within(walk[i - 1], walk[i], walk[(i + 1) % len(walk)])[numbers] for i in places])
    sees &= between & between.T
    cuts = {tuple(sorted((walk[i - 1], walk[i]))) for i in places if not ground.is_border(walk[i - 1], walk[i])}
    for a, b in sorted(cuts):
        sees &= ~ground.crossing(a, b, numbers)
    return sees


def _reach(corners, sees):
    """Which places can be vertices of one part: they see each other, or are ends of an edge, or of such lines one after
    the other without a bend."""
    points = np.array(corners)
    reaches = sees | np.roll(np.eye(len(points), dtype=bool), 1, axis=1) | np.roll(np.eye(len(points), dtype=bool), 1, axis=0)
    starts, ends = np.nonzero(reaches)
    along = points[ends] - points[starts]
    for i, row in enumerate(reaches):
        to = points[starts] - points[i]
        ahead = (to[:, 0] * along[:, 1] == to[:, 1] * along[:, 0]) & ((to * along).sum(axis=1) > 0)
        before = 0
        while before < row.sum():
            before = row.sum()
            row[ends[ahead & row[starts]]] = True
    return reaches


def cheapest(polygon, costs):
    """(cost, parts) of the polygon's cheapest convex decomposition; a part is a list of vertex numbers."""
    cuts = _Cuts(polygon, costs)
    for i in range(polygon.count - 2, -1, -1):
        _fan(cuts, i)
    last = polygon.count - 1
    return cuts.cost[0][last], list(_parts(cuts, 0, last))


class _Cuts:
    """cost[i][k]: the least cost of all that the diagonal from i to k cuts off, the places i to k; closed_by[i][k]: the
    chain of the part along it. That part has i as its first and k as its last place, so it is a chain from i; whether a
    chain can go on depends on nothing but its end, its last and its first edge.
    A diagonal between two corners that are not reflex can be left out of any decomposition, so it is not looked at."""

    def __init__(self, polygon, costs):
        places = range(polygon.count)
        self.costs = costs
        self.polygon = polygon
        self.cost = [{i + 1: 0} for i in places]
        self.closed_by = [{} for _ in places]
        self.reaches = polygon.reaches.tolist()
        self.ahead = [[k for k in places[i + 1:] if k == i + 1 or polygon.useful[i, k]] for i in places]
        self.closes = [set(ahead) - {i + 1} for i, ahead in enumerate(self.ahead)]
        self.closes[0].add(polygon.count - 1)


def _fan(cuts, i):
    """Grow all chains from i, place by place, and close them with the diagonals from i. The edge or diagonal to a place
    is a chain to it as well, the one that can go on in most ways."""
    arriving = [[] for _ in range(cuts.polygon.count)]
    for k in range(i + 1, cuts.polygon.count):
        chains = sorted(arriving[k], key=_cost)
        if chains and k in cuts.closes[i]:
            _close(cuts, i, k, chains)
        if k in cuts.cost[i]:
            bisect.insort(chains, _first(cuts, i, k), key=_cost)
        if chains:
            _lengthen(cuts, i, k, _undominated(chains), arriving)


def _first(cuts, i, k):
    (x, y), (to_x, to_y) = cuts.polygon.corners[i], cuts.polygon.corners[k]
    edge = to_x - x, to_y - y
    return Chain(cuts.cost[i][k], k, None, *edge, *(edge if cuts.polygon.is_reflex[i] else (0, 0)))


def _lengthen(cuts, i, k, chains, arriving):
    """Add each edge and diagonal from k that turns the right way and leaves an angle at i of at most 180 degrees."""
    corners, reaches, cost_of, reflex = cuts.polygon.corners, cuts.reaches[i], cuts.cost[k], cuts.polygon.is_reflex[i]
    (x, y), (at_x, at_y) = corners[i], corners[k]
    for m in cuts.ahead[k]:
        if not reaches[m]:
            continue
        to_x, to_y = corners[m]
        edge_x, edge_y, from_x, from_y = to_x - at_x, to_y - at_y, to_x - x, to_y - y
        for chain in chains:
            cost, _, _, dx, dy, first_dx, first_dy = chain
            if dx * edge_y >= dy * edge_x and first_dx * from_y >= first_dy * from_x:
                arriving[m].append(Chain(cost + cost_of[m], m, chain, edge_x, edge_y, first_dx, first_dy))
                if not reflex:
                    break    # what follows is dearer


def _undominated(chains):
    """Of chains to the same end, cheapest first, those that may still be the best: a cheaper one beats all that it can
    stand in for. One that comes straight back towards the first place goes on in no other way, and stands in for no
    other. That the one beaten might end as the fatter part is left out of account."""
    kept = []
    for chain in chains:
        _, _, _, dx, dy, first_dx, first_dy = chain
        for _, _, _, better_dx, better_dy, better_first_dx, better_first_dy in kept:
            turn = better_dx * dy - better_dy * dx
            if ((turn > 0 or turn == 0 and better_dx * dx + better_dy * dy > 0)
                    and first_dx * better_first_dy >= first_dy * better_first_dx):
                break
        else:
            kept.append(chain)
    return kept


def _cost(chain):
    return chain.cost


def _close(cuts, i, k, chains):
    """The cheapest part along the diagonal from i to k, of chains in order of cost. Its length is a cut's, unless it is
    the edge that the whole program ends with."""
    corners = cuts.polygon.corners
    x, y = corners[i][0] - corners[k][0], corners[i][1] - corners[k][1]
    length = 0 if (i, k) == (0, cuts.polygon.count - 1) else round(dist(corners[i], corners[k]))
    least = cuts.cost[i].get(k)
    for chain in chains:
        if least is not None and chain.cost + length + PART >= least:
            break
        if chain.dx * y < chain.dy * x or chain.first_dy * x < chain.first_dx * y:
            continue
        cost = chain.cost + length + cuts.costs.of_part([corners[place] for place in _places(chain, i)])
        if least is None or cost < least:
            least = cuts.cost[i][k] = cost
            cuts.closed_by[i][k] = chain


def _places(chain, i):
    places = []
    while chain:
        places.append(chain.end)
        chain = chain.back
    return [i, *reversed(places)]


def _parts(cuts, i, k):
    """The part along the diagonal from i to k, and all that its other edges cut off."""
    open_edges = [(i, k)]
    while open_edges:
        i, k = open_edges.pop()
        places = _places(cuts.closed_by[i][k], i)
        yield [cuts.polygon.walk[place] for place in places]
        open_edges += [(a, b) for a, b in zip(places, places[1:]) if b > a + 1]
