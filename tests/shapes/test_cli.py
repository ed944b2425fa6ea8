# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The command: bad input gives a message with file and place, status 2 and no file; good input whole files and a summary.
import struct
import time
import zlib

import builds
import drawings
import maps
import numpy as np
import pytest
from PIL import Image
from tuff_shapes import cli

OLD = "what was there before\n"


def picture(path, mask):
    """White where the mask is solid, clear elsewhere."""
    Image.fromarray(np.asarray(mask, dtype=np.uint8)[..., None] * np.uint8([255, 255, 255, 255]), "RGBA").save(path)


def block(size=64, margin=8):
    mask = np.zeros((size, size), dtype=bool)
    mask[margin:-margin, margin:-margin] = True
    return mask


def png(path, width, height, depth, color, rows, palette=b"", alphas=b""):
    """A PNG of any depth, as Pillow does not write them."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    data = b"".join(b"\0" + row for row in rows)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, depth, color, 0, 0, 0))
                     + (chunk(b"PLTE", palette) if palette else b"") + (chunk(b"tRNS", alphas) if alphas else b"")
                     + chunk(b"IDAT", zlib.compress(data)) + chunk(b"IEND", b""))


def run(folder, *arguments):
    """The command in this process, in that folder; its status."""
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        return cli.main([str(argument) for argument in arguments])


# ---- Bad input: how it is made, and what the message must say

def write(text):
    return lambda path: path.write_text(text)


def square(path):
    picture(path, block())


def single_pixel(path):
    picture(path, np.pad([[True]], 7))


def line(path):
    mask = np.zeros((64, 64), dtype=bool)
    mask[30, 10:22] = True
    picture(path, mask)


def disc(size):
    across = np.arange(size) - size / 2 + 0.5
    return np.hypot(*np.meshgrid(across, across)) < size * 0.45


def round_rock(path):
    picture(path, disc(512))


def wide(path):
    mask = np.zeros((4096, 4096), dtype=bool)
    mask[100:-100, 100:-100] = True
    picture(path, mask)


def polygon_map(points, kind="polygon"):
    text = f"""<?xml version="1.0" encoding="UTF-8"?>
