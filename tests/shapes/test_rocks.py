# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The demo's rocks: pictures, headers and the Makefile's rule between them agree. Everything is made in a copy.
import os
import re
import runpy
import shlex
import shutil
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
import source_tree
from builds import ROOT
from PIL import Image
from source_tree import make

ROCKS = Path("ports/scene/rocks")
SHEETS = ["small", "medium", "large", "concave"]


def command_of(header):
    """The command that the header's first comment names."""
    line = re.search(r"^ *python -m tuff_shapes .*$", header.read_text(), re.MULTILINE).group().strip()
    return shlex.split(line)[3:]


@pytest.fixture
def tree(tmp_path):
    return source_tree.copy(tmp_path)


def age(path, seconds):
    moment = time.time() - seconds
    os.utime(path, (moment, moment))


def without_upper_half(path):
    with Image.open(path) as image:
        pixels = np.array(image)
    pixels[:pixels.shape[0] // 2] = 0
    Image.fromarray(pixels).save(path)


@pytest.mark.parametrize("name", SHEETS)
def test_the_committed_header_comes_from_the_committed_picture(name, tmp_path):
    (tmp_path / ROCKS).mkdir(parents=True)
    shutil.copy(ROOT / ROCKS / f"{name}.png", tmp_path / ROCKS)
    command = [sys.executable, "-m", "tuff_shapes", *command_of(ROOT / ROCKS / f"{name}.h")]
    subprocess.run(command, cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(ROOT / "tools/shapes")}, check=True)
    assert (tmp_path / ROCKS / f"{name}.h").read_bytes() == (ROOT / ROCKS / f"{name}.h").read_bytes()


@pytest.mark.parametrize("name", SHEETS)
def test_the_script_draws_the_committed_pixels(name):
    drawn = np.asarray(runpy.run_path(str(ROOT / ROCKS / "draw.py"))["sheet"](name))
    with Image.open(ROOT / ROCKS / f"{name}.png") as image:
        assert image.mode == "RGBA"
        assert np.array_equal(drawn, np.asarray(image))


@pytest.mark.parametrize("name", SHEETS)
def test_the_rule_gives_the_committed_header(name, tree):
    header = tree / ROCKS / f"{name}.h"
    committed = header.read_bytes()
    header.unlink()
    make(tree, str(ROCKS / f"{name}.h"))
    assert header.read_bytes() == committed


def test_a_changed_picture_changes_its_header_and_the_object(tree):
    header, picture = tree / ROCKS / "concave.h", tree / ROCKS / "concave.png"
    committed, shapes = header.read_bytes(), tree / "build/make/plain/q16/ports/scene/shapes.o"
    make(tree, str(shapes.relative_to(tree)))
    before = shapes.read_bytes()
    without_upper_half(picture)
    age(header, 60)
    make(tree, str(shapes.relative_to(tree)))
    assert header.read_bytes() != committed
    assert shapes.read_bytes() != before
    assert (tree / ROCKS / "small.h").read_bytes() == (ROOT / ROCKS / "small.h").read_bytes()


def test_without_the_tools_a_picture_newer_than_its_header_changes_nothing(tree):
    for name in SHEETS:
        without_upper_half(tree / ROCKS / f"{name}.png")
        age(tree / ROCKS / f"{name}.h", 60)
    make(tree, "build/make/plain/float/ports/scene/shapes.o", tools="none")
    for name in SHEETS:
        assert (tree / ROCKS / f"{name}.h").read_bytes() == (ROOT / ROCKS / f"{name}.h").read_bytes()


def test_a_sheet_that_lost_a_rock_is_an_error_of_the_compiler(tree):
    header = tree / ROCKS / "small.h"
    header.write_text(header.read_text().replace("#define SMALL_ROCKS_COUNT 5", "#define SMALL_ROCKS_COUNT 4"))
    with pytest.raises(AssertionError, match="each frame of a picture in rocks/ holds one rock"):
        make(tree, "build/make/plain/float/ports/scene/shapes.o", tools="none")
