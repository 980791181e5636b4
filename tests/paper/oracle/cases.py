"""Supports of every kind as scene files say them, and centers of rotation inside, near and far."""

SQUARE = {"shape": "polygon", "vertices": [(-1, -1), (1, -1), (1, 1), (-1, 1)]}
TRIPOD = {
    "shape": "points",
    "positions": [(1, 0), (-0.5, 0.75**0.5), (-0.5, -(0.75**0.5))],
    "weights": [1, 1, 1],
}
MAP = {
    "shape": "pressure_map",
    "x": [-1, 0, 0.3, 1],
    "y": [-1, -0.5, 0.4],
    "pressure": [[1.0, 0.0, 2.0], [0.5, 3.0, 1e-3]],
}
SUPPORTS = {
    "ring": {"shape": "ring"},
    "points": TRIPOD,
    "segment": {"shape": "segment", "start": (-0.3, -1), "end": (0.4, 1.2)},
    "disc": {"shape": "disc", "radius": 0.7, "center": (0.3, -0.2)},
    "annulus": {"shape": "annulus", "inner": 0.5, "outer": 1, "center": (0.1, 0.2)},
    "square": SQUARE,
    "triangle": {"shape": "polygon", "vertices": [(0, 0), (3, 0.1), (1, 1)]},
    "clockwise": {"shape": "polygon", "vertices": [(0, 0), (1, 1), (3, 0.1)]},
    "L": {"shape": "polygon", "vertices": [(0, 0), (2, 0), (2, 0.5), (0.5, 0.5), (0.5, 2), (0, 2)]},
    "frame": {
        "shape": "polygon",
        "vertices": [(-1, -1), (1.2, -1), (1, 1), (-0.9, 0.7)],
        "holes": [
            [(-0.7, -0.8), (0.2, -0.6), (-0.6, 0.3)],
            [(0.3, 0.4), (0.5, 0.6), (0.7, 0.1), (0.4, 0.0)],
        ],
    },
    "map": MAP,
    "composite": {
        "shape": "composite",
        "members": [
            {"share": 1, "support": {"shape": "disc", "radius": 0.5, "center": (1, 0)}},
            {"share": 2, "support": SQUARE},
            {"share": 0.5, "support": TRIPOD},
        ],
    },
}
CENTERS = [(0.3, 0.2), (1.5, -0.7), (-0.2, 0.9), (30.0, 4.0)]
