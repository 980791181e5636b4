"""A scene: a slider, a contact law and the effects that resist the motion."""

from __future__ import annotations

import math
from dataclasses import dataclass

from planar_pushing.mechanics.contact import ContactLaw
from planar_pushing.mechanics.effects.base import IsotropicEffect
from planar_pushing.mechanics.errors import InvalidValue, require_number, require_positive
from planar_pushing.mechanics.planar import LONGEST


@dataclass(frozen=True, slots=True, kw_only=True)
class Slider:
    """A ring with a massless rod, pushed at the rod's free end (Fig. 1).

    Parameters
    ----------
    rod_length : float
        l >= 0, from the contact to the ring centre.
    rod_angle : float
        psi between the fence and the rod, radians, in (0, pi).
    radius : float
        R > 0; all lengths are in any one unit.

    Raises
    ------
    InvalidValue
        Where a parameter is out of range, or the rod longer than `planar.LONGEST` radii.
    """

    rod_length: float
    rod_angle: float
    radius: float = 1.0

    def __post_init__(self) -> None:
        require_number(
            "rod_length", self.rod_length, lambda x: 0 <= x < math.inf,
            "a finite number >= 0", "give the distance from the contact to the ring centre",
        )  # fmt: skip
        require_number(
            "rod_angle", self.rod_angle, lambda x: 0 < x < math.pi,
            "radians in the open interval (0, pi)", "keep the slider above the fence",
        )  # fmt: skip
        require_positive(
            "radius", self.radius, "give the ring's radius in the unit of the rod length"
        )
        require_number(
            "rod_length", self.rod_length, lambda _: self.length_ratio <= LONGEST,
            f"at most {LONGEST:g} times the radius",
            "give the radius and the rod length in one unit",
        )  # fmt: skip

    @property
    def length_ratio(self) -> float:
        """Rod length in units of the radius, l / R."""
        return float(self.rod_length) / float(self.radius)


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene:
    """What is pushed, through which contact, against which effects.

    Parameters
    ----------
    slider : Slider
    contact : ContactLaw
        `Coulomb`, `InfiniteFriction` or `PerfectlyRough`.
    effects : tuple of effects
        At least one of `RingFriction` and `Inertia`; an absent effect is never evaluated.

    Raises
    ------
    InvalidValue
        Where no effect is listed, or something else than an effect or a law is given.
    """

    slider: Slider
    contact: ContactLaw
    effects: tuple[IsotropicEffect, ...]

    def __post_init__(self) -> None:
        if not isinstance(self.contact, ContactLaw) or isinstance(self.contact, type):
            raise InvalidValue(
                "contact", self.contact, "Coulomb, InfiniteFriction or PerfectlyRough",
                "construct one of these laws",
            )  # fmt: skip
        effects = tuple(self.effects) if isinstance(self.effects, (tuple, list)) else ()
        known = all(hasattr(each, "degree") and not isinstance(each, type) for each in effects)
        if not effects or not known:
            raise InvalidValue(
                "effects", self.effects, "a tuple of at least one of RingFriction and Inertia",
                "list what resists the motion, for instance (RingFriction(),)",
            )  # fmt: skip
        object.__setattr__(self, "effects", effects)
        _ = self.scaled_effects  # refuses an effect out of proportion to the slider

    @property
    def scaled_effects(self) -> tuple[IsotropicEffect, ...]:
        """The effects in lengths scaled by the slider's radius."""
        return tuple(effect.scaled(self.slider.radius) for effect in self.effects)  # type: ignore[misc]
