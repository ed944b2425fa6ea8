# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The preview's files, and that what it shows is what the pieces are.
import subprocess
import sys
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image
from tuff_shapes import pipeline, preview
from tuff_shapes.model import Drawing, Region

ELL = np.array([(2, 2), (8, 2), (8, 10), (14, 10), (14, 14), (2, 14)], dtype=float)
HOLE = np.array([(4, 4), (4, 6), (6, 6), (6, 4)], dtype=float)


def options(**changed):
    chosen = {"model": "parts", "tolerance": 0.25, "vertices": None, "scale": 1.0, "per_unit": 64, "origin": "area", "name": "rock"}
    return SimpleNamespace(**{**chosen, **changed})


def drawing(name="", place="", holes=(), image=True):
    return Drawing(name, place, [Region(ELL, list(holes))], (16.0, 16.0), picture() if image else None)


def picture():
    image = Image.new("RGBA", (16, 16))
    image.paste((200, 40, 40, 255), (2, 2, 8, 14))
    image.paste((40, 40, 200, 255), (2, 10, 14, 14))
    return image


def panel(shape=None, **changed):
    shape = shape or drawing()
    return shape, pipeline.bake(shape, options(**changed), None)


def view(shape=None, **changed):
    return preview.View(*panel(shape, **changed), options(**changed))


def figure(panels, **changed):
    return preview.figure_of(panels, options(**changed))


def texts(figure):
    return [text.get_text() for text in figure.texts] + [text.get_text() for axes in figure.axes for text in axes.texts]


def legend(figure):
    return [text.get_text() for text in figure.legends[0].get_texts()]


def sides(edges):
    return {frozenset((tuple(map(float, start)), tuple(map(float, end)))) for start, end in edges}


def test_outline_edges_are_those_of_the_border_and_no_cut():
    expected = zip(ELL, np.roll(ELL, -1, axis=0))
    outer = np.array(view().edges(internal=False))
    assert sum(np.hypot(*(end - start)) for start, end in outer) == pytest.approx(sum(np.hypot(*(b - a)) for a, b in expected))


def test_a_cut_is_given_once_though_two_parts_have_it():
    found = view()
    given = sum(bin(bits).count("1") for _, bits in found.parts)
    assert given > 0 and len(found.edges(internal=True)) * 2 == given


def test_arrows_point_outward():
    from matplotlib.figure import Figure
    from shapely import Point, Polygon
    for holes in ([], [HOLE]):
        shape = drawing(holes=holes)
        axes = Figure().add_axes((0, 0, 1, 1))
        preview.draw_normals(axes, view(shape), 1.0)
        arrows = axes.collections[0]
        solid = Polygon(ELL, holes)
        for (x, y), u, v in zip(arrows.get_offsets(), arrows.U, arrows.V):
            length = np.hypot(u, v)
            assert not solid.contains(Point(x + 0.1 * u / length, y + 0.1 * v / length))
            assert solid.contains(Point(x - 0.1 * u / length, y - 0.1 * v / length))


def test_lengths_are_pixels_whatever_the_scale():
    one, two = view(), view(scale=2.0)
    assert np.allclose(one.outlines[0], two.outlines[0])
    assert np.allclose(one.origins[0], two.origins[0], atol=1 / 64)
    assert two.pixels(two.pieces[0].radius_raw) == pytest.approx(one.pixels(one.pieces[0].radius_raw), rel=1e-3)


def test_everything_is_within_the_panel():
    found = view()
    reach = found.pixels(found.pieces[0].bounding_raw)
    assert np.all(found.low < found.origins[0] - reach) and np.all(found.high > found.origins[0] + reach)
    assert np.all(found.low < 0) and np.all(found.high > 16)


