# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Shapes that were drawn as lines, not pixels: what maps and SVG have in common on the way from shapely's geometry
# to Regions and Drawings.
import math
import re
from itertools import chain, count

import numpy as np
import shapely
from shapely.validation import explain_validity

from .faults import ShapeFault
from .model import Drawing, Region
from .names import cleaned

# Pixels that a curve and its polygon may be apart: under one step of the usual lattice of 1/64 unit, so that it
# does not add to the error that is measured against the polygon.
FLATNESS = 0.01

# Pixels: less than half a pixel, so that nothing that was there is gone, and many steps of the lattice.
CUT = 0.25


class Names:
    """Gives each drawing a name of its own, by the number that its file knows it by; also where C sees less of a name."""

    def __init__(self):
        self.taken = set()

    def give(self, wanted, number):
        tries = chain([wanted, f"{wanted}_{number}"], (f"{wanted}_{number}_{again}" for again in count(2)))
        return next(name for name in tries if self._take(name))

    def _take(self, name):
        key = cleaned(name)
        fresh = key not in self.taken
        self.taken.add(key)
        return fresh


def finite(values, place):
    """Refuses NaN and infinity, which both XML and JSON can smuggle in."""
    if not np.isfinite(np.asarray(values, dtype=np.float64)).all():
        raise ShapeFault("a coordinate is not a finite number", place)


def polygon(points, place, put=lambda geometry: geometry):
    """The polygon with these corners, put in its place on the picture. Checked before, as turning it rounds."""
    finite(points, place)
    if len(np.unique(np.asarray(points), axis=0)) < 3:
        raise ShapeFault("has fewer than three different points", place)
    shape = shapely.Polygon(points)
    if shape.convex_hull.area == 0:
        raise ShapeFault("has no area: its points lie on one line", place)
    if not shape.is_valid:
        raise ShapeFault(f"crosses or touches itself{_spot(shape, put)}", place)
    return put(shape)


def _spot(shape, put):
    found = re.search(r"\[(\S+) (\S+)\]", explain_validity(shape))
    if not found:
        return ""
    point = put(shapely.Point(float(found[1]), float(found[2])))
    return f" at ({point.x:g}, {point.y:g})"


def arc_steps(radius, sweep, flatness=FLATNESS):
    """Chords that an arc of that sweep (radians) needs: a chord over the angle a is radius * (1 - cos(a / 2)) off."""
    return math.ceil(abs(sweep) / (2 * math.acos(max(0.0, 1 - flatness / radius))))


def ellipse(width, height):
    """The ellipse in the box from (0, 0) to (width, height); its chords are those of a circle about it, stretched."""
    steps = 4 * arc_steps(max(width, height) / 2, math.pi / 2)
    angles = np.arange(steps) * (2 * math.pi / steps)
    return shapely.Polygon(np.column_stack([width / 2 * (1 + np.cos(angles)), height / 2 * (1 + np.sin(angles))]))


def parted(geometry, journal, place):
    """Cut back where a hole of an island touches its border or another hole in a point: an outline does not touch itself.
    The cut joins the air on both sides, which takes a hole away, where a bridge would keep it."""
    touches = [point for island in shapely.get_parts(geometry) for point in _touches(island)]
    if not touches:
        return geometry
    journal.note(f"touches itself in {len(touches)} points, first at ({touches[0][0]:g}, {touches[0][1]:g}): cut back by {CUT} px", place)
    return shapely.difference(geometry, shapely.union_all([_diamond(*point) for point in touches]))


def _touches(island):
    rings = np.array([island.exterior, *island.interiors])
    one, other = shapely.STRtree(rings).query(rings, predicate="intersects")
    once = one < other
    return shapely.get_coordinates(shapely.intersection(rings[one[once]], rings[other[once]]))


def _diamond(x, y):
    return shapely.Polygon([(x - CUT, y), (x, y - CUT), (x + CUT, y), (x, y + CUT)])


def regions(geometry):
    """The islands of some geometry, in reading order."""
    islands = [part for part in shapely.get_parts(geometry) if part.area > 0]
    return [_region(island) for island in sorted(islands, key=_reading_order)]


def _reading_order(island):
    return min((y, x) for x, y in island.exterior.coords)


def _region(island):
    # Counterclockwise where y grows up is a positive shoelace sum whichever way y grows.
    island = shapely.orient_polygons(island)
    exterior, *holes = [shapely.get_coordinates(ring)[:-1] for ring in [island.exterior, *island.interiors]]
    return Region(exterior, holes)


def drawing(name, place, geometry, exact):
    """A drawing of some geometry, and where its (0, 0) lies: the next whole pixel up and left. A whole one, so that
    neighbors with a common edge still have it in common when each has been rounded to the lattice."""
    finite(geometry.bounds, place)
    left, top, right, bottom = geometry.bounds
    x, y = math.floor(left + 1e-9), math.floor(top + 1e-9)    # turning by a right angle leaves dust
    size = (math.ceil(right - 1e-9) - x, math.ceil(bottom - 1e-9) - y)
    moved = shapely.transform(geometry, lambda points: points - (x, y))
    return Drawing(name, place, regions(moved), size, exact=exact), (float(x), float(y))
