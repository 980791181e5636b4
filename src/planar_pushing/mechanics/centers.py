"""Motion centers of the slider, exactly and by the paper's seven cases (Sec. 4)."""

from __future__ import annotations

from enum import StrEnum
from math import asin, copysign, inf, nan, pi
from typing import TYPE_CHECKING, Literal, overload

from planar_pushing.mechanics.angles import AngleInterval, interval
from planar_pushing.mechanics.compiled import compiled, kernel, owning
from planar_pushing.mechanics.cones import (
    direction_in,
    force_columns,
    sight_in,
    under_force,
    unit_columns,
)
from planar_pushing.mechanics.effects.base import count_fields
from planar_pushing.mechanics.numerics.arrays import Output, evaluated, is_labeled
from planar_pushing.mechanics.plane import (
    Array,
    center_from,
    contact_motion_angle,
    moment_arm,
    rod,
    seen,
)
from planar_pushing.mechanics.scene import Scene, required_scene
from planar_pushing.terms.domain import Number, Numbers, Scalar, required_ratio
from planar_pushing.terms.errors import InvalidValue, require_option
from planar_pushing.terms.units import named_units

if TYPE_CHECKING:
    import xarray as xr


class Origin(StrEnum):
    """The point to which positions are relative."""

    CONTACT = "contact"
    SLIDER_CENTER = "slider-center"


#: The enum, or its value.
OriginName = Origin | Literal["contact", "slider-center"]
CENTER = (Output("center", (("xy", 2),)),)
CONE = (Output("conservative_cone_right"), Output("conservative_cone_left"))


@kernel
@owning
def _centers(kinds, rows, centers):
    """After the directions a row holds the radius, and the rod's length from the origin of the centers."""
    last = count_fields(kinds) + 4
    for i in range(len(rows)):
        effects, own, at, force, ratio = under_force(kinds, rows[i])
        found, radius, reach = (
            direction_in(effects, own, at, force, ratio),
            rows[i, last],
            rows[i, last + 1],
        )
        v_x, v_y = found.v_x * own.x - found.v_y * own.y, found.v_x * own.y + found.v_y * own.x
        x, y = center_from(v_x, v_y, found.spin) if found.found else (nan, nan)
        centers[i, 0], centers[i, 1] = radius * (x + reach * own.x), radius * (y + reach * own.y)


@overload
def motion_centers(
    scene: Scene,
    force_angle: Scalar | Numbers,
    inertia_share: Scalar | Numbers | None = None,
    origin: OriginName = Origin.CONTACT,
    force_ratio: Scalar | Numbers | None = None,
) -> Array: ...
@overload
def motion_centers(
    scene: Scene,
    force_angle: xr.DataArray,
    inertia_share: Scalar | Numbers | xr.DataArray | None = None,
    origin: OriginName = Origin.CONTACT,
    force_ratio: Scalar | Numbers | xr.DataArray | None = None,
) -> xr.DataArray: ...
@overload
def motion_centers(
    scene: Scene,
    force_angle: Scalar | Numbers,
    inertia_share: xr.DataArray,
    origin: OriginName = Origin.CONTACT,
) -> xr.DataArray: ...
@overload
def motion_centers(
    scene: Scene,
    force_angle: Scalar | Numbers,
    inertia_share: None = None,
    origin: OriginName = Origin.CONTACT,
    *,
    force_ratio: xr.DataArray,
) -> xr.DataArray: ...
def motion_centers(
    scene: Scene,
    force_angle: Number,
    inertia_share: Number | None = None,
    origin: OriginName = Origin.CONTACT,
    force_ratio: Number | None = None,
) -> Number:
    """Motion centers, shape S + (2,), in the unit of the slider's lengths.

    A translation has its center at infinity. For inertia alone the centers lie on one line, the dual of
    the contact (Fig. 9).

    Parameters
    ----------
    scene : Scene
    force_angle : float or array, shape S
        phi, radians.
    inertia_share, force_ratio : float or array, optional
        As in `spin_ratio`, which raises the same errors.
    origin : {"contact", "slider-center"}
        The point to which the centers are relative.

    Returns
    -------
    ndarray or DataArray
        A DataArray if an argument, or a parameter of the scene, is one.
    """
    origin = require_option("origin", origin, Origin, "name one of these points")
    columns = force_columns(scene, force_angle, inertia_share, force_ratio)
    reach = scene.slider.length_ratio if origin == Origin.CONTACT else 0.0
    found = evaluated(_centers, scene.kinds, [*columns, scene.slider.radius, reach], CENTER)[0]
    return named_units(found, scene.units) if is_labeled(found) else found


