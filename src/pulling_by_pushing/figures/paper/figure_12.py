"""Figure 12: possible acceleration centers and accelerations with support friction and inertia."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from planar_pushing.drawing.body import Body, add_body, add_fence
from planar_pushing.drawing.canvas.colors import (
    CENTER,
    DARK,
    FORCE,
    GUIDE,
    MODES,
    MOTION,
    PUSHER,
    SLIP,
    tint,
)
from planar_pushing.drawing.canvas.marks import (
    AREAS,
    ARROWS,
    DASHES,
    Picture,
    arc,
    corners,
    unit,
)
from planar_pushing.drawing.canvas.panels import EDGE, TITLE, Texts, crop
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.drawing.scene import add_slip
from planar_pushing.drawing.supports import Ink, Pose, add_support
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.supports import Ring
from pulling_by_pushing.figures.captions import acceleration, degrees, number, values
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
REACH, FAR = 2.1, 3.2
#: Colors of the paper's bound, of the exact set, and of the sector in which the contact slips.
BOUND, EXACT, SLIPS = tint(CENTER, 0.14), tint(CENTER, 0.68), MODES[ContactMode.SLIP_RIGHT]
#: Half the width of the enlarged view of the ring, in radii, and its width in points.
DETAIL, ENLARGED = 1.5, 126.0
#: Part of the figure's width for the scene, and size of small letters in points.
SHARE, SMALL = 0.52, 8.0
#: Strength of the color of the exact cone, darker in gray than the bound on the centers.
CONE = 0.32
#: The character before a circled 1.
CIRCLED = 0x245F


def sectors(scene: xr.Dataset) -> Iterator[tuple[int, float, float, bool]]:
    """Sectors of acceleration centers about the ring center, by the paper's cases (Sec. 4).

    The center lies on the far side of the ring's center from the line of force, 90 degrees from the
    force's direction: inside the ring if the line passes outside it, outside if the line crosses it.

    Yields
    ------
    case : int
        The case: 1 and 7 for a line outside the ring, 3 and 5 for a line that crosses it.
    start, stop : float
        Ends of the sector, degrees.
    outside : bool
        Whether it is outside the ring.
    """
    rod, length, radius = (float(scene[name]) for name in ("rod_angle", "rod_length", "radius"))
    cuts = {0.0, rod, 180.0}
    if length > radius:
        tangent = float(np.rad2deg(np.arcsin(radius / length)))
        cuts |= {rod + turn for turn in (tangent, -tangent, 180 - tangent, tangent - 180)}
    for start, stop in pairwise(sorted(cut for cut in cuts if 0 <= cut <= 180)):
        arm = length * np.sin(np.deg2rad(rod - (start + stop) / 2))  # Eq. (10)
        turn, outside = 90.0 if arm > 0 else -90.0, bool(abs(arm) < radius)
        case = (3 if outside else 1) if arm > 0 else (5 if outside else 7)
        yield case, start + turn, stop + turn, outside


def caption(data: Data) -> str:
    """Caption with the plotted values."""
    scene = data["scenes/figure_12"]
    names = (
        "pusher_angle", "rod_length", "rod_angle", "friction_coefficient", "radius", "weight", "mass",
        "gyration_radius",
    )  # fmt: skip
    return (
        "Slip with infinite friction, support friction and inertia. Numbers: the paper's cases, as the "
        "direction of f turns from right to left. The line of force passes the ring on the right (1), "
        "touches it (2), crosses it to the right of its center (3), passes through the center (4), and "
        "likewise on the left (5 to 7). The acceleration center is then opposite: inside the ring "
        "(1, 7), on it (2, 6), outside it (3, 5), or at infinity (4). Light: the paper's bound; "
        "dark: the exact set. Blue: accelerations of the contact in the exact cone, and those that the "
        "bound adds (hatched). For a fence acceleration in the yellow sector the contact slips whatever "
        "the magnitude; the dashed arrow is the slip, the acceleration relative to the fence "
        f"({values(scene, *names)}, |aₚ| = {number(acceleration(scene))}\N{NO-BREAK SPACE}μₛg)."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw the scene with both regions and both cones, and an enlarged view of the ring."""
    cones, scene = (data[name] for name in FIGURE.reads)
    frame = corners([scene.ring_center.values], DETAIL * float(scene.radius))
    left, right = _scene_picture(scene, cones, frame), _detail(scene, frame)
    _lay_out(figure, left, right, frame)


