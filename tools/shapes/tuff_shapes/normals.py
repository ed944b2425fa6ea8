# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Unit normals, right to the last bit of both builds: integers only, rounded once.
#
# A component c = a / sqrt(a^2 + b^2) is rounded by floor(2 |c| 2^s) = isqrt(floor(a^2 4^(s + 1) / (a^2 + b^2))), then (that + 1) / 2.
# Ties do not occur: a c that is a fraction of a power of two is 0 or +-1, for a^2 + b^2 = 4^k has no other solution in integers
# without a common factor.
from math import isqrt, ldexp

UNIT_BITS = 30      # tuff_unit of the fixed build: Q2.30
FLOAT_BITS = 24     # significant bits of a float


def doubled(component, square, shift):
    """floor(2 * 2^shift * |component| / sqrt(square))."""
    return isqrt((component * component << 2 * shift + 2) // square)


def fixed(component, square):
    """component / sqrt(square) in steps of 2^-30, to nearest."""
    magnitude = (doubled(component, square, UNIT_BITS) + 1) >> 1
    return -magnitude if component < 0 else magnitude


def single(component, square):
    """component / sqrt(square) to the nearest float. A float of Python's holds it exactly."""
    if component == 0:
        return 0.0
    shift = FLOAT_BITS - 1
    while doubled(component, square, shift).bit_length() <= FLOAT_BITS:
        shift += 1
    magnitude = ldexp((doubled(component, square, shift) + 1) >> 1, -shift)
    return -magnitude if component < 0 else magnitude


def literal(value):
    """A float constant of C. Nine digits tell any two floats apart, and are far from the middle of two."""
    digits = f"{value:.9g}"
    return f"{digits}f" if "." in digits or "e" in digits else f"{digits}.0f"


def component_text(component, square):
    return f"TUFF_UNIT_EITHER({fixed(component, square)}, {literal(single(component, square))})"


def text(x, y):
    """The initializer of a tuff_unit2 along the vector (x, y) of whole numbers."""
    square = x * x + y * y
    return f"{{ {component_text(x, square)}, {component_text(y, square)} }}"
