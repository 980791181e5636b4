"""Roots of the balance of torques, enclosed: from the moment arm to the spin ratio, and sticking.

Under a line of force, friction and inertia act together with the share sigma = s / (1 + s) of inertia,
which is 0 for friction alone and 1 for inertia alone: ``(1 - sigma) (t - h f) + sigma (g k - h) = 0``
with ``g = (rho / R)^2``; the root k increases with h.
"""

from __future__ import annotations

from flint import arb, fmpq

from planar_pushing.certified import ring
from planar_pushing.certified.roots import WIDTH, increasing_root

Number = arb | fmpq


def spin_of_arm(arm: arb, gyration: Number, share: Number, width: arb = WIDTH) -> arb:
    """Spin ratio for a moment arm in units of R: Eqs. (7) and (10), or their mixture.

    Parameters
    ----------
    arm : arb
    gyration : arb or fmpq
        ``(rho / R)^2``.
    share : arb or fmpq
        Share of inertia in [0, 1].
    width : arb
        Relative width of the enclosure if the spin ratio is computed as a root.

    Raises
    ------
    Undecided
        If the sign of the arm is undecided.
    """
    if arm == 0:
        return arb(0)
    if arm < 0:
        return -spin_of_arm(-arm, gyration, share, width)
    if share == 1:
        return arm / gyration
    if arm == 1 and (share == 0 or gyration == 1):  # tangent to the ring
        return arb(1)

    def balance(k: arb) -> arb:
        force, torque = ring.profile(k)
        return (1 - share) * (torque - arm * force) + share * (gyration * k - arm)

    # t / f lies between k / 2 and k below k = 1, and between k and 2 k above it.
    ends = [arm / 3, arm * 3]
    if share != 0:
        ends += [arm / gyration * fmpq(2, 3), arm / gyration * fmpq(3, 2)]
    low, high = min(float(end.lower()) for end in ends), max(float(end.upper()) for end in ends)
    return increasing_root(balance, arb(low), arb(high), width)


def sticking_rotation(
    along: arb, aside: arb, length: Number, gyration: Number, ratio: Number, width: arb = WIDTH
) -> arb:
    """R omega of the motion whose contact moves as given, without torque about the contact.

    In the frame of the rod the contact moves by ``(along, aside)``; `ratio` is m over W in their units.
    """
    size = abs(aside)

    def torque(omega: arb) -> arb:
        across = size - length * omega
        speed = (along * along + across * across).sqrt()
        force, moment = ring.profile(omega / speed)
        friction = moment - length * across / speed * force
        return friction + ratio * (gyration * omega - length * across)

    # The arm of every such force is at least min(1/2, g) k: a fraction of `aside` remains for the center.
    least = min(arb(0.5), arb(gyration), key=float) / 2
    high = size / (length * (1 + least / length**2))
    return aside.sgn() * increasing_root(torque, arb(0), high.upper(), width)
