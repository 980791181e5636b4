r"""Geometry of the plane: frame, signs and the kinematics of a pushed slider.

::

                       ring (radius R, center c)
             y'  y   .-'''-.            psi   rod angle
               \ |  /   c   \           l     rod length, from the contact to the slider's center
                \|  \  /    /           phi   force angle: f points along (cos phi, sin phi)
                 |   `/....'            n     outward normal of the fence = +y
                 |   / rod              theta angle of a velocity or an acceleration
                 |  / ) psi             all angles from +x (the fence), counterclockwise
   --------------+-*----------- x
         fence     contact = free end of the rod, origin of all positions; slider above the fence

A twist is ``(v_x, v_y, omega)`` and a wrench ``(f_x, f_y, tau)``, both at the slider's center. `f` is
the force of the pusher on the slider. The moment arm ``h = l sin(psi - phi)`` is the signed distance of
the line of force from the slider's center, and the spin ratio ``k = R omega / v`` compares the rotation
with the center's speed `v` along `f`. "Motion" is velocity in a quasi-static scene and initial
acceleration from rest otherwise. Angles are radians. The core has lengths in units of R.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.kernels import run
from planar_pushing.terms.numbers import Array as Array


def direction(angle: npt.ArrayLike) -> Array:
    """Unit vectors at `angle` (radians, shape S), shape S + (2,), exact at multiples of 90 degrees.

    A fence that moves along its own line then has exactly zero normal motion.
    """
    angles = np.asarray(angle, dtype=float)
    return run("unit_vectors", (), angles.reshape(-1, 1), 2).reshape(*angles.shape, 2)
