#!/usr/bin/env python3
# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The table and the pictures of docs/stability.md.
#   page.py collect LOGS TABLE    cells that the tests printed (LOGS/*.log) -> a CSV file; fails where tuff has an empty cell
#   page.py check TABLE PAGE      does the page show tuff's figures of the table?
#   page.py write BUILD PAGE      run the programs in BUILD, then collect, write the page's table and draw its pictures
# Needs no package but for write (matplotlib, Pillow).
import argparse
import csv
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

COLUMNS = ["family", "measure", "method that fails", "its figure", "Box2D 2.4.1", "tuff float", "tuff Q16.16"]
TUFF = {"float": "tuff float", "q16": "tuff Q16.16"}
OTHERS = {"fails": "its figure", "box2d": "Box2D 2.4.1"}
BEGIN, END = "<!-- table: written by make stability -->", "<!-- end of table -->"
MARK = "cell: "


class Fault(Exception):
    pass


# ---- The table

def read_cells(logs):
    """(family number, family name, measure, column, method, figure) of each cell, in the order of the families."""
    cells = []
    for log in sorted(logs.glob("*.log")):
        for line in log.read_text(errors="replace").splitlines():
            if line.startswith(MARK):
                number, *rest = line[len(MARK):].split(";")
                cells.append((int(number), *rest))
    return sorted(cells, key=lambda cell: cell[0])


def put(row, column, build, figure):
    """The same figure from both builds' programs is shown once; different ones with their builds."""
    row.setdefault(column, {})[build] = figure


def shown(figures):
    if len(set(figures.values())) == 1:
        return next(iter(figures.values()))
    return ", ".join(f"{figure} ({TUFF[build].removeprefix('tuff ')})" for build, figure in sorted(figures.items()))


def rows_of(cells):
    rows = {}
    for number, family, measure, column, method, figure in cells:
        row = rows.setdefault((number, measure), {"family": {"": f"{number}. {family}"}, "measure": {"": measure}})
        if column in TUFF:
            put(row, TUFF[column], column, figure)
            continue
        kind, build = column.split("-")
        put(row, OTHERS[kind], build, figure)
        if method:
            put(row, "method that fails", "", method)
    return [{column: shown(row[column]) if column in row else "" for column in COLUMNS} for row in rows.values()]


def collect(logs, table):
    rows = rows_of(read_cells(logs))
    if not rows:
        raise Fault(f"{logs}: no cells")
    table.parent.mkdir(parents=True, exist_ok=True)
    with table.open("w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    for row in rows:
        for column in TUFF.values():
            if not row[column]:
                raise Fault(f"{row['family']}, {row['measure']}: no figure of {column}")
    return rows


# ---- The page

def page_table(rows):
    lines = ["| " + " | ".join(COLUMNS) + " |", "|" + "---|" * len(COLUMNS)]
    last = None
    for row in rows:
        family = row["family"] if row["family"] != last else ""
        lines.append("| " + " | ".join([family] + [row[column] for column in COLUMNS[1:]]) + " |")
        last = row["family"]
    return lines


def split_page(page):
    """The text before the table, the table's lines, the text after it."""
    lines = page.read_text().splitlines()
    if BEGIN not in lines or END not in lines:
        raise Fault(f"{page}: no table between {BEGIN!r} and {END!r}")
    begin, end = lines.index(BEGIN), lines.index(END)
    return lines[:begin + 1], lines[begin + 1:end], lines[end:]


def tuffs_part(line):
    """What must hold on any machine: the row's measure and tuff's figures; Box2D and C libraries elsewhere may differ in the last digit."""
    fields = [field.strip() for field in line.strip().strip("|").split("|")]
    return [fields[COLUMNS.index(column)] for column in ("measure", *TUFF.values())]


def check(table, page):
    with table.open(newline="") as file:
        rows = list(csv.DictReader(file))
    faults = []
    expected, found = page_table(rows), split_page(page)[1]
    if len(expected) != len(found):
        faults.append(f"the page has {len(found) - 2} rows, the run {len(expected) - 2}")
    for now, then in zip(expected, found):
        if tuffs_part(now) != tuffs_part(then):
            faults.append(f"this run: {now}\nthe page: {then}")
    if faults:
        raise Fault("\n".join([*faults, "to write the page anew: make stability"]))


# ---- All of it

def run(program, log, pictures):
    environment = {name: value for name, value in os.environ.items() if not name.startswith("TUFF_TEST_")}
    environment["TUFF_STABILITY_PICTURES"] = str(pictures)
    with log.open("w") as file:
        status = subprocess.run([program], stdout=file, stderr=subprocess.STDOUT, env=environment, check=False).returncode
    print(f"{'ran' if status == 0 else 'FAILED'} {program.name}", flush=True)
    return status


def write(build, page):
    import draw
    folder = build / "stability"
    folder.mkdir(parents=True, exist_ok=True)
    for old in [*folder.glob("*.log"), *folder.glob("*.picture")]:
        old.unlink()
    tests = [line for line in (Path(__file__).parent / "tests.list").read_text().splitlines() if not line.startswith("#")]
    programs = [build / f"make/plain/stability/{test}-{scalar}" for test in tests for scalar in TUFF]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        failed = sum(pool.map(lambda program: run(program, folder / f"{program.name}.log", folder) != 0, programs))
    if failed:
        raise Fault(f"{failed} programs failed; their output: {folder}/*.log")
    rows = collect(folder, build / "stability.csv")
    before, _, after = split_page(page)
    page.write_text("\n".join([*before, *page_table(rows), *after]) + "\n")
    for picture in sorted(folder.glob("*.picture")):
        draw.draw(picture, page.parent / "stability")
    print(f"wrote {page} and {page.parent / 'stability'}")


def main():
    command = argparse.ArgumentParser(description="The table and pictures of docs/stability.md; see the head of this file.")
    command.add_argument("what", choices=["collect", "check", "write"])
    command.add_argument("source", type=Path)
    command.add_argument("target", type=Path)
    options = command.parse_args()
    try:
        {"collect": collect, "check": check, "write": write}[options.what](options.source, options.target)
    except Fault as fault:
        sys.exit(f"stability: {fault}")


if __name__ == "__main__":
    main()
