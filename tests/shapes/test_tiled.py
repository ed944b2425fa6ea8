# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Tiled's maps and tile sets: what stands where, in each way that Tiled writes it, and what is refused.
import base64
import gzip
import json
import math
import struct
import zlib
from types import SimpleNamespace

import maps
import numpy as np
import pytest
import shapely
from PIL import Image
from tuff_shapes import tiled
from tuff_shapes.faults import Journal, ShapeFault

HEAD = ('<map version="1.10" tiledversion="1.10.2" orientation="orthogonal" renderorder="right-down" width="4" height="3" tilewidth="16"'
        ' tileheight="16" infinite="0" nextlayerid="9" nextobjectid="9">')
SET = '<tileset firstgid="1" source="ground.tsx"/>'


def read(path, **options):
    journal = Journal(path.name)
    return tiled.read(path, SimpleNamespace(**options), journal), journal.notes


def written(folder, text, name="test.tmx"):
    maps.write_map(folder)
    path = folder / name
    path.write_text(text)
    return path


def of_map(folder, body, **options):
    return read(written(folder, f"{HEAD}{SET}{body}</map>"), **options)


def of_objects(folder, body, **options):
    return of_map(folder, f'<objectgroup id="1" name="objects">{body}</objectgroup>', **options)


def layer(rows, **attributes):
    extra = "".join(f' {key}="{value}"' for key, value in attributes.items())
    data = ",".join(str(gid) for row in rows for gid in row)
    return f'<layer id="7" name="floor" width="{len(rows[0])}" height="{len(rows)}"{extra}><data encoding="csv">{data}</data></layer>'


def fault(call, *arguments, **options):
    with pytest.raises(ShapeFault) as caught:
        call(*arguments, **options)
    return str(caught.value)


def polygon(region):
    return shapely.Polygon(region.exterior, region.holes)


def shoelace(ring):
    x, y = ring.T
    return np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)


def on_map(source, number):
    """The ground of one placement, in map pixels."""
    placement = source.placements[number]
    regions = source.drawings[placement.drawing].regions
    return shapely.transform(shapely.union_all([polygon(region) for region in regions]), lambda points: points + (placement.x, placement.y))


def corners(source, number=0):
    return {tuple(point) for point in shapely.get_coordinates(on_map(source, number)).round(6).tolist()}


def same(first, second):
    assert first.placements == second.placements
    assert [drawing.name for drawing in first.drawings] == [drawing.name for drawing in second.drawings]
    for one, other in zip(first.drawings, second.drawings):
        assert (one.place, one.size, one.exact) == (other.place, other.size, other.exact)
        assert all(np.array_equal(a.exterior, b.exterior) for a, b in zip(one.regions, other.regions, strict=True))


# ---- Objects

def test_a_rectangle_keeps_its_corners(tmp_path):
    source, notes = of_objects(tmp_path, '<object id="4" name="Door 1" x="10.5" y="20" width="30" height="40"/>')
    drawing = source.drawings[0]
    assert corners(source) == {(10.5, 20), (40.5, 20), (40.5, 60), (10.5, 60)}
    assert (drawing.name, drawing.place, drawing.exact, drawing.image) == ("Door 1", "object 4 (Door 1)", True, None)
    assert (source.placements[0].x, source.placements[0].y, drawing.size) == (10, 20, (31, 40)) and not notes


def test_rotation_is_clockwise_about_the_position(tmp_path):
    source, _ = of_objects(tmp_path, '<object id="1" x="100" y="50" width="30" height="10" rotation="90"/>')
    assert corners(source) == {(100, 50), (100, 80), (90, 80), (90, 50)}
    source, _ = of_objects(tmp_path, '<object id="1" x="0" y="0" width="10" height="10" rotation="45"/>')
    half = round(math.sqrt(50), 6)
    assert corners(source) == {(0, 0), (half, half), (0, 2 * half), (-half, half)}


def test_a_polygon_may_go_either_way_round(tmp_path):
    points = "0,0 40,0 40,30 20,10 0,30"
    back = " ".join(reversed(points.split()))
    body = [f'<object id="{number}" x="8" y="4"><polygon points="{way}"/></object>' for number, way in enumerate((points, back), 1)]
    source, _ = of_objects(tmp_path, "".join(body))
    assert corners(source, 0) == corners(source, 1) == {(8, 4), (48, 4), (48, 34), (28, 14), (8, 34)}
    assert all(shoelace(drawing.regions[0].exterior) > 0 for drawing in source.drawings)


