# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# From masks to regions: every mask of 4 x 4 pixels and random larger ones against a flood fill and shapely's predicates;
# specks, holes, noise.
import io
import time

import numpy as np
import pytest
import shapely
from outlines import repeatable, seeds
from tuff_shapes import trace
from tuff_shapes.faults import Journal, ShapeFault

CELL = 5    # pixels: a mask of 4 x 4 and a gap


def traced(mask, specks=1, place=""):
    """Regions and notes."""
    journal = Journal("rock.png", io.StringIO())
    return trace.regions(np.array(mask, dtype=bool), specks, journal, place), journal.notes


def drawn(*rows):
    return np.array([[pixel != "." for pixel in row] for row in rows])


# ---- What must hold of any mask

def components(mask):
    """A number for each pixel: its 4-connected island's, 0 where empty. Each pixel takes its neighbors' least number until none changes."""
    numbers = np.where(mask, np.arange(1, mask.size + 1).reshape(mask.shape), 0)
    none = mask.size + 1
    while True:
        spread = np.pad(np.where(mask, numbers, none), 1, constant_values=none)
        least = np.minimum.reduce([spread[1:-1, 1:-1], spread[:-2, 1:-1], spread[2:, 1:-1], spread[1:-1, :-2], spread[1:-1, 2:]])
        least = np.where(mask, least, 0)
        if np.array_equal(least, numbers):
            return numbers
        numbers = least


def shoelace(ring):
    x, y = ring[:, 0], ring[:, 1]
    return float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)) / 2


def cross(a, b):
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]


def check_turns(rings, signs):
    """Every point is a corner, and areas have their signs. All rings at once, as they are tens of thousands."""
    lengths = np.array([len(ring) for ring in rings])
    points, ends = np.concatenate(rings), np.cumsum(lengths)
    after, before = np.arange(1, ends[-1] + 1), np.arange(-1, ends[-1] - 1)
    after[ends - 1], before[ends - lengths] = ends - lengths, ends - 1
    assert cross(points - points[before], points[after] - points).all(), "a point that is no corner"
    areas = np.add.reduceat(cross(points, points[after]), ends - lengths) / 2
    assert (areas * signs > 0).all(), "a ring runs the wrong way round"


def check_rings(regions):
    rings = [ring for region in regions for ring in region.rings]
    check_turns(rings, np.array([sign for region in regions for sign in [1] + [-1] * len(region.holes)]))
    lines = shapely.linearrings(np.concatenate(rings), indices=np.repeat(np.arange(len(rings)), [len(ring) for ring in rings]))
    assert shapely.is_simple(lines).all()
    one, other = shapely.STRtree(lines).query(lines, predicate="intersects")
    assert [lines[i].wkt for i in one[one != other]] == [], "rings that meet"


def check_pixels(mask, regions):
    """Each solid pixel's center is in one region, neighbors are in the same one, islands in different ones, empty pixels in none."""
    polygons = [shapely.Polygon(region.exterior, region.holes) for region in regions]
    assert shapely.is_valid(polygons).all()
    rows, columns = np.nonzero(np.ones_like(mask))
    pixel, region = shapely.STRtree(polygons).query(shapely.points(columns + 0.5, rows + 0.5), predicate="within")
    assert len(np.unique(pixel)) == len(pixel)
    owners = np.zeros(mask.size, dtype=int)
    owners[pixel] = region + 1
    pairs = np.unique(np.stack([owners, components(mask).ravel()], axis=1), axis=0)
    assert len(np.unique(pairs[:, 0])) == len(np.unique(pairs[:, 1])) == len(pairs), "islands and regions are not one to one"
    assert np.array_equal(owners > 0, mask.ravel())
    return np.array([polygon.area for polygon in polygons]), owners.reshape(mask.shape)


