"""Picture of any scene: slider, fence, cones, and one solution's force, motion and center."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_pushing.figures.parts import arrows, bodies, drawing, forces, labels
from planar_pushing.figures.parts.shown import shown
from planar_pushing.figures.parts.shown import status as status_of
from planar_pushing.figures.parts.sketch import CONE, Sketch
from planar_pushing.figures.settings import Settings, Sources
from planar_pushing.figures.style import (
    ABOVE,
    CENTER,
    FORCE,
    GUIDE,
    MOTION,
    NOTE_SIZE,
    PUSHER,
    SLIP,
)

Layer = Callable[[Axes, Sketch], None]


def body(ax: Axes, sketch: Sketch) -> None:
    """Fence and slider."""
    xmin, xmax, _, _ = sketch.box()
    drawing.fence(ax, xmin, xmax, depth=0.09 * sketch.reach)
    bodies.draw_body(ax, sketch.body, sketch.pose)


def friction_cone(ax: Axes, sketch: Sketch) -> None:
    """Directions that the force can take."""
    right, left = (float(sketch.data[f"friction_cone_{side}"]) for side in ("right", "left"))
    drawing.cone(ax, (0, 0), right, left, 0.5 * sketch.reach, FORCE)


def motion_cone(ax: Axes, sketch: Sketch) -> None:
    """Directions that the slider's contact can move in."""
    right, left = (float(sketch.data[f"motion_cone_{side}"]) for side in ("right", "left"))
    drawing.cone(ax, (0, 0), right, left, CONE * sketch.reach, MOTION)


def motions(ax: Axes, sketch: Sketch) -> None:
    """Motion of the fence and of the slider's contact, and what one slips over the other."""
    pusher, slider = sketch.drawn_motion(sketch.pusher), sketch.drawn_motion(sketch.motion)
    bold = rf"\mathbf{{{sketch.symbol}}}"
    if sketch.sticks:
        wide = 18.0 * slider[0] / sketch.reach, 9.0 * slider[1] / sketch.reach
        arrows.motion_arrow(ax, (0, 0), slider, rf"${bold}_s = {bold}_p$", offset=wide)
        return
    arrows.motion_arrow(ax, (0, 0), pusher, rf"${bold}_p$", color=PUSHER)
    if sketch.moves:
        arrows.motion_arrow(ax, (0, 0), slider, rf"${bold}_s$")
        arrows.motion_arrow(
            ax,
            pusher,
            slider - pusher,
            rf"${bold}_\mathrm{{slip}}$",
            color=SLIP,
            at=0.5,
            offset=(0.0, 8.0),
            zorder=ABOVE - 0.5,
        )


def center(ax: Axes, sketch: Sketch) -> None:
    """Motion center on the perpendicular to the force, or where it lies if it is far away."""
    if not sketch.moves:
        return
    ahead = sketch.toward_center
    if sketch.center_is_near:
        drawing.guide(ax, sketch.ring, sketch.center, color=CENTER)
        noun = "acceleration" if sketch.symbol == "a" else "velocity"
        name = "pivot" if sketch.pivots else f"{noun}\ncentre"
        if sketch.pivots:
            drawing.pivot_mark(ax, sketch.center)
        drawing.center_mark(ax, sketch.center, name, offset=(30 * ahead[0], 17 * ahead[1]))
    elif np.any(ahead):
        drawing.guide(ax, sketch.ring, sketch.far_center, color=CENTER)
        far = sketch.center_distance / sketch.radius
        unit = "radii" if sketch.body.is_ring else "half-widths"
        words = f"centre\n{far:,.0f} {unit} away" if far < 1e6 else "centre\nalmost at infinity"
        labels.label(ax, sketch.far_center, words, offset=(0.0, 12.0), color=CENTER, size=NOTE_SIZE)


def moment_arm(ax: Axes, sketch: Sketch) -> None:
    """Perpendicular from the ring center to the line of force."""
    if sketch.moves:
        drawing.guide(ax, sketch.ring, sketch.foot, style=":")
        drawing.dot(ax, sketch.foot, color=FORCE, size=2.8)


def centers(ax: Axes, sketch: Sketch) -> None:
    """Names of the centers of pressure and of mass, where they are apart."""
    bodies.name_centers(ax, sketch.body, sketch.pose)


def status(ax: Axes, sketch: Sketch) -> None:
    """Say what the contact does."""
    ax.set_title(status_of(sketch.data), fontsize=NOTE_SIZE, color=GUIDE)


LAYERS: tuple[Layer, ...] = (
    body,
    motion_cone,
    friction_cone,
    forces.force,
    forces.line_of_force,
    motions,
    center,
    forces.support_friction,
    centers,
    status,
)


@dataclass(frozen=True, slots=True)
class SceneFigure:
    """Figure of one solution of a scene, by the layers that it shows."""

    layers: tuple[Layer, ...]

    def select(self, sources: Sources, settings: Settings) -> xr.Dataset:
        """Select the solution to draw."""
        (scene,) = sources.values()
        return shown(scene)

    def draw(self, figure: Figure, data: xr.Dataset) -> None:
        """Draw the layers."""
        draw_scene(figure, data, self.layers)


def draw_scene(
    target: Figure | Axes, dataset: xr.Dataset, layers: tuple[Layer, ...] = LAYERS
) -> Axes:
    """Draw a scene's dataset.

    Parameters
    ----------
    target : Figure or Axes
        What to draw on; of axes, the frame is taken away and the limits are set.
    dataset : xarray.Dataset
        A scene's dataset as the study builds it, or the part that `shown` selects.
    layers : tuple of callables
        What to show, all by default.
    """
    sketch = Sketch.of(dataset)
    top = 0.93 if status in layers else 1.0
    ax = target if isinstance(target, Axes) else target.add_axes((0, 0, 1, top))
    ax.set_axis_off()
    drawing.fit(ax, sketch.box(), pad=20.0)
    for layer in layers:
        layer(ax, sketch)
    labels.declutter(ax)
    return ax
