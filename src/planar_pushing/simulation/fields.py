"""The fields of a log: their places in the rows of the core, and how their arrays follow from the rows."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from enum import IntEnum
from functools import cache
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.core.run import (
    LOG_ANGLE,
    LOG_CONTACT_DISSIPATED,
    LOG_CONTACT_POSITION,
    LOG_DISSIPATED,
    LOG_EVALUATIONS,
    LOG_EVENT,
    LOG_FLUSH,
    LOG_FORCE,
    LOG_GAP,
    LOG_IMPULSE,
    LOG_KINETIC,
    LOG_LOAD_WORK,
    LOG_MODE,
    LOG_PARTED,
    LOG_PIVOT,
    LOG_POSITION,
    LOG_PUSHER,
    LOG_RATIO,
    LOG_SLIP,
    LOG_SOLUTIONS,
    LOG_STOPPED,
    LOG_TIME,
    LOG_TWIST,
    LOG_WORK,
)
from planar_pushing.core.system import (
    GOES_ON,
    INCONSISTENT,
    LAID_DOWN,
    MET_OUTLINE,
    NO_IMPULSE,
    NO_PROGRESS,
    SIDE_ENDED,
    SINGULAR_MOTION,
    TOO_MANY_EVENTS,
    TOO_MUCH_WORK,
)
from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.contact import Outcome
from planar_pushing.simulation.problem import Problem
from planar_pushing.terms import quantities
from planar_pushing.terms.numbers import Array
from planar_pushing.terms.options import Method, Shape
from planar_pushing.terms.quantities import COMPONENT_UNITS, LOG_TWIST_UNITS

Arrays = dict[str, npt.NDArray[Any]]


class Stop(IntEnum):
    """Reasons why a run ended early."""

    NO = GOES_ON
    INCONSISTENT = INCONSISTENT
    SLIDER_CENTER_REACHES_FENCE = LAID_DOWN
    NO_IMPULSE = NO_IMPULSE
    SINGULAR = SINGULAR_MOTION
    EVENTS = TOO_MANY_EVENTS
    PROGRESS = NO_PROGRESS
    PENETRATES = MET_OUTLINE
    END_OF_SIDE = SIDE_ENDED
    EVALUATIONS = TOO_MUCH_WORK


def _is_finger(problem: Problem) -> bool:
    return problem.shape == Shape.FINGER


def _can_lie(problem: Problem) -> bool:
    """Whether a side of the slider can lie on the fence."""
    slider = problem.scene.slider
    return not _is_finger(problem) and (slider.flush or slider.outline is not None)


def _has_position(problem: Problem) -> bool:
    return _is_finger(problem) or _can_lie(problem)


def _has_impacts(problem: Problem) -> bool:
    return problem.scene.stores_energy


def _has_loads(problem: Problem) -> bool:
    return bool(problem.scene.loads)


def _is_placed(problem: Problem) -> bool:
    return problem.world is not None


class Field(NamedTuple):
    """A variable over time.

    Attributes
    ----------
    name : str
        Its unit and its long name are in `terms.quantities`.
    first : int
        First of its numbers in a row of the core, or of those from which it is computed.
    dims : tuple of str
        Dimensions after time.
    dtype : str
    logged : callable
        Whether the log of a problem contains it.
    sampled : bool
        Whether the dataset of a batch contains it, if a log does or if it is `stopped`.
    stepped : bool
        Whether a log of time-stepping contains it: the force of a step includes its impulse.
    """

    name: str
    first: int
    dims: tuple[str, ...] = ()
    dtype: str = "f8"
    logged: Callable[[Problem], bool] = lambda problem: True
    sampled: bool = False
    stepped: bool = True


XY, EFFECT = ("xy",), ("effect",)
FIELDS = (
    Field("time", LOG_TIME, sampled=True),
    Field("position", LOG_POSITION, XY, sampled=True),
    Field("rod_angle", LOG_ANGLE, sampled=True),
    Field("twist", LOG_TWIST, ("twist_component",)),
    Field("pusher", LOG_PUSHER, XY),
    Field("slip", LOG_SLIP, sampled=True),
    Field("gap", LOG_GAP, sampled=True),
    Field("force", LOG_FORCE, XY, sampled=True),
    Field("mode", LOG_MODE, dtype="i1", sampled=True),
    Field("pivot", LOG_PIVOT, dtype="i4", sampled=True),
    Field("event", LOG_EVENT, dtype="i1"),
    Field("outcome", LOG_SOLUTIONS, dtype="i1"),
    Field("solutions", LOG_SOLUTIONS, dtype="i1", sampled=True),
    Field("adhesive", LOG_FORCE, dtype="?"),
    Field("spin_ratio", LOG_RATIO),
    Field("dissipated", LOG_DISSIPATED, EFFECT),
    Field("contact_dissipated", LOG_CONTACT_DISSIPATED),
    Field("work", LOG_WORK),
    Field("kinetic_energy", LOG_KINETIC),
    Field("evaluations", LOG_EVALUATIONS, EFFECT, "i8"),
    Field("stopped", LOG_STOPPED, (), "i1", lambda problem: False, sampled=True),
    Field("contact_position", LOG_CONTACT_POSITION, logged=_has_position, sampled=True),
    Field("flush", LOG_FLUSH, (), "?", _can_lie, sampled=True),
    Field("parted", LOG_PARTED, (), "?", _is_finger, sampled=True),
    Field("impulse", LOG_IMPULSE, XY, logged=_has_impacts, sampled=True, stepped=False),
    Field("load_work", LOG_LOAD_WORK, logged=_has_loads),
    Field("object_position", LOG_POSITION, XY, logged=_is_placed),
    Field("object_angle", LOG_ANGLE, logged=_is_placed),
    Field("pusher_position", LOG_PUSHER, XY, logged=_is_placed),
)  # fmt: skip
#: Numbers of components along dimensions.
COMPONENTS = {"xy": 2, "twist_component": 3}


def logged_fields(problem: Problem, method: str) -> list[Field]:
    """The fields of a log."""
    steps = method == Method.TIME_STEPPING
    return [field for field in FIELDS if field.logged(problem) and (field.stepped or not steps)]


def sampled_fields(problem: Problem) -> list[Field]:
    """The fields of a batch."""
    batch = [field for field in FIELDS if field.sampled]
    return [field for field in batch if field.logged(problem) or field.name == "stopped"]


@cache
def _have_unit(quantity: str, width: int) -> npt.NDArray[np.bool_]:
    """Whether the unit of each number in a row of the core has a quantity: "length" or "force"."""
    answers = np.zeros(width, bool)
    for name, first, dims, *_ in FIELDS:
        unit = quantities.BATCH[name][0]
        size = width - first if dims == EFFECT else COMPONENTS[dims[0]] if dims else 1
        units = LOG_TWIST_UNITS if unit in COMPONENT_UNITS else [unit] * size
        for i in range(size):
            answers[first + i] |= quantity in units[i]
    return answers


def scales_of(radius: Array, force: Array, width: int) -> Array:
    """Factors from the units of the core to those of the scene.

    Parameters
    ----------
    radius, force : ndarray, shape S
        Radii of the sliders, and units of force.
    width : int
        How many numbers a row of the core has.

    Returns
    -------
    ndarray, shape S + (width,)
    """
    lengths = np.where(_have_unit("length", width), radius[..., None], 1.0)
    return lengths * np.where(_have_unit("force", width), force[..., None], 1.0)


def arrays(rows: Array, problem: Problem, fields: Sequence[Field]) -> Arrays:
    """Values of fields by name, from rows in the units of the scene; angles in degrees.

    Parameters
    ----------
    rows : ndarray, shape S + (width,)
    problem : Problem
    fields : sequence of Field

    Returns
    -------
    dict of ndarray, shape S, or S + (components,)
    """
    return {
        field.name: np.array(COMPUTED.get(field.name, _read)(rows, problem, field), field.dtype)
        for field in fields
    }


def _read(rows: Array, problem: Problem, field: Field) -> Array:
    """The values of a field in the rows of the core."""
    if not field.dims:
        return rows[..., field.first]
    return rows[..., field.first : field.first + COMPONENTS[field.dims[0]]]


def _degrees(rows: Array, problem: Problem, field: Field) -> Any:
    return np.rad2deg(rows[..., LOG_ANGLE])


def _outcome(rows: Array, problem: Problem, field: Field) -> Any:
    return np.minimum(rows[..., LOG_SOLUTIONS], Outcome.AMBIGUOUS)


def _adhesive(rows: Array, problem: Problem, field: Field) -> Any:
    """Whether the normal force pulls; the normal of a finger's side rotates with the slider."""
    x, normal = rows[..., LOG_FORCE], rows[..., LOG_FORCE + 1]
    size = np.hypot(x, normal)
    if problem.shape == Shape.FINGER:
        rotation = rows[..., LOG_ANGLE] - problem.scene.slider.rod_angle
        normal = normal * np.cos(rotation) - x * np.sin(rotation)
    return normal < -RESOLUTION * size


