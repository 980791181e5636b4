"""Derivatives of twists and forces with respect to the parameters of a push."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from enum import IntEnum
from typing import Any, Self

import numpy as np

from planar_pushing.core.instant.sensitivity import FREE_CASE, SLIP_CASE, STICK_CASE
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.force.parameters import (
    Motions,
    Response,
    at_places,
    common_fields,
    from_places,
    responses,
)
from planar_pushing.mechanics.kernels.arrays import is_labeled, same
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.options import format_member, name_of

#: Results of a side that say where it touches the fence.
ON_SIDE = "flush", "force_position", "end_forces"
#: The mode changes if a force is this close to an edge of the friction cone, relative to its magnitude, or
#: a free motion this close to the pusher's: a little more than `solve` resolves.
EDGE = 2e-12
SEPARATES, SLIPS_RIGHT = int(ContactMode.SEPARATE), int(ContactMode.SLIP_RIGHT)
STICKS = int(ContactMode.STICK)


class Smoothness(IntEnum):
    """Smoothness of a solution as a function of the parameters of its problem.

    `NONE`: there is no solution. `SMOOTH`: all derivatives exist. `PIVOT`: all exist; the slider pivots
    about a support point, so weights and contact friction change the force but not the twist. `OPEN`: it
    sticks and pivots, so the force is undetermined within an interval and its derivatives are NaN, as are
    those of the twist with respect to parameters whose change makes the point slide. `CHANGE`: the mode
    changes, and all derivatives are NaN: a sticking force on an edge of the friction cone, an end of a
    continuum, a grazing fence, a pusher at rest, a support point about to start or stop being a pivot, or a
    side on the fence without a force at one end.
    """

    NONE = 0
    SMOOTH = 1
    PIVOT = 2
    OPEN = 3
    CHANGE = 4

    __str__ = name_of
    __format__ = format_member


@dataclass(frozen=True, slots=True, kw_only=True)
class _Common:
    """Fields of the derivatives of every problem."""

    status: Any
    twist_by_point: Array
    twist_by_strength: Array
    twist_by_foot: Array
    force_by_point: Array
    force_by_strength: Array
    force_by_foot: Array

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def __getitem__(self, index: Any) -> Self:
        """The derivatives of selected solutions, by an index into their shape S."""
        values = {
            field.name: np.asarray(getattr(self, field.name))[index] for field in fields(self)
        }
        if values["status"].ndim == 0:
            values["status"] = Smoothness(values["status"])
        return type(self)(**values)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Derivatives(_Common):
    """Derivatives of solutions of `solve`, in the fence frame; S is their shape, () for one solution.

    Entry ``[..., i, j]`` of a field is the derivative of component i of the twist (v_x, v_y, omega) of the
    slider's center, or of the force (f_x, f_y), with respect to parameter j, with all others fixed.

    Attributes
    ----------
    status : Smoothness, or ndarray of int of shape S
    twist_by_motion : ndarray, shape S + (3, 2)
        With respect to the pusher's motion (u_x, u_y).
    twist_by_point : ndarray, shape S + (3, 2)
        With respect to the position of the contact on the slider, along x and y of the fence. Supports,
        masses and the reference center of the twist stay fixed on the slider. Zero for a side that stays on
        the fence.
    twist_by_mu : ndarray, shape S + (3,)
        With respect to the coefficient of contact friction; zero for laws without one.
    twist_by_strength : ndarray, shape S + (3, effects)
        With respect to the strength of each effect, in the order of the scene: weight, mass, coefficient;
        for a load, a factor of its force.
    twist_by_foot : ndarray, shape S + (3, feet)
        With respect to the weight on each support point alone, numbered as in `Solution.pivot`. For an
        array of supports, the length is the maximum number of points, and values after the last are NaN.
    force_by_motion, force_by_point : ndarray, shape S + (2, 2)
    force_by_mu : ndarray, shape S + (2,)
    force_by_strength : ndarray, shape S + (2, effects)
    force_by_foot : ndarray, shape S + (2, feet)
        The same for the force; if a pivot slips, for the force on the edge of the friction cone.

    Notes
    -----
    The derivatives follow from the balance of wrenches by the implicit function theorem, with the Hessian
    of the total potential. At a center of rotation exactly on a ring or a segment, this Hessian has a
    logarithmic singularity; the derivatives are then those at the distance of a rounding error.
    """

    twist_by_motion: Array
    twist_by_mu: Array
    force_by_motion: Array
    force_by_mu: Array


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class ForceDerivatives(_Common):
    """Derivatives of `motion_of_force`, as in `Derivatives`; S is the shape of its arguments.

    Attributes
    ----------
    status : Smoothness, or ndarray of int of shape S
    twist_by_angle : ndarray, shape S + (3,)
        With respect to the force angle, in radians.
    twist_by_ratio : ndarray, shape S + (3,)
        With respect to `force_ratio`; zero if none is given.
    twist_by_point : ndarray, shape S + (3, 2)
    twist_by_strength : ndarray, shape S + (3, effects)
    twist_by_foot : ndarray, shape S + (3, feet)
    force_by_angle : ndarray, shape S + (2,)
        With respect to the force angle, in radians.
    force_by_ratio : ndarray, shape S + (2,)
    force_by_point : ndarray, shape S + (2, 2)
    force_by_strength : ndarray, shape S + (2, effects)
    force_by_foot : ndarray, shape S + (2, feet)
    """

    twist_by_angle: Array
    twist_by_ratio: Array
    force_by_angle: Array
    force_by_ratio: Array


def require_unlabeled(arguments: Sequence[Any]) -> None:
    """Refuse derivatives if an argument is a DataArray."""
    if any(map(is_labeled, arguments)):
        raise InvalidValue(
            "derivatives", True, "False if an argument is a DataArray",
            "give numpy arrays, for instance each argument's values",
        )  # fmt: skip


def solution_derivatives(
    scene: Scene, inputs: Sequence[Any], solutions: dict[str, Any]
) -> Derivatives:
    """The derivatives of solutions.

    Parameters
    ----------
    scene : Scene
    inputs : sequence
        Columns passed to `solve_arrays`.
    solutions : dict of arrays
        Results of `solve_arrays` by name.
    """
    rows, places = scene.rows, np.asarray(solutions["mode"]) >= 0
    count = len(rows.columns) + 3
    columns = [at_places(places, column) for column in inputs]
    names = "mode", "twist", "force", "contact_motion", "pivot", "continuum"
    push = columns[count + len(rows.ends) :]
    motions, by_mu = _motions(push, *(solutions[name][places] for name in names))
    if rows.ends:
        motions = _on_side(motions, *(solutions[name][places] for name in ON_SIDE))
    spread = [
        from_places(places, array) for array in (*responses(rows, columns[:count], motions), by_mu)
    ]
    response, by_mu = Response(*spread[:3]), spread[3][..., None]
    return Derivatives(
        **common_fields(scene, response),
        twist_by_motion=response.twist[..., :2], twist_by_mu=response.twist[..., 4] * by_mu,
        force_by_motion=response.force[..., :2], force_by_mu=response.force[..., 4] * by_mu,
    )  # fmt: skip


def _motions(
    push: Sequence[Any], mode: Any, twist: Array, force: Array, motion: Array, pivot: Any, flat: Any
) -> tuple[Motions, Array]:
    """Solutions under a push, and the derivative of the angle of each one's edge with respect to mu."""
    right, left, _, _, rough, _, toward, size = push
    is_right, sticks, rests = mode == SLIPS_RIGHT, mode == STICKS, mode == SEPARATES
    # The mode changes if a separating pusher grazes the slider or is at rest, or a sticking force is on an
    # edge.
    normal_speed = np.abs(motion[:, 1] - size * np.sin(toward))
    grazes = normal_speed <= EDGE * np.maximum(size, np.abs(motion).max(axis=1))
    across_edge = np.minimum(_cross(direction(right), force), -_cross(direction(left), force))
    on_edge = (across_edge <= EDGE * np.hypot(force[:, 0], force[:, 1])) & (np.asarray(rough) == 0)
    changes = flat | (rests & grazes) | (sticks & on_edge)
    condition = np.where(rests, FREE_CASE, np.where(sticks, STICK_CASE, SLIP_CASE))
    sense = np.where(is_right, 1.0, np.where(rests | sticks, 0.0, -1.0))
    rate = sense * np.sin(right) ** 2
    return Motions(twist, force, np.where(is_right, left, right), condition, pivot, changes), rate


def _on_side(motions: Motions, flush: Any, position: Array, forces: Array) -> Motions:
    """Motions of a side that stays on the fence, or that turns about the end at a position.

    The mode changes if no force acts at an end that is on the fence.
    """
    rests = motions.condition == FREE_CASE
    tilts = (forces[..., 1] == 0.0).all(axis=2).any(axis=1)
    return motions._replace(
        changes=motions.changes | (flush & ~rests & tilts), held=flush & ~rests,
        place=np.where(flush | rests, 0.0, position),
    )  # fmt: skip


def _cross(one: Array, other: Array) -> Array:
    return np.asarray(one[..., 0] * other[..., 1] - one[..., 1] * other[..., 0])
