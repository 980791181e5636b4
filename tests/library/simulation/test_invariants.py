"""What holds of every motion: scenes by name, by both methods.

A motion is mirrored with its scene, and is the same in other units, in a batch and in a file. It stores or
dissipates the energy that pusher and loads give, and obeys the laws of contact. Steps converge to it.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import xarray as xr
from simulation.runs import check
from simulation.scenes import METHODS, SCENES, STEPS, Image

import planar_pushing as pp

EVENTS, TIME_STEPS = METHODS
CASES = [(name, method) for name, case in SCENES.items() for method in case.methods]
by_both = pytest.mark.parametrize(("name", "method"), CASES, ids=map("-".join, CASES))
by_events = pytest.mark.parametrize("name", SCENES)
SEPARATE, STICK, RIGHT, LEFT = (
    pp.ContactMode[name] for name in ("SEPARATE", "STICK", "SLIP_RIGHT", "SLIP_LEFT")
)
NO_MODE = -1


@cache
def log_of(name, method=EVENTS):
    return SCENES[name].log(method)


def modes(log):
    return log["mode"].values


def turn(log):
    """Angle in radians by which the slider has turned."""
    return np.deg2rad(log.rod_angle.values - log.rod_angle.values[0])


SYMMETRIC = [name for name in SCENES if "through" in name] + [
    "flush side",
    "two feet along the fence",
]


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    "name", [*SYMMETRIC, "bar on its own line end", "center of pressure at the contact"]
)
def test_what_is_pushed_along_its_axis_of_symmetry_moves_with_the_pusher(name, method):
    log = log_of(name, method)
    assert log.rod_angle.values == pytest.approx(90, abs=1e-9)
    assert log.position.values - log.position.values[0] == pytest.approx(
        log.pusher.values, abs=1e-12
    )
    assert (modes(log) == STICK).all()


# --- Images --------------------------------------------------------------------------------------


def require_image(case, method, image, tolerance):
    """The log of an image of a case is the image of its log."""
    log, other = case.log(method), image.of(case).log(method)
    assert other.attrs["stopped"] == log.attrs["stopped"]
    assert len(other.time) == len(log.time)
    np.testing.assert_array_equal(other.event, log.event)
    wanted_log = image.log(log)
    if case.limit:
        wanted_log = {
            k: v for k, v in wanted_log.items() if k not in ("solutions", "outcome", "adhesive")
        }
    for each, wanted in wanted_log.items():
        found = other[each].values
        size = 1 + np.abs(wanted).max(initial=0)
        if wanted.dtype.kind == "f":
            assert np.abs(found - wanted).max() <= tolerance * size, each
        else:
            np.testing.assert_array_equal(found, wanted, each)


@by_both
def test_the_mirror_of_a_scene_has_the_mirrored_motion(name, method):
    require_image(SCENES[name], method, Image(flip=-1.0), 1e-7)


@by_both
def test_other_units_give_the_same_motion(name, method):
    require_image(SCENES[name], method, Image(length=0.05, force=30.0, time=7.0), 1e-7)


# --- Routes --------------------------------------------------------------------------------------


@by_events
def test_a_batch_has_the_numbers_of_each_of_its_runs(name):
    """To the last bit, for two durations."""
    case, parts = SCENES[name], 5
    durations = case.duration * np.array([1.0, 0.6])
    batch = pp.simulate_batch(
        case.scene, case.pusher, duration=durations, twist=case.twist, gap=case.gap,
        on_ambiguity=case.policy, samples=parts,
    )  # fmt: skip
    for row, duration in enumerate(durations):
        log = replace(case, duration=float(duration)).log(samples=parts)
        found = batch.isel(scene=row)
        for part, time in enumerate(np.linspace(0.0, duration, parts)):
            there = log.isel(time=int(np.flatnonzero(log.time.values <= time)[-1]))
            shared = [
                each
                for each in found.data_vars
                if "part" in found[each].dims and each in log.variables
            ]
            assert {"time", "position", "rod_angle", "force", "mode", "solutions"} <= {*shared}
            for each in shared:
                assert np.array_equal(found[each][part], there[each]), (each, part)
        assert bool(found.stopped[-1]) == bool(log.attrs["stopped"])


def layout(case):
    """What a file depends on: the variables of its log, and whether the run ends early."""
    effects = case.scene.effects
    return case.shape, len(effects), bool(case.scene.loads), bool(case.stopped)


LAYOUTS = {layout(case): name for name, case in SCENES.items()}


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", LAYOUTS.values())
def test_a_log_on_disk_is_that_in_memory(name, method, tmp_path):
    kept = log_of(name, method)
    with SCENES[name].log(method, path=tmp_path / "log.nc") as streamed:
        xr.testing.assert_identical(
            kept.drop_attrs(deep=False), streamed.load().drop_attrs(deep=False)
        )
        assert streamed.attrs.keys() == kept.attrs.keys()
        for each, value in kept.attrs.items():
            np.testing.assert_array_equal(streamed.attrs[each], value, each)


@by_events
def test_samples_do_not_change_the_motion(name):
    """A run at two instants has the same events as one at hundreds, to the last bit."""
    rare, often = (SCENES[name].log(samples=count) for count in (2, 301))
    both = [log.drop_vars("evaluations") for log in (rare, often)]  # each sample is evaluated
    xr.testing.assert_equal(*(log.isel(time=log.event.values >= 0) for log in both))
    xr.testing.assert_equal(*(log.isel(time=-1) for log in both))
    assert often.sizes["time"] >= 301 * rare.time.values[-1] / SCENES[name].duration


@by_both
def test_the_same_run_has_the_same_bits(name, method):
    xr.testing.assert_identical(SCENES[name].log(method), log_of(name, method))


def distance(case, log, exact):
    """Largest distance of two logs, in lengths and radians."""
    one, other = case.at(log), case.at(exact)
    count = min(one.sizes["time"], other.sizes["time"])
    apart = (one[each].values[:count] - other[each].values[:count] for each in ("position", "slip"))
    angles = np.deg2rad(one.rod_angle.values[:count] - other.rod_angle.values[:count])
    return max(np.abs(each).max() for each in (angles, *apart))


@pytest.mark.parametrize(
    "name", [name for name, case in SCENES.items() if TIME_STEPS in case.methods]
)
def test_steps_converge_to_the_motion_between_events(name):
    case, exact = SCENES[name], log_of(name)
    finer = 2 if case.order else 16
    rough, fine = (distance(case, case.log(TIME_STEPS, finer=f), exact) for f in (1, finer))
    assert rough < 0.05
    if rough > 1e-10:
        assert rough / fine == pytest.approx(2.0, abs=0.25) if case.order else fine < rough / 2


# --- Laws ----------------------------------------------------------------------------------------


@by_both
def test_the_log_is_in_order_and_work_becomes_kinetic_energy_and_heat(name, method):
    log = check(log_of(name, method), 1e-11)
    assert log.attrs["stopped"] == SCENES[name].stopped
    assert set(log.pivot.values) <= {-1, *range(feet_of(SCENES[name].scene))}
    assert (log.evaluations.diff("time") >= 0).all()


def feet_of(scene):
    """The number of points that may be pivots."""
    supports = [each.support for each in scene.effects if isinstance(each, pp.SupportFriction)]
    points = [each for each in supports if isinstance(each, pp.Points)]
    return sum(len(each.positions) for each in points) + 9 * any(
        isinstance(each, pp.Composite) for each in supports
    )


@by_both
def test_nothing_gives_energy_back(name, method):
    log = log_of(name, method)
    for lost in (log.dissipated.values, log.contact_dissipated.values[:, None]):
        assert (np.diff(lost, axis=0) >= -1e-12 * (1 + np.abs(lost).max())).all()
    stores = log.effect.str.startswith(("inertia", "load")).values
    assert not log.dissipated.values[:, stores].any()


@by_both
def test_a_closed_contact_is_closed_and_an_open_one_exerts_no_force(name, method):
    log = log_of(name, method)
    closed = modes(log) > SEPARATE
    if not SCENES[name].scene.stores_energy:
        assert not log.twist.values[~closed].any()
    # The last row before a step that closes the contact has the force of that step.
    slack = 1e-12 if method == EVENTS else 2 * SCENES[name].duration / STEPS
    assert np.abs(log.gap.values[closed]).max(initial=0) < slack
    assert not log.force.values[~closed].any()


@by_both
def test_the_contact_is_where_slider_and_pusher_are(name, method):
    """By the geometry of fence and disc, from the poses of both."""
    case, log = SCENES[name], log_of(name, method)
    length, psi = case.scene.slider.rod_length, np.deg2rad(log.rod_angle.values)
    end = log.position.values - length * np.stack([np.cos(psi), np.sin(psi)], axis=-1)
    if case.shape == "fence":
        apart = end - log.pusher.values
        assert apart[:, 1] == pytest.approx(log.gap.values, abs=1e-12)
        if (modes(log) > SEPARATE).all():
            assert apart[:, 0] == pytest.approx(log.slip.values, abs=1e-9)
        return
    tangent = np.stack([np.cos(turn(log)), np.sin(turn(log))], axis=-1)
    normal = np.stack([-tangent[:, 1], tangent[:, 0]], axis=-1)
    contact = end + log.contact_position.values[:, None] * tangent
    center = log.pusher.values - (0.0, case.radius)
    there = ~log.parted.values
    wanted = center + (case.radius + log.gap.values)[:, None] * normal
    assert np.abs(contact - wanted)[there].max() < 1e-9
    if (modes(log) > SEPARATE).all():
        rolled = -case.radius * turn(log)
        assert log.contact_position.values == pytest.approx(rolled - log.slip.values, abs=1e-9)


@by_both
def test_the_force_is_in_the_cone_and_on_its_edge_where_the_contact_slips(name, method):
    case, log = SCENES[name], log_of(name, method)
    angle = turn(log) if case.shape == "finger" else np.zeros(log.sizes["time"])
    c, s = np.cos(angle), np.sin(angle)
    f_x, f_y = log.force.values.T
    along, normal = c * f_x + s * f_y, c * f_y - s * f_x
    size = np.hypot(along, normal)
    free = np.array([modes(log) <= SEPARATE, size == 0]).any(axis=0)
    assert (
        np.array_equal(log.adhesive.values, normal < -1e-12 * size)
        or case.scene.contact != pp.PerfectlyRough()
    )
    mu = getattr(case.scene.contact, "friction_coefficient", np.inf)
    if isinstance(case.scene.contact, pp.PerfectlyRough):
        assert not np.isin(modes(log), (RIGHT, LEFT)).any()
        return
    # The side turns during a step, and the force is that at its beginning.
    turns = case.shape == "finger" and method == TIME_STEPS
    slack = (0.05 if turns else 1e-7) * size.max(initial=1)
    assert (normal >= -slack).all()
    if mu < np.inf:
        assert (np.abs(along) <= mu * normal + slack).all()
    for mode, side in ((RIGHT, -1), (LEFT, 1)):
        slips = (modes(log) == mode) & ~free
        if mu < np.inf:
            assert along[slips] == pytest.approx(side * mu * normal[slips], abs=slack)
        else:
            assert np.abs(normal[slips]).max(initial=0) < slack
            assert (side * along[slips] >= 0).all()


@by_both
def test_the_contact_slips_in_the_sense_of_its_mode(name, method):
    log = log_of(name, method)
    slipped = np.diff(log.slip.values)
    same = modes(log)[1:] == modes(log)[:-1]
    same &= ~(log.event.values[1:] >= 0)
    still = same & np.isin(modes(log)[1:], (SEPARATE, STICK))
    if method == EVENTS:
        assert np.abs(slipped[still]).max(initial=0) < 1e-12
    for mode, sense in ((RIGHT, 1), (LEFT, -1)):
        slips = same & (modes(log)[1:] == mode)
        assert (sense * slipped[slips] >= -1e-12).all()


@by_events
def test_modes_change_at_events_and_where_the_motion_of_the_pusher_or_the_policy_does(name):
    case, log = SCENES[name], log_of(name)
    times = [t for t, _ in case.velocity] if isinstance(case.velocity, list) else []
    times += [t for t, _ in case.policy] if isinstance(case.policy, list) else []
    times += case.breakpoints
    changes = np.flatnonzero(np.diff(modes(log))) + 1
    for row in changes:
        at_break = np.isclose(log.time.values[row], times, atol=1e-12).any()
        assert at_break or log.event.values[row] >= 0 or log.event.values[row - 1] >= 0
    assert (np.diff(log.time.values) >= 0).all()
