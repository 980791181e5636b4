"""Content of a picture of a scene: slider, cones, push and solutions, and the lengths of arrows.

Arrow lengths are scaled to the slider, with one scale for all motions. The contact is the origin, and the
fence is the x axis. If a side of the slider lies on the fence, the contact is this side or one of its ends.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Self

import numpy as np
import xarray as xr

from planar_pushing.drawing.body import Body, body_in, body_of
from planar_pushing.drawing.canvas.marks import corners
from planar_pushing.drawing.supports import Pose
from planar_pushing.drawing.walls import DrawnWall
from planar_pushing.drawing.words import best
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.force.cones import friction_cone, motion_cone
from planar_pushing.mechanics.force.limit_curve import limit_curve, require_one_curve
from planar_pushing.mechanics.force.rubbing import place_friction, ring_friction
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene, require_one_point
from planar_pushing.mechanics.solutions import Solution, Solutions
from planar_pushing.mechanics.solve import solve

#: A center farther away than this, in units of the slider's span, is only pointed to.
FAR = 2.0
#: Radii of the motion cone and the friction cone, in units of the reach of arrows.
MOTION_CONE, FRICTION_CONE = 0.72, 0.5
#: Lower edge of the label of a force's position on a side, in units of the reach.
LABEL = -0.3
#: Largest radius of the friction cones at both ends of a side, in units of its length.
END_CONE = 0.45
#: Length of the longest arrow of support friction, in units of half the support.
SUPPORT_LENGTH = 0.36
#: Motions with angles that differ by less, radians, count as equal: a pivot, a flat of the curve.
ALIKE = 1e-9
#: Force angles of a limit curve, radians.
ANGLES = np.linspace(0.0, 2 * np.pi, 721)
#: Positions and friction of a support without friction.
NOWHERE = np.empty((0, 2)), np.empty((0, 2))


@dataclass(frozen=True, slots=True, kw_only=True)
class Sketch:
    """Content of a picture of a scene.

    Attributes
    ----------
    body, pose : Body, Pose
        The slider and its pose.
    friction, motion : tuple of float
        Right and left edges of each cone, radians; a side on the fence has no motion cone, but NaN.
    pusher : ndarray, shape (2,), optional
        Motion of the pusher; None shows only the slider and its cones.
    solutions, chosen : tuple of Solution, int
        The consistent solutions, and the index of the one drawn in full; -1 if there is none.
    symbol : str
        Symbol of the motions: "a" if inertia resists, otherwise "v".
    side : tuple of float, optional
        Ends of the side that a finger pushes; None for a fence.
    ends : tuple of float, optional
        Ends of the side that lies on the fence; None for one point of contact.
    finger_radius : float
        Radius of this finger; 0 for a point.
    rubbing : tuple of ndarray
        Positions at which the support rubs, and its friction there in the chosen solution, shapes (n, 2).
    curve, flats : ndarray, sequence of slice
        Forces of the limit curve, shape (n, 2), and its flats, which belong to one pivot each.
    pusher_length : float, optional
        Drawn length of the pusher's motion, in units of the reach; by default the longest motion has the
        length of the reach.
    unit : str
        Unit of length, if the scene names it.
    walls : tuple of DrawnWall
        Walls at rest, in the fence frame.
    """

    body: Body
    pose: Pose
    friction: tuple[float, float]
    motion: tuple[float, float]
    pusher: Array | None = None
    solutions: tuple[Solution, ...] = ()
    chosen: int = -1
    symbol: str = "v"
    side: tuple[float, float] | None = None
    ends: tuple[float, float] | None = None
    finger_radius: float = 0.0
    rubbing: tuple[Array, Array] = field(default_factory=lambda: NOWHERE)
    curve: Array = field(default_factory=lambda: NOWHERE[0])
    flats: Sequence[slice] = ()
    pusher_length: float | None = None
    unit: str = ""
    walls: tuple[DrawnWall, ...] = ()

    @classmethod
    def of(
        cls,
        scene: Scene,
        pusher_angle: float | None = None,
        magnitude: float = 1.0,
        *,
        solutions: Solutions | None = None,
        chosen: int | None = None,
        **rest: Any,
    ) -> Self:
        """Sketch of a scene under a push at an angle in radians, or of the scene alone."""
        slider = scene.slider
        content: dict[str, Any] = {
            "body": body_of(scene),
            "pose": Pose(slider.rod_length * direction(slider.rod_angle), float(slider.rod_angle)),
            **_cones(scene),
            "symbol": "a" if scene.stores_energy else "v",
            "unit": scene.units.length if scene.units else "",
        }
        if scene.slider.pocket:
            content["side"] = 0.0, 0.0  # only a point fits into an inner corner
        if pusher_angle is not None:
            if solutions is None:
                solutions = solve(scene, pusher_angle, magnitude)
            consistent = tuple(solutions)
            chosen = best(consistent) if chosen is None else chosen
            content |= {"pusher": magnitude * direction(pusher_angle), "solutions": consistent}
            content |= {"chosen": chosen}
            if chosen >= 0:
                content["rubbing"] = rubbing_of(scene, consistent[chosen])
        return cls(**content | rest)

    @classmethod
    def of_dataset(cls, data: xr.Dataset) -> Self:
        """Sketch of a scene's dataset as a study stores it."""
        solutions = tuple(_solution(data.isel(solution=i)) for i in range(data.sizes["solution"]))
        chosen = best(solutions)
        angle = float(np.deg2rad(data["rod_angle"].item()))
        edges: dict[str, Any] = {
            kind: tuple(
                float(np.deg2rad(data[f"{kind}_cone_{side}"])) for side in ("right", "left")
            )
            for kind in ("friction", "motion")
        }
        return cls(
            body=body_in(data), pose=Pose(data["ring_center"].values, angle),
            friction=edges["friction"], motion=edges["motion"],
            pusher=data["pusher_motion"].values, solutions=solutions, chosen=chosen,
            symbol="a" if "inertia" in data["effect"].values else "v",
            rubbing=_friction_forces(data.isel(solution=chosen)) if chosen >= 0 else NOWHERE,
        )  # fmt: skip

    @property
    def solution(self) -> Solution | None:
        """The solution drawn in full."""
        return self.solutions[self.chosen] if self.chosen >= 0 else None

    @property
    def center(self) -> Array:
        """The slider's center."""
        return np.asarray(self.pose.origin, dtype=float)

    @property
    def half(self) -> float:
        """Half the larger side of the support; the radius of a ring."""
        return self.body.half

    @property
    def contacts(self) -> list[Array]:
        """Points at which the fence can transmit a force: the contact, or both ends of the side."""
        return [np.array([end, 0.0]) for end in self.ends or (0.0,)]

    @property
    def friction_radius(self) -> float:
        """Drawn radius of the friction cones; those of both ends of a side do not meet."""
        start, end = self.ends or (-np.inf, np.inf)
        return min(FRICTION_CONE * self.reach, END_CONE * (end - start))

    def contact_of(self, solution: Solution | None) -> Array:
        """Position of the contact in a solution: an end of the side if the other end lifts off."""
        if solution is None or solution.flush or not moves(solution):
            return np.zeros(2)
        return np.array([solution.force_position or 0.0, 0.0])

    def tail_of(self, solution: Solution) -> Array:
        """Start of the arrow of the force.

        It is where the line of action crosses the side. If it does not, because adhesion pulls at an end,
        it is the point of this line nearest the middle of the slider.
        """
        position, forces_at_ends = solution.force_position, solution.end_forces
        if self.ends is None or position is None or forces_at_ends is None or not solution.flush:
            return self.contact_of(solution)
        start, end = self.ends
        if start <= position <= end:
            return np.array([position, 0.0])
        heading = heading_of(solution.force)
        torque = float(np.dot(self.ends, forces_at_ends[:, 0, 1]))
        foot = torque / float(np.hypot(*solution.force)) * np.array([heading[1], -heading[0]])
        return np.asarray(foot + (self.middle @ heading) * heading)

    @property
    def middle(self) -> Array:
        """Middle of the support; the center of a ring."""
        return self.pose.to_plane(self.body.middle)

    @property
    def span(self) -> float:
        """Size of the slider."""
        return float(np.hypot(*self.middle)) + 2 * self.half

    @property
    def reach(self) -> float:
        """Drawn length of the longest motion."""
        return 0.38 * self.span

    @property
    def motion_scale(self) -> float:
        """Drawn length of a unit of motion."""
        pusher = 0.0 if self.pusher is None else float(np.hypot(*self.pusher))
        if self.pusher_length is not None:
            return self.pusher_length * self.reach / (pusher or 1.0)
        contact = 0.0 if self.solution is None else float(np.hypot(*self.solution.contact_motion))
        return self.reach / (max(pusher, contact) or 1.0)

    def force_scale(self, solution: Solution) -> float:
        """Drawn length of a unit of force; it keeps the head of a force off that of a parallel motion."""
        speed, reaches = float(np.hypot(*solution.contact_motion)), []
        for force in forces(solution):
            size = float(np.hypot(*force))
            along = bool(size and force @ solution.contact_motion > 0.96 * size * speed)
            reaches.append((0.6 if along else 0.95) * self.reach / (size or 1.0))
        return min(reaches)

    def end_of_line(self, force: Array, tail: Array) -> Array:
        """End of the drawn line of a force, past the slider."""
        heading = heading_of(force)
        along = float(heading @ (self.middle - tail))
        return np.asarray(tail + (along + (-1 if along < 0 else 1) * 1.2 * self.half) * heading)

    def end_arrows(self, solution: Solution) -> list[Array]:
        """Tails and vectors of the forces at both ends of the side, if they are determined."""
        if solution.end_forces is None or not solution.flush:
            return []
        low, high = np.moveaxis(solution.end_forces, 1, 0)
        if not np.array_equal(low, high):
            return []
        scale = self.force_scale(solution)
        return [
            np.array([tail, scale * force])
            for tail, force in zip(self.contacts, low, strict=True)
            if np.any(force)
        ]

    def distance(self, solution: Solution) -> float:
        """Distance of the motion center from the slider's center; infinite for a translation."""
        away = float(np.hypot(*(solution.center - self.center)))
        return away if solution.spin_ratio and np.isfinite(away) else np.inf

    def is_near(self, solution: Solution) -> bool:
        """Whether the motion center is in the picture."""
        return moves(solution) and self.distance(solution) < FAR * self.span

    def far_center(self, solution: Solution) -> Array:
        """End of the line toward a motion center that is far away."""
        if not (solution.spin_ratio and np.isfinite(solution.center).all()):
            return self.center
        return np.asarray(self.center + 1.6 * self.half * heading_of(solution.center - self.center))

    @property
    def curve_scale(self) -> float:
        """Drawn length of a unit of force of the limit curve."""
        sizes = np.hypot(*self.curve.T)
        solution = self.solution
        if solution is None or not moves(solution):
            return 0.95 * self.reach / float(sizes.max(initial=1e-300))
        here = float(sizes[np.argmax(self.curve @ solution.force / sizes)])
        return self.force_scale(solution) * float(np.hypot(*solution.force)) / here

    @property
    def wall_segments(self) -> list[tuple[Array, Array]]:
        """Ends of the drawn segments of the walls near the slider, and their normals."""
        segments = [
            (wall.segment(self.center, 2.0 * self.half), wall.normal) for wall in self.walls
        ]
        return [(ends, normal) for ends, normal in segments if ends is not None]

    @property
    def box(self) -> Array:
        """Corners of the box around everything drawn in full."""
        rim = SUPPORT_LENGTH * self.half * np.array([[-1.0, -1.0], [1.0, 1.0]])
        rubs = bool(np.any(self.rubbing[1]))
        points: list[Any] = [(0.0, 0.0), self.center, self.body.box(self.pose) + rubs * rim]
        points += [(sign * 0.7 * self.reach, -0.15 * self.reach) for sign in (-1.0, 1.0)]
        if self.ends is None:
            points += [MOTION_CONE * self.reach * direction(np.linspace(*self.motion, 13))]
        else:
            cone = self.friction_radius * direction(np.linspace(*self.friction, 13))
            points += [contact + cone for contact in self.contacts]
            points.append((0.0, LABEL * self.reach))
        finger = min(self.finger_radius, self.reach)
        points += [(-finger, 0.0), (finger, -2 * finger)]
        points += [ends for ends, _ in self.wall_segments]
        if len(self.curve):
            points.append(self.curve_scale * self.curve)
        solution = self.solution
        if self.pusher is not None:
            points.append(self.contact_of(solution) + self.motion_scale * self.pusher)
        if solution is not None and moves(solution):
            tail = self.tail_of(solution)
            points.append(self.contact_of(solution) + self.motion_scale * solution.contact_motion)
            for force in forces(solution):
                points += [tail, tail + self.force_scale(solution) * force]
                points.append(self.end_of_line(force, tail))
            points += [arrow.sum(axis=0) for arrow in self.end_arrows(solution)]
            points.append(solution.center if self.is_near(solution) else self.far_center(solution))
        return corners(points)


