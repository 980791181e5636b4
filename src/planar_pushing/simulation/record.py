"""One logged instant, and how an integrator hands its instants on.

An integrator is a generator of lists of records, in order of time; a log consumes them. It ends early
only after a record whose `stopped` says why.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from planar_pushing.mechanics.contact import Outcome

#: Value of `mode` where no mode is consistent; otherwise it is one of `ContactMode`.
NO_MODE = -1


class Record(NamedTuple):
    """Everything that is logged at one instant; radians, and the units of the scene.

    Attributes
    ----------
    time : float
    position : (x, y)
        Ring centre.
    rod_angle : float
        Any real number.
    twist : (v_x, v_y, R omega)
        At the ring centre, just after the instant.
    fence : (X, Y)
        Displacement of the fence.
    slip : float
        Path of the contact over the fence, accumulated while they touch; positive to the right.
    gap : float
        Height of the contact point above the fence.
    force : (f_x, f_y)
        Force of the fence on the slider.
    mode : int
        `ContactMode`, or `NO_MODE`.
    solutions : int
        Number of consistent solutions; more than one is a choice.
    spin_ratio : float
        R omega / v; 0 at rest.
    dissipated : tuple of float
        Energy dissipated so far by each effect of the scene; 0 for inertia.
    contact_dissipated : float
        Energy dissipated so far by slip and by impacts at the contact.
    work : float
        Work done so far by the fence on the slider.
    kinetic_energy : float
    evaluations : tuple of int
        How often each effect was evaluated so far.
    stopped : str
        Why the run ends here before its time; empty otherwise.
    """

    time: float
    position: tuple[float, float]
    rod_angle: float
    twist: tuple[float, float, float]
    fence: tuple[float, float]
    slip: float
    gap: float
    force: tuple[float, float]
    mode: int
    solutions: int
    spin_ratio: float
    dissipated: tuple[float, ...]
    contact_dissipated: float
    work: float
    kinetic_energy: float
    evaluations: tuple[int, ...]
    stopped: str = ""

    @property
    def outcome(self) -> Outcome:
        return Outcome(min(self.solutions, 2))


Records = Iterator[list[Record]]


def spin_ratio(spin: float, speed: float) -> float:
    """Spin ratio R omega / v, 0 at rest."""
    if spin == 0.0:
        return 0.0
    return spin / speed if speed > 0.0 else math.copysign(math.inf, spin)
