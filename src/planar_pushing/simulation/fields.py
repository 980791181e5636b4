"""The fields of a log: their places in the rows of the core, and how their arrays follow from the rows."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from enum import IntEnum
from functools import cache
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.core.motion.kinematics.run import LOG_ROW, LogRow
from planar_pushing.core.motion.kinematics.system import (
    GOES_ON,
    INCONSISTENT,
    LAID_DOWN,
    NO_IMPULSE,
    NO_PROGRESS,
    SINGULAR_MOTION,
    TOO_MANY_EVENTS,
    TOO_MUCH_WORK,
    TWO_CONTACTS,
)
from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.contact import Outcome
from planar_pushing.mechanics.kernels.columns import Columns
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.world import World
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
    TWO_CONTACTS = TWO_CONTACTS
    EVALUATIONS = TOO_MUCH_WORK
    JAMMED = 9
    WEDGED = 10
    MANY_CONTACTS = 11


def _is_finger(problem: Problem) -> bool:
    return problem.shape == Shape.FINGER


def _can_lie(problem: Problem) -> bool:
    """Whether a side of the slider can lie on the fence."""
    slider = problem.scene.slider
    return not _is_finger(problem) and (slider.flush or slider.outline is not None)


def _has_position(problem: Problem) -> bool:
    return _is_finger(problem) or _can_lie(problem)


def _has_outline(problem: Problem) -> bool:
    return problem.scene.slider.outline is not None


def _has_normal(problem: Problem) -> bool:
    return _has_outline(problem) and _is_placed(problem)


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
    source : str
        Field of a row of the core that holds it, or from which it is computed; "" for the energies
        dissipated by each effect, which are last.
    dims : tuple of str
        Dimensions after time.
    dtype : str
    logged : callable
        Whether the log of a problem contains it.
    sampled : bool
        Whether the dataset of a batch contains it, if a log does.
    stepped : bool
        Whether a log of time-stepping contains it: the force of a step includes its impulse.
    """

    name: str
    source: str
    dims: tuple[str, ...] = ()
    dtype: str = "f8"
    logged: Callable[[Problem], bool] = lambda problem: True
    sampled: bool = False
    stepped: bool = True


XY, EFFECT = ("xy",), ("effect",)
FIELDS = (
    Field("time", "time", sampled=True),
    Field("position", "position", XY, sampled=True),
    Field("rod_angle", "angle", sampled=True),
    Field("twist", "twist", ("twist_component",)),
    Field("pusher", "pusher", XY),
    Field("slip", "slip", sampled=True),
    Field("gap", "gap", sampled=True),
    Field("force", "force", XY, sampled=True),
    Field("mode", "mode", dtype="i1", sampled=True),
    Field("pivot", "pivot", dtype="i4", sampled=True),
    Field("event", "event", dtype="i1"),
    Field("outcome", "solutions", dtype="i1"),
    Field("solutions", "solutions", dtype="i1", sampled=True),
    Field("adhesive", "force", dtype="?"),
    Field("spin_ratio", "ratio"),
    Field("dissipated", "", EFFECT),
    Field("contact_dissipated", "contact_dissipated"),
    Field("work", "work"),
    Field("kinetic_energy", "kinetic"),
    Field("evaluations", "evaluations", EFFECT, "i8"),
    Field("contact_position", "contact_position", logged=_has_position, sampled=True),
    Field("contact_normal", "contact_normal", logged=_has_normal, sampled=True),
    Field("contact_piece", "contact_piece", (), "i4", _has_outline, sampled=True),
    Field("flush", "flush", (), "?", _can_lie, sampled=True),
    Field("parted", "parted", (), "?", _is_finger, sampled=True),
    Field("impulse", "impulse", XY, logged=_has_impacts, sampled=True, stepped=False),
    Field("load_work", "load_work", logged=_has_loads),
    Field("object_position", "position", XY, logged=_is_placed, sampled=True),
    Field("object_angle", "angle", logged=_is_placed, sampled=True),
    Field("pusher_position", "pusher", XY, logged=_is_placed, sampled=True),
)  # fmt: skip
#: Numbers of components along dimensions.
COMPONENTS = {"xy": 2, "twist_component": 3}


def logged_fields(problem: Problem, method: str) -> list[Field]:
    """The fields of a log."""
    steps = method == Method.TIME_STEPPING
    return [field for field in FIELDS if field.logged(problem) and (field.stepped or not steps)]


