"""Without inertia, the modes at an instant of a log are those of a push from rest, which `solve` finds."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

import planar_pushing as pp

RING = (pp.RingFriction(),)
LOAD = pp.Load(force=(0.05, 0.226))
FILM = pp.Viscous(support=pp.Ring(), coefficient=0.4)
SQUARE = pp.SupportFriction(support=pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)]))
FEET = pp.SupportFriction(
    support=pp.Points([(-1.26, -0.61), (-0.14, -0.43), (-0.12, -0.13)], weights=(0.34, 0.7, 0.77))
)
TWO_FEET = pp.SupportFriction(support=pp.Points([(-1.0, 0.0), (1.0, 0.0)]))
#: Effects, length and angle of the rod, friction coefficient, and velocity of the fence.
CASES = {
    "ring": (RING, 2.0, 0.8, 0.5, (0.3, 1.0)),
    "slips": (RING, 2.0, 0.8, 0.1, (0.9, 0.4)),
    "frictionless": (RING, 2.0, math.pi / 2, 0.0, (0.0, 1.0)),
    "frictionless, aside": (RING, 2.0, math.pi / 2, 0.0, (0.4, 1.0)),
    "through the center": ((SQUARE,), 2.0, math.pi / 2, 0.5, (0.0, 1.0)),
    "along the fence": (RING, 2.0, 0.8, 0.5, (1.0, 0.0)),
    "contact at the center": (RING, 0.0, 0.8, 0.5, (0.2, 1.0)),
    "retreats": (RING, 2.0, 0.8, 4.0, (0.9, -0.2)),
    "two feet": ((TWO_FEET,), 1.0, 0.6, 0.5, (0.3, 1.0)),
    "three feet": ((FEET,), 2.1, 1.74, 0.5, (-0.23, 1.5)),
    "load, infinite friction": ((FEET, LOAD), 2.1, 1.74, None, (-0.23, 1.5)),
    "load, slips": ((*RING, LOAD), 2.0, 0.8, 0.2, (0.9, 0.6)),
    "film": ((*RING, FILM), 2.0, 0.8, 0.5, (0.3, 1.0)),
    "film alone": ((FILM,), 2.0, 0.8, 0.2, (0.8, 0.5)),
    "film and load": ((SQUARE, FILM, LOAD), 1.0, 1.2, 0.3, (-0.8, 1.0)),
}


@pytest.mark.parametrize("name", CASES)
def test_a_log_counts_the_modes_of_the_mechanics(name):
    effects, length, angle, friction, velocity = CASES[name]
    law = pp.InfiniteFriction() if friction is None else pp.Coulomb(friction)
    slider = pp.Slider(rod_length=length, rod_angle=angle)
    scene = pp.Scene(slider=slider, contact=law, effects=effects)
    log = pp.simulate(scene, pusher=pp.Pusher(velocity=velocity), duration=1.0, samples=9)
    assert log.stopped == ""
    for instant in (log.isel(time=i) for i in range(log.sizes["time"])):
        if instant.event != pp.Event.NONE or instant.gap > 0:
            continue  # at an event two modes meet
        turned = replace(slider, rod_angle=math.radians(instant.rod_angle))
        solutions = pp.solve(
            replace(scene, slider=turned), math.atan2(*velocity[::-1]), math.hypot(*velocity)
        )
        assert instant.solutions == len(solutions)
        modes = {solution.mode: solution for solution in solutions}
        if instant.mode.item() in modes:
            force = modes[instant.mode.item()].force
            assert instant.force.values == pytest.approx(np.array(force), rel=1e-7, abs=1e-9)


STOPS = {"ring": RING, "ring and load": (*RING, pp.Load(force=(0.02, 0.01))), "square": (SQUARE,)}


@pytest.mark.parametrize("inertia", [(), (pp.Inertia(mass=0.1),)], ids=["slow", "inertia"])
@pytest.mark.parametrize("name", STOPS)
def test_a_pusher_that_retreats_pushes_again_where_it_has_come_back(name, inertia):
    """It stops at 1, retreats until 2 by 2 / pi, and is back at 3."""
    slider = pp.Slider(rod_length=1.0, rod_angle=1.2)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.5), effects=(*STOPS[name], *inertia))
    pusher = pp.Pusher(
        velocity=lambda t: (0.0, math.sin(math.pi * t) + (0.2 if t > 2.5 else 0.0)), breakpoints=[2.5]
    )  # fmt: skip
    log = pp.simulate(scene, pusher=pusher, duration=3.5, samples=8)
    stepped = pp.simulate(
        scene, pusher=pusher, duration=3.5, samples=8, method="time-stepping", step=1e-3
    )
    rests = log.sel(time=slice(1.1, 2.6))
    assert (rests.gap > 0).all()
    assert (rests["mode"] == pp.ContactMode.SEPARATE).all()
    assert float(np.ptp(rests.rod_angle.values)) == 0.0
    touches = log.time[log.event == pp.Event.TOUCHES].values
    # The gap is (1 + cos(pi t)) / pi, less what 0.2 adds from 2.5 on.
    assert ((1 + np.cos(np.pi * touches[:1])) / np.pi) == pytest.approx(0.2 * (touches[:1] - 2.5))
    shared = log.sel(time=stepped.time, method="nearest")
    assert shared.rod_angle.values == pytest.approx(stepped.rod_angle.values, abs=0.5)


REVERSALS = {
    "load": (*RING, pp.Load(force=(0.1, -0.2))),
    "film": (*RING, FILM),
    "film and load": (SQUARE, FILM, pp.Load(force=(0.1, -0.2))),
    "feet, load": (FEET, pp.Load(force=(-0.08, -0.004), center=(0.35, 0.63))),
}


@pytest.mark.parametrize("shape", ["fence", "finger"])
@pytest.mark.parametrize("name", REVERSALS)
def test_a_slip_ends_where_the_pusher_turns_back(name, shape):
    """Under loads and viscous friction the slider comes to rest with the pusher's normal velocity."""
    slider = pp.Slider(rod_length=2.0, rod_angle=0.8)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.5), effects=REVERSALS[name])
    pusher = pp.Pusher(velocity=lambda t: (math.sin(3 * t), math.cos(2 * t)), shape=shape)
    log = pp.simulate(scene, pusher=pusher, duration=1.5, samples=16)
    stepped = pp.simulate(
        scene, pusher=pusher, duration=1.5, samples=16, method="time-stepping", step=1e-4
    )
    assert log.stopped == ""
    assert np.isfinite(log.position).all()
    shared = log.sel(time=stepped.time, method="nearest")
    assert shared.rod_angle.values == pytest.approx(stepped.rod_angle.values, abs=0.05)
    assert shared.position.values == pytest.approx(stepped.position.values, abs=2e-3)