@compiled
def conservative_spin_ratios(arm):
    """Limits of the spin ratio in the paper's seven cases, for a moment arm in units of R.

    The motion center is inside the ring (1 .. inf) for a line of force outside it, on the ring for a
    tangent line, outside it (0 .. 1) for a line through the ring, and at infinity (0) for a line through
    the ring center. It lies across the ring center from the line, so negative arms mirror the cases.
    """
    size = abs(arm)
    near = 1.0 if size >= 1.0 else 0.0
    far = inf if size > 1.0 else 0.0 if size == 0.0 else 1.0
    return copysign(near, arm), copysign(far, arm)


@compiled
def _widened(own, force, ratio, right, left):
    angle = contact_motion_angle(own, force, ratio)
    return min(right, angle), max(left, angle)


@compiled
def _conservative(own, low, high):
    """Bounds of the motion angle over the lines of force from `low` to `high`.

    At a fixed spin ratio the motion angle increases with the force angle, so a bound is attained on an
    edge of the friction cone or where the line of force touches the ring. On such a tangent the cases on
    both sides meet: the spin ratio takes every value from 0 to infinity.
    """
    right, left = inf, -inf
    for edge in (low, high):
        force = seen(own, edge)
        for ratio in conservative_spin_ratios(moment_arm(own, force)):
            right, left = _widened(own, force, ratio, right, left)
    if own.length <= 1.0:
        return right, left
    lean = asin(1.0 / own.length)
    for first in (lean, -lean, pi - lean, lean - pi):
        for turn in (-2.0 * pi, 0.0, 2.0 * pi):
            tangent = own.angle - (first + turn)
            if low < tangent < high:
                force = seen(own, tangent)
                for size in (0.0, inf):
                    ratio = copysign(size, force.aside)
                    right, left = _widened(own, force, ratio, right, left)
    return right, left


@kernel
@compiled
def _conservative_cones(kinds, rows, right, left):
    for i in range(len(rows)):
        sight = sight_in(rows[i], count_fields(kinds))
        own = rod(sight.length, sight.angle)
        right[i], left[i] = _conservative(own, sight.first, sight.second)


def conservative_motion_cone(scene: Scene) -> AngleInterval:
    """The paper's bound on the contact's motion with both effects, radians (Fig. 12).

    Returns
    -------
    AngleInterval
        For a labeled scene an xarray.Dataset, as in `friction_cone`.

    Raises
    ------
    InvalidValue
        If an effect alone does not turn the slider about a point of the ring under a tangent force, as
        facts 5-7 of Sec. 4 assume: with inertia, the radius of gyration must be the ring's radius.
    """
    if not required_scene(scene).isotropic:
        raise InvalidValue(
            "effects", scene.effects, "effects that are isotropic about the slider's center",
            "use motion_cone, which is exact for every support",
        )  # fmt: skip
    if scene.stores_energy:
        required_ratio("conservative_gyration", scene.inertia[1] ** 0.5)
    law = scene.law
    columns, rod_columns = unit_columns(scene)
    columns += [*rod_columns, law.right, law.left]
    right, left = evaluated(_conservative_cones, scene.kinds, columns, CONE)
    cone: AngleInterval = interval(right, left, closed=False)
    return cone
