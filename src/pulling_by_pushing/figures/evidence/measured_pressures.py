"""Pressures identified from measured pushes, compared with the true feet."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from planar_pushing.drawing.canvas.axes import schematic, to_axes
from planar_pushing.drawing.canvas.colors import DARK, GRAY, LIGHT, tint
from planar_pushing.drawing.canvas.marks import LINES, NOTE, Picture, Sheet, corners
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.drawing.comparison import LOOKS
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.supports.polygon import Polygon
from pulling_by_pushing.figures.figure import Figure
from pulling_by_pushing.figures.measured import PUSHES_FILE

FIGURE = Figure(
    title="Pressures identified from measured pushes",
    reads=(PUSHES_FILE,),
    size=(PAGE, 4.9),
)
#: Colors of true and of identified quantities, as in the comparison of models.
TRUE, IDENTIFIED = LOOKS["known_feet"].color, LOOKS["identified"].color
#: Radius of a disc for the whole weight, relative to the outline's extent; fraction shown in the key.
FULL, KEY = 0.13, 0.25
#: Side of the frame of the enlarged centers, relative to the outline's extent; largest enlargement.
FRAME, LARGEST = 0.36, 5.0
#: Length of the scale bar, mm; line height of the key and padding around it, points.
BAR, LINE, PAD = 50.0, 18.0, 4.0
#: Starts of the key's entries, as fractions of the figure's width.
STARTS = (0.0, 0.225, 0.475, 0.665)
#: Points of the unit circle.
CIRCLE = direction(np.linspace(0.0, 2 * np.pi, 49))
#: Panel letters.
LETTERS = "abcdefghij"


def logs(data: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Logs of the triangle on three feet and on its face, by name."""
    return {**data["three_feet"]["logs"], **data["patch"]["logs"]}


def reference(log: dict[str, Any]) -> Array:
    """True center of pressure; the centroid of the face for a slider without feet."""
    if log["true_feet"] is None:
        return np.array(Polygon(log["outline"]).center_of_pressure)
    feet = np.array(log["true_feet"])
    return np.asarray(feet[:, 2] @ feet[:, :2] / feet[:, 2].sum())


def caption(data: dict[str, Any]) -> str:
    """Caption of the figure."""
    parts = "; ".join(_panel_phrases(data))
    return (
        "Pressures identified from measured pushes: true feet (rings) and identified points (discs), with "
        "areas proportional to their fractions of the weight; true center of pressure, or centroid of the "
        f"face (cross), and identified center (dot). The frames enlarge both centers {enlargement(data):g} "
        f"times and show 90 percent intervals of the identified center. {parts}."
    )


def _panel_phrases(data: dict[str, Any]) -> Iterator[str]:
    """One phrase for each panel."""
    for letter, log in zip(LETTERS, logs(data).values(), strict=False):
        distance = float(np.hypot(*(log["center_of_pressure"] - reference(log))))
        feet = [f"({x:g}, {y:g})" for x, y, _ in log["true_feet"] or ()]
        base = f"feet at {', '.join(feet)} mm" if feet else "on the whole face"
        spin = f"{log['spin_torque']:.0f}"
        if log["true_spin_torque"] is not None:
            spin += f" (true: {log['true_spin_torque']:.0f})"
        yield (
            f"({letter}) {base}, {log['pushes']} pushes: centers {distance:.1f} mm apart, mean distance "
            f"from the center {spin} mm"
        )


def draw(figure: Any, data: dict[str, Any]) -> None:
    """Draw a panel for each log in a row and, below the panels, a key to the marks."""
    panels, zoom = list(logs(data).values()), enlargement(data)
    wide = 72 * figure.get_figwidth()
    count, side, key = len(panels), wide / len(panels), LINE + 2 * PAD
    high = side + key
    figure.set_figheight(high / 72)
    for column, (letter, log) in enumerate(zip(LETTERS, panels, strict=False)):
        ax = schematic(figure, (column / count, (high - side) / high, 1 / count, side / high))
        sheet = to_axes(_picture(log, letter, zoom), ax, _box(log), PAD)
    key_sheet = Sheet.around(np.array([(0, 0), (wide, key)]), (wide, key), 0.0)
    picture = _key(wide, FULL * _extent(panels[-1]) * sheet.scale, sheet.scale)
    to_axes(picture, schematic(figure, (0.0, 0.0, 1.0, key / high)), key_sheet.box, 0.0)


def _extent(log: dict[str, Any]) -> float:
    return float(np.ptp(log["outline"], axis=0).max())


def _box(log: dict[str, Any]) -> Array:
    """Corners of the area that a panel shows: the outline with room for rings at its edge."""
    return corners([log["outline"]], 0.06 * _extent(log))


