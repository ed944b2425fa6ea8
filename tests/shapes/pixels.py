# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# What the picture says, apart from the tool's own tracing: exact distances of pixel centers from the border of a mask or of polygons,
# and the harness's answers held against them.
from dataclasses import dataclass
from pathlib import Path

import builds
import numpy as np
import shapely

NEAR = 4        # pixels on either side of the border are asked
MARGIN = NEAR + 1
RADIUS = 0.5    # pixels


@dataclass
class Probe:
    """Pixel centers near the border, (n, 2), and how far outside of it they lie; negative inside."""

    frame: int
    centers: np.ndarray
    distances: np.ndarray


def border_edges(mask):
    """Middles of the unit edges between solid and empty pixels: upright ones, level ones. The mask is padded."""
    upright = np.argwhere(mask[:, 1:] != mask[:, :-1])[:, ::-1] + [1.0, 0.5]
    level = np.argwhere(mask[1:] != mask[:-1])[:, ::-1] + [0.5, 1.0]
    return upright, level


def square_distance(points, middles, axis):
    """From each point to the nearest of unit edges along an axis."""
    if not len(middles):
        return np.full(len(points), np.inf)
    gaps = np.abs(points[:, None, :] - middles[None])
    along = np.maximum(gaps[..., axis] - 0.5, 0)
    return (along ** 2 + gaps[..., 1 - axis] ** 2).min(axis=1)


def centers_of(width, height):
    y, x = np.mgrid[0:height, 0:width]
    return np.stack([x.ravel(), y.ravel()], axis=1) + 0.5


def probe_mask(mask, frame=0):
    padded = np.pad(mask, MARGIN)
    upright, level = border_edges(padded)
    points = centers_of(*padded.shape[::-1])
    chunks = np.array_split(points, 1 + len(points) // 2000)    # for the sake of memory
    squares = [np.minimum(square_distance(some, upright, 1), square_distance(some, level, 0)) for some in chunks]
    distances = np.sqrt(np.concatenate(squares)) * np.where(padded.ravel(), -1, 1)
    close = np.abs(distances) <= NEAR
    return Probe(frame, points[close] - MARGIN, distances[close])


def probe_ground(ground, size):
    """Of a shapely geometry instead of pixels: a map."""
    points = centers_of(size[0] + 2 * MARGIN, size[1] + 2 * MARGIN) - MARGIN
    spots = shapely.points(points)
    distances = shapely.distance(spots, ground.boundary) * np.where(shapely.contains(ground, spots), -1, 1)
    close = np.abs(distances) <= NEAR
    return Probe(0, points[close], distances[close])


def split(probe, chosen):
    """Two probes: of the chosen centers, and of the others."""
    return [Probe(probe.frame, probe.centers[some], probe.distances[some]) for some in (chosen, ~chosen)]


def build(header, kind, folder, scalar, library, y_up=False):
    """The harness with one header; kind: FRAMES, MAP, ISLANDS or empty."""
    name = Path(header).stem
    options = [f'-DSHAPES="{header}"', f"-DSHAPE={name}", f"-DMACRO={name.upper()}"]
    options += [f"-DOF_{kind}"] * bool(kind) + ["-DY_UP"] * y_up
    return builds.link(builds.ROOT / "tests/shapes/harness.c", folder / f"{name}-{scalar}", scalar, library, *options)


def ask(program, probes, scale=1.0):
    """Faults of the pieces and of the world, and for each probe an array of bool: hit."""
    lines = []
    for probe in probes:
        raw = np.rint(probe.centers * scale * 65536).astype(int)
        lines += [f"{probe.frame} {x} {y} {round(RADIUS * scale * 65536)}" for x, y in raw]
    *faults, answers = builds.run([program], input="\n".join(lines)).splitlines()
    hits = np.frombuffer(answers.encode(), dtype=np.uint8) == ord("1")
    assert len(hits) == len(lines)
    return faults, np.split(hits, np.cumsum([len(probe.centers) for probe in probes])[:-1])


def wrong(probe, hits, tolerance):
    """Wrong pixels that the tolerance does not allow, and those that it does."""
    outside = probe.distances - RADIUS
    miss = hits != (outside < 0)
    beyond = miss & (np.abs(outside) > tolerance)
    return int(beyond.sum()), int((miss & ~beyond).sum())
