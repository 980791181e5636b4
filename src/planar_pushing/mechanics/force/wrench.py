"""Potential and wrench of an effect at given twists, and the two functions of the ring, elementwise."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from planar_pushing.core.instant.solution import Twist
from planar_pushing.mechanics.contact import PerfectlyRough
from planar_pushing.mechanics.effects import Effect, Load
from planar_pushing.mechanics.kernels.arrays import Output, map_kernel
from planar_pushing.mechanics.kernels.columns import row_of
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.rows import data_of, entries_of
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.slider import Slider
from planar_pushing.terms.domain import require_in_range
from planar_pushing.terms.errors import InvalidValue

NO_DATA = np.zeros(0)
WRENCH = (Output("wrench", (("wrench_component", 3),)),)


def wrench(effect: Effect, twist: npt.ArrayLike, slider: Slider | None = None) -> Array:
    """Wrench at the slider's center that sustains twists, the gradient of the effect's potential.

    Parameters
    ----------
    effect : SupportFriction, RingFriction, Viscous, Inertia or Load
    twist : array_like, shape S + (3,)
        (v_x, v_y, omega) at the slider's center, in the body frame, omega in radians per unit of time.
    slider : Slider, optional
        Provides the radius of the ring, 1 by default, and for a load the angle of the body frame.

    Returns
    -------
    ndarray, shape S + (3,)
        (f_x, f_y, tau). At rest, where friction sustains any wrench inside the limit surface, its wrench is
        zero.

    Raises
    ------
    InvalidValue
        If a twist does not have three numbers, or a load is given without a slider.
    """
    if slider is None and isinstance(effect, Load):
        raise InvalidValue("slider", None, "a Slider for a Load", "give the angle of the rod")
    slider = slider or Slider(rod_length=0.0, rod_angle=np.pi / 2)
    scene = Scene(slider=slider, contact=PerfectlyRough(), effects=(effect,))
    radius = scene.slider.radius
    twists = np.asarray(require_in_range("twist", twist), dtype=float)
    if twists.shape[-1:] != (3,):
        raise InvalidValue("twist", twist, "shape S + (3,)", "give (v_x, v_y, omega)")
    # Scaled to about 1 so that squares neither overflow nor underflow; a power of two is exact.
    _, size = np.frexp(np.abs(twists).max(axis=-1, keepdims=True))
    v_x, v_y, omega = np.moveaxis(np.ldexp(twists, -size), -1, 0)
    entries = entries_of(enumerate(scene.effects), scene)
    columns = [*entries[0].columns, *row_of(Twist, x=v_x, y=v_y, spin=radius * omega)]
    wrenches = map_kernel("wrenches", data_of(entries), columns, WRENCH)[0]
    wrenches[..., 2] *= radius
    return np.asarray(np.ldexp(wrenches, (effect.degree - 1) * size))


def potential(effect: Effect, twist: npt.ArrayLike, slider: Slider | None = None) -> Array:
    """Potential at twists, shape S: the power of friction, or the kinetic energy.

    A potential of degree d is the power of its wrench divided by d.

    Parameters
    ----------
    effect : SupportFriction, RingFriction, Viscous, Inertia or Load
    twist : array_like, shape S + (3,)
        (v_x, v_y, omega) at the slider's center, omega in radians per unit of time.
    slider : Slider, optional
        As in `wrench`.
    """
    force = wrench(effect, twist, slider)
    return np.asarray((np.asarray(twist, dtype=float) * force).sum(axis=-1) / effect.degree)


def ring_profile(spin_ratio: npt.ArrayLike) -> tuple[Array, Array]:
    """f(k) and t(k) of Eqs. (2)-(3), per unit weight and radius, for any k including infinity."""
    force, torque = map_kernel(
        "ring_profiles", NO_DATA, [spin_ratio], (Output("force"), Output("torque"))
    )
    return force, torque


def ring_spin_ratios(moment_arm: npt.ArrayLike) -> Array:
    """Spin ratios under forces with these moment arms in radii: the inverse of ``t(k) / f(k)`` (Eq. 7)."""
    return map_kernel("ring_spin_ratios", NO_DATA, [moment_arm], (Output("spin_ratio"),))[0]
