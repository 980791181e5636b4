"""A scene: a slider, a contact law and the effects that resist the motion."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.contact import LAWS, ContactLaw, Law, as_numbers, is_law
from planar_pushing.mechanics.effects import (
    Effect,
    Inertia,
    Load,
    RingFriction,
    SupportFriction,
    Viscous,
)
from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.pictures import picture
from planar_pushing.mechanics.plane import Array, Frame, Kind, Placement, change_frame, direction
from planar_pushing.mechanics.rows import Rows, extents, is_own_ring
from planar_pushing.mechanics.slider import Slider
from planar_pushing.terms.domain import Number, require_in_range, require_ratio
from planar_pushing.terms.errors import InvalidValue, require_kind
from planar_pushing.terms.numbers import pair_of
from planar_pushing.terms.units import Units

if TYPE_CHECKING:
    import xarray as xr


#: The laws that are known not to be arrays of laws.
KINDS_OF_LAWS = {*LAWS.values()}


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
        is_one = type(self.contact) in KINDS_OF_LAWS
        laws = [self.contact] if is_one else np.ravel(np.asarray(self.contact, dtype=object))
        if not len(laws) or not all(map(is_law, laws)):
            raise InvalidValue(
                "contact", self.contact, "Coulomb, InfiniteFriction or PerfectlyRough",
                "construct one of these laws",
            )  # fmt: skip
        effects = tuple(self.effects) if isinstance(self.effects, (tuple, list)) else ()
        kinds = SupportFriction | RingFriction | Inertia | Viscous | Load
        if not effects or not all(isinstance(effect, kinds) for effect in effects):
            raise InvalidValue(
                "effects", self.effects,
                "a tuple of SupportFriction, RingFriction, Inertia, Viscous and Load",
                "list what resists the motion, for instance (RingFriction(),)",
            )  # fmt: skip
        effects = tuple(_complete(effect, self.slider) for effect in effects)
        object.__setattr__(self, "effects", effects)
        if self.slider.radius is None:
            supports = [effect.support for effect in self.effects if hasattr(effect, "support")]
            radius = extents(supports[0]) if supports else 1.0
            object.__setattr__(self, "slider", self.slider.with_radius(radius))
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
        return change_frame(value, kind, self._object, self._center, into=True)

    def to_fence(self, value: npt.ArrayLike, kind: Kind) -> Array:
        """Transform numbers from the object's frame to the fence frame; the inverse of `to_object`."""
        return change_frame(value, kind, self._object, self._center, into=False)

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
        return [
            effect for effect in self.effects if isinstance(effect, (SupportFriction, RingFriction))
        ]

    @property
    def viscous(self) -> list[Viscous]:
        """The effects of viscous friction."""
        return [effect for effect in self.effects if isinstance(effect, Viscous)]

    @cached_property
    def loads(self) -> tuple[Load, ...]:
        """The loads."""
        return tuple(effect for effect in self.effects if isinstance(effect, Load))

    @property
    def masses(self) -> list[Inertia]:
        """The effects of inertia, which store energy."""
        return [effect for effect in self.effects if isinstance(effect, Inertia)]

    @cached_property
    def stores_energy(self) -> bool:
        """Whether an effect has inertia."""
        return bool(self.masses)

    @property
    def isotropic(self) -> bool:
        """Whether every support is the slider's own ring, and every center of mass the slider's center."""
        if any(_is_off(coordinate) for mass in self.masses for coordinate in mass.center):
            return False
        return all(is_own_ring(effect.support, self.slider.radius) for effect in self.friction)

    @property
    def resisting(self) -> list[int]:
        """Indices of the effects that act in a push from rest.

        A slider with inertia has no velocity then, and therefore no viscous friction.
        """
        absent = Viscous if self.stores_energy else ()
        return [i for i, effect in enumerate(self.effects) if not isinstance(effect, absent)]

    def __getstate__(self) -> dict[str, Any]:
        """The fields of the scene; a copy in another process computes its own rows."""
        return {part.name: getattr(self, part.name) for part in fields(self)}

    @cached_property
    def rows(self) -> Rows:
        """The effects of a push from rest in the form of the core."""
        return Rows.of(self)

    @property
    def weight(self) -> Number:
        """W = mu_s m g, the weight times the coefficient of support friction; 1 without friction."""
        return sum(effect.weight for effect in self.friction) if self.friction else 1.0

    @property
    def inertia(self) -> tuple[Number, Number]:
        """Total mass, and its squared radius of gyration in radii."""
        heavy = self.masses
        if not heavy:
            return 1.0, 1.0
        mass, radius = sum(effect.mass for effect in heavy), self.slider.radius
        ratios = [
            require_ratio("gyration_ratio", effect.gyration_radius / radius) ** 2
            for effect in heavy
        ]
        if len(heavy) == 1:
            return mass, ratios[0]
        center = self.mass_center
        moment = 0.0
        for effect, ratio in zip(heavy, ratios, strict=True):
            arm = [
                coordinate / radius - mean
                for coordinate, mean in zip(effect.center, center, strict=True)
            ]
            moment = moment + effect.mass * (ratio + arm[0] ** 2 + arm[1] ** 2)
        return mass, moment / mass

    @property
    def mass_center(self) -> tuple[Number, Number]:
        """Center of mass in the body frame, in radii."""
        if not self.masses:
            return 0.0, 0.0
        total = self.slider.radius * sum(effect.mass for effect in self.masses)
        x, y = (
            sum(effect.mass * effect.center[i] for effect in self.masses) / total for i in (0, 1)
        )
        return x, y

    @cached_property
    def law(self) -> Any:
        """The contact law in numbers."""
        return as_numbers(self.contact)

    @property
    def cone(self) -> Law:
        """The contact law in numbers of a contact that sticks.

        At an inner corner, the cone is the sum of those of both sides. If its edges are more than 180
        degrees apart, it contains every force.
        """
        law: Law = self.law
        pocket = self.slider.pocket
        if type(pocket) is float and pocket == 0.0:
            return law
        right, left = law.right - pocket, law.left + pocket
        rough = left - right > math.pi
        right, left = (
            edge * (1 - rough) + end * rough
            for edge, end in ((right, -math.pi / 2), (left, 3 * math.pi / 2))
        )
        return law._replace(right=right, left=left, rough=law.rough | rough)


