"""Motion of the slider under a force through the contact, for any contact law."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import nan, sqrt
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.compiled import compiled, generic, kernel, owning
from planar_pushing.mechanics.cones import is_magnitude_open, under_force, unit_columns
from planar_pushing.mechanics.contact import Status
from planar_pushing.mechanics.core import Entry
from planar_pushing.mechanics.derivatives import ForceDerivatives, require_unlabeled
from planar_pushing.mechanics.effects.base import KINDS, count_fields, is_steady
from planar_pushing.mechanics.numerics.arrays import (
    Output,
    component_labels,
    dataset,
    evaluated,
    is_labeled,
    same,
)
from planar_pushing.mechanics.parameters import (
    Motions,
    Response,
    at_places,
    from_places,
    responses,
    shared,
)
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.reduced.magnitude import at_force
from planar_pushing.mechanics.reduced.under import pushed, pushed_ends
from planar_pushing.mechanics.response import FIRST, FORCE, LINE
from planar_pushing.mechanics.scene import Scene, required_scene
from planar_pushing.terms.domain import required
from planar_pushing.terms.errors import InvalidValue, require_flag
from planar_pushing.terms.units import named_units

NONE, CONSISTENT, PIVOTS = int(Status.NONE), int(Status.CONSISTENT), int(Status.PIVOTS)
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


@generic
def _under_force(kinds: Any) -> Callable[..., Any]:
    """The motion under a force, and whether it is one of a continuum: effects, contact, e_x, e_y, size."""
    return _of_unit_motion if is_steady(kinds) else _of_size


@compiled
def _of_unit_motion(effects, at, e_x, e_y, size):
    """The motion with a unit component along the line of force."""
    first, _ = pushed_ends(effects, at, e_x, e_y, 1.0)
    if first.continuum:
        return pushed(effects, at, e_x, e_y, 1.0), True
    return first, False


@compiled
def _of_size(effects, at, e_x, e_y, size):
    return at_force(effects, at, e_x, e_y, size), False


@generic
def _factors(kinds: Any) -> Callable[..., Any]:
    """Factors that scale motion and force to a unit motion of the contact: effects, motion."""
    if not is_steady(kinds):
        return _as_they_are
    return _both if all(KINDS[kind].DEGREE == 2 for kind in kinds) else _motion_alone


@compiled
def _as_they_are(effects, moved):
    return 1.0, 1.0


@compiled
def _both(effects, moved):
    factor = 1.0 / sqrt(moved.u_x * moved.u_x + moved.u_y * moved.u_y)
    return factor, factor


@compiled
def _motion_alone(effects, moved):
    return 1.0 / sqrt(moved.u_x * moved.u_x + moved.u_y * moved.u_y), 1.0


@compiled
def _write(own, x, y, factor, target):
    """Write a vector of the body frame, times a factor, in the frame of the contact."""
    target[0], target[1] = factor * (own.x * x - own.y * y), factor * (own.x * y + own.y * x)


@kernel
@owning
def _motions(kinds, rows, status, twists, forces, contacts, pivots):
    """Motions; the columns after those of `under_force` are the units of motion, force and length."""
    units = count_fields(kinds) + 4
    for i in range(len(rows)):
        effects, own, at, force, size = under_force(kinds, rows[i])
        moved, flat = _under_force(effects, at, force.along, -force.aside, size)
        one, other = _factors(effects, moved)
        motion, strength = one * rows[i, units], other * rows[i, units + 1]
        status[i] = CONTINUUM if flat else CONSISTENT if moved.point < 0 else PIVOTS
        _write(own, moved.v_x, moved.v_y, motion, twists[i])
        twists[i, 2] = motion * moved.spin / rows[i, units + 2]
        _write(own, moved.u_x, moved.u_y, motion, contacts[i])
        _write(own, moved.f_x, moved.f_y, strength, forces[i])
        pivots[i] = moved.point
        if not moved.found:
            status[i], pivots[i] = NONE if size > 0.0 else UNSOLVED, -1
            twists[i], forces[i], contacts[i] = nan, nan, nan


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
    ratio = _required_ratio(required_scene(scene), force_ratio)
    angle = required("force_angle", force_angle)
    columns, rod = unit_columns(scene)
    given = [*columns, *rod, angle, np.divide(ratio, 2), *_units(scene), scene.slider.radius]
    if require_flag("derivatives", derivatives):
        require_unlabeled(given)
    results = evaluated(_motions, scene.kinds, given, OUTPUTS)
    if is_labeled(results[0]):
        found = dataset(results).assign_coords(component_labels())
        return named_units(found, scene.units, inertia=scene.stores_energy)
    found = {each.name: result for each, result in zip(OUTPUTS, results, strict=True)}
    by = _derivatives(scene, angle, ratio, found) if derivatives else None
    if np.ndim(found["status"]) == 0:
        found["status"], by = Status(found["status"]), by and by[()]
    return ForceMotion(**found, derivatives=by)


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
    return required("force_ratio", ratio) if is_open else 0.0


def _units(scene: Scene) -> tuple[Any, Any]:
    """Units of motion and force in the columns of `unit_columns` for an inertia share of one half."""
    one, two = _strength(scene, 1), _strength(scene, 2)
    if is_magnitude_open(scene):
        return one / two, 2.0 * one
    return 1.0, one + two


def _strength(scene: Scene, degree: int) -> Any:
    """Sum of the strengths of the effects of a degree, without loads."""
    own = [each for each in scene.from_rest if each.degree == degree and len(each.forces) == 1]
    return sum(each.forces[0] for each in own)


def _derivatives(scene: Scene, angle: Any, ratio: Any, found: dict[str, Any]) -> ForceDerivatives:
    entries, slider = scene.from_rest, scene.slider
    status = np.asarray(found["status"])[..., None]
    places = (status != NONE) & (status != UNSOLVED)
    twist, force = (np.asarray(found[name])[..., None, :][places] for name in ("twist", "force"))
    body = slider.rod_length, slider.rod_angle, slider.radius
    columns = [at_places(places, each) for each in (*scene.numbers, *body)]
    motions = Motions(
        twist, force, at_places(places, angle), np.full(len(twist), FORCE if np.any(ratio) else LINE),
        np.asarray(found["pivot"])[..., None][places], status[places] == CONTINUUM,
    )  # fmt: skip
    by = [from_places(places, each) for each in responses(entries, columns, motions)]
    response = Response(*(np.take(each, 0, places.ndim - 1) for each in by))
    _hold_ratio(entries, response, np.asarray(ratio, dtype=float))
    weight = np.asarray(_strength(scene, 1), dtype=float)[..., None]
    return ForceDerivatives(
        **shared(scene, entries, response),
        twist_by_angle=response.twist[..., 4], twist_by_ratio=weight * response.twist[..., 0],
        force_by_angle=response.force[..., 4], force_by_ratio=weight * response.force[..., 0],
    )  # fmt: skip


def _hold_ratio(entries: Sequence[Entry], response: Response, ratio: Array) -> None:
    """Add the change of the force with the weight, at a fixed ratio of the two."""
    feet = FIRST + len(entries)
    friction = [i for i, each in enumerate(entries) if each.degree == 1 and len(each.forces) == 1]
    for by in (response.twist, response.force):
        more = ratio[..., None] * by[..., 0]
        for i in (*(FIRST + i for i in friction), *range(feet, by.shape[-1])):
            by[..., i] += more
