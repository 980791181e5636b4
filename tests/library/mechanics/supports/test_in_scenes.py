"""Supports in effects and scenes: units, default radius, arrays, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr
from mechanics.supports.cases import SUPPORTS, TRIPOD, rectangle

import planar_pushing as pp

TWISTS = np.array([(0.3, -0.2, 0.5), (0.0, 0.0, -1.0), (1.0, 0.4, 0.0)])
BOX = rectangle(2.0, 1.0)


def scene(support, radius=None, contact=None):
    slider = pp.Slider(rod_length=3.0, rod_angle=0.8, radius=radius)
    effects = (pp.SupportFriction(support=support),)
    return pp.Scene(slider=slider, contact=contact or pp.Coulomb(0.7), effects=effects)


def test_a_ring_takes_the_radius_of_the_slider():
    slider = pp.Slider(rod_length=1.0, rod_angle=1.0, radius=2.5)
    for own in (pp.Ring(), pp.Ring(2.5)):
        found = pp.wrench(pp.SupportFriction(support=own, weight=1.3), TWISTS, slider)
        assert found == pytest.approx(pp.wrench(pp.RingFriction(weight=1.3), TWISTS, slider))
    assert pp.wrench(pp.SupportFriction(), TWISTS) == pytest.approx(
        pp.wrench(pp.SupportFriction(support=pp.Ring(1.0)), TWISTS)
    )


def test_another_ring_keeps_its_own_radius():
    slider = pp.Slider(rod_length=1.0, rod_angle=1.0, radius=2.5)
    small = pp.SupportFriction(support=pp.Ring(0.5))
    assert pp.wrench(small, TWISTS[1], slider) == pytest.approx([0, 0, -0.5])
    assert pp.potential(small, TWISTS[1], slider) == pytest.approx(0.5)


@pytest.mark.parametrize("name", SUPPORTS)
def test_the_radius_of_a_slider_is_the_reach_of_its_support(name):
    support, _ = SUPPORTS[name]
    assert scene(support).slider.radius == support.extent
    assert scene(support, 4.0).slider.radius == 4.0


@pytest.mark.parametrize("radius", [0.5, 7.0])
def test_the_radius_is_the_unit_of_the_spin_ratio_alone(radius):
    one, other = pp.solve(scene(BOX), 1.2), pp.solve(scene(BOX, radius), 1.2)
    assert one.modes == other.modes
    for mine, reference in zip(other, one, strict=True):
        assert mine.twist == pytest.approx(reference.twist, rel=1e-10)
        assert mine.force == pytest.approx(reference.force, rel=1e-10)
        scale = radius / BOX.extent
        assert mine.spin_ratio == pytest.approx(scale * reference.spin_ratio, rel=1e-10)


def test_labeled_supports_keep_their_names():
    members = np.array([BOX, TRIPOD, pp.Ring(1.0), None], dtype=object)[:-1]
    supports = xr.DataArray(members, dims="support", coords={"support": ["box", "tripod", "ring"]})
    angle = xr.DataArray([1.0, 2.0], dims="pusher_angle")
    found = pp.solve(scene(supports), angle)
    assert found.solutions.dims == ("support", "pusher_angle")
    for name, support in (("box", BOX), ("tripod", TRIPOD), ("ring", pp.Ring(1.0))):
        alone = pp.solve(scene(support), np.array([1.0, 2.0]))
        one = found.sel(support=name)
        assert np.array_equal(one.mode, alone.mode)
        assert np.allclose(one.force, alone.force, rtol=1e-12, atol=1e-14, equal_nan=True)


@pytest.mark.parametrize("support", ["disc", None, [], [BOX, "disc"]], ids=repr)
def test_what_is_no_support_is_refused(support):
    with pytest.raises(pp.InvalidValue) as caught:
        pp.SupportFriction(support=support)
    assert "support: " in str(caught.value)
    assert "construct one, or give your class" in str(caught.value)


@pytest.mark.parametrize("support", [BOX, pp.Ring(2.0)], ids=["box", "other ring"])
def test_a_push_through_the_centers_of_mass_and_of_pressure_translates(support):
    """A force along the rod meets the centers of both, so that nothing turns."""
    mass = pp.Inertia(mass=2.0, gyration_radius=0.5, center=(0.4, 0.0))
    slider = pp.Slider(rod_length=3.0, rod_angle=0.8, radius=1.0)
    each = pp.Scene(
        slider=slider, contact=pp.PerfectlyRough(),
        effects=(pp.SupportFriction(support=support, weight=1.0), mass),
    )  # fmt: skip
    (stick,) = pp.solve(each, 0.8, 5.0)  # along the rod, through both centers
    assert stick.twist[2] == pytest.approx(0.0, abs=1e-12)
    assert np.hypot(*stick.force) == pytest.approx(1.0 + 2.0 * 5.0, rel=1e-12, abs=0)