def test_a_closed_polyline_is_a_polygon(tmp_path):
    source, _ = of_objects(tmp_path, '<object id="1" x="0" y="0"><polyline points="0,0 9,0 9,9 0,0"/></object>')
    assert corners(source) == {(0, 0), (9, 0), (9, 9)} and source.drawings[0].exact


@pytest.mark.parametrize(("width", "height"), [(40, 40), (60, 12), (2000, 1500), (0.5, 0.25)])
def test_an_ellipse_is_within_a_hundredth_of_a_pixel(tmp_path, width, height):
    body = f'<object id="1" x="7" y="9" width="{width}" height="{height}" rotation="30"><ellipse/></object>'
    source, _ = of_objects(tmp_path, body)
    angles = np.linspace(0, 2 * math.pi, 20000)
    x, y = width / 2 * (1 + np.cos(angles)), height / 2 * (1 + np.sin(angles))
    c, s = math.cos(math.radians(30)), math.sin(math.radians(30))
    truth = shapely.points(7 + c * x - s * y, 9 + s * x + c * y)
    assert shapely.distance(on_map(source, 0).exterior, truth).max() <= 0.01
    assert not source.drawings[0].exact


def test_what_has_no_outline_is_noted_and_skipped(tmp_path):
    source, notes = of_objects(tmp_path, """
        <object id="1" x="0" y="0" width="8" height="8"/> <object id="2" name="spawn" x="5" y="5"><point/></object>
        <object id="3" x="5" y="5" width="50" height="20"><text>hello</text></object> <object id="4" x="5" y="5"/>
        <object id="5" x="5" y="5" width="9" height="9" visible="0"/>""")
    assert len(source.drawings) == 1
    assert [note.split(": ")[1] for note in notes] == ["object 2 (spawn)", "object 3", "object 4", "object 5"]


def test_names_are_made_unique(tmp_path):
    source, _ = of_objects(tmp_path, "".join(f'<object id="{i}" name="{name}" x="0" y="0" width="8" height="8"/>'
                                             for i, name in enumerate(("rock", "rock", "Rock!", "", "rock_2"), 1)))
    assert [drawing.name for drawing in source.drawings] == ["rock", "rock_2", "Rock!_3", "4", "rock_2_5"]


# ---- Layers

def test_groups_move_and_hide_their_layers(tmp_path):
    box = '<object id="{}" x="10" y="10" width="8" height="8"/>'
    source, notes = of_map(tmp_path, f"""
        <group id="1" name="g" offsetx="100" offsety="20">
        <objectgroup id="2" name="a" offsetx="0.5" offsety="-3">{box.format(1)}</objectgroup></group>
        <group id="3" name="h" visible="0"><objectgroup id="4" name="b">{box.format(2)}</objectgroup></group>
        <group id="5" name="i"><objectgroup id="6" name="c" visible="0">{box.format(3)}</objectgroup></group>""")
    assert corners(source) == {(110.5, 27), (118.5, 27), (118.5, 35), (110.5, 35)} and len(source.placements) == 1
    assert notes == ["test.tmx: layer h: hidden; skipped", "test.tmx: layer i/c: hidden; skipped"]


def test_a_tile_stands_on_the_lower_left_corner_of_its_cell(tmp_path):
    source, _ = read(maps.write_map(tmp_path))
    tree = next(i for i, drawing in enumerate(source.drawings) if drawing.name == "tree")
    placed = next(placement for placement in source.placements if placement.drawing == tree)
    assert (placed.x, placed.y) == (2 * 16, 6 * 16 - 40)


def test_flipped_tiles_are_as_their_flipped_pictures(tmp_path):
    source, _ = read(maps.write_map(tmp_path))
    slopes = [drawing for drawing in source.drawings if drawing.name.startswith("ground_2")]
    assert [drawing.name[len("ground_2"):] for drawing in slopes] == ["", "_h", "_v", "_hv", "_d", "_dh", "_dv", "_dhv"]
    assert len({np.asarray(drawing.image).tobytes() for drawing in slopes}) == 8
    centers = np.argwhere(np.ones((16, 16))) + 0.5
    for drawing in slopes:
        ground = polygon(drawing.regions[0])
        solid = np.asarray(drawing.image)[..., 3].ravel() > 0
        points = shapely.points(centers[:, 1], centers[:, 0])
        clear = shapely.distance(ground.exterior, points) > 1
        assert np.array_equal(shapely.contains(ground, points)[clear], solid[clear]) and clear.sum() > 150


