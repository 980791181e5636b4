"""A scene from an object in its own frame: supports, masses and contact in the user's coordinates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.contact import ContactLaw
from planar_pushing.mechanics.effects import Effect, Inertia, Load, SupportFriction, Viscous
from planar_pushing.mechanics.kernels.arrays import require_alike
from planar_pushing.mechanics.outline import Outline, require_outline
from planar_pushing.mechanics.plane import Array, Frame, Placement, positions_in_frame
from planar_pushing.mechanics.rows import extents
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.slider import SAME, Slider
from planar_pushing.mechanics.supports import Ring
from planar_pushing.objects.many import Contacts, require_contacts
from planar_pushing.objects.on_outline import on_outline, side_on_fence
from planar_pushing.objects.plausible import warn_of_doubts
from planar_pushing.objects.resistance import center_of_pressure, complete_masses, mass_center
from planar_pushing.terms.caches import cache_results
from planar_pushing.terms.domain import Number
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.units import Units

#: A center closer to the fence than this, relative to the extent, counts as on it: its rod would be flat.
MINIMUM_HEIGHT = 1e-9
#: Number of objects whose centers and extents are kept.
KEPT = 64
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
        The contact; an array makes an array of scenes, each with one contact. Several contacts at once are
        a problem of `solve_contacts`. In a DataArray the last dimension holds x and y, and the scenes
        extend over the others.
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
        object's frame. A mass without a center is at the center of pressure; without friction, it is at the
        centroid of the outline, or without one at the origin. A mass without a radius of gyration has that
        of a uniform plate in the shape of the outline, about its center of mass, or 1 without an outline.
        Parameters can be arrays that broadcast against the points.
    contact : ContactLaw
    outline : sequence of pairs, Polygon, Disc, Outline, or an object with `coords` or `exterior`, optional
        Corners of the object in order, or its round outline. The contact must be on the outline, and the
        normal that of its side or arc.
        The outline is exact to a millionth of its size: a vertex that close to the one before, or to a
        straight side, is no corner, and a contact that close to a corner is there. At an inner corner a
        point touches two sides; its normal is the bisector of theirs.
    units : Units, optional
        Names of the units, for results.

    Returns
    -------
    Scene
        In the fence frame: origin at the contact, +y along the normal, +x the normal rotated by -90
        degrees. A side on the fence has its origin at its midpoint; the scene's slider is then flush, and
        its side ends where the outline leaves the fence's line. Use `Scene.to_object` to transform results
        back. All scenes of an array have the object's outline, each with its own body frame.

    Warns
    -----
    SceneWarning
        If more than a hundredth of a support's pressure lies outside the outline, by more than a hundredth
        of its size; a radius of gyration is less than 0.05 or more than 2 times that of the support and of
        the outline; two effects are equal; or a coefficient of friction is larger than 10.

    Raises
    ------
    InvalidValue
        If the normal is zero, points out of the object or is not that of its place, the point is not on the
        outline, there is no such side, a fence along the side would pass through the object, an effect
        cannot be placed in an object's frame, or shapes do not match.

    Notes
    -----
    The slider's center c is the center of pressure, or the center of mass of a scene with inertia alone. If
    it is not above the fence, as for a hook, c is instead the point above the contact at the height of the
    support's extent. The rod goes from the contact to c.
    """
    scene, whole = place_object(point, normal, side, effects, contact, outline, units)
    warn_of_doubts(effects, contact, whole)
    return scene


def place_object(
    point: Any,
    normal: Any,
    side: Any,
    effects: Any,
    contact: Any,
    outline: Any,
    units: Any = None,
) -> tuple[Scene, Outline | None]:
    """The scene of `scene_at`, and the outline in the object's frame; without warnings."""
    flush, whole = side is not None, None
    if flush:
        _require_side_alone(point, normal, outline)
        placement, ends, whole = side_on_fence(side, outline)
        contacts = Contacts(placement, placement.point, placement.normal)
    else:
        contacts = require_contacts(*_required_point(point, normal))
        if outline is None:
            placement, ends = _free(contacts)
        else:
            whole = require_outline(outline)
            placement, ends = on_outline(contacts, whole)
    acting = require_effects(effects, whole)
    require_alike([placement.point[0], *_numbers_of(acting), *_numbers_of_law(contact)])
    contacts = contacts._replace(placement=placement)
    center, extent = measure_object(acting)
    if any(map(np.ndim, (*center, extent))):
        contacts, (x, y, extent) = contacts.repeat(*center, extent)
        center = x, y
    placement, many = contacts.placement, bool(contacts.shape)
    _require_no_films(acting, many)
    length, angle, body = _place_rods(contacts, center, extent)
    slider = Slider(
        rod_length=length,
        rod_angle=angle,
        # That of the support in the object's frame: it is the same number at every contact, one or many.
        radius=extent,
        side=ends,
        flush=flush,
        outline=whole,
        outline_frame=SAME if whole is None else body,
    )
    loaded = [with_center(effect, center, acting) for effect in acting]
    scene_effects = tuple(effect.in_frames(body, placement.fence) for effect in loaded)
    scene = Scene(
        slider=slider, contact=contact, effects=scene_effects, placement=placement, units=units
    )
    return scene, whole


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


def _place_rods(
    contacts: Contacts, center: tuple[Number, Number], extent: Number
) -> tuple[Number, Number, Frame]:
    """Lengths and angles of the rods, and the body frames in the object's frame."""
    fence = contacts.placement.fence
    if all(type(number) is float for number in (*fence.axis, *center, extent)):
        return _place_rod(fence, center, extent)
    rods = _rods(fence, center, extent)
    _require_one_unit(rods.length, extent)
    body = Frame(contacts.pair(rods.origin), contacts.pair(rods.axis))
    return contacts.number(rods.length), contacts.number(rods.angle), body


def _place_rod(
    fence: Frame, center: tuple[float, float], extent: float
) -> tuple[float, float, Frame]:
    """As `_place_rods`, for one contact: the same numbers, in a tenth of the time."""
    (x, y), (a, b) = fence
    ((along, height),) = positions_in_frame([center], fence)
    if height <= MINIMUM_HEIGHT * extent:
        along, height = 0.0, extent
    length, angle = float(np.hypot(along, height)), float(np.arctan2(height, along))
    if not length <= FARTHEST * extent:
        _require_one_unit(np.array([length]), extent)
    t, n = along / length, height / length
    origin = along * a - height * b + x, height * a + along * b + y
    return length, angle, Frame(origin, (t * a - n * b, n * a + t * b))


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


def _require_one_unit(lengths: Array, extent: Number) -> None:
    """Refuse a contact so far from the support that the units of length must differ."""
    far = ~(lengths <= FARTHEST * np.ravel(extent))
    if far.any():
        sizes = np.broadcast_to(np.ravel(extent), lengths.shape)
        raise InvalidValue(
            "point",
            f"a contact {lengths[far][0]:.6g} from the center of a support of size {sizes[far][0]:.6g}",
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


def require_effects(value: Any, outline: Outline | None) -> tuple[Any, ...]:
    """Effects of an object, all with supports and centers, or `InvalidValue`."""
    effects = tuple(value) if isinstance(value, (list, tuple)) else ()
    if not effects or not all(hasattr(effect, "in_frames") for effect in effects):
        raise InvalidValue(
            "effects", value, "a sequence of SupportFriction, Viscous, Inertia and Load",
            "list what resists the motion; for a ring give the radius: SupportFriction(support=Ring(1.0))",
        )  # fmt: skip
    return _acting_effects(effects, outline)


@cache_results(KEPT)
def _acting_effects(effects: tuple[Any, ...], outline: Outline | None) -> tuple[Any, ...]:
    """Effects with known masses, found once for all contacts of an object; errors of their supports."""
    for effect in effects:
        _require_one_support(effect, outline)
    return complete_masses(effects, outline)


def _require_one_support(effect: Any, outline: Outline | None) -> None:
    """Refuse an array of supports, and a ring whose radius nothing tells."""
    support = getattr(effect, "support", None)
    if np.ndim(np.array(support, dtype=object)):
        raise InvalidValue("support", support, "one support", "make the scenes one by one")
    if isinstance(support, Ring) and support.radius is None:
        uniform = "outline" if outline and outline.corners else "outline.vertices(tolerance)"
        whole = "" if outline is None else f", or support=Polygon({uniform}) for the whole outline"
        raise InvalidValue(
            "support", support, "the object's support, which has no default",
            f"give it: a ring with its radius, as in support=Ring(1.0){whole}",
        )  # fmt: skip


def _require_no_films(effects: tuple[Any, ...], many: bool) -> None:
    """Refuse viscous friction of an array of scenes."""
    films = [effect for effect in effects if isinstance(effect, Viscous)]
    if many and films:
        raise InvalidValue(
            "effects", films[0], "effects without viscous friction for an array of contacts",
            "make the scenes one by one",
        )  # fmt: skip


def _numbers_of(effects: Sequence[Any]) -> list[Number]:
    """All numbers of effects, which can be arrays."""
    names = ("weight", "coefficient", "mass", "gyration_radius", "center", "force")
    values = [getattr(effect, name, None) for effect in effects for name in names]
    pairs = [value if isinstance(value, tuple) else (value,) for value in values]
    return [number for pair in pairs for number in pair if number is not None]


def _numbers_of_law(contact: Any) -> list[Any]:
    """The coefficients of a law, and an array of the shape of an array of laws."""
    laws = contact if hasattr(contact, "dims") else np.asarray(contact, dtype=object)
    return [laws if np.ndim(laws) else getattr(contact, "friction_coefficient", 0.0)]


def with_center(effect: Any, center: tuple[Number, Number], effects: tuple[Any, ...]) -> Any:
    """A load with the object's center as default point: the slider's center differs for a hook."""
    if not isinstance(effect, Load) or effect.center is not None:
        return effect
    if any(isinstance(other, Inertia) for other in effects):
        return effect
    return replace(effect, center=center)


@cache_results(KEPT)
def measure_object(effects: tuple[Any, ...]) -> tuple[tuple[Number, Number], Number]:
    """Center and extent of an object in its frame: of friction, else of viscous friction, else of mass."""
    center = center_of_pressure(effects)
    if center is not None:
        kinds = (SupportFriction, Viscous)
        resting = [effect for kind in kinds for effect in effects if isinstance(effect, kind)]
        return center, float(extents(resting[0].support))
    masses = [effect for effect in effects if isinstance(effect, Inertia)]
    if not masses:
        raise InvalidValue(
            "effects", effects, "friction or inertia among them", "list what resists the motion"
        )
    return mass_center(effects), masses[0].gyration_radius


def _rods(fences: Frame, center: tuple[Number, Number], extent: Number) -> Rods:
    """The rods from contacts to the object's center."""
    origin, axis = (tuple(map(np.ravel, pair)) for pair in fences)
    fence, sizes = Frame((origin[0], origin[1]), (axis[0], axis[1])), np.ravel(extent)
    along, height = fence.point_in(np.array([np.ravel(part) for part in center]).T).T
    low = height <= MINIMUM_HEIGHT * sizes
    if low.any():
        along, height = np.where(low, 0.0, along), np.where(low, sizes, height)
    rod, length = np.array([along, height]).T, np.hypot(along, height)
    angle = np.arctan2(height, along)
    return Rods(fence.point_out(rod), fence.vector_out(rod / length[:, None]), length, angle)
