"""Friction cone -> motion cone (Secs. 3.1, 3.2 and 4)."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.angles import RESOLUTION, AngleInterval, interval
from planar_pushing.mechanics.compiled import kernel, owning
from planar_pushing.mechanics.effects.base import COLUMNS, made
from planar_pushing.mechanics.numerics.arrays import Output, evaluated, named
from planar_pushing.mechanics.plane import rod, seen
from planar_pushing.mechanics.reduced import base
from planar_pushing.mechanics.scene import Scene, required_scene
from planar_pushing.terms.domain import Number, required
from planar_pushing.terms.errors import InvalidValue

#: Columns of a row behind those of the effects.
LENGTH, ANGLE, FIRST, SECOND = range(COLUMNS, COLUMNS + 4)
CONE = (Output("motion_cone_right"), Output("motion_cone_left"), Output("closed", (), "?"))


def friction_cone(scene: Scene) -> Any:
    """Force angles that the scene's contact can transmit, radians.

    Returns
    -------
    AngleInterval, or xarray.Dataset
        A dataset with the variables `right`, `left` and `closed` where an argument is a DataArray.
    """
    law = required_scene(scene).law
    return interval(law.right, law.left, law.closed)


def unit_columns(scene: Scene, inertia_share: Number = 0.5) -> list[Number]:
    """Columns of effects, as weight and mass their shares of the force in a translation, and of the rod."""
    both = scene.friction and scene.masses
    shares = [1.0 - inertia_share, inertia_share] if both else [1.0, 1.0]
    slider = scene.slider
    return [*shares, scene.inertia[1], *scene.placement, slider.length_ratio, slider.rod_angle]


def force_columns(scene: Scene, force_angle: Number, inertia_share: Number | None) -> list[Number]:
    """The columns of a scene under a force."""
    share = _required_share(scene, inertia_share)
    return [*unit_columns(scene, share), required("force_angle", force_angle)]


def _required_share(scene: Scene, inertia_share: Number | None) -> Number:
    """The share of inertia where the effects leave it open."""
    if not (required_scene(scene).friction and scene.masses):
        if inertia_share is not None:
            raise InvalidValue(
                "inertia_share", inertia_share, "None for a scene whose effects are of one kind",
                "leave the argument out",
            )  # fmt: skip
        return 0.5
    if inertia_share is None:
        raise InvalidValue(
            "inertia_share", inertia_share, "numbers in [0, 1] for a scene with friction and inertia",
            "give s / (1 + s) with s = m a / W; motion_cone and solve need none",
        )  # fmt: skip
    return required("inertia_share", inertia_share)


@owning
def under_force(kinds, row):
    """Effects, rod, and force in the first direction of a row."""
    own = rod(row[LENGTH], row[ANGLE])
    return made(kinds, row), own, seen(own, row[FIRST])


@kernel
@owning
def _spin_ratios(kinds, rows, ratios):
    for i in range(len(rows)):
        effects, own, force = under_force(kinds, rows[i])
        ratios[i] = base.spin_ratio(effects, own, force)


@kernel
@owning
def _motion_angles(kinds, rows, angles):
    for i in range(len(rows)):
        effects, own, force = under_force(kinds, rows[i])
        angles[i] = base.motion_angle(effects, own, force)


def spin_ratio(
    scene: Scene, force_angle: npt.ArrayLike, inertia_share: npt.ArrayLike | None = None
) -> Number:
    """Spin ratio k = R omega / v for each force angle.

    Parameters
    ----------
    scene : Scene
    force_angle : float or array
        phi, radians.
    inertia_share : float or array, optional
        s / (1 + s) in [0, 1] with s = m a / W, required where the scene has friction and inertia and
        refused otherwise; broadcast against `force_angle`.

    Returns
    -------
    float, ndarray or DataArray
        As the arguments are.

    Raises
    ------
    InvalidValue
        Where `inertia_share` is missing, superfluous or out of range, or an angle is not finite.

    Notes
    -----
    Solves Eq. (7) for friction and Eq. (10) for inertia, with both
    ``h / R = (t(k) + s (rho/R)^2 k) / (f(k) + s)``.
    """
    columns = force_columns(scene, force_angle, inertia_share)
    return evaluated(_spin_ratios, scene.kinds, columns, [Output("spin_ratio")])[0]


def motion_angle(
    scene: Scene, force_angle: npt.ArrayLike, inertia_share: npt.ArrayLike | None = None
) -> Number:
    """Angle of the contact's motion for each force angle, radians, unwrapped and increasing.

    Parameters
    ----------
    scene : Scene
    force_angle : float or array
        phi, radians.
    inertia_share : float or array, optional
        As in `spin_ratio`, whose errors and equations are those of this function.

    Returns
    -------
    float, ndarray or DataArray
        As the arguments are.
    """
    columns = force_columns(scene, force_angle, inertia_share)
    return evaluated(_motion_angles, scene.kinds, columns, [Output("motion_angle")])[0]


@kernel
@owning
def _motion_cones(kinds, rows, right, left, reached):
    for i in range(len(rows)):
        effects, own, force = under_force(kinds, rows[i])
        low, low_other = base.motion_angles(effects, own, force)
        high_other, high = base.motion_angles(effects, own, seen(own, rows[i, SECOND]))
        # Rounding may cross the edges of a long rod's cone, which is narrower than an ulp.
        right[i], left[i] = min(low, high), high
        spread = max(low_other - low, high - high_other)
        reached[i] = len(effects) == 1 or spread <= RESOLUTION


def motion_cone(scene: Scene) -> Any:
    """Motion cone: directions in which the contact can move without slip, radians.

    It is the velocity cone of a scene with friction, the acceleration cone of one with inertia,
    and with both the exact union over all magnitudes of the motion. The map from force angle to motion
    angle increases, so the edges are those of the friction cone. With both effects an edge at
    which they differ is approached and never reached: the cone is open. What is returned is as for
    `friction_cone`.
    """
    law = required_scene(scene).law
    columns = [*unit_columns(scene), law.right, law.left]
    right, left, reached = evaluated(_motion_cones, scene.kinds, columns, CONE)
    return interval(right, left, law.closed & reached)


def leaves_the_fence(cone: AngleInterval) -> Any:
    """Whether a motion cone holds motions away from the slider (Sec. 3.1)."""
    return (cone.right < -RESOLUTION) | (cone.left > np.pi + RESOLUTION)


def can_pull(scene: Scene) -> Any:
    """Whether the contact can stick while the pusher moves away from the slider (Sec. 3.1)."""
    return named("pulls", leaves_the_fence(motion_cone(scene)))


def omits_pushes(cone: AngleInterval) -> Any:
    """Whether a motion cone leaves out motions into the slider (Sec. 3.2)."""
    return (cone.right > RESOLUTION) | (cone.left < np.pi - RESOLUTION)


def slips_while_pushing(scene: Scene) -> Any:
    """Whether some pusher motion into the slider makes the contact slip (Sec. 3.2)."""
    omits = omits_pushes(motion_cone(scene))
    return named("slips_while_pushing", scene.law.slips & omits)
