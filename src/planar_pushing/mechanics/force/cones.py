"""From the friction cone to the motion cone (Secs. 3.1, 3.2 and 4)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Protocol, overload

import numpy as np

from planar_pushing.core.instant.kernels import ConeRow, ForceRow, MotionResult
from planar_pushing.core.instant.magnitude import FORCE_SIZE, UNIT_SPEED
from planar_pushing.mechanics.angles import RESOLUTION, AngleInterval, interval
from planar_pushing.mechanics.force.held import require_held
from planar_pushing.mechanics.kernels.arrays import Output, evaluate_kernel, label_result
from planar_pushing.mechanics.kernels.columns import Columns, row_of
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.rows import scale_forces
from planar_pushing.mechanics.scene import Scene, require_point_scene, require_scene
from planar_pushing.terms.domain import Number, Numbers, Scalar, require_in_range
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import in_radians

if TYPE_CHECKING:
    import xarray as xr


class OfForce(Protocol):
    """A function of a scene, force angles, and an inertia share or a magnitude of the force."""

    __name__: str

    @overload
    def __call__(
        self, scene: Scene, force_angle: Scalar, inertia_share: Scalar | None = None,
        force_ratio: Scalar | None = None,
    ) -> float: ...  # fmt: skip
    @overload
    def __call__(
        self, scene: Scene, force_angle: Numbers, inertia_share: Scalar | Numbers | None = None,
        force_ratio: Scalar | Numbers | None = None,
    ) -> Array: ...  # fmt: skip
    @overload
    def __call__(self, scene: Scene, force_angle: Scalar, inertia_share: Numbers) -> Array: ...
    @overload
    def __call__(
        self, scene: Scene, force_angle: Scalar, inertia_share: None = None, *, force_ratio: Numbers
    ) -> Array: ...
    @overload
    def __call__(
        self, scene: Scene, force_angle: xr.DataArray,
        inertia_share: Scalar | Numbers | xr.DataArray | None = None,
        force_ratio: Scalar | Numbers | xr.DataArray | None = None,
    ) -> xr.DataArray: ...  # fmt: skip
    @overload
    def __call__(
        self, scene: Scene, force_angle: Scalar | Numbers, inertia_share: xr.DataArray
    ) -> xr.DataArray: ...
    @overload
    def __call__(
        self, scene: Scene, force_angle: Scalar | Numbers, inertia_share: None = None, *,
        force_ratio: xr.DataArray,
    ) -> xr.DataArray: ...  # fmt: skip


def of_force(function: Callable[..., Any]) -> OfForce:
    """The same function, with the types of `OfForce`."""
    typed: OfForce = function
    return typed


CONE = (
    Output("motion_cone_right"), Output("motion_cone_left"), Output("closed", (), "?"),
    Output("status", (), "i1"),
)  # fmt: skip


def friction_cone(scene: Scene) -> AngleInterval:
    """Force angles that the scene's contact can transmit, radians.

    Returns
    -------
    AngleInterval
        For a labeled scene, which has a DataArray as a parameter, an xarray.Dataset with the variables
        `right`, `left` and `closed`.
    """
    law = require_scene(scene).cone
    cone: AngleInterval = interval(law.right, law.left, law.closed)
    return cone


def unit_columns(scene: Scene, inertia_share: Number = 0.5) -> list[Number]:
    """Columns of the effects in units of their forces in a translation.

    If there are effects of degrees 1 and 2, those of degree 2 have the share `inertia_share` of the force.
    """
    require_held(require_point_scene(scene))
    rows = scene.rows
    if scene.loads and not scene.friction:
        raise InvalidValue(
            "effects", scene.effects, "friction together with a load", "use solve: under a load without "
            "friction the motion depends on the magnitude of the force",
        )  # fmt: skip
    shares = (1.0, 1.0) if rows.is_steady else (1.0 - inertia_share, inertia_share)
    units = [rows.strength(degree) for degree in (1, 2)]
    return scale_forces(rows.entries, rows.columns, shares, units)


def row_of_force(scene: Scene, force_angle: Number, norm: int, size: Number) -> list[Any]:
    """The columns of a force, which follow those of the effects."""
    length, angle, _ = scene.rows.body
    return row_of(
        ForceRow, length=length, angle=angle, force=force_angle, norm=norm, magnitude=size
    )


def force_columns(
    scene: Scene, force_angle: Number, inertia_share: Number | None, force_ratio: Number | None
) -> list[Number]:
    """The columns of a scene under a force, of the magnitude that fits an inertia share or a ratio."""
    share, ratio = _required_magnitude(scene, inertia_share, force_ratio)
    norm = UNIT_SPEED if force_ratio is None else FORCE_SIZE
    # With shares of one half, the weight is half the unit of force.
    angle = require_in_range("force_angle", force_angle)
    return [*unit_columns(scene, share), *row_of_force(scene, angle, norm, np.divide(ratio, 2))]


def _required_magnitude(
    scene: Scene, share: Number | None, ratio: Number | None
) -> tuple[Number, Number]:
    """Inertia share and |f| / W, if the motion depends on the magnitude of the force."""
    open_, magnitudes = is_magnitude_open(require_point_scene(scene)), (share, ratio)
    name = "inertia_share" if ratio is None else "force_ratio"
    if not open_ and magnitudes != (None, None):
        raise InvalidValue(
            name, share if ratio is None else ratio, "None for a scene whose effects are of one kind",
            "leave the argument out",
        )  # fmt: skip
    if not open_:
        return 0.5, 0.0
    if share is not None and not scene.isotropic:
        raise InvalidValue(
            "inertia_share", share, "None if the effects are not isotropic about the slider's center",
            "give force_ratio = |f| / W: several motions can share one m a / W",
        )  # fmt: skip
    if (share is None) == (ratio is None):
        raise InvalidValue(
            "inertia_share", share, "numbers in [0, 1] for a scene with friction and inertia",
            "give s / (1 + s) with s = m a / W, or force_ratio = |f| / W; motion_cone and solve need none",
        )  # fmt: skip
    return (
        (require_in_range("inertia_share", share), 0.0)
        if ratio is None
        else (0.5, require_in_range("force_ratio", ratio))
    )


def is_magnitude_open(scene: Scene) -> bool:
    """Whether the direction of a motion depends on its magnitude."""
    return not scene.rows.is_steady


@of_force
def spin_ratio(
    scene: Scene,
    force_angle: Number,
    inertia_share: Number | None = None,
    force_ratio: Number | None = None,
) -> Number:
    """Spin ratio k = R omega / v for each force angle.

    Parameters
    ----------
    scene : Scene
    force_angle : float or array
        phi, radians.
    inertia_share : float or array, optional
        s / (1 + s) in [0, 1], with s = m a / W and a the acceleration of the slider's center. Only for a
        scene with friction and inertia that is isotropic about that center: in others it does not determine
        the motion.
    force_ratio : float or array, optional
        |f| / W > 0, for any scene with effects of both degrees; the result is NaN if friction holds the
        slider under this force.

    Returns
    -------
    float, ndarray or DataArray
        Of the type of the arguments; an array for an array of scenes, a DataArray for a labeled scene.

    Raises
    ------
    InvalidValue
        If `inertia_share` is missing, superfluous or out of range, or an angle is beyond 4 pi.

    Notes
    -----
    Solves Eq. (7) for friction, Eq. (10) for inertia, and with both
    ``h / R = (t(k) + s (rho/R)^2 k) / (f(k) + s)``.
    """
    columns = force_columns(scene, force_angle, inertia_share, force_ratio)
    return _of_motion(scene, columns, "spin_ratio", "spin_ratio")


@of_force
def motion_angle(
    scene: Scene,
    force_angle: Number,
    inertia_share: Number | None = None,
    force_ratio: Number | None = None,
) -> Number:
    """Angle of the contact's motion for each force angle, radians, unwrapped and increasing.

    Parameters
    ----------
    scene : Scene
    force_angle : float or array
        phi, radians.
    inertia_share, force_ratio : float or array, optional
        As in `spin_ratio`, which has the same errors and equations.

    Returns
    -------
    float, ndarray or DataArray
        Of the type of the arguments; an array for an array of scenes, a DataArray for a labeled scene.
    """
    columns = force_columns(scene, force_angle, inertia_share, force_ratio)
    return _of_motion(scene, columns, "motion_angle", "angle")


def angle_under_force(scene: Scene, force_angle: float) -> float:
    """Direction in which the contact, and a fence that follows it, moves under a force; both in degrees.

    With friction and inertia, each effect takes an equal share of the force.
    """
    share = 0.5 if is_magnitude_open(scene) else None
    return float(np.rad2deg(motion_angle(scene, in_radians(force_angle), share)))


def _of_motion(scene: Scene, columns: Sequence[Any], name: str, field: str) -> Number:
    """One field of the results of `force_motions`."""

    def decode(results: Array, columns: Sequence[Any], outputs: Sequence[Any]) -> None:
        outputs[0][:] = getattr(Columns(MotionResult, results), field)

    outputs = [Output(name)]
    value: Number = evaluate_kernel(
        "force_motions", scene.rows.data, columns, outputs, MotionResult.size, decode
    )[0]
    return value


def motion_cone(scene: Scene) -> AngleInterval:
    """Motion cone: directions in which the contact can move without slip, radians.

    It is the velocity cone of a scene with friction, the acceleration cone of a scene with inertia, and
    with both effects the exact union over all magnitudes of the motion. The motion angle increases with the
    force angle, so the edges correspond to those of the friction cone. With both effects, an edge at which
    they differ is approached but never reached: the cone is open. The type of the result is that of
    `friction_cone`.
    """
    law = require_point_scene(scene).cone
    length, angle, _ = scene.rows.body
    edges = row_of(ConeRow, length=length, angle=angle, right=law.right, left=law.left)
    columns = [*unit_columns(scene), *edges]
    right, left, reached, status = evaluate_kernel("motion_cones", scene.rows.data, columns, CONE)
    cone: AngleInterval = interval(right, left, law.closed & reached, status)
    return cone


def leaves_the_fence(cone: AngleInterval, pocket: Number = 0.0) -> Any:
    """Whether a motion cone contains motions away from the slider (Sec. 3.1), as `Slider.pocket` says."""
    return (cone.right < -pocket - RESOLUTION) | (cone.left > np.pi + pocket + RESOLUTION)


def can_pull(scene: Scene) -> bool:
    """Whether the contact can stick while the pusher moves away from the slider (Sec. 3.1).

    Returns
    -------
    bool
        An array for an array of scenes, a DataArray for a labeled scene.
    """
    pulls: bool = label_result("pulls", leaves_the_fence(motion_cone(scene), scene.slider.pocket))
    return pulls


def omits_pushes(cone: AngleInterval, pocket: Number = 0.0) -> Any:
    """Whether a motion cone excludes some motions into the slider (Sec. 3.2), as `Slider.pocket` says."""
    return (cone.right > RESOLUTION - pocket) | (cone.left < np.pi + pocket - RESOLUTION)


def slips_while_pushing(scene: Scene) -> bool:
    """Whether some pusher motion into the slider makes the contact slip (Sec. 3.2).

    Returns
    -------
    bool
        An array for an array of scenes, a DataArray for a labeled scene.
    """
    omits = omits_pushes(motion_cone(scene), scene.slider.pocket)
    slips: bool = label_result("slips_while_pushing", scene.law.slips & omits)
    return slips
