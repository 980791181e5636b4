"""Limit curve: the forces through the contact that just move the slider, and the motions they cause.

For friction it is the section of the limit surface by the plane of no torque about the contact
(Sec. 3); for inertia it is the ellipse of Sec. 4. One definition serves both and their sum: the forces
whose motion has the potential of degree 2, the kinetic energy, of a unit translation. The contact
motion is then normal to the curve at the force.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics import response
from planar_pushing.mechanics.planar import Array, contact_motion_angle, direction, moment_arm
from planar_pushing.mechanics.scene import Scene


@dataclass(frozen=True, slots=True, kw_only=True)
class LimitCurve:
    """A limit curve, one entry per force angle (shape S).

    Attributes
    ----------
    force_angle : ndarray
        phi, radians.
    magnitude : ndarray
        |f|, in the unit of the weight or, without friction, of mass times a unit motion.
    spin_ratio : ndarray
        k = R omega / v.
    motion_angle : ndarray
        Angle of the contact's motion, radians: the curve's outward normal.
    """

    force_angle: Array
    magnitude: Array
    spin_ratio: Array
    motion_angle: Array

    @property
    def force(self) -> Array:
        """Forces, shape S + (2,)."""
        return self.magnitude[..., None] * direction(self.force_angle)

    @property
    def contact_motion(self) -> Array:
        """Unit vectors of the contact's motion, shape S + (2,)."""
        return direction(self.motion_angle)


def _speed(resisting: response.Resistance, spin_ratio: Array) -> Array:
    """Centre speed at which the potential of degree 2 is that of a unit translation."""
    inertial = [effect for kind in resisting.kinds for effect in response.of_degree(kind, 2)]
    unit = np.stack(np.broadcast_arrays(1.0, 0.0, spin_ratio), axis=-1)
    energy = sum(effect.potential(unit) for effect in inertial)
    rest = sum(effect.potential(np.array([1.0, 0.0, 0.0])) for effect in inertial)
    return np.sqrt(np.divide(rest, energy)) if inertial else np.ones(np.shape(spin_ratio))


def _curve_force(resisting: response.Resistance, spin_ratio: Array) -> tuple[Array, Array]:
    """Force and torque on the curve at each spin ratio, in units of `resisting`."""
    return resisting.profile(spin_ratio, _speed(resisting, spin_ratio))


def _curve_spin_ratio(
    effects: response.Effects, resisting: response.Resistance, arm: Array
) -> Array:
    if response.is_homogeneous(effects):
        return response.spin_ratio(effects, arm, None)

    def excess(k: Array, h: Array) -> Array:
        force, torque = _curve_force(resisting, k)
        return torque - h * force

    size = np.abs(arm)
    ends = np.stack([response.spin_ratio(kind, size, None) for kind in resisting.kinds])
    return np.copysign(response.root(excess, ends.min(axis=0), ends.max(axis=0), (size,)), arm)


def limit_curve(scene: Scene, force_angle: npt.ArrayLike) -> LimitCurve:
    """Limit curve of a scene at the given force angles (Eqs. 2-7; the ellipse of Sec. 4).

    Parameters
    ----------
    scene : Scene
    force_angle : array_like, shape S
        phi, radians.

    Returns
    -------
    LimitCurve
    """
    phi = np.asarray(force_angle, dtype=float)
    rod = scene.slider.length_ratio, scene.slider.rod_angle
    resisting = response.resistance(scene.scaled_effects)
    k = _curve_spin_ratio(scene.scaled_effects, resisting, moment_arm(*rod, phi))
    magnitude, _ = _curve_force(resisting, k)
    return LimitCurve(
        force_angle=phi,
        magnitude=np.asarray(resisting.force * magnitude),
        spin_ratio=k,
        motion_angle=contact_motion_angle(phi, k, *rod),
    )
