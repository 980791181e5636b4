r"""Geometry of the plane: frame, signs and the kinematics of a pushed slider.

::

                       ring (radius R, centre c)
             y'  y   .-'''-.            psi   rod angle
               \ |  /   c   \           l     rod length, from the contact to the ring centre
                \|  \  /    /           phi   force angle: f points along (cos phi, sin phi)
                 |   `/....'            n     outward normal of the fence = +y
                 |   / rod              theta angle of a velocity or an acceleration
                 |  / ) psi             all angles from +x (the fence), counter-clockwise
   --------------+-*----------- x
         fence     contact = free end of the rod, origin of all positions; slider above the fence

A twist is ``(v_x, v_y, omega)`` at the ring centre, a wrench ``(f_x, f_y, tau)`` at the ring
centre. `f` is the force of the pusher on the slider. The moment arm ``h = l sin(psi - phi)`` is the
signed distance of the line of force from the ring centre, and the spin ratio ``k = R omega / v``
compares the rotation with the centre's speed `v` along `f`. "Motion" is velocity in a quasi-static
scene and initial acceleration from rest otherwise. Angles are radians.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

QUARTER_TURN = np.pi / 2

#: Longest length in units of the ring's radius, and the inverse of the shortest radius of gyration.
#: The products of four lengths that the equations hold are then doubles.
LONGEST = 1e70


def direction(angle: npt.ArrayLike) -> Array:
    """Unit vectors at `angle`, exact where the angle is the double nearest to a quarter turn.

    Parameters
    ----------
    angle : array_like, shape S
        Radians.

    Returns
    -------
    ndarray, shape S + (2,)
        Dimensionless. ``direction(np.pi)`` is (-1, 0), so a fence that moves along itself has no
        normal motion left over from rounding.
    """
    angle = np.asarray(angle, dtype=float)
    vectors = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    quarters = np.rint(angle / QUARTER_TURN)
    on_axis = (quarters * QUARTER_TURN == angle)[..., None]
    return np.where(on_axis, np.rint(vectors), vectors)


def moment_arm(
    rod_length: npt.ArrayLike, rod_angle: npt.ArrayLike, force_angle: npt.ArrayLike
) -> Array:
    """Moment arm of the line of force about the ring centre, Eq. (10): l sin(psi - phi).

    The unit is that of `rod_length`; a positive arm turns the slider counter-clockwise.
    """
    psi, phi = np.asarray(rod_angle, dtype=float), np.asarray(force_angle, dtype=float)
    lean = psi - phi
    back = lean - psi
    # What the subtraction rounded off: a long rod along the fence multiplies it by its length.
    rounding = (psi - (lean - back)) - (phi + back)
    rod, force = direction(psi), direction(phi)
    across = rod[..., 1] * force[..., 0] - rod[..., 0] * force[..., 1]
    # Along an axis the double is taken for the quarter turn, as in `direction`; nothing cancels.
    on_axis = (force == 0).any(axis=-1) | (rod == 0).any(axis=-1)
    sine = np.where(on_axis, across, np.sin(lean) + rounding * np.cos(lean))
    return np.asarray(np.multiply(rod_length, sine))


def parts_along_rod(rod_angle: float, vectors: Array) -> tuple[Array, Array]:
    """Parts of unit vectors, shape S + (2,), along the rod and along its right-hand normal, shape S.

    The products are exact where the rod or the vector lies on an axis, and keep a part as small as the
    smallest double; elsewhere they would cancel where the difference of the angles does not.
    """
    rod = direction(rod_angle)
    along, aside = vectors @ rod, vectors @ np.array([rod[1], -rod[0]])
    lean = rod_angle - np.arctan2(vectors[..., 1], vectors[..., 0])
    on_axis = (vectors == 0).any(axis=-1) | (rod == 0).any()
    return np.where(on_axis, along, np.cos(lean)), np.where(on_axis, aside, np.sin(lean))


def contact_motion_angle(
    force_angle: npt.ArrayLike,
    spin_ratio: npt.ArrayLike,
    rod_length: npt.ArrayLike,
    rod_angle: npt.ArrayLike,
) -> Array:
    """Angle of the contact's motion, radians, on the branch within 90 degrees of the force.

    Parameters
    ----------
    force_angle, rod_angle : array_like
        Radians.
    spin_ratio : array_like
        ``k = R omega / v``, of the same sign as the moment arm; may be infinite.
    rod_length : array_like
        In units of the ring radius.

    Notes
    -----
    The contact moves along ``f + k l (sin psi, -cos psi)`` (Eqs. 11-12 for inertia). Its deviation
    from `f` has a cosine proportional to ``1 + k l sin(psi - phi) >= 1``: the pusher never does
    negative work.
    """
    lean = np.subtract(rod_angle, force_angle)
    pull = np.multiply(spin_ratio, rod_length)
    far = np.isinf(pull)
    ahead = np.where(far, np.sign(pull) * np.sin(lean), 1 + np.where(far, 0, pull) * np.sin(lean))
    aside = np.where(far, np.sign(pull), pull) * np.cos(lean)
    return np.asarray(force_angle - np.arctan2(aside, ahead))


def motion_center(
    force_angle: npt.ArrayLike,
    spin_ratio: npt.ArrayLike,
    rod_length: npt.ArrayLike,
    rod_angle: npt.ArrayLike,
    radius: npt.ArrayLike = 1.0,
) -> Array:
    """Motion centre relative to the contact, shape S + (2,), in the unit of the lengths.

    It lies at the signed distance ``-R/k`` along x', the force direction turned by -90 degrees,
    from the ring centre (text below Eq. 3). A translation puts it at infinity: the coordinates
    are then infinite, or the ring centre's where x' has no such component.
    """
    along = direction(np.subtract(force_angle, QUARTER_TURN))
    ratio = np.asarray(spin_ratio, dtype=float)[..., None]
    with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
        offset = -np.asarray(radius)[..., None] / np.where(ratio == 0, 0.0, ratio) * along
    offset = np.where(along == 0, 0.0, offset)
    center = np.asarray(rod_length)[..., None] * direction(rod_angle)
    return np.asarray(center + offset)
