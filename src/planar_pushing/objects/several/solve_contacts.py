"""Every consistent solution of an object with several contacts, from rest."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.core.contacts.several_frames import MOST_OF_SEVERAL, SeveralRow
from planar_pushing.core.contacts.several_solutions import (
    SEVERAL_SOLUTION,
    SeveralResults,
    SeveralSolution,
)
from planar_pushing.mechanics.contact import Coulomb
from planar_pushing.mechanics.effects import Effect
from planar_pushing.mechanics.force.held import require_held
from planar_pushing.mechanics.kernels.arrays import Output, elementwise, is_labeled, map_kernel
from planar_pushing.mechanics.kernels.columns import Columns, row_of
from planar_pushing.mechanics.outline import require_outline
from planar_pushing.mechanics.plane import Frame, Placement
from planar_pushing.mechanics.rows import in_units, strengths_of
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.slider import Slider
from planar_pushing.mechanics.solve import require_proportion, size_of_fall
from planar_pushing.objects.plausible import warn_of_doubts
from planar_pushing.objects.scene_at import (
    measure_object,
    require_effects,
    with_center,
)
from planar_pushing.objects.several.contact import Contact, PlacedContact, place_contacts
from planar_pushing.objects.several.grip import OPPOSITE, grip_rows, is_opposite, require_grip
from planar_pushing.objects.several.solutions import (
    ContactsSolutionArrays,
    as_labeled,
    solutions_of,
)
from planar_pushing.terms.domain import Number
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import Array

#: Room for the solutions of up to two contacts, of which five were the most that random scenes had.
ROOM_FOR_TWO = 8


def solve_contacts(
    contacts: Sequence[Contact],
    *,
    effects: Sequence[Effect],
    outline: Any = None,
) -> Any:
    """Every consistent solution of an object that several fingers, walls or sides touch, from rest.

    Parameters
    ----------
    contacts : sequence of Contact
        One to four; a side counts as two.
    effects : sequence of effects
        `SupportFriction`, `Viscous`, `Inertia` and `Load` in the object's frame, as of `scene_at`.
    outline : sequence of pairs, Polygon, Disc, Outline, or an object with `coords` or `exterior`, optional
        As of `scene_at`. Every contact must be on it.

    Returns
    -------
    ContactsSolutions, ContactsSolutionArrays or xarray.Dataset
        All numbers are in the object's frame. `ContactsSolutionArrays` if a velocity, a law, a grip force
        or the strength of an effect is an array, all of which are broadcast, and a dataset with the same
        variables if one is a DataArray.

    Raises
    ------
    InvalidValue
        If there are no contacts or more than four, one is not on the outline or is given twice, an effect
        cannot be placed, m a / W with friction and inertia is out of its range, two contacts squeeze the
        object along one line, so that nothing determines their forces, or a contact with a grip force is
        not one of two with opposite normals on one line, or acts beside inertia, viscous friction or a
        support on one line.

    Notes
    -----
    Each contact separates, sticks or slips; every combination is examined. Solutions with one twist count
    once: of a contact that neither opens nor pushes it is said that it is closed, and of one that does not
    slip that it sticks. If there is no solution, `reason` says whether the object is jammed, because the
    pushers leave it no motion, or wedged, because forces of the contacts can cancel one another without
    bound.

    If friction holds an object in a gripper at rest, its forces are not determined. Those are given that
    need the smallest share of friction, and `inner_force` is theirs, not a range.
    """
    shape = None if outline is None else require_outline(outline)
    placed = place_contacts(contacts, shape, outline)
    scene, center = scene_about_center(effects, shape)
    warn_of_doubts(effects, [contact.law for contact in placed], shape)
    forces = [contact.grip_force for contact in placed if contact.grip_force is not None]
    if forces:  # the fingers can hold a load that friction cannot
        require_grip(placed, effects, scene)
    else:
        require_held(scene)
        _require_no_squeeze(placed, scene)
    count = len(placed)
    numbers = [
        *scene.rows.columns,
        *(number for contact in placed for number in (*contact.velocity, *contact.numbers)),
        *forces,
    ]
    outputs = outputs_of(count)
    answer = functools.partial(_solve_arrays, scene, placed, center)
    arrays = elementwise(answer, numbers, outputs)
    values = {output.name: array for output, array in zip(outputs, arrays, strict=True)}
    if is_labeled(arrays[0]):
        return as_labeled(values)
    if np.ndim(arrays[0]):
        return ContactsSolutionArrays(**values)
    return solutions_of(values)


def scene_about_center(effects: Any, outline: Any) -> tuple[Scene, tuple[float, float]]:
    """The object about its center, with a body frame along its own frame, and this center."""
    acting = require_effects(effects, outline)
    center, extent = measure_object(acting)
    placement = Placement(center, (1.0, 0.0))
    slider = Slider(rod_length=0.0, rod_angle=np.pi / 2.0, radius=extent)
    loaded = [with_center(effect, center, acting) for effect in acting]
    body = Frame(center, (1.0, 0.0))
    placed = tuple(effect.in_frames(body, placement.fence) for effect in loaded)
    return Scene(slider=slider, contact=Coulomb(0.0), effects=placed), center


def _require_no_squeeze(contacts: Sequence[PlacedContact], scene: Scene) -> None:
    """Refuse two contacts with opposite normals on one line that neither close in nor open."""
    for i, one in enumerate(contacts):
        for other in contacts[:i]:
            if not is_opposite(one, other, float(scene.slider.radius)):
                continue
            (n_x, n_y), (m_x, m_y) = one.normal, other.normal
            (v_x, v_y), (w_x, w_y) = one.velocity, other.velocity
            closing = n_x * v_x + n_y * v_y + m_x * w_x + m_y * w_y
            speed = np.hypot(v_x, v_y) + np.hypot(w_x, w_y)
            if np.any(np.abs(closing) <= OPPOSITE * speed):
                raise InvalidValue(
                    "contacts", f"a squeeze between {other.point} and {one.point}",
                    "contacts whose forces the motion determines",
                    "give one of them its grip_force, or move it off the other's normal",
                )  # fmt: skip


def _solve_arrays(
    scene: Scene, contacts: Sequence[PlacedContact], center: tuple[float, float], *numbers: Any
) -> list[npt.NDArray[Any]]:
    """The arrays of `ContactsSolutionArrays`, from the columns of the effects and those of the contacts.

    A grip force, if there is one, is the last of the numbers.
    """
    rows, radius, count = scene.rows, scene.slider.radius, len(contacts)
    columns, rest = numbers[: len(rows.columns)], numbers[len(rows.columns) :]
    moved = [rest[7 * i : 7 * i + 7] for i in range(count)]
    kernel, data, gripped = "solve_contacts", rows.data, len(rest) > 7 * count
    size: Any = 0.0
    for contact, (v_x, v_y, *_) in zip(contacts, moved, strict=True):
        speed = np.hypot(v_x, v_y)
        if contact.grip_force is not None:
            speed = np.abs(contact.normal[1] * v_x - contact.normal[0] * v_y)
        size = np.maximum(size, speed)
    if gripped:
        kernel, size = "solve_gripped", np.where(np.asarray(size) > 0.0, size, 1.0)
        data, scaled, unit = grip_rows(scene, contacts, columns, rest[-1])
    else:
        strengths = strengths_of(rows.entries, columns)
        require_proportion(rows.entries, strengths, size)
        size = np.where(np.asarray(size) > 0.0, size, size_of_fall(rows.entries, strengths))
        unit, scaled = in_units(rows.entries, columns, strengths, size)
    for contact, (v_x, v_y, right, left, slips, closed, rough) in zip(contacts, moved, strict=True):
        (x, y), (c_x, c_y) = contact.point, center
        scaled += row_of(
            SeveralRow, point=[(x - c_x) / radius, (y - c_y) / radius], normal=list(contact.normal),
            velocity=[v_x / size, v_y / size], right=right, left=left, slips=slips, closed=closed,
            rough=rough,
        )  # fmt: skip
    width = SeveralResults.size + _room_of(count) * SEVERAL_SOLUTION
    geometry, outputs = _Geometry(contacts, center, radius), outputs_of(count)
    return map_kernel(kernel, data, [*scaled, size, unit], outputs, width, geometry.decode)


def _room_of(count: int) -> int:
    """Length of the axis of solutions for a number of contacts."""
    return ROOM_FOR_TWO if count <= 2 else MOST_OF_SEVERAL


def outputs_of(count: int) -> tuple[Output, ...]:
    """The results of each problem with a number of contacts."""
    many, xy, one_each = ("solution", _room_of(count)), ("xy", 2), ("contact", count)
    return (
        Output("solutions", (), "i1"),
        Output("status", (), "i1"),
        Output("reason", (), "i1"),
        Output("modes", (many, one_each), "i1"),
        Output("twist", (many, ("twist_component", 3))),
        Output("forces", (many, one_each, xy)),
        Output("forces_end", (many, one_each, xy)),
        Output("inner_force", (many, ("bound", 2))),
        Output("directions", (many, ("bound", 2), one_each, xy)),
        Output("contact_motions", (many, one_each, xy)),
        Output("gap_rates", (many, one_each)),
        Output("pivot", (many,), "i4"),
        Output("continuum", (many,), "?"),
        Output("condition", (many,)),
    )


class _Geometry:
    """Points and normals of the contacts, with which results of the core become those of the object."""

    def __init__(
        self, contacts: Sequence[PlacedContact], center: tuple[float, float], radius: Number
    ) -> None:
        self.points = np.array([contact.point for contact in contacts])
        self.normals = np.array([contact.normal for contact in contacts])
        self.contacts, self.center, self.radius = contacts, np.asarray(center), radius

    def decode(
        self, results: Array, columns: Sequence[Any], outputs: Sequence[npt.NDArray[Any]]
    ) -> None:
        """Write the outputs in the units of the object; the last columns of a row are its units."""
        counts, status, reason, modes, *others = outputs
        head = Columns(SeveralResults, results)
        counts[:], status[:], reason[:] = head.count, head.status, head.reason
        most = int(counts.max(initial=0))
        modes[:] = -1
        for output in others:
            output[:] = (
                np.nan if output.dtype.kind == "f" else -1 if output.dtype.kind == "i" else 0
            )
        if most == 0:
            return
        numbers = results[:, SeveralResults.size :].reshape(len(results), -1, SEVERAL_SOLUTION)
        rows = Columns(SeveralSolution, numbers[:, :most])
        exists = np.arange(most) < counts[:, None]
        modes[:, :most] = np.where(exists[..., None], rows.modes, -1.0)[..., : len(self.points)]
        kept = [output[:, :most] for output in others]
        self._decode_motions(columns, rows, modes[:, :most], kept)
        self._decode_forces(columns, rows, kept)
        pivot, continuum = kept[7:9]
        pivot[:] = np.where(exists, rows.pivot, -1.0)
        continuum[:] = rows.continuum == 1.0

    def _decode_motions(
        self, columns: Sequence[Any], rows: Any, modes: Any, outputs: Sequence[Array]
    ) -> None:
        """Write the twists, and the motions at the contacts."""
        size, twist, motions = np.asarray(columns[-2])[..., None], outputs[0], outputs[5]
        omega = rows.twist[..., 2] * size / self.radius
        (c_x, c_y), (x, y) = self.center, self.points.T
        twist[..., 0] = rows.twist[..., 0] * size + omega * c_y
        twist[..., 1] = rows.twist[..., 1] * size - omega * c_x
        twist[..., 2] = omega
        motions[..., 0] = twist[..., 0, None] - omega[..., None] * y
        motions[..., 1] = twist[..., 1, None] + omega[..., None] * x
        self._decode_rates(columns, modes, motions, outputs[6])

    def _decode_forces(self, columns: Sequence[Any], rows: Any, outputs: Sequence[Array]) -> None:
        """Write the forces at both ends of their range."""
        unit = np.asarray(columns[-1])[..., None]
        forces, ends, inner, directions = outputs[1:5]
        shape = (*rows.pivot.shape, -1, 2)
        low = rows.low_forces.reshape(shape)[:, :, : len(self.points)]
        high = rows.high_forces.reshape(shape)[:, :, : len(self.points)]
        infinite = np.stack([rows.low_infinite, rows.high_infinite], axis=-1) == 1.0
        np.multiply(low, unit[..., None, None], out=forces)
        np.multiply(high, unit[..., None, None], out=ends)
        inner[..., 0], inner[..., 1] = rows.low_inner * unit, rows.high_inner * unit
        if infinite.any():
            for k, (force, end) in enumerate(((low, forces), (high, ends))):
                without = infinite[..., k, None, None]
                directions[:, :, k] = np.where(without, force, np.nan)
                grown = np.where(np.abs(force) > OPPOSITE, np.copysign(np.inf, force), 0.0)
                end[:] = np.where(without, grown, end)
        self._decode_condition(np.stack([low, high]), infinite, outputs[9])

    def _decode_rates(
        self, columns: Sequence[Any], modes: Any, motions: Array, rates: Array
    ) -> None:
        """Write how fast the gaps open; those of closed contacts do not."""
        size, first = np.asarray(columns[-2]), len(columns) - 2 - SeveralRow.size * len(self.points)
        for i, normal in enumerate(self.normals):
            place = SeveralRow.places["velocity"].start + first + SeveralRow.size * i
            pusher = [np.asarray(column) * size for column in columns[place : place + 2]]
            across = (normal[0] * pusher[0] + normal[1] * pusher[1])[..., None]
            rate = motions[:, :, i] @ normal - across
            rates[:, :, i] = np.where(modes[:, :, i] > 0, 0.0, rate)

    def _decode_condition(self, forces: Array, infinite: Array, condition: Array) -> None:
        """Write the sum of the forces' magnitudes relative to the load, at the end where it is smaller."""
        with np.errstate(invalid="ignore", divide="ignore"):
            lever = (self.points - self.center) / self.radius
            total = np.hypot(*np.moveaxis(forces, -1, 0)).sum(axis=-1)
            net = forces.sum(axis=-2)
            torque = (lever[:, 0] * forces[..., 1] - lever[:, 1] * forces[..., 0]).sum(axis=-1)
            load = np.maximum(np.hypot(net[..., 0], net[..., 1]), np.abs(torque))
            ratio = np.where(total > 0.0, total / np.where(load > 0.0, load, 1.0), 1.0)
            ratio = np.where((total > 0.0) & (load == 0.0), np.inf, ratio)
            ratio = np.where(np.moveaxis(infinite, -1, 0), np.inf, ratio)
        condition[:] = np.where(np.isnan(total[0]), np.nan, ratio.min(axis=0))
