"""Figure 17: the friction that pulling requires."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, cast

import numpy as np
import xarray as xr

from planar_pushing.drawing.canvas.colors import DARK, GRAY
from planar_pushing.drawing.canvas.marks import NOTE
from planar_pushing.drawing.canvas.style import COLUMN, PAGE
from planar_pushing.mechanics.contact import PerfectlyRough
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from pulling_by_pushing.figures.figure import Figure, Settings, Sources
from pulling_by_pushing.figures.parts.data import named, number, titled
from pulling_by_pushing.figures.parts.gallery import SECTION, sustaining
from pulling_by_pushing.figures.parts.rods import ANGLES, Part, over_rods, panels
from pulling_by_pushing.study.datasets.base import words

FIGURE = Figure(
    title="The friction that pulling needs",
    reads=("supports",),
    takes=("rod_length",),
    size=(PAGE, 4.9),
    column=(COLUMN, 9.0),
    section=SECTION,
)
#: A force within this angle of the fence, radians, requires infinite friction.
ALONG_FENCE = 1e-12
#: Friction coefficients labeled on the axis of friction angles.
TICKS = np.array([0.5, 1, 1.5, 2, 3, 5, 10, np.inf])
#: A larger change of the friction angle between two samples, degrees, is a jump.
JUMP = 8.0
LEAST = "smallest friction angle, arctan mu, with which the contact can pull; 90 degrees if it cannot pull"


def pulling_friction_angle(scenes: Scene) -> xr.DataArray:
    """Smallest friction angle at which pulling is possible, degrees; 90 if it never is.

    The motion direction increases with the force direction. The motion cone therefore reaches below the
    fence on the right as soon as the friction cone contains a force beyond all those that sustain motion
    along the fence to the right; similarly on the left. The angle is as accurate as the directions of
    these forces, whereas mu, its tangent, is not where it is large.
    """
    right, left = sustaining(scenes, 0.0)[0], -sustaining(scenes, np.pi)[1]
    steeper = right.where(right > left, left)
    friction = cast(xr.DataArray, 90.0 - np.rad2deg(steeper))
    return friction.where(steeper > ALONG_FENCE, 90.0)


def inertia_friction_angle(length: Array, angle: Array) -> Array:
    """Friction angle in degrees for a ring with inertia alone; its tangent is 1 + 2/l^2 at 45 degrees.

    The radius of gyration is the radius of the ring, and lengths are in radii. Eqs. (11)-(13) give the
    force that moves the contact along the fence.
    """
    c, s = np.cos(np.deg2rad(angle)), np.sin(np.deg2rad(angle))
    return np.asarray(np.rad2deg(np.arctan2(1 + (length * c) ** 2, np.abs(length**2 * s * c))))


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Compute the smallest friction over rod length and rod angle, and its closed form for inertia."""
    grid, law = sources["supports"], PerfectlyRough()
    data = over_rods(grid, settings, law, pulling_friction_angle, LEAST, "degree")
    ring = float(data.ring_extent)
    rods = {
        "rod_length": (data.rod_length.values / ring, np.array(settings.rod_angle)),
        "rod_angle": (np.array(settings.rod_length / ring), ANGLES),
    }
    for axis, rod in rods.items():
        text = f"{LEAST}; of the ring with inertia alone"
        data[f"inertia_over_{axis}"] = named(axis, inertia_friction_angle(*rod), "degree", text)
    return titled(data, "How much friction pulling requires", sources)


def caption(data: xr.Dataset) -> str:
    """Caption with the plotted values."""
    length, angle = number(float(data.cut_rod_length)), number(float(data.cut_rod_angle))
    return (
        "Smallest coefficient of friction at which the contact can stick while the pusher moves "
        "away, for supports on areas (a, b) and on points and lines (c, d). Over the rod length "
        f"(a, c; ψ = {angle}°), the vertical axis is linear in arctan μ. Over the rod angle (b, d; "
        f"l = {length}), the curves show the difference of arctan μ from that of a ring of the same "
        f"extent, of radius {number(float(data.ring_extent))} (gray). Where a curve reaches "
        "infinity, pulling is impossible; at ψ = 90° this happens for every support that is "
        f"symmetric about the rod.{''.join(_remarks(data))}"
    )


def _remarks(data: xr.Dataset) -> Iterator[str]:
    """Remarks on the supports with discontinuous curves."""
    names = [words(str(name)) for name in data.support.values if _jump(data, name)]
    if names:
        yield (
            f" For the {' and the '.join(names)}, this happens only at 90° (dot): at "
            "angles close to it the motion along the fence is a pivot, and the curve ends at the open "
            "circle."
        )
    if "quadruped" in data.support.values:
        yield " The quadruped's curve jumps where a foot is directly above the contact."


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw the smallest friction over rod length, and its difference from the ring's over rod angle."""

    def drawn(friction_angle: xr.DataArray, axis: str) -> Array:
        height = friction_angle.values
        if axis == "rod_angle":
            height = height - data.ring_over_rod_angle.values
        return _broken(height)

    for part in panels(figure, data, drawn):
        law = drawn(data[f"inertia_over_{part.axis}"], part.axis)
        part.ax.plot(data[part.axis], law, ":", color=DARK, label="ring, inertia alone")
        if part.axis == "rod_length":
            _over_lengths(part.ax)
        else:
            part.ax.set_ylabel(r"$\arctan \mu$ minus the ring's (degrees)")
            _jumps_at_the_upright_rod(part, data)


def _over_lengths(ax: Any) -> None:
    ax.set_ylim(42.0, 91.5)
    shown = TICKS[np.degrees(np.arctan(TICKS)) >= 42.0]
    names = [r"$\infty$" if np.isinf(mu) else f"{mu:g}" for mu in shown]
    ax.set_yticks(np.degrees(np.arctan(shown)), names)
    ax.axhline(90.0, color=GRAY, linewidth=0.5, zorder=0)
    ax.annotate("never", (1.0, 90.3), xycoords=("axes fraction", "data"), annotation_clip=False,
                size=NOTE, color=GRAY, ha="right", va="bottom")  # fmt: skip
    ax.set_ylabel(r"smallest $\mu$ that pulls")
    ax.legend(loc="upper right", bbox_to_anchor=(1.0, 0.97), labelspacing=0.2)


def _jumps_at_the_upright_rod(part: Part, data: xr.Dataset) -> None:
    """Mark curves whose value at 90 degrees differs from their limit there."""
    for name, color, _ in part.looks:
        found = _jump(data, name)
        if found:
            style: dict[str, Any] = {"color": color, "markersize": 4.0, "zorder": 5}
            for height, face in zip(found, (color, "white"), strict=True):
                part.ax.plot(90.0, height, "o", markerfacecolor=face, clip_on=False, **style)


def _jump(data: xr.Dataset, name: object) -> tuple[float, float] | None:
    """Heights of a curve at 90 degrees and beside it, minus the ring's; None if they are equal."""
    height = data.over_rod_angle.sel(support=name).values
    middle = int(np.flatnonzero(ANGLES == 90.0)[0])
    here = float(height[middle] - data.ring_over_rod_angle.values[middle])
    limit = float(height[middle - 1]) - 90.0
    return (here, limit) if abs(here - limit) > JUMP else None


def _broken(height: Array) -> Array:
    """Heights with gaps where a curve jumps."""
    return np.where(np.abs(np.diff(height, append=height[-1])) > JUMP, np.nan, height)
