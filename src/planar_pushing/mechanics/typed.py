"""Types of functions of force angles: the type of the result follows the arguments."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Protocol, overload

from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.terms.domain import Numbers, Scalar

if TYPE_CHECKING:
    import xarray as xr


class OfForce(Protocol):
    """A function of a scene, force angles, and an inertia share or a magnitude of the force."""

    __name__: str

    @overload
    def __call__(
        self, scene: Scene, force_angle: Scalar, inertia_share: Scalar | None = None,
        force_ratio: Scalar | None = None,
    ) -> float: ...  # fmt: skip
    @overload
    def __call__(
        self, scene: Scene, force_angle: Numbers, inertia_share: Scalar | Numbers | None = None,
        force_ratio: Scalar | Numbers | None = None,
    ) -> Array: ...  # fmt: skip
    @overload
    def __call__(self, scene: Scene, force_angle: Scalar, inertia_share: Numbers) -> Array: ...
    @overload
    def __call__(
        self, scene: Scene, force_angle: Scalar, inertia_share: None = None, *, force_ratio: Numbers
    ) -> Array: ...
    @overload
    def __call__(
        self, scene: Scene, force_angle: xr.DataArray,
        inertia_share: Scalar | Numbers | xr.DataArray | None = None,
        force_ratio: Scalar | Numbers | xr.DataArray | None = None,
    ) -> xr.DataArray: ...  # fmt: skip
    @overload
    def __call__(
        self, scene: Scene, force_angle: Scalar | Numbers, inertia_share: xr.DataArray
    ) -> xr.DataArray: ...
    @overload
    def __call__(
        self, scene: Scene, force_angle: Scalar | Numbers, inertia_share: None = None, *,
        force_ratio: xr.DataArray,
    ) -> xr.DataArray: ...  # fmt: skip


def of_force(function: Callable[..., Any]) -> OfForce:
    """The same function, with the types of `OfForce`."""
    typed: OfForce = function
    return typed
