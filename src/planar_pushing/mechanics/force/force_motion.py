"""Motion of the slider under a force through the contact, for any contact law."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.core.instant.kernels import MotionResult
from planar_pushing.core.instant.magnitude import FORCE_SIZE, UNIT_MOTION
from planar_pushing.core.instant.sensitivity import FIRST, FORCE_CASE, LINE_CASE
from planar_pushing.mechanics.contact import Status
from planar_pushing.mechanics.force.cones import is_magnitude_open, row_of_force, unit_columns
from planar_pushing.mechanics.force.derivatives import ForceDerivatives, require_unlabeled
from planar_pushing.mechanics.force.parameters import (
    Motions,
    Response,
    at_places,
    common_fields,
    from_places,
    responses,
)
from planar_pushing.mechanics.kernels.arrays import (
    Output,
    component_labels,
    dataset,
    evaluate_kernel,
    is_labeled,
    same,
)
from planar_pushing.mechanics.kernels.columns import Columns
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.rows import EffectColumns
from planar_pushing.mechanics.scene import Scene, require_point_scene
from planar_pushing.terms.domain import require_in_range
from planar_pushing.terms.errors import InvalidValue, require_flag
from planar_pushing.terms.units import named_units

NONE = int(Status.NONE)
CONTINUUM, UNSOLVED = int(Status.CONTINUUM), int(Status.UNSOLVED)
OUTPUTS = (
    Output("status", (), "i1"), Output("twist", (("twist_component", 3),)), Output("force", (("xy", 2),)),
    Output("contact_motion", (("xy", 2),)), Output("pivot", (), "i4"),
)  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class ForceMotion:
    """Motions of the slider under forces of shape S through the contact, in the fence frame.

    Attributes
    ----------
    status : Status, or ndarray of int of shape S
        `NONE`: friction holds the slider under this force, and the motion is NaN. `CONTINUUM`: the motion
        is one of a continuum.
    twist : ndarray, shape S + (3,)
        (v_x, v_y, omega) at the slider's center, omega in radians per unit of time.
    force : ndarray, shape S + (2,)
        Force of the pusher on the slider.
    contact_motion : ndarray, shape S + (2,)
        Velocity or initial acceleration of the slider at the contact.
    pivot : int or ndarray of int, shape S
        Number of the support point about which the slider pivots, -1 without one.
    derivatives : ForceDerivatives, optional
        Derivatives of twist and force, if requested.
    """

    status: Any
    twist: Array
    force: Array
    contact_motion: Array
    pivot: Any
    derivatives: ForceDerivatives | None = None

    def __eq__(self, other: object) -> Any:
        return same(self, other)


def _decode(results: Array, columns: Sequence[Any], outputs: Sequence[Any]) -> None:
    """Write the outputs of a block of results of `force_motions`; the last columns of a row are units.

    With potentials of one degree the contact moves at unit speed.
    """
    motion, force, radius, degree = (np.asarray(column)[..., None] for column in columns[-4:])
    motions = Columns(MotionResult, results)
    u = motions.motion
    speed = np.sqrt(u[:, :1] * u[:, :1] + u[:, 1:] * u[:, 1:])
    factor = np.where(degree > 0.0, 1.0 / np.where(speed > 0.0, speed, np.nan), 1.0)
    motion, force = factor * motion, np.where(degree == 2.0, factor, 1.0) * force
    status, twist, forces, contact_motion, pivot = outputs
    status[:] = motions.status
    twist[:], forces[:] = motion * motions.twist, force * motions.force
    twist[:, 2:] /= radius
    contact_motion[:] = motion * u
    pivot[:] = np.where(np.isnan(motions.pivot), -1.0, motions.pivot)


def motion_of_force(
    scene: Scene,
    force_angle: npt.ArrayLike,
    force_ratio: npt.ArrayLike | None = None,
    *,
    derivatives: bool = False,
) -> Any:
    """Motion of the slider under a force through the contact, even one that the contact cannot transmit.

    Parameters
    ----------
    scene : Scene
        Its parameters can be arrays.
    force_angle : float or array
        phi, radians.
    force_ratio : float or array, optional
        |f| / W > 0, for scenes with both friction and inertia only. In other scenes a line of force leaves
        the magnitude of the motion undetermined: the contact moves at unit speed (or acceleration) in the
        direction of `motion_angle`, and the force is the one that sustains this motion.
    derivatives : bool
        Whether to compute `ForceDerivatives`: derivatives of twist and force with respect to the arguments,
        the contact point, and the strengths of the effects.

    Returns
    -------
    ForceMotion, or xarray.Dataset
        A dataset if an argument is a DataArray.

    Raises
    ------
    InvalidValue
        If `force_ratio` is missing, superfluous or not positive, an angle is beyond 4 pi, or derivatives
        are requested with a DataArray.

    Notes
    -----
    Solves ``grad Psi(u) = f`` for the motion u of the contact (Eqs. 7 and 10 for the ring).
    """
    ratio = _required_ratio(require_point_scene(scene), force_ratio)
    angle = require_in_range("force_angle", force_angle)
    norm = FORCE_SIZE if is_magnitude_open(scene) else UNIT_MOTION
    # With shares of one half, the weight is half the unit of force.
    columns = [*unit_columns(scene), *row_of_force(scene, angle, norm, np.divide(ratio, 2))]
    columns += [*_units(scene), scene.slider.radius, _degree(scene)]
    if require_flag("derivatives", derivatives):
        require_unlabeled(columns)
    rows = scene.rows
    results = evaluate_kernel(
        "force_motions", rows.data, columns, OUTPUTS, MotionResult.size, _decode
    )
    if is_labeled(results[0]):
        motions = dataset(results).assign_coords(component_labels())
        return named_units(motions, scene.units, inertia=scene.stores_energy)
    fields = {output.name: result for output, result in zip(OUTPUTS, results, strict=True)}
    by = _derivatives(scene, angle, ratio, fields) if derivatives else None
    if np.ndim(fields["status"]) == 0:
        fields["status"], by = Status(fields["status"]), by and by[()]
    return ForceMotion(**fields, derivatives=by)


def _required_ratio(scene: Scene, ratio: Any) -> Any:
    """|f| / W, or 0 if the direction of the motion does not depend on it."""
    is_open = is_magnitude_open(scene)
    if not is_open and ratio is not None:
        raise InvalidValue(
            "force_ratio", ratio, "None for a scene whose effects are of one kind", "leave it out"
        )
    if is_open and ratio is None:
        raise InvalidValue(
            "force_ratio",
            None,
            "a number > 0 for a scene with friction and inertia",
            "give |f| / W",
        )
    return require_in_range("force_ratio", ratio) if is_open else 0.0


def _units(scene: Scene) -> tuple[Any, Any]:
    """Units of motion and force in the columns of `unit_columns` for an inertia share of one half."""
    one, two = scene.rows.strength(1), scene.rows.strength(2)
    if is_magnitude_open(scene):
        return one / two, 2.0 * one
    return 1.0, one + two


def _degree(scene: Scene) -> float:
    """Degree of all potentials, 0 if they have several."""
    return 0.0 if is_magnitude_open(scene) else float(scene.rows.entries[0].degree)


def _derivatives(scene: Scene, angle: Any, ratio: Any, fields: dict[str, Any]) -> ForceDerivatives:
    rows = scene.rows
    status = np.asarray(fields["status"])[..., None]
    places = (status != NONE) & (status != UNSOLVED)
    twist, force = (np.asarray(fields[name])[..., None, :][places] for name in ("twist", "force"))
    columns = [at_places(places, column) for column in (*rows.columns, *rows.body)]
    condition = np.full(len(twist), FORCE_CASE if np.any(ratio) else LINE_CASE)
    motions = Motions(
        twist, force, at_places(places, angle), condition,
        np.asarray(fields["pivot"])[..., None][places], status[places] == CONTINUUM,
    )  # fmt: skip
    by = [from_places(places, array) for array in responses(rows, columns, motions)]
    response = Response(*(np.take(array, 0, places.ndim - 1) for array in by))
    _hold_ratio(rows.entries, response, np.asarray(ratio, dtype=float))
    weight = np.asarray(rows.strength(1), dtype=float)[..., None]
    return ForceDerivatives(
        **common_fields(scene, response),
        twist_by_angle=response.twist[..., 4], twist_by_ratio=weight * response.twist[..., 0],
        force_by_angle=response.force[..., 4], force_by_ratio=weight * response.force[..., 0],
    )  # fmt: skip


def _hold_ratio(entries: Sequence[EffectColumns], response: Response, ratio: Array) -> None:
    """Add the change of the force with the weight, at a fixed ratio of the two."""
    feet = FIRST + len(entries)
    friction = [i for i, entry in enumerate(entries) if entry.degree == 1 and entry.resists]
    for by in (response.twist, response.force):
        more = ratio[..., None] * by[..., 0]
        for i in (*(FIRST + i for i in friction), *range(feet, by.shape[-1])):
            by[..., i] += more
