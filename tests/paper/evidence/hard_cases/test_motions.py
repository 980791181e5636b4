"""Hard motions over time: references on other routes, errors of the library, and what is hard in each."""

import json

import numpy as np
import pytest
from flint import arb, ctx

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.terms.options import Event
from pulling_by_pushing.evidence.hard_cases import integrator, motion_references, quadrature
from pulling_by_pushing.evidence.hard_cases.dataset import measure_motion
from pulling_by_pushing.evidence.hard_cases.motion_references import (
    DIGITS,
    agreeing_digits,
    by_oracle,
    conditions,
    main,
)
from pulling_by_pushing.evidence.hard_cases.motions import (
    MOTIONS,
    ORACLE,
    QUADRATURE,
    RTOL,
    HardMotion,
    Reference,
    label,
    outcomes,
    run,
    stored_references,
)
from pulling_by_pushing.oracle.balls import Undecided

BY_NAME = {motion.name: motion for motion in MOTIONS}
EPS = float(np.finfo(float).eps)
#: Accumulated errors over a run, in units of the tolerance of a step.
STEPS = 16


@pytest.fixture(scope="module")
def found():
    return {outcome.label: outcome for outcome in outcomes()}


def test_every_stored_reference_belongs_to_a_motion(found):
    assert found.keys() == stored_references().keys()
    assert {reference.route for reference in stored_references().values()} == {
        motion.route for motion in MOTIONS
    }
    for motion in MOTIONS:
        of_motion = [r.reference for r in found.values() if r.label.endswith(f", {motion.name}")]
        assert [reference.route for reference in of_motion] == [motion.route] * 2


def test_errors_are_of_the_size_of_the_tolerance(found):
    for outcome in found.values():
        error = measure_motion(outcome).error_ulp * EPS
        assert error <= STEPS * RTOL * (1 + outcome.reference.condition), outcome.label


def test_a_wrong_result_has_a_large_error(found):
    for outcome in found.values():
        wrong = outcome._replace(result=outcome.result * (1 + 1e-9))
        assert measure_motion(wrong).error_ulp > 1e-10 / EPS


def numbers_by_quadrature(motion, level=4):
    with ctx.workprec(quadrature.BITS):
        return motion_references._by_level(motion, level)


@pytest.mark.parametrize(
    "motion", [m for m in MOTIONS if m.mass is None and m.pieces == 1], ids=lambda m: m.name
)
def test_references_without_inertia_follow_from_a_quadrature(motion):
    for quantity, number in numbers_by_quadrature(motion).items():
        reference = stored_references()[label(quantity, motion)]
        with ctx.workprec(quadrature.BITS):
            assert abs(number - arb(reference.value)) < abs(number) * arb(10) ** (
                1 - reference.digits
            )


def test_the_oracle_agrees_with_a_quadrature_over_contact_changes():
    motion = HardMotion(
        name="few changes", route=ORACLE, length=2.0, angle=45.0, mu=0.3, pusher=150.0,
        duration=4 / 1024, pieces=4,
    )  # fmt: skip
    exact = by_oracle(motion)["rod_angle"][0]
    with ctx.workprec(quadrature.BITS):
        angle = motion_references._radians(motion.angle)
        for i in range(motion.pieces):
            way = motion_references._radians(180.0 - motion.pusher if i % 2 else motion.pusher)
            push = quadrature.Push(arb(2), arb(motion.mu), (way.cos().mid(), way.sin().mid()))
            angle = quadrature.follow(push, angle, arb(1) / 1024, 3)[-1].angle
        assert abs(angle * 180 / arb.pi() - exact) < 1e-20
    way = np.deg2rad(motion.pusher)
    fence = float(np.cos(way)), float(np.sin(way))
    last, _ = integrator.alternate(2.0, np.pi / 4, motion.mu, fence, motion.pieces, 1 / 1024, 2)
    assert np.rad2deg(last) == pytest.approx(float(exact), rel=1e-14)


