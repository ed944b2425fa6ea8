# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# What all charts share: colors on light and dark ground, fonts, axes, labels that keep out of each other's way, files without dates.
from dataclasses import dataclass
from io import BytesIO
from itertools import product

import matplotlib
from matplotlib import pyplot
from matplotlib.text import Text
from matplotlib.transforms import Bbox
from PIL import Image

matplotlib.use("agg")

WIDTH = 9.0      # inches: 900 px in the README, twice that in the file
DPI = 200
COLORS = 128     # of a PNG: a third of the bytes, and no eye sees it
HEADLINE = 0.38  # inches above the line below it
LINE = 0.19      # inches of each of those lines

# Okabe and Ito's palette, which color-blind eyes tell apart: "Color Universal Design", 2008.
BLUE, VERMILION, GREEN, ORANGE, SKY, PURPLE = "#0072B2", "#D55E00", "#009E73", "#E69F00", "#56B4E9", "#CC79A7"


@dataclass(frozen=True)
class Theme:
    name: str
    ground: str
    ink: str
    quiet: str       # axes and secondary text
    grid: str
    blue: str        # the palette's blue is too dark for a dark ground, where its sky blue stands in


LIGHT = Theme("light", "#ffffff", "#1f2328", "#59636e", "#e4e8ec", BLUE)
DARK = Theme("dark", "#0d1117", "#f0f6fc", "#9198a1", "#262c34", SKY)
THEMES = (LIGHT, DARK)


def use(theme):
    matplotlib.rcdefaults()
    matplotlib.rcParams.update({
        "figure.facecolor": theme.ground, "axes.facecolor": theme.ground, "savefig.facecolor": theme.ground,
        "text.color": theme.ink, "axes.labelcolor": theme.ink, "axes.edgecolor": theme.quiet, "axes.titlecolor": theme.ink,
        "xtick.color": theme.quiet, "ytick.color": theme.quiet, "xtick.labelcolor": theme.ink, "ytick.labelcolor": theme.ink,
        "grid.color": theme.grid, "grid.linewidth": 0.8, "axes.grid": True, "axes.axisbelow": True,
        "axes.spines.top": False, "axes.spines.right": False, "font.family": "DejaVu Sans", "font.size": 9.5,
        "axes.titlesize": 11, "axes.titleweight": "bold", "axes.titlelocation": "left", "axes.titlepad": 8,
        "lines.linewidth": 1.8, "svg.hashsalt": "tuff", "figure.dpi": 100,
    })


def figure(theme, rows, columns, height, **options):
    use(theme)
    return pyplot.subplots(rows, columns, figsize=(WIDTH, height), layout="constrained", squeeze=False, **options)


def headline(figure, text, below):
    """What the chart says, and what is drawn; the panels keep out of both."""
    height = figure.get_figheight()
    room = HEADLINE + LINE * len(below.splitlines())
    figure.get_layout_engine().set(rect=(0, 0, 1, 1 - room / height))
    figure.text(0.008, 1 - 0.08 / height, text, va="top", fontsize=13, fontweight="bold")
    figure.text(0.008, 1 - HEADLINE / height, below, va="top", fontsize=9.5, linespacing=1.3, color=quiet())


def quiet():
    """The color of secondary text in the theme now used."""
    return matplotlib.rcParams["xtick.color"]


def plain_number(number, _=None):
    """Tick labels of logarithmic axes, as people write them."""
    if number >= 1000:
        return f"{number:,.0f}"
    return f"{number:g}"


def plain(axis, subs=(1, 2, 5)):
    """A logarithmic axis with ticks at these multiples of the powers of ten."""
    axis.set_major_locator(matplotlib.ticker.LogLocator(10, subs))
    axis.set_major_formatter(plain_number)
    axis.set_minor_locator(matplotlib.ticker.NullLocator())


def save(figure, folder, name, theme):
    """Twice the same data, twice the same bytes."""
    folder.mkdir(parents=True, exist_ok=True)
    figure.savefig(folder / f"{name}.{theme.name}.svg", metadata={"Date": None, "Creator": None})
    pixels = BytesIO()
    figure.savefig(pixels, format="png", dpi=DPI)
    Image.open(pixels).convert("RGB").quantize(COLORS, dither=Image.Dither.NONE).save(folder / f"{name}.{theme.name}.png", optimize=True)
    pyplot.close(figure)


# ---- Labels at points

# Where a label may go, best first: direction, and which side of the label is at the point.
SIDES = [((1, 0), "left", "center"), ((0, 1), "center", "bottom"), ((0, -1), "center", "top"), ((-1, 0), "right", "center"),
         ((0.8, 0.8), "left", "bottom"), ((0.8, -0.8), "left", "top"), ((-0.8, 0.8), "right", "bottom"), ((-0.8, -0.8), "right", "top"),
         ((-0.4, 1), "center", "bottom"), ((-0.4, -1), "center", "top"), ((0.4, 1), "center", "bottom"), ((0.4, -1), "center", "top")]
FACING = 4       # the first sides, on which nobody takes a label for another mark's
AWAY = (8, 14, 20, 27, 34, 42, 50, 60, 70)    # points from the mark; beyond the first a thin line leads there
POINT = 5        # points around a mark that labels keep free


class Labels:
    """Labels of one panel, each at the first spot where it meets no mark, no other label and no edge."""

    def __init__(self, axes, marks):
        axes.figure.draw_without_rendering()
        self.axes = axes
        reach = POINT * axes.figure.dpi / 72
        centers = axes.transData.transform(marks)
        self.taken = [Bbox.from_extents(x - reach, y - reach, x + reach, y + reach) for x, y in centers]

    def put(self, text, point, near=False, **style):
        """near: rather no label than one that is away from its mark."""
        for away, (direction, ha, va) in product(AWAY[:1], SIDES[:FACING]) if near else product(AWAY, SIDES):
            leader = {"arrowstyle": "-", "color": quiet(), "linewidth": 0.7, "shrinkA": 0, "shrinkB": 4} if away > AWAY[0] else None
            offset = [away * part for part in direction]
            label = self.axes.annotate(text, point, offset, textcoords="offset points", ha=ha, va=va, arrowprops=leader, in_layout=False,
                                       **style)
            label.update_positions(self.axes.figure.canvas.get_renderer())
            box = Text.get_window_extent(label)     # without its line
            if self.is_free(box):
                break
            label.remove()
        else:
            if near:
                return
            raise ValueError(f"no room for the label {text!r}: enlarge the panel")
        self.taken.append(box)
        label.set_bbox({"facecolor": matplotlib.rcParams["axes.facecolor"], "edgecolor": "none", "alpha": 0.75, "pad": 0.6})

    def is_free(self, box):
        edge = self.axes.get_window_extent().padded(1)
        inside = edge.x0 <= box.x0 and box.x1 <= edge.x1 and edge.y0 <= box.y0 and box.y1 <= edge.y1
        return inside and not any(box.overlaps(other) for other in self.taken)
