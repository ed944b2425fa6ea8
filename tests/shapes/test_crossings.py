# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Rings that cross, touch or fold back, against shapely on random rings of a coarse grid.
import random

import outlines
import shapely
from tuff_shapes.crossings import shoelace, touching, without_straight

HERE = "tests/shapes/test_crossings.py"


def some_ring(dice, size):
    ring = [(dice.randint(0, size), dice.randint(0, size)) for _ in range(dice.randint(3, 6))]
    return without_straight(ring)


def test_a_ring_is_simple_where_shapely_says_so():
    seen = set()
    for seed in outlines.seeds(2000):
        with outlines.repeatable(f"{HERE} -k simple_where", seed):
            ring = some_ring(random.Random(seed), 6)
            if len(ring) < 3:
                continue
            simple = shapely.LinearRing(ring).is_simple
            assert (not touching([ring])) == simple
            seen.add(simple)
    assert len(outlines.seeds(2000)) < 50 or seen == {True, False}


def test_two_rings_touch_where_shapely_says_so():
    for seed in outlines.seeds(2000):
        with outlines.repeatable(f"{HERE} -k two_rings", seed):
            dice = random.Random(seed)
            one, other = some_ring(dice, 9), some_ring(dice, 9)
            if len(one) < 3 or len(other) < 3:
                continue
            between = [touch for touch in touching([one, other]) if touch[0][0] != touch[1][0]]
            assert bool(between) == shapely.LinearRing(one).intersects(shapely.LinearRing(other))


def test_the_place_of_a_crossing_is_told():
    (first, second, place), = touching([[(0, 0), (4, 4), (4, 0), (0, 4)]])
    assert {first, second} == {(0, 0), (0, 2)} and place == (2.0, 2.0)


def test_straight_and_repeated_points_go():
    assert without_straight([(0, 0), (2, 0), (2, 0), (4, 0), (4, 4), (0, 4), (0, 2)]) == [(0, 0), (4, 0), (4, 4), (0, 4)]
    assert without_straight([(1, 1), (1, 1)]) == []
    assert len(without_straight([(0, 0), (2, 0), (4, 0)])) < 3


def test_twice_the_area_is_signed():
    assert shoelace([(0, 0), (4, 0), (4, 4), (0, 4)]) == 32
    assert shoelace([(0, 0), (0, 4), (4, 4), (4, 0)]) == -32