def _cones(scene: Scene) -> dict[str, Any]:
    """Edges of the friction cone and of the motion cone, and the ends of a side on the fence."""
    slider = scene.slider
    if not slider.flush:
        friction, motion = friction_cone(scene), motion_cone(scene)
        edges = (friction.right, friction.left), (motion.right, motion.left)
        return dict(zip(("friction", "motion"), edges, strict=True))
    start, end = (float(end) for end in slider.side)
    edges = (float(scene.law.right), float(scene.law.left)), (np.nan, np.nan)
    return {"friction": edges[0], "motion": edges[1], "ends": (start, end)}


def heading_of(vector: Array) -> Array:
    """Unit vector along a vector; zero for a zero vector."""
    return np.asarray(vector / (float(np.hypot(*vector)) or 1.0))


def moves(solution: Solution) -> bool:
    """Whether the pusher transmits a force."""
    return bool(np.any(solution.force))


def forces(solution: Solution) -> list[Array]:
    """The force, or both ends of its interval, the right one first, if a pivot leaves it undetermined."""
    force, end = solution.force, solution.force_end
    if np.array_equal(force, end):
        return [force]
    return [force, end] if force[0] * end[1] > force[1] * end[0] else [end, force]


def _solution(data: xr.Dataset) -> Solution:
    """A solution in a scene's dataset."""
    return Solution(
        mode=ContactMode(int(data["mode"])), force=data["force"].values,
        force_end=data.get("force_end", data["force"]).values,
        contact_motion=data["contact_motion"].values, twist=data["twist"].values,
        spin_ratio=float(data["spin_ratio"]), center=data["center"].values,
        pivot=int(data["pivot"]) if "pivot" in data else -1, continuum=False,
    )  # fmt: skip


