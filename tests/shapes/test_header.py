# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Headers as compilers see them: C99 and C++11, both builds, after and before what SDKs define; and what the compiled program then holds,
# to the last bit.
import random
import re
from fractions import Fraction

import builds
import made
import numpy as np
import pytest
from tuff_shapes import header, normals
from tuff_shapes.faults import ShapeFault
from tuff_shapes.model import Placement

HEADERS = builds.ROOT / "tests" / "headers"
CONFIGURATIONS = {"plain": [], "own types": ['-DTUFF_CONFIG_HEADER="own_types.h"', f"-I{HEADERS}"],
                  "asserts": ['-DTUFF_CONFIG_HEADER="asserts.h"', f"-I{HEADERS}"], "hostile": ["-include", HEADERS / "hostile.h"]}
ELL = made.region([(4, 4), (20, 4), (20, 40), (60, 40), (60, 60), (4, 60)])
RING = made.region([(2, 2), (50, 3), (51, 47), (1, 49)], [(20, 20), (20, 30), (30, 31), (30, 20)])


def rock(seed):
    """A star-shaped rock whose corners are no whole pixels."""
    rng = random.Random(seed)
    turns = np.sort([rng.uniform(0, 2 * np.pi) for _ in range(rng.randint(5, 14))])
    radii = np.array([rng.uniform(15, 60) for _ in turns])
    return made.region(np.stack([64 + radii * np.cos(turns), 64 + radii * np.sin(turns)], axis=1))


# What a header holds: the name of each kind, its drawings, options, placements.
def one():
    return [made.drawing(ELL)], made.options(), None


def islands():
    return [made.drawing(RING, made.square(60, 10, 12))], made.options(y_up=True), None


def frames():
    cells = [made.drawing(ELL, name="0", place="frame 0"), made.drawing(RING, made.square(60, 10, 9), name="2", place="frame 2"),
             made.drawing(ELL, name="3", place="frame 3")]
    return cells, made.options(grid=(3, 2), scale=0.5), None


def circle():
    return [made.drawing(ELL)], made.options(model="circle"), None


def level():
    shapes = [made.drawing(ELL, name="Door", place="object 1 (Door)"),
              made.drawing(RING, made.square(60, 10, 9), name="door", place="object 2 (door)"),
              made.drawing(made.square(0, 0, 16), name="count", place="tile 3")]
    spots = [Placement(0, 10, 20.5), Placement(1, 0, 0), Placement(2, -32, 0), Placement(2, -16, 0), Placement(1, 300, 3)]
    return shapes, made.options(origin="center"), spots


def set_of_tiles():
    shapes = [made.drawing(made.square(0, 0, 16), name="block"), made.drawing(RING, made.square(60, 10, 9), name="two parts")]
    return shapes, made.options(), None


KINDS = [one, islands, frames, circle, level, set_of_tiles]


def write(content, folder):
    drawings, options, placements = content
    text, pieces = made.header_of(drawings, options, placements)
    (folder / "rock.h").write_text(text)
    return folder / "rock.h", pieces


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_a_header_compiles_everywhere_without_a_warning(kind, tmp_path):
    path, _ = write(kind(), tmp_path)
    twice = tmp_path / "twice.c"
    twice.write_text(f'#include "{path.name}"\n#include "{path.name}"\nint twice(void);\nint twice(void) {{ return 0; }}\n')
    for scalar in builds.SCALARS.values():
        for options in CONFIGURATIONS.values():
            for compiler in (builds.C99, builds.CXX11):
                builds.run([*compiler, scalar, *options, "-fsyntax-only", twice])


def dump(path, folder, scalar, library, pieces="(&rock)", count="1"):
    program = builds.link(builds.ROOT / "tests/shapes/dump.c", folder / f"dump-{scalar}", scalar, library,
                          f'-DSHAPES="{path}"', f"-DPIECES={pieces}", f"-DCOUNT={count}")
    lines = [line.split() for line in builds.run([program]).splitlines()]
    return [(kind, [int(word, 16) if kind == "part" else Fraction(float.fromhex(word)) for word in words]) for kind, *words in lines]


def expected_normal(vector, scalar):
    square = vector[0] ** 2 + vector[1] ** 2
    if scalar == "q16":
        return [Fraction(normals.fixed(component, square), 2 ** 30) for component in vector]
    return [Fraction(normals.single(component, square)) for component in vector]


def expected(piece, position, options, scalar):
    """The lines of dump.c for a piece."""
    up = -1 if options.y_up else 1
    lines = [("piece", [*position, Fraction(piece.radius_raw, 65536), Fraction(piece.bounding_raw, 65536)])]
    for part in piece.parts:
        lines.append(("part", [part.internal]))
        for (x, y), (next_x, next_y) in zip(part.vertices, part.vertices[1:] + part.vertices[:1]):
            corner = [Fraction(x - piece.origin[0], options.per_unit), up * Fraction(y - piece.origin[1], options.per_unit)]
            lines.append(("vertex", corner + expected_normal((next_y - y, up * (x - next_x)), scalar)))
    return lines


