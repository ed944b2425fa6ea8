# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The picture under what was made of it, as PNG or SVG: one panel a drawing. Colors: Okabe and Ito, Color Universal Design (2008),
# which the color-blind tell apart; besides, no two kinds of line have the same dashes.
from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import shapely

from .model import Lattice
from .table import figures

BLACK, GRAY, PAPER = "#000000", "#707070", "#ECECEC"
ORANGE, SKY, GREEN, YELLOW = "#E69F00", "#56B4E9", "#009E73", "#F0E442"
BLUE, VERMILLION, PURPLE = "#0072B2", "#D55E00", "#CC79A7"
TINTS = (ORANGE, SKY, GREEN, YELLOW, PURPLE, BLUE, VERMILLION)

# Dashes in line widths.
INTERNAL = (0, (4, 2))
AREA = (0, (8, 2))
BOUNDING = (0, (1, 1.5))
HULL = (0, (6, 2, 1, 2))

DOTS = 100            # dots an inch
SIDE = 6.6            # inches: the longer side of a panel that stands alone; its lines are drawn as wide as is said here
CROWD = 40            # with more corners, dots and arrows shrink
IMAGE_SIDE = 1024     # a larger picture is shrunk: a panel has fewer dots
SETTINGS = {"svg.hashsalt": "tuff", "svg.fonttype": "path", "font.size": 9.0}
METADATA = {".svg": {"Date": None, "Creator": None}, ".png": {"Software": None}}


def draw(path, drawing, pieces, options):
    draw_all(path, [(drawing, pieces)], options)


def draw_all(path, panels, options):
    """panels: (drawing, pieces) of each frame or object."""
    import matplotlib

    kind = Path(path).suffix.lower()
    with matplotlib.rc_context(SETTINGS):
        figure_of(panels, options).savefig(path, format=kind[1:], metadata=METADATA[kind])


def figure_of(panels, options):
    from matplotlib.figure import Figure

    figure = Figure(dpi=DOTS, facecolor="white")
    views = [View(drawing, pieces, options) for drawing, pieces in panels]
    if len(views) == 1:
        lay_out_one(figure, views[0], options)
    else:
        lay_out_many(figure, views, options)
    return figure


# ---- What a panel shows

class View:
    """A drawing and its pieces in pixels, y down."""

    def __init__(self, drawing, pieces, options):
        self.drawing, self.pieces, self.scale = drawing, pieces, options.scale
        self.lattice = Lattice(options.scale, options.per_unit)
        self.exteriors = [self.lattice.pixels(piece.outline.exterior) for piece in pieces]
        self.outlines = [self.lattice.pixels(ring) for piece in pieces for ring in piece.outline.rings]
        self.parts = [(self.lattice.pixels(part.vertices), part.internal) for piece in pieces for part in piece.parts]
        self.origins = [self.lattice.pixels(piece.origin) for piece in pieces]
        self.hulls = [convex_hull(exterior) for exterior in self.exteriors]
        self.worst = max((piece.deviation for piece in pieces), key=lambda deviation: deviation.largest)
        self.low, self.high = self.frame()
        self.width, self.height = self.high - self.low
        self.side = max(self.width, self.height)
        self.crowd = min(1.0, math.sqrt(CROWD / sum(map(len, self.outlines))))

    def frame(self):
        """The corners of what is to be seen: picture, outlines and bounding circles with a margin."""
        corners = [(0.0, 0.0), self.drawing.size]
        for piece, origin, exterior in zip(self.pieces, self.origins, self.exteriors):
            reach = self.pixels(piece.bounding_raw)
            corners = np.vstack([corners, origin - reach, origin + reach, exterior])
        low, high = np.min(corners, axis=0), np.max(corners, axis=0)
        margin = 0.04 * max(high - low)
        return low - margin, high + margin

    def pixels(self, raw):
        return raw / 65536 / self.scale

    def edges(self, internal):
        """(start, end) of the parts' edges, internal or not; an internal edge belongs to two parts and is given once."""
        found = {}
        for corners, bits in self.parts:
            for index, edge in enumerate(zip(map(tuple, corners), map(tuple, np.roll(corners, -1, axis=0)))):
                if bool(bits >> index & 1) == internal:
                    found[frozenset(edge)] = edge
        return list(found.values())


def convex_hull(corners):
    return np.asarray(shapely.MultiPoint(corners).convex_hull.exterior.coords)[:-1]


# ---- Layout, in inches

def lay_out_one(figure, view, options):
    """Title above, legend with the figures at the right."""
    width, height = SIDE * view.width / view.side, SIDE * view.height / view.side
    left, bottom, legend, head = 0.6, 0.5, 2.9, 0.5
    size = (max(left + width + legend, 8.5), bottom + max(height, 3.6) + head)
    figure.set_size_inches(*size)
    axes = figure.add_axes((left / size[0], (size[1] - head - height) / size[1], width / size[0], height / size[1]))
    draw_panel(axes, view, 1.0)
    axes.set_xlabel("pixels of the picture")
    write_title(figure, size, heading(view, options), view.pieces)
    figure.legend(handles=legend_handles(view, values=True), loc="upper left", frameon=False, handlelength=2.8, labelspacing=1.0,
                  bbox_to_anchor=((left + width + 0.1) / size[0], 1 - head / size[1]))


