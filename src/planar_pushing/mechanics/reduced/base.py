"""What the contact feels of the slider: the reduced potential of the contact's motion.

With the rotation eliminated, ``Psi(u) = min over omega`` of the sum of the effects' potentials at the twist
whose contact moves by `u` (Secs. 3 and 4). Psi is convex; its gradient is the force of the pusher, and the
torque about the contact is zero by the minimum. Cones, limit curve, contact modes and simulation use Psi
through the functions below alone, each of which a family of supports provides.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from planar_pushing.mechanics.compiled import generic
from planar_pushing.mechanics.reduced import isotropic, turning


@generic
def stick(kinds: Any) -> Callable[..., Any]:
    """Twist and force, as `isotropic.Sustained`, of a contact that moves by one unit: the gradient of Psi.

    Parameters
    ----------
    effects : tuple
    rod : Rod
    towards : Direction
        Of the contact's motion.
    """
    return isotropic.stick


@generic
def held_on_edge(kinds: Any) -> Callable[..., Any]:
    """The motion next to a sticking one whose force lies on an edge, as `Sustained`.

    Parameters
    ----------
    effects : tuple
    rod : Rod
    edge : Direction
        Of the force.
    moved : Sustained
        The motion that sticks.
    """
    return isotropic.held_on_edge


@generic
def slips(kinds: Any) -> Callable[..., Any]:
    """Every motion under a force on an edge whose contact has a given normal part.

    Parameters
    ----------
    effects : tuple
    rod : Rod
    edge : Direction
        Of the force.
    normal : float
        ``n . u``.
    found : ndarray, shape (SLIPS, 5)
        Takes the motions: v_x, v_y, R omega, f_x, f_y.

    Returns
    -------
    int
        How many there are.
    """
    return isotropic.steady_slips if len(kinds) == 1 else turning.slips


@generic
def edge_motion(kinds: Any) -> Callable[..., Any]:
    """Motion of unit size under a force on an edge, of one effect: v_x, v_y, R omega, f_x, f_y."""
    return isotropic.edge_motion


@generic
def limit_motion(kinds: Any) -> Callable[..., Any]:
    """Size of the force on the limit curve in a direction, and the motion it causes.

    Parameters
    ----------
    effects : tuple
    rod : Rod
    force : Direction

    Returns
    -------
    magnitude, spin_ratio, motion_angle : float
        Without friction the curve is that of the kinetic energy of a unit translation.
    """
    return isotropic.limit_motion


@generic
def motion_angle(kinds: Any) -> Callable[..., Any]:
    """Angle of the contact's motion under a force in a direction, its centre at unit speed.

    Parameters
    ----------
    effects : tuple
    rod : Rod
    force : Direction
    """
    return isotropic.motion_angle


@generic
def motion_angles(kinds: Any) -> Callable[..., Any]:
    """Least and greatest angle of the contact's motion under a force, over all magnitudes of the motion.

    Parameters are those of `motion_angle`.
    """
    return isotropic.motion_angles
