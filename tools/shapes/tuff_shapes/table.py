# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# What a model costs and how wrong it is, for the model chosen and for its neighbors, so that the author takes the least that is right.
from __future__ import annotations

import argparse
import io
from dataclasses import dataclass

import numpy as np

from . import pipeline
from .faults import Journal, ShapeFault
from .piece import rom_bytes, vertex_count

HULLS, NEAR_HULLS = (4, 6, 8, 12), (4, 8)                 # vertices; all of them where the author asks for the table
STEPS, NEAR_STEPS = (2, 1, 0, -1, -2), (1, 0, -1)         # from a tolerance or budget, in roots of two
CORNERS = 40    # of all outlines together: a model finer than that is not tried unless it is the author's


@dataclass(frozen=True)
class Figures:
    """Sums over the pieces of a drawing; ROM where pointers have 32 bits; errors in pixels, the mean over the border's whole length."""

    parts: int
    vertices: int
    bytes: int
    largest: float
    mean: float


@dataclass(frozen=True)
class Row:
    """A model and its figures; where it cannot be made, what is wrong instead."""

    label: str
    figures: Figures | None
    fault: str = ""
    limit: float | None = None    # only the chosen model has one: the largest error that the author allows, in pixels


def border_length(region):
    return sum(float(np.hypot(*(ring - np.roll(ring, 1, axis=0)).T).sum()) for ring in region.rings)


def figures(pieces):
    lengths = [border_length(piece.region) for piece in pieces]
    mean = np.average([piece.deviation.mean for piece in pieces], weights=lengths)
    parts, vertices, size = (sum(map(count, pieces)) for count in (part_count, vertex_count, rom_bytes))
    return Figures(parts, vertices, size, max(piece.deviation.largest for piece in pieces), float(mean))


def part_count(piece):
    return len(piece.parts)


def allowed(options):
    return pipeline.TOLERANCE if options.tolerance is None else options.tolerance


def by_tolerance(tolerance, model="parts"):
    return f"{model}, {tolerance:.3g} px", {"model": model, "tolerance": tolerance, "vertices": None}


def by_budget(vertices, model="parts"):
    return f"{model}, {vertices} vertices", {"model": model, "tolerance": None, "vertices": vertices}


def chosen_label(drawing, options):
    """The author's own model in words."""
    if options.model == "circle":
        return "circle"
    if options.vertices is not None:
        return by_budget(options.vertices, options.model)[0]
    if options.tolerance is None and drawing.exact:
        return f"{options.model}, all corners"
    return by_tolerance(allowed(options), options.model)[0]


def neighbors(options):
    """Coarser and finer than the chosen tolerance or budget."""
    steps = STEPS if options.table else NEAR_STEPS
    if options.vertices is None or options.model != "parts":
        return [by_tolerance(allowed(options) * 2 ** (step / 2)) for step in steps]
    budgets = {max(3, round(options.vertices * 2 ** (step / 2))) for step in steps}
    return [by_budget(budget) for budget in sorted(budgets)]


def models(drawing, options):
    """Labels, and what they change in the options, from the coarsest model on; the chosen one is among them."""
    hulls = HULLS if options.table else NEAR_HULLS
    listed = dict([("circle", {"model": "circle"}), *[by_budget(count, "hull") for count in hulls], *neighbors(options)])
    listed[chosen_label(drawing, options)] = {}
    return listed


def limit(options, found):
    """With a budget the author takes whatever error comes."""
    return found.largest if options.vertices is not None or options.model == "circle" else max(allowed(options), found.largest)


def rows(drawing, options, journal, pieces=None):
    """A Row for each model. pieces: what the chosen model gave, if that is known already. Its faults are the command's."""
    quiet = Journal(journal.file, io.StringIO())
    chosen = chosen_label(drawing, options)
    result, corners = [], 0
    for label, changes in models(drawing, options).items():
        own = argparse.Namespace(**{**vars(options), **changes})
        if label == chosen:
            baked, fault = pieces or pipeline.bake(drawing, own, quiet), ""
        else:
            baked, fault = attempt(drawing, own, corners, quiet)
        found = figures(baked) if baked else None
        result.append(Row(label, found, fault, limit(options, found) if label == chosen else None))
        if own.model == "parts":
            corners = max(corners, corner_count(baked))
    return result


def attempt(drawing, own, corners, journal):
    """(pieces, what is wrong): one of them is empty. corners: of the next coarser model's outlines."""
    if own.model == "parts" and corners > CORNERS:
        option = f"--tolerance {own.tolerance:.3g}" if own.vertices is None else f"--vertices {own.vertices}"
        return [], f"not tried, it may take long; {option} does"
    try:
        return pipeline.bake(drawing, own, journal), ""
    except ShapeFault as fault:
        return [], str(fault)


def corner_count(pieces):
    return sum(len(ring) for piece in pieces for ring in piece.outline.rings)


def cells(row):
    """A row's columns as text."""
    mark = "" if row.limit is None else ">"
    if row.figures is None:
        return [mark, row.label, "", "", "", "", ""]
    found = row.figures
    return [mark, row.label, str(found.parts), str(found.vertices), str(found.bytes), f"{found.largest:.2f}", f"{found.mean:.2f}"]


HEAD = [["", "model", "parts", "vertices", "ROM,", "largest", "mean"], ["", "", "", "", "bytes", "error, px", "error, px"]]


def text(rows):
    """The table, its columns aligned, the chosen model marked, and a line of advice."""
    lines = [*HEAD, *[cells(row) for row in rows]]
    widths = [max(len(line[column]) for line in lines) for column in range(len(HEAD[0]))]
    drawn = []
    for line in lines:
        left = " ".join(cell.ljust(width) for cell, width in zip(line[:2], widths))
        drawn.append("  ".join([left, *[cell.rjust(width) for cell, width in zip(line[2:], widths[2:])]]).rstrip())
    drawn += [f"  {row.label}: {row.fault}" for row in rows if row.fault]
    return "\n".join([*drawn, advice(rows), ""])


def advice(rows):
    """The cheapest model that is as right as the author asks."""
    chosen = next(row for row in rows if row.limit is not None)
    right = [row for row in rows if row.figures and row.figures.largest <= chosen.limit]
    least = min(right, key=lambda row: (row.figures.bytes, row.figures.largest))
    if least.figures.bytes >= chosen.figures.bytes:
        return f"No other model here is within {chosen.limit:.2f} px for fewer than {chosen.figures.bytes} bytes."
    return (f"Within {chosen.limit:.2f} px for fewer bytes: {least.label}, {least.figures.bytes} bytes instead of {chosen.figures.bytes}"
            f" (largest error {least.figures.largest:.2f} px).")
