"""Derivatives of twists and forces by the parameters of a push, which planners and estimators need."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from enum import IntEnum
from typing import Any, Self

import numpy as np

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.numerics.arrays import is_labelled, same
from planar_pushing.mechanics.parameters import (
    Motions,
    Response,
    at_places,
    from_places,
    responses,
    shared,
)
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.response import FREE, SLIP, STICK
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.status import formatted, name_of
from planar_pushing.terms.errors import InvalidValue

#: A force this near to an edge of the friction cone, relative to its magnitude, and a free motion this near
#: to the pusher's, are where the mode changes: some units in the last place more than `solve` resolves.
EDGE = 2e-12
SEPARATES, SLIPS_RIGHT = int(ContactMode.SEPARATE), int(ContactMode.SLIP_RIGHT)
STICKS = int(ContactMode.STICK)


class Smoothness(IntEnum):
    """How a solution depends on the parameters of its problem.

    `NONE`: there is no solution. `SMOOTH`: all derivatives exist. `PIVOT`: all exist; the slider pivots
    about a support point, so weights and contact friction change the force and not the twist. `OPEN`: it
    sticks and pivots, so the force is any of an interval and its derivatives are NaN; so are those of the
    twist by each change after which the point slides, one way or the other. `CHANGE`: a change of mode,
    where all derivatives are NaN: a sticking force on an edge of the friction cone, an end of a continuum,
    a fence that grazes, a pusher at rest, a support point about to be a pivot or no longer one.
    """

    NONE = 0
    SMOOTH = 1
    PIVOT = 2
    OPEN = 3
    CHANGE = 4

    __str__ = name_of
    __format__ = formatted


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
        """The derivatives of some of the solutions, by an index into their shape S."""
        found = {each.name: np.asarray(getattr(self, each.name))[index] for each in fields(self)}
        if found["status"].ndim == 0:
            found["status"] = Smoothness(found["status"])
        return type(self)(**found)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Derivatives(_Common):
    """Derivatives of solutions of `solve`, in the fence frame; S is their shape, () for one solution.

    Entry ``[..., i, j]`` of a field is the derivative of component i of the twist (v_x, v_y, omega) of the
    slider's center, or of the force (f_x, f_y), by parameter j, with all others fixed.

    Attributes
    ----------
    status : Smoothness, or ndarray of int of shape S
    twist_by_motion : ndarray, shape S + (3, 2)
        By the pusher's motion (u_x, u_y).
    twist_by_point : ndarray, shape S + (3, 2)
        By the position of the contact on the slider, along x and y of the fence. Supports, masses and the
        center whose twist this is stay where they are on the slider.
    twist_by_mu : ndarray, shape S + (3,)
        By the coefficient of contact friction; zero for laws without one.
    twist_by_strength : ndarray, shape S + (3, effects)
        By the strength of each effect of the scene, in the order in which it lists them: weight, mass,
        coefficient; of a load by a factor of its force.
    twist_by_foot : ndarray, shape S + (3, feet)
        By the weight on each support point alone, numbered as `pivot` of a solution numbers them; an array
        of supports has the most that one of them has, and NaN behind the last.
    force_by_motion, force_by_point : ndarray, shape S + (2, 2)
    force_by_mu : ndarray, shape S + (2,)
    force_by_strength : ndarray, shape S + (2, effects)
    force_by_foot : ndarray, shape S + (2, feet)
        The same of the force; where a pivot slips, of the force on the edge of the friction cone.

    Notes
    -----
    By the implicit function theorem from the balance of wrenches, with the Hessian of the total potential.
    Where the center of rotation is exactly on a ring or a segment, this Hessian is infinite like a
    logarithm, and the derivatives are those at the distance of a rounding error.
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
        By the force angle, in radians.
    twist_by_ratio : ndarray, shape S + (3,)
        By `force_ratio`; zero where none is given.
    twist_by_point : ndarray, shape S + (3, 2)
    twist_by_strength : ndarray, shape S + (3, effects)
    twist_by_foot : ndarray, shape S + (3, feet)
    force_by_angle : ndarray, shape S + (2,)
        By the force angle, in radians.
    force_by_ratio : ndarray, shape S + (2,)
    force_by_point : ndarray, shape S + (2, 2)
    force_by_strength : ndarray, shape S + (2, effects)
    force_by_foot : ndarray, shape S + (2, feet)
    """

    twist_by_angle: Array
    twist_by_ratio: Array
    force_by_angle: Array
    force_by_ratio: Array


def require_unlabelled(given: Sequence[Any]) -> None:
    """Refuse derivatives where an argument is a DataArray."""
    if any(map(is_labelled, given)):
        raise InvalidValue(
            "derivatives", True, "False where an argument is a DataArray",
            "give numpy arrays, for instance each argument's values",
        )  # fmt: skip


def solution_derivatives(scene: Scene, given: Sequence[Any], found: dict[str, Any]) -> Derivatives:
    """The derivatives of solutions.

    Parameters
    ----------
    scene : Scene
    given : sequence
        The columns from which `solve_arrays` found them.
    found : dict of arrays
        Its results by name.
    """
    entries, places = scene.from_rest, np.asarray(found["mode"]) >= 0
    own = sum(len(entry.columns) for entry in entries) + 3
    columns = [at_places(places, each) for each in given]
    names = "mode", "twist", "force", "contact_motion", "pivot", "continuum"
    motions, by_mu = _motions(columns[own:], *(found[name][places] for name in names))
    spread = [
        from_places(places, each) for each in (*responses(entries, columns[:own], motions), by_mu)
    ]
    response, by_mu = Response(*spread[:3]), spread[3][..., None]
    return Derivatives(
        **shared(scene, entries, response),
        twist_by_motion=response.twist[..., :2], twist_by_mu=response.twist[..., 4] * by_mu,
        force_by_motion=response.force[..., :2], force_by_mu=response.force[..., 4] * by_mu,
    )  # fmt: skip


def _motions(
    push: Sequence[Any], mode: Any, twist: Array, force: Array, motion: Array, pivot: Any, flat: Any
) -> tuple[Motions, Array]:
    """Solutions under a push, its law first, and the rate of the angle of each one's edge by mu."""
    right, left, _, _, rough, toward, size = push
    is_right, sticks, rests = mode == SLIPS_RIGHT, mode == STICKS, mode == SEPARATES
    # Separate: the pusher grazes the slider, or is at rest. Stick: the force is on an edge.
    apart = np.abs(motion[:, 1] - size * np.sin(toward))
    grazes = apart <= EDGE * np.maximum(size, np.abs(motion).max(axis=1))
    least = np.minimum(_cross(direction(right), force), -_cross(direction(left), force))
    on_edge = (least <= EDGE * np.hypot(force[:, 0], force[:, 1])) & (np.asarray(rough) == 0)
    changes = flat | (rests & grazes) | (sticks & on_edge)
    condition = np.select([rests, sticks], [FREE, STICK], SLIP)
    rate = np.select([rests | sticks, is_right], [0.0, 1.0], -1.0) * np.sin(right) ** 2
    return Motions(twist, force, np.where(is_right, left, right), condition, pivot, changes), rate


def _cross(one: Array, other: Array) -> Array:
    return np.asarray(one[..., 0] * other[..., 1] - one[..., 1] * other[..., 0])
