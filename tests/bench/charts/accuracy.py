# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Speed against accuracy: for each kind of test, one point per method and build, and the front of those that no other beats in both.
from math import log10

from . import look, tables

COLUMNS = ("kind", "vertices", "class", "method", "build", "ns", "instructions", "wrong", "depth_max")
KINDS = {"circle": "Circle against polygon", "hull": "5-gon hull against polygon", "segment": "Segment against polygon"}
MIX = "3-8"
COSTS = {"ns": "ns per test", "instructions": "instructions per test"}
FLOOR = 1e-8     # units; what errs less is drawn here

NAMES = {"tuff": "tuff", "textbook": "textbook", "box2d": "Box2D", "chipmunk": "Chipmunk2D"}
BUILDS = {"float": "float", "q16": "Q16.16"}
BELOW = """\
Polygons of 3 to 8 vertices; a third of the pairs overlap, a third are near, a third far. Circles: float; squares: Q16.16; diamonds: double.
Dashed: the Pareto front; nothing is both cheaper and more exact than what lies on it. (n wrong): n yes or no answers were wrong.
Median times on one machine; instructions by callgrind. Box2D is 2.4.1, Chipmunk2D 7.0.3; textbook: all corners on all normals."""
OWN_NUMBERS = ("box2d", "chipmunk")      # come in one build
MARKS = {"float": "o", "q16": "s", "double": "D"}


def color(method, theme):
    return {"tuff": look.VERMILION, "textbook": look.ORANGE, "box2d": theme.blue, "chipmunk": look.GREEN}[method]


def name(row):
    method = NAMES[row["method"]]
    return method if row["method"] in OWN_NUMBERS else f"{method} {BUILDS[row['build']]}"


def error(row):
    return row["wrong"] if row["kind"] == "segment" else max(row["depth_max"], FLOOR)


def label(row):
    """With what the axis does not show."""
    if row["kind"] == "segment":
        return name(row)
    small = f"({row['depth_max']:.0e} units)" if row["depth_max"] < FLOOR else ""
    wrong = f"({row['wrong']:.0f} wrong)" if row["wrong"] else ""
    return "\n".join(filter(None, [name(row), small, wrong]))


def front(points):
    """The points that no other is left of and below, from left to right."""
    kept = []
    for x, y in sorted(points):
        if not kept or y < kept[-1][1]:
            kept.append((x, y))
    return kept


def draw_front(axes, points):
    """As stairs, to the edges of the panel."""
    found = front(points)
    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    x, y = zip((found[0][0], top), *found, (right, found[-1][1]))
    axes.step(x, y, where="post", color=look.quiet(), linewidth=1.2, linestyle=(0, (4, 3)), zorder=1)
    axes.set_xlim(left, right)
    axes.set_ylim(bottom, top)


def scale_cost(axes, costs):
    """With room for the labels on both sides."""
    axes.set_xscale("log")
    axes.set_xlim(min(costs) / 2, max(costs) * 2)
    look.plain(axes.xaxis)


def power_or_less(value, _):
    return "less" if value < 1.01 * FLOOR else f"$10^{{{round(log10(value))}}}$"


def scale_error(axes, kind, errors):
    """An answer is right or wrong; of a depth, everything below the floor is one line."""
    if kind == "segment":
        axes.set_yscale("symlog", linthresh=1)
        axes.set_ylim(-1, max(10, *errors) * 4)
        axes.set_yticks([0, *(10 ** i for i in range(int(log10(max(10, *errors))) + 1))])
        axes.yaxis.set_major_formatter(look.plain_number)
        axes.tick_params(axis="y", which="minor", left=False)
        return
    axes.set_yscale("log")
    axes.set_ylim(FLOOR / 6, max(errors) * 20)
    look.plain(axes.yaxis, subs=(1,))
    axes.yaxis.set_major_formatter(power_or_less)


def draw_panel(axes, rows, kind, cost, theme):
    axes.set_xlabel(COSTS[cost])
    rows = tables.having(rows, kind=kind)
    points = [(row[cost], error(row)) for row in rows]
    scale_cost(axes, [row[cost] for row in rows])
    scale_error(axes, kind, [error(row) for row in rows])
    draw_front(axes, points)
    for row, point in zip(rows, points):
        axes.plot(*point, MARKS[row["build"]], color=color(row["method"], theme), markersize=8, markeredgecolor=theme.ground,
                  zorder=4 if row["method"] == "tuff" else 3)
    axes.set_ylabel("wrong answers in the set" if kind == "segment" else "largest error of the depth, units")
    return rows, points


def label_panel(axes, rows, points):
    labels = look.Labels(axes, points)
    for row, point in sorted(zip(rows, points), key=lambda pair: (pair[0]["method"] != "tuff", pair[1])):
        labels.put(label(row), point, fontsize=8.5, fontweight="bold" if row["method"] == "tuff" else "normal", linespacing=1.1)


def draw(folder, theme):
    """A figure."""
    rows = tables.having(tables.read(folder, "pairs", COLUMNS), vertices=MIX, **{"class": "all"})
    figure, grid = look.figure(theme, len(COSTS), len(KINDS), 7.6)
    look.headline(figure, "Speed against accuracy: cheap is left, exact is low", BELOW)
    panels = [(axes, *draw_panel(axes, rows, kind, cost, theme)) for cost, line in zip(COSTS, grid) for kind, axes in zip(KINDS, line)]
    for axes, title in zip(grid[0], KINDS.values()):
        axes.set_title(title)
    for panel in panels:
        label_panel(*panel)
    return figure