def lay_out_many(figure, views, options):
    """A grid of panels, the legend below them."""
    columns = math.ceil(math.sqrt(1.4 * len(views)))
    rows = math.ceil(len(views) / columns)
    side = min(3.4, max(1.5, 15.0 / columns))
    head, foot, caption = 0.5, 0.9, 0.25
    size = (max(columns * side, 8.0) + 0.2, head + rows * (side + caption) + foot)
    figure.set_size_inches(*size)
    for index, view in enumerate(views):
        row, column = divmod(index, columns)
        bottom = size[1] - head - (row + 1) * (side + caption)
        axes = figure.add_axes(((0.15 + column * side) / size[0], bottom / size[1], (side - 0.1) / size[0], (side - 0.1) / size[1]))
        draw_panel(axes, view, side / SIDE)
        axes.set_axis_off()
        axes.set_title(caption_of(view), fontsize=min(9.0, 2.8 * side), pad=2)
    write_title(figure, size, options.name, [piece for view in views for piece in view.pieces])
    figure.legend(handles=legend_handles(views[0], values=False), loc="lower center", ncols=4, frameon=False, handlelength=2.8)


def write_title(figure, size, name, pieces):
    found = figures(pieces)
    islands = f"{len(pieces)} pieces, " if len(pieces) > 1 else ""
    text = (f"{islands}{counted(found.parts, 'part', 'parts')}, {counted(found.vertices, 'vertex', 'vertices')}, {found.bytes} bytes; "
            f"error at most {found.largest:.2f} px, mean {found.mean:.2f} px")
    figure.text(0.15 / size[0], 1 - 0.32 / size[1], f"{name}:  {text}", fontsize=10.5, weight="bold")


def heading(view, options):
    return f"{options.name}, {view.drawing.place}" if view.drawing.place else options.name


def caption_of(view):
    found = figures(view.pieces)
    return f"{view.drawing.name}:  {counted(found.parts, 'part', 'parts')}, {found.vertices} vertices, {found.largest:.2f} px"


def counted(number, one, more):
    return f"{number} {one if number == 1 else more}"


# ---- The layers of a panel, from back to front. width: of lines, 1 for a panel that stands alone.

def draw_panel(axes, view, width):
    small = width * view.crowd
    axes.set_facecolor(PAPER)
    axes.set_aspect("equal")
    draw_picture(axes, view)
    draw_parts(axes, view, small)
    draw_fits(axes, view, width)
    draw_outlines(axes, view, small)
    draw_normals(axes, view, small)
    draw_origins(axes, view, width)
    draw_worst(axes, view, width)
    axes.set_xlim(view.low[0], view.high[0])
    axes.set_ylim(view.high[1], view.low[1])


def draw_picture(axes, view):
    """The pixels, paled so that lines show on any of them; without pixels, the shape that was given."""
    from matplotlib.collections import PolyCollection
    from matplotlib.patches import Rectangle

    right, bottom = view.drawing.size
    axes.add_patch(Rectangle((0, 0), right, bottom, facecolor="white", edgecolor=GRAY, linewidth=0.5, linestyle=(0, (2, 2)),
                             zorder=-1))
    if view.drawing.image is None:
        axes.add_collection(PolyCollection([piece.region.exterior for piece in view.pieces], facecolor="#C8C8C8"))
        axes.add_collection(PolyCollection([hole for piece in view.pieces for hole in piece.region.holes], facecolor="white"))
        return
    image = view.drawing.image.copy()
    image.thumbnail((IMAGE_SIDE, IMAGE_SIDE))
    axes.imshow(np.asarray(image), extent=(0, right, bottom, 0), interpolation="none", alpha=0.72, aspect="equal")


def draw_parts(axes, view, width):
    from matplotlib.collections import LineCollection, PolyCollection

    tints = [TINTS[index % len(TINTS)] for index in range(len(view.parts))]
    axes.add_collection(PolyCollection([corners for corners, _ in view.parts], facecolors=tints, alpha=0.24))
    axes.add_collection(LineCollection(view.edges(internal=True), colors=BLUE, linewidths=1.6 * width + 0.4, linestyles=[INTERNAL],
                                       path_effects=halo(width)))
    if 1 < len(view.parts) <= 40:
        for number, (corners, _) in enumerate(view.parts):
            x, y = corners.mean(axis=0)
            axes.text(x, y, str(number), ha="center", va="center", fontsize=5 + 4 * width, color=BLACK, path_effects=halo(width))


def draw_fits(axes, view, width):
    """What stands in where there is no outline: circles and convex hull."""
    from matplotlib.collections import PolyCollection
    from matplotlib.patches import Circle

    for piece, origin in zip(view.pieces, view.origins):
        for raw, color, dashes in ((piece.radius_raw, ORANGE, AREA), (piece.bounding_raw, PURPLE, BOUNDING)):
            axes.add_patch(Circle(origin, view.pixels(raw), fill=False, edgecolor=color, linewidth=1.4 * width + 0.4, linestyle=dashes,
                                  path_effects=halo(width)))
    axes.add_collection(PolyCollection(view.hulls, facecolor="none", edgecolor=GREEN, linewidth=1.4 * width + 0.4, linestyle=HULL,
                                       path_effects=halo(width)))


