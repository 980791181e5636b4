"""A scene: a slider, a contact law and the effects that resist the motion."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from planar_pushing.mechanics.contact.laws import as_numbers, is_law
from planar_pushing.mechanics.effects import Effect, Inertia, RingFriction
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.effects.support_friction import RingSupport
from planar_pushing.terms.domain import Number, require_fields, required_ratio
from planar_pushing.terms.errors import InvalidValue, require_kind


@dataclass(frozen=True, slots=True, kw_only=True)
class Slider:
    """A ring with a massless rod, pushed at the rod's free end (Fig. 1).

    Parameters
    ----------
    rod_length : float or array
        l >= 0, from the contact to the ring centre, at most a million radii.
    rod_angle : float or array
        psi between the fence and the rod, radians, in (0, pi).
    radius : float or array
        R > 0; all lengths are in any one unit.

    Raises
    ------
    InvalidValue
        Where a parameter is out of range.
    """

    rod_length: Number
    rod_angle: Number
    radius: Number = 1.0

    def __post_init__(self) -> None:
        require_fields(self, "rod_length", "rod_angle", "radius")
        _ = self.length_ratio

    @property
    def length_ratio(self) -> Number:
        """Rod length in units of the radius, l / R."""
        return required_ratio("length_ratio", self.rod_length / self.radius)


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene:
    """What is pushed, through which contact, against which effects.

    Parameters
    ----------
    slider : Slider
    contact : ContactLaw, or array of laws
        `Coulomb`, `InfiniteFriction` or `PerfectlyRough`.
    effects : tuple of effects
        At least one of `RingFriction` and `Inertia`; an absent effect is never evaluated.

    Raises
    ------
    InvalidValue
        Where no effect is listed, or something else than an effect or a law is given.

    Notes
    -----
    Parameters of slider, law and effects may be arrays, which are broadcast: the scene is then an array
    of scenes, and every function of the mechanics gives an array.
    """

    slider: Slider
    contact: Any
    effects: tuple[Effect, ...]

    def __post_init__(self) -> None:
        require_kind("slider", self.slider, Slider)
        laws = np.ravel(np.asarray(self.contact, dtype=object))
        if not len(laws) or not all(map(is_law, laws)):
            raise InvalidValue(
                "contact", self.contact, "Coulomb, InfiniteFriction or PerfectlyRough",
                "construct one of these laws",
            )  # fmt: skip
        effects = tuple(self.effects) if isinstance(self.effects, (tuple, list)) else ()
        if not effects or not all(isinstance(each, (RingFriction, Inertia)) for each in effects):
            raise InvalidValue(
                "effects", self.effects, "a tuple of at least one of RingFriction and Inertia",
                "list what resists the motion, for instance (RingFriction(),)",
            )  # fmt: skip
        object.__setattr__(self, "effects", effects)
        _ = self.inertia

    @property
    def friction(self) -> list[RingFriction]:
        """The effects that dissipate energy."""
        return [each for each in self.effects if isinstance(each, RingFriction)]

    @property
    def masses(self) -> list[Inertia]:
        """The effects that store energy."""
        return [each for each in self.effects if isinstance(each, Inertia)]

    @property
    def stores_energy(self) -> bool:
        """Whether an effect has inertia."""
        return bool(self.masses)

    @property
    def kinds(self) -> tuple[Any, ...]:
        """The effects in the compiled core, without their numbers: friction first."""
        found: tuple[Any, ...] = (RingSupport(1.0),) if self.friction else ()
        return (*found, Mass(1.0, 1.0)) if self.stores_energy else found

    @property
    def weight(self) -> Number:
        """Force of friction in a translation; 1 without friction, which then nothing reads."""
        return sum(each.weight for each in self.friction) if self.friction else 1.0

    @property
    def inertia(self) -> tuple[Number, Number]:
        """Mass, and square of the radius of gyration in radii; of several inertias together."""
        heavy = self.masses
        if not heavy:
            return 1.0, 1.0
        mass = sum(each.mass for each in heavy)
        ratios = [
            required_ratio("gyration_ratio", each.gyration_radius / self.slider.radius) ** 2
            for each in heavy
        ]
        if len(heavy) == 1:
            return mass, ratios[0]
        moment = sum(each.mass * ratio for each, ratio in zip(heavy, ratios, strict=True))
        return mass, moment / mass

    @property
    def law(self) -> Any:
        """The contact law in numbers."""
        return as_numbers(self.contact)


def required_scene(given: object) -> Scene:
    """The scene that was given, or `InvalidValue`."""
    return require_kind("scene", given, Scene, "read a file with load_scene, or construct one")


def required_single(scene: Scene) -> Scene:
    """The scene if its parameters are numbers, or `InvalidValue`."""
    slider = scene.slider
    rod = slider.rod_length, slider.rod_angle, slider.radius
    if any(map(np.ndim, (*rod, scene.weight, *scene.inertia, *scene.law))):
        raise InvalidValue(
            "scene", "an array of scenes", "one scene, whose parameters are numbers",
            "take the scenes one by one, or call simulate_batch",
        )  # fmt: skip
    return scene
