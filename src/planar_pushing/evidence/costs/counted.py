"""Effects that count how often they are evaluated, and scenes and studies made of them."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
from typing import cast

import numpy as np
import numpy.typing as npt
from pydantic import Field

from planar_pushing.evidence.internals import Array, IsotropicEffect
from planar_pushing.mechanics.effects import Inertia, RingFriction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.study.fields import EffectsName
from planar_pushing.study.models import StudyFile

#: Names of the effects in the datasets.
NAMES: dict[type, str] = {RingFriction: "support_friction", Inertia: "inertia"}


@dataclass(frozen=True, slots=True)
class Counted:
    """An effect, and a tally of the points at which it is evaluated: a motion or a line of force each."""

    effect: IsotropicEffect
    tally: Counter[str]

    @property
    def degree(self) -> int:
        return self.effect.degree

    @property
    def kinks(self) -> tuple[float, ...]:
        return self.effect.kinks

    def scaled(self, *units: float) -> Counted:
        return replace(self, effect=cast(IsotropicEffect, self.effect.scaled(*units)))

    def potential(self, twist: Array) -> Array:
        return self._add(self.effect.potential(twist))

    def wrench(self, twist: Array) -> Array:
        wrench = self.effect.wrench(twist)
        self._add(wrench[..., 0])
        return wrench

    def profile(self, spin_ratio: npt.ArrayLike) -> tuple[Array, Array]:
        force, torque = self.effect.profile(spin_ratio)
        return self._add(force), torque

    def spin_ratio(self, moment_arm: npt.ArrayLike) -> Array:
        return self._add(self.effect.spin_ratio(moment_arm))

    def _add(self, values: Array) -> Array:
        self.tally[NAMES[type(self.effect)]] += int(np.size(values))
        return values


def counted_scene(scene: Scene, tally: Counter[str]) -> Scene:
    """Scene of the same effects, counted."""
    return replace(scene, effects=tuple(Counted(effect, tally) for effect in scene.effects))


class CountedStudy(StudyFile):
    """Study that builds counted effects."""

    tally: Counter[str] = Field(default_factory=Counter)

    def effects(self, name: EffectsName) -> tuple[IsotropicEffect, ...]:
        """Build the effects, counted."""
        return tuple(Counted(effect, self.tally) for effect in super().effects(name))
