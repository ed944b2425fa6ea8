# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# What went wrong, and where: every message to the author names the file and the place in it.
import sys


class ShapeFault(Exception):
    """Nothing is written, and the command ends with status 2. The file's name is put in front by the command."""

    def __init__(self, text, place=""):
        super().__init__(f"{place}: {text}" if place else text)


class Journal:
    """Notes on one input file, which do not stop the work: dropped specks, corners that touch."""

    def __init__(self, file, stream=None):
        self.file = file
        self.stream = stream
        self.notes = []

    def note(self, text, place=""):
        line = f"{self.file}: {place}: {text}" if place else f"{self.file}: {text}"
        self.notes.append(line)
        print(f"note: {line}", file=self.stream or sys.stderr)
