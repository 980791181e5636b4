"""The limit curve of a scene around its contact: forces to the scale of the solution's force."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from planar_pushing.figures.parts.sketch import Sketch
from planar_pushing.figures.style import CENTER, FORCE

#: Motions whose angles differ by less, degrees, are one motion: a pivot, a flat of the curve.
ALIKE = 1e-7


def limit_curve(ax: Axes, sketch: Sketch) -> None:
    """The curve, heavier along its flats, where one pivot belongs to an interval of forces."""
    curve, motion = sketch.curve, sketch.data["limit_motion_angle"].values
    ax.plot(*curve.T, color=FORCE, linewidth=0.9, zorder=2.4)
    flat = np.concatenate([[False], np.abs(np.diff(motion)) < ALIKE, [False]])
    turns = np.flatnonzero(flat[1:] != flat[:-1])
    for start, stop in turns.reshape(-1, 2):
        ax.plot(*curve[start : stop + 1].T, color=CENTER, linewidth=2.4, zorder=2.5)
