#!/usr/bin/env python3
# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Draws the demo's rocks: small.png, medium.png, large.png, concave.png, sheets of one row. `make rocks-draw`, or draw.py FOLDER.
# The pictures are the source of what is hit: draw them anew here or with any paint program, and the build traces them again.
# No sine, no power and no library's random numbers: the same pixels on every machine.

import sys
from pathlib import Path

import numpy as np
from PIL import Image

# Corners in pixels from the middle of the frame, x right, y down.
OCTAGON = [(16, 2), (11, 11), (2, 15), (-9, 13), (-15, 4), (-14, -7), (-5, -15), (8, -13)]
CHUNK = [(15, -6), (13, 8), (-3, 14), (-15, 5), (-12, -9), (3, -14)]
ROUND = [(16, 0), (13, 9), (5, 15), (-5, 15), (-13, 9), (-16, -1), (-11, -11), (0, -16), (11, -11)]
WEDGE = [(15, 4), (-2, 13), (-15, 7), (-10, -11), (9, -12)]
SLAB = [(16, -2), (14, 7), (3, 11), (-13, 9), (-16, 0), (-9, -10), (10, -10)]
CONVEX = [OCTAGON, CHUNK, ROUND, WEDGE, SLAB]

ELL = [(-22, -30), (-8, -28), (-4, 6), (24, 7), (28, 16), (18, 29), (-20, 30), (-26, 8)]
STAR = [(11, -15), (40, -10), (17, 6), (22, 31), (0, 18), (-26, 34), (-17, 6), (-36, -12), (-11, -15), (2, -39)]
CRESCENT = [(32, 35), (5, 39), (-19, 26), (-28, 0), (-19, -26), (5, -39), (32, -35), (10, -24), (-3, -16), (-8, 0), (-3, 16), (10, 24)]
CONCAVE = [ELL, STAR, CRESCENT]

# name: frame's side, corners of its rocks, size, quarter turns, soft border
SHEETS = {
    "small": (40, CONVEX, 1.0, 0, False),
    "medium": (56, CONVEX, 1.5, 1, False),
    "large": (72, CONVEX, 2.0, 2, False),
    "concave": (88, CONCAVE, 1.0, 0, True),
}

STONE = [(38, 32, 38), (62, 54, 60), (90, 81, 86), (122, 110, 108), (154, 141, 132), (186, 173, 158), (216, 205, 188)]
ICE = [(28, 34, 60), (46, 56, 92), (68, 82, 126), (94, 112, 162), (122, 142, 198), (156, 176, 226), (200, 214, 246)]
LIGHT = (-0.56, -0.60, 0.57)     # from the upper left, toward the eye
FINE = 4                         # samples a pixel, each way, for the border
BAYER = np.array([[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]]) / 16 - 15 / 32


def chance(x, y, seed):
    """Numbers from 0 to 1 that a hash of whole coordinates gives."""
    mixed = (x.astype(np.uint64) * 2654435761 ^ y.astype(np.uint64) * 2246822519 ^ np.uint64(seed * 3266489917)) & 0xFFFFFFFF
    for shift in (15, 13, 16):
        mixed = ((mixed ^ mixed >> shift) * 2246822519) & 0xFFFFFFFF
    return mixed / 0xFFFFFFFF


def noise(x, y, cell, seed):
    """Value noise from -1 to 1: chance at the corners of cells, blended in between."""
    left, top = np.floor(x / cell), np.floor(y / cell)
    u, v = x / cell - left, y / cell - top
    u, v = u * u * (3 - 2 * u), v * v * (3 - 2 * v)
    corner = [[chance(left + i + 512, top + j + 512, seed) for i in (0, 1)] for j in (0, 1)]
    upper, lower = (row[0] + (row[1] - row[0]) * u for row in corner)
    return 2 * (upper + (lower - upper) * v) - 1


def depth(x, y, corners):
    """Distance from the outline, positive inside."""
    nearest = np.full(x.shape, 1e9)
    inside = np.zeros(x.shape, dtype=bool)
    for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1]):
        ex, ey = bx - ax, by - ay
        along = np.clip(((x - ax) * ex + (y - ay) * ey) / (ex * ex + ey * ey), 0, 1)
        dx, dy = x - ax - along * ex, y - ay - along * ey
        nearest = np.minimum(nearest, dx * dx + dy * dy)
        crossed = (ay > y) != (by > y)
        inside ^= crossed & (x < ax + (y - ay) * ex / (ey if ey else 1))
    return np.where(inside, 1, -1) * np.sqrt(nearest)


