# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The cut into convex parts: against an exhaustive search for the fewest, against what libraries make of the same outlines,
# and on shapes set by hand. convex.check() says of each result that it is right; here it is shown that it can say no.
import time
from collections import Counter
from dataclasses import replace
from math import dist

import outlines
import pymunk.autogeometry
import pytest
import shapely
from fewest_parts import fewest_parts, merged_triangles
from outlines import boxes, outline, regular, repeatable, seeds
from tuff_shapes import convex
from tuff_shapes.faults import ShapeFault
from tuff_shapes.model import Outline, Part

HERE = "tests/shapes/test_convex.py"


def decomposed(shape, **options):
    parts = convex.decompose(shape, **options)
    convex.check(shape, parts)
    return parts


def excess(counts):
    return ", ".join(f"{number} with {more} more" if more else f"{number} with the fewest" for more, number in sorted(counts.items()))


# ---- How few

def small(seed):
    """Without holes; every second one on a grid of 8 x 8, where many corners are in line."""
    return outlines.tangle(seed, 6 + seed % 7, 8 if seed % 2 else 40)


def small_with_holes(seed):
    corners, holes, hole_corners = ((7, 1, 6), (6, 1, 5), (5, 2, 3), (6, 2, 4), (5, 1, 3))[seed % 5]
    return outlines.with_holes(seed, corners, holes, hole_corners, 8 * (1 + holes) if seed % 2 else 50)


def test_no_decomposition_without_holes_has_fewer_parts(figures):
    for seed in seeds(400):
        with repeatable(f"{HERE} -k without_holes_has_fewer", seed):
            shape = small(seed)
            assert len(decomposed(shape, thin=0)) == fewest_parts(shape)
    figures(f"convex parts: {len(seeds(400))} outlines of 6 to 12 vertices, all with the fewest of an exhaustive search")


def test_with_holes_there_are_at_most_a_third_more_parts_than_needed(figures):
    counts = Counter()
    for seed in seeds(60):
        with repeatable(f"{HERE} -k with_holes_there_are", seed):
            shape = small_with_holes(seed)
            parts, fewest = len(decomposed(shape, thin=0)), fewest_parts(shape)
            assert fewest <= parts <= fewest * 4 / 3
            counts[parts - fewest] += 1
    figures(f"convex parts: {sum(counts.values())} outlines with one or two holes, against exhaustive search: {excess(counts)}")


def test_three_holes_are_cut_into_at_most_a_third_more_parts_than_needed():
    room = [(0, 0), (1200, 0), (1200, 600), (0, 600)]
    holes = [regular(3, 100, 200, 300), regular(3, 120, 550, 280), regular(3, 110, 950, 310)]
    shape = outline(room, *holes)
    fewest = fewest_parts(shape)
    assert fewest <= len(decomposed(shape)) <= fewest * 4 / 3


def test_outlines_too_large_for_the_exact_program_have_at_most_a_third_more_parts(monkeypatch, figures):
    monkeypatch.setattr(convex, "MOST_WORK", 0)
    counts = Counter()
    for seed in seeds(60):
        with repeatable(f"{HERE} -k too_large_for", seed):
            shape = small_with_holes(seed) if seed % 3 else small(seed)
            parts, fewest = len(decomposed(shape, thin=0)), fewest_parts(shape)
            assert fewest <= parts <= fewest * 4 / 3
            counts[parts - fewest] += 1
    figures(f"convex parts: {sum(counts.values())} small outlines cut in groups as large ones are, against exhaustive search: "
            f"{excess(counts)}")


def test_large_outlines_cut_in_groups_come_near_the_exact_program(monkeypatch, figures):
    exact, grouped = 0, 0
    for seed in seeds(6):
        with repeatable(f"{HERE} -k come_near", seed):
            shape = outlines.blob(seed, 60 + 8 * seed)
            monkeypatch.setattr(convex, "MOST_WORK", 1 << 40)
            fewest = len(decomposed(shape, thin=0))
            monkeypatch.setattr(convex, "MOST_WORK", 0)
            parts = len(decomposed(shape, thin=0))
            assert fewest <= parts <= fewest * 4 / 3
            exact, grouped = exact + fewest, grouped + parts
    figures(f"convex parts: blobs of 68 to 108 vertices: {exact} parts by the exact program, {grouped} cut in groups")


