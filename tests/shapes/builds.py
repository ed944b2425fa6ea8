# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The compilers, both builds of the library, and the command itself, for tests that go all the way from a picture to a game.
# TUFF_LIBRARIES=folder: the libtuff-*.a there are used; otherwise they are compiled, once for each test program.
import os
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CC = shlex.split(os.environ.get("CC", "cc"))
CXX = shlex.split(os.environ.get("CXX", "c++"))
SCALARS = {"float": "-DTUFF_SCALAR=TUFF_FLOAT", "q16": "-DTUFF_SCALAR=TUFF_Q16_16"}
WARNINGS = "-Wall -Wextra -Wconversion -Wsign-conversion -Wdouble-promotion -Wshadow -pedantic -Werror".split()
C99 = [*CC, "-std=c99", "-ffp-contract=off", *WARNINGS, f"-I{ROOT / 'include'}"]
CXX11 = [*CXX, "-x", "c++", "-std=c++11", *WARNINGS, f"-I{ROOT / 'include'}"]


def run(command, **options):
    """Runs a command; a failure shows what it said."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **options)
    assert done.returncode == 0, f"{shlex.join(map(str, command))}\n{done.stdout}{done.stderr}"
    return done.stdout


def shapes(*arguments, folder=None):
    """The command line as an author types it; the finished process."""
    environment = dict(os.environ, PYTHONPATH=str(ROOT / "tools" / "shapes"))
    command = [sys.executable, "-m", "tuff_shapes", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, env=environment, cwd=folder)


def sources():
    lines = (ROOT / "src" / "sources.list").read_text().splitlines()
    return [ROOT / line for line in lines if line and not line.startswith("#")]


def make_libraries(folder):
    """Both libraries as {scalar: path}."""
    if "TUFF_LIBRARIES" in os.environ:
        return {scalar: ROOT / os.environ["TUFF_LIBRARIES"] / f"libtuff-{scalar}.a" for scalar in SCALARS}
    return {scalar: make_library(folder / scalar, option) for scalar, option in SCALARS.items()}


def make_library(folder, scalar_option):
    folder.mkdir()
    objects = [folder / f"{source.stem}.o" for source in sources()]
    commands = [[*C99, scalar_option, "-O1", f"-I{ROOT / 'src'}", "-c", source, "-o", target] for source, target in zip(sources(), objects)]
    with ThreadPoolExecutor(2) as pool:
        list(pool.map(run, commands))
    run(["ar", "rcs", folder / "libtuff.a", *objects])
    return folder / "libtuff.a"


def link(source, target, scalar, library, *options):
    """Compiles one C file against a library of that build."""
    run([*C99, SCALARS[scalar], "-O1", *options, source, library, "-lm", "-o", target])
    return target
