# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Where a piece's position lies, and its circles.
import random
from fractions import Fraction

import made
import pytest
import shapely
from tuff_shapes import piece
from tuff_shapes.faults import ShapeFault
from tuff_shapes.model import Lattice, Outline, Part

LATTICE = Lattice()


def random_triangle(seed, reach=60000):
    """Corners with a positive area."""
    rng = random.Random(seed)
    while True:
        corners = [(rng.randint(-reach, reach), rng.randint(-reach, reach)) for _ in range(3)]
        area = piece.moments([Outline(corners)])[0]
        if area:
            return corners if area > 0 else corners[::-1]


@pytest.mark.parametrize("seed", range(50))
def test_the_center_of_area_is_the_nearest_lattice_point(seed):
    corners = random_triangle(seed)
    for axis, center in enumerate(piece.center_of_area([Outline(corners)])):
        assert abs(center - Fraction(sum(corner[axis] for corner in corners), 3)) <= Fraction(1, 2), f"seed {seed}: {corners}"


def test_a_hole_moves_the_center_away():
    ring = Outline([(0, 0), (100, 0), (100, 100), (0, 100)], [[(60, 20), (60, 80), (90, 80), (90, 20)]])
    polygon = shapely.Polygon(ring.exterior, ring.holes)
    assert piece.center_of_area([ring]) == (round(polygon.centroid.x), round(polygon.centroid.y))


def test_the_origin_is_what_the_author_chose():
    outline = Outline([(0, 0), (640, 0), (0, 640)])
    assert piece.origin("area", (20, 30), [outline], LATTICE) == (213, 213)
    assert piece.origin("center", (20, 30), [outline], LATTICE) == (640, 960)
    assert piece.origin((-1, 2.5), (20, 30), [outline], LATTICE) == (-64, 160)


@pytest.mark.parametrize("per_unit", [1, 64, 8192])
def test_the_circle_has_the_area_of_the_outline(per_unit):
    side = 100 * per_unit
    raw = piece.circle_raw(Outline([(0, 0), (side, 0), (side, side), (0, side)]), per_unit)
    assert raw == 3697473    # 100 / sqrt(pi) = 56.41895835... units


@pytest.mark.parametrize("seed", range(200))
def test_the_bounding_circle_covers_and_is_the_least_that_both_builds_hold(seed):
    corners = random_triangle(seed, reach=64 * 2 ** (seed % 11))
    raw = piece.bounding_raw([Part(tuple(corners))], (0, 0), 0, 64)
    farthest = max(x * x + y * y for x, y in corners) * 1024 ** 2
    assert raw * raw >= farthest, f"seed {seed}: {corners}"
    grain = 1 << max(0, raw.bit_length() - 24)
    assert raw % grain == 0 and (raw - 2 * grain) ** 2 < farthest, f"seed {seed}: {corners}"


def test_the_bounding_circle_covers_the_circle():
    assert piece.bounding_raw([Part(((0, 0), (64, 0), (0, 64)))], (0, 0), 3 * 65536, 64) == 3 * 65536
    assert piece.bounding_raw([], (0, 0), 5 * 65536, 64) == 5 * 65536


def test_a_shape_wider_than_any_position_allows_is_refused_with_a_scale_that_fits():
    with pytest.raises(ShapeFault, match=r"3000.0 units across, more than 2048: --scale 0.68 fits"):
        piece.check_span(made.square(0, 0, 3000), 1.0)
    piece.check_span(made.square(0, 0, 3000), 0.68)


def test_a_corner_too_far_from_the_position_is_refused():
    outline = Outline([(0, 0), (64 * 1500, 0), (0, 640)])
    with pytest.raises(ShapeFault, match=r"1500.0 units from the position, more than 1024: --scale 0.68 fits, or another --origin"):
        piece.check_extent(outline, (0, 0), LATTICE)
    piece.check_extent(outline, (64 * 750, 0), LATTICE)


def test_bytes_are_those_of_32_bit_machines():
    baked = made.bake(made.drawing(made.square(0, 0, 10)), made.options())[0]
    assert piece.rom_bytes(baked) == 4 * 16 + 16 + 24
