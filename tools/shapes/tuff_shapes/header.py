# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The header that a game includes: C99 that is C++11 too, one file for both builds. What it declares stands in its first comment
# (manual.py). Here y is turned up if the author wants it so.
from dataclasses import dataclass

from . import manual, names, normals, pipeline
from .faults import ShapeFault
from .piece import FLOAT_BITS, PIECE_BYTES, RAW_PER_UNIT, array_bytes, relative, vertex_count

MAX_POSITION = 32768     # units, as TUFF_MAX_POSITION; Q16.16 ends just before
MAX_PIECES = 65534       # as TUFF_MAX_PIECES
MAX_BUCKETS = 32768
MAX_PITCH_LOG2 = 14

# What is declared for a piece, for several pieces together, and once a file: endings of its name.
OF_PIECE = ("", "_at", "_vertices", "_normals", "_parts", "_part_count", "_vertex_count", "_radius", "_bounding_radius",
            "_origin_x", "_origin_y", "_width", "_height")
OF_GROUP = ("", "_at", "_count", "_origin_x", "_origin_y", "_width", "_height")
OF_FILE = ("_shapes_h", "_pitch_log2")
OF_SHEET = ("", "_count", "_first", "_origins", "_frame_count", "_frame_pieces", "_width", "_height")
OF_MAP = ("", "_count", "_bucket_count")


# ---- Numbers

@dataclass(frozen=True)
class Grid:
    """Lattice steps as C writes them."""

    per_unit: int
    y_up: bool

    def length(self, steps):
        """Exact in both builds, or refused."""
        odd = abs(steps) // (steps & -steps) if steps else 0
        if odd >> FLOAT_BITS or not -MAX_POSITION < steps / self.per_unit < MAX_POSITION:
            raise ShapeFault(f"{steps / self.per_unit:.3f} units are beyond {MAX_POSITION}, or too many steps of 1/{self.per_unit} for a "
                             "float: a smaller --scale or --per-unit")
        return f"TUFF_RATIO({steps}, {self.per_unit})"

    def turned(self, point):
        """A vector in the game's directions."""
        return (point[0], -point[1]) if self.y_up else point

    def vector(self, point):
        x, y = self.turned(point)
        return f"{{ {self.length(x)}, {self.length(y)} }}"


def radius(raw):
    return f"TUFF_REAL_RAW({raw})"


def define(name, value):
    return f"#define {name.upper()} {value}"


def array(declaration, initializers, columns=1):
    rows = [", ".join(initializers[i:i + columns]) for i in range(0, len(initializers), columns)]
    return "\n".join([f"static const {declaration} = {{", ",\n".join(f"    {row}" for row in rows), "};"])


