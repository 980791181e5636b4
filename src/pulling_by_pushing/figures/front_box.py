"""The picture of README's first example: the three motions of a box from which a fence retreats."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from planar_pushing.drawing.body import add_body, add_fence, body_in
from planar_pushing.drawing.canvas.axes import schematic, to_axes
from planar_pushing.drawing.canvas.colors import DARK, FENCE, LIGHT, MODES, SLIDER
from planar_pushing.drawing.canvas.marks import NOTE, Picture, corners
from planar_pushing.drawing.canvas.style import paper_style
from planar_pushing.drawing.motion import (
    DEPTH,
    add_first_pusher,
    add_velocity,
    box,
    fence_ends,
    force_arrows,
    pose,
    span,
)
from planar_pushing.drawing.supports import Ink
from planar_pushing.drawing.timeline import path_data, rod_end
from planar_pushing.mechanics.contact import ContactMode, Coulomb
from planar_pushing.mechanics.effects import SupportFriction, weight
from planar_pushing.mechanics.plane import direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.supports import Polygon
from planar_pushing.objects.scene_at import scene_at
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.simulate import simulate
from planar_pushing.terms.options import PolicyName

#: Direction of the fence, degrees, its speed, m/s, and the duration, s.
DIRECTION, SPEED, DURATION = -8.0, 0.05, 1.7
#: Size of the picture in inches, its pixels per inch, and the padding around a drawing in points.
SIZE, DPI, PAD = (7.4, 2.35), 110, 6.0
#: Height of the words above the drawings, inches, and their size, points.
WORDS, TITLE = 0.4, 11.0
#: The motions, each with its policy and its words.
MOTIONS: dict[ContactMode, tuple[PolicyName, str]] = {
    ContactMode.SEPARATE: ("separate", "The box stays behind."),
    ContactMode.STICK: ("stick", "It follows the fence."),
    ContactMode.SLIP_LEFT: ("slip-left", "It follows, and its corner slips."),
}


def box_scene() -> Scene:
    """The box of README, 0.3 m by 0.2 m, with the fence at a corner."""
    base = Polygon.rectangle(0.3, 0.2)
    friction = SupportFriction(support=base, weight=weight(1.2, 0.3))
    return scene_at((-0.15, -0.1), (1, 4), effects=(friction,), contact=Coulomb(2.0), outline=base)


def box_motions() -> dict[ContactMode, xr.Dataset]:
    """Data for the pictures of the three motions, whose contact stays in its mode."""
    velocity = tuple(SPEED * direction(np.deg2rad(DIRECTION)))
    pusher, motions = Pusher(velocity=velocity), {}
    for mode, (policy, _) in MOTIONS.items():
        log = simulate(box_scene(), pusher=pusher, duration=DURATION, on_ambiguity=policy)
        motions[mode] = path_data(log)
    return motions


def end_picture(data: xr.Dataset) -> Picture:
    """Picture of the end of a motion, with the box at its start in gray."""
    picture, row = Picture(), data.sizes["time"] - 1
    start = pose(data, 0)
    corner, body = rod_end(data), body_in(data)
    add_body(picture, body, start, contact=corner[0], ink=Ink(LIGHT, 1.2))
    add_body(picture, body, pose(data, row), contact=corner[row], ink=Ink(SLIDER, 1.5))
    add_first_pusher(picture, data, row)
    (x, y), (start_x, end_x) = data["path_pusher"].values[row], fence_ends(data)
    add_fence(
        picture, x + start_x, x + end_x, y=y, color=FENCE, width=1.0, depth=DEPTH * span(data)
    )
    add_velocity(picture, data, row)
    arrow = force_arrows(data)[row]
    if np.any(arrow):
        picture.force(corner[row], arrow, r"$\mathbf{f}$", head=9.0, width=1.2)
    return picture


def box_picture() -> Image.Image:
    """The three motions side by side."""
    motions, figure = box_motions(), Figure(figsize=SIZE, dpi=DPI)
    limits = corners([box(data) for data in motions.values()])
    with paper_style():
        for column, (mode, data) in enumerate(motions.items()):
            left, high = column / len(motions), 1.0 - WORDS / SIZE[1]
            axes = schematic(figure, (left, 0.0, 1.0 / len(motions), high))
            to_axes(end_picture(data), axes, limits, PAD)
            _, words = MOTIONS[mode]
            figure.text(left + 0.02, 0.97, mode.name, size=TITLE, color=MODES[mode].ink, va="top")
            figure.text(left + 0.02, 0.87, words, size=NOTE + 2, color=DARK, va="top")
        canvas: Any = FigureCanvasAgg(figure)
        canvas.draw()
    return Image.fromarray(np.asarray(canvas.buffer_rgba())[..., :3].copy())
