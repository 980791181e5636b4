"""A pusher that turns back: the slider rests where it is left, and is pushed again where it is met."""

from __future__ import annotations

import math

import numpy as np
import pytest

import planar_pushing as pp

RING = (pp.RingFriction(),)
FILM = pp.Viscous(support=pp.Ring(), coefficient=0.4)
SQUARE = pp.SupportFriction(support=pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)]))
FEET = pp.SupportFriction(
    support=pp.Points([(-1.26, -0.61), (-0.14, -0.43), (-0.12, -0.13)], weights=(0.34, 0.7, 0.77))
)

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
