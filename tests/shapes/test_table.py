# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The table of models: what stands in it, which row is the author's, and what it advises.
from types import SimpleNamespace

import numpy as np
import pytest
from tuff_shapes import pipeline, table
from tuff_shapes.faults import Journal, ShapeFault
from tuff_shapes.model import Drawing, Region
from tuff_shapes.table import Figures, Row

# A stair of eight pixels, an L, far apart: nothing of them is symmetric.
STAIR = np.array([(0, 0), *[(8 + 4 * (i // 2), 4 * ((i + 1) // 2)) for i in range(16)], (40, 40), (0, 40)], dtype=float)
ELL = np.array([(60, 0), (70, 0), (70, 25), (90, 25), (90, 35), (60, 35)], dtype=float)


def options(**changed):
    chosen = {"model": "parts", "tolerance": None, "vertices": None, "scale": 1.0, "per_unit": 64, "origin": "area", "table": True}
    return SimpleNamespace(**{**chosen, **changed})


def drawing(exact=False):
    return Drawing("", "", [Region(STAIR), Region(ELL)], (90.0, 40.0), exact=exact)


def rows(exact=False, **changed):
    return table.rows(drawing(exact), options(**changed), Journal("rock.png"))


def labels(found):
    return [row.label for row in found]


def chosen(found):
    marked = [row for row in found if row.limit is not None]
    assert len(marked) == 1
    return marked[0]


def row(label, size, largest, limit=None):
    return Row(label, Figures(1, 4, size, largest, largest / 2), limit=limit)


def test_bytes_are_those_of_a_32_bit_machine():
    pieces = pipeline.bake(drawing(exact=True), options(), None)
    found = table.figures(pieces)
    assert found.bytes == 24 * 2 + 16 * found.parts + 16 * found.vertices
    assert found.largest == 0 and found.mean < 1e-12


def test_the_mean_is_over_the_length_of_the_border():
    pieces = pipeline.bake(drawing(), options(tolerance=3.0), None)
    lengths = [sum(np.hypot(*(b - a)) for a, b in zip(ring, np.roll(ring, -1, axis=0))) for ring in (STAIR, ELL)]
    expected = sum(length * piece.deviation.mean for length, piece in zip(lengths, pieces)) / sum(lengths)
    assert table.figures(pieces).mean == pytest.approx(expected, rel=1e-12)
    assert pieces[0].deviation.mean != pytest.approx(pieces[1].deviation.mean)


def test_a_tolerance_has_neighbors_from_twice_to_half_of_it():
    found = rows(tolerance=2.0)
    assert labels(found) == ["circle", "hull, 4 vertices", "hull, 6 vertices", "hull, 8 vertices", "hull, 12 vertices",
                             "parts, 4 px", "parts, 2.83 px", "parts, 2 px", "parts, 1.41 px", "parts, 1 px"]
    assert chosen(found).label == "parts, 2 px"


def test_rows_by_tolerance_are_within_it():
    for each in rows(tolerance=2.0)[5:]:
        assert each.figures.largest <= float(each.label.split()[1]) + 0.005


def test_without_a_tolerance_the_default_is_chosen():
    assert chosen(rows()).label == f"parts, {pipeline.TOLERANCE:g} px"


def test_a_budget_has_neighbors_from_half_to_twice_of_it():
    found = rows(vertices=8)
    assert labels(found)[5:] == [f"parts, {count} vertices" for count in (4, 6, 8, 11, 16)]
    assert chosen(found).label == "parts, 8 vertices"


def test_the_smallest_budget_has_no_neighbor_below_a_triangle():
    assert labels(rows(vertices=3))[5:] == ["parts, 3 vertices", "parts, 4 vertices", "parts, 6 vertices"]


@pytest.mark.parametrize(("changed", "label"), [
    ({"model": "circle"}, "circle"),
    ({"model": "hull", "vertices": 6}, "hull, 6 vertices"),
    ({"model": "hull", "vertices": 7}, "hull, 7 vertices"),
    ({"model": "hull", "tolerance": 0.5}, "hull, 0.5 px"),
    ({"exact": True}, "parts, all corners"),
    ({"exact": True, "tolerance": 1.0}, "parts, 1 px"),
])
def test_the_chosen_model_is_in_the_table_once(changed, label):
    found = rows(**changed)
    assert chosen(found).label == label
    assert labels(found).count(label) == 1


def test_each_row_has_the_figures_of_its_own_model():
    for each, changed in zip(rows(), [{"model": "circle"}, {"model": "hull", "vertices": 4}, {"model": "hull", "vertices": 6}]):
        assert each.figures == table.figures(pipeline.bake(drawing(), options(**changed), None))


def test_pieces_that_are_known_are_not_made_again(monkeypatch):
    pieces = pipeline.bake(drawing(), options(), None)
    made, bake = [], pipeline.bake
    monkeypatch.setattr(pipeline, "bake", lambda shape, own, journal: made.append(own) or bake(shape, own, journal))
    found = table.rows(drawing(), options(), Journal("rock.png"), pieces)
    assert len(made) == len(found) - 1
    assert chosen(found).figures == table.figures(pieces)


def test_what_is_finer_than_a_fine_outline_is_not_tried(monkeypatch):
    monkeypatch.setattr(table, "CORNERS", 12)
    found = rows(tolerance=1.0)
    tried = {each.label: each.figures is not None for each in found}
    assert tried["parts, 2 px"] and tried["parts, 1 px"]
    assert not tried["parts, 0.5 px"]
    assert "parts, 0.5 px: not tried, it may take long; --tolerance 0.5 does" in table.text(found)


def test_the_chosen_model_is_tried_however_fine(monkeypatch):
    monkeypatch.setattr(table, "CORNERS", 0)
    assert chosen(rows(tolerance=0.5)).figures is not None


def failing(monkeypatch, model):
    bake = pipeline.bake

    def fails(shape, own, journal):
        if own.model == model:
            raise ShapeFault("no such luck", "frame 3")
        return bake(shape, own, journal)
    monkeypatch.setattr(pipeline, "bake", fails)


def test_a_model_that_cannot_be_made_is_a_row_that_says_why(monkeypatch):
    failing(monkeypatch, "hull")
    found = rows()
    assert [each.figures is None for each in found[1:5]] == [True] * 4
    assert "hull, 4 vertices: frame 3: no such luck" in table.text(found)


def test_the_fault_of_the_chosen_model_is_the_commands(monkeypatch):
    failing(monkeypatch, "parts")
    with pytest.raises(ShapeFault, match="no such luck"):
        rows()


def test_notes_are_not_given_once_a_row(monkeypatch, capsys):
    bake = pipeline.bake
    monkeypatch.setattr(pipeline, "bake", lambda shape, own, journal: journal.note("a speck") or bake(shape, own, journal))
    rows()
    assert capsys.readouterr() == ("", "")


def test_columns_are_aligned_and_the_chosen_row_is_marked():
    lines = table.text(rows()).splitlines()
    figures = [line for line in lines if "parts, " in line or "hull, " in line or "circle" in line][:10]
    assert [line.startswith(">") for line in figures].count(True) == 1
    assert next(line for line in figures if line.startswith(">")).startswith("> parts, 1 px ")
    assert len({len(line) for line in figures}) == 1
    assert all(len(line.replace(", ", ",").split()) >= 6 for line in figures)


def test_the_advice_is_the_cheapest_row_that_is_right():
    found = [row("circle", 24, 5.0), row("hull, 4 vertices", 104, 0.9), row("hull, 6 vertices", 136, 0.4),
             row("parts, 1 px", 250, 0.8, limit=1.0)]
    assert table.advice(found) == "Within 1.00 px for fewer bytes: hull, 4 vertices, 104 bytes instead of 250 (largest error 0.90 px)."


def test_nothing_is_advised_where_all_others_are_dearer_or_wrong():
    found = [row("circle", 24, 5.0), row("parts, 1 px", 250, 0.8, limit=1.0), row("parts, 0.5 px", 300, 0.3),
             Row("hull, 4 vertices", None, "no")]
    assert table.advice(found) == "No other model here is within 1.00 px for fewer than 250 bytes."


def test_a_budget_is_compared_with_the_error_that_it_gives():
    found = chosen(rows(vertices=8))
    assert found.limit == found.figures.largest
