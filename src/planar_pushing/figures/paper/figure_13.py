"""Figure 13: the contact-mode map, every consistent mode over friction and the pusher's angle."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, cast

import numpy as np
import xarray as xr
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from planar_pushing.figures.parts.curves import (
    attributed,
    chosen,
    labelled,
    named,
    number,
    rod_angle,
    rod_lengths,
    titled,
)
from planar_pushing.figures.parts.mode_sets import (
    LEFT,
    RIGHT,
    SEPARATE,
    STICK,
    fill,
    mode_sets,
    patch,
)
from planar_pushing.figures.settings import Settings, Sources
from planar_pushing.figures.style import DARK, NOTE_SIZE
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import solve
from planar_pushing.study.catalog import contact_labels
from planar_pushing.study.datasets.base import friction_angle, objects, pushing
from planar_pushing.study.describe import parameters_of
from planar_pushing.study.files.study_model import labelled_law

#: Coefficients of friction, and pusher angles in degrees, at which the sets of modes are computed.
COEFFICIENTS = (
    0, 0.1, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.1, 1.2, 1.25, 1.3, 1.35, 1.4, 1.45, 1.5,
    1.6, 1.7, 1.8, 1.9, 2, 2.25, 2.5, 3, 3.5, 4, 5, 7, 10, 20, 50, 100,
)  # fmt: skip
ANGLES = np.linspace(-180.0, 180.0, 361)
#: The legend's groups: title, columns, place in the figure, and the sets in it.
LEGENDS = (
    ("unique", 2, 0.21, (SEPARATE, STICK, LEFT, RIGHT)),
    ("ambiguous", 1, 0.48, (SEPARATE | STICK | LEFT, SEPARATE | STICK, SEPARATE | LEFT)),
    ("inconsistent", 1, 0.69, (0,)),
)
TITLES = {
    "support_friction": "support friction",
    "inertia": "inertia",
    "support_friction+inertia": r"both, $|\mathbf{{a}}_p| = {:g}$",
}
#: Coefficients of friction that the axis names, and the range of the pusher's angle, degrees.
TICKS = (0.0, 0.5, 1.0, 2.0, 5.0, np.inf)
LOWEST = -60.0
#: Where the strips of the other laws stand on the axis of friction angles, and their width.
STRIPS = {"infinite_friction_none": 97.0, "perfectly_rough": 109.0}
STRIP_WIDTH = 8.0
RIGHTMOST = 117.0
#: Middle of the friction axis, without the strips, fraction.
MIDDLE = 45.0 / RIGHTMOST
STRIP_NAMES = {"infinite_friction_none": "definition 2", "perfectly_rough": "rough"}
DOTS: dict[str, Any] = {
    "color": DARK,
    "markersize": 2.8,
    "markerfacecolor": "white",
    "markeredgewidth": 0.7,
    "clip_on": False,
}
#: Line where sticking ends.
BORDER: dict[str, Any] = {"color": DARK, "linewidth": 0.7, "zorder": 2}
UPRIGHT: dict[str, Any] = {"rotation": 90, "ha": "center", "va": "top", "size": NOTE_SIZE}


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Compute the sets of consistent modes and where sticking ends; select the edges of the motion cones.

    A contact sticks under Coulomb's law where the force of perfectly rough contact, which sticks to
    every motion, is inside the friction cone: so that force's angle tells exactly where sticking ends.
    """
    cones = sources["motion_cones"]
    length = rod_lengths(settings, (2.0,))[0]
    data = maps(cones, length, chosen(settings.pusher_magnitude, 1.0))
    cones = cones.sel(rod_length=length, rod_angle=rod_angle(cones))
    for side in ("right", "left"):
        edge = cones[f"motion_cone_{side}"]
        data[f"motion_cone_{side}"] = edge.drop_vars(["friction_coefficient", "friction_angle"])
    data["cone_friction_angle"] = named(
        "friction_coefficient",
        cones.friction_angle.values,
        "degree",
        "angle of friction of the motion cone",
    )
    return titled(data, "Contact modes over friction and the direction of the pusher", sources)


