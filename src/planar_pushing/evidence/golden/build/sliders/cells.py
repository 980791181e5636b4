"""Records of the golden datasets of a study of sliders: the named numbers at one point of a grid.

Coordinates and entries of supports are plain values, taken as exact; the weight is 1.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from flint import arb, fmpq

from planar_pushing.certified.balls import cosine_sine, in_degrees, rational, sign
from planar_pushing.certified.effects.cone_edges import Edge, edge
from planar_pushing.certified.potential.direction import degrees as at_degrees
from planar_pushing.certified.potential.direction import relative
from planar_pushing.certified.potential.precision import FINE, decided
from planar_pushing.certified.potential.resistance import Friction, Scene, resistance
from planar_pushing.certified.potential.sticking import Stuck, stick
from planar_pushing.certified.supports.pressure.moments import moments
from planar_pushing.certified.supports.pressure.pieces import Pieces, pieces
from planar_pushing.evidence.golden.build.cells import Record

Entries = Mapping[str, Any]
CENTERS = ("center_x", "center_y")
MODES = ("SEPARATE", "STICK", "SLIP_RIGHT", "SLIP_LEFT")
VALUES = ("force_angle", "force_angle_end", "motion_angle", "spin", "pivot")
#: What a mode without a solution has, and one that leaves the slider at rest.
ABSENT = (*(arb.nan() for _ in range(4)), -1)
AT_REST = (*(arb(0) for _ in range(4)), -1)


def _support(entries: Entries, name: str) -> Pieces:
    return pieces(entries[name])


def wrench(entries: Entries, name: str, x: float, y: float) -> Record:
    """Mean distance, and the wrench about the origin of a counter-clockwise rotation."""
    c = arb(rational(x)), arb(rational(y))
    now = moments(_support(entries, name), c)
    return {
        "mean_distance": now.distance,
        "force_x": -now.y,
        "force_y": now.x,
        "torque": now.torque(c, (arb(0), arb(0))),
    }


def numbers(entries: Entries, name: str) -> Record:
    """Numbers of a support as a whole."""
    support, zero = _support(entries, name), arb(0)
    x, y = (arb(each) for each in support.center)
    distance = moments(support, (x, y)).distance
    last = 1 / (distance * distance)
    return {
        "center_of_pressure_x": x,
        "center_of_pressure_y": y,
        "extent": support.extent,
        "integration_constant": distance / support.extent,
        "ellipsoid": [[arb(1), zero, zero], [zero, arb(1), zero], [zero, zero, last]],
    }


def cone(entries: Entries, name: str, length: float, angle: float, friction: float) -> Record:
    """Edges of a motion cone, what they pivot about, and what follows from them."""
    rod = _support(entries, name), rational(length), rational(angle)
    right, left = (edge(*rod, friction, side) for side in (1, -1))
    low, high = sign(right.angle), sign(left.angle - 180)
    return {
        "motion_angle": [right.angle, left.angle],
        "pivot": [right.moved.pivot, left.moved.pivot],
        "width": left.angle - right.angle,
        "pulls": low < 0 or high > 0,
        "slips_while_pushing": low > 0 or high < 0,
    }


def mode(
    entries: Entries, name: str, length: float, angle: float, friction: float, pusher: float
) -> Record:
    """Every contact mode of one push; NaN where there is none."""
    rod = _support(entries, name), rational(length), rational(angle)
    right, left = (edge(*rod, friction, side) for side in (1, -1))
    degrees = rational(pusher)
    found = [
        AT_REST if degrees <= 0 or degrees == 180 else None,
        _stick(rod, right, left, degrees),
        _slip(rod, left, -1, degrees),
        _slip(rod, right, 1, degrees),
    ]
    columns = zip(*(each or ABSENT for each in found), strict=True)
    consistent = [each is not None for each in found]
    values: Record = {"consistent": consistent, "outcome": min(sum(consistent), 2)}
    return values | {key: list(each) for key, each in zip(VALUES, columns, strict=True)}


def _stick(rod: Any, right: Edge, left: Edge, pusher: fmpq) -> tuple[Any, ...] | None:
    """The sticking motion, where the pusher's motion is within the motion cone."""
    turns = [pusher + turn for turn in (-360, 0, 360)]
    within = [sign(each - right.angle) >= 0 and sign(left.angle - each) >= 0 for each in turns]
    if not any(within):
        return None
    support, length, angle = rod
    scene = Scene(length, at_degrees(angle), (Friction(support, fmpq(1)),))

    def along() -> Stuck:
        total = resistance(scene)
        return stick(total, total.push(relative(at_degrees(pusher), scene.rod)), fmpq(1))

    found = decided(along, FINE)
    ends = _ends(found, right, left, angle)
    spin = found.spin * support.extent
    return *ends, arb(180 if pusher == -180 else pusher), spin, found.pivot


def _ends(found: Stuck, right: Edge, left: Edge, angle: fmpq) -> tuple[arb, arb]:
    """Ends of the force angles that a motion leaves open, within the friction cone."""
    c, s = cosine_sine(angle)
    force, free = ((x * c - y * s, x * s + y * c) for x, y in (found.force, found.free))
    low, high = arb(-1), arb(1)
    if found.pivot >= 0:
        for at, side in ((right, 1), (left, -1)):
            turn = at.force_angle / 180
            depth, change = (
                side * (turn.cos_pi() * y - turn.sin_pi() * x) for x, y in (force, free)
            )
            if sign(change) > 0:
                low = arb.max(low, -depth / change)
            else:
                high = arb.min(high, -depth / change)
    return _angle(force, free, low), _angle(force, free, high)


def _angle(force: Any, free: Any, part: arb) -> arb:
    """Angle of a force, which pushes."""
    x, y = (f + part * e for f, e in zip(force, free, strict=True))
    return 90 + in_degrees(arb.atan2(-x, y))


def _slip(rod: Any, at: Edge, side: int, pusher: fmpq) -> tuple[Any, ...] | None:
    """The slip under the force of an edge, if the contact keeps up with the fence and goes to its side."""
    support = rod[0]
    _, moves = cosine_sine(pusher)
    turn = at.angle / 180
    normal = arb(0) if at.angle == 0 or at.angle == 180 else turn.sin_pi()
    if sign(moves) == 0 or sign(normal) != sign(moves):
        return None
    over = ((pusher - at.angle) / 180).sin_pi()
    if sign(over) * sign(normal) * side >= 0:
        return None
    spin = at.moved.turn * support.extent * moves / normal
    high = sign(at.angle - 180) > 0
    motion = at.angle - 360 if high else at.angle
    return at.force_angle, at.force_angle, motion, spin, at.moved.pivot
