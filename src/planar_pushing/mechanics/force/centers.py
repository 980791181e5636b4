"""Motion centers of the slider, exactly and by the paper's seven cases (Sec. 4)."""

from __future__ import annotations

from collections.abc import Sequence
from enum import StrEnum
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np

from planar_pushing.core.instant.kernels import MotionResult
from planar_pushing.core.supports.tolerances import COINCIDENT
from planar_pushing.mechanics.angles import AngleInterval, interval
from planar_pushing.mechanics.force.cones import force_columns
from planar_pushing.mechanics.kernels.arrays import Output, elementwise, evaluate_kernel, is_labeled
from planar_pushing.mechanics.kernels.columns import Columns
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene, require_point_scene
from planar_pushing.terms.domain import Number, Numbers, Scalar, require_ratio
from planar_pushing.terms.errors import InvalidValue, require_option
from planar_pushing.terms.units import named_units

if TYPE_CHECKING:
    import xarray as xr


class Origin(StrEnum):
    """The point to which positions are relative."""

    CONTACT = "contact"
    SLIDER_CENTER = "slider-center"


#: The enum, or its value.
OriginName = Origin | Literal["contact", "slider-center"]
CENTER = (Output("center", (("xy", 2),)),)
CONE = (Output("conservative_cone_right"), Output("conservative_cone_left"))


def _decode(results: Array, columns: Sequence[Any], outputs: Sequence[Any]) -> None:
    """Centers in the user's unit; the last columns of a row are the radius and the contact's position."""
    radius, reach, angle = (np.asarray(column)[..., None] for column in columns[-3:])
    centers = Columns(MotionResult, results).center
    outputs[0][:] = radius * (centers + reach * direction(angle[..., 0]))


@overload
def motion_centers(
    scene: Scene,
    force_angle: Scalar | Numbers,
    inertia_share: Scalar | Numbers | None = None,
    origin: OriginName = Origin.CONTACT,
    force_ratio: Scalar | Numbers | None = None,
) -> Array: ...
@overload
def motion_centers(
    scene: Scene,
    force_angle: xr.DataArray,
    inertia_share: Scalar | Numbers | xr.DataArray | None = None,
    origin: OriginName = Origin.CONTACT,
    force_ratio: Scalar | Numbers | xr.DataArray | None = None,
) -> xr.DataArray: ...
@overload
def motion_centers(
    scene: Scene,
    force_angle: Scalar | Numbers,
    inertia_share: xr.DataArray,
    origin: OriginName = Origin.CONTACT,
) -> xr.DataArray: ...
@overload
def motion_centers(
    scene: Scene,
    force_angle: Scalar | Numbers,
    inertia_share: None = None,
    origin: OriginName = Origin.CONTACT,
    *,
    force_ratio: xr.DataArray,
) -> xr.DataArray: ...
def motion_centers(
    scene: Scene,
    force_angle: Number,
    inertia_share: Number | None = None,
    origin: OriginName = Origin.CONTACT,
    force_ratio: Number | None = None,
) -> Number:
    """Motion centers, shape S + (2,), in the unit of the slider's lengths.

    A translation has its center at infinity. For inertia alone the centers lie on one line, the dual of
    the contact (Fig. 9).

    Parameters
    ----------
    scene : Scene
    force_angle : float or array, shape S
        phi, radians.
    inertia_share, force_ratio : float or array, optional
        As in `spin_ratio`, which raises the same errors.
    origin : {"contact", "slider-center"}
        The point to which the centers are relative.

    Returns
    -------
    ndarray or DataArray
        A DataArray if an argument, or a parameter of the scene, is one.
    """
    origin = require_option("origin", origin, Origin, "name one of these points")
    columns = force_columns(scene, force_angle, inertia_share, force_ratio)
    reach, angle = scene.rows.body[0] if origin == Origin.CONTACT else 0.0, scene.slider.rod_angle
    columns += [scene.slider.radius, reach, angle]
    centers = evaluate_kernel(
        "force_motions", scene.rows.data, columns, CENTER, MotionResult.size, _decode
    )[0]
    return named_units(centers, scene.units) if is_labeled(centers) else centers


