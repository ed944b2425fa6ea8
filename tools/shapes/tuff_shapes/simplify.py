# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# From the border of a picture to an outline with the fewest vertices under a tolerance, or under a budget of vertices.
import numpy as np
import shapely

from .corridor import Corridor
from .crossings import shoelace, touching, without_straight
from .cycles import cheapest_cycle
from .faults import ShapeFault
from .measure import deviation
from .model import Outline

NARROWER = 0.75     # what is left of the radii about a place where the outline crosses itself
BESIDE = 2          # columns to either side of an unfit edge's ends where others are looked at
GROWTH = 1.5        # of the tolerance while a budget is not kept
FINENESS = 1.02     # ratio of two tolerances between which a budget is not looked for any longer
LEAST_TOLERANCE = 0.01      # pixels: what a budget is looked for from
FLOOR = 1e-3        # pixels: radii are not lowered further than this above what the grid allows


def outline(region, tolerance, lattice):
    """The Outline with the fewest vertices that was found within the tolerance (pixels) of a Region's border."""
    if tolerance <= 0:
        return kept_within(region, 0.0, lattice)
    borders = [Border(ring, tolerance, lattice) for ring in region.rings]
    while all(rings := [border.ring() for border in borders]):
        wrong = illegal(borders, rings, lattice)
        if not wrong:
            return Outline(rings[0], rings[1:])
        if not any([border.narrow(places) for border, places in wrong]):
            break
    return kept_within(region, tolerance, lattice)


def outline_with_budget(region, vertices, lattice):
    """The Outline with no more vertices in all its rings than that, and the least tolerance that was found for it."""
    if vertices < 3 * len(region.rings):
        raise ShapeFault(f"{vertices} vertices are not enough for {counted(len(region.rings), 'ring')}: at least {3 * len(region.rings)}")
    known = []
    low, high = bracket(region, vertices)
    while not (found := within_budget(region, high, vertices, lattice, known)):
        if high == most_useful(region):
            raise ShapeFault(f"no outline with {vertices} vertices was found: the least is {min(known, default='none on this grid')}")
        low, high = high, min(high * GROWTH, most_useful(region))
    while high > low * FINENESS:
        middle = (low * high) ** 0.5
        smaller = within_budget(region, middle, vertices, lattice, known)
        low, high, found = (low, middle, smaller) if smaller else (middle, high, found)
    return found


def within_budget(region, tolerance, vertices, lattice, known):
    """The Outline for a tolerance if it keeps the budget, or None; its count is added to the known ones."""
    try:
        result = outline(region, tolerance, lattice)
    except ShapeFault:
        return None
    known.append(sum(map(len, result.rings)))
    return result if known[-1] <= vertices else None


def bracket(region, vertices):
    """(low, high): tolerances to begin with. Douglas and Peucker's outline needs up to four times the tolerance."""
    rings = [shapely.LinearRing(ring) for ring in region.rings]
    low, high = LEAST_TOLERANCE, most_useful(region)
    while high > 1.1 * low:
        middle = (low * high) ** 0.5
        fits = shapely.get_num_coordinates(shapely.simplify(rings, middle)).sum() - len(rings) <= vertices
        low, high = (low, middle) if fits else (middle, high)
    return high / 4, high


def most_useful(region):
    """The tolerance beyond which outline() gives the same for all: no ring's radii are wider."""
    return max(breadth(ring) for ring in region.rings) / 2


def counted(number, noun):
    return f"{number} {noun}{'' if number == 1 else 's'}"


class Border:
    """One ring on its way: corners, the radius that the outline has to pass each within, the last answer."""

    def __init__(self, ring, tolerance, lattice):
        self.corners = ring[:, 0] + 1j * ring[:, 1]
        self.lattice = lattice
        self.radii = np.full(len(ring), float(min(tolerance, breadth(ring) / 2)))
        self.floor = np.minimum(np.abs(spots(lattice, lattice.nearest(ring)) - self.corners) + FLOOR, self.radii)
        self.clockwise = area(self.corners) > 0
        self.answer = None

    def ring(self):
        """The fewest lattice points that follow the border; [] if there are none."""
        if self.answer is None:
            self.answer = fewest(Corridor(self.corners, self.radii, self.lattice))
        return self.answer

    def narrow(self, places=None):
        """Lowers the radii: of all corners, or of those that the outline's points at some places may answer to.

        The widest go first, so that places close to each other do not add up. False if there was nothing to lower.
        """
        wide = self.radii
        for place in [None] if places is None else places:
            lower = slice(None) if place is None else self.answering(place)
            narrower = np.minimum(self.radii[lower], NARROWER * self.radii[lower].max(initial=0))
            wide = wide.copy()
            wide[lower] = np.minimum(wide[lower], np.maximum(narrower, self.floor[lower]))
        changed = bool((wide < self.radii).any())
        self.radii = wide
        self.answer = None if changed else self.answer
        return changed

    def answering(self, place):
        """Which corners end an edge of the border that passes a place within its radius."""
        close = distance_from_edges(self.corners, place) <= np.maximum(self.radii, np.roll(self.radii, -1)) + 1e-6
        return close | np.roll(close, 1)