def solid(x, y, corners, seed):
    """How deep below the rock's rough border a point lies."""
    return depth(x, y, corners) + 0.4 * noise(x, y, 5, seed) - 0.1


def craters(x, y, corners, seed):
    """Bowls with a rim: their height, and nothing beyond the rim."""
    height = np.zeros(x.shape)
    spots = np.arange(40)
    places = zip(*(chance(spots, spots + k, seed + 7) for k in (1, 2, 3)))
    reach = max(abs(c) for corner in corners for c in corner)
    taken = []
    for px, py, size in places:
        cx, cy, r = (2 * px - 1) * reach, (2 * py - 1) * reach, reach * (0.10 + 0.16 * size * size)
        apart = all((cx - ox) ** 2 + (cy - oy) ** 2 > (r + other) ** 2 for ox, oy, other in taken)
        if not apart or depth(np.array([cx]), np.array([cy]), corners)[0] < 0.8 * r:
            continue
        taken.append((cx, cy, r))
        t = ((x - cx) * (x - cx) + (y - cy) * (y - cy)) / (r * r)
        height += r * np.where(t < 1, 0.55 * t - 0.40, np.maximum(0.15 * (2 - t), 0))
    return height


def relief(x, y, corners, seed):
    """The rock's height: a dome that falls off to the border, roughness, craters."""
    inward = depth(x, y, corners)
    slope = 1 - np.clip(inward / (0.75 * inward.max()), 0, 1)
    dome = 0.75 * inward.max() * (1 - slope * slope)
    rough = 1.6 * noise(x, y, 9, seed + 1) + 0.6 * noise(x, y, 4, seed + 2)
    return dome + rough + craters(x, y, corners, seed)


def shades(height, count):
    """Which of so many shades a pixel has: the light's part along the normal, dithered."""
    down, right = np.gradient(height)
    light = (LIGHT[2] - LIGHT[0] * right - LIGHT[1] * down) / np.sqrt(1 + right * right + down * down)
    rows, columns = height.shape
    dither = np.tile(BAYER, (rows // 4, columns // 4))
    level = np.floor((0.10 + 0.90 * np.clip(light, 0, 1)) * count + 0.7 * dither)
    return np.clip(level, 0, count - 1).astype(np.intp)


def grid(side, samples):
    """The middles of a frame's samples, from the frame's middle."""
    steps = (np.arange(side * samples) + 0.5) / samples - side / 2
    return np.meshgrid(steps, steps)


def cover(side, corners, seed, soft):
    """Alpha: which part of each pixel is rock; without soft, all or nothing."""
    inside = solid(*grid(side, FINE), corners, seed) > 0
    part = inside.reshape(side, FINE, side, FINE).mean(axis=(1, 3))
    return np.rint(255 * part if soft else 255 * (part >= 0.5)).astype(np.uint8)


def rock(side, corners, seed, soft, ramp):
    pixels = np.zeros((side, side, 4), dtype=np.uint8)
    pixels[..., :3] = np.array(ramp)[shades(relief(*grid(side, 1), corners, seed), len(ramp))]
    pixels[..., 3] = cover(side, corners, seed, soft)
    pixels[pixels[..., 3] == 0] = 0
    return pixels


def turned(corners, size, quarters):
    for _ in range(quarters):
        corners = [(-y, x) for x, y in corners]
    return [(x * size, y * size) for x, y in corners]


def sheet(name):
    side, outlines, size, quarters, soft = SHEETS[name]
    first = 100 * list(SHEETS).index(name)
    ramp = ICE if soft else STONE
    frames = [rock(side, turned(corners, size, quarters), first + 10 * i, soft, ramp) for i, corners in enumerate(outlines)]
    return Image.fromarray(np.concatenate(frames, axis=1))


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    for name in SHEETS:
        sheet(name).save(folder / f"{name}.png", optimize=True)


if __name__ == "__main__":
    main()
