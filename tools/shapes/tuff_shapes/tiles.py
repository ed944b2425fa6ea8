# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The tiles of Tiled's tile sets: which tile a number means, its collision shapes and its picture, both also flipped.
from dataclasses import dataclass, field, replace
from pathlib import Path

from PIL import Image, UnidentifiedImageError
from pytiled_parser import tiled_object as kinds
from shapely import affinity

from . import objects, vectors
from .faults import ShapeFault
from .model import Drawing

FLIP_X, FLIP_Y, FLIP_DIAGONAL = 0x80000000, 0x40000000, 0x20000000
FLIPS = FLIP_X | FLIP_Y | FLIP_DIAGONAL
NUMBER = 0x0FFFFFFF    # the fourth of the upper bits turns hexagonal tiles only


@dataclass(frozen=True)
class Box:
    """The pixels that a tile covers; turn() flips what lies in it as Tiled does: first over the diagonal."""

    width: float
    height: float

    def turned(self, flips):
        return Box(self.height, self.width) if flips & FLIP_DIAGONAL else self

    def turn(self, geometry, flips):
        box = self.turned(flips)
        if flips & FLIP_DIAGONAL:
            geometry = affinity.affine_transform(geometry, [0, 1, 1, 0, 0, 0])
        if flips & FLIP_X:
            geometry = affinity.affine_transform(geometry, [-1, 0, 0, 1, box.width, 0])
        if flips & FLIP_Y:
            geometry = affinity.affine_transform(geometry, [1, 0, 0, -1, 0, box.height])
        return geometry


def flip_letters(flips):
    """The flips for a name: '', or of 'd', 'h' and 'v' those that there are."""
    return "".join(letter for letter, bit in (("d", FLIP_DIAGONAL), ("h", FLIP_X), ("v", FLIP_Y)) if flips & bit)


@dataclass
class Tiles:
    """The tile sets of a map, by the number of their first tile."""

    sets: dict
    folder: Path
    journal: object
    shapes_of: dict = field(default_factory=dict)
    sheets: dict = field(default_factory=dict)

    def find(self, number, place):
        """The tile set that a tile number of a map is from, and the tile's number in it."""
        first = max((first for first in self.sets if first <= number), default=None)
        if first is None or number - first >= max([self.sets[first].tile_count, *_past_the_last(self.sets[first])]):
            raise ShapeFault(f"tile number {number} is in no tile set", place)
        return self.sets[first], number - first

    def place(self, tileset, number):
        return f"tile {number} of {tileset.name}" if len(self.sets) > 1 else f"tile {number}"

    def box(self, tileset, number):
        own = (tileset.tiles or {}).get(number)
        return Box(own.width, own.height) if own and own.width and own.height else Box(tileset.tile_width, tileset.tile_height)

    def shapes(self, tileset, number):
        """The collision shapes of a tile."""
        key = (tileset.firstgid, number)
        if key not in self.shapes_of:
            self.shapes_of[key] = self._read_shapes(tileset, number)
        return self.shapes_of[key]

    def _read_shapes(self, tileset, number):
        own = (tileset.tiles or {}).get(number)
        if own is None or own.objects is None:
            return []
        if tileset.grid is not None and tileset.grid.orientation != "orthogonal":
            raise ShapeFault("has no orthogonal grid", f"tile set {tileset.name}")
        found = []
        for thing in own.objects.tiled_objects:
            place = f"{self.place(tileset, number)}, {objects.place_of(thing)}"
            if isinstance(thing, kinds.Tile):
                self.journal.note("a tile is no collision shape; skipped", place)
            else:
                found.append(objects.outline(thing, place, self.journal))
        return [shape for shape in found if shape]

    def drawings(self, tileset, number, flips, names, prefix):
        """A tile's shapes as drawings; (0, 0) is the tile's upper left corner. Those without a name are called by number."""
        own, letters = self.box(tileset, number), flip_letters(flips)
        box, place = own.turned(flips), self.place(tileset, number) + (f" flipped {letters}" if letters else "")
        made, shapes = [], self.shapes(tileset, number)
        for shape in shapes:
            where = f"{place}, {objects.place_of(shape)}" if len(shapes) > 1 else place
            name = "_".join(word for word in (shape.name or f"{prefix}{number}", letters) if word)
            ground = vectors.regions(own.turn(shape.geometry, flips))
            made.append(Drawing(names.give(name, shape.id), where, ground, (box.width, box.height), exact=shape.exact))
        picture = self.image(tileset, number, flips) if made else None
        return [replace(drawing, image=picture) for drawing in made]

    def image(self, tileset, number, flips):
        """The picture of a tile, or None with a note."""
        own = (tileset.tiles or {}).get(number)
        if own is not None and own.image is not None:
            left, top, box = own.x, own.y, self.box(tileset, number)
            sheet = self._sheet(own.image)
        elif tileset.image is not None and tileset.columns > 0:
            box = Box(tileset.tile_width, tileset.tile_height)
            row, column = divmod(number, tileset.columns)
            left, top = (tileset.margin + index * (step + tileset.spacing) for index, step in
                         ((column, box.width), (row, box.height)))
            sheet = self._sheet(tileset.image)
        else:
            return None
        return sheet and _flipped(sheet.crop((left, top, left + box.width, top + box.height)), flips)

    def _sheet(self, path):
        path = self.folder / path    # what the library has found in another file's folder is absolute and stays
        if path not in self.sheets:
            self.sheets[path] = self._open(path)
        return self.sheets[path]

    def _open(self, path):
        try:
            with Image.open(path) as picture:
                return picture.convert("RGBA")
        except (OSError, UnidentifiedImageError, Image.DecompressionBombError, ValueError, SyntaxError):
            return self.journal.note("this picture cannot be read; its tiles are shown without it", path.name)


def _past_the_last(tileset):
    """Collections of pictures may have gaps: their numbers reach beyond the count."""
    return [number + 1 for number in tileset.tiles or {}]


def _flipped(picture, flips):
    for bit, way in ((FLIP_DIAGONAL, Image.Transpose.TRANSPOSE), (FLIP_X, Image.Transpose.FLIP_LEFT_RIGHT),
                     (FLIP_Y, Image.Transpose.FLIP_TOP_BOTTOM)):
        picture = picture.transpose(way) if flips & bit else picture
    return picture
