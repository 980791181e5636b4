"""Parts that the figures of curves, cones and maps share: scenes of a study, curves, and panels."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import matplotlib
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_pushing.figures.parts import arrows, drawing, labels
from planar_pushing.figures.settings import Settings, Sources
from planar_pushing.figures.style import DARK, FORCE, GUIDE, MOTION, NOTE_SIZE
from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.limit_curve import limit_curve
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.study.datasets.base import pushing
from planar_pushing.study.describe import parameters_of
from planar_pushing.terms.quantities import DATASET, attributes, described

#: Ends of curves that close on themselves.
BUTT: dict[str, Any] = {"solid_capstyle": "butt", "zorder": 3}
#: Force angles of a limit curve, degrees: as close as a smooth line takes.
ANGLES = np.linspace(0.0, 360.0, 361)
#: Force angles of a mapping that are drawn between the edges of its cone, degrees.
INSIDE = (45.0, 90.0)


def chosen(given: float | None, default: float) -> float:
    """Value of a figure: the study's, or the module's own."""
    return default if given is None else given


def rod_lengths(settings: Settings, default: tuple[float, ...]) -> tuple[float, ...]:
    """Rod lengths of a figure: the study's, or the module's own."""
    given = settings.rod_length
    if given is None:
        return default
    return given if isinstance(given, tuple) else (given,)


def scene_of(dataset: xr.Dataset, effects: str, rod_length: float | xr.DataArray) -> Scene:
    """The slider of a dataset over the grid on this rod, or these rods, under infinite friction."""
    part = parameters_of(dataset)
    return Scene(
        slider=part.ring(rod_length), contact=InfiniteFriction(), effects=part.effects(effects)
    )


def labelled(name: str, values: Iterable[float]) -> xr.DataArray:
    """Values along an axis of their own."""
    array = np.array(list(values), dtype=float)
    return xr.DataArray(array, dims=name, coords={name: array})


def attributed(dataset: xr.Dataset) -> xr.Dataset:
    """Give variables the units and the names that they have in the datasets of a study."""
    for name in dataset.variables.keys() & DATASET.keys():
        dataset[name].attrs = attributes(DATASET, str(name))
    return dataset


def rod_angle(dataset: xr.Dataset) -> float:
    """The study's rod angle, degrees; a dataset over other angles is cut there."""
    return float(parameters_of(dataset).slider.rod_angle)


def radius(dataset: xr.Dataset) -> xr.Variable:
    """Radius of the ring that a dataset over the grid was computed for."""
    return named((), parameters_of(dataset).slider.radius, "length", "radius of the ring")


def named(dims: Iterable[str] | str, values: object, units: str, long_name: str) -> xr.Variable:
    """Make a variable with its unit and name."""
    axes = dims if isinstance(dims, str) else tuple(dims)
    return xr.Variable(axes, np.asarray(values), described(units, long_name))


def titled(dataset: xr.Dataset, title: str, sources: Sources) -> xr.Dataset:
    """Give the plotted numbers a title, and the sources of the datasets that they come from."""
    origins = dict.fromkeys(str(each.attrs["source"]) for each in sources.values())
    named = {name: each for name, each in dataset.attrs.items() if name == "scene"}
    dataset.attrs = {"title": title, "source": "; ".join(origins)} | named
    return dataset


def forces(scene: Scene, degrees: xr.DataArray) -> xr.Dataset:
    """Limit curve at force angles in degrees: force, its components, and the motion in degrees."""
    phi = pushing(degrees)
    curve = limit_curve(scene, phi)
    x, y = (phi.copy(data=each) for each in direction(phi.values).T)
    return attributed(
        xr.Dataset(
            {
                "force": curve.force_size,
                "force_x": curve.force_size * x,
                "force_y": curve.force_size * y,
                "motion_angle": np.rad2deg(curve.motion_angle),
            }
        )
    )