def test_a_diagonal_flip_mirrors_lower_left_to_upper_right(tmp_path):
    source, _ = of_map(tmp_path, layer([[0x20000003]]))
    assert corners(source) == {(16, 0), (16, 16), (4, 16)}


def test_a_tall_tile_on_its_side_stands_in_the_same_corner(tmp_path):
    path = maps.write_map(tmp_path, [[0] * 12] * 4 + [[0, 5 | 0x20000000] + [0] * 10] + [[0] * 12] * 3)
    source, _ = read(path)
    assert corners(source) == {(16, 60), (24, 76), (56, 76), (56, 60)}    # a box of 40 x 24 on (16, 80)


def test_every_shape_of_a_tile_is_a_drawing(tmp_path):
    source, _ = of_map(tmp_path, layer([[4, 4]]))
    assert [(drawing.name, drawing.exact) for drawing in source.drawings] == [("ground_3", True), ("bump", False)]
    assert [placement.drawing for placement in source.placements] == [0, 1, 0, 1]


def test_a_tile_offset_moves_tiles(tmp_path):
    maps.write_map(tmp_path)
    path = written(tmp_path, f'{HEAD}<tileset firstgid="1" source="moved.tsx"/>{layer([[2]], offsetx=100, offsety=0)}</map>')
    (tmp_path / "moved.tsx").write_text(maps.TILESET.replace("<image", '<tileoffset x="3" y="-5"/><image', 1))
    assert min(corners(read(path)[0])) == (103, -5)


def test_neighboring_objects_share_their_edge_on_the_lattice(tmp_path):
    body = '<object id="1" x="0.3" y="0.7" width="9.11" height="8"/><object id="2" x="9.41" y="0.7" width="7" height="8"/>'
    source, _ = of_objects(tmp_path, body)
    edges = [np.rint((source.drawings[p.drawing].regions[0].exterior + (p.x, p.y)) * 64) for p in source.placements]
    assert edges[0][:, 0].max() == edges[1][:, 0].min() == round(9.41 * 64)
    assert all(float(p.x).is_integer() and float(p.y).is_integer() for p in source.placements)


# ---- Tile objects

def test_a_tile_object_shares_the_drawing_of_its_tile(tmp_path):
    body = '<objectgroup id="1" name="o"><object id="1" gid="2" x="50.5" y="40" width="16" height="16"/></objectgroup>'
    source, _ = of_map(tmp_path, layer([[2]]) + body)
    assert len(source.drawings) == 1 and corners(source, 1) == {(50.5, 24), (66.5, 24), (66.5, 40), (50.5, 40)}


def test_a_tile_object_is_scaled_flipped_and_turned(tmp_path):
    source, _ = of_objects(tmp_path, '<object id="1" name="ramp" gid="2147483651" x="50" y="40" width="32" height="8" rotation="90"/>')
    # The slope flipped and scaled is (0, 8), (32, 8), (0, 2); its position is the lower left corner.
    assert corners(source) == {(50, 40), (50, 72), (56, 40)}
    assert source.drawings[0].place == "object 1 (ramp), tile 2"


@pytest.mark.parametrize(("alignment", "corner"), [("topleft", (50, 40)), ("center", (42, 32)), ("bottomright", (34, 24)),
                                                   ("top", (42, 40)), ("unspecified", (50, 24))])
def test_a_tile_object_lies_as_its_tile_set_says(tmp_path, alignment, corner):
    path = written(tmp_path, f'{HEAD}{SET}<objectgroup id="1" name="o"><object id="1" gid="2" x="50" y="40"/></objectgroup></map>')
    (tmp_path / "ground.tsx").write_text(maps.TILESET.replace('name="ground"', f'name="ground" objectalignment="{alignment}"'))
    assert min(corners(read(path)[0])) == corner


def test_a_tile_object_without_shapes_is_noted(tmp_path):
    source, notes = of_map(tmp_path, layer([[2]]) + '<objectgroup id="1" name="o"><object id="8" gid="1" x="5" y="4"/></objectgroup>')
    assert len(source.placements) == 1 and notes[0].startswith("test.tmx: object 8: ")