def draw_outlines(axes, view, width):
    from matplotlib.collections import PolyCollection

    borders = [ring for piece in view.pieces for ring in piece.region.rings]
    axes.add_collection(PolyCollection(borders, facecolor="none", edgecolor=GRAY, linewidth=0.8 * width + 0.1))
    axes.add_collection(PolyCollection(view.outlines, facecolor="none", edgecolor=BLACK, linewidth=1.6 * width + 0.3,
                                       path_effects=halo(width)))
    corners = np.vstack(view.outlines)
    axes.plot(corners[:, 0], corners[:, 1], linestyle="none", marker="o", markersize=4.0 * width + 0.6, color=BLACK,
              markeredgecolor="white", markeredgewidth=0.6 * width)


def draw_normals(axes, view, width):
    """Arrows at the middles of the outline's edges. With the solid side as in model.py, (dy, -dx) points outward."""
    edges = np.array(view.edges(internal=False)).reshape(-1, 2, 2)
    middles, ways = edges.mean(axis=1), edges[:, 1] - edges[:, 0]
    normals = np.column_stack([ways[:, 1], -ways[:, 0]]) / np.hypot(*ways.T)[:, None] * 0.035 * view.side * view.crowd
    axes.quiver(*middles.T, *normals.T, angles="xy", scale_units="xy", scale=1, units="inches", width=0.018 * width + 0.004, headwidth=4.5,
                headlength=5, headaxislength=4.5, color=VERMILLION, zorder=3)


def draw_origins(axes, view, width):
    from matplotlib import patheffects

    effects = [patheffects.withStroke(linewidth=5 * width, foreground="white")]
    for x, y in view.origins:
        axes.plot([x], [y], marker="+", markersize=14 * width, markeredgewidth=2.2 * width, color=BLACK, path_effects=effects)


def draw_worst(axes, view, width):
    """A ring about the spot, its label pulled toward the picture's middle."""
    spot = np.array(view.worst.spot)
    pull = np.where(spot < (view.low + view.high) / 2, 1, -1) * 38 * width
    axes.plot(*spot, marker="o", markersize=15 * width + 2, fillstyle="none", color=VERMILLION, markeredgewidth=2.2 * width, zorder=4)
    axes.annotate(f"{view.worst.largest:.2f} px", spot, xytext=(pull[0], -pull[1]), textcoords="offset points", fontsize=4.5 + 5 * width,
                  color=BLACK, weight="bold", ha="center", va="center", zorder=5,
                  bbox={"boxstyle": "round,pad=0.25", "facecolor": "white", "edgecolor": VERMILLION, "linewidth": 1.2 * width},
                  arrowprops={"arrowstyle": "-", "color": VERMILLION, "linewidth": 1.5 * width, "shrinkB": 7 * width})


def halo(width):
    """White about lines and letters, for dark pictures."""
    from matplotlib import patheffects

    return [patheffects.withStroke(linewidth=3.4 * width + 0.6, foreground="white", alpha=0.75)]


# ---- Legend

def legend_handles(view, values):
    """One entry a layer; with values, the numbers of a view with one piece stand in it."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    lone = view.pieces[0] if values and len(view.pieces) == 1 else None
    number = (lambda template, *numbers: template.format(*numbers)) if lone else (lambda template, *numbers: "")
    area, bounding = (lone.radius_raw / 65536, lone.bounding_raw / 65536) if lone else (0, 0)
    return [
        Line2D([], [], color=GRAY, linewidth=0.9, label="border of the picture's solid pixels"),
        Line2D([], [], color=BLACK, marker="o", markersize=4, linewidth=1.8, label="outline"),
        Patch(facecolor=TINTS[0], alpha=0.5, label="convex parts, numbered"),
        Line2D([], [], color=BLUE, linewidth=1.8, linestyle=INTERNAL, label="internal edges"),
        Line2D([], [], color=VERMILLION, linestyle="none", marker=r"$\rightarrow$", markersize=13, label="outward normals"),
        Line2D([], [], color=ORANGE, linewidth=1.8, linestyle=AREA,
               label="circle of the same area" + number("\nradius {:.2f} units", area)),
        Line2D([], [], color=PURPLE, linewidth=1.8, linestyle=BOUNDING,
               label="bounding circle" + number("\nradius {:.2f} units", bounding)),
        Line2D([], [], color=GREEN, linewidth=1.8, linestyle=HULL, label="convex hull" + number("\n{} vertices", len(view.hulls[0]))),
        Line2D([], [], color=BLACK, linestyle="none", marker="+", markersize=11, markeredgewidth=2, label="origin" + number(
            "\nat pixel ({:.2f}, {:.2f})", *view.origins[0])),
        Line2D([], [], color=VERMILLION, linestyle="none", marker="o", markersize=10, markeredgewidth=2, fillstyle="none",
               label="largest error"),
    ]