def _picture(log: dict[str, Any], letter: str, zoom: float) -> Picture:
    """Picture of a log: outline, feet, identified points, and centers of pressure."""
    picture, outline = Picture(), np.array(log["outline"])
    picture.area(outline, color="#F4F4F4")
    picture.line(np.vstack([outline, outline[:1]]), GRAY, width=0.8)
    full = FULL * _extent(log)
    for x, y, fraction in log["support"]:
        add_disc(picture, (x, y), full * np.sqrt(fraction))
    for x, y, fraction in log["true_feet"] or ():
        add_ring(picture, (x, y), full * np.sqrt(fraction))
    true, identified = reference(log), np.array(log["center_of_pressure"])
    add_true(picture, true)
    add_identified(picture, identified)
    _add_enlarged(picture, log, zoom)
    low, high = _window(log)
    picture.label((low[0] - 0.08 * _extent(log), high[1]), f"({letter})", color=DARK, held=True)
    return picture


def _window(log: dict[str, Any]) -> Array:
    """Corners of the frame with the enlarged centers, at the upper right of a panel."""
    high = np.max(log["outline"], axis=0) - 0.01 * _extent(log)
    return np.array([high - FRAME * _extent(log), high])


def enlargement(data: dict[str, Any]) -> float:
    """Enlargement at which all centers and their intervals fit into a frame."""
    return min(LARGEST, *(float(np.floor(_fitting(log))) for log in logs(data).values()))


def _fitting(log: dict[str, Any]) -> float:
    true, identified = reference(log), np.array(log["center_of_pressure"])
    reach = np.abs(np.vstack([true, identified, _bounds(log).T]) - (true + identified) / 2).max()
    return float(0.45 * FRAME * _extent(log) / max(reach, 1e-9))


def _add_enlarged(picture: Picture, log: dict[str, Any], zoom: float) -> None:
    """Add the centers of pressure in a frame, enlarged about their midpoint."""
    low, high = window = _window(log)
    picture.line([low, (high[0], low[1]), high, (low[0], high[1]), low], LIGHT, width=0.6)
    true, identified = reference(log), np.array(log["center_of_pressure"])
    middle, onto = (true + identified) / 2, window.mean(axis=0)
    there, here = (onto + zoom * (center - middle) for center in (true, identified))
    picture.line([there, here], GRAY, width=0.6, order=LINES + 1.0)
    add_true(picture, there)
    ends = onto[:, None] + zoom * (_bounds(log) - middle[:, None])
    for axis, bounds in enumerate(ends):
        bar = np.tile(here, (2, 1))
        bar[:, axis] = bounds
        picture.line(bar, IDENTIFIED, width=0.9, order=LINES + 1.5)
    add_identified(picture, here)


def _bounds(log: dict[str, Any]) -> Array:
    """Intervals of the identified center along x and y, shape (2, 2)."""
    names = ("center_of_pressure_x", "center_of_pressure_y")
    return np.array([log["intervals"][name] for name in names], dtype=float)


def add_disc(picture: Picture, center: Any, radius: float) -> None:
    """Add the disc of an identified point."""
    rim = np.asarray(center) + radius * CIRCLE
    picture.area(rim, color=tint(IDENTIFIED, 0.45), order=1.0)
    picture.line(rim, IDENTIFIED, width=0.6, order=1.1)


def add_ring(picture: Picture, center: Any, radius: float) -> None:
    """Add the ring of a true foot."""
    rim = np.asarray(center) + radius * CIRCLE
    picture.line(rim, TRUE, width=1.5, order=LINES + 0.5)


def add_true(picture: Picture, center: Any) -> None:
    """Add the cross of the true center of pressure."""
    picture.dot(center, 6.0, "#FFFFFF", edge=TRUE, width=0.8, shape="pressure", order=LINES + 1.4)


def add_identified(picture: Picture, center: Any) -> None:
    """Add the dot of the identified center of pressure."""
    picture.dot(center, 2.6, IDENTIFIED, order=LINES + 1.6)


def _key(wide: float, full: float, scale: float) -> Picture:
    """Key of marks and names in a line of a width in points; `scale` is points per mm."""
    names = ("true foot, 25% of the weight", "identified point, 25% of the weight",
             "true center of pressure", "identified center, 90% intervals")  # fmt: skip
    centers = [np.array([PAD + 9.0 + wide * start, PAD + LINE / 2]) for start in STARTS]
    picture, radius = Picture(), full * np.sqrt(KEY)
    add_ring(picture, centers[0], radius)
    add_disc(picture, centers[1], radius)
    add_true(picture, centers[2])
    for axis in np.eye(2):
        bar = centers[3] + 5.0 * np.outer([-1, 1], axis)
        picture.line(bar, IDENTIFIED, width=0.9, order=LINES + 1.5)
    add_identified(picture, centers[3])
    for center, name in zip(centers, names, strict=True):
        picture.label(
            center + np.array([10.0, 0.0]), name, size=NOTE, align="left", color=DARK, held=True
        )
    picture.scale_bar((wide - PAD - BAR * scale, PAD + 0.15 * LINE), BAR * scale, f"{BAR:g} mm")
    return picture