# ---- Ways of writing

def test_json_says_the_same(tmp_path):
    path = maps.write_map(tmp_path)
    same(read(path)[0], read(maps.write_json(path))[0])
    same_set = [read(tmp_path / name)[0] for name in ("ground.tsx", "ground.tsj")]
    assert same_set[0].placements is None and [drawing.name for drawing in same_set[0].drawings] == ["1", "2", "3", "bump"]
    assert [drawing.place for drawing in same_set[1].drawings] == ["tile 1", "tile 2", "tile 3, object 1", "tile 3, object 2 (bump)"]


def test_a_json_file_may_be_map_or_tile_set(tmp_path):
    path = maps.write_map(tmp_path)
    twins = [maps.write_json(path).rename(tmp_path / "a.json"), (tmp_path / "ground.tsj").rename(tmp_path / "b.json")]
    (tmp_path / "ground.tsj").write_text(twins[1].read_text())
    assert read(twins[0])[0].placements and read(twins[1])[0].placements is None


@pytest.mark.parametrize(("compression", "pack"), [("", bytes), ("zlib", zlib.compress), ("gzip", gzip.compress)])
def test_base64_says_the_same_as_csv(tmp_path, compression, pack):
    rows = [[0, 2, 3, 0], [0x80000003, 0, 0, 4], [2, 2, 2, 2]]
    plain, _ = of_map(tmp_path, layer(rows))
    data = base64.b64encode(pack(struct.pack("<12I", *(gid for row in rows for gid in row)))).decode()
    body = f'<layer id="1" name="floor" width="4" height="3"><data encoding="base64" compression="{compression}">{data}</data></layer>'
    same(plain, of_map(tmp_path, body)[0])
    same(plain, read(maps.write_json(tmp_path / "test.tmx"))[0])


def test_infinite_maps_reach_to_the_left_and_up(tmp_path):
    body = ('<layer id="1" name="floor" width="4" height="3"><data encoding="csv">'
            '<chunk x="-16" y="-2" width="2" height="2">0,2,0,0</chunk><chunk x="0" y="0" width="1" height="1">2</chunk></data></layer>')
    head = HEAD.replace('infinite="0"', 'infinite="1"')
    source, _ = read(written(tmp_path, f"{head}{SET}{body}</map>"))
    assert [(placement.x, placement.y) for placement in source.placements] == [(-240, -32), (0, 0)]


def test_a_byte_order_mark_is_no_fault(tmp_path):
    path = maps.write_map(tmp_path)
    plain, _ = read(path)
    path.write_bytes(b"\xef\xbb\xbf" + path.read_bytes())
    same(plain, read(path)[0])


def test_a_collection_of_pictures_has_tiles_of_any_size(tmp_path):
    Image.new("RGBA", (20, 50), "red").save(tmp_path / "big.png")
    (tmp_path / "set.tsx").write_text("""<tileset version="1.10" name="set" tilewidth="20" tileheight="50" tilecount="1" columns="0">
        <tile id="7"><image width="20" height="50" source="big.png"/><objectgroup id="1"><object id="1" x="0" y="0" width="20" height="50"/>
        </objectgroup></tile></tileset>""")
    path = written(tmp_path, f'{HEAD}<tileset firstgid="1" source="set.tsx"/>{layer([[0], [8]])}</map>')
    source, _ = read(path)
    assert corners(source) == {(0, -18), (20, -18), (20, 32), (0, 32)}
    assert source.drawings[0].image.size == (20, 50) and source.drawings[0].image.getpixel((3, 3)) == (255, 0, 0, 255)


def test_a_lost_picture_is_noted_once(tmp_path):
    path = maps.write_map(tmp_path)
    (tmp_path / "ground.png").unlink()
    source, notes = read(path)
    assert all(drawing.image is None for drawing in source.drawings if drawing.name.startswith("ground"))
    assert sum("ground.png" in note for note in notes) == 1


# ---- Merging

def test_merged_tiles_have_no_seams(tmp_path):
    source, _ = of_map(tmp_path, layer([[2, 2, 2, 0], [2, 0, 2, 0], [2, 2, 2, 0x80000003]]), merge=True)
    assert len(source.drawings) == 1 == len(source.placements)
    region, = source.drawings[0].regions
    ground = polygon(region)
    assert ground.area == 8 * 256 + 96 and len(region.holes) == 1
    assert shoelace(region.exterior) > 0 > shoelace(region.holes[0])
    assert (source.drawings[0].name, source.drawings[0].place, source.drawings[0].exact) == ("floor", "layer floor", True)


