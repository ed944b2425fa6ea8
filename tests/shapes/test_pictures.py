# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Pictures as files: every way of being transparent, sheets and animations, and what is refused.
import io
import struct
import time
import zlib
from types import SimpleNamespace

import numpy as np
import pytest
import shapely
from outlines import repeatable, seeds
from PIL import Image
from tuff_shapes import pictures
from tuff_shapes.faults import Journal, ShapeFault

SOLID, EMPTY = (90, 80, 70, 255), (0, 0, 0, 0)
GRAY, RGB, PALETTE, GRAY_ALPHA, RGBA = 0, 2, 3, 4, 6    # PNG's color types
SAMPLES = {GRAY: 1, RGB: 3, PALETTE: 1, GRAY_ALPHA: 2, RGBA: 4}


def read(path, **options):
    """The source and the notes."""
    journal = Journal(path.name, io.StringIO())
    settings = {"alpha": 128, "key": None, "grid": None, "frame": None, "specks": 1, **options}
    return pictures.read(path, SimpleNamespace(**settings), journal), journal.notes


def picture(*rows, solid=SOLID, empty=EMPTY):
    image = Image.new("RGBA", (len(rows[0]), len(rows)))
    image.putdata([empty if pixel == "." else solid for row in rows for pixel in row])
    return image


def saved(folder, image, name="rock.png", **how):
    path = folder / name
    image.save(path, **how)
    return path


def areas(drawing):
    """Pixels of each region."""
    return [shapely.Polygon(region.exterior, region.holes).area for region in drawing.regions]


def fault(path, **options):
    with pytest.raises(ShapeFault) as caught:
        read(path, **options)
    return str(caught.value)


# ---- PNG byte by byte: depths that Pillow does not write

def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def packed(samples, depth):
    """A row of a PNG: its filter, 0, and its bits."""
    bits = "".join(f"{sample:0{depth}b}" for sample in samples)
    bits += "0" * (-len(bits) % 8)
    return zlib.compress(bytes([0, *(int(bits[i:i + 8], 2) for i in range(0, len(bits), 8))]))


def png(folder, depth, color, samples, transparent=b"", palette=b""):
    """One row of pixels from its samples."""
    return put_together(folder, depth, color, len(samples), [(b"PLTE", palette), (b"tRNS", transparent), (b"IDAT", packed(samples, depth))])


def put_together(folder, depth, color, samples, chunks):
    head = struct.pack(">IIBBBBB", samples // SAMPLES[color], 1, depth, color, 0, 0, 0)
    path = folder / "row.png"
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + b"".join(chunk(*one) for one in chunks if one[1]) + chunk(b"IEND", b""))
    return path


def solid_columns(path, **options):
    """Of a picture one pixel high."""
    source, _ = read(path, **options)
    columns = []
    for region in source.drawings[0].regions:
        columns += range(int(region.exterior[:, 0].min()), int(region.exterior[:, 0].max()))
    return columns


def test_alpha_of_16_bits_is_scaled(tmp_path):
    alphas = [0, 0x7fff, 0x8000, 0, 0xffff, 0x00ff]
    assert solid_columns(png(tmp_path, 16, RGBA, [v for a in alphas for v in (1000, 2000, 3000, a)])) == [2, 4]
    assert solid_columns(png(tmp_path, 16, GRAY_ALPHA, [v for a in alphas for v in (1000, a)])) == [2, 4]


def test_the_alpha_threshold_is_the_least_solid_alpha(tmp_path):
    path = png(tmp_path, 8, GRAY_ALPHA, [9, 0, 9, 1, 9, 199, 9, 200])
    assert solid_columns(path, alpha=1) == [1, 2, 3]
    assert solid_columns(path, alpha=200) == [3]


def test_palette_with_alpha_for_each_color(tmp_path):
    colors = bytes(range(12))
    assert solid_columns(png(tmp_path, 8, PALETTE, [0, 1, 2, 3], bytes([0, 127, 128]), colors)) == [2, 3]
    assert solid_columns(png(tmp_path, 2, PALETTE, [3, 0, 1, 2], bytes([0, 255, 11]), colors)) == [0, 2]
    assert solid_columns(png(tmp_path, 1, PALETTE, [1, 0, 1], bytes([0]), colors[:6])) == [0, 2]


