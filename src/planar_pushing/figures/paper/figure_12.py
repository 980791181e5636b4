"""Figure 12: possible acceleration centers and accelerations with support friction and inertia."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch, Polygon, Rectangle, Wedge

from planar_pushing.figures.parts import arrows, drawing, labels
from planar_pushing.figures.parts.curves import (
    attributed,
    degrees,
    labelled,
    named,
    rod_lengths,
    scene_of,
    titled,
)
from planar_pushing.figures.settings import Settings, Sources
from planar_pushing.figures.style import CENTER, LIGHT, MOTION, NOTE_SIZE, PUSHER, SLIP
from planar_pushing.mechanics.centers import motion_centers
from planar_pushing.study.datasets.base import pushing
from planar_pushing.terms.options import EffectSet

#: Force angles of the boundaries, degrees.
ANGLES = np.linspace(0.0, 180.0, 181)
SCENE = (
    "rod_length rod_angle radius ring_center pusher_angle pusher_motion contact_motion force "
    "friction_cone_right friction_cone_left"
)


def sectors(rod_length: float, rod_angle: float, radius: float) -> xr.Dataset:
    """Sectors of acceleration centers about the ring center, by the paper's cases (Sec. 4).

    The center lies opposite the line of force, a quarter turn from it: inside the ring where the line
    passes outside of it, outside where the line passes through it.
    """
    cuts = {0.0, rod_angle, 180.0}
    if rod_length > radius:
        lean = float(np.rad2deg(np.arcsin(radius / rod_length)))
        cuts |= {rod_angle + turn for turn in (lean, -lean, 180 - lean, lean - 180)}
    edges = np.array(sorted(cut for cut in cuts if 0 <= cut <= 180))
    middle = np.deg2rad((edges[:-1] + edges[1:]) / 2)
    arm = rod_length * np.sin(np.deg2rad(rod_angle) - middle)  # Eq. (10)
    turn = np.where(arm > 0, 90.0, -90.0)
    outside = np.abs(arm) < radius
    parts = (
        ("start", edges[:-1] + turn, "degree", "right end of the sector of centers"),
        ("stop", edges[1:] + turn, "degree", "left end of the sector of centers"),
        ("outside", outside, "1", "whether the sector is outside the ring"),
    )
    return xr.Dataset(
        {
            f"sector_{name}": named("sector", values, unit, words)
            for name, values, unit, words in parts
        }
    )


def exact_centers(grid: xr.Dataset, rod_length: float) -> xr.Dataset:
    """Boundaries of the exact set of centers, under friction alone and under inertia alone.

    Those of the grid's force angles would draw corners, so they are computed here. Force angles whose
    center is at infinity, a translation, are left out.
    """
    angle, share = labelled("force_angle", ANGLES), labelled("inertia_share", (0.0, 1.0))
    scene = scene_of(grid, EffectSet.BOTH, rod_length)
    center = motion_centers(scene, pushing(angle), share).transpose("force_angle", ...)
    center = center.isel(force_angle=np.isfinite(center).all(("inertia_share", "xy")).values)
    parts = {f"center_{xy}": center.isel(xy=i, drop=True) for i, xy in enumerate("xy")}
    return attributed(xr.Dataset(parts)).rename({name: f"exact_{name}" for name in parts})


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the scene and both cones; compute both sets of centers."""
    scene = sources["scenes/figure_12"]
    length = rod_lengths(settings, (float(scene.rod_length),))[0]
    grid = sources["acceleration_centers"]
    data = scene[SCENE.split()].isel(solution=0)
    data = data.merge(exact_centers(grid, length))
    data = data.merge(sectors(length, float(scene.rod_angle), float(scene.radius)))
    cones = grid.sel(rod_length=length)
    for kind in ("conservative", "exact"):
        for side in ("right", "left"):
            data[f"{kind}_cone_{side}"] = cones[f"{kind}_cone_{side}"].drop_vars("rod_length")
    return titled(data, "Possible acceleration centers and accelerations", sources)


