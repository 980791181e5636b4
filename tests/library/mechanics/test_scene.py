"""Effects as terms of a sum, and values of a scene."""

from __future__ import annotations

import dataclasses
import pickle

import numpy as np
import pytest
import xarray as xr
from mechanics.builders import BOTH, PSI, make_scene, names

import planar_pushing as pp
from planar_pushing.core.supports.rows import MASS, RING
from planar_pushing.mechanics.force.limit_curve import curve_of_unit_motions

PHI = np.linspace(0, np.pi, 13)
SPLIT_RING = (pp.RingFriction(weight=0.5), pp.RingFriction(weight=1.5))
WHOLE_RING = (pp.RingFriction(weight=2.0),)
SPLIT_MASS = (pp.Inertia(mass=1.0, gyration_radius=0.5), pp.Inertia(mass=3.0, gyration_radius=1.5))
WHOLE_MASS = (pp.Inertia(mass=4.0, gyration_radius=np.sqrt((1 * 0.25 + 3 * 2.25) / 4)),)

SUMS = {
    "friction": (SPLIT_RING, WHOLE_RING),
    "inertia": (SPLIT_MASS, WHOLE_MASS),
    "split friction": (SPLIT_RING + WHOLE_MASS, WHOLE_RING + WHOLE_MASS),
    "split inertia": (WHOLE_RING + SPLIT_MASS, WHOLE_RING + WHOLE_MASS),
    "split both": (SPLIT_RING + SPLIT_MASS, WHOLE_RING + WHOLE_MASS),
    "interleaved": (
        (SPLIT_MASS[0], SPLIT_RING[0], SPLIT_MASS[1], SPLIT_RING[1]),
        WHOLE_RING + WHOLE_MASS,
    ),
}
EVERY_SUM = pytest.mark.parametrize(("parts", "whole"), SUMS.values(), ids=SUMS)


@EVERY_SUM
@pytest.mark.parametrize("length", [0.3, 1.0, 3.0])
def test_parts_map_forces_to_motions_like_their_sum(parts, whole, length):
    one, other = (make_scene(length, effects=effects) for effects in (parts, whole))
    share = 0.4 if len({effect.degree for effect in whole}) == 2 else None
    expected = pp.motion_angle(other, PHI, share)
    assert pp.motion_angle(one, PHI, share) == pytest.approx(expected, abs=1e-13)
    assert pp.spin_ratio(one, PHI, share) == pytest.approx(
        pp.spin_ratio(other, PHI, share), rel=1e-13, abs=0
    )


@EVERY_SUM
@pytest.mark.parametrize("length", [0.3, 3.0])
def test_parts_have_the_cones_and_curves_of_their_sum(parts, whole, length):
    one, other = (make_scene(length, 2.0, effects) for effects in (parts, whole))
    cones = pp.motion_cone(one), pp.motion_cone(other)
    assert [cones[0].right, cones[0].left] == pytest.approx(
        [cones[1].right, cones[1].left], abs=1e-13
    )
    assert cones[0].closed == cones[1].closed
    curves = curve_of_unit_motions(one, PHI), curve_of_unit_motions(other, PHI)
    assert curves[0].magnitude == pytest.approx(curves[1].magnitude, rel=1e-13, abs=0)
    assert curves[0].motion_angle == pytest.approx(curves[1].motion_angle, abs=1e-13)


@EVERY_SUM
@pytest.mark.parametrize("degrees", [-8.0, 20.0, 80.0, 150.0, 175.0])
def test_parts_solve_like_their_sum(parts, whole, degrees):
    one, other = (
        pp.solve(make_scene(2.0, 2.0, effects), np.deg2rad(degrees), 0.7)
        for effects in (parts, whole)
    )
    assert names(one) == names(other)
    for a, b in zip(one, other, strict=True):
        assert a.force == pytest.approx(b.force, rel=1e-11, abs=1e-13)
        assert a.twist == pytest.approx(b.twist, rel=1e-11, abs=1e-13)


def test_order_of_the_effects_does_not_matter():
    scene, turned = make_scene(2.0, 2.0, BOTH), make_scene(2.0, 2.0, BOTH[::-1])
    assert pp.motion_cone(scene) == pp.motion_cone(turned)
    for degrees in (-5.0, 40.0, 170.0):
        found, same = (pp.solve(each, np.deg2rad(degrees)) for each in (scene, turned))
        assert names(found) == names(same)
        for a, b in zip(found, same, strict=True):
            assert a.force == pytest.approx(b.force, rel=1e-12, abs=0)


def test_degrees():
    assert pp.RingFriction().degree == 1
    assert pp.Inertia().degree == 2


def test_values_are_frozen():
    scene = make_scene(2.0, 2.0, BOTH)
    for value in (scene, scene.slider, scene.contact, *scene.effects, pp.motion_cone(scene)):
        field = next(iter(dataclasses.fields(value))).name
        with pytest.raises(dataclasses.FrozenInstanceError):
            setattr(value, field, None)
        assert hash(value) == hash(dataclasses.replace(value))


def test_scene_turns_a_list_of_effects_into_a_tuple():
    slider = pp.Slider(rod_length=1.0, rod_angle=PSI)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=list(BOTH))
    friction, inertia = BOTH
    assert scene.effects == (
        friction,
        dataclasses.replace(inertia, gyration_radius=1.0, center=(0.0, 0.0)),
    )
    assert slider.radius is None
    assert (scene.slider.radius, scene.slider.length_ratio) == (1.0, 1.0)


