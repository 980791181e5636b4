"""Motion over time to thirty digits: every value of the log of a scene, by two orders of one integrator.

Nothing is validated: the radius of a number is the difference of the two runs, and at least 2^-100 of the
largest number of its variable.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

from flint import arb, ctx, fmpq

from pulling_by_pushing.oracle.balls import (
    PRECISION,
    Undecided,
    Vector,
    cone_edge,
    cosine_sine,
    in_degrees,
    norm,
    rational,
    rational_pair,
)
from pulling_by_pushing.oracle.body import Body
from pulling_by_pushing.oracle.logs.course import PREFERRED_MODE, Course, Instant, Piece, Scheme
from pulling_by_pushing.oracle.logs.phases import Massive, Slider, State, line
from pulling_by_pushing.oracle.logs.sliding import Sliding
from pulling_by_pushing.oracle.shapes import support

File = Mapping[str, Any]
#: Dimensions, and nested lists of balls, or of flags.
LogVariables = dict[str, tuple[tuple[str, ...], Any]]
#: Two schemes of different orders; the result is from the first.
SCHEMES = Scheme(16, arb(2) ** -122), Scheme(12, arb(2) ** -100)
#: Largest difference of the two runs, and the least radius, both over the largest number of a variable.
LARGEST_DIFFERENCE, SMALLEST_RADIUS = arb(10) ** -25, arb(2) ** -100
FRICTIONS = "ring_friction", "support_friction"
#: Dimensions after time.
VECTORS = {"position": "xy", "pusher": "xy", "force": "xy", "twist": "twist_component"}


def log_values(scene: File, times: Sequence[float]) -> LogVariables:
    """Every value of the log of a scene at its stored instants, without the code that wrote the log.

    Parameters
    ----------
    scene : mapping
        A scene file's plain content (`SceneFile.model_dump()`), with its section `simulate`.
    times : sequence of float, shape (n,)
        The stored instants in order, taken as exact, in the scene's unit of time.

    Returns
    -------
    dict
        For `time` and each variable of the log except `evaluations`: its dimensions, and its values as
        nested lists, with balls for numbers and int or bool for flags. Names, dimensions, frames and units
        are those of the log: angles in degrees, rotations in radians per time, x along the fence, y normal
        to it.

    Raises
    ------
    Undecided
        If the scene is not of a supported kind, its motion is not smooth between events, an event has no
        stored instant, or the two runs differ in a flag or by more than 1e-25 of the largest number of a
        variable.

    Notes
    -----
    Supported are one support friction, one mass, or both, on a fence whose velocity is constant in pieces;
    with inertia the slider must not pivot.

    A log contains each event of a motion at the time that the library found. The stored instant next to an
    event, within 1e-8 of the last time, is that of the event: its `time` is the event's own, and its other
    values are those of the motion after the event, at the stored time, so that the error of that time does
    not count twice. At the start of a piece of the fence's motion the values are also those just after it.
    """
    exact = [rational(time) for time in times]
    if not exact or any(b <= a for a, b in pairwise(exact)):
        raise Undecided("instants must increase, and there must be at least one")
    if scene["simulate"] is None:
        raise Undecided("the scene file has no section simulate")
    with ctx.workprec(PRECISION):
        fine, coarse = (_columns(scene, exact, scheme) for scheme in SCHEMES)
        return {
            name: (dims, _join(rows, coarse[name][1], _largest(rows)))
            for name, (dims, rows) in fine.items()
        }


def _columns(scene: File, times: list[fmpq], scheme: Scheme) -> LogVariables:
    """Every variable of the log, from one run of the integrator."""
    section, slider, pieces = scene["simulate"], _slider(scene), _pieces(scene["simulate"])
    if not (times[0] >= 0 and times[-1] <= pieces[-1].end):
        raise Undecided("instants must be within the duration")
    state = _initial_state(scene, slider, pieces[0].velocity)
    course = Course(slider, pieces, times, section["on_ambiguity"], scheme, state)
    instants, radius, gap = (
        course.follow(),
        _radius(scene, slider),
        rational(section["initial_gap"]),
    )
    rows = [
        _row(slider, radius, _fence_position(pieces, time, gap), instant)
        for time, instant in zip(times, instants, strict=True)
    ]
    values: LogVariables = {}
    for name in rows[0]:
        dims = (VECTORS[name],) if name in VECTORS else ()
        values[name] = ("time", *dims), [row[name] for row in rows]
    dissipated = [
        [
            arb(0) if effect["type"] == "inertia" else row.state.support_loss
            for effect in scene["effects"]
        ]
        for row in instants
    ]
    return values | {"dissipated": (("time", "effect"), dissipated)}


def _row(slider: Slider, radius: fmpq | arb, fence: Vector, instant: Instant) -> dict[str, Any]:
    """Values of the log at an instant."""
    state, phase, motion, solutions, event, time = instant
    rod, (x, y), spin = slider.rod(state.angle), motion.contact, motion.spin
    velocity = x - spin * rod[1], y + spin * rod[0]
    return {
        "time": time,
        "position": [fence[0] + state.along + rod[0], fence[1] + state.gap + rod[1]],
        "rod_angle": in_degrees(state.angle),
        "twist": [*velocity, spin],
        "pusher": [*fence],
        "slip": state.slip,
        "gap": state.gap,
        "force": [*motion.force],
        "mode": int(phase.mode),
        "pivot": phase.foot,
        "event": event,
        "outcome": min(solutions, 2),
        "solutions": solutions,
        "adhesive": bool(motion.force[1] < 0),
        "spin_ratio": arb(0) if spin == 0 else radius * spin / norm(*velocity),
        "contact_dissipated": state.contact_loss,
        "work": state.work,
        "kinetic_energy": slider.energy(state.angle, motion.contact, spin),
    }


def _largest(rows: Any) -> arb:
    """The largest magnitude of nested numbers."""
    if isinstance(rows, list):
        return max(map(_largest, rows))
    return abs(arb(rows)).mid()


def _join(fine: Any, coarse: Any, size: arb) -> Any:
    """Values of one run as balls with the difference from the other one as the radius."""
    if isinstance(fine, list):
        return [_join(a, b, size) for a, b in zip(fine, coarse, strict=True)]
    if not isinstance(fine, arb):
        if fine != coarse:
            raise Undecided(f"two runs differ in a flag: {fine}, {coarse}")
        return fine
    number, difference = fine.mid(), abs(fine.mid() - coarse.mid())
    if not difference <= LARGEST_DIFFERENCE * size:
        raise Undecided(f"two runs differ by too much: {fine}, {coarse}")
    radius = arb.max(difference, SMALLEST_RADIUS * size)
    if number != 0 and abs(number) < radius:
        return arb(0, 2 * radius)
    if difference == 0 and number == float(number):  # a number of the scene, or zero
        return number
    return arb(number, radius)


def _pieces(section: File) -> list[Piece]:
    """Pieces of constant velocity of the fence, from the section `simulate`."""
    plain = section["method"] == "event-driven" and section["pusher_shape"] == "fence"
    further = any(section.get(name) is not None for name in ("waypoints", "until"))
    along = section.get("pusher_frame", "fence") == "fence"
    if not plain or not along or further:
        raise Undecided("motion over time requires event-driven integration and a fence")
    if (
        not isinstance(section["on_ambiguity"], str)
        or section["on_ambiguity"] not in PREFERRED_MODE
    ):
        raise Undecided(f"motion over time requires one policy of {', '.join(PREFERRED_MODE)}")
    entries = section["pusher"] or [
        {"time": 0, "angle": section["pusher_angle"], "speed": section["pusher_speed"]}
    ]
    ends = [*(rational(entry["time"]) for entry in entries), rational(section["duration"])]
    pieces = []
    for entry, (start, end) in zip(entries, pairwise(ends), strict=True):
        speed = fmpq(1) if entry["speed"] is None else rational(entry["speed"])
        x, y = cosine_sine(rational(entry["angle"]))
        pieces.append(Piece(start, end, ((speed * x).mid(), (speed * y).mid())))
    return pieces


def _fence_position(pieces: Sequence[Piece], time: fmpq, gap: fmpq) -> Vector:
    """Place of the fence, which is initially at a gap below the contact."""
    x, y = arb(0), arb(-gap)
    for start, end, velocity in pieces:
        if start < time:
            x, y = line((x, y), velocity, arb(min(time, end) - start))
    return x, y


def _slider(scene: File) -> Slider:
    """The slider, if the scene is of a kind that `log_values` supports."""
    entry, contact, effects = scene["slider"], scene["contact"], scene["effects"]
    inertia = [effect for effect in effects if effect["type"] == "inertia"]
    frictions = [effect for effect in effects if effect["type"] in FRICTIONS]
    if len(inertia) + len(frictions) < len(effects) or max(len(inertia), len(frictions)) > 1:
        raise Undecided("motion over time requires at most one support friction and one mass alone")
    if contact["law"] == "coulomb":
        mu = contact["friction_coefficient"]
    elif contact["law"] == "infinite_friction" and contact["at_zero_normal"] == "free":
        mu = math.inf
    else:
        raise Undecided("motion over time requires a contact law that allows slip")
    right, left = (cone_edge(mu, side).ball for side in (1, -1))
    length, edges = rational(entry["rod_length"]), (_middle(right), _middle(left))
    body = None
    for friction in frictions:
        shape = friction.get("support") or {"shape": "ring", "radius": entry["radius"]}
        weight = rational(friction["weight"])
        body = Body(length=length, support=support(shape), weight=weight)
    if body is not None and not inertia:
        return Sliding(length=length, edges=edges, body=body)
    mass, (x, y) = rational(inertia[0]["mass"]), rational_pair(inertia[0]["center"] or (0, 0))
    return Massive(
        length=length, edges=edges, body=body, mass=mass, center=(length + x, y),
        moment=mass * rational(inertia[0]["gyration_radius"]) ** 2,
    )  # fmt: skip


def _middle(vector: Vector) -> Vector:
    return vector[0].mid(), vector[1].mid()


def _radius(scene: File, slider: Slider) -> fmpq | arb:
    """The slider's radius; without one the largest distance of the support, or 1 for a ring."""
    if scene["slider"]["radius"] is not None:
        return rational(scene["slider"]["radius"])
    ring = any(effect["type"] == "ring_friction" for effect in scene["effects"])
    if ring or slider.body is None or slider.body.support is None:
        return fmpq(1)
    return slider.body.support.extent


def _initial_state(scene: File, slider: Slider, fence: Vector) -> State:
    """The state at the start, where the contact is the origin."""
    section = scene["simulate"]
    twist = section["initial_twist"] or {"v_x": 0, "v_y": 0, "omega": 0}
    v_x, v_y, degrees = (rational(twist[name]) for name in ("v_x", "v_y", "omega"))
    angle, spin = (
        (arb.pi() * part / 180).mid() for part in (rational(scene["slider"]["rod_angle"]), degrees)
    )
    rates: Vector = (arb(0), arb(0))
    if isinstance(slider, Massive):
        x, y = slider.rod(angle)
        rates = line((v_x + spin * y, v_y - spin * x), fence, -1)
    return State(angle, arb(0), arb(rational(section["initial_gap"])), *rates, spin, *[arb(0)] * 5)