def _dissipation(rows: Array, problem: Problem, field: Field) -> Any:
    """Energy dissipated by each effect, zero for those that do not resist."""
    energies = np.zeros((*rows.shape[:-1], len(problem.scene.effects)))
    for i, entry in enumerate(problem.entries):
        energies[..., entry.number] = rows[..., LOG_DISSIPATED + i]
    return energies


def _evaluations(rows: Array, problem: Problem, field: Field) -> Any:
    """Evaluations of the motion, which evaluate each effect."""
    counts = rows[..., LOG_EVALUATIONS, None]
    return np.repeat(counts, len(problem.scene.effects), axis=-1)


def _object_pose(rows: Array, problem: Problem, field: Field) -> Any:
    """Position or angle of the object in the world."""
    position = rows[..., LOG_POSITION : LOG_POSITION + 2]
    assert problem.world is not None
    pose = problem.world.object_pose(position, rows[..., LOG_ANGLE])
    return pose[0] if field.dims else pose[1]


def _pusher_position(rows: Array, problem: Problem, field: Field) -> Any:
    """Position of the pusher in the world; at time 0 a finger's center is one radius below the contact."""
    assert problem.world is not None
    radius: Any = problem.pusher.radius
    return problem.world.fence.point_out(_read(rows, problem, field) - (0.0, radius))


#: Functions of the fields that are computed from the numbers of a row.
COMPUTED: dict[str, Callable[[Array, Problem, Field], Any]] = {
    "rod_angle": _degrees,
    "outcome": _outcome,
    "adhesive": _adhesive,
    "dissipated": _dissipation,
    "evaluations": _evaluations,
    "object_position": _object_pose,
    "object_angle": _object_pose,
    "pusher_position": _pusher_position,
}
