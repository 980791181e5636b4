"""Friction cone -> motion cone (Secs. 3.1, 3.2 and 4)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics import response
from planar_pushing.mechanics.angles import RESOLUTION, AngleInterval
from planar_pushing.mechanics.contact import ContactLaw
from planar_pushing.mechanics.planar import Array, contact_motion_angle, moment_arm
from planar_pushing.mechanics.scene import Scene


def friction_cone(scene: Scene) -> AngleInterval:
    """Force angles that the scene's contact can transmit, radians."""
    return scene.contact.force_angles


def spin_ratio(
    scene: Scene, force_angle: npt.ArrayLike, inertia_share: npt.ArrayLike | None = None
) -> Array:
    """Spin ratio k = R omega / v for each force angle.

    Parameters
    ----------
    scene : Scene
    force_angle : array_like
        phi, radians.
    inertia_share : array_like, optional
        s / (1 + s) in [0, 1] with s = m a / W, required where the scene has friction and inertia and
        refused otherwise; broadcast against `force_angle`.

    Raises
    ------
    InvalidValue
        Where `inertia_share` is missing, superfluous or out of range.

    Notes
    -----
    Solves Eq. (7) for friction and Eq. (10) for inertia, with both
    ``h / R = (t(k) + s (rho/R)^2 k) / (f(k) + s)``.
    """
    arm = moment_arm(scene.slider.length_ratio, scene.slider.rod_angle, force_angle)
    return response.spin_ratio(scene.scaled_effects, arm, inertia_share)


def motion_angle(
    scene: Scene, force_angle: npt.ArrayLike, inertia_share: npt.ArrayLike | None = None
) -> Array:
    """Angle of the contact's motion for each force angle, radians, unwrapped and increasing.

    Parameters, errors and equations are those of `spin_ratio`.
    """
    k = spin_ratio(scene, force_angle, inertia_share)
    return contact_motion_angle(force_angle, k, scene.slider.length_ratio, scene.slider.rod_angle)


def edge_motions(scene: Scene, edges: npt.ArrayLike) -> Array:
    """Motion angles of force angles of shape S under each kind of effect alone, shape (kinds,) + S."""
    rod = scene.slider.length_ratio, scene.slider.rod_angle
    kinds = [response.of_degree(scene.scaled_effects, degree) for degree in (1, 2)]
    arm = moment_arm(*rod, edges)
    ratios = [response.spin_ratio(kind, arm, None) for kind in kinds if kind]
    return np.stack([contact_motion_angle(edges, ratio, *rod) for ratio in ratios])


def motion_cones(scene: Scene, laws: Sequence[ContactLaw]) -> list[AngleInterval]:
    """Motion cones of the scene's slider and effects under other contact laws, as `motion_cone`."""
    force_angles = [law.force_angles for law in laws]
    angles = edge_motions(scene, [[cone.right, cone.left] for cone in force_angles])
    reached = np.ptp(angles, axis=0).max(axis=-1) <= RESOLUTION
    left = angles[..., 1].max(axis=0)
    # Rounding may cross the edges of a long rod's cone, which is narrower than an ulp.
    right = np.minimum(angles[..., 0].min(axis=0), left)
    cones = zip(right.tolist(), left.tolist(), reached.tolist(), force_angles, strict=True)
    return [AngleInterval(a, b, force.closed and met) for a, b, met, force in cones]


def motion_cone(scene: Scene) -> AngleInterval:
    """Motion cone: directions in which the contact can move without slip, radians.

    It is the velocity cone of a scene with friction, the acceleration cone of one with inertia,
    and with both the exact union over all magnitudes of the motion. The map from force angle to motion
    angle increases, so the edges are those of the friction cone. With both effects an edge at
    which they differ is approached and never reached: the cone is open.
    """
    return motion_cones(scene, [scene.contact])[0]


def leaves_the_fence(cone: AngleInterval) -> bool:
    """Whether a motion cone holds motions away from the slider (Sec. 3.1)."""
    return cone.right < -RESOLUTION or cone.left > np.pi + RESOLUTION


def can_pull(scene: Scene) -> bool:
    """Whether the contact can stick while the pusher moves away from the slider (Sec. 3.1)."""
    return leaves_the_fence(motion_cone(scene))


def omits_pushes(cone: AngleInterval) -> bool:
    """Whether a motion cone leaves out motions into the slider (Sec. 3.2)."""
    return cone.right > RESOLUTION or cone.left < np.pi - RESOLUTION


def slips_while_pushing(scene: Scene) -> bool:
    """Whether some pusher motion into the slider makes the contact slip (Sec. 3.2)."""
    return scene.contact.slips and omits_pushes(motion_cone(scene))