def sampled_fields(problem: Problem) -> list[Field]:
    """The fields of a batch."""
    return [field for field in FIELDS if field.sampled and field.logged(problem)]


def _first(source: str) -> int:
    """First number of a source in a row of the core."""
    place = LogRow.places.get(source, LOG_ROW)
    return int(place.start if isinstance(place, slice) else place)


@cache
def _have_unit(quantity: str, width: int) -> npt.NDArray[np.bool_]:
    """Whether the unit of each number in a row of the core has a quantity: "length" or "force"."""
    answers = np.zeros(width, bool)
    for name, source, dims, *_ in FIELDS:
        unit, first = quantities.BATCH[name][0], _first(source)
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


def arrays(
    rows: Array, problem: Problem, fields: Sequence[Field], world: World | None = None
) -> Arrays:
    """Values of fields by name, from rows in the units of the scene; angles in degrees.

    Parameters
    ----------
    rows : ndarray, shape S + (width,)
    problem : Problem
    fields : sequence of Field
    world : World, optional
        Its arrays broadcast against shape S; by default that of the problem.

    Returns
    -------
    dict of ndarray, shape S, or S + (components,)
    """
    world = problem.world if world is None else world

    def values(field: Field) -> Any:
        if world is not None and field.name in PLACED:
            return PLACED[field.name](world, rows)
        return COMPUTED.get(field.name, _read)(rows, problem, field)

    return {field.name: np.array(values(field), field.dtype) for field in fields}


def _read(rows: Array, problem: Problem, field: Field) -> Array:
    """The values of a field in the rows of the core."""
    return rows[..., LogRow.places[field.source]]


def _degrees(rows: Array, problem: Problem, field: Field) -> Any:
    return np.rad2deg(Columns(LogRow, rows).angle)


def _outcome(rows: Array, problem: Problem, field: Field) -> Any:
    return np.minimum(Columns(LogRow, rows).solutions, Outcome.AMBIGUOUS)


def _adhesive(rows: Array, problem: Problem, field: Field) -> Any:
    """Whether the normal force pulls; the normal at a finger rotates with the contact frame.

    Under a law that only pushes, the total force of a disc in a narrow notch can point out of the object,
    though neither side pulls.
    """
    law = problem.scene.law
    if not np.any(law.rough | (np.sin(law.right) < 0) | (np.sin(law.left) < 0)):
        return np.zeros(rows.shape[:-1], bool)
    x, normal = np.moveaxis(Columns(LogRow, rows).force, -1, 0)
    size = np.hypot(x, normal)
    if problem.shape == Shape.FINGER:
        rotation = Columns(LogRow, rows).contact_normal
        normal = normal * np.cos(rotation) - x * np.sin(rotation)
    return normal < -RESOLUTION * size


def _dissipation(rows: Array, problem: Problem, field: Field) -> Any:
    """Energy dissipated by each effect, zero for those that do not resist."""
    energies = np.zeros((*rows.shape[:-1], len(problem.scene.effects)))
    for i, entry in enumerate(problem.entries):
        energies[..., entry.number] = rows[..., LOG_ROW + i]
    return energies


def _evaluations(rows: Array, problem: Problem, field: Field) -> Any:
    """Evaluations of the motion, which evaluate each effect."""
    counts = Columns(LogRow, rows).evaluations[..., None]
    return np.repeat(counts, len(problem.scene.effects), axis=-1)


def _object_pose(world: World, rows: Array) -> tuple[Array, Array]:
    """Positions and angles of the objects in the world."""
    columns = Columns(LogRow, rows)
    return world.object_pose(columns.position, columns.angle)


#: Functions of the fields that are computed from the numbers of a row.
COMPUTED: dict[str, Callable[[Array, Problem, Field], Any]] = {
    "rod_angle": _degrees,
    "outcome": _outcome,
    "adhesive": _adhesive,
    "dissipated": _dissipation,
    "evaluations": _evaluations,
}
#: Functions of the fields that are computed from the world and the numbers of a row.
PLACED: dict[str, Callable[[World, Array], Any]] = {
    "contact_normal": lambda world, rows: world.contact_normal(
        Columns(LogRow, rows).contact_normal
    ),
    "object_position": lambda world, rows: _object_pose(world, rows)[0],
    "object_angle": lambda world, rows: _object_pose(world, rows)[1],
    "pusher_position": lambda world, rows: world.pusher_position(Columns(LogRow, rows).pusher),
}