def test_a_part_more_is_taken_to_avoid_slivers_but_no_more_than_a_third(figures):
    before, after, more = 0, 0, 0
    for seed in seeds(60):
        with repeatable(f"{HERE} -k avoid_slivers", seed):
            shape = outlines.blob(seed, 16 + seed % 20, radius=64 * 12, roughness=0.3)
            fewest, parts = decomposed(shape, thin=0), decomposed(shape)
            assert len(parts) <= len(fewest) * 4 / 3
            assert slivers(parts) <= slivers(fewest)
            before, after, more = before + slivers(fewest), after + slivers(parts), more + len(parts) - len(fewest)
    figures(f"convex parts: slivers (below 1/2 px, or 48 times as long as wide) in jagged blobs 24 px wide: {before} with the fewest parts "
            f"whatever their form, {after} as cut, with {more} parts more")


def slivers(parts):
    return sum(convex.width(part) < max(32, longest_edge(part) / 48) for part in parts)


def longest_edge(part):
    return max(dist(a, b) for a, b in zip(part.vertices, part.vertices[1:] + part.vertices[:1]))


def test_a_sliver_is_avoided_where_another_diagonal_does_as_well():
    """From the notch, the near corner is 6 steps beside the side's end; the far one leaves two fat parts."""
    shape = outline([(0, 0), (2000, 0), (2000, 1000), (1994, 1000), (1000, 990), (0, 1000)])
    parts = decomposed(shape)
    assert len(parts) == 2
    assert min(map(convex.width, parts)) > 500


# ---- Against the libraries

def test_there_are_fewer_parts_than_the_libraries_make(figures):
    ours, pymunks, triangles = 0, 0, 0
    for seed in seeds(40):
        with repeatable(f"{HERE} -k libraries_make", seed):
            shape = outlines.blob(seed, 20 + seed % 21)
            fewest = decomposed(shape, thin=0)
            merged = merged_triangles(shape)
            assert len(fewest) <= merged
            ours, triangles = ours + len(fewest), triangles + merged
            pymunks += len(pymunk.autogeometry.convex_decomposition([*shape.exterior, shape.exterior[0]], 0))
    assert ours < triangles or len(seeds(40)) < 5
    figures(f"convex parts: {len(seeds(40))} blobs of 20 to 40 vertices: {ours} parts; pymunk.autogeometry.convex_decomposition {pymunks}; "
            f"shapely's constrained Delaunay triangles, merged (Hertel-Mehlhorn) {triangles}")


# ---- Shapes

LETTERS = {
    "L": boxes((0, 0, 1, 5), (0, 4, 4, 5)),
    "T": boxes((0, 0, 5, 1), (2, 0, 3, 5)),
    "H": boxes((0, 0, 1, 5), (3, 0, 4, 5), (0, 2, 4, 3)),
    "E": boxes((0, 0, 1, 5), (0, 0, 4, 1), (0, 2, 3, 3), (0, 4, 4, 5)),
    "C": boxes((0, 0, 1, 5), (0, 0, 4, 1), (0, 4, 4, 5)),
    "S": boxes((0, 0, 4, 1), (0, 0, 1, 3), (0, 2, 4, 3), (3, 2, 4, 5), (0, 4, 4, 5)),
    "O": boxes((0, 0, 1, 5), (3, 0, 4, 5), (0, 0, 4, 1), (0, 4, 4, 5)),
    "P": boxes((0, 0, 1, 5), (2, 0, 3, 3), (0, 0, 3, 1), (0, 2, 3, 3)),
    "plus": boxes((1, 0, 2, 3), (0, 1, 3, 2)),
    "star": outlines.star(5, 2048, 900),
    "arrow": outline([(0, 400), (1000, 400), (1000, 0), (2000, 700), (1000, 1400), (1000, 1000), (0, 1000)]),
    "comb": outlines.comb(3),
    "spiral": outlines.spiral(1),
}


@pytest.mark.parametrize("name", LETTERS)
def test_letters_and_signs_have_the_fewest_parts(name):
    shape = LETTERS[name]
    assert len(decomposed(shape)) == fewest_parts(shape)


