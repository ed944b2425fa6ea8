# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The README's section on pictures, word for word: its command, its C, its rule for make.
import os
import re
import shlex
import shutil
import sys

import builds
import pytest
import source_tree
from builds import ROOT
from PIL import Image
from source_tree import make


def section():
    text = (ROOT / "README.md").read_text()
    return re.search(r"^## From picture to terrain\n(.*?)^## ", text, re.MULTILINE | re.DOTALL).group(1)


@pytest.fixture
def tree(tmp_path):
    """Where the README's command has been run."""
    folder = source_tree.copy(tmp_path)
    command = re.search(r"^    make (shapes .*)$", section(), re.MULTILINE).group(1)
    make(folder, *shlex.split(command))
    return folder


def test_the_command_writes_header_and_preview(tree):
    assert "static const tuff_terrain rock" in (tree / "rock.h").read_text()
    with Image.open(tree / "rock-preview.png") as image:
        assert image.width > 500


@pytest.mark.parametrize("scalar", builds.SCALARS)
def test_the_lines_of_use_compile(tree, scalar):
    code = re.search(r"^```c\n(.*?)^```", section(), re.MULTILINE | re.DOTALL).group(1)
    (tree / "game.c").write_text(code)
    builds.run([*builds.C99, builds.SCALARS[scalar], "-fsyntax-only", "game.c"], cwd=tree)


def test_the_rule_makes_a_header_anew_when_its_picture_has_changed(tmp_path):
    rule = "\n".join(line[4:] for line in re.search(r"^    %.h: %.png\n    .*$", section(), re.MULTILINE).group().splitlines())
    (tmp_path / "Makefile").write_text(rule + "\n")
    package = shlex.quote(str(ROOT / "tools/shapes"))
    source_tree.script(tmp_path / "bin" / "tuff-shapes", f"env PYTHONPATH={package} {shlex.quote(sys.executable)} -m tuff_shapes")
    shutil.copy(ROOT / "docs/shapes-rock.png", tmp_path / "rock.png")
    make(tmp_path, "rock.h", path=[tmp_path / "bin"])
    before = (tmp_path / "rock.h").read_text()
    with Image.open(tmp_path / "rock.png") as image:
        image.transpose(Image.Transpose.ROTATE_90).save(tmp_path / "rock.png")
    os.utime(tmp_path / "rock.h", (1, 1))
    make(tmp_path, "rock.h", path=[tmp_path / "bin"])
    assert (tmp_path / "rock.h").read_text() != before
