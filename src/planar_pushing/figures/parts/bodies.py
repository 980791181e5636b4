"""The slider of a picture: its support, and its centers of pressure and of mass."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.path import Path

from planar_pushing.figures.parts import drawing, labels
from planar_pushing.figures.parts.supports import Ink, Pose, draw_support, extents
from planar_pushing.figures.style import ABOVE, DARK, NOTE_SIZE
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.supports import Ring
from planar_pushing.study.datasets.rubbing import support_of
from planar_pushing.study.files.scene_model import SceneFile

#: Keys of a scene file that do not describe a motion over time.
OWN = ("slider", "contact", "effects")
#: A center nearer to the origin of the body than this, in units of the support's size, is there.
NEAR = 1e-6
#: By how much dots and signs reach beyond their places, in units of half the support.
RIM = 0.07
#: Two quarters of a disc, the sign of a center of mass.
QUARTERS = Path.make_compound_path(Path.wedge(0, 90), Path.wedge(180, 270))
#: Diameters of the signs, points.
MASS, PRESSURE = 7.5, 7.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Body:
    """A slider in its body frame, with the centers that are marked: those that are not its origin."""

    support: Any
    centers: tuple[tuple[str, Any], ...] = ()

    @property
    def half(self) -> float:
        """Half of the support's larger side; a ring's radius."""
        return float(np.ptp(self.bounds, axis=0).max() / 2)

    @property
    def bounds(self) -> Array:
        """Corners of the box around the support, sides along the axes of the body."""
        return _bounds(self.support)

    @property
    def middle(self) -> Array:
        """Middle of that box."""
        return np.asarray(self.bounds.mean(axis=0))

    @property
    def is_ring(self) -> bool:
        return isinstance(self.support, Ring)

    def box(self, pose: Pose) -> Array:
        """Corners of the upright box around the support and what is marked, in a place."""
        points = [*extents(self.support, pose), *(pose.at(place) for _, place in self.centers)]
        rim = 0.0 if self.is_ring else RIM * self.half
        return np.array([np.min(points, axis=0) - rim, np.max(points, axis=0) + rim])


@lru_cache(maxsize=16)
def _bounds(support: Any) -> Array:
    return extents(support, Pose((0.0, 0.0), 0.0))


def body_of(data: xr.Dataset) -> Body:
    """The slider of a scene's dataset or of a log; a ring where the dataset names no scene."""
    named = data.attrs.get("scene") or data.attrs.get("parameters")
    if named is None:
        return Body(support=Ring(float(data["radius"])))
    return _read(named)


@lru_cache(maxsize=16)
def _read(text: str) -> Body:
    """The slider of a scene, as attributes hold it."""
    given = json.loads(text)
    return body_in(given.get("scene", given))


def body_in(entry: dict[str, Any]) -> Body:
    """The slider of a scene file's content."""
    return body_of_scene(SceneFile.model_validate({name: entry[name] for name in OWN}).build())


def body_of_scene(scene: Scene) -> Body:
    """The slider of a scene."""
    support = support_of(scene)
    if scene.isotropic:
        return Body(support=support)
    pressure = support.center_of_pressure
    mass = tuple(scene.slider.radius * each for each in scene.mass_center)
    found = {"pressure": pressure} if scene.friction else {}
    found |= {"mass": mass} if scene.masses else {}
    near = NEAR * support.extent
    apart = any(np.hypot(*place) > near for place in found.values())
    return Body(support=support, centers=tuple(found.items()) if apart else ())


def draw_body(
    ax: Axes, body: Body, pose: Pose, *, contact: npt.ArrayLike = (0.0, 0.0), ink: Ink | None = None
) -> None:
    """Support, rod, contact, and the signs of the centers."""
    own = ink or Ink()
    draw_support(ax, body.support, pose, own)
    drawing.rod(ax, pose.origin, contact=contact, width=own.width, color=own.color)
    for name, place in body.centers:
        for sign in SIGNS[name](own.color):
            ax.plot(*pose.at(place), zorder=ABOVE - 0.5, **sign)


def _pressure_signs(color: str) -> list[dict[str, Any]]:
    return [{"marker": "P", "mfc": color, "mec": "white", "mew": 0.6, "markersize": PRESSURE}]


def _mass_signs(color: str) -> list[dict[str, Any]]:
    disc = {"marker": "o", "mfc": "white", "mec": color, "mew": 0.9, "markersize": MASS}
    return [disc, {"marker": QUARTERS, "mfc": color, "mew": 0.0, "markersize": MASS}]


#: Name of each center, and the markers of its sign.
NAMES = {"pressure": "centre of\npressure", "mass": "centre\nof mass"}
SIGNS = {"pressure": _pressure_signs, "mass": _mass_signs}


def name_centers(ax: Axes, body: Body, pose: Pose) -> None:
    """Write the names of the centers beside their signs."""
    back = {"boxstyle": "square,pad=0.1", "facecolor": "white", "linewidth": 0, "alpha": 0.75}
    note: dict[str, Any] = {"color": DARK, "size": NOTE_SIZE, "bbox": back}
    for name, place in body.centers:
        labels.label(ax, pose.at(place), NAMES[name], offset=(0.0, -14.0), **note)


def explain_centers(ax: Axes, body: Body) -> None:
    """Legend of the signs of the centers, where there are any."""
    if body.centers:
        names = [NAMES[name].replace("\n", " ") for name, _ in body.centers]
        signs = [
            tuple(Line2D([], [], linestyle="none", **sign) for sign in SIGNS[name](DARK))
            for name, _ in body.centers
        ]
        row: dict[str, Any] = {"ncols": len(names), "borderpad": 0.0, "borderaxespad": 0.15}
        ax.legend(signs, names, loc="lower left", handletextpad=0.3, columnspacing=1.2, **row)
