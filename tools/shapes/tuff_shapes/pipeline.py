# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The way of a drawing: regions -> outlines -> the model that the author chose -> pieces.
from contextlib import contextmanager
from math import cos, pi, sin

import numpy as np
import shapely

from . import convex, measure, piece, simplify
from .faults import ShapeFault
from .model import Lattice, Outline, Part, Region

TOLERANCE = 1.0       # pixels, where the author gives none
SLIVER = 0.5          # pixels: parts of less width are avoided
MAX_VERTICES = 32     # of a part, as TUFF_MAX_VERTICES
CIRCLE_EDGES = 720    # the polygon by which a circle is measured is within 1e-5 of its radius


@contextmanager
def faults_at(place):
    """The rooms below know no place; the author wants one."""
    try:
        yield
    except ShapeFault as fault:
        raise ShapeFault(str(fault), place) from None


def lattice_of(options):
    return Lattice(options.scale, options.per_unit)


def simplified(region, exact, options, lattice):
    if options.vertices is not None:
        return simplify.outline_with_budget(region, options.vertices, lattice)
    if options.tolerance is None and exact:
        return simplify.keep(region, lattice)
    return simplify.outline(region, TOLERANCE if options.tolerance is None else options.tolerance, lattice)


# ---- Models: each gives the outline that the game collides with

def border_hull(region):
    ring = np.asarray(shapely.MultiPoint(region.exterior).convex_hull.exterior.coords)[:-1]
    x, y = ring.T
    return Region(ring if np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) > 0 else ring[::-1])


def hull_outline(region, exact, options, lattice):
    """The hull of a simplified hull is no farther from the hull of the border than the simplified one."""
    outline = simplified(border_hull(region), exact, options, lattice)
    vertices = convex.hull(outline.exterior).vertices
    if len(vertices) > MAX_VERTICES:
        raise ShapeFault(f"the hull has {len(vertices)} vertices, more than {MAX_VERTICES}: "
                         f"a larger --tolerance, or --vertices {MAX_VERTICES} at most")
    return Outline(list(vertices))


def outline_of(region, exact, options, lattice):
    return (hull_outline if options.model == "hull" else simplified)(region, exact, options, lattice)


def parts_of(outline, model, lattice):
    if model == "circle":
        return []
    return [Part(tuple(outline.exterior))] if model == "hull" else convex.decompose(outline, MAX_VERTICES, SLIVER / lattice.step)


# ---- Errors, measured on what the game collides with

def circle_deviation(region, outline, center, lattice):
    """From the exterior to the circle of equal area, which has no holes either."""
    fine = Lattice(lattice.scale, piece.RAW_PER_UNIT)
    radius = piece.circle_raw(outline, lattice.per_unit)
    if radius > piece.MAX_RADIUS * piece.RAW_PER_UNIT:
        raise ShapeFault(f"the circle has a radius of {radius / piece.RAW_PER_UNIT:.1f} units, more than {piece.MAX_RADIUS}: --scale")
    x, y = (coordinate * (fine.per_unit // lattice.per_unit) for coordinate in center)
    turns = [2 * pi * i / CIRCLE_EDGES for i in range(CIRCLE_EDGES)]
    circle = [(x + round(radius * cos(turn)), y + round(radius * sin(turn))) for turn in turns]
    return measure.deviation(Region(region.exterior), Outline(circle), fine)


def deviation_of(region, outline, center, model, lattice):
    if model == "circle":
        return circle_deviation(region, outline, center, lattice)
    return measure.deviation(Region(region.exterior) if model == "hull" else region, outline, lattice)


# ---- Drawings

def island(drawing, number):
    """Name and place of one of a drawing's regions."""
    if len(drawing.regions) == 1:
        return drawing.name, drawing.place
    name = f"{drawing.name}_{number}" if drawing.name else str(number)
    return name, ", ".join(filter(None, [drawing.place, f"island {number}"]))


def piece_of(drawing, number, options):
    """A single island lies about the origin that the author chose, one of several about its own center of area."""
    region, lattice = drawing.regions[number], lattice_of(options)
    name, place = island(drawing, number)
    with faults_at(place):
        piece.check_span(region, options.scale)
        outline = outline_of(region, drawing.exact, options, lattice)
        choice = options.origin if len(drawing.regions) == 1 else "area"
        center = piece.origin(choice, drawing.size, [outline], lattice)
        piece.check_extent(outline, center, lattice)
        deviation = deviation_of(region, outline, center, options.model, lattice)
        parts = parts_of(outline, options.model, lattice)
        return piece.fit(name, place, region, outline, parts, center, deviation, lattice)


def bake(drawing, options, journal):
    """One Piece for each Region."""
    return [piece_of(drawing, number, options) for number in range(len(drawing.regions))]


def origin_of(drawing, pieces, options):
    """The lattice point of the picture about which all its pieces are placed together."""
    if len(pieces) == 1:
        return pieces[0].origin
    return piece.origin(options.origin, drawing.size, [each.outline for each in pieces], lattice_of(options))