def _complete(effect: Effect, slider: Slider) -> Effect:
    """A mass without a center has it at the slider's center, the origin of the body frame.

    Without a radius of gyration, it is a uniform plate in the shape of the slider's outline.
    """
    if not isinstance(effect, Inertia):
        return effect
    mass = replace(effect, center=(0.0, 0.0)) if effect.center is None else effect
    return mass.with_gyration(slider.outline, slider.outline_frame)


def _is_off(coordinate: Number) -> bool:
    """Whether a coordinate, or any entry of an array, is nonzero."""
    if isinstance(coordinate, float):
        return coordinate != 0.0
    return bool(np.any(np.asarray(coordinate) != 0))


def _required_push(value: Any) -> tuple[Number, Number]:
    """Angle and magnitude of a push, or `InvalidValue`."""
    pair = pair_of(value)
    if pair is None:
        raise InvalidValue("push", value, "(angle, magnitude)", "give the angle in radians")
    return require_in_range("pusher_angle", pair[0]), require_in_range("pusher_magnitude", pair[1])


def require_scene(value: object) -> Scene:
    """The argument if it is a scene, or `InvalidValue`."""
    return require_kind("scene", value, Scene, "read a file with load_scene, or construct one")


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


def require_point_scene(value: object) -> Scene:
    """The argument if it is a scene with a contact at one point, or `InvalidValue`."""
    return require_one_point(require_scene(value))


def require_flat_contact(scene: Scene) -> Scene:
    """The scene if no contact is at an inner corner, or `InvalidValue`."""
    if np.any(np.asarray(scene.slider.pocket) > 0.0):
        raise InvalidValue(
            "scene", "a contact at an inner corner", "contacts with one side",
            "move the contact off the corner: there it touches two sides",
        )  # fmt: skip
    return scene


def require_single(scene: Scene) -> Scene:
    """The scene if its parameters are scalars, or `InvalidValue`."""
    slider = scene.slider
    rod = slider.rod_length, slider.rod_angle, slider.radius, *slider.side
    if any(map(np.ndim, (*rod, *scene.rows.columns, *scene.law))):
        raise InvalidValue(
            "scene", "an array of scenes", "one scene, whose parameters are numbers",
            "take the scenes one by one, or call simulate_batch",
        )  # fmt: skip
    return scene
