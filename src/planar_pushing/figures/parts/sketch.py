"""What a picture of a scene shows: the chosen solution, and how long its arrows are drawn."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np
import xarray as xr

from planar_pushing.figures.parts.arrows import unit
from planar_pushing.mechanics.contact import ContactMode, Outcome
from planar_pushing.mechanics.plane import Array

#: Variables of a scene dataset that its picture shows.
PLOTTED = (
    "rod_length",
    "rod_angle",
    "radius",
    "ring_center",
    "friction_cone_right",
    "friction_cone_left",
    "motion_cone_right",
    "motion_cone_left",
    "pusher_motion",
    "outcome",
    "mode",
    "adhesive",
    "force",
    "contact_motion",
    "spin_ratio",
    "center",
    "support_force",
)
#: A centre further away than this, in units of the slider's span, is pointed to.
FAR = 2.0
#: Radius of the motion cone, in units of the longest motion.
CONE = 0.72
#: Length of the arrows of support friction, in units of the radius.
SUPPORT_LENGTH = 0.36


def shown(dataset: xr.Dataset) -> xr.Dataset:
    """Select the solution to draw: the sticking one, else the first that moves, else the first.

    Parameters
    ----------
    dataset : xarray.Dataset
        A scene's dataset, or what this function made of one.

    Returns
    -------
    xarray.Dataset
        The plotted variables; ``solution`` has one entry, or none where no solution is consistent.
    """
    modes = dataset["mode"].values
    ranks = np.select([modes == ContactMode.STICK, modes != ContactMode.SEPARATE], [0, 1], 2)
    best = np.argsort(ranks, kind="stable")[:1]
    chosen = dataset[[*PLOTTED, "effect"]].isel(solution=best)
    return chosen.assign_attrs(title=dataset.attrs.get("title", ""))


@dataclass(frozen=True, slots=True, kw_only=True)
class Sketch:
    """One solution in the plane of the picture; the contact is the origin.

    Arrows keep their directions; their lengths are scaled to the slider, all motions alike.
    """

    data: xr.Dataset
    radius: float
    ring: Array
    pusher: Array
    force: Array
    motion: Array
    center: Array
    spin_ratio: float

    @classmethod
    def of(cls, dataset: xr.Dataset) -> Self:
        data = shown(dataset)
        one = data.isel(solution=0) if data.sizes["solution"] else None

        def vector(name: str) -> Array:
            return np.zeros(2) if one is None else np.asarray(one[name].values, dtype=float)

        return cls(
            data=data,
            radius=float(data["radius"]),
            ring=np.asarray(data["ring_center"].values, dtype=float),
            pusher=np.asarray(data["pusher_motion"].values, dtype=float),
            force=vector("force"),
            motion=vector("contact_motion"),
            center=vector("center"),
            spin_ratio=0.0 if one is None else float(one["spin_ratio"]),
        )

    @property
    def span(self) -> float:
        """Size of the slider."""
        return float(np.hypot(*self.ring)) + 2 * self.radius

    @property
    def reach(self) -> float:
        """Length at which the longest motion is drawn."""
        return 0.38 * self.span

    @property
    def drawn_force(self) -> Array:
        """Force at a length that keeps its head off the head of a motion along it."""
        size, speed = float(np.hypot(*self.force)), float(np.hypot(*self.motion))
        along = bool(size and self.force @ self.motion > 0.96 * size * speed)
        return (0.6 if along else 0.95) * self.reach * self.force / size if size else self.force

    @property
    def heading(self) -> Array:
        """Unit vector along the force; zero where there is none."""
        size = float(np.hypot(*self.force)) or 1.0
        return np.asarray(self.force / size)

    @property
    def foot(self) -> Array:
        """Point of the line of force that is nearest to the ring centre."""
        return np.asarray((self.heading @ self.ring) * self.heading)

    @property
    def end_of_line(self) -> Array:
        """Where the line of force is drawn to: past the slider."""
        past = float(self.heading @ self.ring) < 0
        return np.asarray(self.foot + (-1 if past else 1) * 1.2 * self.radius * self.heading)

    def drawn_motion(self, motion: Array) -> Array:
        longest = max(float(np.hypot(*self.pusher)), float(np.hypot(*self.motion)))
        return self.reach * motion / longest if longest else motion

    @property
    def moves(self) -> bool:
        return bool(np.any(self.force))

    @property
    def sticks(self) -> bool:
        return bool(np.any(self.data["mode"].values == ContactMode.STICK))

    @property
    def adhesive(self) -> bool:
        return bool(np.any(self.data["adhesive"].values))

    @property
    def symbol(self) -> str:
        """Letter of the motions: accelerations where inertia resists, else velocities."""
        return "a" if "inertia" in self.data["effect"].values else "v"

    @property
    def toward_center(self) -> Array:
        """Unit vector from the ring centre to the motion centre; zero where there is no rotation."""
        size = float(np.hypot(*self.force))
        if not size or not self.spin_ratio:
            return np.zeros(2)
        x, y = self.force / size
        return np.asarray(-np.sign(self.spin_ratio) * np.array([y, -x]))

    @property
    def center_distance(self) -> float:
        """Distance of the motion centre from the ring centre; infinite for a translation."""
        return self.radius / abs(self.spin_ratio) if self.spin_ratio else np.inf

    @property
    def center_is_near(self) -> bool:
        return self.moves and self.center_distance < FAR * self.span

    @property
    def far_center(self) -> Array:
        """Where the line towards a centre that is far away ends."""
        return np.asarray(self.ring + 1.6 * self.radius * self.toward_center)

    @property
    def status(self) -> str:
        """Contact mode, and whether other solutions are consistent too."""
        if not self.data.sizes["solution"]:
            return "no consistent solution"
        names = {
            ContactMode.SEPARATE: "the contact breaks",
            ContactMode.STICK: "the contact sticks",
            ContactMode.SLIP_RIGHT: "slips to the right",
            ContactMode.SLIP_LEFT: "slips to the left",
        }
        mode = names[ContactMode(int(self.data["mode"].values[0]))]
        several = int(self.data["outcome"]) == Outcome.AMBIGUOUS
        return f"{mode} (one of several solutions)" if several else mode

    def box(self, margin: float = 0.0) -> tuple[float, float, float, float]:
        """xmin, xmax, ymin, ymax of all that is drawn."""
        rubs = bool(np.any(self.data["support_force"].values)) and self.moves
        corners = (1 + SUPPORT_LENGTH * rubs) * self.radius * np.array([[-1.0, -1.0], [1.0, 1.0]])
        points = [np.zeros(2), *(self.ring + corners), self.drawn_force]
        points += [self.drawn_motion(self.pusher), self.drawn_motion(self.motion)]
        points += [self.end_of_line] if self.moves else []
        points += [np.array([sign * 0.7 * self.reach, -0.15 * self.reach]) for sign in (-1.0, 1.0)]
        right, left = (float(self.data[f"motion_cone_{side}"]) for side in ("right", "left"))
        points += [CONE * self.reach * unit(each) for each in np.linspace(right, left, 13)]
        if self.center_is_near:
            points.append(self.center)
        elif self.moves:
            points.append(self.far_center)
        low, high = np.min(points, axis=0) - margin, np.max(points, axis=0) + margin
        return float(low[0]), float(high[0]), float(low[1]), float(high[1])
