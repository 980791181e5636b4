"""Motion centres: where the slider can turn about, exactly and by the paper's seven cases (Sec. 4)."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.angles import AngleInterval
from planar_pushing.mechanics.cones import friction_cone, spin_ratio
from planar_pushing.mechanics.errors import InvalidValue
from planar_pushing.mechanics.planar import (
    Array,
    contact_motion_angle,
    moment_arm,
    motion_center,
)
from planar_pushing.mechanics.scene import Scene


def motion_centers(
    scene: Scene, force_angle: npt.ArrayLike, inertia_share: npt.ArrayLike | None = None
) -> Array:
    """Motion centres relative to the contact, shape S + (2,), in the unit of the slider's lengths.

    Parameters and errors are those of `spin_ratio`; a translation has its centre at infinity. For
    inertia alone the centres lie on one line, the dual of the contact (Fig. 9).
    """
    slider = scene.slider
    k = spin_ratio(scene, force_angle, inertia_share)
    return motion_center(force_angle, k, slider.rod_length, slider.rod_angle, slider.radius)


def conservative_spin_ratios(moment_arm: npt.ArrayLike) -> tuple[Array, Array]:
    """Ends of the spin ratios that the paper's seven cases allow, for a moment arm in units of R.

    A line of force outside the ring puts the centre inside it (1 .. inf), a tangent line on it, a line
    through the ring outside it (0 .. 1), and a line through the ring centre at infinity (0);
    the centre lies opposite, so the cases mirror for negative arms.
    """
    arm = np.asarray(moment_arm, dtype=float)
    size = np.abs(arm)
    near = np.where(size >= 1, 1.0, 0.0)
    far = np.where(size > 1, np.inf, np.where(size == 0, 0.0, 1.0))
    return np.copysign(near, arm), np.copysign(far, arm)


def conservative_motion_cone(scene: Scene) -> AngleInterval:
    """The paper's bound on the contact's motion with both effects, radians (Fig. 12).

    At a fixed spin ratio the motion angle increases with the force angle, so the bound is attained
    on an edge of the friction cone or where the line of force touches the ring. On such a tangent
    the cases on both sides meet: the spin ratio takes every value from 0 to infinity.

    Raises
    ------
    InvalidValue
        Where an effect does not turn the slider about a point of the ring under a tangent force, as
        facts 5-7 of Sec. 4 presume: with inertia the radius of gyration must be the ring's radius.
    """
    for effect in scene.scaled_effects:
        if not np.isclose(effect.spin_ratio(1.0), 1.0, rtol=1e-12, atol=0.0):
            raise InvalidValue(
                "effects", effect, "inertia with the gyration radius of the ring",
                "use motion_cone, which is exact",
            )  # fmt: skip
    rod = scene.slider.length_ratio, scene.slider.rod_angle
    cone = friction_cone(scene)
    edges = np.array([cone.right, cone.left])
    ends = np.stack(conservative_spin_ratios(moment_arm(*rod, edges)))
    motions = contact_motion_angle(edges, ends, *rod).ravel()
    if rod[0] > 1:
        lean = np.arcsin(1 / rod[0])
        leans = np.add.outer(
            [lean, -lean, np.pi - lean, lean - np.pi], 2 * np.pi * np.arange(-1, 2)
        )
        tangents = rod[1] - leans[(rod[1] - leans > cone.right) & (rod[1] - leans < cone.left)]
        sides = np.sign(moment_arm(*rod, tangents)) * np.array([[0.0], [1.0], [np.inf]])
        motions = np.append(motions, contact_motion_angle(tangents, sides, *rod))
    return AngleInterval(float(motions.min()), float(motions.max()), closed=False)
