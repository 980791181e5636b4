"""One object at many contacts: an array of scenes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields, replace
from typing import Any

import numpy as np

from planar_pushing.mechanics.effects import Viscous
from planar_pushing.mechanics.frames import Placement
from planar_pushing.mechanics.numerics.arrays import is_labeled
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import required_array


def scenes_at(points: Any, normals: Any, make: Callable[[Any, Any], Scene]) -> Scene:
    """The scenes of one object at points of shape S + (2,), as a scene of arrays of shape S.

    Raises
    ------
    InvalidValue
        As in `make`, for the first contact that is refused; also if the shape differs, or the object has
        viscous friction, whose support cannot be an array.
    """
    places = required_array("point", points, "finite numbers", "give x and y")
    if places.shape[-1:] != (2,) or not places.size:
        raise InvalidValue(
            "point", places.shape, "shape S + (2,)", "give x and y along the last axis"
        )
    shape = places.shape[:-1]
    every = None if normals is None else _for_each("normal", normals, places.shape)
    scenes = [
        make(places[index], None if every is None else every[index]) for index in np.ndindex(shape)
    ]

    def array(values: Any) -> Any:
        """Values of the scenes over their dimensions."""
        found = np.empty(len(scenes), dtype=object)
        found[:] = values
        plain = found if not isinstance(values[0], (int, float)) else found.astype(float)
        return _labeled(plain.reshape(shape), points)

    def pair(values: Any) -> tuple[Any, Any]:
        return array([each[0] for each in values]), array([each[1] for each in values])

    first, sliders = scenes[0], [each.slider for each in scenes]
    slider = Slider(
        rod_length=array([each.rod_length for each in sliders]),
        rod_angle=array([each.rod_angle for each in sliders]),
        radius=first.slider.radius,
        side=pair([each.side for each in sliders]),
    )
    effects = tuple(
        _stacked([each.effects[k] for each in scenes], array, pair)
        for k in range(len(first.effects))
    )
    placement = Placement(
        pair([each.placement.point for each in scenes if each.placement]),
        pair([each.placement.normal for each in scenes if each.placement]),
    )
    return replace(first, slider=slider, effects=effects, placement=placement)


def _for_each(name: str, given: Any, shape: tuple[int, ...]) -> Any:
    """Vectors that are broadcast to the shape of the points."""
    vectors = required_array(name, given, "finite numbers", "give x and y")
    try:
        return np.broadcast_to(vectors, shape)
    except ValueError:
        remedy = "give one vector, or one for each point"
        raise InvalidValue(name, vectors.shape, f"shape (2,) or {shape}", remedy) from None


def _stacked(effects: list[Any], array: Callable[..., Any], pair: Callable[..., Any]) -> Any:
    """One effect of all scenes, with its support, center and force as arrays."""
    if isinstance(effects[0], Viscous):
        raise InvalidValue(
            "effects", effects[0], "effects without viscous friction for an array of contacts",
            "make the scenes one by one",
        )  # fmt: skip
    names = {each.name for each in fields(effects[0])}
    found: dict[str, Any] = {}
    if "support" in names:
        found["support"] = array([each.support for each in effects])
    for name in ("center", "force"):
        if name in names and getattr(effects[0], name) is not None:
            found[name] = pair([getattr(each, name) for each in effects])
    return replace(effects[0], **found)


def _labeled(values: Any, points: Any) -> Any:
    """Values over the dimensions of labeled points."""
    if not is_labeled(points):
        return values
    import xarray as xr

    coords = {
        name: each for name, each in points.coords.items() if points.dims[-1] not in each.dims
    }
    return xr.DataArray(values, dims=points.dims[:-1], coords=coords)
