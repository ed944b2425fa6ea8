# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Cycles against accuracy on the Game Boy Advance: each method and build in both placements of its code, against the error that the host's
# bench has found for it.
from statistics import mean

from . import accuracy, look, tables

COLUMNS = ("machine", "build", "method", "case", "vertices", "class", "mean", "unit")
PLACES = {"gba-iwram-arm": "full", "gba-rom-thumb": "none"}     # how their marks are filled
FAST, SLOW = PLACES
VERTICES = 8
STEPS = 12       # of a line between two marks, which labels keep off
BELOW = """\
Polygons of 8 vertices; all classes of pairs weigh the same. Circles: float in software; squares: Q16.16. Filled: ARM code in IWRAM;
hollow: Thumb code in ROM. Cycles as the emulator mGBA counts them; a frame has 280,896. Errors: those of the same code on the
host. Box2D is 2.4.1; its ray casts leave out a segment that starts inside. textbook: all corners on all normals."""


def cost(cycles, machine, row):
    """The mean of the classes."""
    counts = tables.having(cycles, machine=machine, method=row["method"], build=row["build"], case=row["kind"], vertices=VERTICES)
    return mean(found["mean"] for found in counts)


def counted(cycles, row):
    return any(found["method"] == row["method"] and found["build"] == row["build"] for found in cycles)


def draw_method(axes, row, points, theme):
    tint = accuracy.color(row["method"], theme)
    axes.plot(*zip(*points.values()), color=tint, linewidth=1, zorder=2)
    for machine, point in points.items():
        face = tint if PLACES[machine] == "full" else theme.ground
        axes.plot(*point, accuracy.MARKS[row["build"]], color=tint, markerfacecolor=face, markersize=8, markeredgewidth=1.4,
                  zorder=4 if row["method"] == "tuff" else 3)


def between(start, end):
    """Points from one to the other, which lie on a level; the cost is logarithmic."""
    return [(start[0] ** (1 - i / STEPS) * end[0] ** (i / STEPS), start[1]) for i in range(STEPS + 1)]


def scale(axes, kind, points):
    accuracy.scale_cost(axes, [x for x, _ in points])
    axes.set_xlim(right=4 * max(x for x, _ in points))
    accuracy.scale_error(axes, kind, [y for _, y in points])
    look.plain(axes.xaxis, subs=(1, 3))
    axes.xaxis.set_major_formatter(lambda cycles, _: look.plain_number(cycles / 1000))
    axes.set_xlabel("thousand cycles per test")
    axes.set_ylabel("wrong answers in the set" if kind == "segment" else "largest error of the depth, units")
    if kind != "segment":
        axes.set_ylim(bottom=min(y for _, y in points) / 10)


def draw_panel(axes, rows, kind, cycles, theme):
    """[(row, where its label goes)] and what labels keep off."""
    rows = [row for row in tables.having(rows, kind=kind) if counted(cycles, row)]
    places = [{machine: (cost(cycles, machine, row), accuracy.error(row)) for machine in PLACES} for row in rows]
    scale(axes, kind, [point for place in places for point in place.values()])
    for row, place in zip(rows, places):
        draw_method(axes, row, place, theme)
    lines = [between(*place.values()) for place in places]
    return [(row, line[STEPS // 2]) for row, line in zip(rows, lines)], [point for line in lines for point in line]


def label_panel(axes, named, points):
    labels = look.Labels(axes, points)
    for row, point in sorted(named, key=lambda pair: (pair[0]["method"] != "tuff", pair[1])):
        labels.put(accuracy.name(row), point, fontsize=8.5, fontweight="bold" if row["method"] == "tuff" else "normal")


def draw(folder, theme):
    """A figure."""
    cycles = tables.read(folder.parent, "cycles", COLUMNS)
    rows = tables.having(tables.read(folder, "pairs", accuracy.COLUMNS), vertices=VERTICES, **{"class": "all"})
    figure, grid = look.figure(theme, 1, len(accuracy.KINDS), 4.6)
    look.headline(figure, "On a Game Boy Advance: cheap is left, exact is low", BELOW)
    panels = [(axes, *draw_panel(axes, rows, kind, cycles, theme)) for kind, axes in zip(accuracy.KINDS, grid[0])]
    for axes, title in zip(grid[0], accuracy.KINDS.values()):
        axes.set_title(title)
    for panel in panels:
        label_panel(*panel)
    return figure
