# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Outlines with few vertices: what is promised holds on blobs and thin shapes; how few they are beside an exhaustive
# search, a lower bound and the libraries' own simplification.
import borders
import fewest_vertices
import numpy as np
import outlines
import pymunk.autogeometry
import pytest
import shapely
from lower_bound import lower_bound
from tuff_shapes import measure, simplify
from tuff_shapes.faults import ShapeFault
from tuff_shapes.model import Lattice, Region

HERE = "tests/shapes/test_simplify.py"
LATTICE = Lattice()
SQUARE = np.array([(2, 2), (42, 2), (42, 42), (2, 42)], dtype=np.float64)


def vertices(outline):
    return sum(len(ring) for ring in outline.rings)


@pytest.mark.parametrize("tolerance", [0.4, 1.0, 3.0])
def test_blobs_keep_their_promises(tolerance):
    for seed in outlines.seeds(30):
        with outlines.repeatable(f"{HERE} -k 'blobs_keep and {tolerance}'", seed):
            region = borders.blob(seed, 48 + seed)
            borders.verify(region, simplify.outline(region, tolerance, LATTICE), tolerance, LATTICE)


@pytest.mark.parametrize("lattice", [LATTICE, Lattice(0.3), Lattice(1 / 16)], ids=["fine", "uneven", "coarse"])
@pytest.mark.parametrize("name", sorted(borders.thin()))
def test_thin_shapes_keep_their_promises(name, lattice):
    for region in borders.regions(borders.thin()[name]):
        for tolerance in (0.5, 1.0, 2.5):
            borders.verify(region, simplify.outline(region, tolerance, lattice), tolerance, lattice)


def test_a_square_keeps_its_four_corners_exactly():
    found = simplify.outline(Region(SQUARE), 1.0, LATTICE)
    assert sorted(found.exterior) == sorted(tuple(corner) for corner in (SQUARE * 64).astype(int).tolist())


def test_a_slanting_square_has_four_vertices():
    y, x = np.mgrid[:80, :80]
    diamond = abs(x + y - 79) + 3 * abs(x - y) < 70
    assert vertices(simplify.outline(borders.largest(diamond), 1.0, LATTICE)) == 4


def test_no_tolerance_keeps_the_border():
    for seed in outlines.seeds(8):
        with outlines.repeatable(f"{HERE} -k no_tolerance", seed):
            region = borders.blob(seed, 40)
            kept = simplify.outline(region, 0.0, LATTICE)
            assert measure.deviation(region, kept, LATTICE).largest == 0.0
            assert vertices(kept) == sum(len(ring) for ring in region.rings)


def test_a_grid_too_coarse_for_the_tolerance_is_a_fault_with_figures():
    with pytest.raises(ShapeFault, match=r"too coarse for a tolerance of 0.01 px: .* 0\.\d+ px off"):
        simplify.outline(borders.blob(1, 40), 0.01, Lattice(0.3))


def test_few_vertices_beside_an_exhaustive_search(figures):
    """The search knows a coarser grid than the tool but every place on it; one vertex more is allowed for the tool."""
    more = []
    for seed in outlines.seeds(24):
        with outlines.repeatable(f"{HERE} -k exhaustive", seed):
            region = borders.small(seed)
            tolerance = (0.6, 0.8, 1.0)[seed % 3]
            least = fewest_vertices.fewest_vertices(region.exterior, tolerance)
            more.append(vertices(simplify.outline(region, tolerance, LATTICE)) - least)
            assert more[-1] <= 1
    figures(f"outlines of {len(more)} small blobs: {sum(n <= 0 for n in more)} have as few vertices as an exhaustive search finds, "
            f"{sum(n > 0 for n in more)} one more")


def test_few_vertices_beside_a_lower_bound(figures):
    for tolerance, allowed in ((0.7, 1.4), (1.0, 1.4), (2.0, 1.45)):
        ours, bound = 0, 0
        for seed in outlines.seeds(16):
            with outlines.repeatable(f"{HERE} -k lower_bound", seed):
                region = Region(borders.blob(seed, 96).exterior)
                found, least = vertices(simplify.outline(region, tolerance, LATTICE)), lower_bound(region.exterior, tolerance)
                assert found >= least
                ours, bound = ours + found, bound + least
        figures(f"blobs of 96 px, tolerance {tolerance} px: {ours} vertices, at least {bound} by runs of corners that single lines pass")
        assert ours <= allowed * bound or len(outlines.seeds(16)) < 16


