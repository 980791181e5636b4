"""Figure 13: the contact-mode map, with all consistent modes over friction and the pusher angle."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, cast

import numpy as np
import xarray as xr
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.patches import Patch, Rectangle

from planar_pushing.drawing.canvas.axes import is_column
from planar_pushing.drawing.canvas.colors import DARK, look_of
from planar_pushing.drawing.canvas.marks import NOTE
from planar_pushing.drawing.canvas.style import COLUMN, PAGE
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import solve
from pulling_by_pushing.figures.figure import Figure, Settings, Sources
from pulling_by_pushing.figures.parts.data import (
    attributed,
    labeled,
    mathematical,
    named,
    rod_angle,
    titled,
    values,
)
from pulling_by_pushing.study.catalog import contact_labels
from pulling_by_pushing.study.datasets.base import friction_angle, objects, pushing
from pulling_by_pushing.study.describe import parameters_of
from pulling_by_pushing.study.model import labeled_law

FIGURE = Figure(
    title="Contact modes over friction and the direction of the push",
    reads=("motion_cones",),
    takes=("rod_length", "pusher_magnitude"),
    size=(PAGE, 3.5),
    column=(COLUMN, 7.6),
    section="Ours, contact modes",
)
#: Friction coefficients and pusher angles, in degrees, at which the sets of modes are computed.
COEFFICIENTS = (
    0, 0.1, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.1, 1.2, 1.25, 1.3, 1.35, 1.4, 1.45, 1.5,
    1.6, 1.7, 1.8, 1.9, 2, 2.25, 2.5, 3, 3.5, 4, 5, 7, 10, 20, 50, 100,
)  # fmt: skip
ANGLES = np.linspace(-180.0, 180.0, 361)
TITLES = {
    "support_friction": "support friction",
    "inertia": "inertia",
    "support_friction+inertia": r"both, $|\mathbf{{a}}_p| = {:g}\,W/m$",
}
#: Friction coefficients labeled on the axis, and the range of the pusher angle, degrees.
TICKS = (0.0, 0.5, 1.0, 2.0, 5.0, np.inf)
LOWEST = -60.0
#: Positions of the strips of the other laws on the axis of friction angles, and their width.
STRIPS = {"infinite_friction_none": 97.0, "perfectly_rough": 109.0}
STRIP_WIDTH = 8.0
RIGHTMOST = 117.0
#: Middle of the friction axis without the strips, as a fraction of the axes' width.
MIDDLE = 45.0 / RIGHTMOST
STRIP_NAMES = {"infinite_friction_none": r"$\infty$, def. 2", "perfectly_rough": "rough"}
DOTS: dict[str, Any] = {
    "color": DARK,
    "markersize": 2.8,
    "markerfacecolor": "white",
    "markeredgewidth": 0.7,
    "clip_on": False,
}
#: Line at which sticking ends.
BORDER: dict[str, Any] = {"color": DARK, "linewidth": 0.7, "zorder": 2}
UPRIGHT: dict[str, Any] = {"rotation": 90, "ha": "center", "va": "top", "size": NOTE}


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Compute the sets of consistent modes and the limit of sticking; select the motion-cone edges.

    A perfectly rough contact sticks under every motion. Under Coulomb's law the contact sticks if the
    force of the perfectly rough contact is inside the friction cone; the angle of this force therefore
    gives the exact limit of sticking.
    """
    cones = sources["motion_cones"]
    length = settings.rod_length
    data = maps(cones, length, settings.pusher_magnitude)
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


def caption(data: xr.Dataset) -> str:
    """Caption with the plotted values."""
    names = "rod_length rod_angle radius weight mass gyration_radius pusher_magnitude"
    known = values(data, *names.split())
    return (
        "Consistent contact modes over the coefficient of friction μ (the axis is linear in "
        "arctan μ, given in degrees below μ) and the direction of the fence's motion, for support "
        "friction, inertia, and both. The strips on the right show infinite friction without "
        "tangential force at zero normal force (the paper's second definition) and perfectly rough "
        "contact. Hatching in one direction marks a single slip mode; crossed or dotted hatching "
        "marks several modes. Sticking ends at the line. With one effect, the line passes through "
        "the motion-cone edges of the dataset (dots); with both, the cone covers all magnitudes of "
        f"the motion, and the map is drawn for one magnitude ({known})."
    )


