"""Supports as the figures draw them: their drawings are read off, not drawn a second time."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.path import Path
from matplotlib.transforms import Affine2D

from planar_pushing.explore.pictures.columns import Marks
from planar_pushing.figures.parts.bodies import NAMES, SIGNS, Body
from planar_pushing.figures.parts.supports import Ink, Pose, draw_support
from planar_pushing.figures.style import DARK
from planar_pushing.mechanics.plane import Array

#: Pixels of the page for a point of the figures, which are smaller.
PIXELS = 1.7
#: Curves are cut into straight pieces as on a picture of this many pixels across.
FINE = 600.0


class Piece(NamedTuple):
    """A mark of a drawing in the body frame: an area where it has a fill, else a line; or a dot."""

    rings: tuple[Array, ...]
    fill: str
    line: str
    width: float
    order: float
    dot: float


@lru_cache(maxsize=32)
def pieces(support: Any, ink: Ink) -> tuple[Piece, ...]:
    """The drawing of a support at the origin of its body frame, in the order in which it is drawn."""
    ax = Figure().add_axes((0, 0, 1, 1))
    draw_support(ax, support, Pose((0.0, 0.0), 0.0), ink)
    found = [piece for artist in _artists(ax) for piece in _read(artist, FINE / support.extent)]
    return tuple(sorted(found, key=lambda each: each.order))


def _hex(color: Any) -> str:
    """One of matplotlib's colors as the page has it."""
    return str(to_hex(color))


def _artists(ax: Axes) -> list[Any]:
    return [*ax.collections, *ax.patches, *ax.lines]


def _read(artist: Any, fine: float) -> list[Piece]:
    """The pieces of one of matplotlib's artists, whose coordinates are those of the body."""
    order = float(artist.get_zorder())
    if isinstance(artist, Line2D):
        return [_line(artist, order)]
    if isinstance(artist, PolyCollection):
        faces = artist.get_facecolor()
        rings = [np.asarray(path.vertices) for path in artist.get_paths()]
        return [
            Piece((ring,), _hex(face), _hex(face), 0.0, order, 0.0)
            for ring, face in zip(rings, faces, strict=True)
        ]
    return [_patch(artist, order, fine)]


def _line(line: Line2D, order: float) -> Piece:
    points, color = np.asarray(line.get_xydata(), dtype=float), _hex(line.get_color())
    if line.get_marker() in ("o",):
        fill, edge = _hex(line.get_markerfacecolor()), _hex(line.get_markeredgecolor())
        return Piece((points,), fill, edge, 1.0, order, PIXELS * float(line.get_markersize()))
    return Piece((points,), "", color, PIXELS * float(line.get_linewidth()), order, 0.0)


def _patch(patch: Patch, order: float, fine: float) -> Piece:
    path = patch.get_patch_transform().transform_path(patch.get_path())
    rings = _rings(path, fine)
    width = PIXELS * float(patch.get_linewidth())
    if patch.get_fill():
        return Piece(
            rings, _hex(patch.get_facecolor()), _hex(patch.get_facecolor()), 0.0, order, 0.0
        )
    return Piece(rings, "", _hex(patch.get_edgecolor()), width, order, 0.0)


def _rings(path: Path, fine: float) -> tuple[Array, ...]:
    large = Affine2D().scale(fine).transform_path(path)
    return tuple(np.asarray(each) / fine for each in large.to_polygons(closed_only=False))


def add_support(marks: Marks, body: Body, pose: Pose, ink: Ink) -> None:
    """Add a support in its place."""
    for piece in pieces(body.support, ink):
        rings = [pose.at(ring) for ring in piece.rings]
        if piece.dot:
            marks.dot(rings[0][0], piece.dot, piece.fill, piece.line)
        elif piece.fill:
            marks.area(rings, piece.fill)
        else:
            for ring in rings:
                marks.line(ring, piece.line, piece.width)


def add_centers(marks: Marks, body: Body, pose: Pose) -> None:
    """Add the signs of the centers of pressure and of mass, where they are apart, and their names."""
    for name, place in body.centers:
        at = pose.at(place)
        for sign in SIGNS[name](DARK):
            marker = {"P": "plus", "o": "circle"}.get(str(sign["marker"]), "circle_dot")
            fill = sign["mfc"] if marker != "circle_dot" else None
            marks.dot(at, PIXELS * sign["markersize"], fill, DARK, marker)
        marks.label(at, NAMES[name].replace("\n", " "), DARK, (0.0, -16.0))
