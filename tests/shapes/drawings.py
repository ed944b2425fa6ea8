# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Ten pictures as an author draws them, for the test that goes from picture to game; and what they show.
from math import cos, pi, sin

import blobs
import maps
import numpy as np
import shapely
from PIL import Image, ImageDraw, ImageFont
from shapely import affinity

SOLID = 128    # alpha


def canvas(width, height):
    return Image.new("RGBA", (width, height))


def polygon(points, size=(96, 96), smooth=1):
    """Filled; smooth > 1: drawn so many times as large, and made small again with soft edges."""
    picture = canvas(size[0] * smooth, size[1] * smooth)
    ImageDraw.Draw(picture).polygon([(x * smooth, y * smooth) for x, y in points], fill=(140, 120, 100, 255))
    return picture.resize(size, Image.Resampling.BOX) if smooth > 1 else picture


def spokes(count, radius, center=(48, 48)):
    """Corners at equal angles; radius gives the distance of each from the center."""
    return [(center[0] + radius(i) * cos(2 * pi * i / count), center[1] + radius(i) * sin(2 * pi * i / count)) for i in range(count)]


def convex():
    return polygon(spokes(9, lambda i: 38 + 4 * (i % 3)), smooth=4)


def ell():
    return polygon([(10, 8), (34, 12), (36, 60), (86, 58), (88, 84), (14, 88)])


def star():
    return polygon(spokes(12, lambda i: (44, 20)[i % 2]), smooth=4)


def crescent():
    picture = canvas(384, 384)
    draw = ImageDraw.Draw(picture)
    draw.ellipse((32, 32, 352, 352), fill=(200, 180, 90, 255))
    draw.ellipse((140, 20, 400, 300), fill=(0, 0, 0, 0))
    return picture.resize((96, 96), Image.Resampling.BOX)


def ring():
    picture = canvas(112, 96)
    draw = ImageDraw.Draw(picture)
    draw.ellipse((6, 4, 104, 90), fill=(90, 90, 90, 255))
    draw.ellipse((30, 30, 70, 72), fill=(0, 0, 0, 0))
    return picture


def letter():
    picture = canvas(80, 112)
    ImageDraw.Draw(picture).text((40, 56), "R", font=ImageFont.load_default(100), fill=(255, 255, 255, 255), anchor="mm")
    return picture


def spike():
    return polygon([(2, 60), (40, 52), (125, 61), (40, 70)], size=(128, 112))


def blob():
    mask = blobs.blob(2105, 96)
    return Image.fromarray(np.where(mask[..., None], np.uint8([120, 100, 80, 255]), np.uint8(0)), "RGBA")


def sheet():
    """Eight frames of a rock that turns and shrinks, and at last breaks in two."""
    picture = canvas(8 * 64, 64)
    for frame in range(7):
        corners = spokes(10, lambda i: (28, 24, 15, 26, 29)[i % 5] - 2 * frame, (32, 32))
        turned = affinity.rotate(shapely.Polygon(corners), 20 * frame, origin=(32, 32))
        picture.paste(polygon(list(turned.exterior.coords), (64, 64)), (64 * frame, 0))
    picture.paste(polygon([(6, 20), (26, 12), (24, 40)], (64, 64)), (64 * 7, 0))
    half = polygon([(36, 50), (58, 30), (60, 56)], (64, 64))
    picture.paste(half, (64 * 7, 0), half)
    return picture


def masks(picture, frames=1):
    """What is solid in each frame."""
    return np.split(np.asarray(picture)[..., 3] >= SOLID, frames, axis=1)


# ---- The map of maps.py, read by hand from what Tiled's documentation says

def cell(column, row):
    return shapely.box(16 * column, 16 * row, 16 * column + 16, 16 * row + 16)


def flipped_slopes():
    """Third row: the slope mirrored along its diagonal, then to the left and right, then up and down."""
    corner, shapes = shapely.Polygon(maps.SLOPE), []
    for column, flips in enumerate(maps.FLIPS):
        points = shapely.get_coordinates(corner)
        if flips & 0x20000000:
            points = points[:, ::-1]
        if flips & 0x80000000:
            points = points * [-1, 1] + [16, 0]
        if flips & 0x40000000:
            points = points * [1, -1] + [0, 16]
        shapes.append(affinity.translate(shapely.Polygon(points), 16 * column, 32))
    return shapes


def shelf(column, row):
    return shapely.box(16 * column, 16 * row + 8, 16 * column + 16, 16 * row + 16)


def ellipse(x, y, width, height):
    return affinity.scale(shapely.Point(x + width / 2, y + height / 2).buffer(1, 64), width / 2, height / 2)


def ellipses():
    """A bump on each shelf, and the pond."""
    return [ellipse(4, 98, 8, 4), ellipse(20, 98, 8, 4), ellipse(82, 11, 40, 20)]


def tiles():
    slope = affinity.translate(shapely.Polygon(maps.SLOPE), 160, 96)
    tree = affinity.translate(shapely.Polygon([(0, 0), (16, 8), (16, 40), (0, 40)]), 32 + 4, 96 - 40)
    return [*flipped_slopes(), tree, shelf(0, 6), shelf(1, 6), slope, cell(11, 6), *(cell(column, 7) for column in range(12))]


def objects():
    """On a layer that is 2 pixels to the right and 1 up; angles are clockwise, as y goes down."""
    arch = shapely.Polygon([(0, 0), (40, 0), (40, 30), (30, 30), (30, 10), (10, 10), (10, 30), (0, 30)])
    crate = affinity.rotate(shapely.box(70, 52, 94, 60), -90, origin=(70, 60))
    beam = affinity.rotate(shapely.box(140, 20, 164, 32), 30, origin=(140, 20))
    shapes = [affinity.translate(arch, 20, 10), beam, crate, shapely.box(0, 126, 192, 128)]
    return [affinity.translate(shape, 2, -1) for shape in shapes]


def map_ground():
    return shapely.union_all([*tiles(), *objects(), *ellipses()])