def mode_sets(mode: xr.DataArray) -> xr.DataArray:
    """Code of the set of consistent modes along `solution`: the sum of 2 ** mode over the modes.

    Several slips of one mode count as one mode.
    """
    code = xr.zeros_like(mode.isel(solution=0, drop=True))
    for each in ContactMode:
        code += (mode == each).any("solution").astype(code.dtype) << each
    code.attrs = {
        "units": "1",
        "long_name": "set of consistent contact modes",
        "flag_masks": np.array([1 << each for each in ContactMode], np.int8),
        "flag_meanings": " ".join(each.name for each in ContactMode),
    }
    return code


def maps(grid: xr.Dataset, rod_length: float, magnitude: float) -> xr.Dataset:
    """Sets of modes and force angles of sticking for each set of effects, on a separate grid."""
    part, names = parameters_of(grid), list(grid.effects.values)
    labels = contact_labels(COEFFICIENTS)
    laws = objects("contact", labels, map(labeled_law, labels))
    angle = pushing(labeled("pusher_angle", ANGLES))
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
    # The laws after Coulomb's: both definitions of infinite friction, and perfect roughness.
    data["friction_angle"] = ("contact", friction_angle([*COEFFICIENTS, np.inf, np.inf, np.nan]))
    data = attributed(data.assign_coords(rod_angle=part.slider.rod_angle))
    data["force_angle"].attrs["long_name"] = "force angle of perfectly rough contact, sticking"
    return data


