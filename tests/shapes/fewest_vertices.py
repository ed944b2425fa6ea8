# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The fewest vertices of an outline by exhaustive search: candidates are all points of a grid within the tolerance of a
# place on the border, every edge between them is tried. Slow and plain, and nothing is taken from the tool.
import numpy as np

PITCH = 0.25      # pixels between candidates


def fewest_vertices(ring, tolerance):
    """Least number of edges, 3 or more, of a closed path that follows a border. It may cross itself: a lower bound then."""
    border = (ring[:, 0] + 1j * ring[:, 1]).astype(np.complex128)
    places = along(border)
    spots = [around(place, tolerance) for place in places]
    first = np.concatenate([[0], np.cumsum([len(spot) for spot in spots])])
    onward, home = np.zeros((2, first[-1], first[-1]), dtype=np.float32)
    for i in range(len(places)):
        for j in range(len(places)):
            if i != j:
                between = places[(i + 1 + np.arange((j - i - 1) % len(places))) % len(places)]
                edges = follow(spots[i][:, None], spots[j][None, :], between, tolerance)
                (onward if i < j else home)[first[i]:first[i + 1], first[j]:first[j + 1]] = edges
    reached, edges = onward, 2
    while True:
        if edges >= 3 and (reached * home.T).any():
            return edges
        reached, edges = np.minimum(reached @ onward, 1), edges + 1


def along(border):
    """Corners and the middles of edges longer than a pixel."""
    places = []
    for start, end in zip(border, np.roll(border, -1)):
        count = max(1, round(abs(end - start)))
        places += [start + (end - start) * i / count for i in range(count)]
    return np.array(places)


def around(place, tolerance):
    reach = np.arange(-np.ceil(tolerance / PITCH), np.ceil(tolerance / PITCH) + 1) * PITCH
    offsets = (reach[:, None] + 1j * reach[None, :]).ravel()
    origin = np.round(place.real / PITCH) * PITCH + 1j * np.round(place.imag / PITCH) * PITCH
    spots = origin + offsets
    return spots[np.abs(spots - place) <= tolerance + 1e-9]


def follow(start, end, between, tolerance):
    """Whether edges pass the places between within the tolerance, one after the other."""
    way = end - start
    length = np.maximum(np.abs(way), 1e-12)
    passed = np.zeros(way.shape)
    good = np.abs(way) > 1e-9
    for place in between:
        local = (place - start) * np.conj(way) / length
        good &= np.abs(local.imag) <= tolerance + 1e-9
        half = np.sqrt(np.maximum(tolerance ** 2 - local.imag ** 2, 0))
        passed = np.maximum(passed, local.real - half)
        good &= passed <= np.minimum(local.real + half, length) + 1e-9
    return good
