# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# SVG in: svgelements reads paths, styles and transforms; here curves become polygons and fill rules become ground.
# A shape becomes a drawing, with the islands and holes that its fill rule gives; all have the page's upper left corner
# as their own, as a frame has its picture's. Units are px.
import math
from dataclasses import replace

import numpy as np
import shapely
import svgelements

from . import markup, vectors
from .faults import ShapeFault
from .model import Drawing, Source


def read(path, options, journal):
    """Every closed shape of an SVG file as a drawing."""
    elements = markup.elements(markup.content(path))
    _look_over(elements, journal)
    page = _parsed(path)
    shapes = [shape for shape in page.elements(lambda element: element is not page) if _is_ground(shape, journal)]
    if not shapes:
        raise ShapeFault("no closed shape in it")
    names = vectors.Names()
    drawings = [_drawing(shape, number, names, journal) for number, shape in enumerate(shapes, 1)]
    size = _size(page, elements[0].attributes, drawings)
    drawings = [replace(drawing, size=size) for drawing in drawings]
    if len(drawings) == 1:
        drawings[0].name = ""
    return Source(drawings)


def _look_over(elements, journal):
    if elements[0].tag != "svg":
        raise ShapeFault(f"is XML, but <{elements[0].tag}> instead of <svg>")
    for element in elements:
        place = f"line {element.line}"
        # svgelements draws what is inside these where it stands, and symbols without their view box.
        if element.tag == "symbol" or element.tag in ("mask", "marker") and "defs" not in element.inside:
            raise ShapeFault(f"<{element.tag}> is not read: unlink clones and release masks", place)
        style = element.attributes.get("style", "")
        if "clip-path" in style or "mask:" in style or element.attributes.keys() & {"clip-path", "mask"}:
            journal.note("clips and masks are not applied", place)
        if element.attributes.get("display") == "none" or "display:none" in style.replace(" ", ""):
            journal.note("hidden; skipped", place)


def _parsed(path):
    try:
        return svgelements.SVG.parse(str(path), reify=False, on_error="raise")
    except RecursionError:
        raise ShapeFault("is nested too deeply, or a <use> shows itself") from None
    except Exception as fault:    # svgelements names no exceptions: a path out of order raises whatever came up
        reason = str(fault) or "numbers are missing, or too many"
        raise ShapeFault(f"a shape is out of order ({reason})") from None


def _size(page, attributes, drawings):
    """The page's, or what holds every shape: svgelements takes 1000 x 1000 where the file does not say."""
    if "viewBox" in attributes or {"width", "height"} <= attributes.keys():
        return page.width, page.height
    corners = np.max([region.exterior.max(axis=0) for drawing in drawings for region in drawing.regions], axis=0)
    return tuple(max(1, math.ceil(corner)) for corner in corners)


def _is_ground(element, journal):
    if isinstance(element, svgelements.Text | svgelements.Image):
        journal.note("only shapes are read; skipped", _place(element))
    if not isinstance(element, svgelements.Shape):
        return False
    if element.values.get("visibility") in ("hidden", "collapse"):
        journal.note("hidden; skipped", _place(element))
        return False
    return True


def _place(element, number=None):
    return " ".join(str(word) for word in (element.values.get("tag"), element.id or number) if word)


def _drawing(shape, number, names, journal):
    place = _place(shape, number)
    ground = filled(_rings(shape, place), shape.values.get("fill-rule", "nonzero"))
    if ground.is_empty:
        raise ShapeFault("has no area", place)
    ground = vectors.parted(ground, journal, place)
    straight = not any(isinstance(segment, svgelements.Curve) for segment in shape.segments(transformed=False))
    return Drawing(names.give(shape.id or str(number), number), place, vectors.regions(ground), (0, 0), exact=straight)


def _rings(shape, place):
    """The closed lines of a shape, in pixels. Curves are cut up before the transform: svgelements' arcs do not shear."""
    matrix = shape.transform
    turn = np.array([[matrix.a, matrix.c], [matrix.b, matrix.d]])
    vectors.finite([*turn.flat, matrix.e, matrix.f], place)
    stretch = np.linalg.norm(turn, 2)
    if stretch == 0:
        raise ShapeFault("has no area", place)
    rings = [_closed(line, vectors.FLATNESS / stretch, place) for line in _lines(shape, vectors.FLATNESS / stretch)]
    return [ring @ turn.T + (matrix.e, matrix.f) for ring in rings]


def _lines(shape, flatness):
    """Each subpath as an array of points."""
    lines = []
    for segment in shape.segments(transformed=False):
        if isinstance(segment, svgelements.Move):
            lines.append([np.array([segment.end])])
        elif lines:
            lines[-1].append(_points(segment, flatness))
    return [np.concatenate(line) for line in lines if len(line) > 1]


def _points(segment, flatness):
    """The points of a segment that follow its first."""
    if not isinstance(segment, svgelements.Curve):
        return np.array([segment.end], dtype=np.float64)
    steps = max(1, _steps(segment, flatness))
    return np.asarray(segment.npoint(np.arange(1, steps + 1) / steps), dtype=np.float64)


def _steps(curve, flatness):
    """Chords for a curve. A chord of a Bezier curve over 1/n of it is off by at most max |B''| / (8 n^2), and |B''| is
    at most d (d - 1) times the largest second difference of the d + 1 control points."""
    if isinstance(curve, svgelements.Arc):
        return vectors.arc_steps(max(curve.rx, curve.ry), curve.sweep, flatness) if curve.rx and curve.ry else 1
    cubic = isinstance(curve, svgelements.CubicBezier)
    middle = [curve.control1, curve.control2] if cubic else [curve.control]
    bend = np.diff(np.array([curve.start, *middle, curve.end], dtype=np.float64), n=2, axis=0)
    largest = np.hypot(*bend.T).max() * (6 if cubic else 2)
    return math.ceil(math.sqrt(largest / (8 * flatness)))


def _closed(line, flatness, place):
    vectors.finite(line, place)
    if math.dist(line[0], line[-1]) > flatness:
        raise ShapeFault("is open: close the path", place)
    # A command to close the path where it has already returned adds a point to the one that is there, or dust away.
    return line[np.hypot(*(line - np.roll(line, 1, axis=0)).T) > flatness * 1e-6]


def filled(rings, rule):
    """The ground of closed lines under a fill rule. The lines are cut where they meet; of the faces between them those
    belong to the ground that the lines go round an odd number of times, or any but 0 under 'nonzero'."""
    lines = shapely.union_all([shapely.LinearRing(ring) for ring in rings if len(ring) > 2])
    faces = shapely.get_parts(shapely.polygonize(shapely.get_parts(lines)))
    inside = [face for face in faces if _is_inside(rings, face.representative_point(), rule)]
    return shapely.union_all(inside)


def _is_inside(rings, point, rule):
    turns = sum(_winding(ring, point.x, point.y) for ring in rings)
    return turns % 2 == 1 if rule == "evenodd" else turns != 0


def _winding(ring, x, y):
    """How often a ring goes round a point that is not on it: edges that cross the ray to the right, by direction."""
    (x0, y0), (x1, y1) = ring.T, np.roll(ring, -1, axis=0).T
    side = (x1 - x0) * (y - y0) - (x - x0) * (y1 - y0)
    return int(np.sum((y0 <= y) & (y1 > y) & (side > 0))) - int(np.sum((y1 <= y) & (y0 > y) & (side < 0)))
