# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# From picture to game: ten pictures go through the command; a C program that includes the header asks the library, in both builds,
# about every pixel near the border, and is held against the picture.
from dataclasses import dataclass
from typing import Callable

import builds
import drawings
import maps
import pixels
import pytest
import shapely

SLACK = 0.02    # pixels: half a step of the grid in x and y, and the arithmetic


@dataclass(frozen=True)
class Case:
    name: str
    draw: Callable
    kind: str = ""
    frames: int = 1
    tolerance: float = 1.0


CASES = [Case("convex", drawings.convex), Case("ell", drawings.ell), Case("star", drawings.star), Case("crescent", drawings.crescent),
         Case("ring", drawings.ring), Case("letter", drawings.letter, tolerance=0.75), Case("spike", drawings.spike),
         Case("blob", drawings.blob, "ISLANDS", tolerance=1.5), Case("sheet", drawings.sheet, "FRAMES", 8), Case("level", None, "MAP")]
VARIANTS = {"plain": (), "y_up": ("--y-up", "--scale", "2"), "pivot": ("--origin", "12,-3", "--per-unit", "256")}


def write_drawing(case, folder):
    """The picture or map as a file, what is true of it, and by how much the outline may differ from each of that."""
    if case.kind == "MAP":
        return maps.write_map(folder), *map_probes(case.tolerance)
    picture = case.draw()
    picture.save(folder / f"{case.name}.png")
    masks = drawings.masks(picture, case.frames)
    return folder / f"{case.name}.png", [pixels.probe_mask(mask, frame) for frame, mask in enumerate(masks)], [case.tolerance] * len(masks)


def map_probes(tolerance):
    """Only what is round is simplified; all other corners stay where they are."""
    probe = pixels.probe_ground(drawings.map_ground(), (192, 128))
    near_round = shapely.distance(shapely.points(probe.centers), shapely.union_all(drawings.ellipses())) < pixels.RADIUS + tolerance
    return pixels.split(probe, near_round), [tolerance, 0.0]


@pytest.mark.parametrize("variant", VARIANTS)
@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_the_ship_hits_what_is_seen(case, variant, libraries, figures, tmp_path):
    path, probes, tolerances = write_drawing(case, tmp_path)
    options = [*VARIANTS[variant], "--tolerance", case.tolerance] if case.kind != "MAP" else VARIANTS[variant]
    options = [*options, "--strip", case.frames] if case.kind == "FRAMES" else options
    header = tmp_path / f"{case.name}.h"
    done = builds.shapes(path.name, "-o", header.name, "--no-table", *options, folder=tmp_path)
    assert done.returncode == 0, done.stderr
    scale = 2.0 if "--scale" in options else 1.0
    for scalar, library in libraries.items():
        program = pixels.build(header, case.kind, tmp_path, scalar, library, y_up="--y-up" in options)
        faults, answers = pixels.ask(program, probes, scale)
        assert set(faults) == {"0"}
        counts = [pixels.wrong(probe, hits, allowed + SLACK) for probe, hits, allowed in zip(probes, answers, tolerances)]
        assert sum(beyond for beyond, _ in counts) == 0
        if variant == "plain":
            figures(f"{case.name}, {scalar}: {sum(len(hits) for hits in answers)} pixels near the border, "
                    f"{sum(within for _, within in counts)} wrong within {case.tolerance} px, 0 beyond")
