# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Normals against arithmetic of 60 digits: each component is the number nearest to the true one, in both builds.
import random
from decimal import Decimal, getcontext

import numpy as np
import pytest
from tuff_shapes import normals

getcontext().prec = 60
SEED = 20261


def true_component(x, y):
    return Decimal(x) / Decimal(x * x + y * y).sqrt()


def vectors():
    """Short, long, and nearly level; every one as far as an edge can reach, and 2^13 steps a unit."""
    rng = random.Random(SEED)
    far = 2048 * 8192
    for reach in (3, 40, 1000, 131072, far):
        for _ in range(1500):
            yield rng.randint(-reach, reach), rng.randint(1, reach)
    for _ in range(500):
        yield rng.randint(-3, 3), rng.randint(far // 2, far)


def is_nearest_float(value, true):
    """Its neighbors are no closer."""
    single = np.float32(value)
    error = abs(Decimal(float(single)) - true)
    return all(error < abs(Decimal(float(np.nextafter(single, np.float32(side)))) - true) for side in (-2, 2))


@pytest.mark.parametrize("turn", range(4))
def test_each_component_is_the_nearest_number(turn):
    for x, y in vectors():
        for _ in range(turn):
            x, y = -y, x
        square, true = x * x + y * y, true_component(x, y)
        again = f"seed {SEED}: normals.fixed({x}, {square}), normals.single({x}, {square})"
        assert abs(normals.fixed(x, square) - true * 2 ** 30) <= Decimal("0.5"), again
        if x:
            assert is_nearest_float(normals.single(x, square), true), again


def test_the_literal_is_the_float():
    for x, y in vectors():
        value = normals.single(x, x * x + y * y)
        assert float(np.float32(normals.literal(value)[:-1])) == value, (x, y)


@pytest.mark.parametrize("x, y, expected", [
    (5, 0, "{ TUFF_UNIT_EITHER(1073741824, 1.0f), TUFF_UNIT_EITHER(0, 0.0f) }"),
    (-1, 0, "{ TUFF_UNIT_EITHER(-1073741824, -1.0f), TUFF_UNIT_EITHER(0, 0.0f) }"),
    (0, 131072, "{ TUFF_UNIT_EITHER(0, 0.0f), TUFF_UNIT_EITHER(1073741824, 1.0f) }"),
    (0, -7, "{ TUFF_UNIT_EITHER(0, 0.0f), TUFF_UNIT_EITHER(-1073741824, -1.0f) }"),
    (3, -4, "{ TUFF_UNIT_EITHER(644245094, 0.600000024f), TUFF_UNIT_EITHER(-858993459, -0.800000012f) }")])
def test_level_and_upright_edges_are_exact(x, y, expected):
    assert normals.text(x, y) == expected