def check_areas(areas, owners):
    """A chamfer cuts a triangle of 1/32 pixel off where two islands touch, and adds one where an island touches itself."""
    expected = np.bincount(owners.ravel(), minlength=len(areas) + 1).astype(float)
    framed = np.pad(owners, 1)
    blocks = framed[:-1, :-1], framed[:-1, 1:], framed[1:, 1:], framed[1:, :-1]
    for one, left, other, right in (blocks, blocks[1:] + blocks[:1]):
        touching = (one > 0) & (other > 0) & (left == 0) & (right == 0)
        change = np.where(one == other, 1, -1)[touching] / 32
        np.add.at(expected, one[touching], change)
        np.add.at(expected, other[touching], change)
    assert np.array_equal(areas, expected[1:])


def check(mask):
    regions, _ = traced(mask)
    check_rings(regions)
    areas, owners = check_pixels(mask, regions)
    check_areas(areas, owners)
    tops = [min((y, x) for x, y in region.exterior) for region in regions]
    assert tops == sorted(tops)


@pytest.mark.parametrize("upper", range(4))
def test_every_4x4_mask_gives_its_pixels_in_simple_rings_that_do_not_meet(upper):
    """16384 masks side by side: the lower fourteen bits of a mask's number are its column and row in the mosaic."""
    numbers = np.arange(1 << 14).reshape(128, 128) | upper << 14
    bits = numbers[:, :, None, None] >> np.arange(16).reshape(4, 4) & 1
    mosaic = np.zeros((128, CELL, 128, CELL), dtype=bool)
    mosaic[:, :4, :, :4] = bits.transpose(0, 2, 1, 3)
    check(mosaic.reshape(128 * CELL, 128 * CELL))


def test_every_3x3_mask_that_fills_its_picture():
    for number in range(1, 512):
        check((number >> np.arange(9) & 1).astype(bool).reshape(3, 3))


@pytest.mark.parametrize("seed", seeds(60))
def test_random_masks_with_islands_in_holes(seed):
    random = np.random.default_rng(seed)
    height, width = random.integers(1, 60, 2)
    mask = random.random((height, width)) < random.uniform(0.2, 0.8)
    mask[0, 0] = True
    with repeatable("tests/shapes/test_trace.py -k random", seed):
        check(mask)


# ---- Islands, holes, corners

def test_a_pixel_is_a_unit_square():
    (region,), notes = traced(drawn("...", ".#.", "..."))
    assert sorted(map(tuple, region.exterior)) == [(1, 1), (1, 2), (2, 1), (2, 2)]
    assert region.exterior.dtype == np.float64 and region.holes == [] and notes == []


def test_pixels_that_touch_at_a_corner_are_apart():
    regions, notes = traced(drawn("#.", ".#"), place="frame 3")
    assert [shoelace(region.exterior) for region in regions] == [1 - 1 / 32, 1 - 1 / 32]
    assert notes == ["rock.png: frame 3: islands touch at 1 corner, first at (1, 1); they are kept apart"]


def test_an_island_that_touches_itself_at_a_corner_stays_closed():
    (region,), notes = traced(drawn(".##", "#.#", "###"))
    assert len(region.holes) == 1 and notes == []
    assert shoelace(region.holes[0]) == -(1 - 1 / 32)


def test_islands_inside_holes_are_regions_of_their_own():
    half = ["#########", "#.......#", "#.#####.#", "#.#...#.#"]
    regions, _ = traced(drawn(*half, "#.#.#.#.#", *reversed(half)))
    assert [len(region.holes) for region in regions] == [1, 1, 0]
    assert [sum(map(shoelace, region.rings)) for region in regions] == [32, 16, 1]


def test_regions_come_in_reading_order_of_their_first_point():
    regions, _ = traced(drawn("..#..#", "#....#", "#..###"))
    assert [tuple(min(map(tuple, region.exterior[:, ::-1]))) for region in regions] == [(0, 2), (0, 5), (1, 0)]


# ---- Specks

def test_islands_below_the_speck_size_are_dropped_and_named():
    mask = drawn("####...#", "####.#.#", "####....", "####.##.")
    regions, notes = traced(mask, specks=3)
    assert len(regions) == 1
    assert notes == ["rock.png: 3 specks below 3 px dropped: 2 px at (7, 0), 2 px at (5, 3), 1 px at (5, 1)"]
    assert len(traced(mask, specks=2)[0]) == 3