def curves(grid: xr.Dataset, effects: str, lengths: tuple[float, ...]) -> xr.Dataset:
    """Limit curves under some effects at the study's rod angle, one for each rod length.

    A line through the forces of the grid would have corners, so the curves are computed here.
    """
    scene = scene_of(grid, effects, labelled("rod_length", lengths))
    found = forces(scene, labelled("force_angle", ANGLES))[["force_x", "force_y"]]
    return found.assign_coords(rod_angle=named((), rod_angle(grid), "degree", "rod angle"))


def cone_mapping(cones: xr.Dataset, effects: str, length: float, friction: float) -> xr.Dataset:
    """Forces of a friction cone and the motions they map to: its edges, and angles inside it."""
    edges = cones.sel(
        effects=effects,
        rod_angle=rod_angle(cones),
        rod_length=length,
        friction_coefficient=friction,
    )
    right, left = float(edges.friction_cone_right), float(edges.friction_cone_left)
    between = [angle for angle in INSIDE if right < angle < left]
    angle = np.array([right, *between, left])
    within = forces(scene_of(cones, effects, length), labelled("force_angle", between))
    motion = [edges.motion_cone_right, *within.motion_angle, edges.motion_cone_left]
    magnitude = np.array([edges.limit_force_right, *within.force, edges.limit_force_left])
    tip = magnitude[:, None] * direction(np.deg2rad(angle))
    return xr.Dataset(
        {
            "mapped_force_x": named("map", tip[:, 0], "force", "mapped force along the fence"),
            "mapped_force_y": named("map", tip[:, 1], "force", "mapped force normal to the fence"),
            "mapped_force_angle": named("map", angle, "degree", "angle of the mapped force"),
            "mapped_motion_angle": named(
                "map", np.array(motion), "degree", "angle of the motion it causes"
            ),
            "mapped_rod_length": named((), length, "length", "rod length of the mapping"),
            "friction_coefficient": edges.friction_coefficient.variable,
            "radius": radius(cones),
        }
    )


def shades(count: int) -> list[tuple[float, ...]]:
    """Colors of an ordered family of force curves, from dark to light, which differ in gray too."""
    return [tuple(each) for each in matplotlib.colormaps["copper"](np.linspace(0.1, 0.82, count))]


def number(value: float) -> str:
    """Number as mathematical text, infinity included."""
    return r"\infty" if np.isinf(value) else f"{value:g}"


def degrees(angle: float) -> str:
    """Angle as mathematical text, to a tenth of a degree."""
    return rf"${angle:.1f}^\circ$"


def on_curve(ax: Axes, xy: Array, text: str, color: Any, side: str = "center") -> None:
    """Label that interrupts the curve it names; `side` is its horizontal alignment."""
    box = {"boxstyle": "round,pad=0.12", "facecolor": "white", "edgecolor": "none"}
    labels.label(ax, xy, text, color=color, size=NOTE_SIZE, bbox=box, zorder=4, ha=side)


def family(ax: Axes, data: xr.Dataset, place: float, side: str, bold: float | None = None) -> None:
    """Force curves of several rod lengths, each interrupted by its length at the angle `place`.

    The first, outermost one carries the symbol too, aligned to `side`; `bold` is the rod length of
    a curve to draw heavier.
    """
    colors = shades(data.sizes["rod_length"])
    for color, length in zip(colors, data.rod_length.values, strict=True):
        curve = data.sel(rod_length=length)
        width = None if bold is None else (1.7 if length == bold else 0.9)
        ax.plot(curve.force_x, curve.force_y, color=color, linewidth=width, **BUTT)
        at = curve.sel(force_angle=place, method="nearest")
        tip = np.array([float(at.force_x), float(at.force_y)])
        first = length == data.rod_length[0]
        text = f"$l = {number(length)}$" if first else f"${number(length)}$"
        on_curve(ax, tip, text, color, side if first else "center")


