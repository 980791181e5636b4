"""A scene from an object in its own frame: supports, masses and contact in the user's coordinates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.contact import ContactLaw
from planar_pushing.mechanics.effects import Effect, Inertia, Load, SupportFriction, Viscous
from planar_pushing.mechanics.outline import Corners, require_outline
from planar_pushing.mechanics.plane import Array, Frame, Placement
from planar_pushing.mechanics.rows import extents
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.slider import Slider
from planar_pushing.objects.many import Contacts, require_contacts
from planar_pushing.objects.on_outline import on_outline, side_on_fence
from planar_pushing.terms.domain import Number
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.units import Units

#: A center closer to the fence than this, relative to the extent, counts as on it: its rod would be flat.
MINIMUM_HEIGHT = 1e-9
#: Largest distance of a contact from the center, in extents of the support: no object's handle is longer.
FARTHEST = 500.0


def scene_at(
    point: npt.ArrayLike | None = None,
    normal: npt.ArrayLike | None = None,
    *,
    side: int | None = None,
    effects: Sequence[Effect],
    contact: ContactLaw,
    outline: Any = None,
    units: Units | None = None,
) -> Scene:
    """The scene of an object pushed at a point or along a side, with everything in the object's own frame.

    Parameters
    ----------
    point : (x, y), or array of shape S + (2,), optional
        The contact; an array makes an array of scenes. In a DataArray the last dimension holds x and y, and
        the scenes extend over the others.
    normal : (n_x, n_y), or array of shape S + (2,), optional
        Normal of the fence or of the finger's side, into the object, of any length. It can be omitted if
        the object has an outline and the contact is not at a corner. At a corner, a finger pushes the side
        with this normal, which ends there; with a normal between both, it leaves the corner by slipping.
    side : int, optional
        Instead of a point: the number of a side of the outline that lies on the fence, from the corner with
        this number to the next one, counted from 0 in the order given. A part of a longer straight side
        stands for all of it.
    effects : sequence of effects
        `SupportFriction`, `Viscous`, `Inertia` and `Load`, with supports, centers and forces in the
        object's frame.
    contact : ContactLaw
    outline : sequence of pairs, or an object with `coords` or `exterior`, optional
        Corners of the object in order. The contact must be on the outline, and the normal that of its side.
        The outline is exact to a millionth of its size: a vertex that close to the one before, or to a
        straight side, is no corner, and a contact that close to a corner is there. At an inner corner a
        pusher would touch two sides.
    units : Units, optional
        Names of the units, for results.

    Returns
    -------
    Scene
        In the fence frame: origin at the contact, +y along the normal, +x the normal rotated by -90
        degrees. A side on the fence has its origin at its midpoint; the scene's slider is then flush, and
        its side ends where the outline leaves the fence's line. Use `Scene.to_object` to transform results
        back. An array of scenes has no outline, because the outline differs between body frames; it has the
        ends of the sides.

    Raises
    ------
    InvalidValue
        If the normal is zero or points out of the object, the point is not on the outline or is at an inner
        corner, there is no such side, a fence along the side would pass through the object, or an effect
        cannot be placed in an object's frame.

    Notes
    -----
    The slider's center c is the center of pressure, or the center of mass of a scene with inertia alone. If
    it is not above the fence, as for a hook, c is instead the point above the contact at the height of the
    support's extent. The rod goes from the contact to c.
    """
    flush, corners = side is not None, None
    if flush:
        _require_side_alone(point, normal, outline)
        placement, ends, corners = side_on_fence(side, outline)
        contacts = Contacts(placement, placement.point, placement.normal)
    else:
        contacts = require_contacts(*_required_point(point, normal))
        if outline is None:
            placement, ends = _free(contacts)
        else:
            corners = require_outline(outline)
            placement, ends = on_outline(contacts, corners)
    many = bool(contacts.shape)
    acting = _required_effects(effects, many)
    center, extent = _middle(acting)
    rods = _rods(placement.fence, center, extent)
    _require_one_unit(rods.length, extent)
    body = Frame(contacts.pair(rods.origin), contacts.pair(rods.axis))
    slider = Slider(
        rod_length=contacts.number(rods.length),
        rod_angle=contacts.number(rods.angle),
        # The default is the extent of the moved support, which is the same at every contact.
        radius=extent if many or not any(hasattr(effect, "support") for effect in acting) else None,
        side=ends,
        flush=flush,
        outline=None if many or corners is None else Corners.of(body.point_in(corners) + 0.0),
    )
    loaded = [_with_center(effect, center, acting) for effect in acting]
    moved = tuple(effect.moved(body, placement.fence) for effect in loaded)
    return Scene(slider=slider, contact=contact, effects=moved, placement=placement, units=units)


class Rods(NamedTuple):
    """Rods of contacts: the center and the direction of each in the object's frame, length and angle.

    Attributes
    ----------
    origin, axis : ndarray, shape (n, 2)
    length, angle : ndarray, shape (n,)
    """

    origin: Array
    axis: Array
    length: Array
    angle: Array


def _required_point(point: Any, normal: Any) -> tuple[Any, Any]:
    """Point and normal, or `InvalidValue` without a point."""
    if point is None:
        raise InvalidValue(
            "point", None, "(x, y) of the contact", "give it, or the number of a side on the fence"
        )
    return point, normal


def _require_side_alone(point: Any, normal: Any, outline: Any) -> None:
    """Refuse a side together with a point or a normal, or without an outline."""
    for name, value in (("point", point), ("normal", normal)):
        if value is not None:
            raise InvalidValue(
                name,
                value,
                "none together with a side",
                "give either a side, or a point and a normal",
            )
    if outline is None:
        raise InvalidValue(
            "outline", None, "the corners of the object, to number its sides", "give the outline"
        )


def _require_one_unit(lengths: Array, extent: float) -> None:
    """Refuse a contact so far from the support that the units of length must differ."""
    far = ~(lengths <= FARTHEST * extent)
    if far.any():
        raise InvalidValue(
            "point",
            f"a contact {lengths[far][0]:.6g} from the center of a support of size {extent:.6g}",
            f"at most {FARTHEST:g} times its size", "give all lengths in one unit",
        )  # fmt: skip


def _free(contacts: Contacts) -> tuple[Placement, tuple[Number, Number]]:
    """Placements and sides of contacts of an object whose outline is unknown."""
    if contacts.normal is None:
        raise InvalidValue(
            "normal",
            None,
            "(n_x, n_y) without an outline",
            "give the inward normal",
        )
    return contacts.placement, contacts.pair(np.full(contacts.points.shape, (-np.inf, np.inf)))


def _required_effects(value: Any, many: bool) -> tuple[Any, ...]:
    """Effects that can be moved, to one or many contacts, or `InvalidValue`."""
    effects = tuple(value) if isinstance(value, (list, tuple)) else ()
    if not effects or not all(hasattr(effect, "moved") for effect in effects):
        raise InvalidValue(
            "effects", value, "a sequence of SupportFriction, Viscous, Inertia and Load",
            "list what resists the motion; for a ring give the radius: SupportFriction(support=Ring(1.0))",
        )  # fmt: skip
    films = [effect for effect in effects if isinstance(effect, Viscous)]
    if many and films:
        raise InvalidValue(
            "effects", films[0], "effects without viscous friction for an array of contacts",
            "make the scenes one by one",
        )  # fmt: skip
    return effects


def _with_center(effect: Any, center: Array, effects: tuple[Any, ...]) -> Any:
    """A load with the object's center as default point: the slider's center differs for a hook."""
    if not isinstance(effect, Load) or effect.center is not None:
        return effect
    if any(isinstance(other, Inertia) for other in effects):
        return effect
    return replace(effect, center=(float(center[0]), float(center[1])))


def _middle(effects: tuple[Any, ...]) -> tuple[Array, float]:
    """Center and extent of an object in its frame: of friction, else of viscous friction, else of mass."""
    friction = [effect for effect in effects if isinstance(effect, SupportFriction)]
    films = [effect for effect in effects if isinstance(effect, Viscous)]
    masses = [effect for effect in effects if isinstance(effect, Inertia)]
    if friction or films:
        resting = friction or films
        loads = np.array(
            [effect.weight for effect in friction] or [effect.coefficient for effect in films]
        )
        centers = np.array([effect.support.center_of_pressure for effect in resting])
        return loads @ centers / loads.sum(), float(extents(resting[0].support))
    if not masses:
        raise InvalidValue(
            "effects", effects, "friction or inertia among them", "list what resists the motion"
        )
    loads = np.array([effect.mass for effect in masses])
    centers = np.array([effect.center for effect in masses])
    return loads @ centers / loads.sum(), masses[0].gyration_radius


def _rods(fences: Frame, center: Array, extent: float) -> Rods:
    """The rods from contacts to the object's center."""
    origin, axis = (tuple(map(np.ravel, pair)) for pair in fences)
    fence = Frame((origin[0], origin[1]), (axis[0], axis[1]))
    along, height = fence.point_in(center).T
    low = height <= MINIMUM_HEIGHT * extent
    rod = np.column_stack([np.where(low, 0.0, along), np.where(low, extent, height)])
    length = np.hypot(rod[:, 0], rod[:, 1])
    angle = np.arctan2(rod[:, 1], rod[:, 0])
    return Rods(fence.point_out(rod), fence.vector_out(rod / length[:, None]), length, angle)