def test_the_title_and_the_legend_hold_the_figures():
    shape, pieces = panel(drawing(place="frame 3"))
    drawn = figure([(shape, pieces)])
    vertices = sum(len(part.vertices) for part in pieces[0].parts)
    title = next(text for text in texts(drawn) if text.startswith("rock, frame 3:"))
    assert f"{len(pieces[0].parts)} parts, {vertices} vertices, {24 + 16 * (len(pieces[0].parts) + vertices)} bytes" in title
    assert f"radius {pieces[0].bounding_raw / 65536:.2f} units" in "\n".join(legend(drawn))
    assert {"internal edges", "outward normals", "largest error"} <= set(legend(drawn))


def test_the_worst_spot_is_labeled():
    shape, pieces = panel(tolerance=3.0)
    worst = pieces[0].deviation
    drawn = figure([(shape, pieces)], tolerance=3.0)
    label = next(text for text in drawn.axes[0].texts if text.get_text() == f"{worst.largest:.2f} px")
    assert worst.largest > 0 and tuple(label.xy) == pytest.approx(worst.spot)


def test_a_circle_has_no_parts_but_all_the_rest():
    drawn = figure([panel(model="circle")], model="circle")
    assert any("0 parts, 0 vertices, 24 bytes" in text for text in texts(drawn))


def test_a_sheet_has_a_panel_for_each_frame():
    drawn = figure([panel(drawing(str(number), f"frame {number}")) for number in range(7)])
    assert [axes.get_title().split(":")[0] for axes in drawn.axes] == list("0123456")
    assert any(text.startswith("rock:  7 pieces, ") for text in texts(drawn))


@pytest.mark.parametrize("ending", ["png", "svg"])
def test_the_same_pieces_give_the_same_bytes(ending, tmp_path):
    files = [tmp_path / f"{number}.{ending}" for number in range(2)]
    for file in files:
        preview.draw(file, *panel(), options())
    assert files[0].read_bytes() == files[1].read_bytes()


def test_an_svg_keeps_the_pixels_and_has_no_date(tmp_path):
    preview.draw(tmp_path / "rock.svg", *panel(), options())
    text = (tmp_path / "rock.svg").read_text()
    assert 'width="16"' in text and "data:image/png" in text
    assert "<dc:date>" not in text


def color_at(image, drawn, x, y):
    """Of the dot that shows a point of the first panel."""
    across, up = drawn.axes[0].transData.transform((x, y))
    return image.getpixel((round(across), image.height - 1 - round(up)))


def test_a_png_shows_pixels_outline_and_paper_where_they_are(tmp_path):
    shape, pieces = panel(drawing(holes=[HOLE]))
    preview.draw(tmp_path / "rock.png", shape, pieces, options())
    drawn = figure([(shape, pieces)])
    drawn.canvas.draw()
    with Image.open(tmp_path / "rock.png") as image:
        image = image.convert("RGB")
        assert image.size == tuple(round(100 * inches) for inches in drawn.get_size_inches())
        assert color_at(image, drawn, 15.5, 0.5) == (255, 255, 255)
        assert max(color_at(image, drawn, 2.0, 8.9)) < 40
        red, blue = color_at(image, drawn, 2.6, 7.6), color_at(image, drawn, 13.4, 13.4)
        assert red[0] > red[2] + 30 and blue[2] > blue[0] + 30


def test_without_pixels_the_shape_itself_is_shown(tmp_path):
    preview.draw(tmp_path / "rock.png", *panel(drawing(image=False)), options())
    assert (tmp_path / "rock.png").stat().st_size > 5000


def test_a_large_picture_is_shrunk(tmp_path):
    shape = drawing()
    shape.image = shape.image.resize((3000, 3000))
    preview.draw(tmp_path / "rock.svg", *panel(shape), options())
    assert 'width="1024"' in (tmp_path / "rock.svg").read_text()


def test_matplotlib_is_loaded_only_to_draw_and_pyplot_never():
    code = ("import sys, tuff_shapes.preview as preview; assert 'matplotlib' not in sys.modules;"
            "sys.path.insert(0, 'tests/shapes'); import test_preview as t; t.figure([t.panel()]); assert 'matplotlib' in sys.modules;"
            "assert 'matplotlib.pyplot' not in sys.modules")
    subprocess.run([sys.executable, "-c", code], check=True)