@pytest.mark.parametrize("depth", [1, 2, 4, 8, 16])
def test_transparent_gray_of_any_depth(tmp_path, depth):
    most = 2 ** depth - 1
    for transparent in {0, 1, most // 2, most - 1, most}:
        values = [transparent, most - transparent, transparent, most, 0]
        wanted = [i for i, value in enumerate(values) if value != transparent]
        assert solid_columns(png(tmp_path, depth, GRAY, values, struct.pack(">H", transparent))) == wanted, transparent


def test_transparent_color_of_8_and_16_bits(tmp_path):
    for depth, clear, other in ((8, (1, 2, 3), (1, 2, 4)), (16, (0x0100, 0x8000, 0xffff), (0x0200, 0x8000, 0xffff)),
                                (16, (255, 255, 255), (65535, 65535, 65535))):
        path = png(tmp_path, depth, RGB, [*clear, *other, *clear, *other], struct.pack(">3H", *clear))
        assert solid_columns(path) == [1, 3], clear


def test_transparent_black_of_a_bilevel_picture(tmp_path):
    assert solid_columns(saved(tmp_path, Image.frombytes("1", (8, 1), b"\xa5"), transparency=0)) == [0, 2, 5, 7]


# ---- Color keys

def test_pixels_of_the_key_color_are_empty(tmp_path):
    image = picture("###.", "#.##", solid=(9, 9, 9, 255), empty=(255, 0, 255, 255)).convert("RGB")
    source, _ = read(saved(tmp_path, image), key=(255, 0, 255))
    assert areas(source.drawings[0]) == [6]
    assert source.drawings[0].image.getpixel((3, 0)) == (255, 0, 255, 0)


def test_colors_beside_the_key_are_solid(tmp_path):
    image = Image.new("RGB", (4, 1))
    image.putdata([(255, 0, 255), (255, 0, 254), (254, 0, 255), (255, 1, 255)])
    assert areas(read(saved(tmp_path, image), key=(255, 0, 255))[0].drawings[0]) == [3]


def test_key_and_alpha_together(tmp_path):
    image = Image.new("RGBA", (4, 1))
    image.putdata([(1, 2, 3, 255), (1, 2, 3, 0), (4, 5, 6, 0), (4, 5, 6, 255)])
    assert solid_columns(saved(tmp_path, image), key=(1, 2, 3)) == [3]


@pytest.mark.parametrize("mode", ["L", "P", "CMYK", "YCbCr", "I;16"])
def test_a_key_serves_pictures_of_any_mode(tmp_path, mode):
    image = Image.new("RGB", (6, 4), (255, 255, 255))
    image.paste((0, 0, 0), (1, 1, 4, 3))
    how = {"name": "rock.tiff"} if mode not in ("L", "P") else {}
    image = Image.fromarray(np.asarray(image.convert("L")).astype(np.uint16) * 256 + 3) if mode == "I;16" else image.convert(mode)
    assert areas(read(saved(tmp_path, image, **how), key=(255, 255, 255))[0].drawings[0]) == [6]


# ---- Single pictures

@pytest.mark.parametrize("name", ["rock.png", "rock.gif", "rock.webp", "rock.tga", "rock.tiff", "rock.qoi"])
def test_whatever_pillow_reads(tmp_path, name):
    how = {"lossless": True} if name.endswith("webp") else {}
    source, notes = read(saved(tmp_path, picture("......", ".####.", ".#..#.", ".####.", "......"), name, **how))
    (drawing,) = source.drawings
    assert (drawing.name, drawing.place, drawing.size, drawing.exact, source.placements) == ("", "", (6, 5), False, None)
    assert areas(drawing) == [10] and len(drawing.regions[0].holes) == 1 and notes == []
    assert drawing.image.mode == "RGBA" and drawing.image.size == (6, 5)


def test_4096_x_4096(tmp_path):
    along = np.arange(4096) - 2048
    alpha = np.where(along[:, None] ** 2 + along ** 2 < 1800 ** 2, 255, 0).astype(np.uint8)
    image = Image.new("RGBA", alpha.shape)
    image.putalpha(Image.fromarray(alpha))
    path = saved(tmp_path, image, compress_level=1)
    began = time.perf_counter()
    source, _ = read(path, specks=16)
    print(f"4096 x 4096: {time.perf_counter() - began:.2f} s")
    assert areas(source.drawings[0]) == [np.count_nonzero(alpha)]


def test_pages_of_a_tiff_are_not_frames(tmp_path):
    source, notes = read(saved(tmp_path, picture("#."), "rock.tiff", save_all=True, append_images=[picture(".#")]))
    assert [drawing.name for drawing in source.drawings] == [""]
    assert notes == ["rock.tiff: only the first of 2 pages or layers is read"]


# ---- Sheets and animations

SHEET = picture("##.....#",
                "##......",
                "....####",
                "....#...")


def test_a_sheet_by_grid_or_frame_size_is_read_row_by_row(tmp_path):
    path = saved(tmp_path, SHEET)
    for options in ({"grid": (4, 2)}, {"frame": (2, 2)}):
        source, notes = read(path, **options)
        assert [(drawing.name, drawing.place) for drawing in source.drawings] == [(n, f"frame {n}") for n in ("0", "3", "6", "7")]
        assert [areas(drawing) for drawing in source.drawings] == [[4], [1], [3], [2]]
        assert all(drawing.size == drawing.image.size == (2, 2) for drawing in source.drawings)
        assert notes == [f"rock.png: frame {n}: empty, skipped" for n in (1, 2, 4, 5)]


def test_regions_of_a_frame_are_in_its_own_pixels(tmp_path):
    source, _ = read(saved(tmp_path, SHEET), grid=(4, 2))
    assert sorted(map(tuple, source.drawings[1].regions[0].exterior)) == [(1, 0), (1, 1), (2, 0), (2, 1)]


def test_a_frame_of_specks_is_skipped_with_a_note(tmp_path):
    source, notes = read(saved(tmp_path, SHEET), grid=(4, 2), specks=2)
    assert [drawing.name for drawing in source.drawings] == ["0", "6", "7"]
    assert any(note.startswith("rock.png: skipped: frame 3: nothing is left: the largest of 1 island has 1 px") for note in notes)


def test_one_frame_of_a_sheet_may_be_full(tmp_path):
    assert [areas(d) for d in read(saved(tmp_path, picture("##..", "##.#")), frame=(2, 2))[0].drawings] == [[4], [1]]


def test_cells_must_divide_the_picture(tmp_path):
    path = saved(tmp_path, SHEET)
    assert fault(path, grid=(3, 2)) == "8 x 4 pixels cannot be cut evenly into 3 columns and 2 rows"
    assert fault(path, frame=(2, 3)) == "8 x 4 pixels cannot be cut evenly into frames of 2 x 3"
    assert "frames of 16 x 4" in fault(path, frame=(16, 4))
    assert "9 columns" in fault(path, grid=(9, 1))
    assert "not both" in fault(path, grid=(2, 1), frame=(4, 4))


def test_a_sheet_with_nothing_in_it(tmp_path):
    assert fault(saved(tmp_path, picture("....", "....")), grid=(2, 1)) == "nothing is solid"
    assert fault(saved(tmp_path, picture("#..#", "....")), grid=(2, 1), specks=2) == "nothing is left in any of its 2 frames"


@pytest.mark.parametrize("name", ["rock.gif", "rock.webp", "rock.png"])
def test_frames_of_an_animation(tmp_path, name):
    frames = [picture("##..", "##.."), picture("....", "...#"), picture("....", "...."), picture("####", "....")]
    how = {"rock.gif": {"disposal": 2}, "rock.webp": {"lossless": True}, "rock.png": {"disposal": 0, "blend": 0}}[name]
    path = saved(tmp_path, frames[0], name, save_all=True, append_images=frames[1:], duration=100, **how)
    source, notes = read(path)
    assert [(drawing.name, drawing.place, areas(drawing)) for drawing in source.drawings] == [
        ("0", "frame 0", [4]), ("1", "frame 1", [1]), ("3", "frame 3", [4])]
    assert notes == [f"{name}: frame 2: empty, skipped"]
    assert "an animation of 4 frames cannot be a sheet too" in fault(path, grid=(2, 1))


def test_transparent_gray_of_an_animated_png(tmp_path):
    control = [struct.pack(">IIIIIHHBB", number, 4, 1, 0, 0, 1, 10, 0, 0) for number in range(2)]
    path = put_together(tmp_path, 2, GRAY, 4, [
        (b"tRNS", struct.pack(">H", 2)), (b"acTL", struct.pack(">II", 2, 0)),
        (b"fcTL", control[0]), (b"IDAT", packed([2, 1, 2, 3], 2)),
        (b"fcTL", control[1]), (b"fdAT", struct.pack(">I", 2) + packed([1, 0, 3, 2], 2))])
    source, _ = read(path)
    assert [areas(drawing) for drawing in source.drawings] == [[1, 1], [3]]


def test_the_still_picture_of_an_animated_png_is_no_frame(tmp_path):
    path = saved(tmp_path, picture("##.."), save_all=True, default_image=True, append_images=[picture("#..."), picture("...#")], disposal=1)
    assert [drawing.regions[0].exterior[:, 0].max() for drawing in read(path)[0].drawings] == [1, 4]


# ---- What is refused

def test_no_picture(tmp_path):
    (tmp_path / "text.png").write_text("not a picture")
    (tmp_path / "empty.png").write_bytes(b"")
    assert fault(tmp_path / "text.png") == "not a picture that Pillow can read"
    assert fault(tmp_path / "empty.png") == "an empty file"
    assert fault(tmp_path / "missing.png") == "no such file"
    assert fault(tmp_path) == "not a file"


@pytest.mark.parametrize("name", ["rock.png", "rock.gif", "rock.webp", "rock.tga", "rock.tiff"])
def test_a_truncated_picture(tmp_path, name):
    noise = np.random.default_rng(1).integers(0, 256, (40, 40, 4), dtype=np.uint8)
    path = saved(tmp_path, Image.fromarray(noise), name)
    whole = path.read_bytes()
    for length in (len(whole) // 2, len(whole) - 200, 20):
        path.write_bytes(whole[:length])
        assert fault(path).startswith(("cannot be read: ", "not a picture")), length


@pytest.mark.parametrize("seed", seeds(100))
def test_random_damage_is_a_fault_or_a_picture(tmp_path, seed):
    random = np.random.default_rng(seed)
    path = saved(tmp_path, picture(*["#." * 20] * 40))
    data = bytearray(path.read_bytes())
    data[random.integers(8, len(data))] ^= int(random.integers(1, 256))
    path.write_bytes(data)
    with repeatable("tests/shapes/test_pictures.py -k damage", seed):
        try:
            assert read(path)[0].drawings
        except ShapeFault as refused:
            assert str(refused)


@pytest.mark.parametrize("name", ["rock.png", "rock.tga"])
@pytest.mark.parametrize("most", [40, 20])
def test_a_picture_that_unpacks_to_too_many_pixels(tmp_path, monkeypatch, name, most):
    """Of 60 pixels: Pillow warns above the limit, refuses above twice the limit."""
    path = saved(tmp_path, picture(*["#."] * 30), name)
    monkeypatch.setattr(Image, "MAX_IMAGE_PIXELS", most)
    assert fault(path) == f"too large: more than {most} pixels, all frames together"


def test_an_animation_of_too_many_pixels(tmp_path, monkeypatch):
    others = [picture(".#"), picture("#."), picture(".#")]
    path = saved(tmp_path, picture("#."), "rock.gif", save_all=True, append_images=others, disposal=2)
    monkeypatch.setattr(Image, "MAX_IMAGE_PIXELS", 4)
    assert "too large" in fault(path)


def test_all_opaque(tmp_path):
    gray = Image.new("RGB", (3, 3), (16, 32, 48))
    hint = "; give --key with the background's color (the upper left pixel is 102030)"
    assert fault(saved(tmp_path, gray)) == "all opaque: no alpha is below 128" + hint
    assert fault(saved(tmp_path, gray.convert("RGBA")), alpha=5) == "all opaque: no alpha is below 5" + hint
    assert fault(saved(tmp_path, gray), key=(1, 2, 255)) == "all opaque: no pixel has the color of --key, 0102ff"
    assert fault(saved(tmp_path, gray), grid=(3, 1)).startswith("all opaque")


def test_nothing_solid(tmp_path):
    assert fault(saved(tmp_path, picture("..", ".."))) == "nothing is solid"
    assert fault(saved(tmp_path, Image.new("RGB", (3, 3), (9, 8, 7))), key=(9, 8, 7)) == "nothing is solid"


def test_one_pixel_is_a_speck_unless_specks_are_wanted(tmp_path):
    path = saved(tmp_path, picture("...", ".#.", "..."))
    assert fault(path, specks=16).startswith("nothing is left: the largest of 1 island has 1 px")
    assert areas(read(path, specks=1)[0].drawings[0]) == [1]
