"""Two opposite fingers on one line, of which one is driven by force: the inputs of their solutions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.core.contacts.gripped_frames import GripRow
from planar_pushing.core.supports.rows import LOAD, LoadRow
from planar_pushing.mechanics.effects import Effect, Inertia, Load, Viscous
from planar_pushing.mechanics.kernels.columns import row_of
from planar_pushing.mechanics.pressure.table import table_of
from planar_pushing.mechanics.rows import data_of, in_units, strengths_of
from planar_pushing.mechanics.scene import Scene
from planar_pushing.objects.several.contact import PlacedContact
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import Array

#: Contacts whose normals are opposite, and on one line, to within this.
OPPOSITE = 1e-9
#: Smallest ratio of the spreads of a support across and along its longest direction.
THINNEST = 1e-9


class GripRows(NamedTuple):
    """Rows of inputs up to the contacts.

    Attributes
    ----------
    data : ndarray
        Numbers that all rows share.
    columns : list
        The effects, and the grip.
    unit : number or array
        Unit of force.
    """

    data: Array
    columns: list[Any]
    unit: Any


def is_opposite(one: PlacedContact, other: PlacedContact, extent: float) -> bool:
    """Whether two contacts have opposite normals on one line, to within a share of an object's extent."""
    (n_x, n_y), (m_x, m_y) = one.normal, other.normal
    r_x, r_y = one.point[0] - other.point[0], one.point[1] - other.point[1]
    aside = abs(r_x * n_y - r_y * n_x)
    return bool(np.hypot(n_x + m_x, n_y + m_y) <= OPPOSITE and aside <= OPPOSITE * extent)


def require_grip(
    contacts: Sequence[PlacedContact], effects: Sequence[Effect], scene: Scene
) -> None:
    """Refuse a finger that is driven by force unless another one is opposite and friction alone resists.

    The friction has to be off every line: on a line it does not determine the motion.

    Raises
    ------
    InvalidValue
        With what is allowed instead.
    """
    gripping = [contact for contact in contacts if contact.grip_force is not None]
    if len(contacts) != 2 or len(gripping) != 1:
        raise InvalidValue(
            "grip_force", f"{len(gripping)} of {len(contacts)} contacts", "one of two contacts",
            "give the force of one finger, and the velocity of the other one",
        )  # fmt: skip
    one, other = contacts
    extent = float(scene.slider.radius)
    apart = np.hypot(one.point[0] - other.point[0], one.point[1] - other.point[1])
    if not is_opposite(one, other, extent) or apart <= OPPOSITE * extent:
        raise InvalidValue(
            "grip_force", f"contacts at {one.point} and {other.point}",
            "contacts with opposite normals on one line",
            "move one of them onto the normal of the other one, or leave out the force",
        )  # fmt: skip
    for effect in effects:
        if isinstance(effect, (Inertia, Viscous)):
            raise InvalidValue(
                "grip_force", effect, "effects that are friction and loads", "leave out this one"
            )
    if _is_on_line(effects):
        raise InvalidValue(
            "grip_force", "a support on one line", "a support with friction off every line",
            "give the support its width",
        )  # fmt: skip


def _is_on_line(effects: Sequence[Any]) -> bool:
    """Whether all friction is on one line."""
    supports = [effect.support for effect in effects if not isinstance(effect, Load)]
    spread, points = np.zeros((2, 2)), []
    for support in supports:
        table = table_of([support])
        xx, xy, yy = table.spreads[0]
        spread += np.array([[xx, xy], [xy, yy]])
        points.append(table.centers[0])
    spread += np.cov(np.array(points).T, bias=True) if len(points) > 1 else 0.0
    low, high = np.linalg.eigvalsh(spread)
    return bool(low <= THINNEST**2 * high)


def grip_rows(
    scene: Scene, contacts: Sequence[PlacedContact], columns: Sequence[Any], force: Any
) -> GripRows:
    """The rows of a scene without its loads, and the grip, which has them and a normal force.

    Parameters
    ----------
    scene : Scene
    contacts : sequence of PlacedContact
        Two, one of which has a grip force.
    columns : sequence
        Those of the scene's effects; loads are first.
    force : number or array
        The grip force, in the unit of force of the effects.
    """
    entries = [entry for entry in scene.rows.entries if entry.kind != LOAD]
    count = len(columns) - sum(len(entry.columns) for entry in entries)
    loads, friction = columns[:count], columns[count:]
    unit, scaled = in_units(entries, friction, strengths_of(entries, friction), 1.0)
    wrench = [sum(loads[k :: LoadRow.size]) / unit if count else 0.0 for k in range(LoadRow.size)]
    pressed = 0 if contacts[0].grip_force is not None else 1
    scaled += row_of(
        GripRow, pressed=float(pressed), force=force / unit, load_x=wrench[0], load_y=wrench[1],
        load_torque=wrench[2],
    )  # fmt: skip
    return GripRows(data_of(entries), scaled, unit)