CHEESE = [regular(6, 300 + 10 * (7 * i % 5), 1200 * (i % 5) + 600, 1200 * (i // 5) + 700 + 20 * (i % 3)) for i in range(20)]


@pytest.mark.parametrize("name, shape, most", [
    ("a star of 12", outlines.star(12, 4096, 2000), 13),
    ("a comb of 8", outlines.comb(8), 9),
    ("a spiral of 4", outlines.spiral(4), 16),
    ("a round ring", outline(regular(20, 2000), regular(20, 1200)), 20),
    ("a ring with its hole at the rim", outline(regular(20, 2000), regular(12, 900, 1000, 60)), 12),
    ("a letter B", boxes((0, 0, 1, 5), (0, 0, 3, 1), (0, 2, 3, 3), (0, 4, 3, 5), (2, 0, 3, 5)), 5),
    ("a cheese with 20 holes", outline([(0, 0), (6000, 0), (6000, 5000), (0, 5000)], *CHEESE), 60),
    ("a sieve", boxes(*[(i, 0, i + 1, 5) for i in (0, 2, 4)], *[(0, i, 5, i + 1) for i in (0, 2, 4)]), 7),
])
def test_larger_shapes_are_cut_rightly(name, shape, most):
    parts = decomposed(shape)
    assert len(parts) <= most, name


def test_a_convex_outline_is_one_part_without_marks():
    assert decomposed(outline(regular(7, 999))) == [Part(tuple(convex.hull(regular(7, 999)).vertices), 0)]


def test_parts_of_more_than_32_vertices_are_halved():
    assert [len(part.vertices) for part in decomposed(outline(regular(33, 60000)))] in ([3, 32], [32, 3])
    assert len(decomposed(outline(regular(62, 60000)))) == 2
    assert len(decomposed(outline(regular(63, 60000)))) == 3
    assert len(decomposed(outline(regular(9, 60000)), max_vertices=4)) == 4


def test_corners_in_line_are_halved_from_the_other_side():
    side = [(100 * i, 0) for i in range(60)]
    parts = decomposed(outline([*side, (3000, 2000)]))
    assert len(parts) == 2


def test_corners_in_line_stay_whole_in_one_part():
    square = outline([(0, 0), (500, 0), (1000, 0), (1000, 1000), (400, 1000), (0, 1000), (0, 300)])
    assert [len(part.vertices) for part in decomposed(square)] == [7]


def test_a_cut_through_a_vertex_in_line_ends_there():
    """The two notches and the tip between them are in line: from notch to notch it is two cuts, or none."""
    shape = outline([(0, 0), (1000, 0), (800, 500), (1000, 1000), (0, 1000), (200, 500)])
    for part in decomposed(shape):
        assert part.internal
    table = outline([(0, 0), (300, 0), (300, 300), (600, 300), (600, 0), (900, 0), (900, 300), (900, 600), (0, 600), (0, 300)])
    assert len(decomposed(table)) == fewest_parts(table) == 3


def test_the_same_outline_gives_the_same_parts():
    shape = outlines.with_holes(3, 8, 2, 5, 4000)
    assert convex.decompose(shape) == convex.decompose(Outline(list(shape.exterior), [list(hole) for hole in shape.holes]))


def test_three_hundred_vertices_take_seconds(figures):
    figures("convex parts: time by vertices: " + ", ".join(f"{count}: {seconds(count):.3f} s" for count in (30, 60, 150)))
    assert seconds(300) < 30


def seconds(count):
    shape = outlines.blob(count, count, roughness=0.03)
    start = time.process_time()
    decomposed(shape)
    return time.process_time() - start


# ---- Bad input

@pytest.mark.parametrize("shape, said", [
    (Outline([(0, 0), (10, 10), (10, 0), (0, 10)]), "crosses itself"),
    (Outline([(0, 0), (10, 0), (10, 10)], [[(20, 20), (20, 30), (30, 20)]]), "crosses itself or a hole"),
    (Outline([(0, 0), (0, 10), (10, 10)]), "wrong way round"),
    (Outline([(0, 0), (10, 0), (10, 10), (0, 10)], [[(2, 2), (4, 2), (2, 4)]]), "wrong way round"),
    (Outline([(0, 0), (10, 0)]), "2 vertices"),
    (Outline([(0, 0), (10, 0), (20, 0)]), "crosses itself"),
    (Outline([(0, 0), (10, 0), (10, 0), (0, 10)]), "twice"),
    (Outline([(0, 0), (10, 0), (10, 10), (0, 10)], [[(0, 5), (5, 6), (5, 4)]]), r"touches itself at \(0, 5\)"),
    (Outline([(0, 0), (10, 0), (10, 10), (0, 10)], [[(0, 0), (5, 6), (6, 5)]]), r"touches itself at \(0, 0\)"),
    (Outline([(0, 0), (1 << 31, 0), (0, 10)]), "lattice steps wide"),
])
def test_unfit_outlines_are_refused(shape, said):
    with pytest.raises(ShapeFault, match=said):
        convex.decompose(shape)


def test_more_than_255_parts_are_refused_with_advice(monkeypatch):
    with pytest.raises(ShapeFault, match="at least 2.. convex parts.*larger tolerance"):
        convex.decompose(outlines.star(520, 1 << 20, 1 << 19))
    monkeypatch.setattr(convex, "MOST_PARTS", 3)
    with pytest.raises(ShapeFault, match="^4 convex parts"):
        convex.decompose(outline(regular(9, 60000)), max_vertices=4)


# ---- Hulls and widths

def test_a_hull_is_convex_and_covers_the_points():
    for seed in seeds(20):
        with repeatable(f"{HERE} -k covers_the_points", seed):
            points = outlines.blob(seed, 40).exterior
            part = convex.hull(points)
            convex.check(Outline(list(part.vertices)), [part], max_vertices=99)
            assert shapely.Polygon(part.vertices).covers(shapely.MultiPoint(points))
            assert set(part.vertices) <= set(points)


def test_points_in_line_have_no_hull():
    with pytest.raises(ShapeFault, match="one line"):
        convex.hull([(0, 0), (5, 5), (9, 9)])


def test_width_is_the_least_of_all_directions():
    assert convex.width(Part(((0, 0), (300, 0), (300, 40), (0, 40)))) == 40
    assert convex.width(Part(((0, 0), (40, 30), (10, 70), (-30, 40)))) == 50
    assert convex.width(Part(((0, 0), (30, 0), (0, 40)))) == 24


# ---- The check can say no

def test_the_check_finds_what_is_wrong():
    square = outline([(0, 0), (10, 0), (10, 10), (0, 10)])
    one, other = Part(((0, 0), (10, 0), (10, 10)), 0b100), Part(((0, 0), (10, 10), (0, 10)), 0b001)
    convex.check(square, [one, other])
    wrong = {
        "is marked": [replace(one, internal=0), other],
        "beyond the last edge": [replace(one, internal=0b1100), other],
        "without a part": [one],
        "in two parts": [one, one, other],
        "no other side": [one, other, Part(((20, 0), (30, 0), (20, 10)), 0b111)],
        "wrong way round": [Part(one.vertices[::-1], 0), other],
        "not convex": [Part(((0, 0), (10, 0), (10, 10), (0, 10), (5, 5)))],
    }
    for said, parts in wrong.items():
        with pytest.raises(AssertionError, match=said):
            convex.check(square, parts)


def test_the_check_finds_a_joint_in_the_middle_of_an_edge():
    shape = Outline([(0, 0), (10, 0), (10, 5), (10, 10), (0, 10)])
    with pytest.raises(AssertionError, match="without a part"):
        convex.check(shape, [Part(((0, 0), (10, 0), (10, 10), (0, 10)))])
    notched = Outline([(0, 0), (4, 0), (5, 5), (6, 0), (10, 0), (10, 5), (10, 10), (0, 10), (0, 5)])
    halves = [Part(((0, 0), (4, 0), (5, 5), (0, 5)), 0b100), Part(((5, 5), (6, 0), (10, 0), (10, 5)), 0b1000),
              Part(((0, 5), (10, 5), (10, 10), (0, 10)), 0b0001)]
    with pytest.raises(AssertionError, match="no other side"):
        convex.check(notched, halves)