def _sticking(found: xr.Dataset) -> xr.DataArray:
    """Force angle of perfectly rough contact, which sticks under every motion, degrees."""
    rough = found.sel(contact="perfectly_rough", drop=True)
    force = rough.force.where(rough["mode"] == ContactMode.STICK).max("solution")
    x, y = (force.isel(xy=i, drop=True) for i in (0, 1))
    return cast(xr.DataArray, np.rad2deg(np.arctan2(y, x)))


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw one map for each set of effects, above a common legend."""
    count, narrow = data.sizes["effects"], is_column(figure)
    shape = (count, 1) if narrow else (1, count)
    axes = figure.subplots(*shape, sharex=narrow, sharey=True, squeeze=False).ravel()
    edges = {"left": 0.15, "bottom": 0.2, "top": 0.97, "hspace": 0.16} if narrow else {
        "left": 0.07, "bottom": 0.36, "top": 0.93, "wspace": 0.08}  # fmt: skip
    figure.subplots_adjust(right=0.995, **edges)
    shown = data.sel(pusher_angle=data.pusher_angle >= LOWEST)
    found: set[int] = set()
    for ax, name in zip(axes, data.effects.values, strict=True):
        found |= _map(ax, shown.sel(effects=name))
        if not narrow or ax is axes[-1]:
            _name_strips(ax)
        ax.set_title(TITLES[str(name)].format(float(data.pusher_magnitude)), x=MIDDLE)
    for ax in axes if narrow else axes[:1]:
        ax.set_ylabel("pusher angle (degrees)")
    for ax in axes[-1:] if narrow else axes:
        ax.set_xlabel(r"$\mu$, and $\arctan \mu$ (degrees)", x=MIDDLE)
    _legend(
        figure,
        sorted(found, key=lambda code: (bin(code).count("1") != 1, code)),
        axes[0].lines[-1:],
    )


def _legend(figure: Any, codes: list[int], dots: Sequence[Artist]) -> None:
    """Add a legend below the maps: sets of one mode first, then larger sets, then the dots."""
    handles = []
    for code in codes:
        look = look_of(code)
        handles.append(Patch(facecolor=look.fill, hatch=look.hatch, edgecolor=look.ink, linewidth=0.5,
                             label=look.name))  # fmt: skip
    narrow = is_column(figure)
    figure.legend(
        handles=[*handles, *dots], ncols=2 if narrow else 4, loc="lower center", handlelength=2.2,
        bbox_to_anchor=(0.5, 0.0), columnspacing=1.4, handleheight=1.1,
    )  # fmt: skip


def fill(ax: Axes, x: Any, low: Any, high: Any, code: int, **options: Any) -> None:
    """Fill the area between two curves in the style of a set."""
    look = look_of(code)
    ax.fill_between(x, low, high, facecolor=look.fill, hatch=look.hatch, edgecolor=look.ink, linewidth=0,
                    zorder=1, **options)  # fmt: skip


def _map(ax: Axes, one: xr.Dataset) -> set[int]:
    """Draw the bands over friction, the strips and the limits of sticking; return the sets drawn."""
    strips = np.isin(one.contact.values, list(STRIPS))
    found = _bands(ax, one.isel(contact=~strips))
    for column in np.flatnonzero(strips):
        found |= _strip(ax, one.isel(contact=[column]))
    force = _force_angle(one)
    for low in (0.0, 90.0):
        part = np.union1d(force[(force > low) & (force < low + 90)], [low, low + 90])
        ends = np.interp(part, force, one.pusher_angle.values)
        ax.plot(np.abs(part - 90.0), ends, **BORDER)
    if "+" not in str(one.effects.values):  # otherwise the cone covers every magnitude
        for side in ("right", "left"):
            ax.plot(
                one.cone_friction_angle,
                one[f"motion_cone_{side}"],
                "o",
                label="computed cone edges",
                **DOTS,
            )
    _decorate(ax)
    return found


def _decorate(ax: Axes) -> None:
    ax.set(xlim=(0, RIGHTMOST), ylim=(LOWEST, 180.0))
    places = np.rad2deg(np.arctan(TICKS))
    names = [f"${mathematical(mu)}$\n{angle:.0f}" for mu, angle in zip(TICKS, places, strict=True)]
    ax.set_xticks(places, names)
    ax.set_yticks(np.arange(LOWEST, 181.0, 60.0))
    ax.spines[["left", "bottom"]].set_visible(False)


def _name_strips(ax: Axes) -> None:
    for name, place in STRIPS.items():
        at, below = (place + STRIP_WIDTH / 2, -0.03), ax.get_xaxis_transform()
        ax.annotate(STRIP_NAMES[name], at, xycoords=below, annotation_clip=False, **UPRIGHT)


def _force_angle(one: xr.Dataset) -> Array:
    """Force angle of sticking over the pusher angle, unwrapped; 0 to 180 if the fence pushes."""
    angle = np.unwrap(one.force_angle.values, period=360.0)
    normal = angle[np.argmin(np.abs(one.pusher_angle.values - 90.0))]
    return np.asarray(angle - 360.0 * np.floor(normal / 360.0))


def _borders(one: xr.Dataset) -> Array:
    """Pusher angles at which the set can change, shape (contact, border): limits of sticking, fence."""
    steep, force, angle = one.friction_angle.values, _force_angle(one), one.pusher_angle.values
    ends = [np.interp(90.0 + sign * steep, force, angle) for sign in (-1.0, 1.0)]
    return np.stack([*ends, np.zeros(len(steep))], axis=1)


def _bands(ax: Axes, one: xr.Dataset) -> set[int]:
    """Draw sets of modes as bands between the angles at which the set changes, joined over friction.

    A set that occurs only at isolated angles, where the fence moves along its own line, has no band.
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
        # A band that ends between two columns tapers to a point at the second one.
        present = np.convolve(high > low, [1, 1, 1], mode="same") > 0
        fill(ax, one.friction_angle.values, low, high, int(code), where=present)
    _frame(ax, 0.0, 90.0)
    return {int(code) for code in found}


def _edge(one: xr.Dataset, count: Array) -> Array:
    """Start of a band, above the first `count` pusher angles of each contact.

    It is the border between the neighboring angles, or their midpoint if no border is known.
    """
    angle, borders = one.pusher_angle.values, _borders(one)
    low = angle[np.maximum(count - 1, 0)]
    high = angle[np.minimum(count, len(angle) - 1)]
    held = (borders >= low[:, None]) & (borders <= high[:, None])
    known = borders[np.arange(len(borders)), held.argmax(axis=1)]
    between = np.where(held.any(axis=1), known, (low + high) / 2)
    return np.select([count == 0, count == len(angle)], [LOWEST, 180.0], between)


def _strip(ax: Axes, column: xr.Dataset) -> set[int]:
    """Draw the sets of modes under one law as a strip beside the axis."""
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
