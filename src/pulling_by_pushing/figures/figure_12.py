"""Figure 12: possible acceleration centers and accelerations with support friction and inertia."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.drawing.body import Body, add_body, add_fence
from planar_pushing.drawing.canvas.axes import Panel, is_column, panels
from planar_pushing.drawing.canvas.colors import CENTER, DARK, MODES, MOTION, PUSHER, tint
from planar_pushing.drawing.canvas.marks import AREAS, NOTE, Picture, arc, corners, unit
from planar_pushing.drawing.canvas.style import COLUMN, PAGE
from planar_pushing.drawing.scene import add_slip
from planar_pushing.drawing.supports import Ink, Pose
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.force.centers import motion_centers
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.supports import Ring
from planar_pushing.terms.options import EffectSet
from pulling_by_pushing.figures.figure import BOTH, DYNAMICS, Figure, Settings, Sources
from pulling_by_pushing.figures.parts.data import (
    attributed,
    degrees,
    labeled,
    named,
    scene_of,
    titled,
    values,
)
from pulling_by_pushing.study.datasets.base import pushing

FIGURE = Figure(
    title="Possible acceleration centers and accelerations",
    reads=("acceleration_centers", "scenes/figure_12"),
    takes=("rod_length",),
    needs=BOTH,
    size=(PAGE, 3.2),
    column=(COLUMN, 5.5),
    section=DYNAMICS,
    promise="slip with infinite friction under support friction and inertia, l = 5.",
)
#: Force angles of the boundaries, degrees.
ANGLES = np.linspace(0.0, 180.0, 181)
SCENE = (
    "rod_length rod_angle radius ring_center pusher_angle pusher_magnitude pusher_motion "
    "contact_motion force friction_cone_right friction_cone_left"
)
#: Radius of the cones, and distance from the ring's center at which regions are clipped, units of length.
REACH, FAR = 2.6, 4.6
#: Colors of the paper's bound, of the exact set, and of the sector in which the contact slips.
BOUND, EXACT, SLIPS = tint(CENTER, 0.2), tint(CENTER, 0.68), MODES[ContactMode.SLIP_RIGHT]
#: Half the width of the detail view of the ring, in radii.
DETAIL = 1.5


def sectors(rod_length: float, rod_angle: float, radius: float) -> xr.Dataset:
    """Sectors of acceleration centers about the ring center, by the paper's cases (Sec. 4).

    The center lies on the far side of the ring's center from the line of force, 90 degrees from the
    force's direction: inside the ring if the line passes outside it, outside if the line crosses it.
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
        {f"sector_{name}": named("sector", each, sign, words) for name, each, sign, words in parts}
    )


def exact_centers(grid: xr.Dataset, rod_length: float) -> xr.Dataset:
    """Boundaries of the exact set of centers, for friction alone and for inertia alone.

    The force angles of the grid are too coarse for smooth curves, so the boundaries are computed here.
    Force angles with a center at infinity (a translation) are omitted.
    """
    angle, share = labeled("force_angle", ANGLES), labeled("inertia_share", (0.0, 1.0))
    scene = scene_of(grid, EffectSet.BOTH, rod_length)
    phi: xr.DataArray = pushing(angle)
    center = motion_centers(scene, phi, share).transpose("force_angle", ...)
    finite: xr.DataArray = xr.ufuncs.isfinite(center)
    center = center.isel(force_angle=finite.all(("inertia_share", "xy")).values)
    parts = {f"center_{xy}": center.isel(xy=i, drop=True) for i, xy in enumerate("xy")}
    return attributed(xr.Dataset(parts)).rename({name: f"exact_{name}" for name in parts})


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the scene and both cones, and compute both sets of centers."""
    scene, grid = sources["scenes/figure_12"], sources["acceleration_centers"]
    length = settings.rod_length
    data = scene[SCENE.split()].isel(solution=0)
    data = data.merge(exact_centers(grid, length))
    data = data.merge(sectors(length, float(scene.rod_angle), float(scene.radius)))
    cones = grid.sel(rod_length=length)
    for kind in ("conservative", "exact"):
        for side in ("right", "left"):
            data[f"{kind}_cone_{side}"] = cones[f"{kind}_cone_{side}"].drop_vars("rod_length")
    return titled(data, "Possible acceleration centers and accelerations", sources)


def caption(data: xr.Dataset) -> str:
    """Caption with the plotted values."""
    push = values(data, "pusher_angle", "pusher_magnitude")
    names = "rod_length rod_angle friction_coefficient radius weight mass gyration_radius"
    known = f"{push}, {values(data, *names.split())}"
    return (
        "Slip with infinite friction, support friction and inertia. Possible acceleration "
        "centers: the paper's bound from the geometry of the line of force (light), and the exact "
        "set (dark), which narrows to a point where the line of force touches the ring; both "
        "extend to infinity. Possible accelerations of the contact (blue): the exact cone, and the "
        "sectors that the bound adds to it (hatched). If the fence accelerates in the hatched "
        "yellow sector, between the cone and the left end of the fence, the contact slips whatever "
        f"the magnitude of the acceleration ({known})."
    )


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw the scene with both regions and both cones, and a detail view of the ring."""
    center, ring = data.ring_center.values, float(data.radius)
    scene, detail = Picture(), Picture()
    for picture, far in ((scene, FAR), (detail, 0.98 * DETAIL * ring)):
        _centers(picture, data, far)
        pose = Pose(center, math.radians(float(data.rod_angle)))
        add_body(picture, Body(support=Ring(ring)), pose, ink=Ink(width=1.4))
    left, right = -1.3 * REACH, center[0] + FAR
    add_fence(scene, left, right, depth=0.2)
    _accelerations(scene, data)
    for turn in (90, -90):
        place = center + FAR * unit(float(data.rod_angle) + turn)
        offset = tuple(map(float, 10.0 * unit(float(data.rod_angle) + turn)))
        scene.label(place, r"$\infty$", offset=offset, color=CENTER)
    detail.marks[:] = [mark for mark in detail.marks if _inside(mark, center, DETAIL * ring)]
    boxes = (
        corners([(left, -0.85 * REACH), center + FAR * unit(90)]),
        corners([center - [0.0, ring], center], DETAIL * ring),
    )
    boxes[0][1, 0] = right
    given = [Panel(scene, boxes[0], pad=27.0), Panel(detail, boxes[1], pad=10.0)]
    narrow = is_column(figure)
    axes = panels(figure, given, 1 if narrow else 2, share=None if narrow else (0.66, 0.34))
    _legend(axes[1])


