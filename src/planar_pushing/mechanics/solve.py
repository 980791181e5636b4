"""Every consistent solution of a pushing problem, and the outcome (Secs. 2-5)."""

from __future__ import annotations

from functools import cache
from math import hypot, inf, nan
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.compiled import compiled, kernel, owning
from planar_pushing.mechanics.contact import ContactMode, Outcome
from planar_pushing.mechanics.contact.laws import Law
from planar_pushing.mechanics.effects.any_mass import MassAt
from planar_pushing.mechanics.effects.base import COLUMNS, made
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.modes import MOST, contact_modes
from planar_pushing.mechanics.numerics.arrays import (
    Output,
    dataset,
    elementwise,
    is_labelled,
    mapped,
    named,
)
from planar_pushing.mechanics.plane import Array, contact_motion, rod, toward
from planar_pushing.mechanics.reduced.base import MOTION, center_of
from planar_pushing.mechanics.scene import Scene, required_scene
from planar_pushing.mechanics.solutions import Solution, SolutionArrays, Solutions
from planar_pushing.terms.domain import Number, required, required_ratio
from planar_pushing.terms.errors import InvalidValue

#: Columns of a row behind those of the effects.
LENGTH, ANGLE, RIGHT, LEFT, SLIPS, CLOSED, ROUGH, TOWARDS, SIZE, FORCE, RADIUS = range(
    COLUMNS, COLUMNS + 11
)
#: Solutions that fit along the axis `solution`, of scenes with one effect and with friction and inertia.
SOLUTIONS = {1: 4, 2: 8}
NO_MODE, NO_PIVOT = -1, -1
XY = ("xy", 2)


@cache
def outputs(count: int) -> tuple[Output, ...]:
    """What is found of each scene with this number of effects."""
    many = ("solution", SOLUTIONS[count])
    return (
        Output("solutions", (), "i1"),
        Output("mode", (many,), "i1"),
        Output("force", (many, XY)),
        Output("force_end", (many, XY)),
        Output("twist", (many, ("twist_component", 3))),
        Output("contact_motion", (many, XY)),
        Output("spin_ratio", (many,)),
        Output("center", (many, XY)),
        Output("pivot", (many,), "i4"),
    )


@compiled
def spin_ratio(speed, spin):
    """R omega / v, 0 at rest."""
    if spin == 0.0:
        return 0.0
    return spin / speed if speed > 0.0 else inf if spin > 0.0 else -inf


@compiled
def _write(effects, own, motion, row, force, end, twist, contact, center):
    """Write down one solution in the units of the scene; its spin ratio."""
    v_x, v_y, spin, f_x, f_y, g_x, g_y, _ = motion
    size, radius = row[SIZE], row[RADIUS]
    u_x, u_y = contact_motion(own, v_x, v_y, spin)
    force[0], force[1] = row[FORCE] * f_x, row[FORCE] * f_y
    end[0], end[1] = row[FORCE] * g_x, row[FORCE] * g_y
    twist[0], twist[1], twist[2] = size * v_x, size * v_y, size * spin / radius
    contact[0], contact[1] = size * u_x, size * u_y
    x, y = center_of(effects, own, motion)
    center[0], center[1] = radius * x, radius * y
    return spin_ratio(hypot(v_x, v_y), spin)


@kernel
@owning
def _modes(kinds, rows, counts, modes, forces, ends, twists, contacts, ratios, centers, pivots):
    every, motions = np.empty(MOST, np.int8), np.empty((MOST, MOTION))
    for i in range(len(rows)):
        row = rows[i]
        effects, own = made(kinds, row), rod(row[LENGTH], row[ANGLE])
        law = Law(row[RIGHT], row[LEFT], row[SLIPS] != 0.0, row[CLOSED] != 0.0, row[ROUGH] != 0.0)
        pusher, moves = toward(own, row[TOWARDS]), row[SIZE] > 0.0
        count = contact_modes(effects, own, law, pusher, moves, every, motions)
        counts[i], modes[i], pivots[i] = count, NO_MODE, NO_PIVOT
        forces[i], ends[i], twists[i], contacts[i] = nan, nan, nan, nan
        ratios[i], centers[i] = nan, nan
        for j in range(min(count, modes.shape[1])):
            modes[i, j], pivots[i, j] = every[j], int(motions[j, 7])
            ratios[i, j] = _write(
                effects, own, motions[j], row,
                forces[i, j], ends[i, j], twists[i, j], contacts[i, j], centers[i, j],
            )  # fmt: skip


