"""Friction cone -> motion cone (Secs. 3.1, 3.2 and 4)."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics import response
from planar_pushing.mechanics.angles import RESOLUTION, AngleInterval
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


def edge_motions(scene: Scene, cone: AngleInterval) -> Array:
    """Motion angles of a cone's edges under each kind of effect alone, shape (kinds, 2)."""
    rod = scene.slider.length_ratio, scene.slider.rod_angle
    edges = np.array([cone.right, cone.left])
    kinds = [response.of_degree(scene.scaled_effects, degree) for degree in (1, 2)]
    ratios = [response.spin_ratio(kind, moment_arm(*rod, edges), None) for kind in kinds if kind]
    return np.stack([contact_motion_angle(edges, ratio, *rod) for ratio in ratios])


def motion_cone(scene: Scene) -> AngleInterval:
    """Motion cone: directions in which the contact can move without slip, radians.

    It is the velocity cone of a scene with friction, the acceleration cone of one with inertia,
    and with both the exact union over all magnitudes of the motion. The map from force angle to motion
    angle increases, so the edges are those of the friction cone. With both effects an edge at
    which they differ is approached and never reached: the cone is open.
    """
    force_angles = friction_cone(scene)
    angles = edge_motions(scene, force_angles)
    reached = bool(np.ptp(angles, axis=0).max() <= RESOLUTION)
    right, left = float(angles[:, 0].min()), float(angles[:, 1].max())
    # Rounding may cross the edges of a long rod's cone, which is narrower than an ulp.
    return AngleInterval(min(right, left), left, closed=force_angles.closed and reached)


def can_pull(scene: Scene) -> bool:
    """Whether the contact can stick while the pusher moves away from the slider (Sec. 3.1)."""
    cone = motion_cone(scene)
    return cone.right < -RESOLUTION or cone.left > np.pi + RESOLUTION


def slips_while_pushing(scene: Scene) -> bool:
    """Whether some pusher motion into the slider makes the contact slip (Sec. 3.2)."""
    cone = motion_cone(scene)
    inside = cone.right > RESOLUTION or cone.left < np.pi - RESOLUTION
    return inside and scene.contact.slips
