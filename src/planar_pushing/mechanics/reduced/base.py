"""What the contact feels of the slider: the reduced potential of the contact's motion.

With the rotation eliminated, ``Psi(u) = min over omega`` of the sum of the effects' potentials at the twist
whose contact moves by `u` (Secs. 3 and 4). Psi is convex; its gradient is the force of the pusher, and the
torque about the contact is zero by the minimum. Cones, limit curve, contact modes and simulation use Psi
through the functions below alone, which a family of effects provides. Each takes the tuple of effects
and the `Rod`, and then directions as `Direction` has them, or for cones, limit curve and centres `Seen`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from planar_pushing.mechanics.compiled import generic
from planar_pushing.mechanics.effects.any_mass import MassAt
from planar_pushing.mechanics.effects.any_support import Support
from planar_pushing.mechanics.reduced import isotropic, sticking, turning
from planar_pushing.mechanics.reduced.pressed import cones, motions
from planar_pushing.mechanics.reduced.pressed import slips as pressed_slips

#: Entries of a motion that is written down: v_x, v_y, R omega; force, and the other end of its interval
#: where it is not settled; number of the support point about which the slider pivots, -1 without one.
MOTION = 8


def _of(kinds: Any, name: str, any_support: Any, family: Any = isotropic) -> Callable[..., Any]:
    """A function of a family of isotropic effects, or where one is not isotropic of one for any support."""
    found: Callable[..., Any] = getattr(
        any_support if kinds[0] is Support or MassAt in kinds else family, name
    )
    return found


@generic
def stick(kinds: Any) -> Callable[..., Any]:
    """`Sustained` motion of a contact that moves by one unit towards a direction: the gradient of Psi."""
    return _of(kinds, "stick", motions, sticking)


@generic
def held_on_edge(kinds: Any) -> Callable[..., Any]:
    """The `Sustained` motion next to another one, whose force has the direction of an edge."""
    return _of(kinds, "held_on_edge", motions, sticking)


@generic
def slips(kinds: Any) -> Callable[..., Any]:
    """Every motion under a force on an edge whose contact has a given normal part ``n . u``; their number.

    Parameters
    ----------
    effects, rod, edge, normal
    start : float
        Slips that move further along the fence than this, in the sense of the force, need not be found;
        an infinite one, of the sign of the force's part along the fence, brings all.
    found : ndarray, shape (SLIPS, MOTION)
        Takes the motions, slow ones first.
    """
    if len(kinds) == 1:
        return _of(kinds, "steady_slips", pressed_slips)
    return _of(kinds, "slips", pressed_slips, turning)


@generic
def edge_motion(kinds: Any) -> Callable[..., Any]:
    """Motion of unit size under a force on an edge, of one effect: v_x, v_y, R omega, f_x, f_y."""
    return _of(kinds, "edge_motion", pressed_slips)


@generic
def limit_motion(kinds: Any) -> Callable[..., Any]:
    """Size of the force on the limit curve in a direction, and its motion: spin ratio and angle.

    Without friction the curve is that of the kinetic energy of a unit translation.
    """
    return _of(kinds, "limit_motion", cones)


@generic
def spin_ratio(kinds: Any) -> Callable[..., Any]:
    """Spin ratio under a force in a direction, the centre at unit speed."""
    return _of(kinds, "spin_ratio", cones)


@generic
def motion_angle(kinds: Any) -> Callable[..., Any]:
    """Angle of the contact's motion under a force in a direction, the centre at unit speed."""
    return _of(kinds, "motion_angle", cones)


@generic
def motion_angles(kinds: Any) -> Callable[..., Any]:
    """Least and greatest `motion_angle` over all magnitudes of the motion."""
    return _of(kinds, "motion_angles", cones)


@generic
def center_of(kinds: Any) -> Callable[..., Any]:
    """Motion centre relative to the contact of a motion that is written down: effects, rod, motion.

    Of a translation the coordinates are infinite, or the slider's centre's where it moves along them.
    """
    return _of(kinds, "center_of", cones)


@generic
def center_under(kinds: Any) -> Callable[..., Any]:
    """Motion centre relative to the slider's centre under a force in a direction, as `motion_angle`."""
    return _of(kinds, "center_under", cones)
