"""A scene pays for the effects that it lists, and for no other."""

from collections import Counter
from dataclasses import dataclass

import numpy as np
import pytest
import scipy

import planar_pushing as pp
from planar_pushing.evidence.costs.counted import counted_scene
from planar_pushing.evidence.costs.effects import OPERATIONS, measure
from planar_pushing.study.study_file import load_study

FRICTION, INERTIA = pp.RingFriction(), pp.Inertia()
LAWS = [pp.Coulomb(2.0), pp.InfiniteFriction(), pp.PerfectlyRough()]


def scene(effects, contact=LAWS[0]):
    slider = pp.Slider(rod_length=2.0, rod_angle=np.deg2rad(45))
    return pp.Scene(slider=slider, contact=contact, effects=effects)


@dataclass(frozen=True)
class Untouchable:
    """An effect that allows nobody to evaluate it."""

    degree: int

    def __getattr__(self, name):
        raise AssertionError(f"{name} of an absent effect")


def run_everything(given):
    for operation in OPERATIONS.values():
        operation(given)
    for angle in (-10, 0, 90, 165, 180):
        pp.solve(given, np.deg2rad(angle))


@pytest.mark.parametrize("degree", [1, 2])
def test_an_effect_that_raises_is_caught_where_it_is_listed(degree):
    with pytest.raises(AssertionError, match="of an absent effect"):
        run_everything(scene((FRICTION, Untouchable(degree))))


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize(("listed", "absent"), [(FRICTION, pp.Inertia), (INERTIA, pp.RingFriction)])
def test_an_absent_effect_is_never_touched(monkeypatch, law, listed, absent):
    def touched(*_):
        raise AssertionError(f"{absent.__name__} is not listed")

    for method in ("scaled", "potential", "wrench", "profile", "spin_ratio"):
        monkeypatch.setattr(absent, method, touched)
    run_everything(scene((listed,), law))


def test_inertia_alone_evaluates_no_elliptic_integral(monkeypatch):
    def evaluated(*_, **__):
        raise AssertionError("an elliptic integral was evaluated")

    for name in ("ellipe", "ellipk", "ellipkm1"):
        monkeypatch.setattr(scipy.special, name, evaluated)
    run_everything(scene((INERTIA,)))
    with pytest.raises(AssertionError, match="elliptic"):
        run_everything(scene((FRICTION,)))


@pytest.mark.parametrize(
    ("effects", "counted"),
    [((FRICTION,), {"support_friction"}), ((INERTIA,), {"inertia"}),
     ((FRICTION, INERTIA), {"support_friction", "inertia"})],
)  # fmt: skip
def test_counting_counts_what_is_listed_and_changes_no_result(effects, counted):
    given, tally = scene(effects), Counter()
    watched = counted_scene(given, tally)
    assert pp.motion_cone(watched) == pp.motion_cone(given)
    assert len(pp.solve(watched, -0.2)) == len(pp.solve(given, -0.2))
    assert set(tally) == counted


@pytest.fixture(scope="module")
def measured():
    study = load_study("workflow/config/smoke.yaml")
    grid = study.grid.model_copy(update={"rod_length": (0.0, 2.0), "pusher_angle": (-10.0, 165.0)})
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("planar_pushing.evidence.costs.effects.REPEATS", 1)
        return measure(study.model_copy(update={"grid": grid}))


def test_only_listed_effects_are_evaluated_anywhere(measured):
    for effect in measured.effect.values:
        listed = [effect in effects.split("+") for effects in measured.effects.values]
        assert ((measured.evaluations.sel(effect=effect) > 0).values == listed).all()


def test_times_are_measured_for_every_case(measured):
    assert measured.time.dims == ("case", "repeat")
    assert (measured.time > 0).all()
