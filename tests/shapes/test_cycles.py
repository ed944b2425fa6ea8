# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The cheapest of the shortest closed paths, against every path there is.
import itertools
import random

import numpy as np
import outlines
from tuff_shapes.cycles import Ring, cheapest_cycle

HERE = "tests/shapes/test_cycles.py"


def ring_of(columns, width, edges):
    ordered = np.array(sorted(edges), dtype=np.int64).reshape(-1, 2)
    return Ring(columns, width, ordered[:, 0], ordered[:, 1])


def some_ring(dice):
    """Columns of one to three candidates, and edges onward at random."""
    columns, width = dice.randint(3, 7), dice.randint(1, 3)
    likely = dice.choice((0.15, 0.3, 0.6))
    nodes = range(columns * width)
    pairs = [(a, b) for a in nodes for b in nodes if a // width != b // width and dice.random() < likely]
    return columns, width, {pair: dice.randint(0, 9) for pair in pairs}


def once_round(path, columns, width):
    onward = sum((b // width - a // width) % columns for a, b in zip(path, path[1:] + path[:1]))
    return onward == columns


def shortest(columns, width, cost):
    """The fewest nodes of a closed path; None if there is none. Every path is tried."""
    for count in range(2, columns + 1):
        for chosen in itertools.combinations(range(columns), count):
            for which in itertools.product(range(width), repeat=count):
                path = [column * width + candidate for column, candidate in zip(chosen, which)]
                if all(edge in cost for edge in zip(path, path[1:] + path[:1])):
                    return count
    return None


def test_no_closed_path_has_fewer_edges():
    for seed in outlines.seeds(300):
        with outlines.repeatable(f"{HERE} -k fewer_edges", seed):
            columns, width, cost = some_ring(random.Random(seed))
            path = cheapest_cycle(ring_of(columns, width, cost), lambda source, target: np.zeros(len(source)))
            assert (len(path) or None) == shortest(columns, width, cost)
            assert not path or once_round(path, columns, width)


def test_the_cost_is_the_least_through_the_half_way_node():
    for seed in outlines.seeds(300):
        with outlines.repeatable(f"{HERE} -k least_through", seed):
            columns, width, cost = some_ring(random.Random(seed))
            path = cheapest_cycle(ring_of(columns, width, cost),
                                  lambda source, target: np.array([cost[pair] for pair in zip(source.tolist(), target.tolist())]))
            if path:
                assert total(path, cost) == least_total(path[0], len(path), columns, width, cost)


def total(path, cost):
    return sum(cost[edge] for edge in zip(path, path[1:] + path[:1]))


def least_total(start, count, columns, width, cost):
    """Of all closed paths with that many nodes through one node."""
    others = [[((start // width + step) % columns) * width + own for own in range(width)] for step in range(1, columns)]
    paths = ([start, *rest] for chosen in itertools.combinations(others, count - 1) for rest in itertools.product(*chosen))
    return min(total(path, cost) for path in paths if all(edge in cost for edge in zip(path, path[1:] + path[:1])))


def test_edges_taken_out_are_not_used():
    edges = {(0, 1), (1, 2), (2, 0), (0, 2), (2, 3), (3, 0)}
    ring = ring_of(4, 1, edges)
    assert len(cheapest_cycle(ring, lambda source, target: np.zeros(len(source)))) == 2
    place = int(np.flatnonzero((ring.source == 0) & (ring.target == 2))[0])
    assert len(cheapest_cycle(ring.without([place]), lambda source, target: np.zeros(len(source)))) == 3