def breadth(ring):
    """The short side of the smallest rectangle about a ring: with radii of half of it, a line could stand for the ring."""
    corners = shapely.get_coordinates(shapely.oriented_envelope(shapely.multipoints(ring)))
    return float(np.hypot(*np.diff(corners, axis=0).T).min()) if len(corners) > 2 else 0.0


def spots(lattice, steps):
    exact = lattice.pixels(steps)
    return exact[..., 0] + 1j * exact[..., 1]


def area(corners):
    return float((np.conj(corners) * np.roll(corners, -1)).imag.sum()) / 2


def distance_from_edges(corners, point):
    """Distance of a point from each edge of a closed ring."""
    way = np.roll(corners, -1) - corners
    part = ((point - corners) * np.conj(way)).real / np.maximum(np.abs(way) ** 2, 1e-300)
    return np.abs(corners + np.clip(part, 0, 1) * way - point)


def fewest(corridor):
    """The ring of lattice points through a corridor; [] if there is none.

    Edges that the sweep let through wrongly are taken out on the way, and with them those like them beside.
    """
    edges = corridor.edges
    while True:
        path = np.array(cheapest_cycle(edges, corridor.squared_error), dtype=np.int64)
        pairs = np.stack([path, np.roll(path, -1)], axis=1)[:, :, None]
        wrong = [pair for pair in pairs if not corridor.follows(*pair).all()]
        if not wrong:
            return without_straight([tuple(point) for point in corridor.steps.reshape(-1, 2)[path].tolist()])
        edges = edges.without(np.concatenate([unfit_beside(corridor, edges, *pair) for pair in wrong]))


def unfit_beside(corridor, edges, source, target):
    """Places in edges of those that begin and end about where an unfit one does, and do not follow the border either."""
    beside = edges.beside(source, target, BESIDE)
    columns = np.stack([edges.source[beside], edges.target[beside]]) // edges.width
    order = np.lexsort(columns)
    change = np.flatnonzero(np.diff(columns[:, order], axis=1).any(axis=0)) + 1
    groups = np.split(beside[order], change)
    return np.concatenate([group[~corridor.follows(edges.source[group], edges.target[group])] for group in groups])


def illegal(borders, rings, lattice):
    """[(border, places or None for all of it), ...]: what stands in the way of a legal outline."""
    turned = [(border, None) for border, ring in zip(borders, rings) if len(ring) < 3 or (shoelace(ring) > 0) != border.clockwise]
    if turned:
        return turned
    places = [complex(*lattice.pixels(point)) for _, _, point in touching(rings)]
    if places:
        return [(border, places) for border in borders]
    return [] if nested(rings) else [(border, None) for border in borders]


def nested(rings):
    """Whether holes lie in the exterior and outside each other; the rings are known not to touch."""
    return bool(shapely.Polygon(rings[0], rings[1:]).is_valid)


def keep(region, lattice):
    """The Outline with every corner of the border on the nearest lattice point; repeated and straight ones dropped."""
    rings = [without_straight([tuple(point) for point in lattice.nearest(ring).tolist()]) for ring in region.rings]
    for ring, corners in zip(rings, region.rings):
        if len(ring) < 3 or (shoelace(ring) > 0) != (area(corners[:, 0] + 1j * corners[:, 1]) > 0):
            raise ShapeFault(f"nothing is left of a ring at {place(corners[0])} on the grid of {grid(lattice)}: a larger scale keeps it")
    touches = touching(rings)
    if touches:
        raise ShapeFault(f"the outline crosses or touches itself at {place(lattice.pixels(touches[0][2]))} "
                         f"on the grid of {grid(lattice)}: a larger scale may keep it apart")
    return Outline(rings[0], rings[1:])


def kept_within(region, tolerance, lattice):
    result = keep(region, lattice)
    largest = deviation(region, result, lattice).largest
    if largest > tolerance:
        raise ShapeFault(f"the grid of {grid(lattice)} is too coarse for a tolerance of {tolerance:g} px: every corner of the border "
                         f"on its nearest grid point is still {largest:.4g} px off; a larger scale makes the grid finer")
    return result


def grid(lattice):
    return f"1/{lattice.per_unit} unit ({lattice.step:.4g} px)"


def place(point):
    return f"({point[0]:.6g}, {point[1]:.6g})"
