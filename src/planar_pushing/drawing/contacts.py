"""The picture of an object with several contacts: cones, forces with their ranges, motions, a center."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from planar_pushing.drawing.body import add_outline, body_of, name_centers, outline_rings
from planar_pushing.drawing.canvas.colors import CENTER, DARK, FORCE, MOTION, PUSHER, tint
from planar_pushing.drawing.canvas.marks import AREAS, ARROWS, NOTE, Picture
from planar_pushing.drawing.scene import add_center_mark
from planar_pushing.drawing.supports import Ink, Pose, add_support
from planar_pushing.drawing.walls import DrawnWall, add_wall
from planar_pushing.mechanics.contact import ContactMode, as_numbers
from planar_pushing.mechanics.effects import Effect
from planar_pushing.mechanics.outline import require_outline
from planar_pushing.mechanics.plane import Array
from planar_pushing.objects.several.contact import Contact, PlacedContact, place_contacts
from planar_pushing.objects.several.solutions import ContactsSolution, ContactsSolutions
from planar_pushing.objects.several.solve_contacts import scene_about_center, solve_contacts
from planar_pushing.terms.errors import InvalidValue

#: Lengths in units of half of the object's size: radius of the cones, of the longest force and motion, and
#: half of the line of a pusher.
CONE, FORCE_LENGTH, MOTION_LENGTH, HALF_LINE = 0.55, 0.9, 0.6, 0.25
#: Largest distance of a drawn center, in units of half of the object's size.
FAR = 4.0
#: Words for the modes of a contact.
WORDS = {
    ContactMode.SEPARATE: "opens", ContactMode.STICK: "sticks",
    ContactMode.SLIP_RIGHT: "slips right", ContactMode.SLIP_LEFT: "slips left",
}  # fmt: skip


class ContactsPicture:
    """The marks of an object with several contacts, in the object's frame.

    Parameters
    ----------
    contacts, effects, outline
        As of `solve_contacts`, of one problem.
    chosen : int
        Number of the solution that is drawn; there may be none.
    walls : sequence of DrawnWall
        Walls at rest in the object's frame, whether or not it touches them.
    """

    def __init__(
        self,
        contacts: Sequence[Contact],
        effects: Sequence[Effect],
        outline: Any,
        chosen: int,
        walls: Sequence[DrawnWall] = (),
    ) -> None:
        whole = None if outline is None else require_outline(outline)
        self.placed = place_contacts(contacts, whole, outline)
        answer: Any = solve_contacts(contacts, effects=effects, outline=outline)
        if not isinstance(answer, ContactsSolutions):
            raise InvalidValue("contacts", "arrays", "one problem", "draw them one at a time")
        self.answer = answer
        if len(answer) and not 0 <= chosen < len(answer):
            raise InvalidValue(
                "solution", chosen, f"a number below {len(answer)}", "choose one of the solutions"
            )
        self.solution: ContactsSolution | None = answer[chosen] if len(answer) else None
        scene, self.center = scene_about_center(effects, whole)
        self.body, self.pose = body_of(scene), Pose(self.center, 0.0)
        self.rings = () if whole is None else outline_rings(whole)
        points = [*self.body.box(self.pose), *(point for ring in self.rings for point in ring)]
        points += [contact.point for contact in self.placed]
        self.low, self.high = np.min(points, axis=0), np.max(points, axis=0)
        self.half = float((self.high - self.low).max()) / 2.0
        segments = [(wall.segment(np.array(self.center), 2.0 * self.half), wall) for wall in walls]
        self.walls = [(ends, wall.normal) for ends, wall in segments if ends is not None]

    def draw(self) -> Picture:
        """The picture."""
        picture = Picture()
        for ends, normal in self.walls:
            add_wall(picture, ends, normal, 2.0 * self.half)
        if self.rings:
            add_outline(picture, [np.array(ring) for ring in self.rings], Ink())
        add_support(picture, self.body.support, self.pose, Ink())
        for number in range(len(self.placed)):
            self._add_contact(picture, number)
        self._add_center(picture)
        name_centers(picture, self.body, self.pose)
        return picture

    def box(self) -> Array:
        """Corners of the picture."""
        corners = [self.low, self.high, *(end for ends, _ in self.walls for end in ends)]
        for contact in self.placed:
            point, normal = np.array(contact.point), np.array(contact.normal)
            corners += [point - MOTION_LENGTH * self.half * normal]
            for force in self._arrows(self.placed.index(contact)):
                corners.append(point + force)
        if (center := self._near_center()) is not None:
            corners.append(center)
        return np.array([np.min(corners, axis=0), np.max(corners, axis=0)])

    def title(self) -> str:
        """The modes of the contacts, in words."""
        if self.solution is None:
            reason = self.answer.reason
            return f"no motion: {reason.name.lower()}" if reason else "no consistent motion"
        words = ", ".join(
            f"contact {i + 1} {WORDS[mode]}" for i, mode in enumerate(self.solution.modes)
        )
        count = len(self.answer)
        return words if count == 1 else f"{words} (one of {count} solutions)"

    def _add_contact(self, picture: Picture, number: int) -> None:
        """Add the pusher's line, the friction cone, the velocity of the pusher, and the forces."""
        contact = self.placed[number]
        point, normal = np.array(contact.point), np.array(contact.normal)
        tangent = np.array([normal[1], -normal[0]])
        line = HALF_LINE * self.half * tangent
        picture.line([point - line, point + line], PUSHER, width=1.6, order=ARROWS - 1)
        law = as_numbers(contact.law)
        if not law.rough:
            turn = float(np.arctan2(normal[1], normal[0])) - np.pi / 2.0
            edges = float(law.right) + turn, float(law.left) + turn
            picture.cone(*edges, CONE * self.half, FORCE, apex=point, order=AREAS + 0.7)
        velocity = self._velocity(contact)
        if velocity.any():
            tail = point - MOTION_LENGTH * self.half * velocity
            picture.motion(tail, point - tail, color=PUSHER, width=1.2)
        for vector in self._arrows(number):
            picture.force(point, vector, width=1.4)
        picture.dot(point, 4.0, DARK, order=ARROWS + 1)
        offset = tuple((-8.0 * normal + 8.0 * tangent).tolist())
        picture.label(point, str(number + 1), size=NOTE + 1, color=DARK, offset=offset)

    def _velocity(self, contact: PlacedContact) -> Array:
        """Velocity of a pusher relative to the fastest."""
        fastest = max(math.hypot(*map(float, one.velocity)) for one in self.placed)
        velocity = np.array([float(part) for part in contact.velocity])
        return velocity / fastest if fastest else velocity

    def _arrows(self, number: int) -> list[Array]:
        """The force of a contact, or both ends of its range; along its direction where it has no end."""
        if self.solution is None or self.solution.modes[number] == ContactMode.SEPARATE:
            return []
        ends = []
        for force, way in zip(
            (self.solution.forces, self.solution.forces_end), self.solution.directions, strict=True
        ):
            ends.append(np.where(np.isfinite(force), force, 0.0) + np.nan_to_num(way))
        longest = max(float(np.hypot(*end.T).max()) for end in ends) or 1.0
        arrows = [FORCE_LENGTH * self.half * end[number] / longest for end in ends]
        same = np.abs(arrows[0] - arrows[1]).max() <= 1e-9 * self.half
        return [arrow for arrow in arrows[: 1 if same else 2] if np.hypot(*arrow) > 0.0]

    def _near_center(self) -> Array | None:
        """The center of rotation, if it is near."""
        if self.solution is None or self.solution.twist[2] == 0.0:
            return None
        v_x, v_y, omega = self.solution.twist
        center = np.array([-v_y, v_x]) / omega
        middle = (self.low + self.high) / 2.0
        return center if np.hypot(*(center - middle)) <= FAR * self.half else None

    def _add_center(self, picture: Picture) -> None:
        """Add the center of rotation, or the direction of the motion."""
        if self.solution is None:
            return
        v_x, v_y, omega = self.solution.twist
        c_x, c_y = self.center
        motion = np.array([v_x - omega * c_y, v_y + omega * c_x])
        if (speed := float(np.hypot(*motion))) > 0.0:
            vector = MOTION_LENGTH * self.half * motion / speed
            picture.motion(self.center, vector, color=MOTION, width=1.4)
        if (center := self._near_center()) is not None:
            add_center_mark(picture, center, pivot=self.solution.pivot >= 0)
            picture.label(center, "center", offset=(0.0, -12.0), color=tint(CENTER, 1.0), size=NOTE)