@pytest.mark.parametrize("seed", range(6))
def test_the_compiled_numbers_are_those_of_the_piece(seed, libraries, tmp_path):
    options = made.options(y_up=seed % 2 == 1, scale=(1.0, 0.37, 3.0)[seed % 3], per_unit=(64, 1024, 8)[seed % 3])
    path, ((piece,),) = write(([made.drawing(rock(seed))], options, None), tmp_path)
    for scalar, library in libraries.items():
        assert dump(path, tmp_path, scalar, library) == expected(piece, [0, 0], options, scalar), f"seed {seed}"


def test_islands_lie_at_their_places(libraries, tmp_path):
    drawings, options, _ = content = islands()
    path, (pieces,) = write(content, tmp_path)
    center = header.pipeline.origin_of(drawings[0], pieces, options)
    for scalar, library in libraries.items():
        lines = []
        for piece in pieces:
            place = [Fraction(piece.origin[0] - center[0], 64), Fraction(center[1] - piece.origin[1], 64)]
            lines += expected(piece, place, options, scalar)
        assert dump(path, tmp_path, scalar, library, "rock", "ROCK_COUNT") == lines


def test_a_map_places_its_shapes(libraries, tmp_path):
    path, ((door,), other, (block,)) = write(level(), tmp_path)
    for scalar, library in libraries.items():
        pieces = [words for kind, words in dump(path, tmp_path, scalar, library, "rock", "ROCK_COUNT") if kind == "piece"]
        assert len(pieces) == 1 + 2 + 1 + 1 + 2
        assert pieces[0][:2] == [10 + Fraction(door.origin[0], 64), Fraction(41, 2) + Fraction(door.origin[1], 64)]
        assert pieces[3][:2] == [-32 + Fraction(block.origin[0], 64), Fraction(block.origin[1], 64)]
        assert [pieces[5][i] - pieces[1][i] for i in (0, 1)] == [300, 3] and pieces[2][2] == Fraction(other[1].radius_raw, 65536)


def test_a_frame_finds_its_pieces(tmp_path):
    text, _ = made.header_of(*frames())
    assert "#define ROCK_FRAME_COUNT 6\n#define ROCK_FRAME_PIECES 2 " in text and "#define ROCK_COUNT 4\n" in text
    assert re.search(r"rock_first\[ROCK_FRAME_COUNT \+ 1\] = \{\s+0, 1, 1, 3, 4, 4, 4\s+\}", text)


def test_equal_pieces_share_their_arrays():
    text, _ = made.header_of(*frames())
    assert "rock_0_vertices[" in text and "rock_3_vertices[" not in text
    assert re.search(r"#define ROCK_3_AT\(x, y\) .* rock_0_parts, ROCK_3_PART_COUNT", text)


def test_no_two_things_of_a_map_have_one_name():
    text, _ = made.header_of(*level())
    declared = re.findall(r"^static const \w+ (\w+)", text, re.M) + re.findall(r"^#define (\w+)", text, re.M)
    assert len(set(declared)) == len(declared) and "rock_door_2_0_parts" in declared


def test_the_first_comment_holds_the_command_and_nothing_of_the_machine():
    command = 'python -m tuff_shapes "a*/b/*c?\?/.png" --name caf\u00e9\nx'
    text, _ = made.header_of(*one(), command=command)
    comment, rest = text.split("*/", 1)
    assert comment.startswith("/* Made by tuff_shapes") and rest.startswith("\n#ifndef ROCK_SHAPES_H")
    assert r'a* /b/ *c?\\?/.png" --name caf\xe9\nx' in comment
    assert text.isascii() and not re.search("licen[sc]e|copyright|SPDX|20[0-9][0-9]", text, re.I)


def test_the_use_in_the_comment_is_short_and_compiles(libraries, tmp_path):
    text, _ = made.header_of(*one())
    use = [line.strip() for line in text.split("Use:")[1].split("*/")[0].splitlines() if line.strip()]
    assert len(use) <= 6
    path, _ = write(one(), tmp_path)
    game = tmp_path / "game.c"
    game.write_text("\n".join([f'#include "{path}"', use[0], use[1], "static tuff_body ship;", "int main(void)", "{",
                               f"    return {use[2].split(';')[0].replace('&ship_hull', 'NULL')} == 0 && ROCK_ORIGIN_X > 0 ? 0 : 1;", "}"]))
    for scalar, library in libraries.items():
        builds.run([builds.link(game, tmp_path / f"game-{scalar}", scalar, library)])


def test_the_pitch_is_the_power_of_two_about_the_bounding_diameter():
    text, ((piece,),) = made.header_of(*one())
    diameter = piece.bounding_raw / 32768
    pitch = 2 ** int(re.search("ROCK_PITCH_LOG2 ([0-9]+)", text)[1])
    assert diameter <= pitch < 2 * diameter


def test_a_map_beyond_the_positions_is_refused():
    shapes, options, _ = level()
    with pytest.raises(ShapeFault, match="object 1 .*32768"):
        made.header_of(shapes, options, [Placement(0, 40000, 0)])


def test_a_number_that_a_float_cannot_hold_is_refused():
    grid = header.Grid(per_unit=8192, y_up=False)
    assert grid.length(2 ** 24 - 1) == "TUFF_RATIO(16777215, 8192)"
    assert grid.length(2 ** 25) == "TUFF_RATIO(33554432, 8192)"
    with pytest.raises(ShapeFault, match="float"):
        grid.length(2 ** 24 + 1)
