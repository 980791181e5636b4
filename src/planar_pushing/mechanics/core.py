"""Effects in the form of the compiled core: their kinds, and columns of numbers for arrays of scenes."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.effects import Inertia, Load, Viscous
from planar_pushing.mechanics.effects.any_support import Supports
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.effects.load import Wrench
from planar_pushing.mechanics.effects.ring import RingSupport
from planar_pushing.mechanics.supports.even_ring import Ring
from planar_pushing.mechanics.supports.in_frames import SupportInFrames, listed
from planar_pushing.mechanics.supports.pressure.table import extents_of, table_of
from planar_pushing.terms.domain import Number, required_ratio


class Entry(NamedTuple):
    """An effect in the compiled core.

    Attributes
    ----------
    kind : named tuple
        Kind of the effect, without the numbers of a scene.
    degree : int
        Degree of homogeneity of its potential: if the motion is multiplied by a factor, the force is
        multiplied by the factor to the power ``degree - 1``.
    forces : list
        Columns of forces, or of forces divided by motions.
    others : list
        All other columns, which follow: lengths in radii of the slider.
    number : int
        Index in the list of effects.
    """

    kind: Any
    degree: int
    forces: list[Number]
    others: list[Number]
    number: int = 0

    @property
    def columns(self) -> list[Number]:
        """All columns."""
        return [*self.forces, *self.others]


def entries(effects: Any, scene: Any) -> list[Entry]:
    """The entries of the effects of a scene, grouped by kind."""
    found = [_entry(effect, scene)._replace(number=i) for i, effect in enumerate(effects)]
    return sorted(found, key=lambda entry: type(entry.kind).__name__, reverse=True)


def _entry(effect: Any, scene: Any) -> Entry:
    radius = scene.slider.radius
    if isinstance(effect, Inertia):
        ratio = required_ratio("gyration_ratio", effect.gyration_radius / radius)
        place = [each / radius for each in effect.center]
        return Entry(Mass(1.0, 1.0, 0.0, 0.0), 2, [effect.mass], [ratio**2, *place])
    if isinstance(effect, Viscous):
        x, y, square = _spread(effect.support, radius)
        return Entry(Mass(1.0, 1.0, 0.0, 0.0), 2, [effect.coefficient], [square, x, y])
    if isinstance(effect, Load):
        return Entry(Wrench(0.0, 0.0, 0.0), 1, _wrench(effect, scene), [])
    if is_own_ring(effect.support, radius):
        return Entry(RingSupport(1.0), 1, [effect.weight], [])
    support = effect.support
    number = np.arange(float(np.size(support))).reshape(np.shape(support))
    others = [extents(support) / radius, alike(support, number)]
    return Entry(Supports(table_of(listed(support))), 1, [effect.weight], others)


def _wrench(load: Load, scene: Any) -> list[Number]:
    """Wrench of a load about the slider's center, in the body frame; lengths in radii."""
    c, s = np.cos(scene.slider.rod_angle), np.sin(scene.slider.rod_angle)
    (x, y), place = load.force, scene.mass_center
    if load.center is not None:
        place = tuple(each / scene.slider.radius for each in load.center)
    g_x, g_y = x * c + y * s, y * c - x * s
    return [g_x, g_y, place[0] * g_y - place[1] * g_x]


def _spread(support: Any, radius: Number) -> tuple[Number, Number, Number]:
    """Center of pressure in radii, and mean square of the distance from it."""
    size = radius if isinstance(support, Ring) and support.radius is None else 1.0
    table, extent = table_of([support]), extents_of([support])[0] * size / radius
    x, y = table.centers[0]
    return x * extent, y * extent, (table.spreads[0, 0] + table.spreads[0, 2]) * extent**2


def is_own_ring(support: Any, radius: Number) -> bool:
    """Whether supports are rings of the slider's radius, about its center."""
    in_frames = isinstance(support, SupportInFrames)
    rings = [support.support] if in_frames else listed(support)
    same = all(
        isinstance(ring, Ring)
        and (ring.radius is None or np.all(np.asarray(radius) == ring.radius))
        for ring in rings
    )
    if same and in_frames:
        return not support.frame.point_in(rings[0].center_of_pressure).any()
    return same and all(ring.center is None for ring in rings)


def alike(support: Any, numbers: Any) -> Any:
    """Numbers of supports: a scalar for one support, labeled if the supports are."""
    if isinstance(support, SupportInFrames):
        return support.alike(numbers)
    if hasattr(support, "dims"):
        return support.copy(data=numbers)
    return numbers if np.ndim(numbers) else float(numbers)


def extents(support: Any) -> Number:
    """Largest distance of a support, or of each support of an array, from its center of pressure."""
    return alike(support, extents_of(listed(support)).reshape(np.shape(support)))