def mapping_panels(
    figure: Figure, data: xr.Dataset, lines: Sequence[Array], symbol: str, titles: Sequence[str]
) -> Axes:
    """Three panels from the friction cone through the curve to the motion cone.

    Returns the middle one, for the caller to draw the curves `lines` in; `symbol` names the motion.
    """
    angles = {"f": data.mapped_force_angle.values, symbol: data.mapped_motion_angle.values}
    for place, name in zip((0.0, 0.68), angles, strict=True):
        _cone_panel(figure, data, (place, 0.0, 0.32, 0.9), name, angles[name])
    middle = _curve_panel(figure, data, lines, symbol)
    for place, title in zip((0.16, 0.5, 0.84), titles, strict=True):
        figure.text(place, 0.97, title, ha="center", va="top", color=DARK)
    for place in (0.335, 0.665):
        figure.text(place, 0.975, r"$\longrightarrow$", ha="center", va="top", color=GUIDE)
    return middle


def _cone_panel(
    figure: Figure,
    data: xr.Dataset,
    rect: tuple[float, float, float, float],
    name: str,
    angles: Array,
) -> None:
    """Slider and fence with a cone at the contact, its edges' angles and the numbered arrows."""
    color, draw = (FORCE, arrows.force_arrow) if name == "f" else (MOTION, arrows.motion_arrow)
    rod, ring = float(data.mapped_rod_length), float(data.radius)
    center, reach = rod * arrows.unit(float(data.rod_angle)), 0.62 * (rod + ring)
    right = max(center[0] + ring, reach)
    box = (-reach, right, min(center[1] - ring, -0.4 * reach), max(center[1] + ring, reach))
    ax = drawing.schematic(figure, box, rect=rect, pad=14)
    drawing.slider(ax, center, ring, width=1.6)
    drawing.fence(ax, -reach, right)
    drawing.cone(ax, (0, 0), angles[0], angles[-1], reach, color)
    for edge in (angles[0], angles[-1]):
        tip = arrows.unit(edge)
        shift = (14.0 * tip[0], 8.0 * tip[1])
        labels.label(ax, reach * tip, degrees(edge), offset=shift, color=color, size=NOTE_SIZE)
    # Shorter than the rod, which one of them may cover.
    length = min(0.76 * reach, 0.7 * max(rod, ring))
    low = -0.04 * (reach + right)
    for index, angle in enumerate(angles):
        text, tip = rf"$\mathbf{{{name}}}_{{{index + 1}}}$", length * arrows.unit(angle)
        draw(ax, (0, 0), tip, text if tip[1] >= 0 else "", head=10, width=1.1)
        if tip[1] < 0:  # below the fence, as its arrow is
            labels.label(ax, (0.8 * tip[0], min(tip[1], low)), text, color=color, va="top")
    labels.declutter(ax)


def _curve_panel(figure: Figure, data: xr.Dataset, lines: Sequence[Array], symbol: str) -> Axes:
    """Forces from the origin to the curve, and the motions normal to it there."""
    span = 1.3 * float(np.abs(lines).max())
    ax = drawing.schematic(figure, (-span, span, -span, span), rect=(0.33, 0.0, 0.34, 0.9), pad=6)
    arrows.coordinate_axes(ax, (0, 0), 0.0, 1.05 * span, ("$f_x$", "$f_y$"), color=GUIDE)
    angle = data.mapped_force_angle.values
    drawing.cone(ax, (0, 0), angle[0], angle[-1], 1.12 * span / 1.3, FORCE, strength=0.1)
    tips = np.stack([data.mapped_force_x, data.mapped_force_y], axis=-1)
    for index, (tip, motion) in enumerate(zip(tips, data.mapped_motion_angle.values, strict=True)):
        arrows.force_arrow(ax, (0, 0), tip, head=8, width=1.0)
        text = rf"$\mathbf{{{symbol}}}_{{{index + 1}}}$"
        arrows.motion_arrow(
            ax, tip, 0.36 * span * arrows.unit(float(motion)), text, head=8, width=1.0
        )
    return ax