def _scene_picture(scene: xr.Dataset, cones: xr.Dataset, frame: Array) -> Picture:
    """The scene with the frame of the enlarged view, and the numbers of the cases far from the ring."""
    picture, center, rod = Picture(), scene.ring_center.values, float(scene.rod_angle)
    _centers(picture, scene, FAR)
    pose = Pose(center, math.radians(rod))
    add_body(picture, Body(support=Ring(float(scene.radius))), pose, ink=Ink(width=1.4))
    add_fence(picture, -1.05 * REACH, center[0] + 0.6 * FAR, depth=0.2)
    _accelerations(picture, scene.isel(solution=0), cones)
    _add_frame(picture, frame)
    for case, start, stop, outside in sectors(scene):
        if outside:  # off the exact set, which lies at the end of the sector across the rod
            turn = 0.62 * (start if case == 3 else stop) + 0.38 * (stop if case == 3 else start)
            _number(picture, center + 0.85 * FAR * unit(turn), case)
    for turn in (90.0, -90.0):
        x, y = unit(rod + turn)
        end = center + FAR * np.array([x, y])
        picture.label(end, r"$\infty$", offset=(9.0 * x, 9.0 * y), color=CENTER, held=True)
        _number(picture, end, 4, (21.0 * x, 21.0 * y))
    return picture


def _detail(scene: xr.Dataset, frame: Array) -> Picture:
    """The ring with the centers near it, and the numbers of the cases there."""
    picture, center, ring = Picture(), scene.ring_center.values, float(scene.radius)
    _centers(picture, scene, 0.98 * DETAIL * ring)
    add_support(picture, Ring(ring), Pose(center, 0.0), Ink(width=1.4))
    rod = unit(float(scene.rod_angle))
    picture.line([center, center - DETAIL * ring / np.max(np.abs(rod)) * rod], width=0.84)
    picture.dot(center, 2.2)
    _add_frame(picture, frame)
    for case, start, stop, outside in sectors(scene):
        if outside:
            continue
        _number(picture, center + 0.78 * ring * unit((start + stop) / 2), case)
        touches, other = (stop, start) if case == 1 else (start, stop)
        picture.guide(center, center + ring * unit(other), CENTER, dash=":")
        picture.dot(center + ring * unit(touches), 3.5, CENTER, order=ARROWS)
        beside = touches + math.copysign(11.0, other - touches)
        _number(picture, center + 1.22 * ring * unit(beside), 2 if case == 1 else 6)
    return picture


def _number(
    picture: Picture, position: Array, case: int, offset: tuple[float, float] = (0, 0)
) -> None:
    """Add the number of a case in a circle."""
    picture.label(position, chr(CIRCLED + case), size=11.0, color=CENTER, offset=offset, held=True)


def _lay_out(figure: Any, left: Picture, right: Picture, frame: Array) -> None:
    """Draw the scene, to its right the enlarged view with its title and the link, and the legend below."""
    from matplotlib.patches import ConnectionPatch

    wide = 72 * figure.get_figwidth()
    texts = Texts(figure.dpi)
    scene, detail = crop(texts, left, SHARE * wide), crop(texts, right, ENLARGED)
    high = float(scene.size[1]) + 2 * EDGE
    figure.set_figheight(high / 72)
    middle = (scene.size[0] + wide) / 2
    low = high - EDGE - TITLE - float(detail.size[1])
    axes = scene.draw(figure, EDGE, EDGE), detail.draw(figure, middle - ENLARGED / 2, low)
    title = f"near the ring, {detail.scale / scene.scale:.1f} times larger"
    figure.text(
        middle / wide, 1 - EDGE / high, title, ha="center", va="top", size=SMALL, color=DARK
    )
    for y in frame[:, 1]:
        ends = (frame[1, 0], y), (frame[0, 0], y)
        link = ConnectionPatch(*ends, axes[0].transData, axes[1].transData, color=GUIDE, linewidth=0.6,
                               zorder=-1)  # fmt: skip
        figure.add_artist(link)
    _add_legend(figure, middle / wide)


