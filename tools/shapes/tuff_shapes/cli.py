# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The command: reads, bakes, writes whole files or none, reports. The rooms with slow imports are imported where they are used.
import io
import os
import re
import shlex
import sys
import tempfile
from contextlib import ExitStack
from pathlib import Path, PurePath

from . import names
from .faults import Journal, ShapeFault
from .options import TABLE_REGIONS, parser

MAPS = (".tmx", ".tsx", ".tmj", ".tsj", ".json")
PREVIEWS = (".png", ".svg")


def check_paths(options):
    """A slip of the hand must not overwrite the drawing."""
    targets = [Path(target) for target in (options.output, options.preview) if target]
    if options.preview and PurePath(options.preview).suffix.lower() not in PREVIEWS:
        raise ShapeFault(f"{options.preview}: a preview is a .png or an .svg file")
    for target in targets:
        if target.resolve() == Path(options.input).resolve():
            raise ShapeFault("would be overwritten: another name for the output")
        if not target.parent.is_dir() or target.is_dir():
            raise ShapeFault(f"{target}: cannot be written: {'it is a folder' if target.is_dir() else 'there is no such folder'}")
    if len(targets) == 2 and targets[0].resolve() == targets[1].resolve():
        raise ShapeFault("header and preview need different names")


# ---- The work

def read(options, journal):
    suffix = PurePath(options.input).suffix.lower()
    if suffix in MAPS:
        from . import tiled as reader
    elif suffix == ".svg":
        from . import svg as reader
    else:
        from . import pictures as reader
    return reader.read(options.input, options, journal)


def progress(drawings, options):
    """A bar for sheets and maps."""
    if len(drawings) < 2 or options.quiet or not (options.progress or sys.stderr.isatty()):
        return drawings
    from tqdm import tqdm
    return tqdm(drawings, desc=PurePath(options.input).name, unit="shape", file=sys.stderr)


def bake_all(source, options, journal):
    from . import pipeline
    return [pipeline.bake(drawing, options, journal) for drawing in progress(source.drawings, options)]


def command_line(arguments):
    """As typed, but for folders that only this machine has."""
    local = [re.sub("^(--[a-z-]+=)?/.*/", r"\1", argument.replace(os.sep, "/")) for argument in arguments]
    return shlex.join(["python", "-m", "tuff_shapes", *local])


def summary(pieces, options):
    from . import manual
    lines = []
    for piece in pieces:
        name = "_".join(filter(None, [options.name, names.cleaned(piece.name)]))
        circles = f"radius {piece.radius_raw / 65536:.2f}, bounding radius {piece.bounding_raw / 65536:.2f} units"
        lines.append(f"{name}: {manual.cost([piece])}; {manual.error(piece)}; {circles}")
    return lines


def table(source, pieces_per_drawing, options, journal):
    """One for all the drawings that were treated alike: sums over them."""
    from . import table as tables
    from .model import Drawing
    texts = []
    for exact in (False, True):
        chosen = [i for i, drawing in enumerate(source.drawings) if drawing.exact == exact]
        if not chosen:
            continue
        regions = [region for i in chosen for region in source.drawings[i].regions]
        together = Drawing("", "", regions, source.drawings[chosen[0]].size, exact=exact)
        pieces = [piece for i in chosen for piece in pieces_per_drawing[i]]
        texts.append(tables.text(tables.rows(together, options, journal, pieces)))
    return texts


def wants_table(source, options):
    if options.quiet or options.table is False:
        return False
    return options.table or sum(len(drawing.regions) for drawing in source.drawings) <= TABLE_REGIONS


def report(source, pieces_per_drawing, options, journal):
    if options.quiet:
        return
    stream = sys.stdout if options.output else sys.stderr
    lines = summary([piece for pieces in pieces_per_drawing for piece in pieces], options)
    tables = table(source, pieces_per_drawing, options, journal) if wants_table(source, options) else []
    print("\n".join([*lines, *(f"\n{text}" for text in tables)]), file=stream)


# ---- Files

def beside(target, stack):
    """A file in the target's folder, of the same kind, that is gone at the end unless it has become the target."""
    target = Path(target)
    handle, name = tempfile.mkstemp(prefix=f".{target.stem}-", suffix=target.suffix, dir=target.parent)
    os.close(handle)
    stack.callback(Path(name).unlink, missing_ok=True)
    return name


def keep_mode(new, target):
    """mkstemp makes files that only their owner reads; a header is as readable as any other file."""
    mask = os.umask(0)
    os.umask(mask)
    os.chmod(new, os.stat(target).st_mode & 0o777 if os.path.exists(target) else 0o666 & ~mask)


def write(text, source, pieces_per_drawing, options):
    """Both files, after everything has succeeded."""
    with ExitStack() as stack:
        written = []
        if options.output:
            written.append((beside(options.output, stack), options.output))
            Path(written[-1][0]).write_text(text, encoding="ascii", newline="\n")
        if options.preview:
            from . import preview
            written.append((beside(options.preview, stack), options.preview))
            preview.draw_all(written[-1][0], list(zip(source.drawings, pieces_per_drawing)), options)
        for new, target in written:
            keep_mode(new, target)
            os.replace(new, target)
    if not options.output:
        sys.stdout.write(text)


def run(options, command):
    """The header is complete before the first file is written."""
    from . import header
    journal = Journal(options.input, io.StringIO() if options.quiet else None)
    check_paths(options)
    options.name = names.base(options.input, options.name)
    source = read(options, journal)
    pieces_per_drawing = bake_all(source, options, journal)
    text = header.text(pieces_per_drawing, source, options, command)
    write(text, source, pieces_per_drawing, options)
    report(source, pieces_per_drawing, options, journal)


def main(argv=None):
    arguments = sys.argv[1:] if argv is None else argv
    options = parser().parse_args(arguments)
    try:
        run(options, command_line(arguments))
    except (ShapeFault, OSError) as fault:
        print(f"{options.input}: {fault}", file=sys.stderr)
        return 2
    return 0