def douglas_peucker(border, tolerance):
    ring = shapely.get_coordinates(shapely.simplify(shapely.Polygon(border), tolerance).exterior)[:-1]
    return ring if len(ring) >= 3 else border


def pymunk_simplified(border, tolerance):
    ring = pymunk.autogeometry.simplify_curves([*map(tuple, border), tuple(border[0])], tolerance)[:-1]
    return np.array(ring) if len(ring) >= 3 else border


def fewest_of(method, border, allowed):
    """Vertices of another method's ring at its own best parameter, held to the same measured error."""
    fits = [ring for ring in (method(border, allowed * part) for part in np.linspace(0.2, 1.6, 29))
            if measure.farther_way(border, ring)[0] <= allowed + 1e-9]
    return min((len(ring) for ring in fits), default=len(border))


def test_fewer_vertices_than_the_libraries_at_the_same_measured_error(figures):
    counts = np.zeros(3, dtype=int)
    for seed in outlines.seeds(16):
        with outlines.repeatable(f"{HERE} -k libraries", seed):
            border = borders.blob(seed, 96).exterior
            ours = vertices(simplify.outline(Region(border), 1.0, LATTICE))
            theirs = [fewest_of(method, border, 1.0) for method in (douglas_peucker, pymunk_simplified)]
            assert ours <= min(theirs)
            counts += [ours, *theirs]
    figures(f"blobs of 96 px, measured error at most 1 px, vertices: tool {counts[0]}, shapely simplify {counts[1]}, "
            f"pymunk simplify_curves {counts[2]}")


@pytest.mark.parametrize("budget", [8, 12, 30])
def test_a_budget_is_kept_with_a_small_error(budget):
    for seed in outlines.seeds(4):
        with outlines.repeatable(f"{HERE} -k 'budget_is_kept and {budget}'", seed):
            region = Region(borders.blob(seed, 64).exterior)
            found = simplify.outline_with_budget(region, budget, LATTICE)
            error = measure.deviation(region, found, LATTICE).largest
            borders.verify(region, found, error, LATTICE)
            assert vertices(found) <= budget
            assert vertices(simplify.outline(region, error * 0.9, LATTICE)) > budget


def test_a_budget_that_holds_every_corner_keeps_them():
    region = borders.blob(1, 40)
    assert measure.deviation(region, simplify.outline_with_budget(region, 1000, LATTICE), LATTICE).largest < 0.02


def test_a_budget_below_three_a_ring_is_a_fault():
    region = borders.largest(borders.thin()["frame"])
    with pytest.raises(ShapeFault, match="5 vertices are not enough for 2 rings: at least 6"):
        simplify.outline_with_budget(region, 5, LATTICE)


def test_a_budget_that_nothing_keeps_is_a_fault():
    with pytest.raises(ShapeFault, match="no outline with 6 vertices was found: the least is"):
        simplify.outline_with_budget(borders.largest(borders.spiral(17)), 6, LATTICE)


def test_shapes_set_by_hand_keep_their_corners_but_straight_and_repeated_ones():
    corners = np.array([(0, 0), (5, 0), (10, 0), (10, 0), (10, 10), (0, 10)], dtype=np.float64)
    assert simplify.keep(Region(corners), LATTICE).exterior == [(0, 0), (640, 0), (640, 640), (0, 640)]


def test_a_shape_smaller_than_a_grid_step_is_a_fault():
    with pytest.raises(ShapeFault, match="nothing is left of a ring at .* a larger scale keeps it"):
        simplify.keep(Region(SQUARE / 10000), LATTICE)


def test_a_neck_thinner_than_a_grid_step_is_a_fault():
    neck = np.array([(0, 0), (10, 0), (10, 4.999), (20, 4.999), (20, 0), (30, 0), (30, 10), (20, 10), (20, 5.001), (10, 5.001),
                     (10, 10), (0, 10)], dtype=np.float64)
    with pytest.raises(ShapeFault, match=r"crosses or touches itself at \(1\d(\.\d+)?, 5\)|crosses or touches itself at \(20, 5\)"):
        simplify.keep(Region(neck), LATTICE)


def test_a_coarse_grid_with_ties_ends():
    """White noise, whole-pixel corners, a tolerance of a whole pixel: thousands of lines pass corners at the tolerance exactly."""
    mask = np.pad(np.random.Generator(np.random.PCG64(5)).random((24, 24)) < 0.7, 1)
    region = borders.largest(mask)
    borders.verify(region, simplify.outline(region, 1.0, Lattice(1 / 16)), 1.0, Lattice(1 / 16))