#: Radius of the cones, and length of the sectors that go on to infinity, units of length.
REACH, FAR = 2.6, 30.0
#: Colors of the paper's bound and of the exact set.
BOUND, EXACT = drawing.tint(CENTER, 0.16), drawing.tint(CENTER, 0.6)
#: Views of the two panels, units of length; the second is half the width of a square.
VIEW, DETAIL = (-3.6, 7.8, -2.35, 5.4), 1.55


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw the scene with both regions and both cones, and the ring again, larger."""
    center, ring = data.ring_center.values, float(data.radius)
    scene = drawing.schematic(figure, VIEW, rect=(0.0, 0.0, 0.65, 1.0), pad=2)
    _centers(scene, data)
    drawing.slider(scene, center, ring, width=1.4)
    drawing.fence(scene, *VIEW[:2], depth=0.2)
    _accelerations(scene, data)
    for along in (arrows.unit(float(data.rod_angle) + turn) for turn in (90, -90)):
        far = np.min(np.abs((np.where(along > 0, VIEW[1::2], VIEW[::2]) - center) / along))
        end = center + 0.9 * far * along
        labels.label(scene, end, r"$\infty$", offset=(-9.0, -7.0), color=CENTER)
    low, size = center - DETAIL * ring, 2 * DETAIL * ring
    _frame(scene, Rectangle(tuple(low), size, size))
    labels.declutter(scene)
    width, height = figure.get_size_inches()
    side = 0.34 * width / height
    box = (low[0], low[0] + size, low[1], low[1] + size)
    detail = drawing.schematic(figure, box, rect=(0.655, 0.985 - side, 0.34, side), pad=0)
    _frame(detail, Rectangle((0, 0), 1, 1, transform=detail.transAxes))
    _centers(detail, data)
    drawing.slider(detail, center, ring, width=1.4)
    handles = [Patch(facecolor=each, linewidth=0) for each in (BOUND, EXACT)]
    names = ["the paper's bound", "exact set"]
    where: dict[str, Any] = {"loc": "upper center", "bbox_to_anchor": (0.5, -0.02), "ncols": 2}
    detail.legend(handles, names, title="possible acceleration centres", **where)


def _frame(ax: Axes, frame: Rectangle) -> None:
    frame.set(fill=False, edgecolor=LIGHT, linewidth=0.7, zorder=1, clip_on=False)
    ax.add_patch(frame)


def _centers(ax: Axes, data: xr.Dataset) -> None:
    """Region of acceleration centers: the sectors of the paper's cases, and the exact set."""
    center, ring = tuple(data.ring_center.values), float(data.radius)
    inside = data.isel(sector=~data.sector_outside.values)
    sectors: list[tuple[float, float, float, float | None]] = []
    if inside.sizes["sector"]:
        ends = float(inside.sector_start.min()), float(inside.sector_stop.max())
        sectors.append((*ends, ring, None))
    outside = data.isel(sector=data.sector_outside.values)
    for start, stop in zip(outside.sector_start.values, outside.sector_stop.values, strict=True):
        sectors.append((start, stop, FAR, FAR - ring))
    for start, stop, size, width in sectors:
        patch = Wedge(center, size, start, stop, width=width, facecolor=BOUND)
        patch.set(linewidth=0, zorder=0.4)
        ax.add_patch(patch)
    # In order of the center's direction, from one translation to the other.
    order = np.argsort(np.where(data.force_angle > data.rod_angle, 0, 1), kind="stable")
    edges = np.stack([data.exact_center_x, data.exact_center_y], axis=-1)[order]
    outline = np.concatenate([edges[:, 0], edges[::-1, 1]])
    ax.add_patch(Polygon(outline, facecolor=EXACT, linewidth=0, zorder=0.6))


def _accelerations(ax: Axes, data: xr.Dataset) -> None:
    """Cones of the contact's acceleration, and a push to their left that makes the contact slip."""
    bound, exact = (
        (float(data[f"{kind}_cone_right"]), float(data[f"{kind}_cone_left"]))
        for kind in ("conservative", "exact")
    )
    drawing.cone(ax, (0, 0), *bound, REACH, MOTION, strength=0.12)
    drawing.cone(ax, (0, 0), *exact, 0.86 * REACH, MOTION, strength=0.3)
    drawing.cone(ax, (0, 0), bound[1], 180.0, 0.86 * REACH, SLIP, strength=0.25, zorder=0.3)
    for outer, inner in zip(bound, exact, strict=True):
        text = f"bound {degrees(outer)}\nexact {degrees(inner)}"
        shift = (-18.0 if outer > 90 else 6.0, 10.0 if outer > 90 else -10.0)
        labels.label(
            ax, REACH * arrows.unit(outer), text, offset=shift, color=MOTION, size=NOTE_SIZE
        )
    pusher, contact = data.pusher_motion.values, data.contact_motion.values
    scale = 0.8 * REACH / float(np.hypot(*pusher))
    arrows.motion_arrow(ax, (0, 0), scale * pusher, r"$\mathbf{a}_p$", color=PUSHER)
    arrows.motion_arrow(ax, (0, 0), scale * contact, r"$\mathbf{a}_s$", head=9)
    slip: dict[str, Any] = {
        "color": SLIP,
        "head": 9.0,
        "width": 1.0,
        "at": 0.45,
        "offset": (0.0, 7.0),
    }
    arrows.motion_arrow(ax, scale * pusher, scale * (contact - pusher), "slip", **slip)
    force = data.force.values / float(np.hypot(*data.force.values))
    arrows.force_arrow(ax, (0, 0), 0.5 * REACH * force, r"$\mathbf{f}$", offset=(0.0, -9.0))