def conservative_spin_ratios(arm: Array) -> tuple[Array, Array]:
    """Limits of the spin ratio in the paper's seven cases, for moment arms in units of R.

    The motion center is inside the ring (1 .. inf) for a line of force outside it, on the ring for a
    tangent line, outside it (0 .. 1) for a line through the ring, and at infinity (0) for a line through
    the ring center. It lies across the ring center from the line, so negative arms mirror the cases.
    """
    size = np.abs(arm)
    size = np.where(np.abs(size - 1.0) <= COINCIDENT, 1.0, size)
    near = np.where(size >= 1.0, 1.0, 0.0)
    far = np.where(size > 1.0, np.inf, np.where(size == 0.0, 0.0, 1.0))
    return np.copysign(near, arm), np.copysign(far, arm)


def _conservative_cones(length: Array, rod_angle: Array, low: Array, high: Array) -> list[Array]:
    """Bounds of the motion angle over the lines of force from `low` to `high`.

    At a fixed spin ratio the motion angle increases with the force angle, so a bound is attained on an
    edge of the friction cone or where the line of force touches the ring. On such a tangent the cases on
    both sides meet: the spin ratio takes every value from 0 to infinity. On an edge that is a tangent there
    is one side only, and the spin ratio is 1.
    """
    length, rod_angle, low, high = np.broadcast_arrays(length, rod_angle, low, high)
    angles = [
        ring_motion_angles(length, rod_angle, edge, ratio)
        for edge in (low, high)
        for ratio in conservative_spin_ratios(length * np.sin(rod_angle - edge))
    ]
    tangent_angle = np.arcsin(1.0 / np.maximum(length, 1.0))
    for first in (tangent_angle, -tangent_angle, np.pi - tangent_angle, tangent_angle - np.pi):
        for turn in (-2.0 * np.pi, 0.0, 2.0 * np.pi):
            tangent = rod_angle - (first + turn)
            margin = np.minimum(tangent - low, high - tangent)
            inside = (length > 1.0) & (margin > COINCIDENT)
            for size in (0.0, np.inf):
                ratio = np.copysign(size, np.sin(first))
                angle = ring_motion_angles(length, rod_angle, tangent, ratio)
                angles.append(np.where(inside, angle, angles[0]))
    return [np.minimum.reduce(angles), np.maximum.reduce(angles)]


def ring_motion_angles(length: Array, rod_angle: Array, force_angle: Array, ratio: Array) -> Array:
    """Angles of the contact's motion at spin ratios, which can be infinite (Eqs. 11-12)."""
    angle = rod_angle - force_angle
    with np.errstate(invalid="ignore"):
        spin_lever = np.where(length > 0.0, ratio * length, 0.0)
    finite = np.isfinite(spin_lever)
    spin_lever, part = np.where(finite, spin_lever, np.sign(ratio)), np.where(finite, 1.0, 0.0)
    return np.asarray(
        force_angle - np.arctan2(spin_lever * np.cos(angle), part + spin_lever * np.sin(angle))
    )


def conservative_motion_cone(scene: Scene) -> AngleInterval:
    """The paper's bound on the contact's motion with both effects, radians (Fig. 12).

    Returns
    -------
    AngleInterval
        For a labeled scene an xarray.Dataset, as in `friction_cone`.

    Raises
    ------
    InvalidValue
        If an effect alone does not turn the slider about a point of the ring under a tangent force, as
        facts 5-7 of Sec. 4 assume: with inertia, the radius of gyration must be the ring's radius.
    """
    if not require_point_scene(scene).isotropic:
        raise InvalidValue(
            "effects", scene.effects, "effects that are isotropic about the slider's center",
            "use motion_cone, which is exact for every support",
        )  # fmt: skip
    if scene.stores_energy:
        require_ratio("conservative_gyration", scene.inertia[1] ** 0.5)
    columns = [*scene.rows.body[:2], scene.cone.right, scene.cone.left]
    right, left = elementwise(_conservative_cones, columns, CONE)
    cone: AngleInterval = interval(right, left, closed=False)
    return cone
