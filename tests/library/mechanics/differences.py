"""Pushes in a frame along the fence at the slider's center, and central differences of their solutions."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

import planar_pushing as pp

#: Steps of the differences; the second tells how far they are from their limit.
STEP = 2e-5
SQUARE = ((1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0))
THIRDS = tuple((math.cos(a), math.sin(a)) for a in np.deg2rad([0, 120, 240]))
#: Kinds of random problems.
KINDS = (
    "ring", "polygon", "points", "inertia", "ring+inertia", "points+inertia", "viscous+polygon", "viscous",
    "viscous+points", "polygon+ring", "load+polygon", "load+points+inertia",
)  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Problem:
    """A push; `make` turns shapes that are given along the fence into effects, by a rotation."""

    motion: tuple[float, float]
    contact: tuple[float, float]
    mu: float | None
    strengths: tuple[float, ...]
    feet: tuple[float, ...]
    make: Any
    ratio: float | None = None
    angle: float = 0.0
    law: Any = None

    @property
    def scene(self):
        x, y = self.contact
        psi = np.arctan2(-y, -x)
        turn = np.array([[np.cos(psi), np.sin(psi)], [-np.sin(psi), np.cos(psi)]])
        slider = pp.Slider(rod_length=np.hypot(x, y), rod_angle=psi, radius=1.0)
        effects = self.make(self.strengths, self.feet, turn)
        law = self.law if self.mu is None else pp.Coulomb(self.mu)
        return pp.Scene(slider=slider, contact=law, effects=effects)

    @property
    def solutions(self):
        u_x, u_y = self.motion
        return pp.solve(self.scene, np.arctan2(u_y, u_x), np.hypot(u_x, u_y), derivatives=True)

    @property
    def of_force(self):
        return pp.motion_of_force(self.scene, self.angle, self.ratio, derivatives=True)


def changed(problem, name, i, by):
    """The problem with a number of one of its fields changed."""
    value = getattr(problem, name)
    if not isinstance(value, tuple):
        return replace(problem, **{name: value + by})
    return replace(problem, **{name: (*value[:i], value[i] + by, *value[i + 1 :])})


def values_of(derivatives):
    """All derivatives, in one row."""
    return np.concatenate([np.ravel(getattr(derivatives, x.name)) for x in fields(derivatives)[1:]])


def numbers(each):
    return np.array([*each.twist, *each.force])


def same_solution(problem, each):
    """The solution of the same mode that is nearest to one."""
    found = [s for s in problem.solutions if s.mode is each.mode and s.pivot == each.pivot]
    if not found:
        return np.full(5, np.nan)
    return min((numbers(s) for s in found), key=lambda n: np.abs(n - numbers(each)).max())


def differences(problem, name, i, numbers_of):
    """Central differences of numbers by a number of the problem, and an estimate of their error."""

    def slope(step):
        ahead, back = (changed(problem, name, i, sign * step) for sign in (1, -1))
        return (numbers_of(ahead) - numbers_of(back)) / (2 * step)

    wide, narrow = slope(STEP), slope(STEP / 2)
    return (4 * narrow - wide) / 3, np.abs(wide - narrow)


PARTS = {"motion": "motion", "contact": "point", "mu": "mu", "strengths": "strength", "feet": "foot",
         "angle": "angle", "ratio": "ratio"}  # fmt: skip


def given_columns(problem, by, names):
    """Each number of the problem, and the derivatives by it of twist and force."""
    for name in names:
        value = getattr(problem, name)
        twist = getattr(by, f"twist_by_{PARTS[name]}")
        force = getattr(by, f"force_by_{PARTS[name]}")
        for i in range(len(value) if isinstance(value, tuple) else int(value is not None)):
            own = (..., i) if isinstance(value, tuple) else ...
            yield name, i, np.concatenate([twist[own], force[own]])


def polygon(corners, turn):
    return pp.Polygon(np.asarray(corners) @ turn.T)


def points(places, loads, turn):
    return pp.Points(np.asarray(places) @ turn.T, loads)


def random_problem(rng, kind):
    """A push of a slider with the effects that a kind names."""
    count = int(rng.integers(3, 6))
    places = rng.uniform(-1, 1, (count, 2))
    corners = SQUARE * rng.uniform(0.3, 1, 2) + rng.uniform(-0.3, 0.3, 2)
    masses, pull = rng.uniform(-0.4, 0.4, 2), rng.uniform(-0.2, 0.2, 2)
    gyration = rng.uniform(0.3, 1.2)
    names = kind.split("+")

    def make(strengths, feet, turn):
        def effect(name, strength):
            x, y = turn @ masses
            if name == "ring":
                return pp.RingFriction(weight=strength)
            if name == "polygon":
                return pp.SupportFriction(support=polygon(corners, turn), weight=strength)
            if name == "points":
                own = points(places, feet, turn)
                return pp.SupportFriction(support=own, weight=strength / sum(loads) * sum(feet))
            if name == "viscous":
                return pp.Viscous(support=polygon(corners, turn), coefficient=strength)
            if name == "load":
                return pp.Load(force=tuple(strength * pull), center=(x, y))
            return pp.Inertia(mass=strength, gyration_radius=gyration, center=(x, y))

        return tuple(effect(name, each) for name, each in zip(names, strengths, strict=True))

    loads = tuple(rng.uniform(0.2, 1, count)) if "points" in names else ()
    strengths = tuple(
        sum(loads) if name == "points" else 1.0 if name == "load" else rng.uniform(0.5, 2)
        for name in names
    )
    mu = (
        float(rng.choice([0.1, 0.4, 1.0, 3.0]) * rng.uniform(0.8, 1.2))
        if rng.random() < 0.8
        else None
    )
    law = None if mu is not None else [pp.InfiniteFriction(), pp.PerfectlyRough()][rng.integers(2)]
    open_magnitude = len({"inertia", "viscous"} & set(names)) and len(
        {"ring", "polygon", "points", "load"} & set(names)
    )
    angle = rng.uniform(-0.5, np.pi + 0.5)
    return Problem(
        motion=(float(np.cos(angle)) * 1.3, float(np.sin(angle)) * 1.3),
        contact=(float(rng.uniform(-1, 1)), float(rng.uniform(-2, -0.2))), mu=mu, law=law,
        strengths=strengths, feet=loads, make=make, angle=float(rng.uniform(0, np.pi)),
        ratio=float(rng.uniform(1.5, 4)) if open_magnitude else None,
    )  # fmt: skip


def assert_differences(problem, by, names, numbers_of, here):
    """Derivatives are the limits of differences, to their estimated error and the rounding of the steps."""
    for name, i, found in given_columns(problem, by, names):
        limit, error = differences(problem, name, i, numbers_of)
        size = 1.0 + np.abs(limit).max() + np.abs(here).max()
        off = np.abs(found - limit).max()
        assert off <= 4.0 * error.max() + 1e-9 * size, (name, i, found, limit)


def assert_same(problem, each):
    """The derivatives of a solution are the limits of differences of the solutions of its mode."""
    names = "motion", "contact", "mu", "strengths", "feet"
    assert_differences(
        problem, each.derivatives, names, lambda p: same_solution(p, each), numbers(each)
    )
