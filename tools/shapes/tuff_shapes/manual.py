# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The first comment of a header: the command that makes it, what it holds, how a game uses it. No time, no license.
from .piece import rom_bytes, vertex_count


def harmless(text):
    """What a comment may hold: ASCII on one line, and nothing that opens or ends a comment or is a trigraph."""
    line = text.encode("unicode_escape").decode("ascii")
    return line.replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?")


def counted(count, noun, nouns=None):
    return f"{count} {noun if count == 1 else nouns or noun + 's'}"


def cost(pieces, size=None):
    """size: bytes, where they are not just the sum."""
    parts = counted(sum(len(piece.parts) for piece in pieces), "part")
    vertices = counted(sum(vertex_count(piece) for piece in pieces), "vertex", "vertices")
    return f"{parts}, {vertices}, {sum(rom_bytes(piece) for piece in pieces) if size is None else size} bytes"


def worst_spot(deviation):
    return f"{deviation.largest:.2f} pixels at ({deviation.spot[0]:.1f}, {deviation.spot[1]:.1f})"


def error(piece):
    return f"largest error {worst_spot(piece.deviation)}, mean {piece.deviation.mean:.2f}"


def figures(pieces, size):
    """Of one piece, or of many together, in so many bytes."""
    if len(pieces) == 1:
        return [f"{cost(pieces, size)} where pointers have 32 bits; {error(pieces[0])}."]
    worst = max(pieces, key=lambda piece: piece.deviation.largest)
    where = f" of {harmless(worst.place)}" if worst.place else ""
    return [f"{len(pieces)} pieces: {cost(pieces, size)} where pointers have 32 bits; "
            f"largest error {worst_spot(worst.deviation)}{where}."]


# ---- How a game uses it, by the kind of source

COLLIDE = "tuff_terrain_collide(&world, &ship, TUFF_REAL(8.0), &ship_hull);     // every step"


def use_of_one(name, several):
    macro = name.upper()
    count = f"2 * {macro}_COUNT" if several else "2"
    places = f"{macro}_AT(TUFF_WHOLE(120), TUFF_WHOLE(60)), {macro}_AT(TUFF_WHOLE(-40), TUFF_WHOLE(9))"
    return [f"static const tuff_terrain belt[] = {{ {places} }};",
            f"static tuff_world world = {{ belt, {count}, NULL, NULL, 0, TUFF_ORDER_ITERATION }};",
            COLLIDE,
            f"The picture's upper left corner is drawn {macro}_ORIGIN_X to the left of the position and {macro}_ORIGIN_Y above."]


def use_of_sheet(name):
    return [f"uint16_t i, first = {name}_first[frame], count = (uint16_t)({name}_first[frame + 1] - first);",
            f"tuff_terrain now[{name.upper()}_FRAME_PIECES];",
            f"for (i = 0; i < count; ++i) {{ now[i] = {name}[first + i]; now[i].position.x += x; now[i].position.y += y; }}",
            "tuff_floater_collide(&ship, TUFF_REAL(8.0), now, count, &ship_hull);",
            f"The frame's upper left corner is drawn {name}_origins[frame].x to the left of (x, y) and .y above."]


def use_of_map(name):
    macro = name.upper()
    return [f"static uint16_t buckets[{macro}_BUCKET_COUNT];",
            f"static tuff_chunk_entry entries[{macro}_COUNT];",
            f"static tuff_chunks chunks = TUFF_CHUNKS(buckets, entries, {macro}_PITCH_LOG2);",
            f"static tuff_world world = {{ {name}, {macro}_COUNT, &chunks, NULL, 0, TUFF_ORDER_DEEPEST }};",
            "tuff_world_index(&world);     // once",
            COLLIDE]



def comment(command, facts, use):
    """The whole comment; command as typed."""
    lines = ["Made by tuff_shapes. Change the picture, not this file:", "", f"  {harmless(command)}", "", *facts, "", "Use:",
             *(f"  {line}" for line in use)]
    return "\n".join(["/* " + lines[0], *(f"   {line}".rstrip() for line in lines[1:])]) + " */"