def test_a_merged_island_does_not_touch_itself(tmp_path):
    source, notes = of_map(tmp_path, layer([[2, 2, 2, 2], [2, 0, 2, 2], [2, 2, 0, 2], [2, 2, 2, 2]]), merge=True)
    region, = source.drawings[0].regions
    assert notes == ["test.tmx: layer floor: touches itself in 1 points, first at (32, 32): cut back by 0.25 px"]
    points = [tuple(point) for ring in region.rings for point in ring]
    assert len(points) == len(set(points)) and len(region.holes) == 1 and polygon(region).area == 14 * 256 - 2 * 0.25**2 / 2


def test_merged_islands_are_in_reading_order(tmp_path):
    source, _ = of_map(tmp_path, layer([[0, 0, 0, 2], [2, 0, 2, 0]]), merge=True)
    assert [tuple(region.exterior.min(axis=0)) for region in source.drawings[0].regions] == [(48, 0), (0, 16), (32, 16)]


# ---- Bad input

OBJECT = '<object id="17" name="door" x="10" y="20"{}>{}</object>'


@pytest.mark.parametrize(("content", "message"), [
    ('<polygon points="0,0 10,10 10,0 0,10"/>', "object 17 (door): crosses or touches itself at (15, 25)"),
    ('<polygon points="0,0 10,0 5,0"/>', "object 17 (door): has no area: its points lie on one line"),
    ('<polygon points="0,0 10,0 10,0"/>', "object 17 (door): has fewer than three different points"),
    ('<polygon points="0,0 10,0 nan,5"/>', "object 17 (door): a coordinate is not a finite number"),
    ('<polygon points="0,0 10,0 5"/>', "is not as Tiled writes it: list index out of range"),
    ('<polyline points="0,0 10,0 10,10"/>', "object 17 (door): is an open polyline: make it a polygon, or end it where it begins"),
    ("<capsule/>", "line 1: a capsule is not read: draw a polygon or an ellipse"),
])
def test_a_bad_outline_is_named(tmp_path, content, message):
    assert fault(of_objects, tmp_path, OBJECT.format("", content)) == message


def test_a_crossing_is_told_where_the_turned_polygon_has_it(tmp_path):
    body = OBJECT.format(' rotation="90"', '<polygon points="0,0 10,10 10,0 0,10"/>')
    assert fault(of_objects, tmp_path, body) == "object 17 (door): crosses or touches itself at (5, 25)"


@pytest.mark.parametrize(("attributes", "message"), [
    (' gid="99"', "object 17 (door): tile number 99 is in no tile set"),
    (' rotation="inf" width="3" height="4"', "object 17 (door): a coordinate is not a finite number"),
    (' width="3" height="tall"', "line 1: 'height' is not a number: 'tall'"),
    (' template="door.tx"', "line 1: is made from a template: detach it in Tiled"),
])
def test_a_bad_object_is_named(tmp_path, attributes, message):
    assert fault(of_objects, tmp_path, OBJECT.format(attributes, "")) == message


def test_a_bad_shape_of_a_tile_is_named(tmp_path):
    path = maps.write_map(tmp_path)
    bad = maps.TILESET.replace("0,0 16,0 16,-12", "0,0 16,0 0,-12 16,-12")
    (tmp_path / "ground.tsx").write_text(bad)
    assert fault(read, path) == "tile 2 of ground, object 1: crosses or touches itself at (8, 10)"
    assert fault(read, tmp_path / "ground.tsx") == "tile 2, object 1: crosses or touches itself at (8, 10)"


def encoded(attributes, data):
    return f'<layer id="1" name="f" width="1" height="1"><data{attributes}>{data}</data></layer>'


