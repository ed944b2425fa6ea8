# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# SVG: every closed shape with its transforms and fill rule, curves within a hundredth of a pixel, and what is refused.
import math

import numpy as np
import pytest
import shapely
from tuff_shapes import svg
from tuff_shapes.faults import Journal, ShapeFault
from tuff_shapes.model import Region

HEAD = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" {}>{}</svg>'
TURNED = np.linspace(0, 2 * math.pi, 5000)


def read(folder, body, head='width="100" height="100"'):
    path = folder / "test.svg"
    path.write_text(HEAD.format(head, body))
    journal = Journal(path.name)
    return svg.read(path, None, journal).drawings, journal.notes


def one(folder, body, **head):
    drawings, _ = read(folder, body, **head)
    assert len(drawings) == 1
    return drawings[0]


def ground(drawing):
    return shapely.union_all([shapely.Polygon(region.exterior, region.holes) for region in drawing.regions])


def fault(folder, body):
    with pytest.raises(ShapeFault) as caught:
        read(folder, body)
    return str(caught.value)


def farthest(drawing, x, y):
    """How far the outline of a drawing is from points of the true curve."""
    return shapely.distance(ground(drawing).boundary, shapely.points(x, y)).max()


def shoelace(ring):
    x, y = ring.T
    return np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)


@pytest.mark.parametrize(("body", "corners"), [
    ('<rect x="3" y="4" width="30" height="20"/>', {(3, 4), (33, 4), (33, 24), (3, 24)}),
    ('<polygon points="0,0 10,0 5,8"/>', {(0, 0), (10, 0), (5, 8)}), ('<polyline points="0,0 10,0 5,8 0,0"/>', {(0, 0), (10, 0), (5, 8)}),
    ('<path d="M5 5h10v10h-10z"/>', {(5, 5), (15, 5), (15, 15), (5, 15)}), ('<path d="m5 5 9 0 0 9 -9-9"/>', {(5, 5), (14, 5), (14, 14)}),
])
def test_straight_shapes_keep_their_corners(tmp_path, body, corners):
    drawing = one(tmp_path, body)
    exterior = drawing.regions[0].exterior
    assert drawing.exact and {tuple(point) for point in exterior} == corners and len(exterior) == len(corners) and shoelace(exterior) > 0


def test_a_circle_is_within_a_hundredth_of_a_pixel(tmp_path):
    drawing = one(tmp_path, '<circle cx="50" cy="60" r="30"/>')
    assert not drawing.exact and farthest(drawing, 50 + 30 * np.cos(TURNED), 60 + 30 * np.sin(TURNED)) <= 0.01
    assert np.abs(np.hypot(*(drawing.regions[0].exterior - (50, 60)).T) - 30).max() < 1e-9


def test_a_sheared_and_stretched_ellipse_too(tmp_path):
    drawing = one(tmp_path, '<ellipse cx="50" cy="60" rx="30" ry="8" transform="matrix(4 0.5 2 3 7 -8)"/>')
    x, y = 50 + 30 * np.cos(TURNED), 60 + 8 * np.sin(TURNED)
    assert farthest(drawing, 4 * x + 2 * y + 7, 0.5 * x + 3 * y - 8) <= 0.01


@pytest.mark.parametrize(("path", "controls"), [
    ("M0 0C40 0 60 90 0 80z", [(0, 0), (40, 0), (60, 90), (0, 80)]), ("M0 0Q90 10 0 80z", [(0, 0), (90, 10), (0, 80)]),
    ("M0 0C400 0 -300 90 0 80z", [(0, 0), (400, 0), (-300, 90), (0, 80)]),
])
def test_bezier_curves_too(tmp_path, path, controls):
    drawing = one(tmp_path, f'<path d="{path}"/>')
    t, degree = np.linspace(0, 1, 5000), len(controls) - 1
    x, y = (sum(math.comb(degree, i) * t**i * (1 - t)**(degree - i) * point[axis] for i, point in enumerate(controls)) for axis in (0, 1))
    assert farthest(drawing, x, y) <= 0.01
    assert 8 < sum(len(region.exterior) for region in drawing.regions) < 300


