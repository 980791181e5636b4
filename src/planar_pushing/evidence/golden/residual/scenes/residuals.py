"""Findings of every variable of a scene that is no flag and no parameter."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.certified.doubled.angles import cosine_sine, off_direction, radians
from planar_pushing.certified.doubled.numbers import Doubled, choose
from planar_pushing.evidence.golden.residual.centers import center, center_error, distance
from planar_pushing.evidence.golden.residual.edges import EDGE, SIDES, motion_edge, spin_ratios
from planar_pushing.evidence.golden.residual.finding import DEGREE, EPSILON, Finding, relative
from planar_pushing.evidence.golden.residual.motion import Shares, angle_error, line_at, shares
from planar_pushing.evidence.golden.residual.scenes.scene import Scene, read
from planar_pushing.evidence.golden.residual.scenes.solutions import solutions
from planar_pushing.evidence.golden.residual.spin import spin_ratio, steady
from planar_pushing.terms.options import EffectSet

#: Roundings of a part of a vector, and of a center.
PART, CENTER = 8, 64


def residuals(dataset: xr.Dataset, study: object) -> Iterable[Finding]:
    """Findings of every variable."""
    scene = read(dataset)
    ring = [part * (scene.length * scene.radius) for part in cosine_sine(radians(scene.rod_angle))]
    yield _vector(dataset, "ring_center", ring)
    angle = dataset["pusher_angle"].values
    yield Finding("pusher_angle", _pusher(scene, angle), EDGE * EPSILON * DEGREE)
    pushed = [part * scene.magnitude for part in cosine_sine(radians(angle))]
    yield _vector(dataset, "pusher_motion", pushed)
    yield from _cones(dataset, scene)
    yield from _samples(dataset, scene, ring)
    yield from solutions(dataset, scene)


def _vector(dataset: xr.Dataset, name: str, parts: list[Doubled]) -> Finding:
    wanted = Doubled(*(np.stack([getattr(p, half) for p in parts], -1) for half in ("high", "low")))
    return relative(name, dataset[name].values, wanted, PART)


def _pusher(scene: Scene, angle: Any) -> Any:
    """The fence moves at an angle, or as the slider does under a force; with both effects equal shares."""
    if scene.force_angle is None:
        return np.where(angle == scene.pusher_angle, 0.0, np.inf)
    line = line_at(scene.rod_angle, scene.force_angle)
    equal = scene.effects == EffectSet.BOTH
    parts = Shares(0.5, 0.5) if equal else shares(scene.effects, scene.slider)
    k = spin_ratio(lambda _: parts, scene.slider, line.aside * scene.length)
    return angle_error(angle, scene.force_angle, line, scene.length, k) * DEGREE


def _cones(dataset: xr.Dataset, scene: Scene) -> Iterable[Finding]:
    for side, sign in SIDES.items():
        forces, motions = (dataset[f"{kind}_cone_{side}"] for kind in ("friction", "motion"))
        error = np.abs(off_direction(radians(forces.values), *scene.edges[sign]).value())
        yield Finding(str(forces.name), error * DEGREE, EDGE * EPSILON * DEGREE)
        line = scene.line(sign)
        spins = spin_ratios(scene.effects, scene.slider, line.aside * scene.length)
        given = motions.values, forces.values, line, scene.length, spins, sign
        yield motion_edge(str(motions.name), *given)


def _samples(dataset: xr.Dataset, scene: Scene, ring: list[Doubled]) -> Iterable[Finding]:
    """Motions under each effect at even steps along the friction cone."""
    phi = dataset["cone_force_angle"].values
    right, left = (float(dataset[f"friction_cone_{side}"]) for side in SIDES)
    even = np.abs(phi - np.linspace(right, left, len(phi)))
    yield Finding("cone_force_angle", even, EDGE * EPSILON * DEGREE)
    line = line_at(scene.rod_angle, phi)
    arm = line.aside * scene.length
    arm = choose(np.abs(arm.high) < 8 * EPSILON * scene.length, 0.0, arm)
    kinds = scene.effects.split("+")
    spins = [spin_ratio(steady(kind, scene.slider), scene.slider, arm) for kind in kinds]
    motions = dataset["cone_motion_angle"].values
    errors = [
        angle_error(m, phi, line, scene.length, k) for m, k in zip(motions, spins, strict=True)
    ]
    allowed = EDGE * (1 + scene.length**2) * EPSILON * DEGREE
    yield Finding("cone_motion_angle", np.stack(errors) * DEGREE, allowed)
    rounding = (
        CENTER * EPSILON * (1 + scene.length / np.where(arm.high == 0, 1.0, np.abs(arm.high)))
    )
    found = [
        center_error(stored, center(ring, radians(phi), distance(k, scene.radius)), rounding)
        for stored, k in zip(dataset["cone_center"].values, spins, strict=True)
    ]
    yield Finding("cone_center", *(np.stack(each) for each in zip(*found, strict=True)))