<map version="1.10" tiledversion="1.10.2" orientation="orthogonal" renderorder="right-down" width="4" height="4" tilewidth="16"
 tileheight="16" infinite="0" nextlayerid="2" nextobjectid="9"><objectgroup id="1" name="ground"><object id="8" name="door" x="10" y="10">
 <{kind} points="{points}"/></object></objectgroup></map>"""
    return lambda path: path.write_text(text)


BAD = {
    "no file": ("none.png", None, [], "none.png: "),
    "no picture": ("text.png", write("not a picture"), [], "text.png: "),
    "an empty file": ("empty.png", write(""), [], "empty.png: "),
    "a folder": ("folder.png", lambda path: path.mkdir(), [], "folder.png: "),
    "all opaque": ("full.png", lambda path: picture(path, np.ones((32, 32))), [], "--key"),
    "nothing solid": ("clear.png", lambda path: picture(path, np.zeros((32, 32))), [], "clear.png: "),
    "one pixel": ("pixel.png", single_pixel, [], "--specks"),
    "a line one pixel wide": ("line.png", line, [], "--specks"),
    "frames that do not divide": ("rock.png", square, ["--grid", "5x1"], "rock.png: "),
    "too wide": ("wide.png", wide, [], "wide.png: the shape is 3896.0 units across, more than 2048: --scale 0.52 fits"),
    "far from its pivot": ("rock.png", square, ["--origin=-2000,0"], "2056.0 units from the position"),
    "a polygon that crosses itself": ("cross.tmx", polygon_map("0,0 20,20 20,0 0,20"), [], "door"),
    "an open polygon": ("open.tmx", polygon_map("0,0 20,20 20,0", "polyline"), [], "door"),
    "no map": ("map.tmx", write("<xml"), [], "map.tmx: "),
    "no JSON": ("map.json", write("{"), [], "map.json: "),
    "no SVG": ("logo.svg", write("nothing"), [], "logo.svg: "),
    "no such preview": ("rock.png", square, ["--preview", "out.gif"], "out.gif: a preview is a .png or an .svg file"),
    "over itself": ("rock.png", square, ["-o", "rock.png"], "would be overwritten"),
    "a name without letters": ("rock.png", square, ["--name", "\u5ca9"], "--name"),
    "no such folder": ("rock.png", square, ["-o", "none/rock.h"], "there is no such folder"),
    "a hull of many corners": ("disc.png", round_rock, ["--model", "hull", "--tolerance", "0.2"], "more than 32"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_input_is_named_and_nothing_is_written(case, tmp_path, capsys):
    name, make, options, message = BAD[case]
    if make:
        make(tmp_path / name)
    (tmp_path / "out.h").write_text(OLD)
    (tmp_path / "out.svg").write_text(OLD)
    before = sorted(tmp_path.iterdir())
    status = run(tmp_path, name, "-o", "out.h", "--preview", "out.svg", *options)
    error = capsys.readouterr().err
    assert status == 2 and error.splitlines()[-1].startswith(f"{name}: ") and message in error
    assert (tmp_path / "out.h").read_text() == OLD and (tmp_path / "out.svg").read_text() == OLD
    assert sorted(tmp_path.iterdir()) == before


@pytest.mark.parametrize("options", [
    ["--alpha", "0"], ["--alpha", "256"], ["--alpha", "x"], ["--key", "nocolor"], ["--specks", "-1"], ["--grid", "4"], ["--grid", "0x2"],
    ["--grid", "2x2", "--strip", "4"], ["--tolerance", "-1"], ["--tolerance", "nan"], ["--vertices", "2"],
    ["--tolerance", "1", "--vertices", "9"],
    ["--scale", "0"], ["--scale", "inf"], ["--per-unit", "48"], ["--per-unit", "16384"], ["--origin", "left"],
    ["--origin", "1,2,3"], ["--model", "box"], ["--include", "a\nb"], ["--include", "\u5ca9.h"], ["--bogus"]])
def test_a_value_that_makes_no_sense_is_refused(options, tmp_path, capsys):
    square(tmp_path / "rock.png")
    with pytest.raises(SystemExit) as exit_status:
        run(tmp_path, "rock.png", "-o", "out.h", *options)
    assert exit_status.value.code == 2 and options[0] in capsys.readouterr().err and not (tmp_path / "out.h").exists()


def test_a_fault_that_comes_late_leaves_no_file(tmp_path, monkeypatch, capsys):
    square(tmp_path / "rock.png")
    (tmp_path / "out.h").write_text(OLD)

    def full(*_):
        raise OSError(28, "No space left on device")
    monkeypatch.setattr("tuff_shapes.preview.draw_all", full)
    assert run(tmp_path, "rock.png", "-o", "out.h", "--preview", "out.png") == 2
    assert capsys.readouterr().err == "rock.png: [Errno 28] No space left on device\n"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out.h", "rock.png"] and (tmp_path / "out.h").read_text() == OLD


# ---- Good input, of the difficult kinds

def header_of(folder, name, *options):
    assert run(folder, name, "-o", "out.h", "--quiet", *options) == 0
    return (folder / "out.h").read_text()


def test_islands_inside_holes_are_pieces(tmp_path):
    mask = block(96)
    mask[20:76, 20:76] = False
    mask[32:64, 32:64] = True
    picture(tmp_path / "rock.png", mask)
    assert "#define ROCK_COUNT 2\n" in header_of(tmp_path, "rock.png")


def test_corners_that_touch_are_apart_and_noted(tmp_path, capsys):
    mask = np.zeros((64, 64), dtype=bool)
    mask[8:32, 8:32] = mask[32:56, 32:56] = True
    picture(tmp_path / "rock.png", mask)
    assert run(tmp_path, "rock.png", "-o", "out.h") == 0
    assert "#define ROCK_COUNT 2\n" in (tmp_path / "out.h").read_text() and "rock.png: " in capsys.readouterr().err


def test_a_picture_of_4096_pixels_works(tmp_path):
    picture(tmp_path / "disc.png", disc(4096))
    assert "DISC_BOUNDING_RADIUS" in header_of(tmp_path, "disc.png", "--scale", "0.25", "--tolerance", "4")


def test_16_bits_a_palette_and_a_color_key_say_the_same_as_alpha(tmp_path):
    mask = block(32, 6)
    picture(tmp_path / "rock.png", mask)
    expected = header_of(tmp_path, "rock.png")
    wide_rows = [b"".join(struct.pack(">4H", 65535, 0, 0, 65535 if solid else 300) for solid in row) for row in mask]
    png(tmp_path / "rock.png", 32, 32, 16, 6, wide_rows)
    assert header_of(tmp_path, "rock.png") == expected
    palette_rows = [bytes(2 if solid else 1 for solid in row) for row in mask]
    png(tmp_path / "rock.png", 32, 32, 8, 3, palette_rows, bytes(range(9)), b"\xff\x00\xff")
    assert header_of(tmp_path, "rock.png") == expected
    Image.fromarray(np.where(mask[..., None], np.uint8([9, 9, 9]), np.uint8([255, 0, 255]))).save(tmp_path / "rock.png")
    keyed = header_of(tmp_path, "rock.png", "--key", "ff00ff")
    assert keyed.split("#ifndef")[1] == expected.split("#ifndef")[1]


def test_specks_are_dropped_and_noted(tmp_path, capsys):
    mask = block()
    mask[2, 2] = True
    picture(tmp_path / "rock.png", mask)
    assert run(tmp_path, "rock.png", "-o", "out.h", "--no-table") == 0
    assert "ROCK_COUNT" not in (tmp_path / "out.h").read_text() and "note: rock.png: " in capsys.readouterr().err


# ---- What is shown, what is written

def test_the_summary_says_what_it_costs_and_how_wrong_it_is(tmp_path, capsys):
    drawings.crescent().save(tmp_path / "moon.png")
    assert run(tmp_path, "moon.png", "-o", "moon.h") == 0
    shown = capsys.readouterr().out
    assert shown.startswith("moon: ") and all(word in shown for word in ("parts", "vertices", "bytes", "largest error", "mean", "radius"))
    assert "circle" in shown and "hull" in shown


def test_without_an_output_the_header_goes_to_standard_output(tmp_path, capsys):
    square(tmp_path / "rock.png")
    assert run(tmp_path, "rock.png") == 0
    captured = capsys.readouterr()
    assert captured.out.startswith("/* Made by tuff_shapes") and captured.out.endswith("#endif\n") and captured.err.startswith("rock: ")


def test_quiet_says_nothing(tmp_path, capsys):
    square(tmp_path / "rock.png")
    assert run(tmp_path, "rock.png", "-o", "out.h", "--quiet") == 0
    assert capsys.readouterr() == ("", "")


def test_the_header_is_the_same_each_time_and_names_no_folder_of_this_machine(tmp_path):
    square(tmp_path / "rock.png")
    first = header_of(tmp_path, tmp_path / "rock.png", f"--preview={tmp_path / 'out.png'}")
    assert header_of(tmp_path, tmp_path / "rock.png", f"--preview={tmp_path / 'out.png'}") == first
    assert str(tmp_path) not in first and "python -m tuff_shapes rock.png -o out.h --quiet --preview=out.png\n" in first


def test_a_header_may_be_read_by_others(tmp_path):
    square(tmp_path / "rock.png")
    header_of(tmp_path, "rock.png")
    (tmp_path / "plain").write_text("")
    assert (tmp_path / "out.h").stat().st_mode == (tmp_path / "plain").stat().st_mode
    (tmp_path / "out.h").chmod(0o640)
    header_of(tmp_path, "rock.png")
    assert (tmp_path / "out.h").stat().st_mode & 0o777 == 0o640


@pytest.mark.parametrize("suffix, start", [(".png", b"\x89PNG"), (".svg", b"<?xml")])
def test_a_preview_is_drawn(suffix, start, tmp_path):
    drawings.star().save(tmp_path / "rock.png")
    header_of(tmp_path, "rock.png", "--preview", f"look{suffix}")
    assert (tmp_path / f"look{suffix}").read_bytes().startswith(start)


def test_options_change_what_they_say(tmp_path):
    square(tmp_path / "rock.png")
    text = header_of(tmp_path, "rock.png", "--name", "Crate", "--include", "tuff.h", "--per-unit", "8", "--scale", "2", "--origin", "0,0",
                     "--y-up")
    assert '#include "tuff.h"\n' in text and "static const tuff_terrain crate = CRATE_AT(" in text and "y up." in text
    assert "#define CRATE_ORIGIN_X TUFF_RATIO(0, 8)\n" in text and "{ TUFF_RATIO(896, 8), TUFF_RATIO(-896, 8) }" in text


def test_a_budget_is_kept(tmp_path):
    drawings.convex().save(tmp_path / "rock.png")
    assert "#define ROCK_VERTEX_COUNT 5\n" in header_of(tmp_path, "rock.png", "--model", "hull", "--vertices", "5")


def test_sheets_and_maps_show_a_progress_bar(tmp_path, capsys):
    drawings.sheet().save(tmp_path / "sheet.png")
    assert run(tmp_path, "sheet.png", "--strip", "8", "-o", "out.h", "--progress", "--no-table") == 0
    assert "8/8" in capsys.readouterr().err
    assert run(maps.write_map(tmp_path).parent, "level.tmx", "-o", "out.h", "--progress", "--no-table") == 0
    assert "level.tmx: 100%" in capsys.readouterr().err


def test_no_bar_where_nobody_looks(tmp_path, capsys):
    drawings.sheet().save(tmp_path / "sheet.png")
    assert run(tmp_path, "sheet.png", "--strip", "8", "-o", "out.h", "--no-table") == 0
    assert capsys.readouterr().err == ""


def test_the_time_of_a_sprite(tmp_path, figures):
    drawings.crescent().resize((256, 256)).save(tmp_path / "sprite.png")
    begin = time.perf_counter()
    done = builds.shapes("sprite.png", "-o", "sprite.h", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    figures(f"a sprite of 256 x 256 pixels with its table: {time.perf_counter() - begin:.1f} s")
