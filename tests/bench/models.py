#!/usr/bin/env python3
# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# What a model of an outline costs and how true it is: models.py PROGRAM ROCKS OUT.csv, run by `make bench-models` in the project's folder.
# Bakes the models by tools/shapes, asks the picture itself what is hit at random places near its border, and lets models.c ask the models.
import argparse
import csv
import os
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np
import shapely
from tqdm import tqdm

import outlines
from tuff_shapes import pipeline
from tuff_shapes.options import parser
from tuff_shapes.piece import relative, rom_bytes, vertex_count

HULLS = (4, 6, 8, 12, 16)     # vertices
TOLERANCES = (2, 1, 0.5)      # pixels, of convex parts
PLACES = 1000                 # of each outline
BAND = 12.0                   # pixels outside the border, in which the places lie: about half of the answers are yes
RADIUS = 6                    # of the circle, and of the hull about its middle; pixels
BEAM = 32                     # pixels from end to end, rounded to the lattice
SEED = 4

STEPS = 65536                 # of a unit, in the program's file
LATTICE = 64                  # steps of a pixel on which places lie: exact in both builds
QUERIES = ("circle", "hull", "beam")
BUILDS = ("float", "q16")
COLUMNS = ("outline", "model", "vertices", "parts", "bytes", "error_max", "error_mean", "build", "query", "ns", "instructions",
           "wrong_share", "setting")


# ---- Models

def settings():
    """(model, what its column `setting` says, what the command line of the tool would say)."""
    hulls = [("hull", str(count), ["--model", "hull", "--vertices", str(count)]) for count in HULLS]
    parts = [("parts", str(px), ["--tolerance", str(px)]) for px in TOLERANCES]
    return [("circle", "", ["--model", "circle"]), *hulls, *parts]


def baked(task):
    drawing, arguments = task
    return pipeline.bake(drawing, parser().parse_args(["picture", *arguments]), None)[0]


def bake_all(drawings):
    """A list of pieces for each outline, in the order of settings()."""
    drawings = [(drawing, arguments) for drawing in drawings for _, _, arguments in settings()]
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        pieces = list(tqdm(pool.map(baked, drawings), total=len(drawings), desc="models", unit="model"))
    each = len(settings())
    return [pieces[i:i + each] for i in range(0, len(pieces), each)]


# ---- Places, and what the picture says

def hull_corners():
    """A regular 5-gon on the lattice."""
    turns = 2 * np.pi * np.arange(5) / 5
    return np.rint(np.stack([np.cos(turns), np.sin(turns)], axis=1) * RADIUS * LATTICE)


def places(picture, random):
    """Middles of queries and half beams, on the lattice, evenly over the band."""
    left, top, right, bottom = picture.buffer(BAND).bounds
    points = random.uniform((left, top), (right, bottom), size=(16 * PLACES, 2))
    apart = shapely.distance(picture, shapely.points(points))
    middles = points[(apart > 0) & (apart < BAND)][:PLACES]
    turns = random.uniform(0, 2 * np.pi, len(middles))
    halves = np.stack([np.cos(turns), np.sin(turns)], axis=1) * BEAM / 2
    return np.rint(middles * LATTICE), np.rint(halves * LATTICE)


def touched(picture, middles, halves):
    """Whether circle, hull and beam meet the picture's solid pixels, at each place."""
    points, reach = middles / LATTICE, halves / LATTICE
    hulls = shapely.polygons(points[:, None, :] + hull_corners()[None] / LATTICE)
    beams = shapely.linestrings(np.stack([points - reach, points + reach], axis=1))
    shapely.prepare(picture)
    return np.stack([shapely.distance(picture, shapely.points(points)) < RADIUS, shapely.intersects(picture, hulls),
                     shapely.intersects(picture, beams)], axis=1)


# ---- The program's file

def steps(values):
    return " ".join(str(int(value) * (STEPS // LATTICE)) for value in np.ravel(values))


def piece_text(piece):
    lines = [steps(piece.origin), f"{piece.radius_raw} {piece.bounding_raw} {len(piece.parts)}"]
    lines += [f"{len(part.vertices)} {part.internal} {steps(relative(part.vertices, piece.origin))}" for part in piece.parts]
    return "\n".join(lines)


def outline_text(pieces, random):
    region = pieces[0].region
    picture = shapely.Polygon(region.exterior, region.holes)
    middles, halves = places(picture, random)
    answers = touched(picture, middles, halves).astype(int)
    lines = [f"{steps(middle)} {steps(half)} {' '.join(map(str, row))}" for middle, half, row in zip(middles, halves, answers)]
    return "\n".join([str(len(lines)), *lines, str(len(pieces)), *map(piece_text, pieces)])


def file_text(pieces_per_outline):
    random = np.random.default_rng(SEED)
    corners = hull_corners()
    first = [str(RADIUS * STEPS), str(len(corners)), steps(corners), str(len(pieces_per_outline))]
    return "\n".join([*first, *(outline_text(pieces, random) for pieces in pieces_per_outline), ""])


# ---- Measuring: {(outline, model, build, query): figures}

def key(text):
    outline, model, build, query = text.split(",")
    return int(outline), int(model), build, int(query)


def lines_of(*command):
    """The words of each line that a program prints; it shows its progress itself."""
    return map(str.split, subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines())


def timed(program, file):
    """Median ns, and the number of wrong answers."""
    return {key(name): (float(ns), int(wrong)) for name, ns, wrong in lines_of(program, "time", file)}


def counted(program, file):
    """Instructions."""
    print("counting instructions under callgrind", file=sys.stderr)
    return {key(name): float(count) for name, count in lines_of("scripts/count-instructions", program, "count", file)}


# ---- The table

def rows(names, pieces_per_outline, times, counts):
    for outline, (name, pieces) in enumerate(zip(names, pieces_per_outline)):
        for model, (piece, (kind, setting, _)) in enumerate(zip(pieces, settings())):
            about = [name, kind, vertex_count(piece), len(piece.parts), rom_bytes(piece),
                     f"{piece.deviation.largest:.4f}", f"{piece.deviation.mean:.4f}"]
            for build in BUILDS:
                for query, query_name in enumerate(QUERIES):
                    where = outline, model, build, query
                    ns, wrong = times[where]
                    yield [*about, build, query_name, f"{ns:.2f}", f"{counts[where]:.1f}", f"{wrong / PLACES:.5f}", setting]


def main():
    command = argparse.ArgumentParser(description="Measure models of outlines; see the head of this file.")
    command.add_argument("program", help="bench-models, built from models.c")
    command.add_argument("rocks", type=Path, help="the folder of the demo's rocks")
    command.add_argument("out", type=Path, help="models.csv; the program's input and the pictures go into the same folder")
    options = command.parse_args()
    options.out.parent.mkdir(parents=True, exist_ok=True)
    found = outlines.all_outlines(options.rocks, options.out.parent)
    pieces = bake_all(found.values())
    file = options.out.parent / "models.txt"
    file.write_text(file_text(pieces), encoding="ascii")
    times, counts = timed(options.program, file), counted(options.program, file)
    with options.out.open("w", newline="", encoding="ascii") as handle:
        csv.writer(handle, lineterminator="\n").writerows([COLUMNS, *rows(found, pieces, times, counts)])
    print(f"wrote {options.out}", file=sys.stderr)


if __name__ == "__main__":
    main()
