"""Figure 12: possible acceleration centers and accelerations with support friction and inertia."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from planar_pushing.drawing.body import Body, add_body, add_fence
from planar_pushing.drawing.canvas.axes import Panel, panels
from planar_pushing.drawing.canvas.colors import CENTER, DARK, MODES, MOTION, PUSHER, tint
from planar_pushing.drawing.canvas.marks import AREAS, NOTE, Picture, arc, corners, unit
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.drawing.scene import add_slip
from planar_pushing.drawing.supports import Ink, Pose
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.supports import Ring
from pulling_by_pushing.figures.captions import degrees, values
from pulling_by_pushing.figures.figure import DYNAMICS, Data, Figure

if TYPE_CHECKING:
    import xarray as xr

FIGURE = Figure(
    title="Possible acceleration centers and accelerations",
    reads=("acceleration_centers", "scenes/figure_12"),
    size=(PAGE, 3.2),
    takes=("rod_length",),
    section=DYNAMICS,
    promise="slip with infinite friction under support friction and inertia, l = 5.",
)
#: Radius of the cones, and distance from the ring's center at which regions are clipped, units of length.
REACH, FAR = 2.6, 4.6
#: Colors of the paper's bound, of the exact set, and of the sector in which the contact slips.
BOUND, EXACT, SLIPS = tint(CENTER, 0.2), tint(CENTER, 0.68), MODES[ContactMode.SLIP_RIGHT]
#: Half the width of the detail view of the ring, in radii.
DETAIL = 1.5


def sectors(scene: xr.Dataset) -> Iterator[tuple[float, float, bool]]:
    """Sectors of acceleration centers about the ring center, by the paper's cases (Sec. 4).

    The center lies on the far side of the ring's center from the line of force, 90 degrees from the
    force's direction: inside the ring if the line passes outside it, outside if the line crosses it.

    Yields
    ------
    start, stop : float
        Ends of the sector, degrees.
    outside : bool
        Whether it is outside the ring.
    """
    rod, length, radius = (float(scene[name]) for name in ("rod_angle", "rod_length", "radius"))
    cuts = {0.0, rod, 180.0}
    if length > radius:
        lean = float(np.rad2deg(np.arcsin(radius / length)))
        cuts |= {rod + turn for turn in (lean, -lean, 180 - lean, lean - 180)}
    for start, stop in pairwise(sorted(cut for cut in cuts if 0 <= cut <= 180)):
        arm = length * np.sin(np.deg2rad(rod - (start + stop) / 2))  # Eq. (10)
        turn = 90.0 if arm > 0 else -90.0
        yield start + turn, stop + turn, bool(abs(arm) < radius)


def caption(data: Data) -> str:
    """Caption with the plotted values."""
    names = (
        "pusher_angle", "pusher_magnitude", "rod_length", "rod_angle", "friction_coefficient", "radius",
        "weight", "mass", "gyration_radius",
    )  # fmt: skip
    known = values(data["scenes/figure_12"], *names)
    return (
        "Slip with infinite friction, support friction and inertia. Possible acceleration "
        "centers: the paper's bound from the geometry of the line of force (light), and the exact "
        "set (dark), which narrows to a point where the line of force touches the ring; both "
        "extend to infinity. Possible accelerations of the contact (blue): the exact cone, and the "
        "sectors that the bound adds to it (hatched). If the fence accelerates in the hatched "
        "yellow sector, between the cone and the left end of the fence, the contact slips whatever "
        f"the magnitude of the acceleration ({known})."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw the scene with both regions and both cones, and a detail view of the ring."""
    cones, scene = (data[name] for name in FIGURE.reads)
    center, ring, rod = scene.ring_center.values, float(scene.radius), float(scene.rod_angle)
    whole, detail = Picture(), Picture()
    for picture, far in ((whole, FAR), (detail, 0.98 * DETAIL * ring)):
        _centers(picture, scene, far)
        pose = Pose(center, math.radians(rod))
        add_body(picture, Body(support=Ring(ring)), pose, ink=Ink(width=1.4))
    left, right = -1.3 * REACH, center[0] + FAR
    add_fence(whole, left, right, depth=0.2)
    _accelerations(whole, scene.isel(solution=0), cones)
    for turn in (90, -90):
        place = center + FAR * unit(rod + turn)
        offset = tuple(map(float, 10.0 * unit(rod + turn)))
        whole.label(place, r"$\infty$", offset=offset, color=CENTER)
    detail.marks[:] = [mark for mark in detail.marks if _inside(mark, center, DETAIL * ring)]
    boxes = (
        corners([(left, -0.85 * REACH), center + FAR * unit(90)]),
        corners([center - [0.0, ring], center], DETAIL * ring),
    )
    boxes[0][1, 0] = right
    given = [Panel(whole, boxes[0], pad=27.0), Panel(detail, boxes[1], pad=10.0)]
    axes = panels(figure, given, 2, share=(0.66, 0.34))
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


def _centers(picture: Picture, scene: xr.Dataset, far: float) -> None:
    """Draw the acceleration centers up to a distance: sectors of the paper's cases, and the exact set."""
    center, ring = scene.ring_center.values, float(scene.radius)
    for start, stop, outside in sectors(scene):
        rim = arc(math.radians(start), math.radians(stop))
        inner = ring * rim[::-1] if outside else [(0.0, 0.0)]
        around = np.vstack([(far if outside else ring) * rim, inner])
        picture.area(center + around, color=BOUND, order=AREAS + 0.3)
    picture.area(_exact_set(scene, far), color=EXACT, order=AREAS + 0.4)


def _exact_set(scene: xr.Dataset, far: float) -> Array:
    """Outline of the exact set up to a distance, between the centers under either effect alone.

    It is ordered by the direction of the centers; those at infinity, of a translation, are left out.
    """
    edges = scene.cone_center.transpose("cone_sample", "effect", "xy").values
    finite = np.isfinite(edges).all(axis=(1, 2))
    angle, edges = scene.cone_force_angle.values[finite], edges[finite]
    order = np.argsort(np.where(angle > float(scene.rod_angle), 0, 1), kind="stable")
    around = edges[order] - scene.ring_center.values
    one, other = (_cut(around[:, side], far) for side in (0, 1))
    return np.asarray(scene.ring_center.values + np.concatenate([one, other[::-1]]))


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


def _accelerations(picture: Picture, scene: xr.Dataset, cones: xr.Dataset) -> None:
    """Draw the cones of the contact acceleration and, to their left, a push that makes the contact slip."""
    bound, exact = (
        np.deg2rad([float(cones[f"{kind}_cone_right"]), float(cones[f"{kind}_cone_left"])])
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
    pusher, contact = scene.pusher_motion.values, scene.contact_motion.values
    scale = 0.95 * REACH / float(np.hypot(*pusher))
    picture.motion((0, 0), scale * pusher, r"$\mathbf{a}_p$", color=PUSHER)
    picture.motion((0, 0), scale * contact, r"$\mathbf{a}_s$", head=9)
    add_slip(picture, scale * pusher, scale * (contact - pusher), "slip", at=0.45)
    force = scene.force.values / float(np.hypot(*scene.force.values))
    picture.force((0, 0), 0.5 * REACH * force, r"$\mathbf{f}$", offset=(0.0, -9.0))
