"""Limit curve: the forces through the contact that just move the slider, and the motions they cause.

For friction it is the section of the limit surface by the plane of zero torque about the contact
(Sec. 3); for inertia it is the ellipse of Sec. 4. One definition covers both: the forces whose motion has
the same potential of degree 2, or kinetic energy, as a unit translation. The contact motion is then normal
to the curve at the force. For the sum of both, this curve is one of many, one for each magnitude of motion.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from planar_pushing.core.instant.kernels import ForceRow, MotionResult
from planar_pushing.core.instant.magnitude import UNIT_ENERGY
from planar_pushing.mechanics.force.cones import is_magnitude_open, row_of_force
from planar_pushing.mechanics.force.held import require_held
from planar_pushing.mechanics.kernels.arrays import (
    Output,
    dataset,
    evaluate_kernel,
    is_labeled,
    same,
)
from planar_pushing.mechanics.kernels.columns import Columns
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene, require_point_scene
from planar_pushing.terms.domain import Number, Numbers, Scalar, require_in_range
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.units import named_units

if TYPE_CHECKING:
    import xarray as xr

OUTPUTS = (
    *map(Output, ("force_angle", "magnitude", "spin_ratio", "motion_angle")),
    Output("status", (), "i1"),
)


@dataclass(frozen=True, slots=True, kw_only=True)
class LimitCurve:
    """A limit curve, one entry per force angle (shape S).

    Attributes
    ----------
    force_angle : float or ndarray
        phi, radians.
    magnitude : float or ndarray
        |f|, in units of the weight or, without friction, of mass times a unit motion.
    spin_ratio : float or ndarray
        k = R omega / v.
    motion_angle : float or ndarray
        Angle of the contact's motion, radians: the curve's outward normal.
    status : int or ndarray
        Values of `Status`.
    """

    force_angle: Number
    magnitude: Number
    spin_ratio: Number
    motion_angle: Number
    status: Number

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    @property
    def force(self) -> Array:
        """Forces, shape S + (2,)."""
        return np.asarray(np.asarray(self.magnitude)[..., None] * direction(self.force_angle))

    @property
    def contact_motion(self) -> Array:
        """Unit vectors of the contact's motion, shape S + (2,)."""
        return direction(self.motion_angle)


def _decode(results: Array, columns: Sequence[Any], outputs: Sequence[Any]) -> None:
    """Write the outputs of a block of results of `force_motions`."""
    angle, magnitude, ratio, motion_angle, status = outputs
    motions = Columns(MotionResult, results)
    inputs = dict(zip(ForceRow.places, columns[-ForceRow.size :], strict=True))
    f_x, f_y = motions.force.T
    angle[:], magnitude[:] = inputs["force"], np.sqrt(f_x * f_x + f_y * f_y)
    ratio[:], motion_angle[:], status[:] = motions.spin_ratio, motions.angle, motions.status


@overload
def limit_curve(scene: Scene, force_angle: Scalar | Numbers) -> LimitCurve: ...
@overload
def limit_curve(scene: Scene, force_angle: xr.DataArray) -> xr.Dataset: ...
def limit_curve(scene: Scene, force_angle: Number) -> Any:
    """Limit curve of a scene at the given force angles (Eqs. 2-7; the ellipse of Sec. 4).

    Parameters
    ----------
    scene : Scene
    force_angle : float or array, shape S
        phi, radians.

    Returns
    -------
    LimitCurve, or xarray.Dataset
        A dataset if the angles, or a parameter of the scene, are a DataArray.

    Raises
    ------
    InvalidValue
        If the forces depend on the magnitude of the motion, as with friction and inertia, so that no single
        curve bounds them.
    """
    require_one_curve(scene)
    return curve_of_unit_motions(scene, force_angle)


def require_one_curve(
    scene: Scene,
    remedy: str = "leave out one effect, or the curve: motion_angle(..., force_ratio=...) takes the "
    "magnitude",
) -> None:
    """Refuse a scene whose forces depend on the magnitude of the motion, and say what to do instead."""
    if is_magnitude_open(require_point_scene(scene)):
        raise InvalidValue(
            "limit_curve", " and ".join(type(effect).__name__ for effect in scene.effects),
            "a scene whose forces do not depend on the magnitude of its motion", remedy,
        )  # fmt: skip


def curve_of_unit_motions(scene: Scene, force_angle: Number) -> Any:
    """As `limit_curve`; with friction and inertia, the curve of one of many magnitudes of motion."""
    scene, angle = require_point_scene(scene), require_in_range("force_angle", force_angle)
    require_held(scene)
    rows = scene.rows
    columns = [*rows.columns, *row_of_force(scene, angle, UNIT_ENERGY, 0.0)]
    arrays = evaluate_kernel(
        "force_motions", rows.data, columns, OUTPUTS, MotionResult.size, _decode
    )
    if is_labeled(arrays[0]):
        return named_units(dataset(arrays[1:]), scene.units, inertia=scene.stores_energy)
    return LimitCurve(**dict(zip(LimitCurve.__slots__, arrays, strict=True)))
