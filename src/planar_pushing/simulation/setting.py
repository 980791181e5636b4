"""What of a scene does not change while it moves, in lengths scaled by the radius."""

from __future__ import annotations

import math
from dataclasses import dataclass

from planar_pushing.mechanics import response
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import direction
from planar_pushing.mechanics.scene import Scene

Vector = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Setting:
    """Geometry, contact law and inertia of a scene.

    Attributes
    ----------
    radius : float
        R, the unit of the lengths.
    length : float
        l / R.
    half : float
        Half the angle of the friction cone, radians.
    edges : dict
        The force's direction in each slipping mode: on the edge opposite to the slip.
    slips, closed : bool
        Whether the contact slips on the edges, and whether it transmits forces along them.
    mass, moment : float
        m and m (rho / R)^2; 0 without inertia.
    """

    radius: float
    length: float
    half: float
    edges: dict[ContactMode, Vector]
    slips: bool
    closed: bool
    mass: float
    moment: float

    @property
    def anything(self) -> bool:
        """Whether the contact transmits forces in every direction."""
        return self.half >= math.pi

    def holds(self, force_x: float, force_y: float, least: float) -> float:
        """Margin of a force in the friction cone, negative outside; forces below `least` count as none.

        The angle left to the nearer edge, by its sine, so that it is smooth and 0 for no force.
        """
        if self.anything:
            return 1.0
        size = math.hypot(force_x, force_y)
        lean = self.half - abs(math.atan2(force_x, force_y))
        return lean * size / (size + least)


def setting(scene: Scene) -> Setting:
    """The setting of a scene."""
    angles = scene.contact.force_angles
    left, right = (direction(edge).tolist() for edge in (angles.left, angles.right))
    heavy = response.of_degree(scene.scaled_effects, 2)
    mass, moment = (float(part) for part in response.profile(heavy, 1.0)) if heavy else (0.0, 0.0)
    return Setting(
        radius=scene.slider.radius,
        length=scene.slider.length_ratio,
        half=angles.span / 2,
        edges={
            ContactMode.SLIP_RIGHT: (left[0], left[1]),
            ContactMode.SLIP_LEFT: (right[0], right[1]),
        },
        slips=scene.contact.slips,
        closed=angles.closed,
        mass=mass,
        moment=moment,
    )
