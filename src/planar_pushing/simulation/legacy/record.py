"""Record of a solution of a push in the compiled core, in the frame of the contact."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.legacy.slips import SLIPS
from planar_pushing.terms.domain import Number

#: Maximum number of solutions of one push: separate, stick, and the slips under each edge.
MOST = 2 + 2 * SLIPS
SEPARATE, STICK = int(ContactMode.SEPARATE), int(ContactMode.STICK)
SLIP_RIGHT, SLIP_LEFT = int(ContactMode.SLIP_RIGHT), int(ContactMode.SLIP_LEFT)
#: Replaces the number of solutions if an iteration has not converged or there are more slips than fit.
UNSOLVED = -1
#: A solution, in the frame of the contact: twist of the slider's origin, motion of the contact, force and
#: the other end of its interval, number of the support point that is the pivot, and whether the solution is
#: an end of a continuum.
SOLUTION = np.dtype(
    (
        np.record,
        [
            ("mode", "i8"), ("twist", "f8", (3,)), ("motion", "f8", (2,)), ("force", "f8", (2,)),
            ("force_end", "f8", (2,)), ("pivot", "i8"), ("continuum", "i8"),
        ],
    ),
)  # fmt: skip


class Push(NamedTuple):
    """A push in the body frame: effects, contact, and the tangent of the pusher there.

    The normal is the tangent rotated by +90 degrees.
    """

    effects: tuple[Any, ...]
    at: Any
    t_x: float
    t_y: float


@compiled
def write(push, mode, moved, found):
    """Write a solution in the frame of the contact."""
    t_x, t_y = push.t_x, push.t_y
    found.mode, found.pivot, found.continuum = mode, moved.point, moved.continuum
    found.twist[0], found.twist[1] = (
        t_x * moved.v_x + t_y * moved.v_y,
        t_x * moved.v_y - t_y * moved.v_x,
    )
    found.twist[2] = moved.spin
    found.motion[0], found.motion[1] = (
        t_x * moved.u_x + t_y * moved.u_y,
        t_x * moved.u_y - t_y * moved.u_x,
    )
    f_x, f_y = moved.f_x - moved.free_x, moved.f_y - moved.free_y
    found.force[0], found.force[1] = t_x * f_x + t_y * f_y, t_x * f_y - t_y * f_x
    f_x, f_y = moved.f_x + moved.free_x, moved.f_y + moved.free_y
    found.force_end[0], found.force_end[1] = t_x * f_x + t_y * f_y, t_x * f_y - t_y * f_x


@compiled
def copy(target, source):
    """Overwrite a solution with another one."""
    target.mode, target.pivot, target.continuum = source.mode, source.pivot, source.continuum
    for k in range(3):
        target.twist[k] = source.twist[k]
    for k in range(2):
        target.motion[k], target.force[k] = source.motion[k], source.force[k]
        target.force_end[k] = source.force_end[k]


class Law(NamedTuple):
    """A contact law in numbers: the edges of its cone, and the behavior there.

    A `rough` law transmits every force. In the public layer each entry is a number or an array.
    """

    right: Number
    left: Number
    slips: Number
    closed: Number
    rough: Number
