# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# A Tiled map's layers: what stands where. Objects become drawings of their own; a tile's shapes become one drawing
# each for all its places, or one with everything in the layer, merged.
from dataclasses import replace

import numpy as np
import pytiled_parser as tiled
import shapely
from pytiled_parser import tiled_object as kinds
from shapely import affinity

from . import objects, tiles, vectors
from .faults import ShapeFault
from .model import Placement, Source

# Where an object's position lies in its tile, in parts of the tile's width and height.
ANCHORS = {"topleft": (0, 0), "top": (0.5, 0), "topright": (1, 0), "left": (0, 0.5), "center": (0.5, 0.5), "right": (1, 0.5),
           "bottomleft": (0, 1), "bottom": (0.5, 1), "bottomright": (1, 1)}


class MapReader:
    def __init__(self, parsed, sets, merge, journal):
        self.map, self.sets, self.merge, self.journal = parsed, sets, merge, journal
        self.drawings, self.placements, self.names = [], [], vectors.Names()
        self.stamps, self.tile_drawings = {}, {}

    def read(self):
        self._layers(self.map.layers, np.zeros(2), "")
        return Source(self.drawings, self.placements)

    def _layers(self, layers, offset, group):
        for layer in layers or []:
            name = f"{group}{layer.name}"
            place = f"layer {name}"
            moved = offset + layer.offset    # a group moves what is in it
            vectors.finite(moved, place)
            if not layer.visible:
                self.journal.note("hidden; skipped", place)
            elif isinstance(layer, tiled.LayerGroup):
                self._layers(layer.layers, moved, f"{name}/")
            elif isinstance(layer, tiled.TileLayer):
                (self._merged if self.merge else self._separate)(layer, moved, place)
            elif isinstance(layer, tiled.ObjectLayer):
                for thing in layer.tiled_objects:
                    self._object(thing, moved)

    # ---- Tile layers

    def _separate(self, layer, offset, place):
        for gid, corner in self._corners(layer, offset, place):
            self._place(self._drawings(gid, place), corner)

    def _merged(self, layer, offset, place):
        """Everything solid in a layer as one drawing: neighbors grow together, without seams."""
        shapes = [(shape, corner) for gid, corner in self._corners(layer, offset, place) for shape in self._stamp(gid, place)[0]]
        if shapes:
            ground = shapely.disjoint_subset_union_all([affinity.translate(shape.geometry, *corner) for shape, corner in shapes])
            ground = vectors.parted(ground, self.journal, place)
            self._add(layer.name, layer.id, place, ground, all(shape.exact for shape, _ in shapes), (0, 0))

    def _corners(self, layer, offset, place):
        """Each placed tile that has shapes: its number with its flips, and its upper left corner on the map."""
        for column, row, gid in _cells(layer, place):
            shapes, shift = self._stamp(gid, f"{place}, tile ({column}, {row})")
            if shapes:
                cell = np.array([column, row + 1]) * self.map.tile_size
                yield gid, cell + offset + shift

    def _stamp(self, gid, place):
        """The shapes of a tile, flipped, and its upper left corner from the lower left corner of its cell."""
        if gid not in self.stamps:
            tileset, number = self.sets.find(gid & tiles.NUMBER, place)
            box = self.sets.box(tileset, number)
            self._refuse_scaled(tileset, box)
            shapes = [replace(shape, geometry=box.turn(shape.geometry, gid & tiles.FLIPS)) for shape in self.sets.shapes(tileset, number)]
            shift = np.array([0, -box.turned(gid & tiles.FLIPS).height]) + (tileset.tile_offset or (0, 0))
            self.stamps[gid] = shapes, shift
        return self.stamps[gid]

    def _refuse_scaled(self, tileset, box):
        if tileset.tile_render_size == "grid" and (box.width, box.height) != tuple(self.map.tile_size):
            raise ShapeFault("scales its tiles to the map's grid: choose the Tile Render Size 'Tile Size'", f"tile set {tileset.name}")

    def _drawings(self, gid, place):
        """The numbers of the drawings of a tile."""
        if gid not in self.tile_drawings:
            tileset, number = self.sets.find(gid & tiles.NUMBER, place)
            new = self.sets.drawings(tileset, number, gid & tiles.FLIPS, self.names, f"{tileset.name}_")
            self.tile_drawings[gid] = range(len(self.drawings), len(self.drawings) + len(new))
            self.drawings += new
        return self.tile_drawings[gid]

    # ---- Object layers

    def _object(self, thing, offset):
        place = objects.place_of(thing)
        if isinstance(thing, kinds.Tile) and thing.visible:
            self._tile_object(thing, offset, place)
        elif shape := objects.outline(thing, place, self.journal):
            self._add(shape.name, shape.id, place, shape.geometry, shape.exact, offset)

    def _tile_object(self, thing, offset, place):
        vectors.finite([*thing.coordinates, *thing.size, thing.rotation], place)
        tileset, number = self.sets.find(thing.gid & tiles.NUMBER, place)
        flips, own = thing.gid & tiles.FLIPS, self.sets.box(tileset, number)
        size = tiles.Box(*thing.size) if any(thing.size) else own
        shapes = self.sets.shapes(tileset, number)
        if not shapes or min(size.width, size.height) <= 0:
            return self.journal.note("its tile has no collision shapes, or it has no size; skipped", place)
        scale = np.array([size.width / own.width, size.height / own.height])
        if tileset.fill_mode != "stretch" and scale[0] != scale[1]:
            raise ShapeFault("does not stretch its tile to the object's shape: choose the Fill Mode 'Stretch'", place)
        corner = _corner(tileset, size.turned(flips), scale)
        if own == size and not thing.rotation:
            return self._place(self._drawings(thing.gid, place), corner + thing.coordinates + offset)
        for shape in shapes:
            scaled = size.turn(affinity.scale(shape.geometry, *scale, origin=(0, 0)), flips)
            geometry = objects.put(affinity.translate(scaled, *corner), thing)
            self._add(thing.name, thing.id, f"{place}, {self.sets.place(tileset, number)}", geometry, shape.exact, offset)

    # ---- Both

    def _add(self, name, number, place, geometry, exact, offset):
        drawing, corner = vectors.drawing(self.names.give(name or str(number), number), place, geometry, exact)
        self.drawings.append(drawing)
        self._place([len(self.drawings) - 1], corner + np.asarray(offset))

    def _place(self, drawings, corner):
        self.placements += [Placement(number, float(corner[0]), float(corner[1])) for number in drawings]


def _corner(tileset, box, scale):
    """The upper left corner of a tile object from its position."""
    right, down = ANCHORS.get(tileset.alignment, ANCHORS["bottomleft"])
    return np.array([-right * box.width, -down * box.height]) + scale * (tileset.tile_offset or (0, 0))


def _cells(layer, place):
    """Column, row and number of each tile in a layer."""
    blocks = [((0, 0), layer.size, layer.data)] if layer.data is not None else []
    blocks += [(chunk.coordinates, chunk.size, chunk.data) for chunk in layer.chunks or []]
    for (left, top), (width, height), rows in blocks:
        if [len(row) for row in rows] != [width] * height:
            raise ShapeFault(f"does not hold {width} x {height} tiles", place)
        grid = np.array(rows, dtype=np.int64)
        for row, column in np.argwhere(grid & tiles.NUMBER):
            yield int(left + column), int(top + row), int(grid[row, column])
