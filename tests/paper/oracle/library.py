"""Solutions of the library as roots that the oracle proves next to them, for any effects and supports."""

import math

from flint import arb, fmpq

from planar_pushing.mechanics.entries import scene_entry
from pulling_by_pushing.evidence.hard_cases.references import in_exact_degrees
from pulling_by_pushing.oracle.balls import (
    ZERO,
    Number,
    Undecided,
    at_degrees,
    cone_edge,
    precise,
    rational,
    rational_pair,
)
from pulling_by_pushing.oracle.body import Body
from pulling_by_pushing.oracle.modes import SLIPS, Law, Mode
from pulling_by_pushing.oracle.prove import (
    Slider,
    force_along,
    krawczyk,
    moves,
    torque,
    with_roundings,
)
from pulling_by_pushing.oracle.shapes import support, together


def slider_of(scene):
    """A public scene as a slider of the oracle: the sum of its effects."""
    entry = scene_entry(scene)
    rod = entry["slider"]
    length, psi = rational(rod["rod_length"]), rational(rod["rod_angle"])
    radius = rod.get("radius") or 1.0
    frictions = [effect for effect in entry["effects"] if effect["type"].endswith("friction")]
    masses = [effect for effect in entry["effects"] if effect["type"] == "inertia"]
    films = [effect for effect in entry["effects"] if effect["type"] == "viscous"]
    loads = [effect for effect in entry["effects"] if effect["type"] == "load"]
    parts = {}
    if frictions:
        weight = sum((rational(effect["weight"]) for effect in frictions), ZERO)
        shares = [
            (_support(effect, radius), rational(effect["weight"]) / weight) for effect in frictions
        ]
        parts |= {"support": together(shares), "weight": weight}
    middle = (ZERO, ZERO)
    if masses:  # one body of all masses
        sizes = [rational(effect["mass"]) for effect in masses]
        centers = [rational_pair(effect.get("center") or (0, 0)) for effect in masses]
        mass = sum(sizes, ZERO)
        middle = tuple(
            sum((m * c[i] for m, c in zip(sizes, centers, strict=True)), ZERO) / mass
            for i in (0, 1)
        )
        second = sum(
            (m * (rational(e["gyration_radius"]) ** 2 + (c[0] - middle[0]) ** 2 + (c[1] - middle[1]) ** 2)
             for m, c, e in zip(sizes, centers, masses, strict=True)), ZERO)  # fmt: skip
        parts |= {"mass": mass, "gyration": second / mass, "mass_center": middle}
    elif films:
        (film,) = films
        parts |= {"viscous": rational(film["coefficient"])}
        if not frictions:
            parts |= {"support": _support(film, radius)}
        elif together([(_support(film, radius), fmpq(1))])._moments != parts["support"]._moments:
            raise Undecided("a film on a support of its own")
    total = [arb(0)] * 3
    cosine, sine = at_degrees(psi).ball
    for load in loads:
        x, y = map(rational, load["force"])
        f_x, f_y = x * cosine + y * sine, y * cosine - x * sine
        at = middle if load.get("center") is None else rational_pair(load["center"])
        moment = (at[0] + length) * f_y - at[1] * f_x
        total = [a + b for a, b in zip(total, (f_x, f_y, moment), strict=True)]
    return Slider(Body(length=length, load=tuple(total), **parts), psi)


def _support(effect, radius):
    entry = dict(effect.get("support") or {"shape": "ring"})
    if entry["shape"] == "ring" and entry.get("radius") is None:
        entry["radius"] = radius
    return support(entry)


@precise
def differences(scene, angle, magnitude, solution):
    """Differences of a solution from the proved root, over what roundings allow; `Undecided` on a kink.

    A solution without contact has none; the fence's motion is the same as that of the library, in radians.
    """
    mode, slider = Mode[solution.mode.name], slider_of(scene)
    if mode is Mode.SEPARATE:
        return []
    if solution.pivot >= 0:
        raise Undecided("a pivot")
    degrees, size = at_degrees(in_exact_degrees(angle)), rational(magnitude)
    w, (c, s) = [size * part for part in degrees.ball], slider.rod
    u, spin = [arb(float(part)) for part in solution.contact_motion], arb(float(solution.twist[2]))
    guess = [u[0] * c + u[1] * s, u[1] * c - u[0] * s, spin]
    if mode is Mode.STICK:
        level = [w[0] * c + w[1] * s, w[1] * c - w[0] * s]
        equations = [
            torque,
            *(moves((i == 0, i == 1, 0), part, degrees.roundings) for i, part in enumerate(level)),
        ]
    else:
        contact = scene.contact
        law = Law(float(getattr(contact, "friction_coefficient", math.inf)))
        edge = cone_edge(law.friction_coefficient, SLIPS[mode]).about(slider.rod_angle)
        equations = [
            torque,
            force_along(edge.ball, edge.roundings),
            moves((s, c, 0), w[1], degrees.roundings),
        ]
    motion = with_roundings(slider.body, equations, *krawczyk(slider.body, equations, guess))
    numbers = motion.numbers(
        slider, lambda p: [*p.to_fence(p.u_x, p.u_y), p.omega, *p.to_fence(p.f_x, p.f_y)]
    )
    computed = (*solution.contact_motion, solution.twist[2], *solution.force)
    return [_ratio(number, float(value)) for number, value in zip(numbers, computed, strict=True)]


def _ratio(number: Number, value: float) -> float:
    off = abs(number.ball.mid() - value)
    return float(off / (number.allowance + abs(arb(value)) * arb(2) ** -52 + arb(2) ** -100))
