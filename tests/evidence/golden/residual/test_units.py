"""Residuals hold in any units, and for any scene over time."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.evidence.golden.rules import RESIDUALS, RULES, Rule
from planar_pushing.study.build import build_dataset
from planar_pushing.study.catalog import AXES
from planar_pushing.study.files.study_model import (
    FrictionParameters,
    InertiaParameters,
    PushEntry,
    RingEntry,
)
from planar_pushing.study.slices import study_slice


@pytest.fixture(scope="module")
def study(smoke):
    """A study whose radius, weight and mass are not one."""
    parts = {
        "slider": RingEntry(radius=2.0, rod_angle=60.0),
        "support_friction": FrictionParameters(weight=3.0),
        "inertia": InertiaParameters(mass=0.5, gyration_radius=2.0),
    }
    return smoke.model_copy(update=parts)


def assert_verified(family, dataset, study):
    found = {each.variable: each for each in RESIDUALS[family](dataset, study)}
    assert set(found) == {name for name, rule in RULES[family].items() if rule == Rule.RESIDUAL}
    for name, each in found.items():
        assert np.all(each.error <= each.allowed), name


@pytest.mark.parametrize("name", AXES)
def test_grids(name, study):
    assert_verified(name, build_dataset(name, study_slice(study, name)), study)


def test_a_scene_without_a_radius(smoke, tmp_path):
    """The ring is given as a support, and its radius is left out."""
    (tmp_path / "scene.yaml").write_text(
        """title: A ring
slider: {rod_length: 2, rod_angle: 60}
contact: {law: coulomb, friction_coefficient: 2}
effects:
  - {type: support_friction, weight: 3, support: {shape: ring}}
  - {type: inertia, mass: 0.5, gyration_radius: 1.5}
""",
        encoding="utf-8",
    )
    push = PushEntry(file=str(tmp_path / "scene.yaml"), pusher_angle=100)
    pushed = smoke.model_copy(update={"scenes": {"one": push}})
    built = build_dataset("scenes", study_slice(pushed, "scenes"))
    assert_verified("scenes", built["one"], pushed)


@pytest.mark.parametrize("effects", ["friction", "inertia", "both"])
def test_motion_over_time(effects):
    friction, inertia = pp.RingFriction(weight=3.0), pp.Inertia(mass=0.5, gyration_radius=1.5)
    every = {"friction": (friction,), "inertia": (inertia,), "both": (friction, inertia)}
    slider = pp.Slider(rod_length=3.0, rod_angle=1.1, radius=2.0)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.4), effects=every[effects])
    pusher = pp.Pusher(velocity=[(0.0, (-0.3, 0.8)), (0.4, (0.5, 0.6))])
    log = pp.simulate(scene, pusher=pusher, duration=1.0, samples=21)
    assert_verified("simulations", log, None)