def rubbing_of(scene: Scene, solution: Solution) -> tuple[Array, Array]:
    """Positions at which the support of a scene rubs, and its friction there."""
    twist = solution.twist[None]
    if not scene.friction:
        return NOWHERE
    if not scene.isotropic:
        friction = place_friction(scene, twist)
        return friction["place_position"][1], friction["place_force"][1][0]
    return _around(scene.slider.rod_length * direction(scene.slider.rod_angle),
                   scene.slider.radius, ring_friction(scene, twist)["support_force"][1][0])  # fmt: skip


def _around(center: Array, radius: float, friction: Array) -> tuple[Array, Array]:
    """Every second position on a ring, because arrows at all positions would touch."""
    turns = np.linspace(0.0, 2 * np.pi, len(friction), endpoint=False)
    return (center + radius * direction(turns))[::2], friction[::2]


def _friction_forces(data: xr.Dataset) -> tuple[Array, Array]:
    if "place_force" in data:
        return data["place_position"].values, data["place_force"].values
    return _around(data["ring_center"].values, float(data["radius"]), data["support_force"].values)


def with_curve(sketch: Sketch, scene: Scene) -> Sketch:
    """Sketch with the limit curve of its scene.

    Raises
    ------
    InvalidValue
        If the force depends on the magnitude of the motion, so that no single curve bounds the forces of
        all motions, or on the position of the force, because a side lies on the fence.
    """
    require_one_point(scene, "limit_curve", "leave it out, or draw a scene at a point of the side")
    require_one_curve(scene, "leave the limit curve out, or list one effect")
    curve = limit_curve(scene, ANGLES)
    return replace(sketch, curve=curve.force, flats=flats(curve.motion_angle))


def flats(motion: Array) -> list[slice]:
    """Flats of a limit curve: runs of points with one angle of motion, in radians."""
    flat = np.concatenate([[False], np.abs(np.diff(motion)) < ALIKE, [False]])
    turns = np.flatnonzero(flat[1:] != flat[:-1]).reshape(-1, 2)
    return [slice(int(start), int(stop) + 1) for start, stop in turns]
