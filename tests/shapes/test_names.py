# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Names in C from whatever files and objects are called.
import pytest
from tuff_shapes import names
from tuff_shapes.faults import ShapeFault


@pytest.mark.parametrize("path, name", [
    ("art/rock.png", "rock"), ("Big Rock-2.png", "big_rock_2"), ("3rocks.png", "shape_3rocks"), ("floor.png", "floor_shape"),
    ("int.png", "int_shape"), ("New.png", "new_shape"), ("tuff_terrain.png", "shape_tuff_terrain"), ("rock.small.png", "rock_small"),
    ("_x_.png", "x"), ("caf\u00e9.png", "caf"), ("main.png", "main_shape")])
def test_a_file_gives_an_identifier(path, name):
    assert names.base(path) == name


def test_the_author_may_name_it():
    assert names.base("7.png", "Crate") == "crate"


def test_a_name_survives_being_cleaned_again():
    assert names.base(names.base("floor.png")) == "floor_shape"


def test_a_file_without_a_letter_is_refused():
    with pytest.raises(ShapeFault, match="--name"):
        names.base("\u5ca9.png")


def test_nothing_is_declared_twice():
    taken = names.Names()
    wishes = ["a", "a", "a_parts", "a_2", "b"]
    claimed = [taken.claim(wish, ("", "_parts")) for wish in wishes]
    declared = [name + ending for name in claimed for ending in ("", "_parts")]
    assert claimed[:2] == ["a", "a_2"] and len(set(declared)) == len(declared)
