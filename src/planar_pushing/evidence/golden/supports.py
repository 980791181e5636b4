"""Certified numbers of any support at one point of a grid; the weight is 1."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import lru_cache
from itertools import product
from typing import Any

from flint import arb, fmpq

from planar_pushing.certified.balls import Undecided, cosine_sine, norm, rational, sign
from planar_pushing.certified.contact.modes import Law, Mode
from planar_pushing.certified.effects import cone_edges
from planar_pushing.certified.effects.modes import Solution, edge, modes
from planar_pushing.certified.potential import direction
from planar_pushing.certified.potential.direction import Direction
from planar_pushing.certified.potential.resistance import Friction, Scene
from planar_pushing.certified.supports.pressure.moments import Vector, moments
from planar_pushing.certified.supports.pressure.pieces import Pieces, pieces
from planar_pushing.evidence.golden.cells import Record, Values, columns
from planar_pushing.evidence.golden.ellipsoid import errors

ONE = fmpq(1)
#: Distance of a motion center, also along one axis, beyond which doubles cannot distinguish a translation.
FAR = 10**15
#: A smaller ball that contains zero is that of a number that vanishes by symmetry.
NOTHING = 1e-30
#: In doubles a load counts as within its share if its square exceeds that of the share by less than this.
KINK = 1e-12


def support(values: Values, name: str) -> Pieces:
    """The pieces of a support of a study."""
    return _support(json.dumps(values["supports"][name]))


@lru_cache(maxsize=64)
def _support(entry: str) -> Pieces:
    found: Mapping[str, Any] = json.loads(entry)
    return pieces(found)


@lru_cache(maxsize=64)
def _scene(own: Pieces, length: float, angle: float) -> Scene:
    rod = direction.degrees(rational(angle))
    return Scene(rational(length), rod, (Friction(own, ONE),))


@lru_cache(maxsize=1024)
def _pusher(degrees: float) -> Direction:
    return direction.degrees(rational(degrees))


def wrench(values: Values, name: str, x: float, y: float) -> Record:
    """Mean distance, and the wrench about the origin for a counter-clockwise rotation."""
    c = arb(rational(x)), arb(rational(y))
    now = moments(support(values, name), c)
    return {
        "mean_distance": now.distance,
        "force_x": -now.y,
        "force_y": now.x,
        "torque": now.torque(c, (arb(0), arb(0))),
    }


def numbers(values: Values, name: str) -> Record:
    """Numbers of a support as a whole, and the errors of its ellipsoid, degrees."""
    own, zero = support(values, name), arb(0)
    x, y = (arb(each) for each in own.center)
    distance = moments(own, (x, y)).distance
    last = 1 / (distance * distance)
    found: Record = {
        "center_of_pressure_x": x,
        "center_of_pressure_y": y,
        "extent": own.extent,
        "integration_constant": distance / own.extent,
        "ellipsoid": [[arb(1), zero, zero], [zero, arb(1), zero], [zero, zero, last]],
    }
    return found | errors(own)


def cone(values: Values, name: str, length: float, angle: float, friction: float) -> Record:
    """Edges of a motion cone, the feet about which they pivot, and the quantities derived from them."""
    rod = support(values, name), rational(length), rational(angle)
    _refuse_kinks(*rod, friction)
    right, left = (cone_edges.edge(*rod, friction, side) for side in (1, -1))
    low, high = sign(right.angle), sign(left.angle - 180)
    return {
        "motion_angle": [right.angle, left.angle],
        "pivot": [right.moved.pivot, left.moved.pivot],
        "width": left.angle - right.angle,
        "pulls": low < 0 or high > 0,
        "slips_while_pushing": low > 0 or high < 0,
    }


def solutions(
    values: Values, name: str, length: float, angle: float, friction: float, pusher: float
) -> Record:
    """Every consistent solution of a push."""
    own = support(values, name)
    _refuse_kinks(own, rational(length), rational(angle), friction)
    found = modes(_scene(own, length, angle), Law(friction), _pusher(pusher), ONE)
    found.sort(key=lambda each: each.mode)
    return columns([_entry(each, own, length, angle, friction) for each in found])


@lru_cache(maxsize=1 << 12)
def _refuse_kinks(own: Pieces, length: fmpq, angle: fmpq, friction: float) -> None:
    """Refuse edges under which a foot would carry more than its share by a rounding error."""
    for side, foot in product((1, -1), range(len(own.points))):
        load = cone_edges.pivot_load(own, length, angle, friction, side, foot)
        if load is not None and load > 1 and load < 1 + KINK:
            raise Undecided("the load of a foot equals its share to all digits")


def _entry(found: Solution, own: Pieces, length: float, angle: float, friction: float) -> Record:
    c, s = cosine_sine(rational(angle))
    x, y = rational(length) * c, rational(length) * s
    spin = arb(0) if _vanishes(found.spin) else found.spin
    v = found.motion[0] - spin * y, found.motion[1] + spin * x
    low, high = _ends(found, friction)
    return {
        "mode": int(found.mode),
        "force": low,
        "force_end": high,
        "twist": [*v, spin],
        "contact_motion": list(found.motion),
        "spin_ratio": _ratio(own, v, spin),
        "center": _center(found.motion, (x, y), v, spin),
        "pivot": found.pivot,
        "continuum": found.continuum,
    }


def _vanishes(ball: arb) -> bool:
    if not ball.contains(0):
        return False
    if ball.abs_upper() > NOTHING:
        raise Undecided(f"the sign of {ball} is undecided")
    return True


def _ratio(own: Pieces, v: Vector, spin: arb) -> arb:
    """R omega / |v|; infinite for a rotation about the slider's center."""
    if spin.is_zero():
        return arb(0)
    if all(map(_vanishes, v)):
        return arb.pos_inf() * spin.sgn()
    return spin * own.extent / norm(*v)


def _center(motion: Vector, own: Vector, v: Vector, spin: arb) -> list[arb]:
    """Motion center from the contact; for a translation, the limit of slow rotations to the left."""
    if not spin.is_zero() and abs(spin) * FAR > norm(*v):
        return [-motion[1] / spin, motion[0] / spin]
    if all(each.is_zero() for each in v):  # a slider at rest has none
        return [arb.nan(), arb.nan()]
    across, speed = (-v[1], v[0]), norm(*v)
    return [
        arb.pos_inf() * part.sgn() if abs(part) * FAR > speed else place
        for place, part in zip(own, across, strict=True)
    ]


def _ends(found: Solution, friction: float) -> tuple[list[arb], list[arb]]:
    """Ends of the forces of a solution within the friction cone; equal except for a sticking pivot."""
    if found.pivot < 0 or found.mode is not Mode.STICK:
        return list(found.force), list(found.force)
    low, high = arb(-1), arb(1)
    for side in (1, -1):
        x, y = edge(Law(friction), side).ball()
        depth, change = (side * (x * f[1] - y * f[0]) for f in (found.force, found.free))
        if sign(change) > 0:
            low = arb.max(low, -depth / change)
        else:
            high = arb.min(high, -depth / change)
    low_end, high_end = (
        [f + part * e for f, e in zip(found.force, found.free, strict=True)] for part in (low, high)
    )
    return low_end, high_end