def maps(grid: xr.Dataset, rod_length: float, magnitude: float) -> xr.Dataset:
    """Sets of modes, and force angles of sticking, of each set of effects: on a grid of their own."""
    part, names = parameters_of(grid), list(grid.effects.values)
    labels = contact_labels(COEFFICIENTS)
    laws = objects("contact", labels, map(labelled_law, labels))
    angle = pushing(labelled("pusher_angle", ANGLES))
    found = [
        solve(
            Scene(slider=part.ring(rod_length), contact=laws, effects=part.effects(name)),
            angle,
            magnitude,
        )
        for name in names
    ]
    along = xr.Variable("effects", names)
    data = xr.Dataset(
        {
            "modes": xr.concat([mode_sets(each["mode"]) for each in found], along),
            "force_angle": xr.concat(map(_sticking, found), along),
        },
        {"rod_length": rod_length, "pusher_magnitude": magnitude},
    ).transpose("effects", "contact", "pusher_angle")
    # The laws behind those of Coulomb: infinite friction twice, and perfect roughness.
    data["friction_angle"] = ("contact", friction_angle([*COEFFICIENTS, np.inf, np.inf, np.nan]))
    data = attributed(data.assign_coords(rod_angle=part.slider.rod_angle))
    data["force_angle"].attrs["long_name"] = "force angle of perfectly rough contact, sticking"
    return data