def test_scene_in_numbers():
    scene = pp.Scene(
        slider=pp.Slider(rod_length=3.0, rod_angle=PSI, radius=2.0),
        contact=pp.Coulomb(1.0),
        effects=(pp.Inertia(mass=5.0, gyration_radius=3.0), pp.RingFriction(weight=7.0)),
    )
    assert scene.slider.length_ratio == 1.5
    assert (scene.weight, scene.inertia) == (7.0, (5.0, 2.25))
    assert [(each.kind, each.number) for each in scene.rows.entries] == [(RING, 1), (MASS, 0)]
    assert len(make_scene(1.0, effects=BOTH[:1]).rows.entries) == 1
    assert len(make_scene(1.0, effects=BOTH[1:]).rows.entries) == 1
    assert scene.stores_energy
    assert not make_scene(1.0, effects=BOTH[:1]).stores_energy
    assert scene.friction == [pp.RingFriction(weight=7.0)]


def test_pairs_can_be_arrays_of_numpy():
    pair = np.array([-1, 2], "i4")
    for value, name in (
        (pp.Load(force=pair), "force"), (pp.Load(force=(0.0, 1.0), center=pair), "center"),
        (pp.Inertia(center=pair), "center"),
        (pp.Slider(rod_length=1.0, rod_angle=PSI, side=pair), "side"),
        (dataclasses.replace(make_scene(1.0), push=np.array([-1.0, 2.0])), "push"),
    ):  # fmt: skip
        found = getattr(value, name)
        assert found == (-1.0, 2.0)
        assert list(map(type, found)) == [float, float]


@pytest.mark.parametrize("given", [np.ones(3), np.ones((2, 2)), np.array([1.0, np.nan])])
def test_other_arrays_are_no_pairs(given):
    for make in (
        lambda: pp.Load(force=given), lambda: pp.Load(force=(1.0, 0.0), center=given),
        lambda: pp.Inertia(center=given),
        lambda: pp.Slider(rod_length=1.0, rod_angle=PSI, side=given),
        lambda: dataclasses.replace(make_scene(1.0), push=given),
    ):  # fmt: skip
        with pytest.raises(pp.InvalidValue):
            make()


def labeled(numbers, dim="case"):
    return xr.DataArray(numbers, dims=dim)


ONES, OTHERS = np.array([1.0, 2.0]), np.array([1.0, 2.5])
#: Makers of values from numbers.
VALUES = {
    "Coulomb": pp.Coulomb,
    "Slider": lambda x: pp.Slider(rod_length=x, rod_angle=1.0),
    "side": lambda x: pp.Slider(rod_length=1.0, rod_angle=1.0, side=(-x, 1.0)),
    "Inertia": lambda x: pp.Inertia(center=(0.0, x)),
    "Load": lambda x: pp.Load(force=(x, 1.0)),
    "RingFriction": lambda x: pp.RingFriction(weight=x),
    "SupportFriction": lambda x: pp.SupportFriction(weight=x),
    "Viscous": lambda x: pp.Viscous(support=pp.Disc(1.0), coefficient=x),
    "law of a scene": lambda x: dataclasses.replace(make_scene(1.0), contact=pp.Coulomb(x)),
    "effect of a scene": lambda x: make_scene(1.0, effects=(pp.RingFriction(weight=x),)),
}


@pytest.mark.parametrize("make", VALUES.values(), ids=VALUES)
def test_values_with_arrays_are_equal_or_not(make):
    one = make(ONES)
    assert (one == make(ONES.copy())) is True
    assert (one != make(ONES.copy())) is False
    for other in (OTHERS, 1.0, ONES[:1], labeled(ONES)):
        assert (one == make(other)) is False
        assert (make(other) == one) is False
    assert (make(np.ones(2)) == make(1.0)) is False
    assert (make(labeled(ONES)) == make(labeled(ONES))) is True
    assert (make(labeled(ONES)) == make(labeled(ONES, "other"))) is False
    assert (make(labeled(ONES).chunk()) == make(labeled(ONES))) is True
    assert one != 1.0
    assert make(1.0) == make(np.float64(1.0))
    assert hash(make(1.0)) == hash(make(1))


def test_arrays_of_laws_and_supports_are_compared():
    def scene(*numbers):
        support = np.array([pp.Disc(each) for each in numbers], dtype=object)
        return pp.Scene(
            slider=pp.Slider(rod_length=1.0, rod_angle=1.0),
            contact=[pp.Coulomb(each) for each in numbers],
            effects=(pp.SupportFriction(support=support),),
        )

    assert (scene(1.0, 2.0) == scene(1.0, 2.0)) is True
    assert (scene(1.0, 2.0) == scene(1.0, 3.0)) is False
    assert (scene(1.0, 2.0) == scene(1.0)) is False
    assert (scene(1.0, 2.0) == dataclasses.replace(scene(1.0, 2.0), push=(1.0, 1.0))) is True


def test_a_copy_in_another_process_computes_its_rows_itself():
    scene = make_scene(2.0, 0.5, [pp.RingFriction()])
    solutions = pp.solve(scene, 1.0)
    copied = pickle.loads(pickle.dumps(scene))
    assert "rows" in vars(scene)
    assert "rows" not in vars(copied)
    assert copied == scene
    assert pp.solve(copied, 1.0) == solutions
