"""A scene as rows of numbers: the effects of a push from rest, in the form that the core reads.

The numbers of a scene are columns, which are arrays for an array of scenes. They are made dimensionless in
one place: lengths are divided by the slider's radius once, and forces by the unit of a call.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.core._record import Record
from planar_pushing.core.instant.flush_solutions import SideRow
from planar_pushing.core.instant.kernels import PushRow
from planar_pushing.core.supports.rows import (
    LOAD,
    MASS,
    RING,
    SUPPORT,
    LoadRow,
    MassRow,
    RingRow,
    SupportRow,
)
from planar_pushing.mechanics.contact import Law
from planar_pushing.mechanics.effects import Inertia, Load, Viscous
from planar_pushing.mechanics.kernels.columns import row_of
from planar_pushing.mechanics.pressure.support_in_frames import (
    KINDS,
    SupportInFrames,
    flatten_supports,
)
from planar_pushing.mechanics.pressure.table import (
    Table,
    extent_of,
    extents_of,
    joined_data,
    table_of,
)
from planar_pushing.mechanics.supports.even_ring import Ring
from planar_pushing.terms.domain import Number, require_ratio
from planar_pushing.terms.numbers import Array

#: Form of the numbers of each kind of effect, in the order of a row, and degree of its potential.
FORMS: dict[int, tuple[type[Record], int]] = {
    LOAD: (LoadRow, 1), SUPPORT: (SupportRow, 1), RING: (RingRow, 1), MASS: (MassRow, 2),
}  # fmt: skip


class EffectColumns(NamedTuple):
    """An effect in the form of the core.

    Attributes
    ----------
    kind : int
        `RING`, `SUPPORT`, `LOAD` or `MASS`.
    degree : int
        Degree of homogeneity of its potential: if the motion is multiplied by a factor, the force is
        multiplied by the factor to the power ``degree - 1``.
    forces : list
        Columns of forces, or of forces divided by motions.
    others : list
        All other columns, which follow: lengths in radii of the slider.
    number : int
        Index in the scene's list of effects.
    table : Table, optional
        Pressures of a support.
    """

    kind: int
    degree: int
    forces: list[Number]
    others: list[Number]
    number: int
    table: Table | None = None

    @classmethod
    def of(cls, kind: int, number: int, table: Table | None = None, **values: Any) -> EffectColumns:
        """An effect from its numbers by name: those of a load are forces, others begin with one."""
        record, degree = FORMS[kind]
        columns = row_of(record, **values)
        forces = len(columns) if kind == LOAD else 1
        return cls(kind, degree, columns[:forces], columns[forces:], number, table)

    @property
    def values(self) -> dict[str, Number]:
        """All columns by name."""
        return dict(zip(FORMS[self.kind][0].places, self.columns, strict=True))

    @property
    def columns(self) -> list[Number]:
        """All columns."""
        return [*self.forces, *self.others]

    @property
    def resists(self) -> bool:
        """Whether the effect resists a motion, unlike a load."""
        return self.kind != LOAD


#: Order of the kinds in a row.
ORDER = {kind: place for place, kind in enumerate(FORMS)}


@dataclass(frozen=True, slots=True, eq=False)
class Rows:
    """The effects of a push from rest as rows of numbers.

    Attributes
    ----------
    entries : tuple of EffectColumns
        The effects, grouped by kind.
    data : ndarray
        Numbers that the rows of a call share: the kinds, and the pressures of the supports.
    body : tuple
        Length of the rod in radii, its angle in radians, and the radius.
    ends : tuple
        Ends of a side that lies on the fence, in radii; empty for a contact at one point.
    law : Law
    pocket : float or array
        As of `Slider`.
    columns : tuple
        The columns of the effects, with forces in the scene's units.
    is_single : bool
        Whether all of these are numbers, not arrays.
    is_steady : bool
        Whether all potentials have one degree, so that directions do not depend on magnitudes.
    strengths : list of float
        As of `strengths_of`, for a single scene; empty for an array of scenes.
    push : list of float
        As of `row_of_push` for a pusher at rest, for a single scene; empty for an array of scenes.
    """

    entries: tuple[EffectColumns, ...]
    data: Array
    body: tuple[Number, Number, Number]
    ends: tuple[Number, ...]
    law: Law
    pocket: Number
    columns: tuple[Number, ...]
    is_single: bool
    is_steady: bool
    strengths: list[float]
    push: list[float]

    @classmethod
    def of(cls, scene: Any) -> Rows:
        """The rows of a scene; callers take `scene.rows`, which keeps them."""
        slider = scene.slider
        entries = entries_of(((i, scene.effects[i]) for i in scene.resisting), scene)
        body = slider.length_ratio, slider.rod_angle, slider.radius
        ends = tuple(end / slider.radius for end in slider.side) if slider.flush else ()
        columns = tuple(column for entry in entries for column in entry.columns)
        pocket = slider.pocket
        numbers = *columns, *body, *ends, *scene.law, pocket
        single = all(isinstance(number, (float, int)) for number in numbers)
        if single:
            columns, ends = tuple(map(float, columns)), tuple(map(float, ends))
            body = float(body[0]), float(body[1]), float(body[2])
        steady = len({entry.degree for entry in entries}) == 1
        strengths = strengths_of(entries, columns) if single else []
        push = row_of_push(*body[:2], scene.law, pocket, 0.0, False, ends) if single else []
        return cls(
            entries, data_of(entries), body, ends, scene.law, pocket, columns, single, steady,
            strengths, push,
        )  # fmt: skip

    def strength(self, degree: int) -> Number:
        """Sum of the strengths of the effects of a degree, without loads; 0 if there are none."""
        return sum(
            entry.forces[0] for entry in self.entries if entry.degree == degree and entry.resists
        )


def row_of_push(
    length: Any, angle: Any, law: Law, pocket: Any, toward: Any, moves: Any, ends: Sequence[Any]
) -> list[Any]:
    """The columns of a push, which follow those of the effects; `ends` are empty for a point."""
    values = {
        "length": length, "angle": angle, "right": law.right, "left": law.left, "slips": law.slips,
        "closed": law.closed, "rough": law.rough, "pusher": toward, "moves": moves, "pocket": pocket,
    }  # fmt: skip
    if not ends:
        return row_of(PushRow, **values)
    start, end = ends
    return row_of(SideRow, **values, start=start, end=end)


def entries_of(effects: Iterable[tuple[int, Any]], scene: Any) -> tuple[EffectColumns, ...]:
    """The entries of numbered effects of a scene, grouped by kind."""
    entries = [_entry(effect, scene, number) for number, effect in effects]
    return tuple(sorted(entries, key=lambda entry: ORDER[entry.kind]))


def data_of(entries: Sequence[EffectColumns]) -> Array:
    """Numbers that the rows of a call share: kinds, columns and tables of the entries."""
    column, effects = 0, []
    for entry in entries:
        effects.append((entry.kind, column, entry.table))
        column += len(entry.forces) + len(entry.others)
    return joined_data(effects, column)


def scale_forces(
    entries: Sequence[EffectColumns],
    columns: Sequence[Any],
    factors: Sequence[Any],
    units: Sequence[Any],
) -> list[Any]:
    """Dimensionless columns of effects.

    Parameters
    ----------
    entries : sequence of EffectColumns
    columns : sequence
        The columns of the entries, as numbers or arrays.
    factors, units : sequence of two
        Factor and unit of the forces of degree 1, and of degree 2.
    """
    scaled, index = [], 0
    for entry in entries:
        factor, unit = factors[entry.degree - 1], units[entry.degree - 1]
        end = index + len(entry.forces)
        scaled += [factor * column / unit for column in columns[index:end]]
        index = end + len(entry.others)
        scaled += columns[end:index]
    return scaled


def strengths_of(entries: Sequence[EffectColumns], columns: Sequence[Any]) -> list[Any]:
    """The strength of each effect: its weight, mass or coefficient, and the magnitude of a load."""
    strengths, index = [], 0
    for entry in entries:
        force = columns[index]
        strengths.append(np.hypot(force, columns[index + 1]) if entry.kind == LOAD else force)
        index += len(entry.forces) + len(entry.others)
    return strengths


def in_units(
    entries: Sequence[EffectColumns], columns: Sequence[Any], strengths: Sequence[Any], size: Any
) -> tuple[Any, list[Any]]:
    """Unit of force, and the columns of effects in this unit, for motions in units of `size`.

    The strengths are those of `strengths_of`.
    """
    unit: Any = 0.0
    for entry, strength in zip(entries, strengths, strict=True):
        force = strength * size if entry.degree == 2 else strength
        is_number = type(force) is float and type(unit) is float
        unit = max(unit, force) if is_number else np.maximum(unit, force)
    return unit, scale_forces(entries, columns, (1.0, size), (unit, unit))


def _entry(effect: Any, scene: Any, number: int) -> EffectColumns:
    radius = scene.slider.radius
    if isinstance(effect, Inertia):
        ratio = require_ratio("gyration_ratio", effect.gyration_radius / radius)
        center = [coordinate / radius for coordinate in effect.center]
        return _mass_columns(number, effect.mass, ratio**2, center)
    if isinstance(effect, Viscous):
        x, y, square = _spread_of(effect.support, radius)
        return _mass_columns(number, effect.coefficient, square, (x, y))
    if isinstance(effect, Load):
        x, y, torque = _wrench_of(effect, scene)
        return EffectColumns.of(LOAD, number, x=x, y=y, torque=torque)
    if is_own_ring(effect.support, radius):
        return EffectColumns.of(RING, number, weight=effect.weight)
    support = effect.support
    pressure: Any = 0.0
    if type(support) not in KINDS:
        pressure = alike(support, np.arange(float(np.size(support))).reshape(np.shape(support)))
    return EffectColumns.of(
        SUPPORT, number, table_of(flatten_supports(support)),
        weight=effect.weight, extent=extents(support) / radius, pressure=pressure,
    )  # fmt: skip


def _mass_columns(number: int, mass: Number, gyration: Number, center: Any) -> EffectColumns:
    """The columns of inertia, or of viscous friction in the form of a mass."""
    x, y = center
    return EffectColumns.of(MASS, number, mass=mass, gyration=gyration, center_x=x, center_y=y)


def _wrench_of(load: Load, scene: Any) -> list[Number]:
    """Wrench of a load about the slider's center, in the body frame; lengths in radii."""
    c, s = unit_vector(scene.slider.rod_angle)
    (x, y), point = load.force, scene.mass_center
    if load.center is not None:
        point = tuple(coordinate / scene.slider.radius for coordinate in load.center)
    g_x, g_y = x * c + y * s, y * c - x * s
    return [g_x, g_y, point[0] * g_y - point[1] * g_x]