def test_a_note_names_the_three_largest_specks():
    _, (note,) = traced(drawn("####.#.", "####...", "####.##", "####...", "...#.##"), specks=8)
    assert note.endswith("3 specks below 8 px dropped: 2 px at (5, 2), 2 px at (5, 4), 1 px at (5, 0)")
    _, (note,) = traced(drawn("####.#.", "####...", "####.##", "####...", "####.##", "####...", "####.#."), specks=8)
    assert "4 specks" in note and note.endswith("1 px at (5, 0), ...")


def test_a_speck_does_not_chamfer_the_corner_it_touches():
    (region,), notes = traced(drawn("###.", "###.", "###.", "...#"), specks=2)
    assert shoelace(region.exterior) == 9
    assert len(notes) == 1 and "touch" not in notes[0]


def test_small_holes_are_filled_and_named():
    mask = drawn("######", "#..#.#", "#..###", "######")
    (region,), notes = traced(mask, specks=2)
    assert len(region.holes) == 1
    assert notes == ["rock.png: 1 hole below 2 px filled: 1 px at (4, 1)"]
    assert len(traced(mask, specks=5)[0][0].holes) == 0


def test_a_speck_inside_a_hole_that_is_filled_goes_with_it():
    (region,), notes = traced(drawn("#######", "#.....#", "#.#.#.#", "#.....#", "#######"), specks=16)
    assert region.holes == [] and shoelace(region.exterior) == 35
    assert len(notes) == 2


def test_a_small_hole_counts_as_solid_before_specks_are_dropped():
    assert len(traced(drawn("###", "#.#", "###"), specks=9)[0]) == 1


def test_the_hole_of_a_dropped_speck_is_not_noted_too():
    _, notes = traced(drawn("###.####", "#.#.####", "###.####"), specks=10)
    assert notes == ["rock.png: 1 speck below 10 px dropped: 9 px at (0, 0)"]


def test_only_specks_is_a_fault_that_names_the_largest():
    with pytest.raises(trace.NothingLeft, match="frame 2: nothing is left: the largest of 2 islands has 3 px; .*--specks"):
        traced(drawn("###.#"), specks=16, place="frame 2")
    with pytest.raises(trace.NothingLeft, match="the largest of 1 island has 1 px"):
        traced(drawn("#"), specks=16)


def test_a_line_one_pixel_wide_is_kept_if_it_is_long_enough():
    (region,), _ = traced(np.ones((1, 16)), specks=16)
    assert shoelace(region.exterior) == 16 and len(region.exterior) == 4


def test_nothing_solid_is_a_fault():
    with pytest.raises(ShapeFault, match="object 4: nothing is solid"):
        traced(np.zeros((3, 3)), place="object 4")


# ---- Large masks

def test_noise_is_refused_before_it_takes_all_memory():
    """The border of a checkerboard of this size passes 1025 x 1025 points."""
    rows, columns = np.mgrid[:1024, :1024]
    with pytest.raises(ShapeFault, match=r"the border has 10506\d\d corners, at most 524288"):
        traced((rows + columns) % 2)


def test_a_mask_may_be_a_view_into_a_larger_one():
    whole = np.zeros((20, 20), dtype=bool)
    whole[5:9, 6:12] = True
    regions, _ = traced(whole[4:10, ::-1][:, 4:18])
    assert [shoelace(region.exterior) for region in regions] == [24]


def test_4096_x_4096_pixels():
    """A disc whose left half is a comb."""
    along = np.arange(4096) - 2048
    mask = (along[:, None] ** 2 + along ** 2 < 1800 ** 2) & ((along[:, None] % 100 < 50) | (along > 0))
    began = time.perf_counter()
    (region,), _ = traced(mask, specks=16)
    print(f"4096 x 4096, {len(region.exterior)} points: {time.perf_counter() - began:.2f} s")
    assert shoelace(region.exterior) == mask.sum()