def _sticking(found: xr.Dataset) -> xr.DataArray:
    """Force angle of perfectly rough contact, which sticks to every motion, degrees."""
    rough = found.sel(contact="perfectly_rough", drop=True)
    force = rough.force.where(rough["mode"] == ContactMode.STICK).max("solution")
    x, y = (force.isel(xy=i, drop=True) for i in (0, 1))
    return cast(xr.DataArray, np.rad2deg(np.arctan2(y, x)))


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw one map for each set of effects, over one legend."""
    axes = figure.subplots(1, data.sizes["effects"], sharey=True, squeeze=False)[0]
    figure.subplots_adjust(left=0.07, right=0.995, bottom=0.34, top=0.93, wspace=0.08)
    shown = data.sel(pusher_angle=data.pusher_angle >= LOWEST)
    found: set[int] = set()
    for ax, name in zip(axes, data.effects.values, strict=True):
        found |= _map(ax, shown.sel(effects=name))
        title = TITLES[str(name)].format(float(data.pusher_magnitude))
        ax.set_title(title, x=MIDDLE)
    axes[0].set_ylabel("pusher angle (degrees)")
    for title, columns, place, codes in LEGENDS:
        _legend(figure, place, columns, [patch(code) for code in codes if code in found], title)
    _legend(figure, 0.87, 1, axes[0].lines[-1:], "motion cone")


def _legend(
    figure: Figure, place: float, columns: int, handles: Sequence[Artist], title: str
) -> None:
    where: dict[str, Any] = {
        "loc": "upper center",
        "bbox_to_anchor": (place, 0.19),
        "columnspacing": 1.2,
    }
    figure.legend(handles=handles, title=title, ncols=columns, **where)


def _map(ax: Axes, one: xr.Dataset) -> set[int]:
    """Bands over friction, strips of the other laws, the ends of sticking; the sets drawn."""
    strips = np.isin(one.contact.values, list(STRIPS))
    found = _bands(ax, one.isel(contact=~strips))
    for column in np.flatnonzero(strips):
        found |= _strip(ax, one.isel(contact=[column]))
    force = _force_angle(one)
    for low in (0.0, 90.0):
        part = np.union1d(force[(force > low) & (force < low + 90)], [low, low + 90])
        ends = np.interp(part, force, one.pusher_angle.values)
        ax.plot(np.abs(part - 90.0), ends, **BORDER)
    if "+" not in str(one.effects.values):  # else the cone covers every magnitude of the motion
        for side in ("right", "left"):
            ax.plot(one.cone_friction_angle, one[f"motion_cone_{side}"], "o", label="edge", **DOTS)
    _decorate(ax)
    return found


def _decorate(ax: Axes) -> None:
    ax.set(xlim=(0, RIGHTMOST), ylim=(LOWEST, 180.0))
    ax.set_xticks(np.rad2deg(np.arctan(TICKS)), [f"${number(each)}$" for each in TICKS])
    ax.set_xlabel(r"coefficient of friction $\mu$", x=MIDDLE)
    ax.set_yticks(np.arange(LOWEST, 181.0, 60.0))
    ax.spines[["left", "bottom"]].set_visible(False)
    for name, place in STRIPS.items():
        at, below = (place + STRIP_WIDTH / 2, -0.03), ax.get_xaxis_transform()
        ax.annotate(STRIP_NAMES[name], at, xycoords=below, annotation_clip=False, **UPRIGHT)


def _force_angle(one: xr.Dataset) -> Array:
    """Force angle of sticking over the pusher angle, unwrapped, 0 to 180 where the fence pushes."""
    angle = np.unwrap(one.force_angle.values, period=360.0)
    normal = angle[np.argmin(np.abs(one.pusher_angle.values - 90.0))]
    return np.asarray(angle - 360.0 * np.floor(normal / 360.0))


def _borders(one: xr.Dataset) -> Array:
    """Pusher angles at which the set can change, shape (contact, border): ends of sticking, fence."""
    steep, force, angle = one.friction_angle.values, _force_angle(one), one.pusher_angle.values
    ends = [np.interp(90.0 + sign * steep, force, angle) for sign in (-1.0, 1.0)]
    return np.stack([*ends, np.zeros(len(steep))], axis=1)


def _bands(ax: Axes, one: xr.Dataset) -> set[int]:
    """Sets of modes as bands between the angles where the set changes, joined over friction.

    A set that holds at single angles only, where the fence moves along itself, has no band.
    """
    modes = one.modes.values
    found = np.unique(modes[:, 1:][modes[:, 1:] == modes[:, :-1]])
    ordered = sorted(found, key=lambda code: float(np.nonzero(modes == code)[1].mean()))
    rank = np.full(modes.shape, -1)
    for index, code in enumerate(ordered):
        rank[modes == code] = index
    rank = np.maximum.accumulate(rank, axis=1)
    below = [(rank < each).sum(axis=1) for each in range(len(found) + 1)]
    edges = [_edge(one, count) for count in below]
    for code, low, high in zip(ordered, edges[:-1], edges[1:], strict=True):
        # A band that ends between two columns narrows to a point at the next one.
        present = np.convolve(high > low, [1, 1, 1], mode="same") > 0
        fill(ax, one.friction_angle.values, low, high, int(code), where=present)
    _frame(ax, 0.0, 90.0)
    return {int(code) for code in found}


def _edge(one: xr.Dataset, count: Array) -> Array:
    """Where a band starts, above the first `count` pusher angles of each contact.

    At the border between these angles, or half way where none is known.
    """
    angle, borders = one.pusher_angle.values, _borders(one)
    low = angle[np.maximum(count - 1, 0)]
    high = angle[np.minimum(count, len(angle) - 1)]
    held = (borders >= low[:, None]) & (borders <= high[:, None])
    known = borders[np.arange(len(borders)), held.argmax(axis=1)]
    between = np.where(held.any(axis=1), known, (low + high) / 2)
    return np.select([count == 0, count == len(angle)], [LOWEST, 180.0], between)


def _strip(ax: Axes, column: xr.Dataset) -> set[int]:
    """Sets of modes under one law beside the axis."""
    modes, left = column.modes.values[0], STRIPS[str(column.contact.values[0])]
    starts = np.flatnonzero(np.diff(modes, prepend=-1))
    stops = np.append(starts[1:], len(modes))
    wide = [(start, stop) for start, stop in zip(starts, stops, strict=True) if stop > start + 1]
    for start, stop in wide:
        low, high = (_edge(column, np.array([n])) for n in (start, stop))
        fill(ax, [left, left + STRIP_WIDTH], low, high, int(modes[start]))
    _frame(ax, left, STRIP_WIDTH)
    return {int(modes[start]) for start, _ in wide}


def _frame(ax: Axes, left: float, width: float) -> None:
    outline = Rectangle((left, LOWEST), width, 180.0 - LOWEST, fill=False, edgecolor=DARK)
    outline.set(linewidth=0.6, zorder=2, clip_on=False)
    ax.add_patch(outline)
