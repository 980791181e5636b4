"""Five pushes of a box, whose values two integrators agree on: what leaving out an effect changes.

The box is 0.3 m by 0.2 m, 1.2 kg, with a coefficient of friction of 0.3 on the table. The values are those
of event-driven runs and of 8,000 and 16,000 equal steps, extrapolated; both agree to 5e-6 mm.
"""

import math

import numpy as np
import pytest

import planar_pushing as pp

BOX = pp.Polygon.rectangle(0.3, 0.2)
WEIGHT = pp.weight(1.2, 0.3)
INERTIA = pp.Inertia(mass=1.2, gyration_radius=math.hypot(0.3, 0.2) / math.sqrt(12))
FEET = pp.Points([(x, y) for x in (-0.135, 0.135) for y in (-0.09, 0.09)])
SLOPE = pp.Load(force=(0.0, -WEIGHT / 0.3 * math.sin(math.radians(1.0))))
MM = 1e-3


def assess(support, point, degrees, speed, duration, *, law=0.5, stop=None, candidates=(INERTIA,)):
    friction = pp.SupportFriction(support=support, weight=WEIGHT)
    scene = pp.scene_at(point, contact=pp.Coulomb(law), outline=BOX, effects=(friction,))
    angle = math.radians(degrees)
    velocity = (0.0 if degrees == 90 else speed * math.cos(angle), speed * math.sin(angle))
    pieces = [(0.0, velocity)] + ([] if stop is None else [(stop, (0.0, 0.0))])
    pusher = pp.Pusher(velocity=pieces, shape="finger")
    return pp.assess_push(scene, pusher, duration=duration, candidates=candidates, tolerance=1 * MM)


@pytest.fixture(scope="module")
def slow():
    return assess(BOX, (0.04, -0.1), 90, 0.05, 1.6)


@pytest.fixture(scope="module")
def on_disc():
    return assess(pp.Disc(0.03), (0.062, -0.1), 136, 0.05, 1.0, law=0.4)


@pytest.fixture(scope="module")
def on_feet():
    return assess(FEET, (0.04, -0.1), 90, 0.02, 4.0, candidates=(INERTIA, SLOPE))


@pytest.fixture(scope="module")
def fast():
    return assess(BOX, (0.04, -0.1), 90, 0.2, 0.4)


@pytest.fixture(scope="module")
def stopped():
    return assess(BOX, (0.0, -0.1), 90, 0.2, 0.6, stop=0.3)


@pytest.mark.parametrize(
    ("push", "effect", "change", "stopping", "estimate", "needed", "modes"),
    [
        ("stopped", "inertia", 6.798108, 6.798108, 6.798, True, "STICK SEPARATE"),
        ("slow", "inertia", 0.756355, 0.500018, 0.898, False, "STICK"),
        ("fast", "inertia", 9.627134, 8.000287, 14.36, True, "STICK"),
        ("on_disc", "inertia", 16.60689, 4.069139, 14.16, True, "SLIP_RIGHT"),
        ("on_feet", "inertia", 0.032007, 0.066125, 0.090, False, "STICK"),
        ("on_feet", "load", 2.535575, 0.0, 5.99, True, "STICK"),
    ],
)
def test_effects(request, push, effect, change, stopping, estimate, needed, modes):
    row = request.getfixturevalue(push).effects.sel(effect=effect)
    assert row.pose_change.item() == pytest.approx(change * MM, rel=2e-6, abs=6e-9)
    assert row.stopping.item() == pytest.approx(stopping * MM, rel=1e-6, abs=1e-9)
    assert row.estimate.item() == pytest.approx(estimate * MM, rel=5e-3)
    assert row.pose_change_near >= row.pose_change
    assert (row.needed.item(), row.modes.item()) == (needed, modes)


def test_a_push_through_the_center_coasts_as_far_as_its_stopping_length(stopped):
    """The exact answer is v^2 / (2 mu_s g)."""
    exact = 0.2**2 / (2 * 0.3 * 9.80665)
    row = stopped.effects.sel(effect="inertia")
    assert row.pose_change.item() == pytest.approx(exact, rel=1e-7, abs=0)
    assert row.stopping.item() == pytest.approx(exact, rel=1e-12, abs=0)


@pytest.mark.parametrize(
    ("push", "values"),
    [
        ("slow", {"place of the contact": (4.380, 4.734), "pressure along the side": (4.030, 3.588),
                  "pressure across the side": (2.884, 2.949), "direction of the push": (1.453, 1.444),
                  "friction of the contact": (0.0, 0.0)}),
        ("on_disc", {"place of the contact": (8.609, 9.021), "pressure along the side": (8.572, 7.915),
                     "friction of the contact": (0.826, 0.826), "mass": (0.116, 0.117)}),
    ],
)  # fmt: skip
def test_inputs(request, push, values):
    inputs = request.getfixturevalue(push).inputs
    for name, changes in values.items():
        found = inputs["change"].sel(input=name).values
        np.testing.assert_allclose(found, np.array(changes) * MM, atol=6e-7)


def test_the_error_grows_as_the_square_of_the_speed(slow):
    """The speed limit is that at which a sweep of speeds crosses the tolerance, within a tenth."""
    limit = slow.effects["speed_limit"].sel(effect="inertia").item()
    there = assess(BOX, (0.04, -0.1), 90, limit, 0.08 / limit)
    near = there.effects["pose_change_near"].sel(effect="inertia").item()
    assert near == pytest.approx(1 * MM, rel=0.1)


def test_the_scene_has_the_needed_effects_and_runs(slow, on_feet):
    assert [effect.kind for effect in slow.scene.effects] == ["support_friction"]
    assert [effect.kind for effect in on_feet.scene.effects] == ["support_friction", "load"]
    for assessment, pusher in ((slow, (0.0, 0.05)), (on_feet, (0.0, 0.02))):
        finger = pp.Pusher(velocity=pusher, shape="finger")
        duration = assessment.duration
        log = pp.simulate(assessment.scene, finger, duration=duration, **assessment.settings)
        assert log.time.values[-1] == duration


def test_leaving_out_two_effects_is_compared_with_all_effects(on_disc):
    """Each of two effects can go alone; what is left out together is within the tolerance, too."""
    viscous = pp.Viscous(support=pp.Disc(0.03), coefficient=0.6)
    load = pp.Load(force=(0.0, -0.004 * WEIGHT))
    both = assess(
        pp.Disc(0.03), (0.062, -0.1), 136, 0.05, 1.0, law=0.4, candidates=(INERTIA, viscous, load)
    )
    assert both.effects["needed"].values.tolist() == [True, True, False, False]
    assert 0 < both.effects.attrs["change_together"] <= 1 * MM
    assert both.scene.effects == on_disc.scene.effects