def unit_vector(angle: Number) -> Any:
    """Cosine and sine of an angle, exact at 90 degrees: a load along the fence has no normal component."""
    if hasattr(angle, "dims"):
        upright = angle == np.pi / 2
        return np.cos(angle).where(~upright, 0.0), np.sin(angle)
    return np.where(np.equal(angle, np.pi / 2), 0.0, np.cos(angle))[()], np.sin(angle)


def _spread_of(support: Any, radius: Number) -> tuple[Number, Number, Number]:
    """Center of pressure in radii, and mean square of the distance from it."""
    size = radius if isinstance(support, Ring) and support.radius is None else 1.0
    table, extent = table_of([support]), extents_of([support])[0] * size / radius
    x, y = table.centers[0]
    return x * extent, y * extent, (table.spreads[0, 0] + table.spreads[0, 2]) * extent**2


def is_own_ring(support: Any, radius: Number) -> bool:
    """Whether supports are rings of the slider's radius, about its center."""
    in_frames = isinstance(support, SupportInFrames)
    rings = [support.support] if in_frames else flatten_supports(support)
    same = all(
        isinstance(ring, Ring)
        and (ring.radius is None or np.all(np.asarray(radius) == ring.radius))
        for ring in rings
    )
    if same and in_frames:
        return not support.frame.point_in(rings[0].center_of_pressure).any()
    return same and all(ring.center is None for ring in rings)


def alike(support: Any, numbers: Any) -> Any:
    """Numbers, one for each support: a scalar for a single support, labeled if the supports are."""
    if isinstance(support, SupportInFrames):
        return support.alike(numbers)
    if hasattr(support, "dims"):
        return support.copy(data=numbers)
    return numbers if np.ndim(numbers) else float(numbers)


def extents(support: Any) -> Number:
    """Largest distance of a support, or of each support of an array, from its center of pressure."""
    if type(support) in KINDS:
        return extent_of(support)
    return alike(support, extents_of(flatten_supports(support)).reshape(np.shape(support)))
