# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# One of Tiled's objects, on a map or in a tile's collision group: its outline, turned and where it is.
from dataclasses import dataclass

import shapely
from pytiled_parser import tiled_object as kinds
from shapely import affinity

from . import vectors
from .faults import ShapeFault


@dataclass
class Shape:
    """A collision shape in the pixels of its tile or map."""

    id: int
    name: str
    geometry: shapely.Polygon
    exact: bool


def outline(thing, place, journal):
    """The Shape of an object that has one; None with a note where it has none."""
    vectors.finite([*thing.coordinates, *thing.size, thing.rotation], place)
    if not thing.visible:
        return journal.note("hidden; skipped", place)
    if isinstance(thing, kinds.Point | kinds.Text):
        return journal.note("a point or text has no outline; skipped", place)
    geometry = _polygon(thing, place) if isinstance(thing, kinds.Polygon | kinds.Polyline) else _box(thing)
    if geometry is None:
        return journal.note("without width or height; skipped", place)
    return Shape(thing.id, thing.name, geometry, not isinstance(thing, kinds.Ellipse))


def put(geometry, thing):
    """Geometry about an object's position, turned with it and moved to where it is. Degrees go clockwise, as y grows down."""
    turned = affinity.rotate(geometry, thing.rotation % 360, origin=(0, 0))
    return affinity.translate(turned, *thing.coordinates)


def _polygon(thing, place):
    points = list(thing.points)
    if isinstance(thing, kinds.Polyline) and (len(points) < 2 or points[0] != points[-1]):
        raise ShapeFault("is an open polyline: make it a polygon, or end it where it begins", place)
    return vectors.polygon(points, place, lambda geometry: put(geometry, thing))


def _box(thing):
    width, height = thing.size
    if width <= 0 or height <= 0:
        return None
    flat = vectors.ellipse(width, height) if isinstance(thing, kinds.Ellipse) else shapely.box(0, 0, width, height)
    return put(flat, thing)


def place_of(thing):
    return f"object {thing.id} ({thing.name})" if thing.name else f"object {thing.id}"
