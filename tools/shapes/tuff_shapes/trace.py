# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# From a mask of solid pixels to Regions: rings along the pixels' borders, specks dropped, and the points where
# borders touch at a corner cut back, so that every ring is simple and no two rings meet.
from typing import NamedTuple

import numpy as np
from rasterio.features import shapes

from .faults import ShapeFault
from .model import Region

CHAMFER = 0.25          # pixels; half an edge would let the cuts at both ends of a pixel's side meet
MOST_CORNERS = 1 << 19  # of a mask's border: seconds, and under a gigabyte; a drawn outline has thousands even at 4096 x 4096
NAMED = 3               # specks or holes named by size and place in a note


class NothingLeft(ShapeFault):
    """Every island is a speck; in a sheet this is no fault of the others."""


class _Island(NamedTuple):
    rings: list      # the exterior, then the holes
    size: int        # pixels inside
    filled: list     # (size, ring) of the holes that were too small


def regions(mask, specks, journal, place):
    """The islands of a mask (bool, rows by columns), 4-connected, without islands and holes smaller than specks pixels."""
    mask = np.asarray(mask, dtype=bool)
    if not mask.any():
        raise ShapeFault("nothing is solid", place)
    _refuse_noise(mask, place)
    islands = _without_specks([_without_small_holes(rings, specks) for rings in _traced(mask)], specks, journal, place)
    pinched = _pinched(islands, mask.shape[1] + 1, journal, place)
    cut = map(_chamfer, (ring for island in islands for ring in island.rings), pinched)
    found = [Region(next(cut), [next(cut) for _ in island.rings[1:]]) for island in islands]
    return sorted(found, key=lambda region: _first_point(region.exterior))


def _refuse_noise(mask, place):
    """A checkerboard of 4096 x 4096 would be eight million islands."""
    padded = np.pad(mask, 1)
    upper, lower = padded[:-1], padded[1:]
    odd = upper[:, :-1] ^ upper[:, 1:] ^ lower[:, :-1] ^ lower[:, 1:]
    checkered = (upper[:, :-1] == lower[:, 1:]) & (upper[:, 1:] == lower[:, :-1]) & (upper[:, :-1] != upper[:, 1:])
    corners = int(np.count_nonzero(odd)) + int(np.count_nonzero(checkered))
    if corners > MOST_CORNERS:
        raise ShapeFault(f"the border has {corners} corners, at most {MOST_CORNERS} are traced: this is noise, not an outline", place)


def _traced(mask):
    """Lists of rings (int64), the exterior first. GDAL runs every ring the other way round than model.py asks."""
    pixels = mask.astype(np.uint8)
    return [[np.array(ring[:0:-1], dtype=np.int64) for ring in shape["coordinates"]]
            for shape, _ in shapes(pixels, mask=pixels, connectivity=4)]


def _area(ring):
    """Pixels enclosed: positive for exteriors, negative for holes. Exact: twice the area is an integer far below 2^63."""
    x, y = ring[:, 0], ring[:, 1]
    return int(x[:-1] @ y[1:] - x[1:] @ y[:-1] + x[-1] * y[0] - x[0] * y[-1]) // 2


def _first_point(ring):
    """(y, x) of the first point in reading order."""
    y = ring[:, 1].min()
    return y, ring[ring[:, 1] == y, 0].min()


def _count(number, noun):
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def _listing(found):
    """The largest few of (size, ring), by size and place."""
    named = [(size, *_first_point(ring)) for size, ring in sorted(found, key=lambda item: -item[0])[:NAMED]]
    return ", ".join(f"{size} px at ({x}, {y})" for size, y, x in named) + (", ..." if len(found) > NAMED else "")


def _without_small_holes(rings, specks):
    """An island inside a hole that is filled is smaller than the hole, and is about to be dropped as a speck."""
    areas = [_area(ring) for ring in rings]
    small = [-specks < area < 0 for area in areas]
    return _Island([ring for ring, is_small in zip(rings, small) if not is_small],
                   sum(area for area, is_small in zip(areas, small) if not is_small),
                   [(-area, ring) for ring, area, is_small in zip(rings, areas, small) if is_small])


def _without_specks(islands, specks, journal, place):
    kept = [island for island in islands if island.size >= specks]
    if not kept:
        raise NothingLeft(f"nothing is left: the largest of {_count(len(islands), 'island')} has "
                          f"{max(island.size for island in islands)} px; those below {specks} px are dropped (see --specks)", place)
    small = [(island.size, island.rings[0]) for island in islands if island.size < specks]
    if small:
        journal.note(f"{_count(len(small), 'speck')} below {specks} px dropped: {_listing(small)}", place)
    filled = [hole for island in kept for hole in island.filled]
    if filled:
        journal.note(f"{_count(len(filled), 'hole')} below {specks} px filled: {_listing(filled)}", place)
    return kept


def _pinched(islands, pitch, journal, place):
    """For every ring of every island, which of its points are passed twice; notes those where two islands touch."""
    keys = [ring @ [1, pitch] for island in islands for ring in island.rings]
    lengths = [len(ring) for ring in keys]
    owners = np.repeat([i for i, island in enumerate(islands) for _ in island.rings], lengths)
    keys = np.concatenate(keys)
    order = np.argsort(keys, kind="stable")
    first = np.flatnonzero(keys[order[1:]] == keys[order[:-1]])
    one, other = order[first], order[first + 1]
    _note_touching(keys[one[owners[one] != owners[other]]], pitch, journal, place)
    pinched = np.zeros(len(keys), dtype=bool)
    pinched[one] = pinched[other] = True
    return np.split(pinched, np.cumsum(lengths)[:-1])


def _note_touching(keys, pitch, journal, place):
    if len(keys):
        y, x = divmod(int(keys[0]), pitch)
        journal.note(f"islands touch at {_count(len(keys), 'corner')}, first at ({x}, {y}); they are kept apart", place)


def _chamfer(ring, pinched):
    """Where pinched, a corner's tip is cut off. Of the four quadrants about a point that is passed twice, each pass turns in
    one, and the two are opposite each other: two islands part, one island that touches itself stays joined."""
    if not pinched.any():
        return ring.astype(np.float64)
    reach = CHAMFER * pinched[:, None]
    before = ring - reach * np.sign(ring - np.roll(ring, 1, axis=0))
    after = ring + reach * np.sign(np.roll(ring, -1, axis=0) - ring)
    return np.stack([before, after], axis=1)[np.stack([np.ones_like(pinched), pinched], axis=1)]
