# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The closed path with the fewest edges through columns of nodes that stand in a circle and, among these, the one of
# least cost. Node n is candidate n % width of column n // width; an edge goes onward by less than a whole lap.
import numpy as np

FAR = 1 << 30    # more edges than any path has: no way there
BATCH = 16       # starts of a search that are followed together


class Ring:
    """The columns and the edges between them: source[e] -> target[e], in order of source."""

    def __init__(self, columns, width, source, target):
        self.columns, self.width = columns, width
        self.nodes = columns * width
        self.source, self.target = source, target
        self.length = target - source + self.nodes * (target // width <= source // width)

    def without(self, edges):
        """The ring without some of its edges, given by their places in source and target."""
        return Ring(self.columns, self.width, np.delete(self.source, edges), np.delete(self.target, edges))

    def beside(self, source, target, columns):
        """Places of the edges that begin and end within some columns of those of an edge from node to node."""
        start = (self.source // self.width - source // self.width + columns) % self.columns
        end = (self.target // self.width - target // self.width + columns) % self.columns
        return np.flatnonzero((start <= 2 * columns) & (end <= 2 * columns))


class Lap:
    """The ring cut open before a column and rolled out: nodes count on from there, those of the next lap after them."""

    def __init__(self, size, source, target):
        self.size, self.source, self.target = size, source, target

    @classmethod
    def of(cls, ring, cut, window):
        """The lap goes on for window columns of the next one, so that a path may end where it began."""
        split, end = np.searchsorted(ring.source, [cut * ring.width, (cut + window) * ring.width])
        again = max(0, int(np.searchsorted(ring.source, (cut + window - ring.columns) * ring.width)))
        parts = ((slice(split, None), 0), (slice(0, split), ring.nodes), (slice(split, end), ring.nodes), (slice(0, again), 2 * ring.nodes))
        source = np.concatenate([ring.source[part] + (lap - cut * ring.width) for part, lap in parts])
        target = source + np.concatenate([ring.length[part] for part, _ in parts])
        size = ring.nodes + window * ring.width
        return cls(size, source, target).only(target < size)

    def only(self, edges):
        """The lap with some of its edges."""
        return Lap(self.size, self.source[edges], self.target[edges])

    def forward(self, starts):
        """Fewest edges to each node, one row for each start."""
        layer = self.size * np.arange(len(starts))
        return breadth_first(self.source, self.target, self.size, starts + layer, len(starts))

    def forward_from_any(self, starts):
        return breadth_first(self.source, self.target, self.size, starts, 1)[0]

    def backward_from_any(self, ends):
        """Fewest edges from each node to the nearest end."""
        order = np.argsort(self.target, kind="stable")
        return breadth_first(self.target[order], self.source[order], self.size, ends, 1)[0]


def breadth_first(source, target, size, frontier, layers):
    """counts[layer, node]: fewest edges from the frontier, whose nodes are counted on through the layers."""
    pointers = np.searchsorted(source, np.arange(size + 1))
    counts = np.full(size * layers, FAR)
    mark = np.zeros(len(counts), dtype=np.int64)
    level = 0
    while len(frontier):
        counts[frontier] = level
        node = frontier % size
        length = pointers[node + 1] - pointers[node]
        edge = np.arange(length.sum()) + np.repeat(pointers[node] - np.cumsum(length) + length, length)
        reached = np.repeat(frontier - node, length) + target[edge]
        reached = reached[counts[reached] == FAR]
        mark[reached] = np.arange(len(reached))
        frontier = reached[mark[reached] == np.arange(len(reached))]
        level += 1
    return counts.reshape(-1, size)


def cheapest_cycle(ring, costs):
    """Nodes of the closed path, [] if there is none. costs(sources, targets) of edges, to be summed.

    A start is found for which the number of edges is least. The path of least cost through it gives another start,
    half a lap away; the path through that may be better yet where the first start was an unlucky one.
    """
    start = best_start(ring)
    if start is None:
        return []
    path = cheapest_from(ring, start, costs)
    return cheapest_from(ring, path[len(path) // 2], costs)


def narrowest_window(ring):
    """(column, width): a run of columns that no edge jumps over, so that every path has a node in it."""
    columns = ring.columns
    start, end = ring.source // ring.width, ring.target // ring.width
    landing = np.arange(columns)
    np.maximum.at(landing, start, end + columns * (end <= start))
    landing = np.maximum.accumulate(np.concatenate([landing, landing + columns]))
    jump = landing[columns - 1:-1] - np.arange(columns, 2 * columns) + 1
    cut = int(np.argmin(jump))
    return cut, int(np.clip(jump[cut], 1, columns))


def best_start(ring):
    """A node through which a path with the fewest edges goes; None if there is no closed path.

    The fewest edges from anywhere in the window to anywhere in the next lap's window bound every closed path from
    below. That many edges are tried, then one more at a time, from a few starts at a time; edges that are on no path
    of so few are left out.
    """
    cut, window = narrowest_window(ring)
    lap = Lap.of(ring, cut, window)
    starts = np.unique(lap.source[lap.source < window * ring.width])
    onward, back = lap.forward_from_any(starts), lap.backward_from_any(starts + ring.nodes)
    through = onward[lap.source] + 1 + back[lap.target]
    bound = np.maximum(onward[starts + ring.nodes], back[starts])
    for count in range(bound.min(initial=FAR), ring.columns + 1):
        short = lap.only(through <= count)
        for some in batches(starts[bound <= count], BATCH):
            closed = short.forward(some)[np.arange(len(some)), some + ring.nodes]
            if closed.min() <= count:
                return (int(some[np.argmin(closed)]) + cut * ring.width) % ring.nodes
    return None


def batches(starts, size):
    return [starts[first:first + size] for first in range(0, len(starts), size)]


def cheapest_from(ring, start, costs):
    """The path with the fewest edges through a node, of those the one of least cost."""
    cut = start // ring.width
    first, last = start - cut * ring.width, start - cut * ring.width + ring.nodes
    lap = Lap.of(ring, cut, 1)
    onward = lap.forward_from_any(np.array([first]))
    lap = lap.only(onward[lap.source] + 1 == onward[lap.target])
    lap = lap.only(lap.backward_from_any(np.array([last]))[lap.target] < FAR)
    cost = costs((lap.source + cut * ring.width) % ring.nodes, (lap.target + cut * ring.width) % ring.nodes)
    before = cheapest_sources(lap, onward[lap.source], cost)
    path = [last]
    while path[-1] != first:
        path.append(before[path[-1]])
    return [(node + cut * ring.width) % ring.nodes for node in reversed(path[1:])]


def cheapest_sources(lap, level, cost):
    """For each node on a shortest path the node to come from, level by level."""
    total, before = np.zeros(lap.size), {}
    order = np.argsort(level, kind="stable")
    for edges in np.split(order, np.flatnonzero(np.diff(level[order])) + 1):
        sums = total[lap.source[edges]] + cost[edges]
        ranked = np.lexsort((sums, lap.target[edges]))
        target = lap.target[edges][ranked]
        best = ranked[np.append(True, np.diff(target) != 0)]
        total[lap.target[edges[best]]] = sums[best]
        before.update(zip(lap.target[edges[best]].tolist(), lap.source[edges[best]].tolist()))
    return before