def _forces(
    kinds: Any, weight: npt.ArrayLike, mass: npt.ArrayLike, size: npt.ArrayLike
) -> tuple[Any, Any, Any]:
    """Unit of force, and the forces of friction and of inertia in a translation, in that unit.

    A pusher at rest takes no force, in any unit.
    """
    pull = np.where(np.asarray(size) > 0, np.multiply(size, mass), weight)
    if len(kinds) == 2:
        required_ratio("force_ratio", pull / np.asarray(weight))
        unit = np.maximum(weight, pull)
        return unit, weight / unit, pull / unit
    return (pull if isinstance(kinds[0], (Mass, MassAt)) else weight), 1.0, 1.0


def solve_arrays(kinds: Any, *given: npt.ArrayLike) -> list[npt.NDArray[Any]]:
    """Every consistent solution of arrays of scenes, which are broadcast.

    Parameters
    ----------
    kinds : tuple
        Of effects, as `Scene.kinds`.
    *given : array_like
        Weight, mass and square of the radius of gyration in radii; the entries of `Scene.placement`; length
        and angle of the rod, radius; the five entries of `Law`; angle and magnitude of the pusher's motion.

    Returns
    -------
    list of ndarray
        As `outputs`; places without a solution hold NaN.
    """
    weight, mass, gyration, *placed = given[:COLUMNS]
    length, angle, radius, *law, towards, size = given[COLUMNS:]
    required("pusher_angle", towards)
    required("pusher_magnitude", size)
    unit, slow, fast = _forces(kinds, weight, mass, size)
    ratio = required_ratio("length_ratio", np.divide(length, radius))
    columns = [slow, fast, gyration, *placed, ratio, angle, *law, towards, size, unit, radius]
    found = mapped(_modes, kinds, columns, outputs(len(kinds)))
    most = SOLUTIONS[len(kinds)]
    if found[0].size and found[0].max() > most:
        raise InvalidValue(
            "pusher_magnitude", size, f"a push with at most {most} solutions",
            "report the scene: none with more is known",
        )  # fmt: skip
    return found


def solve(scene: Scene, pusher_angle: Number, pusher_magnitude: Number = 1.0) -> Any:
    """Every solution of the pushing problem from rest that is consistent (Sec. 2).

    Parameters
    ----------
    scene : Scene
        Its parameters may be arrays.
    pusher_angle : float or array
        Angle of the pusher's velocity or initial acceleration, radians.
    pusher_magnitude : float or array
        Its magnitude, >= 0. It matters to the modes only where the scene has friction and inertia.

    Returns
    -------
    Solutions, SolutionArrays or xarray.Dataset
        For numbers, for arrays, and where an argument is a DataArray: with the variables of
        `SolutionArrays`, units, `consistent` and `outcome`.

    Raises
    ------
    InvalidValue
        Where a value is out of its range; with friction and inertia also where m a / W is.
    """
    kinds, slider = required_scene(scene).kinds, scene.slider
    body = slider.rod_length, slider.rod_angle, slider.radius
    given = [*scene.numbers, *body, *scene.law, pusher_angle, pusher_magnitude]
    results = outputs(len(kinds))
    found = elementwise(lambda *each: solve_arrays(kinds, *each), given, results)
    by_name = {output.name: each for output, each in zip(results, found, strict=True)}
    if is_labelled(found[0]):
        return _dataset(**by_name)
    return SolutionArrays(**by_name) if np.ndim(found[0]) else _solutions(**by_name)


def _solutions(solutions: int, mode: Any, **values: Array) -> Solutions:
    """The solutions of one problem."""
    entries = {name: each if each.ndim > 1 else each.tolist() for name, each in values.items()}
    return Solutions(
        tuple(
            Solution(mode=ContactMode(mode[i]), **{name: each[i] for name, each in entries.items()})
            for i in range(solutions)
        )
    )


def _dataset(solutions: Any, mode: Any, **values: Any) -> Any:
    consistent = named("consistent", mode >= 0)
    outcome = named("outcome", np.minimum(solutions, Outcome.AMBIGUOUS).astype(np.int8))
    merged = dataset([solutions, mode, *values.values(), consistent, outcome])
    return merged.assign_coords(xy=["x", "y"], twist_component=["v_x", "v_y", "omega"])
