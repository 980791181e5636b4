"""Certified pieces of what the figures plot: curves, cones, mappings and sectors of the study."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping, Sequence
from typing import Any

from flint import arb

from planar_pushing.certified.balls import in_degrees, rational, sign
from planar_pushing.certified.setting import Effects, heading, lean
from planar_pushing.evidence.golden.build import cells
from planar_pushing.evidence.golden.build.packing import Values
from planar_pushing.evidence.golden.build.scenes import Scene, slider_of

#: Plain values of a study.
Study = Mapping[str, Any]


def parameters(study: Study) -> dict[str, float]:
    """Parameters of the study's slider and effects."""
    radius = {"radius": study["slider"]["radius"]}
    return {**study["support_friction"], **study["inertia"], **radius}


def point(study: Study, effects: Effects, length: float, phi: float) -> Any:
    """Point of a limit curve at the study's rod angle."""
    psi = study["slider"]["rod_angle"]
    return cells.limit_point(parameters(study), effects, length, psi, phi)


def cone(study: Study, effects: Effects, length: float, mu: float) -> Any:
    """Friction cone and motion cone at the study's rod angle."""
    psi = study["slider"]["rod_angle"]
    return cells.motion_cone(parameters(study), effects, length, psi, mu)


def center(study: Study, length: float, phi: float, share: float) -> Any:
    """Acceleration center at the study's rod angle."""
    return cells.center(parameters(study), study["slider"]["rod_angle"], length, phi, share)


def curves(study: Study, effects: Effects, lengths: Sequence[float]) -> Values:
    """Limit curves of several rod lengths."""
    points = [
        [point(study, effects, each, phi) for phi in study["curve_angles"]] for each in lengths
    ]
    dims = ("rod_length", "force_angle")
    return {
        name: (dims, [[each[name] for each in row] for row in points])
        for name in ("force_x", "force_y")
    }


def mapping(study: Study, effects: Effects, length: float, mu: float) -> Values:
    """Edges of the friction cone and the force angles 45 and 90 degrees, mapped to motions."""
    edges = cone(study, effects, length, mu)
    inner = [point(study, effects, length, phi) for phi in (45.0, 90.0)]
    forces = [edges["limit_force_right"], *(p["force"] for p in inner), edges["limit_force_left"]]
    angles = [edges["friction_cone_right"], arb(45), arb(90), edges["friction_cone_left"]]
    motions = [
        edges["motion_cone_right"],
        *(each["motion_angle"] for each in inner),
        edges["motion_cone_left"],
    ]
    turns = [angle / 180 for angle in angles]
    pairs = list(zip(forces, turns, strict=True))
    return {
        "mapped_force_x": (("map",), [size * turn.cos_pi() for size, turn in pairs]),
        "mapped_force_y": (("map",), [size * turn.sin_pi() for size, turn in pairs]),
        "mapped_force_angle": (("map",), angles),
        "mapped_motion_angle": (("map",), motions),
    }


def sectors(scene: Scene) -> Values:
    """Sectors about the ring center that the seven cases allow, from the cuts between the cases."""
    slider, _ = slider_of(scene[0])
    psi, cuts = arb(slider.rod_angle), [arb(0), arb(slider.rod_angle), arb(180)]
    if slider.rod_length > 1:
        half = in_degrees((1 / arb(slider.rod_length)).asin())
        found = [psi + half, psi - half, psi + 180 - half, psi - 180 + half]
        cuts += [each for each in found if each > 0 and each < 180]
    cuts.sort(key=lambda each: float(each.mid()))
    starts, stops, outside = [], [], []
    for first, last in itertools.pairwise(cuts):
        middle = heading(float(((first + last) / 2).mid()))
        arm = slider.rod_length * lean(slider, middle)[1]
        turn = 90 * sign(arm)
        starts.append(first + turn)
        stops.append(last + turn)
        outside.append(sign(abs(arm) - 1) < 0)
    return {
        "sector_start": (("sector",), starts),
        "sector_stop": (("sector",), stops),
        "sector_outside": (("sector",), outside),
    }


def mode_set(record: cells.Record) -> int:
    """Code of the set of consistent modes: the sum of two to the power of each."""
    counts: Any = record["consistent"]
    return sum(1 << mode for mode, count in enumerate(counts) if count)


def friction_angle(mu: float) -> arb:
    """Angle of friction of a coefficient, degrees."""
    if math.isnan(mu):
        return arb.nan()
    return arb(90) if math.isinf(mu) else in_degrees(arb(rational(mu)).atan())
