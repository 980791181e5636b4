"""Certified numbers of the paper's ring at one point of a grid: the variables of a dataset by name.

Parameters and coordinates are plain values, taken as exact. A cell is a function of the plain values of
its study and of its coordinates; it returns balls, integers or booleans, or lists of them.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from flint import arb

from planar_pushing.certified import cones, line_of_force, ring
from planar_pushing.certified.balls import cosine_sine, exact_sine, in_degrees, rational, sign
from planar_pushing.certified.contact import modes
from planar_pushing.certified.contact.sticking import Motion
from planar_pushing.certified.setting import (
    Effects,
    Heading,
    Slider,
    direction,
    edge,
    heading,
    lean,
)

#: Name of a variable: its value at a point.
Record = dict[str, Any]
#: Plain values of a study, or of the part of one from which a dataset is built.
Values = Mapping[str, Any]
LAWS = {
    "infinite_friction_free": modes.INFINITE_FREE,
    "infinite_friction_none": modes.INFINITE_NONE,
    "perfectly_rough": modes.PERFECTLY_ROUGH,
}


def slider(values: Values, length: float, angle: float | None = None) -> Slider:
    """The ring of a study with a rod."""
    own = values["slider"]
    parameters = {**values.get("support_friction", {}), **values.get("inertia", {})}
    turned = own["rod_angle"] if angle is None else angle
    return Slider.of(length, turned, radius=own["radius"], **parameters)


def labeled_law(label: str) -> modes.Law:
    """Contact law of a label on the axis `contact`."""
    return LAWS[label] if label in LAWS else modes.coulomb(float(label.removeprefix("coulomb_")))


def friction_angle(mu: float) -> arb:
    """Angle of friction of a coefficient, degrees."""
    if math.isnan(mu):
        return arb.nan()
    return arb(90) if math.isinf(mu) else in_degrees(arb(rational(mu)).atan())


def limit_point(
    values: Values, effects: str, length: float, angle: float, force_angle: float
) -> Record:
    """Point of the limit curve at a force angle."""
    own, resisting = slider(values, length, angle), Effects(effects)
    force = heading(rational(force_angle))
    size, spin = line_of_force.limit_point(own, resisting, force)
    if resisting is Effects.BOTH:
        motion = line_of_force.motion_degrees(own, force, spin)
    else:
        motion = line_of_force.motion_angle(own, force, resisting.shares[0])
    return {
        "force": size,
        "force_x": size * force.x,
        "force_y": size * force.y,
        "spin_ratio": spin,
        "motion_angle": motion,
    }


def motion_cone(values: Values, effects: str, length: float, angle: float, mu: float) -> Record:
    """Friction cone, motion cone, and the quantities derived from them."""
    own, resisting = slider(values, length, angle), Effects(effects)
    forces, motions = cones.friction_cone(mu), cones.motion_cone(own, resisting, mu)
    return {
        "friction_cone_right": forces.right,
        "friction_cone_left": forces.left,
        "motion_cone_right": motions.right,
        "motion_cone_left": motions.left,
        "limit_force_right": line_of_force.limit_point(own, resisting, edge(mu, 1))[0],
        "limit_force_left": line_of_force.limit_point(own, resisting, edge(mu, -1))[0],
        "pulls": cones.pulls(own, resisting, mu),
        "slips_while_pushing": cones.slips_while_pushing(own, resisting, mu),
    }


def contact_laws(values: Values, label: str) -> Record:
    """Angle of friction of a contact law."""
    law = labeled_law(label)
    return {
        "friction_angle": friction_angle(math.nan if law.adhesive else law.friction_coefficient)
    }


def coefficients(values: Values, mu: float) -> Record:
    """Angle of friction of a coefficient."""
    return {"friction_angle": friction_angle(mu)}


def solutions(
    values: Values, effects: str, contact: str, length: float, magnitude: float, pusher_angle: float
) -> Record:
    """Every consistent solution of a push."""
    own, resisting, law = slider(values, length), Effects(effects), labeled_law(contact)
    found = modes.contact_modes(own, resisting, law, magnitude, pusher_angle)
    continuum = modes.is_continuum(own, resisting, law, pusher_angle)
    pusher = heading(pusher_angle)
    size = rational(values["slider"]["radius"])
    listed = [
        solution(own, resisting, law, mode, motion, rational(magnitude), pusher)
        | {"continuum": continuum and mode is modes.Mode.STICK}
        | {"center": center(own, size, motion)}
        for mode, motions in found.items()
        for motion in motions
    ]
    leave_out_centers(listed)
    for each in listed:
        v_x, v_y, spin = each["twist"]
        each |= {"twist": [v_x, v_y, spin / size], "force_end": each["force"], "pivot": -1}
    return columns(listed)


#: Entries of a solution; `columns` converts them to lists along `solution`.
ENTRIES = (
    "mode", "force", "force_end", "twist", "contact_motion", "spin_ratio", "center", "pivot",
    "continuum",
)  # fmt: skip
NONE, CONSISTENT, PIVOTS, CONTINUUM = range(4)


def columns(listed: list[Record]) -> Record:
    """Convert the solutions of a push to its variables, which are lists along `solution`."""
    status = CONSISTENT if listed else NONE
    if any(each["continuum"] for each in listed):
        status = CONTINUUM
    elif any(each["pivot"] >= 0 for each in listed):
        status = PIVOTS
    found = {name: [each[name] for each in listed] for name in ENTRIES}
    counts = {"solutions": len(listed), "status": status, "outcome": min(len(listed), 2)}
    return counts | found | {"consistent": [True] * len(listed)}


def leave_out_centers(listed: list[Record]) -> None:
    """Remove the motion centers of sliders at rest, which have none."""
    for each in listed:
        if all(part == 0 for part in each["twist"]):
            each["center"] = [arb.nan(), arb.nan()]


def solution(
    own: Slider,
    effects: Effects,
    law: modes.Law,
    mode: modes.Mode,
    motion: Motion,
    size: Any,
    pusher: Heading,
) -> Record:
    """Force and motion of a solution; the rotation of the twist is R omega."""
    if mode is modes.Mode.SEPARATE:
        rest = [arb(0), arb(0)]
        still = {"contact_motion": rest, "twist": [*rest, arb(0)], "spin_ratio": arb(0)}
        return {"mode": int(mode), "force": rest, "slip": -size * pusher.x, **still}
    along, k = direction(motion.force_angle), motion.spin_ratio
    u = line_of_force.contact_motion(own, along, k)
    sticks = mode is modes.Mode.STICK
    speed = modes.speed(own, law, mode, motion, size, pusher)
    force = arb(0)
    if effects is not Effects.INERTIA:
        force += own.weight * ring.profile(abs(k))[0]
    if effects is not Effects.FRICTION:
        force += own.mass * speed
    moved = [size * pusher.x, size * pusher.y] if sticks else [speed * u[0], size * pusher.y]
    return {
        "mode": int(mode),
        "force": [force * along.x, force * along.y],
        "contact_motion": moved,
        "slip": arb(0) if sticks else speed * u[0] - size * pusher.x,
        "twist": [speed * along.x, speed * along.y, speed * k],
        "spin_ratio": k,
    }


def center(own: Slider, size: Any, motion: Motion) -> list[arb]:
    """Motion center relative to the contact; for a translation, the limit k -> 0+ of a rotation."""
    c, s = cosine_sine(own.rod_angle)
    place = [own.rod_length * size * c, own.rod_length * size * s]
    along, k = direction(motion.force_angle), motion.spin_ratio
    across = -along.y, along.x
    if sign(k) != 0:
        return [c + size * part / k for c, part in zip(place, across, strict=True)]
    far = [arb.pos_inf() * part.sgn() if part != 0 else part for part in across]
    return [c + part for c, part in zip(place, far, strict=True)]


def acceleration_center(values: Values, length: float, force_angle: float, share: float) -> Record:
    """Acceleration center relative to the contact, and motion, at a share of inertia."""
    own, force = slider(values, length), heading(rational(force_angle))
    return _center_at(values, own, force, share)


def _center_at(values: Values, own: Slider, force: Heading, share: float) -> Record:
    spin = line_of_force.spin_ratio(own, force, rational(share))
    x, y = _from_contact(values, own, line_of_force.motion_center(own, force, spin))
    motion = line_of_force.motion_angle(own, force, rational(share))
    return {"center_x": x, "center_y": y, "motion_angle": motion}


def region_ends(values: Values, length: float, angle: float, force_angle: float) -> Record:
    """Ends of both regions of centers under one line of force, relative to the contact (Sec. 4).

    The ends of the exact region are friction alone and inertia alone. In the paper's bound, the centers
    lie inside the ring for a line that misses the ring, and outside it for a line that crosses the
    ring.
    """
    own, force = slider(values, length, angle), heading(rational(force_angle))
    exact = [_center_at(values, own, force, share) for share in (0.0, 1.0)]
    _, sine = lean(own, force)
    side = 0 if own.rod_length == 0 else sign(sine)
    degrees = own.rod_angle - rational(force_angle)
    misses = sign(
        own.rod_length * abs(sine) - 1, lambda: side * own.rod_length * exact_sine(degrees) - 1
    )
    inner, outer = {1: (arb.pos_inf(), arb(1)), 0: (arb(1), arb(1)), -1: (arb(1), arb(0))}[misses]
    spins = [arb(0), arb(0)] if side == 0 else [side * inner, side * outer]
    bound = [_bound_end(values, own, force, spin, side) for spin in spins]
    found: Record = {f"bound_{x}": [each[i] for each in bound] for i, x in enumerate("xy")}
    return found | {f"exact_{x}": [each[f"center_{x}"] for each in exact] for x in "xy"}


def _bound_end(
    values: Values, own: Slider, force: Heading, spin: arb, side: int
) -> tuple[arb, arb]:
    """Center at a spin ratio; at infinity it lies on the side toward which the region extends."""
    if spin.is_finite():
        x, y = line_of_force.motion_center(own, force, spin)
        flip = -1 if spin == 0 and side < 0 else 1
        return _from_contact(values, own, (flip * x, flip * y))
    return _from_contact(values, own, (arb(0), arb(0)))


def _from_contact(values: Values, own: Slider, place: tuple[arb, arb]) -> tuple[arb, arb]:
    """Place relative to the contact, from a place relative to the ring center in units of R."""
    c, s = cosine_sine(own.rod_angle)
    size = rational(values["slider"]["radius"])
    return (place[0] + own.rod_length * c) * size, (place[1] + own.rod_length * s) * size


def acceleration_cones(values: Values, length: float) -> Record:
    """The paper's bound and the exact cone under infinite friction."""
    own = slider(values, length)
    bound = cones.conservative_cone(own)
    exact = cones.motion_cone(own, Effects.BOTH, math.inf)
    return {
        "conservative_cone_right": bound.right,
        "conservative_cone_left": bound.left,
        "exact_cone_right": exact.right,
        "exact_cone_left": exact.left,
    }
