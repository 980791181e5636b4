"""What a picture of a scene shows: the chosen solution, and how long its arrows are drawn."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np
import xarray as xr

from planar_pushing.figures.parts.arrows import unit
from planar_pushing.figures.parts.bodies import Body, body_of
from planar_pushing.figures.parts.shown import shown
from planar_pushing.figures.parts.supports import Pose
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import Array

#: A center further away than this, in units of the slider's span, is pointed to.
FAR = 2.0
#: Radius of the motion cone, in units of the longest motion.
CONE = 0.72
#: Length of the arrows of support friction, in units of the radius.
SUPPORT_LENGTH = 0.36


@dataclass(frozen=True, slots=True, kw_only=True)
class Sketch:
    """One solution in the plane of the picture; the contact is the origin.

    Arrows keep their directions; their lengths are scaled to the slider, all motions alike.
    """

    data: xr.Dataset
    body: Body
    ring: Array
    pusher: Array
    force: Array
    force_end: Array
    motion: Array
    center: Array
    spin_ratio: float
    pivots: bool

    @classmethod
    def of(cls, dataset: xr.Dataset) -> Self:
        data = shown(dataset)
        one = data.isel(solution=0) if data.sizes["solution"] else None

        def vector(name: str) -> Array:
            return np.zeros(2) if one is None else np.asarray(one[name].values, dtype=float)

        return cls(
            data=data,
            body=body_of(data),
            ring=np.asarray(data["ring_center"].values, dtype=float),
            pusher=np.asarray(data["pusher_motion"].values, dtype=float),
            force=vector("force"),
            force_end=vector("force_end" if "force_end" in data else "force"),
            motion=vector("contact_motion"),
            center=vector("center"),
            spin_ratio=0.0 if one is None else float(one["spin_ratio"]),
            pivots=bool(np.any(data["pivot"].values >= 0)) if "pivot" in data else False,
        )

    @property
    def pose(self) -> Pose:
        """Where the slider is."""
        return Pose(self.ring, float(np.deg2rad(float(self.data["rod_angle"]))))

    @property
    def radius(self) -> float:
        """Radius of the ring; half the larger side of another support."""
        return self.body.half

    @property
    def middle(self) -> Array:
        """Center of the ring; the middle of another support."""
        return self.pose.at(self.body.middle)

    @property
    def span(self) -> float:
        """Size of the slider."""
        return float(np.hypot(*self.middle)) + 2 * self.radius

    @property
    def reach(self) -> float:
        """Length at which the longest motion is drawn."""
        return 0.38 * self.span

    @property
    def forces(self) -> list[Array]:
        """The force; where a pivot leaves it open the ends of its interval, the right one first."""
        one, other = self.force, self.force_end
        if np.array_equal(one, other):
            return [one]
        return [one, other] if one[0] * other[1] > one[1] * other[0] else [other, one]

    @property
    def force_scale(self) -> float:
        """Drawn length of a unit force; it keeps heads of forces off the head of a motion along them."""
        speed, reaches = float(np.hypot(*self.motion)), []
        for force in self.forces:
            size = float(np.hypot(*force))
            along = bool(size and force @ self.motion > 0.96 * size * speed)
            reaches.append((0.6 if along else 0.95) * self.reach / (size or 1.0))
        return min(reaches)

    def drawn_force(self, force: Array) -> Array:
        return np.asarray(self.force_scale * force)

    @property
    def curve(self) -> Array:
        """Limit curve, to the scale of the force: the curve's force along that of the solution."""
        given = self.data["limit_force"].values if "limit_force" in self.data else np.empty((0, 2))
        sizes = np.hypot(*given.T)
        if not self.moves:
            return np.asarray(0.95 * self.reach / sizes.max(initial=1e-300) * given)
        here = sizes[np.argmax(given @ self.force / sizes)] if len(given) else 1.0
        return np.asarray(self.force_scale * float(np.hypot(*self.force)) / here * given)

    @property
    def foot(self) -> Array:
        """Point of the line of force that is nearest to the ring center."""
        heading = _unit(self.force)
        return np.asarray((heading @ self.middle) * heading)

    def end_of_line(self, force: Array) -> Array:
        """Where the line of a force is drawn to: past the slider."""
        heading = _unit(force)
        along = float(heading @ self.middle)
        return np.asarray((along + (-1 if along < 0 else 1) * 1.2 * self.radius) * heading)

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
        """Unit vector from the slider's center to the motion center; zero where there is no rotation."""
        if not (np.any(self.force) and self.spin_ratio and np.isfinite(self.center).all()):
            return np.zeros(2)
        return _unit(self.center - self.ring)

    @property
    def center_distance(self) -> float:
        """Distance of the motion center from the slider's center; infinite for a translation."""
        return float(np.hypot(*(self.center - self.ring))) if self.spin_ratio else np.inf

    @property
    def center_is_near(self) -> bool:
        return self.moves and self.center_distance < FAR * self.span

    @property
    def far_center(self) -> Array:
        """Where the line towards a center that is far away ends."""
        return np.asarray(self.ring + 1.6 * self.radius * self.toward_center)

    @property
    def rubbing(self) -> tuple[Array, Array]:
        """Places where the support rubs, and its friction there."""
        data = self.data
        if "place_force" in data:
            return data["place_position"].values, data["place_force"].values
        around = [unit(angle) for angle in data["support_angle"].values]
        return self.ring + self.radius * np.array(around), data["support_force"].values

    def box(self, margin: float = 0.0) -> tuple[float, float, float, float]:
        """xmin, xmax, ymin, ymax of all that is drawn."""
        rubs = bool(np.any(self.rubbing[1])) and self.moves
        rim = SUPPORT_LENGTH * rubs * self.radius * np.array([[-1.0, -1.0], [1.0, 1.0]])
        points = [np.zeros(2), self.ring, *self.curve, *(self.body.box(self.pose) + rim)]
        points += [self.drawn_force(each) for each in self.forces]
        points += [self.drawn_motion(self.pusher), self.drawn_motion(self.motion)]
        points += [self.end_of_line(each) for each in self.forces if self.moves]
        points += [np.array([sign * 0.7 * self.reach, -0.15 * self.reach]) for sign in (-1.0, 1.0)]
        right, left = (float(self.data[f"motion_cone_{side}"]) for side in ("right", "left"))
        points += [CONE * self.reach * unit(each) for each in np.linspace(right, left, 13)]
        if self.center_is_near:
            points.append(self.center)
        elif self.moves:
            points.append(self.far_center)
        low, high = np.min(points, axis=0) - margin, np.max(points, axis=0) + margin
        return float(low[0]), float(high[0]), float(low[1]), float(high[1])


def _unit(vector: Array) -> Array:
    """Unit vector along a vector; zero along none."""
    size = float(np.hypot(*vector)) or 1.0
    return np.asarray(vector / size)
