"""Loads and viscous friction over time, against closed forms, and what logs say of pivots and events."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from simulation.runs import check, final, heading, run

import planar_pushing as pp

METHODS = {
    "event-driven": ({"method": "event-driven"}, 1e-8),
    "time-stepping": ({"method": "time-stepping", "step": 1e-3}, 3e-3),
}
methods = pytest.mark.parametrize(("options", "tolerance"), METHODS.values(), ids=METHODS)
RING = pp.Ring(1.0)
#: A pusher that moves away from the slider.
AWAY = (0.0, -10.0)


def scene_of(*effects, mu=0.5, length=1.0, psi=np.pi / 2):
    slider = pp.Slider(rod_length=length, rod_angle=psi, radius=1.0)
    return pp.Scene(slider=slider, contact=pp.Coulomb(mu), effects=effects)


@methods
def test_a_slider_falls(options, tolerance):
    """Without support the center of mass moves on a parabola, and the rotation stays."""
    mass, pull = pp.Inertia(mass=2.0, gyration_radius=0.7), pp.Load(force=(0.6, 0.8))
    log = check(
        run(scene_of(mass, pull), AWAY, 2.0, twist=(0.1, 0.0, 0.3), samples=5, **options), 1e-7
    )
    end, start = log.isel(time=-1), log.isel(time=0)
    assert (end.twist - start.twist).values == pytest.approx([0.6, 0.8, 0.0], abs=tolerance)
    moved = (end.position - start.position).values
    assert moved == pytest.approx([0.1 * 2 + 0.6, 0.8], abs=tolerance)
    assert end.load_work == pytest.approx(0.6 * moved[0] + 0.8 * moved[1], abs=1e-9)
    assert np.rad2deg(0.6) == pytest.approx(float(end.rod_angle - start.rod_angle), abs=1e-6)


@methods
def test_a_load_beside_the_center_of_mass_turns_the_slider(options, tolerance):
    """The load keeps its direction in the world, so that the slider swings as a pendulum does."""
    moment, pull = 1.5 * 0.8**2, 0.9
    effects = (
        pp.Inertia(mass=1.5, gyration_radius=0.8),
        pp.Load(force=(0.0, pull), center=(0.5, 0.0)),
    )
    log = check(run(scene_of(*effects), AWAY, 3.0, samples=7, **options), 1e-7)
    assert log.rod_angle.values[-1] == pytest.approx(90.0, abs=1e-6)  # balanced, if unstable
    effects = (effects[0], pp.Load(force=(pull, 0.0), center=(0.5, 0.0)))
    log = check(run(scene_of(*effects), AWAY, 3.0, samples=7, **options), 1e-7)
    # The point is at half a radius along the rod, which turns by the angle.
    swing = solve_ivp(
        lambda t, y: (y[1], -pull * 0.5 * np.sin(y[0]) / moment),
        (0.0, 3.0), (np.pi / 2, 0.0), rtol=1e-11, atol=1e-11,
    )  # fmt: skip
    assert np.deg2rad(final(log, "rod_angle")) == pytest.approx(swing.y[0, -1], abs=tolerance)


@methods
def test_a_film_slows_a_slider_down(options, tolerance):
    """Speed and rotation decay by exp(-c t / m) and exp(-c R^2 t / J); the film takes the energy."""
    effects = (
        pp.Inertia(mass=2.0, gyration_radius=0.5),
        pp.Viscous(support=RING, coefficient=0.8),
    )
    log = check(
        run(scene_of(*effects), AWAY, 1.5, twist=(0.3, 0.4, -0.6), samples=4, **options), 1e-7
    )
    slower, turned = np.exp(-0.8 * 1.5 / 2.0), np.exp(-0.8 * 1.5 / 0.5)
    expected = [0.3 * slower, 0.4 * slower, -0.6 * turned]
    assert log.twist.values[-1] == pytest.approx(expected, abs=tolerance)
    lost = float(log.kinetic_energy[0] - log.kinetic_energy[-1])
    assert log.dissipated.values[-1].tolist() == pytest.approx([0.0, lost], abs=1e-8)


@methods
def test_a_load_and_a_film_have_a_terminal_velocity(options, tolerance):
    effects = (
        pp.Inertia(mass=0.1),
        pp.Viscous(support=RING, coefficient=2.0),
        pp.Load(force=(0.5, -1.0)),
    )
    log = check(run(scene_of(*effects), (0.0, -20.0), 2.0, samples=3, **options), 1e-7)
    assert log.twist.values[-1] == pytest.approx([0.25, -0.5, 0.0], abs=1e-8)


@methods
def test_a_film_beside_friction_adds_to_the_force(options, tolerance):
    """A translation along the normal: the force is W + c v, and the load takes from it."""
    effects = (
        pp.RingFriction(weight=1.5),
        pp.Viscous(support=RING, coefficient=0.8),
        pp.Load(force=(0.0, 0.4)),
    )
    log = check(run(scene_of(*effects), (0.0, 0.5), 1.0, samples=3, **options), 1e-7)
    assert log["mode"].values.tolist() == [pp.ContactMode.STICK] * len(log.time)
    assert log.force.values[-1] == pytest.approx([0.0, 1.5 + 0.8 * 0.5 - 0.4], abs=1e-8)
    assert log.dissipated.values[-1] == pytest.approx([0.75, 0.2, 0.0], abs=1e-8)
    assert final(log, "load_work") == pytest.approx(0.2, abs=1e-9)


@methods
def test_friction_holds_a_small_load_and_no_large_one(options, tolerance):
    """On a tilted table a slider stays where it is, or slides down with the rest of the load."""
    for pull, speed in ((0.9, 0.0), (1.3, 0.3)):
        effects = (pp.RingFriction(), pp.Inertia(), pp.Load(force=(pull, 0.0)))
        log = check(run(scene_of(*effects), (0.0, -1.0), 1.0, samples=3, **options), 1e-7)
        assert log.twist.values[-1] == pytest.approx([speed, 0.0, 0.0], abs=1e-7)


def test_two_effects_of_degree_one_share_the_load():
    parts = pp.RingFriction(weight=0.25), pp.RingFriction(weight=0.75)
    log, whole = (
        run(scene_of(*each, mu=2.0, length=2.0, psi=np.pi / 4), heading(60), 1.0)
        for each in (parts, [pp.RingFriction()])
    )
    assert final(log, "rod_angle") == pytest.approx(final(whole, "rod_angle"), abs=1e-10)
    expected = final(whole, "dissipated") * [0.25, 0.75]
    assert final(log, "dissipated") == pytest.approx(expected, rel=1e-9)
