"""Supports of every kind, and centers of rotation where they are hard."""

from __future__ import annotations

import numpy as np

from planar_pushing.core.supports.piece_rows import COLUMNS, PressureHead
from planar_pushing.mechanics.supports.annulus import Annulus
from planar_pushing.mechanics.supports.composite import Composite
from planar_pushing.mechanics.supports.disc import Disc
from planar_pushing.mechanics.supports.even_ring import Ring
from planar_pushing.mechanics.supports.points import Points
from planar_pushing.mechanics.supports.polygon import Polygon
from planar_pushing.mechanics.supports.pressure_map import PressureMap
from planar_pushing.mechanics.supports.segment import Segment


def rows_of(table, kind):
    """Rows of one kind of pieces but edges, by the name of their place in the head of a pressure."""
    place = PressureHead.places[kind]
    first, last = table.head.numbers[0, place : place + 2].astype(int)
    return table.data[first:last].reshape(-1, COLUMNS)


def rectangle(half_length, half_width):
    a, b = half_length, half_width
    return Polygon([(-a, -b), (a, -b), (a, b), (-a, b)])


def regular(count, radius=1.0):
    angles = 2 * np.pi * np.arange(count) / count
    return radius * np.column_stack([np.cos(angles), np.sin(angles)])


SQUARE = rectangle(1.0, 1.0)
TRIPOD = Points([(1.0, 0.0), (-0.5, np.sqrt(3) / 2), (-0.5, -np.sqrt(3) / 2)], [1.0, 1.0, 1.0])
STAR = Polygon(regular(14) * np.where(np.arange(14) % 2, 0.4, 1.6)[:, None])
#: A polygon with two holes, which turn either way.
FRAME = Polygon(
    [(-1, -1), (1.2, -1), (1, 1), (-0.9, 0.7)],
    [[(-0.7, -0.8), (0.2, -0.6), (-0.6, 0.3)], [(0.3, 0.4), (0.5, 0.6), (0.7, 0.1), (0.4, 0.0)]],
)
#: A map with one loaded cell and a trace of pressure in two corners.
PEAK = np.zeros((8, 8))
PEAK[1, 2], PEAK[0, 0], PEAK[7, 7] = 1.0, 1e-6, 1e-6
#: Of each support its aspect ratio, by which its errors may grow above 20.
SUPPORTS = {
    "points": (Points([(1.0, 0.0), (-0.5, 0.8), (-0.5, -0.9)], [1.0, 2.0, 3.0]), 1),
    "segment": (Segment((-0.3, -1.0), (0.4, 1.2)), 1),
    "ring": (Ring(1.3), 1),
    "disc": (Disc(0.7, (0.3, -0.2)), 1),
    "annulus": (Annulus(0.5, 1.0), 1),
    "narrow annulus": (Annulus(0.95, 1.0, (0.1, 0.2)), 1),
    "square": (SQUARE, 1),
    "triangle": (Polygon([(0.0, 0.0), (1.0, 1.0), (3.0, 0.1)]), 1),
    "L": (Polygon([(0, 0), (2, 0), (2, 0.5), (0.5, 0.5), (0.5, 2), (0, 2)]), 1),
    "star": (STAR, 1),
    "frame": (FRAME, 1),
    "20:1": (rectangle(2.0, 0.1), 20),
    "100:1": (rectangle(2.0, 0.02), 100),
    "map": (PressureMap([-1, 0, 0.3, 1], [-1, -0.5, 0.4], [[1.0, 0.0, 2.0], [0.5, 3.0, 1e-3]]), 1),
    "peak": (PressureMap(np.linspace(-1, 1, 9), np.linspace(-1, 1, 9), PEAK), 1),
    "composite": (
        Composite(
            [
                (1, Disc(0.5, (1.0, 0.0))),
                (2, rectangle(0.3, 0.4)),
                (0.5, Points([(-1.0, -1.0)], [1.0])),
                (1, Segment((-1.0, 1.0), (0.0, 1.5))),
                (1, Composite([(1, Annulus(0.2, 0.4, (0.0, -1.0))), (2, Ring(0.5))])),
            ]
        ),
        1,
    ),
}


def turned(angle):
    return np.array([np.cos(angle), np.sin(angle)])


def special_places(support):
    """Atoms, ends, vertices, places on edges and on their lines, rims and centers."""
    pieces = support.pieces()
    found = [np.array(support.center_of_pressure), *pieces.atoms[:, :2]]
    for rows in (pieces.segments, *pieces.plates):
        start, end = rows[:, :2], rows[:, 2:4]
        found += [
            *start,
            *end,
            *((start + end) / 2),
            *(2 * end - start),
            *(0.3 * start + 0.7 * end),
        ]
    for x, y, radius, _ in np.concatenate([pieces.rings, pieces.discs]):
        found += [np.array([x, y]), np.array([x + radius, y]), (x, y) + radius * turned(2.0)]
    return np.array(found)


def hard_centers(support, count, seed=1):
    """Special places, places next to them, and places from inside to 1e9 extents away."""
    random = np.random.default_rng(seed)
    middle, size = np.array(support.center_of_pressure), support.extent
    places = special_places(support)
    places = places[random.permutation(len(places))[:count]]
    gaps = 10 ** random.uniform(-15, -1, len(places))
    beside = [
        place + size * gap * turned(random.uniform(0, 2 * np.pi))
        for place, gap in zip(places, gaps, strict=True)
    ]
    ranges = [(0, 3), (1.5, 1.9), (3.8, 4.2)]
    distances = [random.uniform(*limits, count // 2) for limits in ranges]
    distances = np.concatenate([*distances, 10 ** random.uniform(0, 9, count // 2)])
    around = [middle + size * r * turned(random.uniform(0, 2 * np.pi)) for r in distances]
    across = [middle + size * r * turned(np.pi / 2) for r in random.uniform(1.2, 2.0, count // 4)]
    return np.array([*places, *beside, *around, *across])
