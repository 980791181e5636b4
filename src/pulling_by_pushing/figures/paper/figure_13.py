"""Figure 13: the contact-mode map, with all consistent modes over friction and the pusher angle."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.legend_handler import HandlerTuple
from matplotlib.patches import Patch, Rectangle

from planar_pushing.drawing.canvas.colors import DARK, look_of
from planar_pushing.drawing.canvas.marks import NOTE
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.mechanics.plane import Array
from pulling_by_pushing.figures.captions import acceleration, mathematical, number, values
from pulling_by_pushing.figures.figure import BOTH, Data, Figure

if TYPE_CHECKING:
    import xarray as xr

FIGURE = Figure(
    title="Contact modes over friction and the direction of the push",
    reads=("mode_maps", "motion_cones"),
    size=(PAGE, 3.5),
    takes=("rod_length", "pusher_magnitude"),
    section="Ours, contact modes",
)
TITLES = {
    "support_friction": "support friction",
    "inertia": "inertia",
    "support_friction+inertia": "both",
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
#: Frame of a map, a strip, and a field of the legend.
FRAME: dict[str, Any] = {"fill": False, "edgecolor": DARK, "linewidth": 0.6}
UPRIGHT: dict[str, Any] = {"rotation": 90, "ha": "center", "va": "top", "size": NOTE}


def caption(data: Data) -> str:
    """Caption with the plotted values."""
    maps = data["mode_maps"]
    names = "rod_length rod_angle radius weight mass gyration_radius"
    known = (
        f"{values(maps, *names.split())}, |aₚ| = {number(acceleration(maps))}\N{NO-BREAK SPACE}μₛg"
    )
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


def draw(figure: Any, data: Data) -> None:
    """Draw one map for each set of effects, above a common legend."""
    maps, cones = data["mode_maps"], data["motion_cones"]
    maps = maps.sel(pusher_angle=maps.pusher_angle >= LOWEST)
    axes = figure.subplots(1, maps.sizes["effects"], sharey=True, squeeze=False).ravel()
    figure.subplots_adjust(left=0.063, right=0.995, bottom=0.298, top=0.935, wspace=0.08)
    codes: set[int] = set()
    for ax, name in zip(axes, maps.effects.values, strict=True):
        codes |= _map(ax, maps.sel(effects=name), cones.sel(effects=name))
        _name_strips(ax)
        ax.set_title(_title(maps, str(name)), x=MIDDLE)
        ax.set_xlabel(r"$\mu$, and $\arctan \mu$ (degrees)", x=MIDDLE)
    axes[0].set_ylabel("pusher angle (degrees)")
    ordered = sorted(codes, key=lambda code: (bin(code).count("1") != 1, code))
    _add_legend(figure, ordered, axes[0].lines[-1:])


def _title(maps: xr.Dataset, effects: str) -> str:
    """Title of a map; that of both effects depends on the magnitude of the acceleration."""
    if effects != BOTH:
        return TITLES[effects]
    return rf"{TITLES[effects]}, $|\mathbf{{a}}_p| = {acceleration(maps):g}\,\mu_s g$"


def _add_legend(figure: Any, codes: list[int], dots: Sequence[Artist]) -> None:
    """Add a legend below the maps: sets of one mode first, then larger sets, then the dots."""
    looks = [look_of(code) for code in codes]
    swatches = [
        (
            Patch(facecolor=look.fill, hatch=look.hatch, edgecolor=look.ink, linewidth=0),
            Patch(**FRAME),
        )
        for look in looks
    ]
    names = [*(look.name for look in looks), *(dot.get_label() for dot in dots)]
    figure.legend(
        [*swatches, *dots], names, ncols=4, loc="lower center", handlelength=2.2,
        bbox_to_anchor=(0.5, 0.0), columnspacing=1.4, handleheight=1.1,
        handler_map={tuple: HandlerTuple(ndivide=1, pad=0.0)},
    )  # fmt: skip


def fill(ax: Axes, x: Any, low: Any, high: Any, code: int, **options: Any) -> None:
    """Fill the area between two curves in the style of a set."""
    look = look_of(code)
    ax.fill_between(x, low, high, facecolor=look.fill, hatch=look.hatch, edgecolor=look.ink, linewidth=0,
                    zorder=1, **options)  # fmt: skip


def _map(ax: Axes, one: xr.Dataset, cones: xr.Dataset) -> set[int]:
    """Draw the bands over friction, the strips and the limits of sticking; return the sets drawn."""
    strips = np.isin(one.contact.values, list(STRIPS))
    codes = _bands(ax, one.isel(contact=~strips))
    for column in np.flatnonzero(strips):
        codes |= _strip(ax, one.isel(contact=[column]))
    force = _force_angle(one)
    for low in (0.0, 90.0):
        part = np.union1d(force[(force > low) & (force < low + 90)], [low, low + 90])
        ends = np.interp(part, force, one.pusher_angle.values)
        ax.plot(np.abs(part - 90.0), ends, **BORDER)
    if "+" not in str(one.effects.values):  # otherwise the cone covers every magnitude
        for side in ("right", "left"):
            edge = cones[f"motion_cone_{side}"]
            ax.plot(cones.friction_angle, edge, "o", label="edges in the dataset", **DOTS)
    _decorate(ax)
    return codes


def _decorate(ax: Axes) -> None:
    ax.set(xlim=(0, RIGHTMOST), ylim=(LOWEST, 180.0))
    places = np.rad2deg(np.arctan(TICKS))
    names = [f"${mathematical(mu)}$\n{angle:.0f}" for mu, angle in zip(TICKS, places, strict=True)]
    ax.set_xticks(places, names)
    ax.set_yticks(np.arange(LOWEST, 181.0, 60.0))
    ax.spines[["left", "bottom"]].set_visible(False)


def _name_strips(ax: Axes) -> None:
    for name, left in STRIPS.items():
        position, below = (left + STRIP_WIDTH / 2, -0.03), ax.get_xaxis_transform()
        ax.annotate(STRIP_NAMES[name], position, xycoords=below, annotation_clip=False, **UPRIGHT)


def _force_angle(one: xr.Dataset) -> Array:
    """Force angle of sticking over the pusher angle, unwrapped; 0 to 180 if the fence pushes."""
    angle = np.unwrap(one.sticking_force_angle.values, period=360.0)
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
    codes = np.unique(modes[:, 1:][modes[:, 1:] == modes[:, :-1]])
    ordered = sorted(codes, key=lambda code: float(np.nonzero(modes == code)[1].mean()))
    rank = np.full(modes.shape, -1)
    for index, code in enumerate(ordered):
        rank[modes == code] = index
    rank = np.maximum.accumulate(rank, axis=1)
    below = [(rank < index).sum(axis=1) for index in range(len(codes) + 1)]
    edges = [_edge(one, count) for count in below]
    for code, low, high in zip(ordered, edges[:-1], edges[1:], strict=True):
        # A band that ends between two columns tapers to a point at the second one.
        present = np.convolve(high > low, [1, 1, 1], mode="same") > 0
        fill(ax, one.friction_angle.values, low, high, int(code), where=present)
    _frame(ax, 0.0, 90.0)
    return {int(code) for code in codes}


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
    outline = Rectangle((left, LOWEST), width, 180.0 - LOWEST, **FRAME)
    outline.set(zorder=2, clip_on=False)
    ax.add_patch(outline)
