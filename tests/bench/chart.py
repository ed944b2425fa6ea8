#!/usr/bin/env python3
# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Draws docs/charts from the tables of the bench: chart.py TABLES PICTURES, run by `make chart`. Each chart on light and on
# dark ground, as SVG and PNG; the same tables give the same bytes.
import argparse
import sys
from pathlib import Path

from charts import accuracy, look, machines, models, scale, tables

CHARTS = {"accuracy": accuracy, "scale": scale, "models": models, "machines": machines}


def main():
    command = argparse.ArgumentParser(description="Draw the charts of the README; see the head of this file.")
    command.add_argument("tables", type=Path, help="the folder of the CSV files: build/bench")
    command.add_argument("pictures", type=Path, help="where the charts go: docs/charts")
    command.add_argument("--only", choices=CHARTS, help="one chart instead of all")
    options = command.parse_args()
    try:
        for name in [options.only] if options.only else CHARTS:
            for theme in look.THEMES:
                look.save(CHARTS[name].draw(options.tables, theme), options.pictures, f"chart-{name}", theme)
                print(f"drew {options.pictures}/chart-{name}.{theme.name}.svg and .png")
        print("\nMedians of the models, Q16.16:", *models.summary(options.tables), sep="\n  ")
    except tables.Missing as fault:
        sys.exit(f"chart: {fault}")


if __name__ == "__main__":
    main()
