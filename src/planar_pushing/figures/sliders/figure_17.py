"""Figure 17: how much friction pulling takes."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from planar_pushing.figures.parts.curves import named, titled
from planar_pushing.figures.settings import Sources
from planar_pushing.figures.sliders.gallery import sustaining
from planar_pushing.figures.sliders.over_rods import ANGLES, LENGTHS, over_rods, panels
from planar_pushing.figures.style import DARK, GREY, NOTE_SIZE
from planar_pushing.mechanics.contact import PerfectlyRough
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.study.files.study_model import SliderEntry

#: A force this close to the fence, radians, needs infinite friction.
ALONG_FENCE = 1e-12
#: Coefficients of friction that name their angles.
TICKS = np.array([0.5, 1, 1.5, 2, 3, 5, 10, np.inf])
#: A step of the angle of friction between two samples, degrees, that is a jump.
JUMP = 8.0
#: Lowest angle of friction in a panel, degrees.
LOWEST = {"rod_length": 42.0, "rod_angle": 22.0}
LEAST = "smallest coefficient of friction with which the contact can pull; infinite where none can"


def pulling_friction(scenes: Scene) -> xr.DataArray:
    """Smallest coefficient of friction with which pulling exists; infinite where it never does.

    The map from force to motion increases, so the motion cone reaches below the fence on its right as soon
    as the friction cone holds a force beyond all those that sustain the motion along the fence to the
    right; on its left likewise.
    """
    right, left = sustaining(scenes, 0.0)[0], -sustaining(scenes, np.pi)[1]
    steeper = right.where(right > left, left)
    friction = cast(xr.DataArray, 1 / np.tan(steeper))
    return friction.where(steeper > ALONG_FENCE, np.inf)


def inertia_friction(length: Array, angle: Array) -> Array:
    """The same of a ring with inertia alone, its radius of gyration its radius; 1 + 2/l^2 at 45 degrees.

    By Eqs. (11)-(13): the force that moves the contact along the fence.
    """
    c, s = np.cos(np.deg2rad(angle)), np.sin(np.deg2rad(angle))
    with np.errstate(divide="ignore"):
        return np.asarray((1 + (length * c) ** 2) / np.abs(length**2 * s * c))


def select(sources: Sources, settings: SliderEntry) -> xr.Dataset:
    """Compute the least friction over rod length and over rod angle, and the law of inertia."""
    data = over_rods(sources["supports"], settings, PerfectlyRough(), pulling_friction, LEAST)
    rods = {
        "rod_length": (LENGTHS, np.array(settings.rod_angle)),
        "rod_angle": (np.array(settings.rod_length), ANGLES),
    }
    for axis, rod in rods.items():
        law = named(axis, inertia_friction(*rod), "1", f"{LEAST}; of the ring with inertia alone")
        data[f"inertia_over_{axis}"] = law
    return titled(data, "How much friction pulling takes", sources)


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw the least friction, linear in its angle, so that infinite friction has a place."""
    for ax, axis in panels(figure, data, _height):
        ax.set_ylim(LOWEST[axis], 91.5)
        shown = TICKS[np.degrees(np.arctan(TICKS)) >= LOWEST[axis]]
        names = [r"$\infty$" if np.isinf(mu) else f"{mu:g}" for mu in shown]
        ax.set_yticks(np.degrees(np.arctan(shown)), names)
        ax.axhline(90.0, color=GREY, linewidth=0.5, zorder=0)
        law = _height(data[f"inertia_over_{axis}"])
        ax.plot(data[axis], law, ":", color=DARK, label="ring, inertia alone")
        if axis == "rod_length":
            ax.set_ylabel(r"smallest $\mu$ that pulls")
            ax.legend(loc="upper right", bbox_to_anchor=(1.0, 0.97), ncols=1)
        else:
            note: dict[str, Any] = {"size": NOTE_SIZE, "color": GREY, "ha": "right", "va": "bottom"}
            ax.annotate("never", (178.0, 90.5), annotation_clip=False, **note)


def _height(friction: xr.DataArray) -> Array:
    """Angle of friction in degrees: finite where the coefficient is infinite."""
    height = np.degrees(np.arctan(friction.values))
    # A line has gaps where a curve jumps.
    return np.where(np.abs(np.diff(height, append=height[-1])) > JUMP, np.nan, height)
