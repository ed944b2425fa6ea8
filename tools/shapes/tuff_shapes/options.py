# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# What the command line may say, and which values make sense. A value that does not is told with status 2 before anything is read.
import argparse
import re
from math import isfinite

TABLE_REGIONS = 16    # pieces; more are not tried with all the neighbors of a model unless the author asks for the table
MAX_PER_UNIT = 8192   # a corner 1024 units away is then 2^23 steps away, which a float holds


# ---- Values

def whole_number(low, high):
    def parse(text):
        if not re.fullmatch(r"-?\d+", text) or not low <= int(text) <= high:
            raise argparse.ArgumentTypeError(f"{text!r} is not a whole number from {low} to {high}")
        return int(text)
    return parse


def number(text, least, noun):
    try:
        value = float(text)
    except ValueError:
        value = float("nan")
    if not isfinite(value) or value < least:
        raise argparse.ArgumentTypeError(f"{text!r} is not {noun}")
    return value


def tolerance(text):
    return number(text, 0.0, "a number of pixels, 0 or more")


def scale(text):
    return number(text, 1e-4, "a number of units per pixel, 0.0001 or more")


def per_unit(text):
    value = whole_number(1, MAX_PER_UNIT)(text)
    if value & (value - 1):
        raise argparse.ArgumentTypeError(f"{text!r} is not a power of two")
    return value


def pair(noun):
    def parse(text):
        match = re.fullmatch(r"([1-9]\d{0,5})[xX]([1-9]\d{0,5})", text)
        if not match:
            raise argparse.ArgumentTypeError(f"{text!r} is not {noun}")
        return int(match[1]), int(match[2])
    return parse


def strip(text):
    return whole_number(1, 65535)(text), 1


def origin(text):
    if text in ("area", "center"):
        return text
    fields = text.split(",")
    if len(fields) != 2:
        raise argparse.ArgumentTypeError(f"{text!r} is not area, center or X,Y in pixels")
    return tuple(number(field, -1e6, "area, center or X,Y in pixels") for field in fields)


def color(text):
    from PIL import ImageColor
    try:
        return ImageColor.getrgb(f"#{text}" if re.fullmatch("[0-9a-fA-F]{6}", text) else text)[:3]
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a color such as ff00ff or magenta") from None


def header_name(text):
    """As it stands after #include."""
    if not re.fullmatch(r"""[^<>"\\]+|<[^<>"\\]+>|"[^<>"\\]+\"""", text) or not text.isascii() or not text.isprintable():
        raise argparse.ArgumentTypeError(f"{text!r} is not the name of a header")
    return text if text[0] in '<"' else f'"{text}"'


# ---- Options

def parser():
    command = argparse.ArgumentParser(
        prog="python -m tuff_shapes", allow_abbrev=False,
        description="Trace a picture, a sprite sheet, a Tiled map or an SVG drawing into a C header with convex parts for tuff.")
    add = command.add_argument
    add("input", metavar="IN", help="a picture, .tmx .tsx .tmj .tsj .json (Tiled), or .svg")
    add("-o", "--output", metavar="OUT.h", help="the header to write (default: standard output)")
    add_reading(command.add_argument_group("what is solid"))
    add_fitting(command.add_argument_group("how true, with how much"))
    add_placing(command.add_argument_group("units and names"))
    add_showing(command.add_argument_group("what is shown"))
    return command


def add_reading(group):
    add = group.add_argument
    add("--alpha", type=whole_number(1, 255), default=128, metavar="A",
        help="pixels of this alpha or more are solid (1 .. 255, default 128)")
    add("--key", type=color, metavar="COLOR", help="pixels of exactly this color are empty: ff00ff, magenta")
    add("--specks", type=whole_number(0, 10 ** 9), default=16, metavar="N",
        help="islands and holes below N pixels are dropped (default 16)")
    cells = group.add_mutually_exclusive_group()
    cells.add_argument("--grid", type=pair("COLUMNSxROWS"), metavar="CxR", help="a sheet of C by R frames")
    cells.add_argument("--strip", type=strip, dest="grid", metavar="N", help="the same as --grid Nx1")
    cells.add_argument("--frame", type=pair("WIDTHxHEIGHT"), metavar="WxH", help="a sheet of frames of W by H pixels")
    add("--merge", action="store_true", help="maps: solid tiles that touch become one piece")


def add_fitting(group):
    measure = group.add_mutually_exclusive_group()
    measure.add_argument("--tolerance", type=tolerance, metavar="PX",
                         help="the outline is no farther from the picture's border (default 1; corners set by hand stay)")
    measure.add_argument("--vertices", type=whole_number(3, 65535), metavar="N",
                         help="at most N vertices in the outline of each piece, as true as can be")
    group.add_argument("--model", choices=("parts", "hull", "circle"), default="parts",
                       help="convex parts of the outline (default), its convex hull, or the circle of the same area")


def add_placing(group):
    add = group.add_argument
    add("--scale", type=scale, default=1.0, metavar="S", help="world units per pixel (default 1)")
    add("--per-unit", type=per_unit, default=64, metavar="N", help="corners lie on steps of 1/N unit, a power of two (default 64)")
    add("--y-up", action="store_true", help="y grows upward in the game (default: downward, as in the picture)")
    add("--origin", type=origin, default="area", metavar="WHERE",
        help="the position: area (its center, default), center (of the picture), or X,Y in pixels (--origin=-4,0 for a negative X)")
    add("--name", help="the name in C (default: from the file's name)")
    add("--include", type=header_name, default="<tuff/tuff.h>", metavar="FILE", help="the header to include (default <tuff/tuff.h>)")


def add_showing(group):
    add = group.add_argument
    add("--preview", metavar="FILE", help="draw the result into FILE.png or FILE.svg")
    add("--table", action=argparse.BooleanOptionalAction, help=f"compare with other models (default: up to {TABLE_REGIONS} pieces)")
    add("--progress", action="store_true", help="show the progress bar even where standard error is no terminal")
    add("--quiet", action="store_true", help="print errors only")
