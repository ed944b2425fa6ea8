# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# From drawing to pieces: which corners stay, which model is made, what is refused.
from math import cos, pi, sin

import made
import pytest
from tuff_shapes import pipeline
from tuff_shapes.faults import ShapeFault

ELL = made.region([(4, 4), (20, 4), (20, 40), (60, 40), (60, 60), (4, 60)])


def disc(corners, radius=40, center=48):
    turns = [2 * pi * i / corners for i in range(corners)]
    return made.region([(center + radius * cos(turn), center + radius * sin(turn)) for turn in turns])


def corners_of(baked):
    return {vertex for part in baked.parts for vertex in part.vertices}


def test_corners_set_by_hand_are_kept():
    baked, = made.bake(made.drawing(ELL), made.options())
    assert corners_of(baked) == {(int(x) * 64, int(y) * 64) for x, y in ELL.exterior} and baked.deviation.largest == 0


def test_corners_set_by_hand_give_way_to_a_tolerance_or_a_budget():
    round_shape = made.drawing(disc(64))
    assert len(made.bake(round_shape, made.options())[0].outline.exterior) == 64
    loose, = made.bake(round_shape, made.options(tolerance=1.0))
    assert len(loose.outline.exterior) < 16 and loose.deviation.largest <= 1.0
    assert len(made.bake(round_shape, made.options(vertices=7))[0].outline.exterior) <= 7


def test_a_traced_drawing_is_simplified_to_one_pixel():
    baked, = made.bake(made.drawing(disc(64), exact=False), made.options())
    assert len(baked.outline.exterior) < 16 and 0 < baked.deviation.largest <= 1.0


def test_the_hull_is_one_convex_part():
    baked, = made.bake(made.drawing(ELL), made.options(model="hull"))
    assert len(baked.parts) == 1 and corners_of(baked) == {(x * 64, y * 64) for x, y in [(4, 4), (20, 4), (60, 40), (60, 60), (4, 60)]}
    assert baked.parts[0].internal == 0
    assert baked.deviation.largest == pytest.approx(20, abs=1e-3)    # from the notch's floor to the bottom


def test_the_hull_of_a_ring_is_measured_from_its_exterior():
    ring = made.region(disc(24).exterior, disc(12, 15).exterior[::-1])
    baked, = made.bake(made.drawing(ring), made.options(model="hull"))
    assert baked.deviation.largest < 0.02 and baked.outline.holes == []


def test_a_hull_takes_a_budget():
    baked, = made.bake(made.drawing(disc(64)), made.options(model="hull", vertices=6))
    assert len(baked.parts[0].vertices) <= 6


def test_a_hull_with_too_many_corners_is_refused():
    with pytest.raises(ShapeFault, match="the hull has 64 vertices, more than 32"):
        made.bake(made.drawing(disc(64, 400, 400)), made.options(model="hull"))


def test_the_circle_has_no_parts_and_its_error_is_measured():
    baked, = made.bake(made.drawing(made.square(10, 10, 40)), made.options(model="circle"))
    radius = 40 / pi ** 0.5
    assert baked.parts == [] and baked.radius_raw == baked.bounding_raw == round(radius * 65536)
    assert baked.deviation.largest == pytest.approx(20 * 2 ** 0.5 - radius, abs=2e-3)


def test_islands_lie_about_their_own_centers_and_a_single_one_where_the_author_says():
    together = made.bake(made.drawing(made.square(0, 0, 10), made.square(30, 20, 10)), made.options(origin="center"))
    assert [baked.origin for baked in together] == [(320, 320), (35 * 64, 25 * 64)]
    assert [baked.name for baked in together] == ["0", "1"]
    drawing = made.drawing(made.square(0, 0, 10), made.square(30, 20, 10))
    assert pipeline.origin_of(drawing, together, made.options(origin="area")) == (20 * 64, 15 * 64)
    assert pipeline.origin_of(drawing, together, made.options(origin="center")) == (32 * 64, 32 * 64)
    alone, = made.bake(made.drawing(made.square(30, 20, 10)), made.options(origin=(1.0, 2.0)))
    assert alone.origin == (64, 128)


def test_a_fault_says_where():
    far = made.drawing(made.square(0, 0, 10), made.square(0, 20, 5000), place="frame 3")
    with pytest.raises(ShapeFault, match="^frame 3, island 1: the shape is 5000.0 units across"):
        made.bake(far, made.options())
