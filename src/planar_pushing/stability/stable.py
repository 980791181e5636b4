"""Whether a flat side of an object stays on a fence that moves and rotates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, overload

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.effects import Effect, Load, RingFriction, SupportFriction, Viscous
from planar_pushing.mechanics.force.held import require_held
from planar_pushing.mechanics.plane import Array, Frame, direction
from planar_pushing.mechanics.rows import extents
from planar_pushing.mechanics.scene import Scene, require_scene, require_single
from planar_pushing.mechanics.supports import Ring
from planar_pushing.objects.resistance import feet_of, motion_at, without_feet
from planar_pushing.objects.wrench_set import ROUNDING
from planar_pushing.terms.domain import Scalar
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import require_array

if TYPE_CHECKING:
    import xarray as xr

#: The fence frame in itself.
FENCE = Frame((0.0, 0.0), (1.0, 0.0))
TWIST = (
    "finite numbers of shape S + (3,)",
    "give (v_x, v_y, omega) of the fence in the object's frame",
)


@overload
def stable(scene: Scene, twist: tuple[Scalar, Scalar, Scalar] | list[float]) -> bool: ...
@overload
def stable(scene: Scene, twist: npt.NDArray[Any]) -> bool | npt.NDArray[np.bool_]: ...
@overload
def stable(
    scene: Scene, twist: Sequence[Sequence[Scalar] | npt.NDArray[Any]] | xr.DataArray
) -> npt.NDArray[np.bool_]: ...
def stable(scene: Scene, twist: Any) -> Any:
    """Whether a flat side stays on a fence that moves and rotates: the object moves with the fence.

    Parameters
    ----------
    scene : Scene
        Its side lies on the fence, as in ``scene_at(side=...)``. Without inertia.
    twist : array_like, shape S + (3,)
        (v_x, v_y, omega) of the fence, omega in radians per unit of time and 0 for a translation: about the
        origin of the object's frame and in it, which without a placement is the body frame. The magnitude
        matters only with viscous friction.

    Returns
    -------
    bool, or ndarray of bool of shape S

    Raises
    ------
    InvalidValue
        If the side is not on the fence, the scene has inertia or is an array of scenes, friction cannot
        hold a load, or a twist is not three finite numbers or is zero.

    Notes
    -----
    A push is stable if the load of the twist is in the cone of forces at the two ends of the side: the
    force is within the contact law's cone, and its line of action crosses the side (Lynch and Mason,
    "Stable pushing: mechanics, controllability, and planning", IJRR 15(6), 1996). If the object turns about
    a foot, the loads are a set, and all of it has to be in the cone: the push that is known to be stable
    whatever the foot does. The edges of the cone belong to it unless the law says otherwise, and a force
    within rounding of an edge is on it. With `PerfectlyRough`, which can pull at both ends, every push is
    stable.
    """
    flush = require_flush(scene)
    twists = _required_twists(twist)
    if flush.law.rough:
        return np.ones(twists.shape[:-1], dtype=bool) if twists.ndim > 1 else True
    is_stable = _are_stable(flush, twists.reshape(-1, 3)).reshape(twists.shape[:-1])
    return is_stable if twists.ndim > 1 else bool(is_stable)


def require_flush(scene: Any) -> Scene:
    """A single scene without inertia whose side lies on the fence, or `InvalidValue`."""
    single = require_single(require_scene(scene))
    if not single.slider.flush:
        raise InvalidValue(
            "scene", "a scene with one point of contact", "a scene whose side lies on the fence",
            "make it with scene_at(side=...), or with Slider(side=(a, b), flush=True)",
        )  # fmt: skip
    if single.stores_energy:
        raise InvalidValue(
            "scene", "a scene with inertia", "a scene whose motion is a velocity, without Inertia",
            "leave Inertia out of its effects: a stable push is quasi-static",
        )  # fmt: skip
    require_held(single)
    return single


def _required_twists(value: Any) -> Array:
    twists = require_array("twist", value, *TWIST)
    if twists.shape[-1:] != (3,) or not np.isfinite(twists).all():
        raise InvalidValue("twist", value, *TWIST)
    if not twists.any(axis=-1).all():
        raise InvalidValue(
            "twist",
            value,
            "twists that are not zero",
            "give a motion: at rest every load is possible",
        )
    return twists


def effects_in_fence(scene: Scene) -> tuple[Effect, ...]:
    """The effects of a scene without inertia, with supports and points in the fence frame."""
    fence = fence_in_body(scene)
    return tuple(
        _with_own_geometry(effect, scene).in_frames(fence, FENCE) for effect in scene.effects
    )


def fence_in_body(scene: Scene) -> Frame:
    """The fence frame in the body frame."""
    (x, y), (c, s) = scene._center.tolist(), direction(scene.slider.rod_angle).tolist()
    return Frame((x, y), (c, s)).inverse


def _with_own_geometry(effect: Any, scene: Scene) -> Any:
    """The effect with all that it takes from its slider: the radius of a ring, the point of a load."""
    if isinstance(effect, Load):
        return replace(effect, center=(0.0, 0.0)) if effect.center is None else effect
    ring = Ring(float(scene.slider.radius))
    if isinstance(effect, RingFriction):
        return SupportFriction(support=ring, weight=effect.weight)
    support = effect.support
    return (
        replace(effect, support=ring)
        if isinstance(support, Ring) and support.radius is None
        else effect
    )


def cone_at_ends(scene: Scene) -> Array:
    """Rows that are nonnegative on the wrenches that the ends can exert, shape (4, 3).

    Wrenches are about the fence's origin. Their force is left of the right edge of the law's cone and right
    of its left edge; the normal forces at the end and at the start are not negative.
    """
    (right_x, right_y), (left_x, left_y) = direction([scene.law.right, scene.law.left])
    start, end = scene.slider.side
    return np.array(
        [[-right_y, right_x, 0.0], [left_y, -left_x, 0.0], [0.0, -start, 1.0], [0.0, end, -1.0]]
    )


def _are_stable(scene: Scene, twists: Array) -> npt.NDArray[np.bool_]:
    """Whether twists of the object about its origin, shape (n, 3), are stable."""
    # Scaled to about 1 so that squares neither overflow nor underflow; a power of two is exact.
    _, powers = np.frexp(np.abs(twists).max(axis=-1, keepdims=True))
    moved = scene.to_fence(np.ldexp(twists, -powers), "twist")
    x, y = scene._center
    moved = moved + moved[:, 2:] * np.array([y, -x, 0.0])
    # A force of degree d is multiplied by a motion's size to the power d - 1.
    scales = {1: np.ldexp(1.0, -np.maximum(powers, 0)), 2: np.ldexp(1.0, np.minimum(powers, 0))}
    effects = effects_in_fence(scene)
    feet, reach = feet_of(effects), _reach(scene, effects)
    loads, shares = _friction_of_feet(feet, moved, reach)
    loads, size = scales[1] * loads, 0.0
    for effect in effects:
        loads = loads + scales[effect.degree] * without_feet(effect, effects, moved)
        size = size + scales[effect.degree] * _size(effect, moved, reach)
    rows = cone_at_ends(scene)
    # The smallest value of a row over the forces of a foot, (g, r x g) with |g| at most its share.
    x, y = feet[:, :1], feet[:, 1:2]
    foot_margins = np.hypot(rows[:, 0] - rows[:, 2] * y, rows[:, 1] + rows[:, 2] * x)
    margins = loads @ rows.T - scales[1] * (shares @ foot_margins)
    rounding = ROUNDING * size * (np.hypot(rows[:, 0], rows[:, 1]) + reach * np.abs(rows[:, 2]))
    within = margins >= -rounding
    if not scene.law.closed:
        within[:, :2] = (margins > rounding)[:, :2]
    return np.asarray(within.all(axis=-1))


def _friction_of_feet(feet: Array, twists: Array, reach: float) -> tuple[Array, Array]:
    """Wrenches of the feet that slide, shape (n, 3), and the shares of those at rest, shape (n, feet)."""
    motion = motion_at(twists.T[..., None], feet[:, :2])
    speed = np.hypot(motion[..., 0], motion[..., 1])
    rests = speed <= ROUNDING * reach * np.abs(twists[:, 2:])
    force = motion * (np.where(rests, 0.0, feet[:, 2] / np.where(rests, 1.0, speed)))[..., None]
    torque = feet[:, 0] * force[..., 1] - feet[:, 1] * force[..., 0]
    sliding = np.concatenate([force.sum(axis=1), torque.sum(axis=1)[:, None]], axis=-1)
    return sliding, np.where(rests, feet[:, 2], 0.0)


def _reach(scene: Scene, effects: tuple[Any, ...]) -> float:
    """Largest distance of the side and of the supports from the fence's origin."""
    supports = [effect.support for effect in effects if not isinstance(effect, Load)]
    far = [
        float(np.hypot(*support.center_of_pressure)) + float(extents(support))
        for support in supports
    ]
    start, end = scene.slider.side
    return float(max(-start, end, *far))


def _size(effect: Any, twists: Array, reach: float) -> Any:
    """Size of the forces of an effect, whose rounding errors are relative to it; shape () or (n, 1)."""
    if isinstance(effect, Load):
        return float(np.hypot(*effect.force))
    if isinstance(effect, Viscous):
        speed = np.hypot(twists[:, :1], twists[:, 1:2]) + reach * np.abs(twists[:, 2:])
        return effect.coefficient * speed
    return effect.weight