def test_rounded_corners_are_arcs(tmp_path):
    assert ground(one(tmp_path, '<rect width="30" height="20" rx="5"/>')).area == pytest.approx(600 - (4 - math.pi) * 25, abs=0.3)


@pytest.mark.parametrize(("attributes", "inner", "area"), [
    ("", "M2 2h6v6h-6z", 100), ("", "M2 2v6h6v-6z", 64), ('fill-rule="evenodd"', "M2 2h6v6h-6z", 64),
    ('style="fill-rule:evenodd"', "M2 2h6v6h-6z", 64),
])
def test_holes_follow_the_fill_rule(tmp_path, attributes, inner, area):
    drawing = one(tmp_path, f'<path {attributes} d="M0 0h10v10h-10z {inner}"/>')
    assert ground(drawing).area == area and all(shoelace(hole) < 0 for hole in drawing.regions[0].holes)


@pytest.mark.parametrize(("rule", "area"), [("nonzero", 1.0), ("evenodd", (5 - math.sqrt(5)) / 4)])
def test_a_star_drawn_in_one_line_follows_the_fill_rule(tmp_path, rule, area):
    tips = [(50 + 40 * math.sin(4 * math.pi * i / 5), 50 - 40 * math.cos(4 * math.pi * i / 5)) for i in range(5)]
    drawing = one(tmp_path, f'<polygon fill-rule="{rule}" points="{" ".join(f"{x},{y}" for x, y in tips)}"/>')
    whole = 5 * 40**2 * math.sin(math.pi / 5) * math.sin(math.pi / 10) / math.sin(7 * math.pi / 10)
    assert ground(drawing).area == pytest.approx(area * whole, rel=1e-5)


def test_holes_that_touch_are_joined(tmp_path):
    drawings, notes = read(tmp_path, '<path fill-rule="evenodd" d="M0 0h30v30h-30z M5 5h10v10h-10z M15 15h10v10h-10z"/>')
    assert len(drawings[0].regions[0].holes) == 1 and ground(drawings[0]).area == 700 - 0.25**2
    assert notes == ["test.svg: path 1: touches itself in 1 points, first at (15, 15): cut back by 0.25 px"]


def test_islands_are_in_reading_order(tmp_path):
    drawing = one(tmp_path, '<path d="M0 20h5v5h-5z M40 0h5v5h-5z M10 0h5v5h-5z"/>')
    assert [tuple(region.exterior.min(axis=0)) for region in drawing.regions] == [(10, 0), (40, 0), (0, 20)]
    assert all(isinstance(region, Region) for region in drawing.regions)


def test_a_view_box_scales(tmp_path):
    drawing = one(tmp_path, '<rect x="1" width="10" height="5"/>', head='width="300" height="300" viewBox="0 0 100 100"')
    assert ground(drawing).bounds == (3, 0, 33, 15) and drawing.size == (300, 300)


@pytest.mark.parametrize(("head", "size"), [('width="60" height="40"', (60, 40)), ('viewBox="0 0 50 30"', (50, 30)), ("", (11, 6)),
                                            ('width="60"', (11, 6))])
def test_a_drawing_is_as_large_as_its_page(tmp_path, head, size):
    assert one(tmp_path, '<rect x="1" y="0.5" width="10" height="5"/>', head=head).size == size


def test_groups_and_clones_are_transformed(tmp_path):
    body = '<g transform="scale(2)"><rect id="a" width="4" height="3"/><use href="#a" transform="rotate(90)"/></g>'
    drawings, _ = read(tmp_path, body)
    assert np.allclose([ground(drawing).bounds for drawing in drawings], [(0, 0, 8, 6), (-6, 0, 0, 8)])
    assert [drawing.name for drawing in drawings] == ["a", "a_2"]