def pitch_log2(pieces):
    """The power of two that is no less than the bounding diameter of nine in ten pieces: few are in more than four chunks' reach."""
    sizes = sorted(piece.bounding_raw for piece in pieces)
    diameter = 2 * sizes[(len(sizes) - 1) * 9 // 10]
    return min(MAX_PITCH_LOG2, (-(-diameter // RAW_PER_UNIT) - 1).bit_length())


# ---- Pieces

def outward(part):
    """A vector along each edge's outward normal: the rings of parts have positive areas."""
    ends = part.vertices[1:] + part.vertices[:1]
    return [(y1 - y0, x0 - x1) for (x0, y0), (x1, y1) in zip(part.vertices, ends)]


def shape_arrays(name, piece, grid):
    """Vertices, normals and parts of a piece; nothing for a circle."""
    if not piece.parts:
        return []
    vertices = [grid.vector(point) for part in piece.parts for point in relative(part.vertices, piece.origin)]
    unit_vectors = [normals.text(*grid.turned(vector)) for part in piece.parts for vector in outward(part)]
    parts, first = [], 0
    for part in piece.parts:
        parts.append(f"{{ {name}_vertices + {first}, {name}_normals + {first}, {part.internal:#x}u, {len(part.vertices)} }}")
        first += len(part.vertices)
    count = name.upper()
    return [array(f"tuff_vec2 {name}_vertices[{count}_VERTEX_COUNT]", vertices, 2),
            array(f"tuff_unit2 {name}_normals[{count}_VERTEX_COUNT]", unit_vectors),
            array(f"tuff_polygon {name}_parts[{count}_PART_COUNT]", parts)]


def origin_macros(name, origin, grid):
    """From the picture's upper left corner to the right and down, whichever way y grows."""
    return [define(f"{name}_origin_x", grid.length(origin[0])), define(f"{name}_origin_y", grid.length(origin[1]))]


def size_macros(name, drawing, options, grid):
    width, height = (int(steps) for steps in pipeline.lattice_of(options).nearest(drawing.size))
    return [define(f"{name}_width", grid.length(width)), define(f"{name}_height", grid.length(height))]


def piece_macros(name, piece, data, grid):
    """data: the name of the piece whose arrays these are."""
    macro = name.upper()
    parts = f"{data}_parts" if piece.parts else "NULL"
    return [define(f"{name}_part_count", len(piece.parts)), define(f"{name}_vertex_count", vertex_count(piece)),
            define(f"{name}_radius", radius(piece.radius_raw)), define(f"{name}_bounding_radius", radius(piece.bounding_raw)),
            *origin_macros(name, piece.origin, grid),
            f"#define {macro}_AT(x, y) {{ {{ (x), (y) }}, {macro}_RADIUS, {macro}_BOUNDING_RADIUS, {parts}, {macro}_PART_COUNT }}"]


class Shapes:
    """Pieces with their arrays. Pieces that are equal share them: a map's tiles, a strip's resting frames."""

    def __init__(self, grid):
        self.grid = grid
        self.names = {}
        self.bytes = 0

    def declaration(self, name, piece):
        key = tuple((tuple(relative(part.vertices, piece.origin)), part.internal) for part in piece.parts)
        data = self.names.setdefault(key, name)
        own = data == name
        self.bytes += array_bytes(piece) if own else 0
        cost = manual.cost([piece]) if own else f"the arrays of {data}"
        arrays = shape_arrays(name, piece, self.grid) if own else []
        return "\n".join([f"/* {name}: {cost}; {manual.error(piece)} */", *piece_macros(name, piece, data, self.grid), *arrays])


# ---- Drawings

@dataclass(frozen=True)
class Named:
    """A drawing, its pieces, where its pieces lie together, and what C calls them."""

    drawing: object
    pieces: list
    origin: tuple[int, int]
    name: str
    piece_names: list[str]

    @property
    def several(self):
        return len(self.pieces) > 1


def named(drawing, pieces, base, taken, options):
    """The C names of one drawing. Islands of a picture are rock_0, rock_1; of its frame 3 rock_3_0, rock_3_1."""
    wish = "_".join(filter(None, [base, names.cleaned(drawing.name)]))
    name = taken.claim(wish, OF_GROUP if len(pieces) > 1 else OF_PIECE)
    piece_names = [taken.claim(f"{name}_{i}", OF_PIECE) for i in range(len(pieces))] if len(pieces) > 1 else [name]
    return Named(drawing, pieces, pipeline.origin_of(drawing, pieces, options), name, piece_names)


def group_macro(group, grid):
    """All pieces at their places about a common position: as many initializers, for an array."""
    calls = []
    for name, piece in zip(group.piece_names, group.pieces):
        x, y = grid.turned(relative([piece.origin], group.origin)[0])
        calls.append(f"    {name.upper()}_AT((x) + {grid.length(x)}, (y) + {grid.length(y)})")
    return f"#define {group.name.upper()}_AT(x, y) \\\n" + ", \\\n".join(calls)


def group_macros(group, grid):
    return [f"/* {group.name}: {manual.counted(len(group.pieces), 'piece')} */", define(f"{group.name}_count", len(group.pieces)),
            *origin_macros(group.name, group.origin, grid), group_macro(group, grid)]


def group_text(group, shapes):
    """Its pieces, then the macro for all of them."""
    sections = [shapes.declaration(name, piece) for name, piece in zip(group.piece_names, group.pieces)]
    return [*sections, "\n".join(group_macros(group, shapes.grid))] if group.several else sections


# ---- Sources: what is declared besides the pieces

def zero(group):
    return f"{group.name.upper()}_AT(TUFF_WHOLE(0), TUFF_WHOLE(0))"


def object_text(group, options, grid):
    """A single picture, or a shape of a set: ready to use, about (0, 0)."""
    sizes = size_macros(group.name, group.drawing, options, grid)
    if group.several:
        return ["\n".join([*sizes, array(f"tuff_terrain {group.name}[{group.name.upper()}_COUNT]", [zero(group)])])]
    return ["\n".join([*sizes, f"static const tuff_terrain {group.name} = {zero(group)};"])]


def frame_numbers(groups, options):
    """How many frames the sheet has, empty ones among them; the author's grid knows those at the end."""
    columns, rows = getattr(options, "grid", None) or (0, 0)
    return max(columns * rows, 1 + max(int(group.drawing.name) for group in groups))


def sheet_text(base, groups, options, grid):
    """Frame f has the pieces from first[f] up to, not including, first[f + 1]."""
    by_frame = {int(group.drawing.name): group for group in groups}
    count = frame_numbers(groups, options)
    firsts, origins = [0], []
    for frame in range(count):
        group = by_frame.get(frame)
        firsts.append(firsts[-1] + (len(group.pieces) if group else 0))
        x, y = group.origin if group else (0, 0)
        origins.append(f"{{ {grid.length(x)}, {grid.length(y)} }}")
    most = max(len(group.pieces) for group in groups)
    macro = base.upper()
    return ["\n".join([define(f"{base}_frame_count", count), define(f"{base}_frame_pieces", f"{most}    /* the most of any frame */"),
                       define(f"{base}_count", firsts[-1]), *size_macros(base, groups[0].drawing, options, grid),
                       array(f"tuff_terrain {base}[{macro}_COUNT]", [zero(group) for group in groups]),
                       array(f"uint16_t {base}_first[{macro}_FRAME_COUNT + 1]", [str(first) for first in firsts], 16),
                       array(f"tuff_vec2 {base}_origins[{macro}_FRAME_COUNT]", origins, 2)])]


def placement_text(placement, group, options, grid):
    corner = pipeline.lattice_of(options).nearest((placement.x, placement.y))
    x, y = grid.turned((int(corner[0]) + group.origin[0], int(corner[1]) + group.origin[1]))
    with pipeline.faults_at(group.drawing.place):
        return f"{group.name.upper()}_AT({grid.length(x)}, {grid.length(y)})"


def map_text(base, groups, source, options, grid):
    """Every placement in the map's own units; its upper left corner is (0, 0)."""
    count = terrain_count(groups, source)
    if count > MAX_PIECES:
        raise ShapeFault(f"the map has {count} pieces, more than {MAX_PIECES}: --merge, or several maps")
    buckets = min(MAX_BUCKETS, 1 << (count - 1).bit_length())
    placed = [placement_text(placement, groups[placement.drawing], options, grid) for placement in source.placements]
    return ["\n".join([define(f"{base}_count", count), define(f"{base}_bucket_count", buckets),
                       array(f"tuff_terrain {base}[{base.upper()}_COUNT]", placed)])]


# ---- The header

def is_sheet(source):
    return source.placements is None and all(drawing.place.startswith("frame ") for drawing in source.drawings)


def declare(taken, base, source):
    """What a file declares once; a map's or sheet's array takes the file's name before its drawings do."""
    taken.claim(base, OF_FILE)
    if source.placements is not None:
        taken.claim(base, OF_MAP)
    elif is_sheet(source):
        taken.claim(base, OF_SHEET)


def whole_text(base, groups, source, options, grid):
    if source.placements is not None:
        return map_text(base, groups, source, options, grid)
    if is_sheet(source):
        return sheet_text(base, groups, options, grid)
    return [text for group in groups for text in object_text(group, options, grid)]


def use(base, groups, source):
    if source.placements is not None:
        return manual.use_of_map(base)
    return manual.use_of_sheet(base) if is_sheet(source) else manual.use_of_one(groups[0].name, groups[0].several)


def terrain_count(groups, source):
    """How many tuff_terrain the file declares."""
    if source.placements is None:
        return sum(len(group.pieces) for group in groups)
    return sum(len(groups[placement.drawing].pieces) for placement in source.placements)


def facts(groups, source, options, arrays):
    """arrays: bytes of vertices, normals and parts."""
    width, height = source.drawings[0].size
    is_picture = source.placements is None and (len(source.drawings) == 1 or is_sheet(source))
    pixels = f"{width:g} x {height:g} pixels, " if is_picture else ""
    size = arrays + PIECE_BYTES * terrain_count(groups, source)
    return [f"{pixels}{options.scale:g} {'unit' if options.scale == 1 else 'units'} a pixel, y {'up' if options.y_up else 'down'}.",
            *manual.figures([piece for group in groups for piece in group.pieces], size)]


def text(pieces_per_drawing, source, options, command):
    """The whole file. options.name is its base; command is what made it."""
    base = names.base(options.name)
    grid = Grid(options.per_unit, options.y_up)
    taken = names.Names()
    declare(taken, base, source)
    groups = [named(drawing, pieces, base, taken, options) for drawing, pieces in zip(source.drawings, pieces_per_drawing)]
    pitch = pitch_log2([piece for group in groups for piece in group.pieces])
    shapes = Shapes(grid)
    declarations = [section for group in groups for section in group_text(group, shapes)]
    comment = manual.comment(command, facts(groups, source, options, shapes.bytes), use(base, groups, source))
    guard = f"{base.upper()}_SHAPES_H"
    sections = [f"{comment}\n#ifndef {guard}\n#define {guard}", f"#include {options.include}",
                define(f"{base}_pitch_log2", f"{pitch}    /* advice for the chunks: 2^{pitch} units */"),
                *declarations, *whole_text(base, groups, source, options, grid), "#endif"]
    return "\n\n".join(sections) + "\n"
