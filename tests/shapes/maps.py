# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# A small map as Tiled writes it: files for the tests of tiled.py and for the way from map to game.
import json
import xml.etree.ElementTree as etree
from pathlib import Path

from PIL import Image, ImageDraw

TILE = 16
SLOPE = [(0, 16), (16, 16), (16, 4)]
TALL = [(4, 0), (20, 8), (20, 40), (4, 40)]

# Tile 0 is air, 1 a block, 2 a slope, 3 a block with a bump: two shapes.
TILESET = f"""<?xml version="1.0" encoding="UTF-8"?>
<tileset version="1.10" tiledversion="1.10.2" name="ground" tilewidth="16" tileheight="16" tilecount="4" columns="2">
 <image source="ground.png" width="32" height="32"/>
 <tile id="1"><objectgroup draworder="index" id="2"><object id="1" x="0" y="0" width="16" height="16"/></objectgroup></tile>
 <tile id="2"><objectgroup draworder="index" id="2"><object id="1" x="0" y="16">
  <polygon points="0,0 16,0 16,-12"/></object></objectgroup></tile>
 <tile id="3"><objectgroup draworder="index" id="2">
  <object id="1" x="0" y="8" width="16" height="8"/>
  <object id="2" name="bump" x="4" y="2" width="8" height="4"><ellipse/></object></objectgroup></tile>
</tileset>
"""

MAP = """<?xml version="1.0" encoding="UTF-8"?>
<map version="1.10" tiledversion="1.10.2" orientation="orthogonal" renderorder="right-down" width="12" height="8"
 tilewidth="16" tileheight="16" infinite="0" nextlayerid="5" nextobjectid="9">
 <tileset firstgid="1" source="ground.tsx"/>
 <tileset firstgid="5" name="tall" tilewidth="24" tileheight="40" tilecount="1" columns="1">
  <image source="tall.png" width="24" height="40"/>
  <tile id="0"><objectgroup draworder="index" id="2"><object id="1" name="tree" x="4" y="0">
   <polygon points="0,0 16,8 16,40 0,40"/></object></objectgroup></tile>
 </tileset>
 <layer id="1" name="floor" width="12" height="8">
  <data encoding="csv">
{rows}
</data>
 </layer>
 <objectgroup id="2" name="rocks" offsetx="2" offsety="-1">
  <object id="1" name="arch" x="20" y="10">
   <polygon points="0,0 40,0 40,30 30,30 30,10 10,10 10,30 0,30"/></object>
  <object id="2" name="pond" x="80" y="12" width="40" height="20"><ellipse/></object>
  <object id="3" x="140" y="20" width="24" height="12" rotation="30"/>
  <object id="4" name="crate" gid="2" x="70" y="60" width="24" height="8" rotation="-90"/>
  <object id="5" name="start" x="8" y="8"><point/></object>
  <object id="6" name="lower floor" x="0" y="126" width="192" height="2"/>
 </objectgroup>
</map>
"""

# The slope in its eight states on the third row; flips are the upper three bits of a number.
FLIPS = (0x00000000, 0x80000000, 0x40000000, 0xC0000000, 0x20000000, 0xA0000000, 0x60000000, 0xE0000000)
ROWS = [[0] * 12, [0] * 12, [3 | flips for flips in FLIPS] + [0] * 4, [0] * 12, [1] * 12, [0, 0, 5] + [0] * 9,
        [4, 4] + [0] * 8 + [3, 2], [2] * 12]


def write_map(folder, rows=ROWS):
    """Writes level.tmx, ground.tsx, ground.png and tall.png; returns the path of the map."""
    folder = Path(folder)
    _draw(folder / "ground.png", (32, 32), [[(16, 0), (31, 0), (31, 15), (16, 15)], [(x, y + 16) for x, y in SLOPE],
                                            [(16, 24), (31, 24), (31, 31), (16, 31)]])
    _draw(folder / "tall.png", (24, 40), [TALL])
    (folder / "ground.tsx").write_text(TILESET)
    path = folder / "level.tmx"
    path.write_text(MAP.format(rows=",\n".join(",".join(map(str, row)) for row in rows)))
    return path


def _draw(path, size, polygons):
    picture = Image.new("RGBA", size)
    for polygon in polygons:
        ImageDraw.Draw(picture).polygon(polygon, fill=(90, 70, 50, 255))
    picture.save(path)


# ---- The same as JSON

LISTS = {"layer": "layers", "objectgroup": "layers", "group": "layers", "tileset": "tilesets", "tile": "tiles", "object": "objects",
         "chunk": "chunks"}
LAYER = {"layer": "tilelayer", "objectgroup": "objectgroup", "group": "group"}


def write_json(path):
    """Writes the twin of a .tmx or .tsx, .tmj or .tsj, with those of the tile sets that it names; returns its path."""
    twin = path.with_suffix(".tmj" if path.suffix == ".tmx" else ".tsj")
    content = _twin(etree.parse(path).getroot())
    for tileset in content.get("tilesets", []):
        if "source" in tileset:
            tileset["source"] = write_json(path.parent / tileset["source"]).name
    twin.write_text(json.dumps(content))
    return twin


def _twin(element):
    content = {key: _value(key, text) for key, text in element.attrib.items()}
    if element.tag in ("map", "tileset"):
        content |= {"type": element.tag, "layers": []} if element.tag == "map" else {"type": "tileset", "spacing": 0, "margin": 0} | content
    if element.tag in LAYER:
        content = {"type": LAYER[element.tag], "name": "", "visible": True, "opacity": 1, "draworder": "topdown"} | content
    if element.tag == "object":
        content = {"name": "", "visible": True, "width": 0, "height": 0, "rotation": 0} | content
    for child in element:
        _add(content, element, child)
    return content


def _add(content, element, child):
    if child.tag in ("polygon", "polyline"):
        content[child.tag] = [dict(zip("xy", map(float, pair.split(",")))) for pair in child.get("points").split()]
    elif child.tag in ("ellipse", "point"):
        content[child.tag] = True
    elif child.tag == "image":
        content |= {"image": child.get("source"), "imagewidth": int(child.get("width")), "imageheight": int(child.get("height"))}
    elif child.tag == "data":
        _add_data(content, child)
    elif element.tag == "tile":
        content[child.tag] = _twin(child)
    else:
        content.setdefault(LISTS[child.tag], []).append(_twin(child))


def _add_data(content, data):
    if data.get("encoding") == "csv":
        content["data"] = [int(word) for word in data.text.split(",")]
    else:
        content |= {"data": data.text.strip(), "encoding": "base64", "compression": data.get("compression", "")}


def _value(key, text):
    if key in ("name", "source", "version", "tiledversion"):
        return text
    if key in ("visible", "infinite"):
        return text == "1"
    try:
        return float(text) if "." in text else int(text)
    except ValueError:
        return text
