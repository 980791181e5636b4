"""A scene from an object in its own frame: supports, masses and contact in the user's coordinates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.contact import ContactLaw
from planar_pushing.mechanics.rows import extents
from planar_pushing.mechanics.effects import Effect, Inertia, Load, SupportFriction, Viscous
from planar_pushing.mechanics.frames import Frame, Placement, moved_place
from planar_pushing.mechanics.outline import placed, required_outline
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.objects.many import scenes_at
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import required_array
from planar_pushing.terms.units import Units

#: A center closer to the fence than this, relative to the extent, counts as on it: its rod would be flat.
LEAST_HEIGHT = 1e-9
#: Largest distance of a contact from the center, in extents of the support: no object's handle is longer.
FARTHEST = 500.0
#: Allowed points and normals, and remedy.
PAIR = "two finite numbers", "give x and y in the object's frame"


def scene_at(
    point: npt.ArrayLike,
    normal: npt.ArrayLike | None = None,
    *,
    effects: Sequence[Effect],
    contact: ContactLaw,
    outline: Any = None,
    units: Units | None = None,
) -> Scene:
    """The scene of an object that is pushed at a point, with everything in the object's own frame.

    Parameters
    ----------
    point : (x, y), or array of shape S + (2,)
        The contact; an array makes an array of scenes. In a DataArray the last dimension holds x and y, and
        the scenes extend over the others.
    normal : (n_x, n_y), or array of shape S + (2,), optional
        Normal of the fence or of the finger's side, into the object, of any length. It can be omitted if
        the object has an outline and the contact is not at a corner.
    effects : sequence of effects
        `SupportFriction`, `Viscous`, `Inertia` and `Load`, with supports, centers and forces in the
        object's frame.
    contact : ContactLaw
    outline : sequence of pairs, or an object with `coords` or `exterior`, optional
        Corners of the object in order. The contact must be on the outline, and the normal that of its side.
    units : Units, optional
        Names of the units, for results.

    Returns
    -------
    Scene
        In the fence frame: origin at the contact, +y along the normal, +x the normal rotated by -90
        degrees. Use `Scene.to_object` to transform results back. An array of scenes has no outline, because
        the outline differs between body frames.

    Raises
    ------
    InvalidValue
        If the normal is zero or points out of the object, the point is not on the outline, or an effect
        cannot be placed in an object's frame.

    Notes
    -----
    The slider's center c is the center of pressure, or the center of mass of a scene with inertia alone. If
    it is not above the fence, as for a hook, c is instead the point above the contact at the height of the
    support's extent. The rod goes from the contact to c.
    """
    if required_array("point", point, *PAIR).ndim > 1:
        return scenes_at(point, normal, partial(
            scene_at, effects=effects, contact=contact, outline=outline, units=units
        ))  # fmt: skip
    if normal is not None and required_array("normal", normal, *PAIR).shape != (2,):
        raise InvalidValue("normal", normal, *PAIR)
    if outline is None:
        place, side, corners = _free(point, normal), None, None
    else:
        corners = required_outline(outline)
        place, side = placed(point, normal, corners)
    listed = _required_effects(effects)
    center, extent = _middle(listed)
    body, length, angle = _body(place, np.array(center), extent)
    _require_one_unit(length, extent)
    slider = Slider(
        rod_length=length, rod_angle=angle,
        radius=None if any(hasattr(each, "support") for each in listed) else extent,
        outline=None if corners is None else [moved_place(each, body) for each in corners],
        **({} if side is None else {"side": side}),
    )  # fmt: skip
    loaded = [_with_center(each, center, listed) for each in listed]
    moved = tuple(each.moved(body, place.fence) for each in loaded)
    return Scene(slider=slider, contact=contact, effects=moved, placement=place, units=units)


def _require_one_unit(length: float, extent: float) -> None:
    """Refuse a contact so far from the support that the units of length must differ."""
    if not length <= FARTHEST * extent:
        raise InvalidValue(
            "point", f"a contact {length:.6g} from the center of a support of size {extent:.6g}",
            f"at most {FARTHEST:g} times its size", "give all lengths in one unit",
        )  # fmt: skip


def _free(point: Any, normal: Any) -> Placement:
    if normal is None:
        raise InvalidValue(
            "normal",
            None,
            "(n_x, n_y) without an outline",
            "give the inward normal",
        )
    return Placement(point, normal)


def _required_effects(given: Any) -> tuple[Any, ...]:
    """Effects that can be moved, or `InvalidValue`."""
    found = tuple(given) if isinstance(given, (list, tuple)) else ()
    if not found or not all(hasattr(each, "moved") for each in found):
        raise InvalidValue(
            "effects", given, "a sequence of SupportFriction, Viscous, Inertia and Load",
            "list what resists the motion; for a ring give the radius: SupportFriction(support=Ring(1.0))",
        )  # fmt: skip
    return found


def _with_center(effect: Any, center: Array, effects: tuple[Any, ...]) -> Any:
    """A load with the object's center as default point: the slider's center differs for a hook."""
    if not isinstance(effect, Load) or effect.center is not None:
        return effect
    if any(isinstance(each, Inertia) for each in effects):
        return effect
    return replace(effect, center=(float(center[0]), float(center[1])))


def _middle(effects: tuple[Any, ...]) -> tuple[Array, float]:
    """Center and extent of an object in its frame: of friction, otherwise viscous friction, or mass."""
    friction = [each for each in effects if isinstance(each, SupportFriction)]
    films = [each for each in effects if isinstance(each, Viscous)]
    masses = [each for each in effects if isinstance(each, Inertia)]
    if friction or films:
        resting = friction or films
        loads = np.array([each.weight for each in friction] or [each.coefficient for each in films])
        centers = np.array([each.support.center_of_pressure for each in resting])
        return loads @ centers / loads.sum(), float(extents(resting[0].support))
    if not masses:
        raise InvalidValue(
            "effects", effects, "friction or inertia among them", "list what resists the motion"
        )
    loads = np.array([each.mass for each in masses])
    return loads @ np.array([each.center for each in masses]) / loads.sum(), masses[
        0
    ].gyration_radius


def _body(place: Placement, center: Array, extent: float) -> tuple[Frame, float, float]:
    """The body frame in the object's frame, and the length and angle of the rod."""
    along, height = place.fence.point_in(center).tolist()
    if height <= LEAST_HEIGHT * extent:
        along, height = 0.0, extent
    length = float(np.hypot(along, height))
    x, y = place.fence.vector_out((along / length, height / length)).tolist()
    c_x, c_y = place.fence.point_out((along, height)).tolist()
    return Frame((c_x, c_y), (x, y)), length, float(np.arctan2(height, along))
