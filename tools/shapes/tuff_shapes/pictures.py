# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Reads whatever Pillow opens, cuts sheets and animations into frames, and says which pixels are solid: those whose
# alpha reaches the threshold and whose color is not the key.
import os
import warnings

import numpy as np
from PIL import Image, UnidentifiedImageError

from . import trace
from .faults import ShapeFault
from .model import Drawing, Source

# Formats whose frames follow each other in time; the pages of a TIFF and the layers of a PSD do not.
ANIMATED = {"AVIF", "GIF", "PNG", "WEBP"}

# How the values of these PNGs become 8 bits when Pillow reads them. Pillow 13 leaves the transparent color (tRNS) as it is, which
# then matches nothing or the wrong pixels. Colors of 16 bits a channel that differ only in their lower bytes become one.
PNG_TO_8_BITS = {"L;2": lambda value: value * 85, "L;4": lambda value: value * 17, "RGB;16B": lambda value: value >> 8}


def read(path, options, journal):
    """A Source with one Drawing per picture or frame; frames in which nothing is solid are skipped with a note."""
    frames, is_sheet = _cells(_opened(path, options, journal), options)
    masks = [_solid(frame, options) for frame in frames]
    _refuse_blank(frames, masks, options)
    if not is_sheet:
        return Source([_drawing("", "", frames[0], masks[0], options, journal)])
    found = [_frame(number, frame, mask, options, journal) for number, (frame, mask) in enumerate(zip(frames, masks))]
    drawings = [drawing for drawing in found if drawing]
    if not drawings:
        raise ShapeFault(f"nothing is left in any of its {len(frames)} frames")
    return Source(drawings)


def _drawing(name, place, frame, mask, options, journal):
    return Drawing(name, place, trace.regions(mask, options.specks, journal, place), frame.size, frame)


def _frame(number, frame, mask, options, journal):
    """None if there is nothing to trace."""
    place = f"frame {number}"
    if not mask.any():
        journal.note("empty, skipped", place)
        return None
    try:
        return _drawing(str(number), place, frame, mask, options, journal)
    except trace.NothingLeft as fault:
        journal.note(f"skipped: {fault}")
        return None


# ---- Files

def _opened(path, options, journal):
    """RGBA pictures: one, or an animation's frames. Decoders may raise anything when a file is damaged; what they warn of, besides
    sizes, is damage to what is not pixels: tags, comments."""
    _refuse_no_file(path)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            warnings.simplefilter("error", Image.DecompressionBombWarning)
            with Image.open(path) as image:
                return [_rgba(image) for _ in _frames(image, journal)]
    except ShapeFault:
        raise
    except (Image.DecompressionBombWarning, Image.DecompressionBombError):
        raise ShapeFault(_too_large()) from None
    except UnidentifiedImageError:
        raise ShapeFault("not a picture that Pillow can read") from None
    except Exception as error:
        raise ShapeFault(f"cannot be read: {error}") from error


def _refuse_no_file(path):
    if not os.path.exists(path):
        raise ShapeFault("no such file")
    if not os.path.isfile(path):
        raise ShapeFault("not a file")
    if os.path.getsize(path) == 0:
        raise ShapeFault("an empty file")


def _too_large():
    return f"too large: more than {Image.MAX_IMAGE_PIXELS} pixels, all frames together"


def _frames(image, journal):
    """Moves the image to each of its frames in turn."""
    count = getattr(image, "n_frames", 1)
    if image.format not in ANIMATED:
        if count > 1:
            journal.note(f"only the first of {count} pages or layers is read")
        yield
        return
    if count * image.width * image.height > Image.MAX_IMAGE_PIXELS:
        raise ShapeFault(_too_large())
    for number in range(1 if getattr(image, "default_image", False) and count > 1 else 0, count):
        image.seek(number)
        yield


def _rgba(image):
    """A copy of the current frame."""
    stored = image.tile[0].args if image.format == "PNG" and image.tile else None
    image.load()
    transparent = image.info.get("transparency")
    if image.mode.startswith("I;16"):
        return _gray_16(np.asarray(image), transparent)
    if transparent is not None and stored in PNG_TO_8_BITS:
        to_8_bits = PNG_TO_8_BITS[stored]
        image = image.copy()
        image.info["transparency"] = tuple(map(to_8_bits, transparent)) if image.mode == "RGB" else to_8_bits(transparent)
    return image.convert("RGBA")


def _gray_16(values, transparent):
    """Pillow 13 clamps these to 255 before it compares them to the transparent one."""
    gray = (values >> 8).astype(np.uint8)
    alpha = np.where(values == transparent, 0, 255).astype(np.uint8) if transparent is not None else np.full_like(gray, 255)
    return Image.merge("RGBA", [*[Image.fromarray(gray)] * 3, Image.fromarray(alpha)])


# ---- Sheets

def _cells(frames, options):
    """The frames to trace, and whether they are numbered."""
    if not (options.grid or options.frame):
        return frames, len(frames) > 1
    if options.grid and options.frame:
        raise ShapeFault("give --grid or --frame, not both")
    if len(frames) > 1:
        raise ShapeFault(f"an animation of {len(frames)} frames cannot be a sheet too")
    return _cut(frames[0], *_cell_size(frames[0].size, options)), True


def _cell_size(size, options):
    if options.frame:
        width, height = options.frame
        wanted = f"frames of {width} x {height}"
        exact = size[0] % width == 0 and size[1] % height == 0
    else:
        columns, rows = options.grid
        width, height = size[0] // columns, size[1] // rows
        wanted = f"{columns} columns and {rows} rows"
        exact = (width * columns, height * rows) == size
    if not exact:
        raise ShapeFault(f"{size[0]} x {size[1]} pixels cannot be cut evenly into {wanted}")
    return width, height


def _cut(sheet, width, height):
    """In reading order."""
    return [sheet.crop((x, y, x + width, y + height)) for y in range(0, sheet.height, height) for x in range(0, sheet.width, width)]


# ---- Solid or empty

def _solid(frame, options):
    """The mask; pixels of the key's color become transparent in the frame too."""
    pixels = np.asarray(frame)
    solid = pixels[..., 3] >= options.alpha
    if options.key is None:
        return solid
    keyed = (pixels[..., :3] == np.array(options.key, dtype=np.uint8)).all(axis=2)
    frame.putalpha(Image.fromarray(np.where(keyed, 0, pixels[..., 3])))
    return solid & ~keyed


def _refuse_blank(frames, masks, options):
    if not any(mask.any() for mask in masks):
        raise ShapeFault("nothing is solid")
    if not all(mask.all() for mask in masks):
        return
    if options.key is not None:
        raise ShapeFault(f"all opaque: no pixel has the color of --key, {_color(options.key)}")
    raise ShapeFault(f"all opaque: no alpha is below {options.alpha}; give --key with the background's color "
                     f"(the upper left pixel is {_color(frames[0].getpixel((0, 0)))})")


def _color(color):
    return "%02x%02x%02x" % tuple(color[:3])
