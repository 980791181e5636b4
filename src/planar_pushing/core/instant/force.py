"""The motion under a line of force, as the only root of the force across the line.

Psi is convex along a path across the line of force. The force across the line therefore increases, and
there is exactly one motion with a given component along the line. With effects of one degree, the motions
for all components have the same direction.
"""

from __future__ import annotations

from math import fabs
from typing import NamedTuple

from planar_pushing.core.instant.path import (
    Path,
    Sample,
    end_of_flat,
    find_root,
    first_sample,
    hinge_on_edge,
    is_flat,
    motion_at,
    sample_at_infinity,
    sample_near,
    sample_path,
)
from planar_pushing.core.numbers import INFINITY
from planar_pushing.core.supports.contact import Contact
from planar_pushing.core.supports.potential import Psi
from planar_pushing.core.supports.psi import psi
from planar_pushing.core.supports.resistance import rough_mass
from planar_pushing.core.supports.rows import NO_POINT, Effects
from planar_pushing.core.supports.tolerances import COINCIDENT, FLAT

#: Number of Newton steps that polish a root within the rounding of its motion.
POLISHES = 2
#: Farthest motion at which the end of a continuum is searched for, in units of the motion at the root.
FARTHEST_END = 1e20


class ContactMotion(NamedTuple):
    """A motion of the slider and the force at the contact that sustains it, in the body frame.

    Attributes
    ----------
    u_x, u_y : float
        Motion of the contact.
    v_x, v_y, spin : float
        Twist of the origin.
    f_x, f_y : float
        Force; for a pivot with an undetermined force, the midpoint of its interval.
    half_x, half_y : float
        Half of that interval, otherwise zero.
    point : int
        Number of the support point about which the slider pivots, -1 without one.
    continuum : bool
        Whether the motion is an end of a continuum, or its rotation is one of an interval.
    noise_x, noise_y : float
        Rounding errors of the force.
    converged : bool
    """

    u_x: float
    u_y: float
    v_x: float
    v_y: float
    spin: float
    f_x: float
    f_y: float
    half_x: float
    half_y: float
    point: int
    continuum: bool
    noise_x: float
    noise_y: float
    converged: bool


class MotionRange(NamedTuple):
    """The first and the last motion under a line of force; they are the same without a continuum."""

    first: ContactMotion
    last: ContactMotion


def replace_force(
    motion: ContactMotion, f_x: float, f_y: float, half_x: float, half_y: float
) -> ContactMotion:
    """A motion with another force."""
    return ContactMotion(
        motion.u_x, motion.u_y, motion.v_x, motion.v_y, motion.spin, f_x, f_y, half_x, half_y,
        motion.point, motion.continuum, motion.noise_x, motion.noise_y, motion.converged,
    )  # fmt: skip


def leave_continuum(motion: ContactMotion) -> ContactMotion:
    """The same motion, marked as one of its own."""
    return ContactMotion(
        motion.u_x, motion.u_y, motion.v_x, motion.v_y, motion.spin, motion.f_x, motion.f_y,
        motion.half_x, motion.half_y, motion.point, False, motion.noise_x, motion.noise_y,
        motion.converged,
    )  # fmt: skip


def sticking_motion(x: float, y: float, root: Psi) -> ContactMotion:
    """The motion of a contact that moves by (x, y), from Psi there."""
    return ContactMotion(
        u_x=x,
        u_y=y,
        v_x=root.v_x,
        v_y=root.v_y,
        spin=root.spin,
        f_x=root.f_x,
        f_y=root.f_y,
        half_x=root.half_x,
        half_y=root.half_y,
        point=root.point,
        continuum=root.continuum,
        noise_x=root.noise_x,
        noise_y=root.noise_y,
        converged=root.converged,
    )


def motion_at_root(path: Path, s: float, spin: float, continuum: bool, point: int) -> ContactMotion:
    """The motion at a root of a path, or at the kink of a point, with its force along the edge.

    The force on a long rod depends on small components of a motion that the sum ``p + s d`` rounds away.
    The root is therefore polished by less than the rounding of its motion. If the edge's line passes
    through the point, the point's friction changes the force only along the edge, which is then an
    interval.
    """
    u = motion_at(path, s)
    x, y = u.x, u.y
    for _ in range(POLISHES if point < 0 else 0):
        rest = Path(
            path.effects, path.contact, path.e_x, path.e_y, p_x=x, p_y=y, d_x=path.d_x, d_y=path.d_y
        )
        sample = sample_path(rest, 0.0, spin, NO_POINT)
        step = -sample.before / sample.slope if sample.slope != 0.0 else 0.0
        size = fabs(step) * (fabs(path.d_x) + fabs(path.d_y))
        if sample.before != sample.after or size > COINCIDENT * (fabs(x) + fabs(y)):
            break
        x, y, spin = x + step * path.d_x, y + step * path.d_y, sample.spin + step * sample.swing
    hinge = hinge_on_edge(path, x, y, spin)
    root = psi(
        path.effects,
        path.contact,
        x,
        y,
        guess=spin,
        point=hinge if hinge >= 0 else point,
        tolerance=0.0,
    )
    part, half = 0.0, path.e_x * root.half_y - path.e_y * root.half_x
    along = 0.0
    if hinge >= 0:
        along = fabs(path.e_x * root.half_x + path.e_y * root.half_y)
    elif half != 0.0:
        part = -(path.e_x * root.f_y - path.e_y * root.f_x) / half
        part = min(max(part, -1.0), 1.0)
    force = path.e_x * (root.f_x + part * root.half_x) + path.e_y * (root.f_y + part * root.half_y)
    flat: bool = continuum or root.continuum
    return ContactMotion(
        u_x=x,
        u_y=y,
        v_x=root.v_x,
        v_y=root.v_y,
        spin=root.spin,
        f_x=force * path.e_x,
        f_y=force * path.e_y,
        half_x=along * path.e_x,
        half_y=along * path.e_y,
        point=root.point,
        continuum=flat,
        noise_x=root.noise_x,
        noise_y=root.noise_y,
        converged=root.converged,
    )