@pytest.mark.parametrize(("body", "message"), [
    (layer([[2, 99]]), "layer floor, tile (1, 0): tile number 99 is in no tile set"),
    (layer([[2, 2]]).replace("2,2", "2,2,2"), "layer floor: does not hold 2 x 1 tiles"),
    (encoded("", '<tile gid="2"/>'),
     "line 1: tile data as XML is not read: choose CSV or Base64 as the Tile Layer Format in the map's properties"),
    (encoded(' encoding="base64" compression="zlib"', "AAAA"), "is not as Tiled writes it: Error -3"),
    ('<tileset firstgid="9" source="lost.tsx"/>', "tile set lost.tsx: cannot be read: No such file or directory"),
    ('<tileset firstgid="9" source="ground.png"/>', "tile set ground.png: is neither XML nor JSON"),
    ('<tileset firstgid="9" source="level.tmx"/>', "tile set level.tmx: is not a tile set"),
    (layer([[1]]), "has no collision shapes"),
    ("", "has no collision shapes"),
    (layer([[2]], offsetx="nan", offsety="0"), "layer floor: a coordinate is not a finite number"),
])
def test_a_bad_map_is_refused(tmp_path, body, message):
    assert fault(of_map, tmp_path, body).startswith(message)


@pytest.mark.parametrize(("old", "new", "message"), [
    ('version="1.10" t', 'version="2.0" t', "has the format version 2.0; versions 1.x are read"),
    ("orthogonal", "isometric", "is isometric; only orthogonal maps are read"),
    ("orthogonal", "hexagonal", "is hexagonal; only orthogonal maps are read"),
    (' renderorder="right-down"', "", "is not as Tiled writes it: 'renderorder' is missing"),
    ("</map>", "", "is not XML: "),
    ("<map", "<world", "is not XML: mismatched tag, line 1, column "),
])
def test_a_bad_head_is_refused(tmp_path, old, new, message):
    text = f"{HEAD}{SET}{layer([[2]])}</map>".replace(old, new, 1)
    assert fault(read, written(tmp_path, text)).startswith(message)


@pytest.mark.parametrize(("text", "message"), [
    ("", "is neither XML nor JSON: "),
    ("not a map", "is neither XML nor JSON: "),
    ('{"layers": [', "is neither XML nor JSON: "),
    ("[1, 2]", "is JSON, but no Tiled map or tile set"),
    ("{}", "is 'unknown'; Tiled maps and tile sets are read"),
    ('{"type": "world"}', "is 'world'; Tiled maps and tile sets are read"),
    ('{"type": "map"}', "is not as Tiled writes it: 'tilesets' is missing"),
    ('{"type": "map", "width": "wide"}', "'width' is not a number: 'wide'"),
    ('{"type": "map", "layers": [{"objects": [{"id": 3, "template": "a.tj"}]}]}', "id 3: is made from a template: detach it in Tiled"),
    ("[" * 100000, "is neither XML nor JSON: "),
    ("<template/>", "is 'template'; Tiled maps and tile sets are read"),
    ('<!DOCTYPE map [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]><map>&b;</map>', "line 1: defines the entity 'a'; entities are not read"),
])
def test_other_files_are_refused(tmp_path, text, message):
    assert fault(read, written(tmp_path, text, "test.json")).startswith(message)


def test_a_json_object_is_checked_as_one_of_xml(tmp_path):
    path = maps.write_json(maps.write_map(tmp_path))
    content = json.loads(path.read_text())
    content["layers"][1]["objects"][0]["polygon"][1:3] = [{"x": 10, "y": 40}, {"x": -10, "y": 10}]
    path.write_text(json.dumps(content))
    assert fault(read, path).startswith("object 1 (arch): crosses or touches itself at (")


def test_a_missing_file_is_told(tmp_path):
    assert fault(read, tmp_path / "lost.tmx") == "cannot be read: No such file or directory"


def test_zstandard_needs_its_package(tmp_path, monkeypatch):
    monkeypatch.setattr(tiled.importlib.util, "find_spec", lambda name: None)
    body = encoded(' encoding="base64" compression="zstd"', "AAAA")
    assert fault(of_map, tmp_path, body).startswith("line 1: Zstandard data needs the Python package zstd")


def test_tiles_scaled_to_the_grid_are_refused(tmp_path):
    head = HEAD.replace('tilewidth="16"', 'tilewidth="32"')
    path = written(tmp_path, f"{head}{SET}{layer([[2]])}</map>")
    (tmp_path / "ground.tsx").write_text(maps.TILESET.replace('name="ground"', 'name="ground" tilerendersize="grid"'))
    assert fault(read, path).startswith("tile set ground: scales its tiles to the map's grid")
