# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# What a model costs and buys: for round, cornered and concave rocks, each model's largest error and its wrong answers against its cost.
from statistics import mean, median

from . import look, tables

COLUMNS = ("outline", "model", "error_max", "build", "query", "instructions", "wrong_share", "setting")
GROUPS = {"round": "Round rocks", "cornered": "Rocks with corners", "concave": "Rocks with craters and arms"}
BUILD = "q16"
ENOUGH = 2.0     # pixels: the advice is the cheapest model whose error is no more, in the median of a group
BELOW = f"""\
Rocks 60 to 80 pixels across as the circle of equal area, as hulls of 4 to 16 vertices, and as convex parts within 2, 1 and 0.5 px.
Points are medians, bars reach over all rocks of a group. Ringed: the cheapest model within {ENOUGH:g} px of the picture. Finer than 1 px
the outline follows the pixels' own stairs: it costs a multiple and hardly answers better."""
PICTURES = {"error_max": "largest error of the border, pixels", "wrong_share": "wrong answers near the border, %"}


def outlines_of(rows):
    """{(group, model, setting): {outline: its rows, one for each query}}"""
    found = {}
    for row in rows:
        key = row["outline"].split()[0], row["model"], row["setting"]
        found.setdefault(key, {}).setdefault(row["outline"], []).append(row)
    return found


def figures(outlines, column):
    """(cost, least, median, largest): the cost over the queries, then over the outlines."""
    factor = 100 if column == "wrong_share" else 1
    values = [factor * mean(row[column] for row in rows) for rows in outlines.values()]
    costs = [mean(row["instructions"] for row in rows) for rows in outlines.values()]
    return median(costs), min(values), median(values), max(values)


def models_of(found, group, column):
    """{(model, setting): figures}, in the order of the table."""
    return {key[1:]: figures(outlines, column) for key, outlines in found.items() if key[0] == group}


def advised(models):
    """The cheapest model that is true enough; models: by error."""
    return min((key for key in models if models[key][2] <= ENOUGH), key=lambda key: models[key][0], default=None)


def words(key):
    model, setting = key
    return {"circle": "circle", "hull": f"hull {setting or 0:g}", "parts": f"parts {setting or 0:g} px"}[model]


def short_words(key, models):
    """Only the first of its kind says what it is."""
    first = next(other for other in models if other[0] == key[0])
    return words(key) if key == first else words(key).split(" ", 1)[1]


def tint(model, theme):
    return {"circle": look.GREEN, "hull": theme.blue, "parts": look.VERMILION}[model]


def draw_model_lines(axes, models, theme):
    """A line through the hulls and one through the parts, with a bar over all outlines at each."""
    for kind in ("circle", "hull", "parts"):
        chosen = [found for key, found in models.items() if key[0] == kind]
        x, low, y, high = zip(*chosen)
        color = tint(kind, theme)
        axes.vlines(x, low, high, color=color, alpha=0.3, linewidth=5, zorder=1)
        axes.plot(x, y, marker="o", markersize=5, linewidth=1.4, color=color, zorder=2)


def scales(axes, column):
    axes.set_xscale("log")
    axes.set_yscale("log")
    look.plain(axes.xaxis)
    look.plain(axes.yaxis)
    if column == "error_max":
        axes.axhline(ENOUGH, color=look.quiet(), linewidth=1, linestyle=(0, (4, 3)), zorder=0)


def widen(axes):
    """Room for the labels beside the outermost marks; the panels share their axes."""
    left, right = axes.get_xlim()
    axes.set_xlim(left / 1.3, right * 1.6)


def draw_panel(axes, found, group, column, theme):
    models = models_of(found, group, column)
    scales(axes, column)
    draw_model_lines(axes, models, theme)
    return models


def label_panel(axes, models, choice, theme):
    marks = [(cost, value) for cost, _, value, _ in models.values()]
    if choice:
        cost, _, value, _ = models[choice]
        axes.plot(cost, value, "o", markersize=13, markerfacecolor="none", markeredgecolor=theme.ink, markeredgewidth=1.6, zorder=3)
    labels = look.Labels(axes, marks)
    ends = [max(key for key in models if key[0] == "hull"), min(key for key in models if key[0] == "hull")]
    for key in sorted(models, key=lambda key: (key != choice, key not in ends)):
        cost, _, value, _ = models[key]
        labels.put(short_words(key, models), (cost, value), near=key[0] == "hull" and key not in ends, fontsize=8.5,
                   color=tint(key[0], theme), fontweight="bold" if key == choice else "normal")


def measured(folder):
    return outlines_of(tables.having(tables.read(folder, "models", COLUMNS), build=BUILD))


def summary(folder):
    """Lines of the medians that the chart shows."""
    found = measured(folder)
    for group in GROUPS:
        errors, wrong = (models_of(found, group, column) for column in PICTURES)
        for key, (cost, _, error, _) in errors.items():
            yield f"{group:<9} {words(key):<13} {cost:5.0f} instructions {error:6.2f} px {wrong[key][2]:5.1f} % wrong"


def draw(folder, theme):
    """A figure."""
    found = measured(folder)
    figure, grid = look.figure(theme, len(PICTURES), len(GROUPS), 6.6, sharex=True, sharey="row")
    advice = {group: advised(models_of(found, group, "error_max")) for group in GROUPS}
    panels = [(axes, draw_panel(axes, found, group, column, theme), advice[group])
              for column, row in zip(PICTURES, grid) for group, axes in zip(GROUPS, row)]
    for axes, group in zip(grid[0], GROUPS):
        axes.set_title(GROUPS[group])
    for row, caption in zip(grid, PICTURES.values()):
        row[0].set_ylabel(caption)
    grid[-1][1].set_xlabel("instructions per test (Q16.16; mean of circle, hull and beam)")
    widen(grid[0][0])
    look.headline(figure, "Model no more than a scene needs", BELOW)
    for panel in panels:
        label_panel(*panel, theme)
    return figure
