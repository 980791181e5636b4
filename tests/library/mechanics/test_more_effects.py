"""Loads, viscous friction, and the magnitude of a force, against values of an outside computation."""

from __future__ import annotations

import numpy as np
import pytest

import planar_pushing as pp

SLIDER = pp.Slider(rod_length=2.0, rod_angle=np.pi / 4, radius=1.0)
RING = pp.RingFriction()


def scene(*effects, contact=None):
    return pp.Scene(slider=SLIDER, contact=contact or pp.InfiniteFriction(), effects=effects)


@pytest.mark.parametrize(
    ("force", "cone"),
    [
        ((0.0, -0.3), (-40.602404, 157.663777)),
        ((0.3, 0.0), (-29.819697, 145.278721)),
        ((-0.3, 0.0), (-34.721279, 150.180303)),
    ],
)
def test_a_load_turns_the_motion_cone(force, cone):
    for effects in ((RING, pp.Load(force=force)), (pp.Load(force=force), RING)):
        assert pp.motion_cone(scene(*effects)).degrees == pytest.approx(cone, abs=1e-6)


def test_a_load_at_the_contact_shifts_the_force():
    """There it is a part of the pusher's own force."""
    load = pp.Load(force=(0.1, -0.2), center=(-2.0, 0.0))
    for angle in (0.4, 1.2, 2.0):
        (without,) = (s for s in pp.solve(scene(RING), angle) if s.mode == pp.ContactMode.STICK)
        found = pp.solve(scene(RING, load, contact=pp.PerfectlyRough()), angle)
        (loaded,) = (s for s in found if s.mode == pp.ContactMode.STICK)
        assert loaded.force == pytest.approx(without.force - [0.1, -0.2], abs=1e-13)
        assert loaded.twist == pytest.approx(without.twist, abs=1e-13)


def test_viscous_friction_resists_like_a_mass_at_the_center_of_pressure():
    """A square of side 2: the mean square of the distance from its center is 2/3."""
    square = pp.Polygon([(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)])
    viscous = scene(RING, pp.Viscous(support=square, coefficient=0.7))
    mass = scene(RING, pp.Inertia(mass=0.7, gyration_radius=(2 / 3) ** 0.5))
    for angle in (-0.2, 0.9, 2.9):
        one, other = pp.solve(viscous, angle, 1.3), pp.solve(mass, angle, 1.3)
        assert one.modes == other.modes
        for a, b in zip(one, other, strict=True):
            assert a.force == pytest.approx(b.force, abs=1e-13)


def test_viscous_friction_is_absent_from_a_push_from_rest_with_inertia():
    heavy = RING, pp.Inertia()
    film = pp.Viscous(support=pp.Disc(1.0), coefficient=3.0)
    assert pp.solve(scene(*heavy, film), 0.7) == pp.solve(scene(*heavy), 0.7)


def test_the_force_determines_the_motion_where_the_acceleration_does_not():
    """With the mass aside two motions share m a / W = 0.235787; this one has |f| = 0.8415 W."""
    aside = scene(RING, pp.Inertia(gyration_radius=0.5, center=(-0.5, 0.0)))
    angle = pp.motion_angle(aside, np.deg2rad(150), force_ratio=[0.8415, 0.1])
    assert np.rad2deg(angle[0]) == pytest.approx(138.605, abs=1e-3)
    assert np.isnan(angle[1])  # friction holds the slider
    with pytest.raises(pp.InvalidValue, match="force_ratio"):
        pp.motion_angle(aside, 1.0, 0.3)


@pytest.mark.parametrize(
    "call", [pp.motion_cone, lambda s: pp.solve(s, 1.0)], ids=["cone", "solve"]
)
def test_a_load_that_friction_cannot_hold_is_refused_with_its_excess(call):
    """Through the center of the ring friction holds W, and at a distance less."""
    call(scene(RING, pp.Load(force=(0.6, -0.79))))
    with pytest.raises(pp.InvalidValue, match=r"1\.25 times"):
        call(scene(RING, pp.Load(force=(0.75, -1.0))))
    with pytest.raises(pp.InvalidValue, match="times"):
        call(scene(RING, pp.Load(force=(0.6, -0.79), center=(0.0, 1.0))))


def test_with_inertia_a_load_moves_a_slider_that_nothing_pushes():
    """Frictionless it falls freely; friction takes W off a load through the center of the ring."""
    load = pp.Load(force=(0.0, 2.0))
    for effects, fall in (((pp.Inertia(),), 2.0), ((RING, pp.Inertia()), 1.0)):
        found = pp.solve(scene(*effects, load), np.pi / 2, 0.5)
        assert found.modes[0] is pp.ContactMode.SEPARATE
        assert found[0].contact_motion == pytest.approx([0.0, fall], abs=1e-12)
        faster = pp.solve(scene(*effects, load), np.pi / 2, 3.0)
        assert pp.ContactMode.SEPARATE not in faster.modes


def test_a_load_has_a_direction_in_the_world():
    """Beside a slider its wrench is turned into the body frame; alone it is refused."""
    slider = pp.Slider(rod_length=1.0, rod_angle=np.pi / 2)
    pull = pp.Load(force=(0.3, -0.2))
    for twist in ([0.0, 0.0, 0.0], [1.0, 2.0, 0.5]):
        assert pp.wrench(pull, twist, slider) == pytest.approx([0.2, 0.3, 0.0], abs=1e-15)
    with pytest.raises(pp.InvalidValue, match="slider: None given; allowed: a Slider for a Load"):
        pp.wrench(pull, [1.0, 0.0, 0.0])


@pytest.mark.parametrize(
    "function", [pp.motion_cone, lambda scene: pp.motion_angle(scene, 1.0, force_ratio=1.0)]
)
def test_directions_under_a_load_without_friction_are_refused(function):
    scene = pp.Scene(
        slider=pp.Slider(rod_length=1.0, rod_angle=1.0), contact=pp.Coulomb(0.5),
        effects=(pp.Inertia(), pp.Load(force=(0.1, 0.0))),
    )  # fmt: skip
    with pytest.raises(
        pp.InvalidValue, match=r"effects: .* allowed: friction together with a load; use solve"
    ):
        function(scene)
