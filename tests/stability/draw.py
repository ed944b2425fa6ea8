#!/usr/bin/env python3
# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Draws a family's picture from the lines that picture.c writes: panels of the world and charts side by side, on light and on dark ground.
#   draw.py FILE.picture FOLDER    makes FOLDER/FILE.light.png and FOLDER/FILE.dark.png
import argparse
import sys
from dataclasses import dataclass, field
from io import BytesIO
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "bench"))

from charts import look                     # noqa: E402
from matplotlib import pyplot               # noqa: E402
from matplotlib.lines import Line2D         # noqa: E402
from matplotlib.patches import Circle, Polygon    # noqa: E402
from PIL import Image                       # noqa: E402

COLUMNS = 3
MOST_HEIGHT = 3.4    # inches of a panel
LEAST_HEIGHT = 1.3
DPI = 160

# Role: name in the legend, color (a field of the theme, or a color), dash, width.
ROLES = {
    "rock": ("", "quiet", "-", 1.0), "seam": ("seam", "quiet", (0, (2, 2)), 0.8), "body": ("", "ink", "-", 1.2),
    "tuff": ("tuff, Q16.16", "blue", "-", 2.0), "other": ("tuff, otherwise", look.GREEN, (0, (5, 2)), 1.6),
    "fails": ("the method that fails", look.VERMILION, (0, (3, 1.5)), 1.6), "box2d": ("Box2D 2.4.1", look.ORANGE, (0, (1, 1)), 1.8),
    "truth": ("exact", look.PURPLE, (0, (6, 2, 1, 2)), 1.4),
}


@dataclass
class Panel:
    title: str
    window: list = None              # left, bottom, right, top; None: a chart
    axes: list = None                # x label, x scale, y label, y scale
    marks: list = field(default_factory=list)


def pairs(numbers):
    numbers = [float(number) for number in numbers]
    return list(zip(numbers[::2], numbers[1::2]))


def read(path):
    panels = []
    for line in path.read_text().splitlines():
        word, *fields = line.split("\t")
        if word == "panel":
            panels.append(Panel(fields[0], window=[float(number) for number in fields[1:]]))
        elif word == "chart":
            panels.append(Panel(fields[0], axes=fields[1:]))
        else:
            panels[-1].marks.append((word, fields))
    return panels


class Pen:
    """One panel on its axes; remembers what the legend must name."""

    def __init__(self, axes, theme, legend):
        self.axes, self.theme, self.legend = axes, theme, legend

    def style(self, role):
        _, color, dash, width = ROLES[role]
        return {"color": getattr(self.theme, color, color), "linestyle": dash, "linewidth": width}

    def name(self, role, label=None):
        text = label or ROLES[role][0]
        if text:
            self.legend.setdefault(text, Line2D([], [], **self.style(role)))

    def area(self, role, patch, **shape):
        style = self.style(role)
        face = self.theme.grid if role == "rock" else "none"
        self.axes.add_patch(patch(**shape, facecolor=face, edgecolor=style["color"], linestyle=style["linestyle"],
                                  linewidth=style["linewidth"], zorder=1 if role == "rock" else 3))
        self.name(role)

    def polygon(self, role, *numbers):
        self.area(role, Polygon, xy=pairs(numbers), closed=True)

    def circle(self, role, x, y, radius):
        self.area(role, Circle, xy=(float(x), float(y)), radius=float(radius))

    def line(self, role, label, *numbers):
        points = pairs(numbers)
        self.axes.plot([x for x, _ in points], [y for _, y in points], zorder=2 if role == "seam" else 4, solid_capstyle="round",
                       **self.style(role))
        self.name(role, label)

    def arrow(self, role, x, y, to_x, to_y):
        color = self.style(role)["color"]
        self.axes.annotate("", (float(to_x), float(to_y)), (float(x), float(y)), zorder=5,
                           arrowprops={"arrowstyle": "-|>", "color": color, "linewidth": 1.6, "shrinkA": 0, "shrinkB": 0})
        self.name(role)

    def dot(self, role, x, y):
        self.axes.plot(float(x), float(y), "o", color=self.style(role)["color"], markersize=4, zorder=6)
        self.name(role)

    def note(self, x, y, text):
        self.axes.annotate(text, (float(x), float(y)), fontsize=8.5, zorder=7,
                           bbox={"facecolor": self.theme.ground, "edgecolor": "none", "alpha": 0.7, "pad": 0.8})


def lay_out(axes, panel):
    axes.set_title(panel.title, fontsize=9.5)
    if panel.window:
        left, bottom, right, top = panel.window
        axes.set(xlim=(left, right), ylim=(bottom, top), aspect="equal", xticks=[], yticks=[])
        axes.grid(False)
        for spine in axes.spines.values():
            spine.set_visible(True)
        return
    x_label, x_scale, y_label, y_scale = panel.axes
    axes.set(xlabel=x_label, ylabel=y_label, xscale=x_scale, yscale=y_scale)


def height_of(panels, columns):
    """Inches of a row: its tallest panel's, of panels as wide as the columns are."""
    width = look.WIDTH / columns - 0.05
    shapes = [(panel.window[3] - panel.window[1]) / (panel.window[2] - panel.window[0]) if panel.window else 0.75 for panel in panels]
    return min(MOST_HEIGHT, max(LEAST_HEIGHT, width * max(shapes))) + (0.7 if any(panel.axes for panel in panels) else 0.35)


def figure_of(panels, theme):
    columns = min(COLUMNS, len(panels))
    rows = [panels[i:i + columns] for i in range(0, len(panels), columns)]
    heights = [height_of(row, columns) for row in rows]
    figure, grid = look.figure(theme, len(rows), columns, sum(heights) + 0.4, height_ratios=heights)
    figure.get_layout_engine().set(h_pad=0.09)
    legend = {}
    for axes, panel in zip(grid.flat, panels):
        lay_out(axes, panel)
        pen = Pen(axes, theme, legend)
        for word, fields in panel.marks:
            getattr(pen, word)(*fields)
    for axes in list(grid.flat)[len(panels):]:
        axes.set_visible(False)
    if legend:
        figure.legend(legend.values(), legend.keys(), loc="outside lower center", ncols=5, frameon=False, fontsize=9)
    return figure


def draw(path, folder):
    panels = read(path)
    folder.mkdir(parents=True, exist_ok=True)
    for theme in look.THEMES:
        figure = figure_of(panels, theme)
        pixels = BytesIO()
        figure.savefig(pixels, format="png", dpi=DPI)
        pyplot.close(figure)
        target = folder / f"{path.stem}.{theme.name}.png"
        Image.open(pixels).convert("RGB").quantize(128, dither=Image.Dither.NONE).save(target, optimize=True)


def main():
    command = argparse.ArgumentParser(description="Draw one picture of docs/stability.md; see the head of this file.")
    command.add_argument("picture", type=Path)
    command.add_argument("folder", type=Path)
    options = command.parse_args()
    draw(options.picture, options.folder)


if __name__ == "__main__":
    main()
