# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# What an entity and a beam cost as the world grows, as it fills and as beams get longer, and the memory of the index.
from . import look, tables

COLUMNS = ("what", "pieces", "density", "length", "build", "ns", "bytes")
BUILDS = {"float": ("float", "-"), "q16": ("Q16.16", (0, (4, 1.5)))}
WHATS = {"entity": "hull", "circle": "circle", "scattered": "scattered"}
BELOW = """\
tuff_terrain_collide with a hull and with a circle on one screen's ground; scattered: hulls all over the world, where each call
finds its pieces outside the cache. tuff_segment_terrain_intersect. Median times on one machine; solid: float, dashed: Q16.16."""


def color(what, theme):
    return {"entity": look.VERMILION, "circle": theme.blue, "scattered": look.GREEN}[what]


def lines(rows, x):
    """{(what, build): [(x, ns), ...]} in the order of x."""
    found = {}
    for row in sorted(rows, key=lambda row: row[x]):
        found.setdefault((row["what"], row["build"]), []).append((row[x], row["ns"]))
    return found


def end_label(axes, points, text, tint, shift=0.0):
    axes.annotate(text, points[-1], (7, shift), textcoords="offset points", va="center", color=tint, fontsize=9, annotation_clip=False,
                  linespacing=1.0)


def apart(heights, least):
    """Shifts in points that keep labels at these heights, in points, at least so far from each other."""
    placed, shifts = None, {}
    for key, height in sorted(heights.items(), key=lambda item: item[1]):
        placed = height if placed is None else max(height, placed + least)
        shifts[key] = placed - height
    return shifts


def draw_lines(axes, found, names, tints):
    """Lines of ns, and a label at the end of each."""
    for (what, build), points in found.items():
        axes.plot(*zip(*points), linestyle=BUILDS[build][1], marker="o", markersize=3.5, color=tints[what], clip_on=False)
    axes.set_ylim(0, 1.15 * max(ns for points in found.values() for _, ns in points))
    axes.figure.draw_without_rendering()
    heights = {key: axes.transData.transform(points[-1])[1] * 72 / axes.figure.dpi for key, points in found.items()}
    shifts = apart(heights, 12)
    for (what, build), points in found.items():
        text = " ".join(filter(None, [names[what], BUILDS[build][0]]))
        end_label(axes, points, text, tints[what], shifts[what, build])


def logarithmic(axes, ticks, label, title):
    axes.set_xscale("log")
    axes.set_xticks(ticks, [look.plain_number(tick) for tick in ticks], fontsize=8.5)
    axes.xaxis.set_minor_locator(look.matplotlib.ticker.NullLocator())
    axes.set_xlabel(label)
    axes.set_title(title)


def ticks_of(rows, column):
    return sorted({row[column] for row in rows})


def draw_pieces(axes, rows, theme):
    rows = [row for row in tables.having(rows, density=1) if row["what"] in WHATS]
    logarithmic(axes, ticks_of(rows, "pieces"), "pieces in the world", "Entity, by the world's size")
    draw_lines(axes, lines(rows, "pieces"), WHATS, {what: color(what, theme) for what in WHATS})
    axes.set_ylabel("ns per call")


def draw_density(axes, rows, theme):
    entities = [row for row in rows if row["what"] in ("entity", "circle")]
    size = next(row["pieces"] for row in entities if row["density"] != 1)
    rows = tables.having(entities, pieces=size)
    label = f"density, of {size:,.0f} pieces; 1: the reference scene"
    logarithmic(axes, ticks_of(rows, "density"), label, "Entity, by the world's density")
    draw_lines(axes, lines(rows, "density"), WHATS, {what: color(what, theme) for what in WHATS})
    axes.set_ylabel("ns per call")


def draw_beams(axes, rows, theme):
    rows = tables.having(rows, what="beam", density=1)
    label = f"length of the beam, units; {rows[0]['pieces']:,.0f} pieces"
    logarithmic(axes, ticks_of(rows, "length"), label, "Beam, by its length; it ends at the first hit")
    draw_lines(axes, lines(rows, "length"), {"beam": ""}, {"beam": look.PURPLE})
    axes.set_ylabel("ns per call")


def draw_memory(axes, rows, theme):
    sizes = {row["pieces"]: row["bytes"] for row in tables.having(rows, what="index", density=1)}
    points = sorted(sizes.items())
    logarithmic(axes, [pieces for pieces, _ in points], "pieces in the world", "RAM of the index")
    axes.set_yscale("log")
    axes.plot(*zip(*points), marker="o", markersize=3.5, color=theme.ink)
    axes.yaxis.set_major_formatter(lambda size, _: f"{size / 1024:g} KB")
    axes.set_yticks([1024, 8 * 1024, 64 * 1024, 512 * 1024])
    axes.minorticks_off()
    pieces, size = points[-1]
    axes.annotate(f"{size / pieces:.1f} bytes a piece", points[-1], (0, -60), textcoords="offset points", ha="right", va="center")


def draw(folder, theme):
    """A figure."""
    rows = tables.read(folder, "scale", COLUMNS)
    figure, grid = look.figure(theme, 2, 2, 6.4)
    look.headline(figure, "Cost follows what is near, not the size of the world", BELOW)
    draw_pieces(grid[0][0], rows, theme)
    draw_density(grid[0][1], rows, theme)
    draw_beams(grid[1][0], rows, theme)
    draw_memory(grid[1][1], rows, theme)
    return figure
