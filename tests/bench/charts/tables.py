# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The CSV files of build/bench, and build/cycles.csv: rows as dictionaries, in which what looks like a number is one and an empty field is
# None.
import csv
from pathlib import Path

MADE_BY = {"pairs": "make bench", "scenes": "make bench", "scale": "make bench", "models": "make bench-models",
           "cycles": "make cycles"}


class Missing(Exception):
    """A table that is not there, or not whole: the text names the command that makes it."""


def value(text):
    if text == "":
        return None
    try:
        return float(text)
    except ValueError:
        return text


def read(folder, name, columns):
    """The rows of folder/name.csv, which must have these columns."""
    path = Path(folder, f"{name}.csv")
    try:
        with path.open(newline="", encoding="utf-8") as handle:
            reader = csv.DictReader(handle)
            rows = [{column: value(text or "") for column, text in row.items()} for row in reader]
    except FileNotFoundError:
        raise Missing(f"{path} is not there: `{MADE_BY[name]}` makes it") from None
    lacking = [column for column in columns if column not in (reader.fieldnames or ())]
    if lacking or not rows:
        raise Missing(f"{path} has no {', '.join(lacking) or 'rows'}: `{MADE_BY[name]}` makes it anew")
    return rows


def having(rows, **wanted):
    """The rows whose columns have these values, in their order."""
    found = [row for row in rows if all(row[column] == value for column, value in wanted.items())]
    if not found:
        listed = ", ".join(f"{column} {value}" for column, value in wanted.items())
        raise Missing(f"no row has {listed}: `make bench`, `make bench-models` and `make cycles` make the tables anew")
    return found
