"""Inertia: the quadratic potential of a mass that starts from rest (Eqs. 8-10)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.plane import Frame, position_in_frame
from planar_pushing.terms.declared import Pair, finite, positive, replace_checked, require_declared
from planar_pushing.terms.numbers import Number
from planar_pushing.terms.options import EffectKind

if TYPE_CHECKING:
    from planar_pushing.mechanics.outline import Outline

NONE = "leave the effect out of the scene if the slider has no inertia"


@dataclass(frozen=True, slots=True, kw_only=True)
class Inertia:
    """Inertia of the slider: ``m (v^2 + rho^2 omega^2) / 2``.

    Parameters
    ----------
    mass : float or array
        m > 0.
    gyration_radius : float or array, optional
        rho > 0 about the center of mass, in the unit of the slider's lengths. By default that of a uniform
        plate in the shape of the outline, holes included: about its centroid, or, if the center of mass is
        elsewhere, about that center by the parallel axis theorem, ``rho^2 = rho_plate^2 + distance^2``.
        Without an outline it is 1.
    center : (x, y), of floats or arrays, optional
        Center of mass, in the object's frame for `scene_at` and in the body frame for `Scene`. By default,
        in the object's frame, the center of pressure, above which the center of mass of a slow object is;
        without friction, the centroid of the outline, or without one the origin. In the body frame, by
        default the slider's center, which is the origin; x is along the rod and away from the contact.

    Raises
    ------
    InvalidValue
        If a parameter is not a positive finite number, or the center is not two finite numbers.
    """

    kind: ClassVar = EffectKind.INERTIA
    mass: Annotated[Number, positive(NONE)] = 1.0
    gyration_radius: Annotated[Any, positive(NONE)] = None
    center: Annotated[
        Any,
        Pair(finite("give x and y of the center of mass in the object's frame, or leave it out")),
    ] = None

    def __post_init__(self) -> None:
        require_declared(self)

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def in_frames(self, body: Frame, fence: Frame) -> Inertia:
        """The same effect expressed in the body frame instead of the object's frame."""
        center = None if self.center is None else position_in_frame(self.center, body)
        return replace_checked(self, center=center)

    @property
    def degree(self) -> int:
        return 2

    def with_gyration(self, outline: Outline | None, frame: Frame | None = None) -> Inertia:
        """The same effect with a radius of gyration; its center is known.

        Parameters
        ----------
        outline : Outline or None
        frame : Frame, optional
            That of the center, in the frame of the outline; by default the same.
        """
        if self.gyration_radius is not None:
            return self
        if outline is None:
            return replace_checked(self, gyration_radius=1.0)
        x, y = self.center
        if frame is not None:
            (origin_x, origin_y), (a, b) = frame
            x, y = x * a - y * b + origin_x, y * a + x * b + origin_y
        middle_x, middle_y = outline.centroid
        square = outline.gyration_radius**2 + (x - middle_x) ** 2 + (y - middle_y) ** 2
        return replace_checked(self, gyration_radius=square**0.5)