def _add_frame(picture: Picture, frame: Array) -> None:
    """Add the frame of the enlarged view."""
    (low_x, low_y), (high_x, high_y) = frame
    corner_points = [
        (low_x, low_y),
        (high_x, low_y),
        (high_x, high_y),
        (low_x, high_y),
        (low_x, low_y),
    ]
    picture.line(corner_points, GUIDE, width=0.6)


def _add_legend(figure: Any, middle: float) -> None:
    """Add a legend at the lower edge, about a position as a fraction of the width."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    looks = (
        ("centers: bound of the paper", BOUND, ""), ("centers: exact set", EXACT, ""),
        ("accelerations: exact cone", tint(MOTION, CONE), ""),
        ("accelerations added by the bound", tint(MOTION, 0.06), "////"),
        ("slip whatever the magnitude", SLIPS.fill, SLIPS.hatch),
    )  # fmt: skip
    handles: list[Any] = [
        Patch(facecolor=color, hatch=hatch, edgecolor=DARK, linewidth=0.4, label=text)
        for text, color, hatch in looks
    ]
    slip = Line2D([], [], color=SLIP, linestyle=(0, DASHES["--"]), linewidth=1.0,
                  label="slip: acceleration relative to the fence")  # fmt: skip
    figure.legend(handles=[*handles, slip], loc="lower center", fontsize=SMALL, ncols=1,
                  bbox_to_anchor=(middle, 0.0), borderaxespad=0.2)  # fmt: skip


def _centers(picture: Picture, scene: xr.Dataset, far: float) -> None:
    """Draw the acceleration centers up to a distance: sectors of the paper's cases, and the exact set."""
    center, ring = scene.ring_center.values, float(scene.radius)
    for _, start, stop, outside in sectors(scene):
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
    kept = []
    for i, (point, size) in enumerate(zip(path, away, strict=True)):
        if i and (size <= far) != (away[i - 1] <= far):
            part = (far - away[i - 1]) / (size - away[i - 1])
            kept.append(path[i - 1] + part * (point - path[i - 1]))
        if size <= far:
            kept.append(point)
    return np.array(kept)


def _accelerations(picture: Picture, scene: xr.Dataset, cones: xr.Dataset) -> None:
    """Draw the cones of the contact acceleration and, to their left, a push that makes the contact slip."""
    bound, exact = (
        np.deg2rad([float(cones[f"{kind}_cone_right"]), float(cones[f"{kind}_cone_left"])])
        for kind in ("conservative", "exact")
    )
    picture.cone(bound[0], bound[1], REACH, MOTION, strength=0.06, hatch="////", order=AREAS + 0.5)
    picture.cone(exact[0], exact[1], REACH, MOTION, strength=CONE, order=AREAS + 0.7)
    sector = np.vstack([(0.0, 0.0), 0.86 * REACH * arc(bound[1], math.pi)])
    picture.area(sector, color=SLIPS.fill, hatch=SLIPS.hatch, ink=SLIPS.ink, order=AREAS + 0.3)
    for outer, inner in zip(bound, exact, strict=True):
        text = f"bound {degrees(math.degrees(outer))}\nexact {degrees(math.degrees(inner))}"
        shift, align = ((-3.0, 6.0), "right") if outer > math.pi / 2 else ((4.0, -4.0), "left")
        picture.label(REACH * direction(outer), text, offset=shift, color=MOTION, size=SMALL,
                      align=align, held=True)  # fmt: skip
    pusher, contact = scene.pusher_motion.values, scene.contact_motion.values
    scale = 0.95 * REACH / float(np.hypot(*pusher))
    picture.motion((0, 0), scale * pusher, r"$\mathbf{a}_p$", color=PUSHER)
    picture.motion((0, 0), scale * contact, r"$\mathbf{a}_s$", head=9)
    add_slip(picture, scale * pusher, scale * (contact - pusher), "")
    force = scene.force.values / float(np.hypot(*scene.force.values))
    picture.force((0, 0), 0.5 * REACH * force)
    picture.label(0.5 * REACH * force, r"$\mathbf{f}$", color=FORCE, offset=(0.0, -13.0), held=True)
