# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# A copy of what the demo and the headers are made from, to run make in, and a stand-in for build/shape-tools that runs this
# test's own Python.
import os
import shlex
import shutil
import subprocess
import sys

from builds import ROOT

COPIED = ("Makefile", "include", "src", "ports", "tools", "docs", "tests/host/tests.list", "tests/unit/tests.list",
          "tests/shapes/requirements.txt")


def script(path, command):
    """A program that passes its arguments on to a command."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f'#!/bin/sh\nexec {command} "$@"\n')
    path.chmod(0o755)


def copy(folder):
    for name in COPIED:
        source, target = ROOT / name, folder / "tree" / name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copytree(source, target) if source.is_dir() else shutil.copy2(source, target)
    script(folder / "tools" / "bin" / "python", shlex.quote(sys.executable))
    (folder / "tools" / "ready").touch()
    return folder / "tree"


def make(tree, *arguments, tools="../tools", path=()):
    """Runs make there, which must succeed."""
    environment = {name: value for name, value in os.environ.items() if name not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL", "PYTHONPATH")}
    environment["PATH"] = os.pathsep.join([*map(str, path), environment["PATH"]])
    done = subprocess.run(["make", "-s", *arguments, f"SHAPE_TOOLS={tools}"], cwd=tree, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout
