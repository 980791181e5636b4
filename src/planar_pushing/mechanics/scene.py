"""A scene: a slider, a contact law and the effects that resist the motion."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.arrays import same
from planar_pushing.mechanics.contact import ContactLaw, as_numbers, is_law
from planar_pushing.mechanics.effects import (
    Effect,
    Inertia,
    Load,
    RingFriction,
    SupportFriction,
    Viscous,
)
from planar_pushing.mechanics.outline import required_outline
from planar_pushing.mechanics.pictures import picture
from planar_pushing.mechanics.plane import Array, Frame, Kind, Placement, changed, direction
from planar_pushing.mechanics.rows import Rows, extents, is_own_ring
from planar_pushing.terms.declared import (
    NUMBER,
    PAIR,
    Declaration,
    Degrees,
    Read,
    Within,
    nonnegative,
    positive,
    require_declared,
)
from planar_pushing.terms.domain import (
    RADIANS,
    TO_RADIANS,
    TURNS,
    Number,
    required,
    required_ratio,
)
from planar_pushing.terms.errors import InvalidValue, as_floats, require_flag, require_kind
from planar_pushing.terms.numbers import pair_of
from planar_pushing.terms.units import Units

if TYPE_CHECKING:
    import xarray as xr


#: The angle of the rod; the slider's center is above the fence.
ROD_ANGLE = Degrees(
    lambda x: (x > 0) & (x < math.pi), "radians in the open interval (0, pi)",
    "keep the slider above the fence; convert degrees to radians with np.deg2rad",
    degrees=Within(
        lambda x: 0 < x < 180, "degrees in the open interval (0, 180)",
        "keep the slider above the fence",
        {"type": "number", "exclusiveMinimum": 0, "exclusiveMaximum": 180},
    ),
)  # fmt: skip
ENDS = (
    "(start, end) with start < 0 < end, infinite for a side without an end",
    "measure both ends along the side from the contact, which is between them, the one toward -x first",
)
START, END = Within(lambda x: x < 0, *ENDS), Within(lambda x: x > 0, *ENDS)


class Side(Declaration):
    """Ends of a side, measured along it from the contact, which is between them."""

    words = ENDS[0]
    schema = PAIR | {"items": {"anyOf": [NUMBER, {"enum": ["inf", "-inf"]}]}}

    def required(self, name: str, given: Any) -> tuple[Number, Number]:
        pair = pair_of(given)
        if pair is None:
            raise InvalidValue(name, given, *ENDS)
        ends = START.required(name, pair[0]), END.required(name, pair[1])
        if any(0 in np.shape(each) for each in ends):
            raise InvalidValue(name, given, *ENDS)
        return ends

    def read(self, given: Any) -> tuple[float, float]:
        start, end = pair_of(given) or (None, None)
        try:
            return START.read(start), END.read(end)
        except InvalidValue:
            raise InvalidValue("", given, *ENDS) from None

    def to_file(self, value: tuple[Number, Number]) -> list[float] | None:
        ends = [float(each) for each in value]
        return ends if any(map(math.isfinite, ends)) else None


SIDE = Side()
FLAG = Read(require_flag, "true or false", {"type": "boolean"})
OUTLINE = Read(
    lambda name, given: required_outline(given, name), "the corners of a simple polygon, in order",
    {"type": "array", "minItems": 3, "items": PAIR},
)  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Slider:
    """A body with a massless rod, pushed at the rod's free end (Fig. 1).

    Parameters
    ----------
    rod_length : float or array
        l >= 0, from the contact to the slider's center, at most a million radii.
    rod_angle : float or array
        psi between the fence and the rod, radians, in (0, pi).
    radius : float or array, optional
        R > 0; all lengths share one arbitrary unit. By default a scene sets it to the largest distance of
        its support from the center of pressure, or to 1 for a ring.
    side : (start, end), of floats or arrays
        Ends of the flat side that a finger pushes, measured from the contact along the side, which at time
        0 is along the fence. They have no effect on a fence, unless the side lies on it.
    flush : bool
        Whether the side lies on the fence: the contact is the whole side, between its ends, which must be
        finite. Its place, from which the rod goes, is then only the origin of the ends.
    outline : sequence of pairs, optional
        Corners of the slider in the body frame, in order; by default the outline is unknown. In a
        simulation a fence touches every corner and side of the outline. Under a finger, the simulation ends
        when another point of the outline meets the finger, or when this reaches the end of its side.

    Raises
    ------
    InvalidValue
        If a parameter is out of range, the side does not contain the contact, the ends of a flush side are
        not finite, or the outline is not a simple polygon.
    """

    rod_length: Annotated[
        Number, nonnegative("give the distance from the contact to the slider's center")
    ]
    rod_angle: Annotated[Number, ROD_ANGLE]
    radius: Annotated[Number, positive("give it in the unit of the rod length")] = None
    side: Annotated[tuple[Number, Number], SIDE] = (-math.inf, math.inf)
    flush: Annotated[bool, FLAG] = False
    outline: Annotated[Any, OUTLINE] = None

    def __post_init__(self) -> None:
        require_declared(self)
        if self.flush and not all(bool(np.all(np.isfinite(end))) for end in self.side):
            raise InvalidValue(
                "side", self.side, "finite ends (start, end) of a side that lies on the fence",
                "measure both ends along the fence, or leave flush out",
            )  # fmt: skip
        if self.radius is not None:
            _ = self.length_ratio

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    @property
    def length_ratio(self) -> Number:
        """Rod length in units of the radius, l / R."""
        if self.radius is None:
            raise InvalidValue(
                "radius", None, "a number, given or filled in by a scene", "ask the slider of a scene",
            )  # fmt: skip
        return required_ratio("length_ratio", self.rod_length / self.radius)


@dataclass(frozen=True, kw_only=True)  # no slots: rows and law are cached
class Scene:
    """A slider, the contact through which it is pushed, and the effects that resist the motion.

    Parameters
    ----------
    slider : Slider
        A missing radius is filled in.
    contact : ContactLaw, or array of laws
        `Coulomb`, `InfiniteFriction` or `PerfectlyRough`.
    effects : tuple of effects
        At least one of `SupportFriction`, its short form `RingFriction`, and `Inertia`; an absent effect is
        never evaluated.
    placement : Placement, optional
        Contact in the object's own frame, as set by `scene_at`; by default that frame is the body frame.
    units : Units, optional
        Names of the units of the scene's numbers, for labeled results and logs.
    push : (angle, magnitude), optional
        Default push of `solve` and `draw`, as set by scene files, with the angle in radians.

    Raises
    ------
    InvalidValue
        If no effect is listed, an effect or a law is of another type, or the push is out of range.

    Notes
    -----
    Parameters of slider, law and effects can be arrays, which are broadcast: the scene is then an array of
    scenes, and every function of the mechanics returns an array.
    """

    slider: Slider
    contact: ContactLaw | list[Any] | npt.NDArray[Any] | xr.DataArray
    effects: tuple[Effect, ...]
    placement: Placement | None = None
    units: Units | None = None
    push: tuple[float, float] | None = field(default=None, compare=False)

    def __post_init__(self) -> None:
        require_kind("slider", self.slider, Slider)
        laws = np.ravel(np.asarray(self.contact, dtype=object))
        if not len(laws) or not all(map(is_law, laws)):
            raise InvalidValue(
                "contact", self.contact, "Coulomb, InfiniteFriction or PerfectlyRough",
                "construct one of these laws",
            )  # fmt: skip
        effects = tuple(self.effects) if isinstance(self.effects, (tuple, list)) else ()
        kinds = SupportFriction | RingFriction | Inertia | Viscous | Load
        if not effects or not all(isinstance(each, kinds) for each in effects):
            raise InvalidValue(
                "effects", self.effects,
                "a tuple of SupportFriction, RingFriction, Inertia, Viscous and Load",
                "list what resists the motion, for instance (RingFriction(),)",
            )  # fmt: skip
        object.__setattr__(self, "effects", effects)
        if self.slider.radius is None:
            supports = [each.support for each in self.effects if hasattr(each, "support")]
            radius = extents(supports[0]) if supports else 1.0
            object.__setattr__(self, "slider", replace(self.slider, radius=radius))
        _ = self.inertia
        if self.push is not None:
            object.__setattr__(self, "push", _required_push(self.push))
        for name, kind in (("placement", Placement), ("units", Units)):
            if getattr(self, name) is not None:
                require_kind(name, getattr(self, name), kind)

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def to_object(self, value: npt.ArrayLike, kind: Kind) -> Array:
        """Transform numbers from the fence frame at time 0 to the object's frame.

        Parameters
        ----------
        value : array_like, shape S + (2,) or S + (3,)
            A vector or a point in the fence frame, or a twist or a wrench in it at the slider's center, as
            returned by `solve`.
        kind : {"vector", "point", "twist", "wrench"}

        Returns
        -------
        ndarray, of the same shape
            In the object's frame; twists and wrenches about its origin. Without a placement the object's
            frame is the body frame.

        Raises
        ------
        InvalidValue
            If the shape does not match the kind.
        """
        return changed(value, kind, self._object, self._center, into=True)

    def to_fence(self, value: npt.ArrayLike, kind: Kind) -> Array:
        """Transform numbers from the object's frame to the fence frame; the inverse of `to_object`."""
        return changed(value, kind, self._object, self._center, into=False)

    @property
    def _center(self) -> Array:
        """The slider's center in the fence frame, shape S + (2,)."""
        return np.asarray(self.slider.rod_length)[..., None] * direction(self.slider.rod_angle)

    @property
    def _object(self) -> Frame:
        """The object's frame in the fence frame."""
        if self.placement is not None:
            return self.placement.fence.inverse
        center, axis = self._center, direction(self.slider.rod_angle)
        return Frame((center[..., 0], center[..., 1]), (axis[..., 0], axis[..., 1]))

    def _repr_svg_(self) -> str | None:
        """Picture of the slider with its cones, for a notebook."""
        return picture("scene", self)

    @property
    def friction(self) -> list[Any]:
        """The effects of Coulomb friction."""
        return [each for each in self.effects if isinstance(each, (SupportFriction, RingFriction))]

    @property
    def viscous(self) -> list[Viscous]:
        """The effects of viscous friction."""
        return [each for each in self.effects if isinstance(each, Viscous)]

    @property
    def loads(self) -> list[Load]:
        """The loads."""
        return [each for each in self.effects if isinstance(each, Load)]

    @property
    def masses(self) -> list[Inertia]:
        """The effects of inertia, which store energy."""
        return [each for each in self.effects if isinstance(each, Inertia)]

    @property
    def stores_energy(self) -> bool:
        """Whether an effect has inertia."""
        return bool(self.masses)

    @property
    def isotropic(self) -> bool:
        """Whether every support is the slider's own ring, and every center of mass the slider's center."""
        if any(_is_off(coordinate) for each in self.masses for coordinate in each.center):
            return False
        return all(is_own_ring(each.support, self.slider.radius) for each in self.friction)

    @property
    def resisting(self) -> list[int]:
        """Indices of the effects that act in a push from rest.

        A slider with inertia has no velocity then, and therefore no viscous friction.
        """
        absent = Viscous if self.stores_energy else ()
        return [i for i, each in enumerate(self.effects) if not isinstance(each, absent)]

    def __getstate__(self) -> dict[str, Any]:
        """The fields of the scene; a copy in another process computes its own rows."""
        return {each.name: getattr(self, each.name) for each in fields(self)}

    @cached_property
    def rows(self) -> Rows:
        """The effects of a push from rest in the form of the core."""
        return Rows.of(self)

    @property
    def weight(self) -> Number:
        """W = mu_s m g, the weight times the coefficient of support friction; 1 without friction."""
        return sum(each.weight for each in self.friction) if self.friction else 1.0

    @property
    def inertia(self) -> tuple[Number, Number]:
        """Total mass, and its squared radius of gyration in radii."""
        heavy = self.masses
        if not heavy:
            return 1.0, 1.0
        mass, radius = sum(each.mass for each in heavy), self.slider.radius
        ratios = [
            required_ratio("gyration_ratio", each.gyration_radius / radius) ** 2 for each in heavy
        ]
        if len(heavy) == 1:
            return mass, ratios[0]
        center = self.mass_center
        moment = 0.0
        for each, ratio in zip(heavy, ratios, strict=True):
            apart = [own / radius - mean for own, mean in zip(each.center, center, strict=True)]
            moment = moment + each.mass * (ratio + apart[0] ** 2 + apart[1] ** 2)
        return mass, moment / mass

    @property
    def mass_center(self) -> tuple[Number, Number]:
        """Center of mass in the body frame, in radii."""
        if not self.masses:
            return 0.0, 0.0
        whole = self.slider.radius * sum(each.mass for each in self.masses)
        x, y = (sum(each.mass * each.center[i] for each in self.masses) / whole for i in (0, 1))
        return x, y

    @cached_property
    def law(self) -> Any:
        """The contact law in numbers."""
        return as_numbers(self.contact)


def _is_off(coordinate: Number) -> bool:
    """Whether a coordinate, or any entry of an array, is nonzero."""
    if isinstance(coordinate, float):
        return coordinate != 0.0
    return bool(np.any(np.asarray(coordinate) != 0))


def _required_push(given: Any) -> tuple[Number, Number]:
    """Angle and magnitude of a push, or `InvalidValue`."""
    pair = pair_of(given)
    if pair is None:
        raise InvalidValue("push", given, "(angle, magnitude)", "give the angle in radians")
    return required("pusher_angle", pair[0]), required("pusher_magnitude", pair[1])


def required_scene(given: object) -> Scene:
    """The argument if it is a scene, or `InvalidValue`."""
    return require_kind("scene", given, Scene, "read a file with load_scene, or construct one")


def require_one_point(
    scene: Scene,
    name: str = "scene",
    remedy: str = "call solve or stable, or make the scene by scene_at(point=...)",
) -> Scene:
    """The scene if its contact is one point, or `InvalidValue` for a side that lies on the fence.

    Parameters
    ----------
    scene : Scene
    name, remedy : str
        What is refused, and what to do instead.
    """
    if scene.slider.flush:
        raise InvalidValue(
            name, "a side that lies on the fence", "a scene with a contact at one point", remedy
        )
    return scene


def required_point_scene(given: object) -> Scene:
    """The argument if it is a scene with a contact at one point, or `InvalidValue`."""
    return require_one_point(required_scene(given))


def required_single(scene: Scene) -> Scene:
    """The scene if its parameters are scalars, or `InvalidValue`."""
    slider = scene.slider
    rod = slider.rod_length, slider.rod_angle, slider.radius, *slider.side
    if any(map(np.ndim, (*rod, *scene.rows.columns, *scene.law))):
        raise InvalidValue(
            "scene", "an array of scenes", "one scene, whose parameters are numbers",
            "take the scenes one by one, or call simulate_batch",
        )  # fmt: skip
    return scene


#: A pose: x, y, and the angle in radians.
Pose = tuple[float, float, float]


class World(NamedTuple):
    """The world frame over time.

    Attributes
    ----------
    fence : Frame
        The fence frame at time 0, in the world.
    origin : ndarray, shape (2,)
        Origin of the object's frame, in the body frame.
    angle : float
        Angle of the object in the world minus the rod angle, a constant.
    """

    fence: Frame
    origin: Array
    angle: float

    def object_pose(self, position: Array, rod_angle: Array) -> tuple[Array, Array]:
        """Positions of the object in the world, shape S + (2,), and angles in degrees, shape S.

        Parameters
        ----------
        position : ndarray, shape S + (2,)
            The slider's center in the fence frame of time 0.
        rod_angle : ndarray, shape S
            Radians.
        """
        body = Frame((position[..., 0], position[..., 1]), (np.cos(rod_angle), np.sin(rod_angle)))
        place = self.fence.point_out(body.point_out(self.origin))
        return place, np.asarray(np.rad2deg(rod_angle + self.angle))


def world_of(scene: Scene, pose: Pose) -> World:
    """The world of a scene whose object has this pose at time 0."""
    x, y, angle = pose
    own = _frame((x, y), direction(angle))
    origin = own.point_out(scene.to_object((0.0, 0.0), "point"))
    fence = _frame(origin, own.vector_out(scene.to_object((1.0, 0.0), "vector")))
    rod, length = float(scene.slider.rod_angle), float(scene.slider.rod_length)
    body = _frame(length * direction(rod), direction(rod))
    return World(fence, body.point_in(scene.to_fence((0.0, 0.0), "point")), angle - rod)


def _frame(origin: Any, axis: Any) -> Frame:
    return Frame((float(origin[0]), float(origin[1])), (float(axis[0]), float(axis[1])))


def required_pose(given: Any) -> Pose:
    """A pose as floats, or `InvalidValue`."""
    pose = as_floats(given)
    if len(pose) != 3 or not all(map(math.isfinite, pose)):
        raise InvalidValue(
            "object_pose", given, "(x, y, angle) of finite numbers",
            "give the pose of the object's frame in the world at time 0, the angle in radians",
        )  # fmt: skip
    x, y, angle = pose
    if abs(angle) > TURNS:
        raise InvalidValue("object_pose", given, f"an angle in {RADIANS}", TO_RADIANS)
    return x, y, angle