def test_the_integrator_agrees_with_the_library_on_a_mass_that_is_less_stiff():
    motion = HardMotion(
        name="light", route="integrator", length=2.0, angle=45.0, mu=0.5, pusher=110.0,
        duration=0.5, mass=1e-3,
    )  # fmt: skip
    way, log = np.deg2rad(motion.pusher), run(motion)
    light = integrator.Light(2.0, np.pi / 4, 0.5, 1e-3, (np.cos(way), np.sin(way)))
    ends, angle, slip = integrator.follow(light, motion.duration, 1e-10)
    assert np.rad2deg(angle) == pytest.approx(float(log.rod_angle[-1]), abs=1e-8)
    assert slip == pytest.approx(float(log.slip[-1]), abs=1e-10)
    assert ends == pytest.approx(
        float(log.time.values[log.event.values == Event.SLIP_ENDS][0]), abs=1e-9
    )


def test_a_fast_slider_is_refused_by_the_integrator():
    light = integrator.Light(2.0, np.pi / 4, 0.1, 1e-3, (-1.0, 0.1))
    with pytest.raises(ArithmeticError, match="slips during the impact"):
        integrator.follow(light, 1.0, 1e-6)


def test_a_contact_that_sticks_is_refused_by_alternating_slips():
    with pytest.raises(ArithmeticError, match="does not slip against"):
        integrator.alternate(2.0, np.pi / 4, 2.0, (0.1, 1.0), 2, 0.1, 1)


def test_a_slip_on_feet_is_refused_by_the_quadrature():
    tripod = BY_NAME["center that crosses a foot"]
    with pytest.raises(Undecided, match="for the ring alone"):
        numbers_by_quadrature(HardMotion(**{**fields_of(tripod), "mu": 0.05}), 2)


def fields_of(motion):
    return {name: getattr(motion, name) for name in HardMotion.__dataclass_fields__}


def test_what_is_hard_in_each_motion_happens():
    logs = {name: run(motion) for name, motion in BY_NAME.items()}
    events = {name: log.event.values.tolist() for name, log in logs.items()}
    assert Event.SLIP_ENDS in events["slip that dies"]
    assert Event.SLIP_ENDS in events["mass of a millionth"]
    modes = logs["thousand contact changes"]["mode"].values
    assert np.count_nonzero(np.diff(modes[:-1])) == 999
    assert {ContactMode.SLIP_RIGHT, ContactMode.SLIP_LEFT} == set(modes.tolist())
    assert logs["side that rocks down"].flush.values[-1]
    gap = logs["grazing contact"]["gap"].values
    assert gap[0] > 0
    assert gap.min() == 0
    places = quadrature_places("center that crosses a foot")
    assert [round(float(place.angle * 180 / arb.pi()), 9) for place in places[1:-1]] == [20.0]


def quadrature_places(name):
    motion = BY_NAME[name]
    with ctx.workprec(quadrature.BITS):
        angle = motion_references._radians(motion.pusher)
        feet = tuple(quadrature.Foot(arb(x), arb(y), arb(1) / 3) for x, y in motion.feet)
        push = quadrature.Push(
            arb(motion.length), arb(motion.mu), (angle.cos().mid(), angle.sin().mid()), feet
        )
        return quadrature.follow(push, motion_references._radians(motion.angle), arb(1), 3)


def test_digits_are_those_on_which_two_steps_agree():
    assert agreeing_digits((arb(2), arb(2))) == DIGITS
    assert agreeing_digits((arb("1.00001"), arb(1))) in (4, 5)


def test_conditions_are_those_of_a_known_law():
    """The side that rocks down later for a slower fence: the time is inverse to the speed."""
    motion = BY_NAME["side that rocks down"]
    slower = HardMotion(**{**fields_of(motion), "speed": 0.5, "duration": 4.0})
    assert conditions(slower)["time"] == pytest.approx(conditions(motion)["time"], rel=0.06)
    assert conditions(motion)["time"] > 1


def test_references_are_printed_where_they_differ(monkeypatch, capsys):
    motion = BY_NAME["side that rocks down"]
    new = {label("time", motion): Reference("1.5", 2, QUADRATURE, 1.0)}
    monkeypatch.setattr(motion_references, "references", lambda _: new)
    assert main(["--only", motion.name]) == 1
    assert capsys.readouterr().out == "time, side that rocks down: 1.5 with 2 digits, condition 1\n"


@pytest.mark.slow
@pytest.mark.parametrize("name", ["grazing contact", "mass of a millionth"])
def test_stored_references_are_computed_anew(name):
    for key, reference in motion_references.references(BY_NAME[name]).items():
        assert json.dumps(reference) == json.dumps(stored_references()[key]), key
