# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Tiled's maps and tile sets in: pytiled-parser reads TMX, TSX and JSON; here its objects and tiles become drawings
# and placements. What the library reads wrongly or not at all is looked for first, and refused.
import importlib.util
import json
from pathlib import Path

import pytiled_parser

from . import markup
from .faults import ShapeFault
from .model import Source
from .tilemap import MapReader
from .tiles import Tiles
from .vectors import Names

ENCODING = "utf-8-sig"    # Tiled writes UTF-8; other editors put a byte order mark in front
NUMBERS = {"id", "gid", "firstgid", "x", "y", "width", "height", "rotation", "offsetx", "offsety", "tilewidth", "tileheight",
           "tilecount", "columns", "margin", "spacing"}


def read(path, options, journal):
    """The collision shapes of a map, with their placements, or of a tile set."""
    path = Path(path)
    source = _tileset(path, journal) if _look_over(path) == "tileset" else _map(path, options, journal)
    if not source.drawings:
        raise ShapeFault("has no collision shapes")
    return source


def _map(path, options, journal):
    parsed = _parsed(pytiled_parser.parse_map, path)
    if parsed.orientation != "orthogonal":
        raise ShapeFault(f"is {parsed.orientation}; only orthogonal maps are read")
    reader = MapReader(parsed, Tiles(parsed.tilesets, path.parent, journal), getattr(options, "merge", False), journal)
    return reader.read()


def _tileset(path, journal):
    tileset = _parsed(pytiled_parser.parse_tileset, path)
    tiles, names = Tiles({1: tileset}, path.parent, journal), Names()
    return Source([drawing for number in sorted(tileset.tiles or {}) for drawing in tiles.drawings(tileset, number, 0, names, "")])


def _parsed(parse, path):
    try:
        return parse(path, encoding=ENCODING)
    except KeyError as fault:
        raise ShapeFault(f"is not as Tiled writes it: {fault} is missing") from None
    except Exception as fault:    # the library checks nothing, so that bad content raises whatever came up
        raise ShapeFault(f"is not as Tiled writes it: {fault or type(fault).__name__}") from None


def _look_over(path, place=""):
    """'map' or 'tileset'. Refuses what the library cannot read, in tile sets of other files too."""
    data = markup.content(path, place)
    kind, records = _xml(data, place) if markup.is_xml(data) else _json(data, place)
    for spot, values in records:
        where = ", ".join(word for word in (place, spot) if word)
        _refuse(values, where)
        if "firstgid" in values and "source" in values:
            _look_over_tileset(path.parent / str(values["source"]), f"tile set {values['source']}")
    return kind


def _look_over_tileset(path, place):
    if _look_over(path, place) != "tileset":
        raise ShapeFault("is not a tile set", place)


def _xml(data, place):
    elements = markup.elements(data, place)
    root = elements[0]
    kind = _kind(root.tag, root.attributes, place)
    return kind, [(f"line {element.line}", {element.tag: True} | element.attributes) for element in elements]


def _json(data, place):
    try:
        root = json.loads(data)
        records = list(_objects(root))
    except (ValueError, RecursionError) as fault:
        raise ShapeFault(f"is neither XML nor JSON: {fault}", place) from None
    if not isinstance(root, dict):
        raise ShapeFault("is JSON, but no Tiled map or tile set", place)
    guess = "map" if "layers" in root else "tileset" if "tilecount" in root else "unknown"
    return _kind(root.get("type", guess), root, place), records


def _objects(value):
    """The place and content of every JSON object, but for properties: their names are the author's."""
    if isinstance(value, dict):
        yield f"id {value['id']}" if "id" in value else "", value
    for key, child in value.items() if isinstance(value, dict) else enumerate(value):
        if isinstance(child, dict | list) and key != "properties":
            yield from _objects(child)


def _kind(kind, root, place):
    if kind not in ("map", "tileset"):
        raise ShapeFault(f"is '{kind}'; Tiled maps and tile sets are read", place)
    if str(root.get("version", 1)).split(".")[0] != "1":
        raise ShapeFault(f"has the format version {root['version']}; versions 1.x are read", place)
    return kind


def _refuse(values, place):
    if "template" in values:
        # The library mixes up what the template says and what the object changes.
        raise ShapeFault("is made from a template: detach it in Tiled", place)
    if "capsule" in values:
        raise ShapeFault("a capsule is not read: draw a polygon or an ellipse", place)
    if "tile" in values and "gid" in values:
        raise ShapeFault("tile data as XML is not read: choose CSV or Base64 as the Tile Layer Format in the map's properties", place)
    if values.get("compression") == "zstd" and not importlib.util.find_spec("zstd"):
        raise ShapeFault("Zstandard data needs the Python package zstd: get it, or choose another Tile Layer Format", place)
    for key in NUMBERS & values.keys():
        _refuse_words(key, values[key], place)


def _refuse_words(key, value, place):
    try:
        float(value)
    except (TypeError, ValueError):
        raise ShapeFault(f"'{key}' is not a number: {value!r}", place) from None
