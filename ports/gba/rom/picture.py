#!/usr/bin/env python3
# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Draws docs/gba-*.png, twice as large as the screen, from a run of the ROM by the keys of tests/rom. Usage: picture.py RUNNER ROM.

import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[3]
SCALE = 2

# A picture each: name, frame of the screen.
SHOTS = [("title", 150), ("beam", 575), ("bounds", 770)]


def main():
    runner, rom = sys.argv[1:3]
    lines = (ROOT / "tests" / "rom" / "keys.list").read_text().splitlines()
    keys = [line for line in lines if not line.startswith("#")]
    with tempfile.TemporaryDirectory() as folder:
        shots = [f"{frame}:shot={folder}/{name}.ppm" for name, frame in SHOTS]
        stop = f"{max(frame for _, frame in SHOTS) + 1}:stop"
        subprocess.run([runner, rom, *keys, *shots, stop], check=True, stdout=subprocess.DEVNULL)
        for name, _ in SHOTS:
            picture = Image.open(f"{folder}/{name}.ppm").convert("RGB")
            large = picture.resize((picture.width * SCALE, picture.height * SCALE), Image.Resampling.NEAREST)
            target = ROOT / "docs" / f"gba-{name}.png"
            large.quantize(colors=256, dither=Image.Dither.NONE).save(target, optimize=True)
            print(f"{target.relative_to(ROOT)}: {target.stat().st_size} bytes")


if __name__ == "__main__":
    main()