def test_drawings_are_named_by_id_or_number(tmp_path):
    drawings, _ = read(tmp_path, '<rect id="Rock" width="4" height="3"/><rect width="4" height="3"/>')
    assert [(drawing.name, drawing.place) for drawing in drawings] == [("Rock", "rect Rock"), ("2", "rect 2")]
    assert one(tmp_path, '<rect id="path1234" width="4" height="3"/>').name == ""


@pytest.mark.parametrize(("body", "note"), [
    ('<text>rock</text>', "text: only shapes are read; skipped"), ('<image href="a.png"/>', "image: only shapes are read; skipped"),
    ('<g style="display: none"><rect width="9" height="9"/></g>', "line 1: hidden; skipped"),
    ('<g visibility="hidden"><rect width="9" height="9"/></g>', "rect: hidden; skipped"),
])
def test_what_is_no_ground_is_noted(tmp_path, body, note):
    drawings, notes = read(tmp_path, f'{body}<rect id="a" width="4" height="3"/>')
    assert [ground(drawing).bounds for drawing in drawings] == [(0, 0, 4, 3)] and notes == [f"test.svg: {note}"]


def test_clips_are_noted(tmp_path):
    _, notes = read(tmp_path, '<rect clip-path="url(#c)" width="4" height="3"/>')
    assert notes == ["test.svg: line 1: clips and masks are not applied"]


@pytest.mark.parametrize(("body", "message"), [
    ('<path id="bay" d="M0 0L10 0L10 10"/>', "path bay: is open: close the path"),
    ('<line x1="0" y1="0" x2="5" y2="5"/>', "line 1: is open: close the path"),
    ('<polyline points="0,0 10,0 5,8"/>', "polyline 1: is open: close the path"),
    ('<path d="M0 0L10 0L20 0z"/>', "path 1: has no area"),
    ('<rect id="flat" width="4" height="3" transform="scale(0)"/>', "rect flat: has no area"),
    ('<rect width="4" height="3" transform="scale(1e400)"/>', "rect 1: a coordinate is not a finite number"),
    ('<path d="M0 0 L x"/>', "a shape is out of order (numbers are missing, or too many)"),
    ('<g id="a"><use href="#a"/></g>', "is nested too deeply, or a <use> shows itself"),
    ('<symbol><rect width="4" height="3"/></symbol>', "line 1: <symbol> is not read: unlink clones and release masks"),
    ('<mask><rect width="4" height="3"/></mask>', "line 1: <mask> is not read: unlink clones and release masks"),
    ("", "no closed shape in it"),
])
def test_a_bad_shape_is_named(tmp_path, body, message):
    assert fault(tmp_path, body) == message


@pytest.mark.parametrize(("text", "message"), [
    ("rock", "is not XML: syntax error, line 1, column 1"), ("", "is not XML: no element found, line 1, column 1"),
    ("<map/>", "is XML, but <map> instead of <svg>"), ("<svg><rect></svg>", "is not XML: mismatched tag, line 1, column 14"),
    ('<!DOCTYPE svg [<!ENTITY a "a">]><svg/>', "line 1: defines the entity 'a'; entities are not read"),
])
def test_other_files_are_refused(tmp_path, text, message):
    (tmp_path / "test.svg").write_text(text)
    with pytest.raises(ShapeFault) as caught:
        svg.read(tmp_path / "test.svg", None, Journal("test.svg"))
    assert str(caught.value) == message


def test_the_document_type_that_editors_write_is_no_fault(tmp_path):
    (tmp_path / "test.svg").write_text('<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd">'
                                       + HEAD.format("", '<rect width="4" height="3"/>'))
    assert len(svg.read(tmp_path / "test.svg", None, Journal("test.svg")).drawings) == 1