def _inside(mark: Any, center: Array, half: float) -> bool:
    """Whether a mark is near the ring and belongs to the detail view; the contact is not."""
    place = getattr(mark, "place", None)
    return place is None or bool(np.all(np.abs(place - center) <= half))


def _legend(ax: Any) -> None:
    from matplotlib.patches import Patch

    looks = (
        ("paper's bound on the centers", BOUND, ""), ("exact set of centers", EXACT, ""),
        ("exact acceleration cone", tint(MOTION, 0.25), ""),
        ("added by the bound", tint(MOTION, 0.06), "////"),
        ("slip whatever the magnitude", SLIPS.fill, SLIPS.hatch),
    )  # fmt: skip
    handles = [
        Patch(facecolor=color, hatch=hatch, edgecolor=DARK, linewidth=0.4, label=text)
        for text, color, hatch in looks
    ]
    ax.legend(handles=handles, loc="lower center", bbox_to_anchor=(0.5, 0.0), ncols=1)


def _centers(picture: Picture, data: xr.Dataset, far: float) -> None:
    """Draw the acceleration centers up to a distance: sectors of the paper's cases, and the exact set."""
    center, ring = data.ring_center.values, float(data.radius)
    for start, stop, outside in zip(
        data.sector_start.values, data.sector_stop.values, data.sector_outside.values, strict=True
    ):
        rim = arc(math.radians(start), math.radians(stop))
        inner = ring * rim[::-1] if outside else [(0.0, 0.0)]
        around = np.vstack([(far if outside else ring) * rim, inner])
        picture.area(center + around, color=BOUND, order=AREAS + 0.3)
    for outline in _outlines(data, center, far):
        picture.area(outline, color=EXACT, order=AREAS + 0.4)


def _outlines(data: xr.Dataset, center: Array, far: float) -> Iterator[Array]:
    """Outlines of the exact set up to a distance, ordered by the direction of the centers."""
    order = np.argsort(np.where(data.force_angle > data.rod_angle, 0, 1), kind="stable")
    edges = np.stack([data.exact_center_x, data.exact_center_y], axis=-1)[order] - center
    one, other = (_cut(edges[:, side], far) for side in (0, 1))
    yield center + np.concatenate([one, other[::-1]])


def _cut(path: Array, far: float) -> Array:
    """Section of a path within a distance, with the points at which it crosses this distance."""
    away = np.hypot(*path.T)
    found = []
    for i, (point, size) in enumerate(zip(path, away, strict=True)):
        if i and (size <= far) != (away[i - 1] <= far):
            part = (far - away[i - 1]) / (size - away[i - 1])
            found.append(path[i - 1] + part * (point - path[i - 1]))
        if size <= far:
            found.append(point)
    return np.array(found)


def _accelerations(picture: Picture, data: xr.Dataset) -> None:
    """Draw the cones of the contact acceleration and, to their left, a push that makes the contact slip."""
    bound, exact = (
        np.deg2rad([float(data[f"{kind}_cone_right"]), float(data[f"{kind}_cone_left"])])
        for kind in ("conservative", "exact")
    )
    picture.cone(bound[0], bound[1], REACH, MOTION, strength=0.06, hatch="////", order=AREAS + 0.5)
    picture.cone(exact[0], exact[1], REACH, MOTION, strength=0.25, order=AREAS + 0.7)
    sector = np.vstack([(0.0, 0.0), 0.86 * REACH * arc(bound[1], math.pi)])
    picture.area(sector, color=SLIPS.fill, hatch=SLIPS.hatch, ink=SLIPS.ink, order=AREAS + 0.3)
    for outer, inner in zip(bound, exact, strict=True):
        text = f"bound {degrees(math.degrees(outer))}\nexact {degrees(math.degrees(inner))}"
        left = outer > math.pi / 2
        shift = (-24.0, 9.0) if left else (8.0, -11.0)
        picture.label(
            REACH * direction(outer), text, offset=shift, color=MOTION, size=NOTE, held=True
        )
    pusher, contact = data.pusher_motion.values, data.contact_motion.values
    scale = 0.95 * REACH / float(np.hypot(*pusher))
    picture.motion((0, 0), scale * pusher, r"$\mathbf{a}_p$", color=PUSHER)
    picture.motion((0, 0), scale * contact, r"$\mathbf{a}_s$", head=9)
    add_slip(picture, scale * pusher, scale * (contact - pusher), "slip", at=0.45)
    force = data.force.values / float(np.hypot(*data.force.values))
    picture.force((0, 0), 0.5 * REACH * force, r"$\mathbf{f}$", offset=(0.0, -9.0))
