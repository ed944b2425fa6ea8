#!/usr/bin/env python3
# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Draws docs/demo.gif and the screenshots docs/demo-*.png from runs of the demo. Usage: picture.py [DEMO], default build/tuff-demo.

import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"

FPS = 20
SIZE = "640x360"
COLORS = 127         # and one that means: as in the frame before
FLAT_COLORS = 64     # of these, the most frequent

# The animation: seed, first step, last step, options. 60 steps are a second.
SCENES = [
    (37, 60, 255, []),
    (37, 255, 360, ["--overlay", "chunks,bounds"]),
    (37, 360, 435, ["--overlay", "normals,contacts"]),
    (15, 834, 954, ["--split", "--overlay", "contacts"]),
]

# A screenshot each: name, seed, step, options.
SHOTS = [
    ("chunks", 37, 255, ["--overlay", "chunks"]),
    ("bounds", 37, 255, ["--overlay", "bounds"]),
    ("normals", 37, 255, ["--overlay", "normals"]),
    ("contacts", 49, 828, ["--overlay", "contacts"]),
    ("split", 15, 930, ["--split"]),
]


def pictures(demo, seed, first, last, options):
    """The pictures after step first up to step last."""
    with tempfile.TemporaryDirectory() as folder:
        command = [demo, "--seed", str(seed), "--ppm", f"{folder}/", "--from", str(first), "--frames", str(last),
                   "--fps", str(FPS), "--size", SIZE, *options]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return [Image.open(path).convert("RGB") for path in sorted(Path(folder).glob("*.ppm"))]


def shared_palette(frames):
    """One palette for all frames: the flat colors as they are, the rest, mostly blended edges, by median cut."""
    counts = {}
    for frame in frames[::5]:
        for count, color in frame.getcolors(frame.width * frame.height):
            counts[color] = counts.get(color, 0) + count
    by_count = sorted(counts, key=lambda color: (-counts[color], color))
    flat, rest = by_count[:FLAT_COLORS], sorted(by_count[FLAT_COLORS:])
    swatch = [color for color in rest for _ in range(round(counts[color] ** 0.4))]
    sheet = Image.new("RGB", (len(swatch), 1))
    sheet.putdata(swatch)
    blended = sheet.quantize(colors=COLORS - FLAT_COLORS, method=Image.Quantize.MEDIANCUT)
    colors = [part for color in flat for part in color] + blended.getpalette()[: 3 * (COLORS - FLAT_COLORS)]
    palette = Image.new("P", (1, 1))
    palette.putpalette(colors)
    return palette


def without_repeats(frames):
    """Pixels that stay as they were become the transparent color, which packs to nothing."""
    before = None
    for frame in frames:
        bytes_now = frame.tobytes()
        if before is None:
            packed = bytes_now
        else:
            packed = bytes(COLORS if now == old else now for now, old in zip(bytes_now, before))
        before = bytes_now
        result = Image.frombytes("P", frame.size, packed)
        result.putpalette(frame.getpalette())
        yield result


def animate(demo):
    frames = [frame for scene in SCENES for frame in pictures(demo, *scene)]
    palette = shared_palette(frames)
    indexed = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    packed = list(without_repeats(indexed))
    target = DOCS / "demo.gif"
    packed[0].save(target, save_all=True, append_images=packed[1:], duration=1000 // FPS, loop=0, disposal=1,
                   transparency=COLORS, optimize=False)
    print(f"{target.relative_to(ROOT)}: {len(packed)} frames, {target.stat().st_size} bytes")


def shoot(demo):
    for name, seed, step, options in SHOTS:
        target = DOCS / f"demo-{name}.png"
        pictures(demo, seed, step - 60 // FPS, step, options)[-1].save(target, optimize=True)
        print(f"{target.relative_to(ROOT)}: {target.stat().st_size} bytes")


def main():
    demo = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "build" / "tuff-demo")
    DOCS.mkdir(exist_ok=True)
    animate(demo)
    shoot(demo)


if __name__ == "__main__":
    main()
