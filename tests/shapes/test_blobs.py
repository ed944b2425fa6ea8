# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# A thousand random blobs go all the way: each closes, is cut, passes the library's checks in both builds and stays inside its tolerance,
# as measured by the tool and as sampled here. One C program holds a hundred.
#
# TUFF_BLOBS=seed: that blob alone.
import io
import os
from dataclasses import dataclass

import blobs
import builds
import made
import numpy as np
import pixels
import pymunk.autogeometry
import pytest
import shapely
from tuff_shapes import convex, header, trace
from tuff_shapes.faults import Journal
from tuff_shapes.model import Drawing, Source

COUNT = 1000
BATCH = 100
SIZE = 48
SPECKS = 16
SPACING = 0.25                   # pixels between samples
TOLERANCES = (1.0, 0.75, 1.5)    # pixels; blob n takes the one at n % 3
ASKED = 10                       # every tenth blob is also compared pixel by pixel
CHAMFER = 0.18                   # pixels: where the tracer takes corners apart that touch

ONLY = os.environ.get("TUFF_BLOBS")
SEEDS = [int(ONLY)] if ONLY else range(COUNT)


@dataclass
class Baked:
    seed: int
    mask: np.ndarray
    drawing: Drawing
    pieces: list
    tolerance: float
    again: str

    @property
    def is_plain(self):
        """No speck was dropped and no hole filled: every pixel is as drawn."""
        area = sum(shapely.Polygon(region.exterior, region.holes).area for region in self.drawing.regions)
        return abs(area - self.mask.sum()) < 1


def bake(seed):
    mask = blobs.blob(seed, SIZE)
    tolerance = TOLERANCES[seed % len(TOLERANCES)]
    frame = str(seed % BATCH)
    regions = trace.regions(mask, SPECKS, Journal(f"blob {seed}", io.StringIO()), "")
    drawing = Drawing(frame, f"frame {frame}", regions, (SIZE, SIZE))
    again = f"TUFF_BLOBS={seed} PYTHONPATH=tools/shapes build/shape-tools/bin/python -m pytest tests/shapes/test_blobs.py"
    return Baked(seed, mask, drawing, made.bake(drawing, made.options(tolerance=tolerance)), tolerance, again)


@pytest.fixture(scope="module")
def baked():
    return [bake(seed) for seed in SEEDS]


def polygon(piece):
    return shapely.Polygon(piece.outline.exterior, piece.outline.holes)


def sampled_error(piece):
    """Both ways, at points along the borders."""
    borders = [shapely.LinearRing(ring) for ring in piece.region.rings]
    outlines = [shapely.LinearRing(np.array(ring) / 64) for ring in piece.outline.rings]
    errors = []
    for border, outline in zip(borders, outlines):
        for one, other in ((border, outline), (outline, border)):
            points = shapely.get_coordinates(one.segmentize(SPACING))
            errors.append(shapely.distance(shapely.points(points), other).max())
    return max(errors)


def test_each_closes_and_is_cut_exactly(baked):
    for blob in baked:
        assert blob.pieces, blob.again
        for piece in blob.pieces:
            assert polygon(piece).is_valid and not polygon(piece).is_empty, blob.again
            assert len(piece.parts) <= 255 and all(len(part.vertices) <= 32 for part in piece.parts), blob.again
            try:
                convex.check(piece.outline, piece.parts)
            except AssertionError as fault:
                pytest.fail(f"{fault}; {blob.again}")


def test_each_stays_inside_its_tolerance(baked):
    for blob in baked:
        for piece in blob.pieces:
            assert piece.deviation.largest <= blob.tolerance, blob.again
            assert sampled_error(piece) <= piece.deviation.largest + 1e-3, blob.again


def program(batch, number, folder, scalar, library):
    """The harness with a hundred blobs as the frames of a sheet."""
    options = made.options(name=f"blobs_{number}", grid=(BATCH, 1))
    source = Source([blob.drawing for blob in batch])
    path = folder / f"blobs_{number}.h"
    path.write_text(header.text([blob.pieces for blob in batch], source, options, "test_blobs.py"))
    return pixels.build(path, "FRAMES", folder, scalar, library)


@pytest.mark.parametrize("scalar", builds.SCALARS)
def test_each_passes_the_checks_and_is_hit_where_it_is_seen(scalar, baked, libraries, tmp_path):
    for number in range(0, len(baked), BATCH):
        batch = baked[number:number + BATCH]
        asked = [blob for blob in batch[::ASKED] if blob.is_plain]
        probes = [pixels.probe_mask(blob.mask, int(blob.drawing.name)) for blob in asked]
        faults, answers = pixels.ask(program(batch, number, tmp_path, scalar, libraries[scalar]), probes)
        assert set(faults) == {"0"}, [blob.again for blob, fault in zip(pieces_in_order(batch), faults) if fault != "0"]
        for blob, probe, hits in zip(asked, probes, answers):
            assert pixels.wrong(probe, hits, blob.tolerance + CHAMFER)[0] == 0, blob.again


def pieces_in_order(batch):
    """The blob of each line that the harness prints; the last is about all together."""
    return [blob for blob in batch for _ in blob.pieces] + [batch[-1]]


# ---- What libraries make of the same borders

def chipmunk_outline(ring, tolerance):
    """Chipmunk's simplification for curves: its tolerance is a distance too."""
    points = [tuple(point) for point in np.vstack([ring, ring[:1]])]
    return len(pymunk.autogeometry.simplify_curves(points, tolerance)) - 1


def chipmunk_parts(piece):
    """Its decomposition of our outline, which it wants without holes and the other way round."""
    ring = [(x / 64, -y / 64) for x, y in piece.outline.exterior]
    return len(pymunk.autogeometry.convex_decomposition([*ring, ring[0]][::-1], 0))


def test_the_counts_beside_those_of_the_libraries(baked, figures):
    pieces = [(piece, blob.tolerance) for blob in baked for piece in blob.pieces]
    solid = [piece for piece, _ in pieces if not piece.outline.holes]
    rings = [(ring, tolerance) for piece, tolerance in pieces for ring in piece.region.rings]
    corners = sum(len(ring) for piece, _ in pieces for ring in piece.outline.rings)
    parts = sum(len(piece.parts) for piece, _ in pieces)
    vertices = sum(len(part.vertices) for piece, _ in pieces for part in piece.parts)
    douglas_peucker = sum(len(shapely.LinearRing(ring).simplify(tolerance).coords) - 1 for ring, tolerance in rings)
    chipmunk = sum(chipmunk_outline(ring, tolerance) for ring, tolerance in rings)
    ours, theirs = sum(len(piece.parts) for piece in solid), sum(chipmunk_parts(piece) for piece in solid)
    figures(f"{len(baked)} blobs of {SIZE} px, {len(pieces)} pieces: {parts} parts, {vertices} vertices in parts; largest error "
            f"{max(piece.deviation.largest / tolerance for piece, tolerance in pieces):.3f} of the tolerance")
    figures(f"{len(baked)} blobs, corners of the outlines: {corners}; shapely simplify, same tolerance: {douglas_peucker}; "
            f"pymunk simplify_curves: {chipmunk}")
    figures(f"{len(baked)} blobs, parts of the {len(solid)} outlines without holes: {ours}; pymunk convex_decomposition: {theirs}")
    assert parts >= len(pieces)
