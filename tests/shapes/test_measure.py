# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The deviation between border and outline: known cases, and random ones against dense sampling.
import borders
import numpy as np
import outlines
import pytest
import shapely
from tuff_shapes import measure, simplify
from tuff_shapes.model import Lattice, Outline, Region

HERE = "tests/shapes/test_measure.py"
LATTICE = Lattice()
SQUARE = np.array([(0, 0), (8, 0), (8, 8), (0, 8)], dtype=np.float64)


def in_steps(ring):
    return [tuple(point) for point in LATTICE.nearest(ring).tolist()]


def test_an_outline_on_the_border_has_no_deviation():
    assert measure.deviation(Region(SQUARE), Outline(in_steps(SQUARE)), LATTICE).largest == 0.0


def test_a_corner_cut_off_is_as_far_as_the_corner():
    found = measure.deviation(Region(SQUARE), Outline(in_steps([(0, 0), (8, 0), (8, 6), (6, 8), (0, 8)])), LATTICE)
    assert found.largest == pytest.approx(2 ** 0.5, abs=1e-6)
    assert found.spot == (8.0, 8.0)
    assert found.mean == pytest.approx((4 * 2 ** 0.5 / 2) / 32, abs=1e-3)


def test_a_spike_of_the_outline_counts_though_the_border_is_near_everywhere():
    found = measure.deviation(Region(SQUARE), Outline(in_steps([(0, 0), (4, 0), (4.25, -3), (4.5, 0), (8, 0), (8, 8), (0, 8)])), LATTICE)
    assert found.largest == pytest.approx(3.0, abs=1e-6)
    assert found.spot == (4.25, -3.0)


def test_the_farthest_point_may_lie_inside_an_edge():
    """The dent's corners are 1 from the square's sides, the middle of its floor is 4 from all of them."""
    found = measure.deviation(Region(SQUARE), Outline(in_steps([(0, 0), (1, 4), (7, 4), (8, 0), (8, 8), (0, 8)])), LATTICE)
    assert found.largest == pytest.approx(4.0, abs=1e-5)
    assert found.spot == pytest.approx((4.0, 4.0), abs=1e-3)


def test_every_ring_counts():
    hole = SQUARE[::-1] / 4 + 3
    moved = in_steps(hole + (0.5, 0))
    assert measure.deviation(Region(SQUARE, [hole]), Outline(in_steps(SQUARE), [moved]), LATTICE).largest == 0.5


def sampled(one, other, pitch=0.01):
    """Both directed distances between rings by points every hundredth of a pixel."""
    one, other = shapely.LinearRing(one), shapely.LinearRing(other)
    dense = [shapely.points(shapely.get_coordinates(shapely.segmentize(ring, pitch))) for ring in (one, other)]
    return max(shapely.distance(dense[0], other).max(), shapely.distance(dense[1], one).max())


def test_random_outlines_measure_as_dense_sampling_does():
    for seed in outlines.seeds(20):
        with outlines.repeatable(f"{HERE} -k random_outlines", seed):
            region = borders.blob(seed, 48)
            outline = simplify.outline(region, 0.6 + seed % 5, LATTICE)
            found = measure.deviation(region, outline, LATTICE)
            brute = max(sampled(border, LATTICE.pixels(ring)) for border, ring in zip(region.rings, outline.rings))
            assert brute - 1e-6 <= found.largest <= brute + 0.006
            assert at_spot(region, outline, found.spot) == pytest.approx(found.largest, abs=1e-6)
            assert found.mean == pytest.approx(mean_sampled(region, outline), abs=1e-3)


def at_spot(region, outline, spot):
    """The larger of the distances of a place from border and outline: it lies on one of them."""
    pairs = [(shapely.LinearRing(border), shapely.LinearRing(LATTICE.pixels(ring))) for border, ring in zip(region.rings, outline.rings)]
    place = shapely.Point(spot)
    return min(max(border.distance(place), ring.distance(place)) for border, ring in pairs)


def mean_sampled(region, outline):
    total, length = 0.0, 0.0
    for border, ring in zip(region.rings, outline.rings):
        line = shapely.LinearRing(border)
        places = shapely.line_interpolate_point(line, np.arange(0.005, line.length, 0.01))
        total += shapely.distance(places, shapely.LinearRing(LATTICE.pixels(ring))).mean() * line.length
        length += line.length
    return total / length
