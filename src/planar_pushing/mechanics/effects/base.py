"""The interface of an effect: a convex potential of the twist, whose gradient is the wrench.

Formulas work without dimensions: lengths in units of the slider's radius, a motion of an isotropic
effect as the centre's speed `v` and the rotation ``s = R omega``. A member of the family is a module: a
named tuple of numbers, and compiled functions of it by the names below. Effects add, so a scene holds a
tuple of those that it has.
"""

from __future__ import annotations

from collections.abc import Callable
from math import hypot
from typing import Any, Protocol

from planar_pushing.mechanics.compiled import compiled, generic, generic_owning, kernel, owning

#: Of each kind of effect, its module.
KINDS: dict[type, Any] = {}
#: Columns of an array of scenes that hold the effects: weight, mass, square of the radius of gyration,
#: centre of mass in the body frame, number of the support, and its extent in radii.
WEIGHT, MASS, GYRATION, MASS_X, MASS_Y, SUPPORT, SCALE = range(7)
COLUMNS = 7


class Effect(Protocol):
    """Something that resists the slider's motion, as users list it."""

    @property
    def degree(self) -> int:
        """Degree of homogeneity of the potential: 1 dissipates energy, 2 stores it."""
        ...


def member(kind: type, name: str) -> Callable[..., Any]:
    """A function of an effect's module."""
    found: Callable[..., Any] = getattr(KINDS[kind], name)
    return found


@generic
def response(kind: Any) -> Callable[..., Any]:
    """Gradient and second derivative of the potential at a motion (v, s) that is not rest.

    Parameters
    ----------
    effects : named tuple, or tuple of named tuples
        One effect, or several, which add.
    speed, spin : float
        ``v >= 0`` and ``s = R omega``.

    Returns
    -------
    force, torque, vv, vs, ss : float
        Force along the motion, torque, and the derivatives of both by v and s.
    """
    if isinstance(kind, tuple):
        return _single if len(kind) == 1 else _sum
    return member(kind, "response")


@compiled
def _single(effects, speed, spin):
    return response(effects[0], speed, spin)


@compiled
def _sum(effects, speed, spin):
    a, b, c, d, e = response(effects[0], speed, spin)
    f, g, h, i, j = response(effects[1:], speed, spin)
    return a + f, b + g, c + h, d + i, e + j


@generic
def wrench_of(kinds: Any) -> Callable[..., Any]:
    """Force and torque at a motion (v_x, v_y, s) of the origin that is not rest: effects, v_x, v_y, s.

    The frame is that of the motion; effects that are not isotropic see the body frame.
    """
    return _along_motion if hasattr(KINDS[kinds[0]], "response") else _of_gradient


@compiled
def _along_motion(effects, x, y, spin):
    speed = hypot(x, y)
    force, torque, _, _, _ = response(effects, speed, spin)
    if speed == 0.0:
        return 0.0, 0.0, torque
    return force * (x / speed), force * (y / speed), torque


@compiled
def _of_gradient(effects, x, y, spin):
    return gradient(effects, x, y, spin)[:3]


@generic
def scaled(kind: Any) -> Callable[..., Any]:
    """A mass times a factor: effect, factor."""
    return member(kind, "scaled")


@generic_owning
def made(kind: Any) -> Callable[..., Any]:
    """Effects of the kinds of a tuple, with the numbers of a row of an array of scenes."""
    if isinstance(kind, tuple):
        return _made_single if len(kind) == 1 else _made_all
    return member(kind, "made")


@kernel
@owning
def _made_single(effects, row):
    return (made(effects[0], row),)


@kernel
@owning
def _made_all(effects, row):
    return (made(effects[0], row), *made(effects[1:], row))


@generic
def spin_ratio_alone(kind: Any) -> Callable[..., Any]:
    """Spin ratio ``k = s / v`` of an effect that alone meets a force of a moment arm >= 0, in radii."""
    return member(kind, "spin_ratio")


@generic
def leverages_alone(kind: Any) -> Callable[..., Any]:
    """Least and greatest moment arm per spin ratio, ``h / k``, of an effect that is alone."""
    return member(kind, "leverages")


@generic
def gradient(kind: Any) -> Callable[..., Any]:
    """Gradient and second derivative of the potential at a motion (v_x, v_y, s) of the origin, body frame.

    Parameters
    ----------
    effects : named tuple, or tuple of named tuples
        One effect, or several, which add.
    x, y, spin : float
        Not all zero.

    Returns
    -------
    f_x, f_y, torque, xx, xy, yy, xs, ys, ss : float
        At an atom of the support its own force is left out.
    """
    if isinstance(kind, tuple):
        return _single_gradient if len(kind) == 1 else _sum_of_gradients
    return member(kind, "gradient")


@compiled
def _single_gradient(effects, x, y, spin):
    return gradient(effects[0], x, y, spin)


@compiled
def _sum_of_gradients(effects, x, y, spin):
    a, b, c, xx, xy, yy, xs, ys, ss = gradient(effects[0], x, y, spin)
    d, e, f, uu, uv, vv, us, vs, tt = gradient(effects[1:], x, y, spin)
    return a + d, b + e, c + f, xx + uu, xy + uv, yy + vv, xs + us, ys + vs, ss + tt


@generic
def wrench_about(kind: Any) -> Callable[..., Any]:
    """Force and torque about the origin of a rotation about a support point, whose own force is left out.

    Parameters are effect or effects, number of the point, spin, and place of the point in the body frame.
    """
    if isinstance(kind, tuple):
        return _single_wrench if len(kind) == 1 else _sum_of_wrenches
    return member(kind, "wrench_about")


@compiled
def _single_wrench(effects, i, spin, c_x, c_y):
    return wrench_about(effects[0], i, spin, c_x, c_y)


@compiled
def _sum_of_wrenches(effects, i, spin, c_x, c_y):
    a, b, c = wrench_about(effects[0], i, spin, c_x, c_y)
    d, e, f = wrench_about(effects[1:], i, spin, c_x, c_y)
    return a + d, b + e, c + f


@generic
def rough(kind: Any) -> Callable[..., Any]:
    """Centre, and square of the radius of gyration, of the mass that an effect roughly acts like."""
    return member(kind, "rough")


@generic
def fastest(kind: Any) -> Callable[..., Any]:
    """Greatest rotation that an effect alone may have, of a contact of unit speed; 0 for a mass.

    Parameters are effect and rod length.
    """
    return member(kind, "fastest")
