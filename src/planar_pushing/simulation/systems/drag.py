"""Forces on a moving slider: friction, viscous friction and loads; and the power that they dissipate.

Twists and wrenches are at the slider's center, in the body frame. A tuple of effects can be empty.
"""

from __future__ import annotations

from collections.abc import Callable
from math import cos, inf, log, nan, sin, sqrt
from typing import Any

from planar_pushing.simulation.legacy.base import (
    KINDS,
    Resistance,
    count_fields,
    count_points,
    made,
    place,
    resistance,
)
from planar_pushing.simulation.legacy.compiled import (
    compiled,
    generic,
    generic_owning,
    owning,
)
from planar_pushing.simulation.legacy.load import Wrench
from planar_pushing.simulation.legacy.mass import Mass
from planar_pushing.simulation.legacy.motion import ROUNDING
from planar_pushing.simulation.legacy.own_ring import RingSupport


@generic_owning
def effects_of(kinds: Any) -> Callable[..., Any]:
    """Create effects of given kinds from a row, starting at a column. Arguments: kinds, row, column."""
    return _effects_of if kinds else _no_effects


@owning
def _effects_of(kinds, row, i):
    return made(kinds, row, i)


@owning
def _no_effects(kinds, row, i):
    return ()


@generic
def columns_of(kinds: Any) -> Callable[..., Any]:
    """Number of columns in a row for given kinds."""
    return _columns_of if kinds else _no_columns


@compiled
def _columns_of(kinds):
    return count_fields(kinds)


@compiled
def _no_columns(kinds):
    return 0


@generic
def drag(kinds: Any) -> Callable[..., Any]:
    """`Resistance` to a twist, 0 at rest, without points at the center. Arguments: effects, x, y, spin."""
    return _drag if kinds else _no_drag


@compiled
def _no_drag(effects, x, y, spin):
    return Resistance(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1, 0.0)


@compiled
def _drag(effects, x, y, spin):
    if x == 0.0 and y == 0.0 and spin == 0.0:
        return _no_drag(effects, x, y, spin)
    return resistance(effects, x, y, spin, ROUNDING * (abs(x) + abs(y)))


@generic
def powers(kinds: Any) -> Callable[..., Any]:
    """Store the power dissipated by each effect. Arguments: effects, x, y, spin, total, found, index."""
    return (_no_powers, _last_power)[len(kinds)] if len(kinds) < 2 else _powers


@compiled
def _no_powers(effects, x, y, spin, total, found, i):
    pass


@compiled
def _last_power(effects, x, y, spin, total, found, i):
    found[i] = total


@compiled
def _powers(effects, x, y, spin, total, found, i):
    now = drag(effects[:1], x, y, spin)
    found[i] = now.f_x * x + now.f_y * y + now.torque * spin
    powers(effects[1:], x, y, spin, total - found[i], found, i + 1)


@compiled
def load_at(body, angle):
    """Wrench of the loads at a rod angle; their direction in the world is constant."""
    (x, y, cross, dot), turn = body.load, angle - body.start_angle
    c, s = cos(turn), sin(turn)
    return Wrench(x * c + y * s, y * c - x * s, cross * c - dot * s)


@compiled
def load_work(body, angle, x, y):
    """Work of the loads since time 0, for a displacement of the center along the initial body axes."""
    (g_x, g_y, cross, dot), turn = body.load, angle - body.start_angle
    return g_x * x + g_y * y + dot * (cos(turn) - 1.0) + cross * sin(turn)


@generic
def with_loads(kinds: Any) -> Callable[..., Any]:
    """Effects and the wrench of the loads, if any, at an angle. Arguments: loads, effects, body, angle."""
    return _with_loads if kinds else _without_loads


@compiled
def _without_loads(loads, effects, body, angle):
    return effects


@compiled
def _with_loads(loads, effects, body, angle):
    return (*effects, load_at(body, angle))


@generic
def scaled_films(kinds: Any) -> Callable[..., Any]:
    """Viscous friction with forces multiplied by a factor. Arguments: films, factor."""
    return _scaled_films if kinds else _no_films


@compiled
def _no_films(films, factor):
    return ()


@compiled
def _scaled_films(films, factor):
    mass, gyration, x, y = films[0]
    return (Mass(factor * mass, gyration, x, y), *scaled_films(films[1:], factor))


@generic
def slowest_foot(kinds: Any) -> Callable[..., Any]:
    """Number and speed of the slowest support point under a twist; the number is -1 without points."""
    return _slowest_foot if kinds else _no_foot


@compiled
def _no_foot(effects, x, y, spin):
    return -1, inf


@compiled
def _slowest_foot(effects, x, y, spin):
    found, least = -1, inf
    for i in range(count_points(effects)):
        p_x, p_y = place(effects, i)
        v_x, v_y = x - spin * p_y, y + spin * p_x
        speed = sqrt(v_x * v_x + v_y * v_y)
        if speed < least:
            found, least = i, speed
    return found, least


@generic
def foot_at(kinds: Any) -> Callable[..., Any]:
    """Position of a support point in the body frame. Arguments: effects, its number."""
    return _place if kinds else _no_place


@compiled
def _place(effects, i):
    return place(effects, i)


@compiled
def _no_place(effects, i):
    return 0.0, 0.0


@generic
def kink(kinds: Any) -> Callable[..., Any]:
    """Watch for kinks of a contact's motion. Arguments: effects, motion, whether it slips.

    For a ring, the center of rotation crosses the ring; with support points, a pivot begins or ends in a
    slip.
    """
    if RingSupport in kinds:
        return _kink_on_ring
    return _kink_at_points if any(KINDS[kind].DEGREE == 1 for kind in kinds) else _no_kink


@compiled
def _no_kink(effects, now, slips):
    return nan


@compiled
def _kink_at_points(effects, now, slips):
    if not slips or count_points(effects) == 0:
        return nan
    return 1.0 if now.pivot >= 0 else -1.0


@compiled
def _kink_on_ring(effects, now, slips):
    total = abs(now.spin) + now.speed
    part = (abs(now.spin) - now.speed) / total if total > 0.0 else 0.0
    # As smooth in time as the moment arm; near the ring, the spin ratio behaves like x / log(x) of the arm.
    return part * (2.0 - log(abs(part))) if part != 0.0 else 0.0