def path_across(effects: Effects, contact: Contact, e_x: float, e_y: float, along: float) -> Path:
    """The path of motions with a given component along a line of force."""
    return Path(effects, contact, e_x, e_y, p_x=along * e_x, p_y=along * e_y, d_x=-e_y, d_y=e_x)


def _guess_root(path: Path, along: float) -> float:
    """A first guess of the root, that of a mass that roughly matches the effects.

    Motions against the force, or without a component along it, are caused by loads; the guess for them is
    zero.
    """
    if not along > 0.0:
        return 0.0
    rough = rough_mass(path.effects, along, path.contact.x, path.contact.y)
    m, x, y, inertia = rough.mass, rough.x, rough.y, rough.inertia
    if inertia == 0.0:
        return 0.0
    # The force of a motion (u, spin) without torque is M u, so u is M^-1 e up to a factor.
    u_x = (m - x * x / inertia) * path.e_x - x * y / inertia * path.e_y
    u_y = (m - y * y / inertia) * path.e_y - x * y / inertia * path.e_x
    across, ahead = path.e_x * u_y - path.e_y * u_x, path.e_x * u_x + path.e_y * u_y
    return along * across / ahead if ahead > 0.0 else 0.0


def _root_of(path: Path, along: float) -> Sample:
    """The root of a path across a line of force."""
    return find_root(
        path, sample_at_infinity(-INFINITY, -1.0), sample_at_infinity(INFINITY, 1.0),
        first_sample(path, _guess_root(path, along)),
    )  # fmt: skip


def motion_under_force(
    effects: Effects, contact: Contact, e_x: float, e_y: float, along: float
) -> ContactMotion:
    """The motion under a line of force with a given component along it; any motion of a continuum."""
    path = path_across(effects, contact, e_x, e_y, along)
    root = _root_of(path, along)
    return motion_at_root(path, root.s, root.spin, False, root.point)


def mark_unsolved(motion: ContactMotion) -> ContactMotion:
    """The same motion, marked as not converged."""
    return ContactMotion(
        motion.u_x,
        motion.u_y,
        motion.v_x,
        motion.v_y,
        motion.spin,
        motion.f_x,
        motion.f_y,
        half_x=0.0,
        half_y=0.0,
        point=motion.point,
        continuum=motion.continuum,
        noise_x=motion.noise_x,
        noise_y=motion.noise_y,
        converged=False,
    )


def motions_under_force(
    effects: Effects, contact: Contact, e_x: float, e_y: float, along: float
) -> MotionRange:
    """The first and the last motion under a line of force with a given component along it."""
    path = path_across(effects, contact, e_x, e_y, along)
    root = _root_of(path, along)
    low, high, scale = root, root, fabs(root.s) + along
    touches: bool = root.before != root.after
    touches = touches and min(fabs(root.before), fabs(root.after)) <= root.noise
    if root.converged and (touches or _is_in_continuum(path, root, scale)):
        low, high = _end_of_continuum(path, root, -1.0), _end_of_continuum(path, root, 1.0)
    continuum: bool = low.s < high.s
    first = motion_at_root(path, low.s, low.spin, continuum, low.point)
    if not continuum:
        return MotionRange(first, first)
    return MotionRange(first, motion_at_root(path, high.s, high.spin, continuum, high.point))


def _is_in_continuum(path: Path, root: Sample, scale: float) -> bool:
    """Whether a root is in a continuum or at its end: the force is along the line to rounding."""
    if is_flat(path, root, scale):
        return True
    if is_flat(path, sample_near(path, root, root.s - FLAT * scale), scale):
        return True
    return is_flat(path, sample_near(path, root, root.s + FLAT * scale), scale)


def _end_of_continuum(path: Path, root: Sample, sense: float) -> Sample:
    """The end of a continuum around a root, in one sense along the path."""
    scale, inside = fabs(root.s) + fabs(path.p_x) + fabs(path.p_y), root
    step = FLAT * scale
    while step < FARTHEST_END * scale:
        sample = sample_near(path, inside, root.s + sense * step)
        if max(fabs(sample.before), fabs(sample.after)) > sample.noise:
            return end_of_flat(path, inside, sample) if inside.s != root.s else root
        inside, step = sample, 2.0 * step
    return inside
