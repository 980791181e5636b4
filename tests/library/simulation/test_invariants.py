"""What holds of every motion: scenes by name, by both methods.

A motion is mirrored with its scene, and is the same in other units, in a batch and in a file. It stores or
dissipates the energy that pusher and loads give, and obeys the laws of contact. Steps converge to it.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from itertools import cycle

import numpy as np
import pytest
import xarray as xr
from simulation.runs import check, imbalance, largest_energy
from simulation.scenes import METHODS, OUTLINED, SCENES, STEPS, Image

import planar_pushing as pp
from planar_pushing.simulation.early_end import quietly

pytestmark = pytest.mark.filterwarnings("ignore:(radius|pusher):planar_pushing.SceneWarning")

EVENTS, TIME_STEPS = METHODS
CASES = [(name, method) for name, case in SCENES.items() for method in case.methods]
by_both = pytest.mark.parametrize(("name", "method"), CASES, ids=map("-".join, CASES))
by_events = pytest.mark.parametrize("name", SCENES)
SEPARATE, STICK, RIGHT, LEFT = (
    pp.ContactMode[name] for name in ("SEPARATE", "STICK", "SLIP_RIGHT", "SLIP_LEFT")
)
NO_EVENT = -1


@cache
def log_of(name, method=EVENTS):
    return SCENES[name].log(method)


def modes(log):
    return log["mode"].values


def events(log):
    """Events, where a contact that opens has one name.

    The force ends where the contact would separate, and without inertia where the pusher turns back:
    rounding decides which of these comes first.
    """
    openings = (
        pp.Event.FORCE_ENDS, pp.Event.SEPARATION_CHANGES, pp.Event.NORMAL_VELOCITY_REVERSES
    )  # fmt: skip
    opens = np.isin(log.event.values, openings) & (modes(log) == SEPARATE)
    return np.where(opens, pp.Event.FORCE_ENDS, log.event.values)


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


IMAGES = {"mirror": Image(flip=-1.0), "units": Image(length=0.05, force=30.0, time=7.0)}
#: What rounding decides where modes are at the limit of being possible.
COUNTED = ("solutions", "outcome", "adhesive")


@by_both
@pytest.mark.parametrize("image", IMAGES)
def test_the_image_of_a_scene_has_the_image_of_its_motion(name, method, image):
    """In a mirror, and in other units of length, force and time."""
    case, log = SCENES[name], log_of(name, method)
    other = IMAGES[image].of(case).log(method)
    assert other.attrs["stopped"] == log.attrs["stopped"]
    assert len(other.time) == len(log.time)
    np.testing.assert_array_equal(events(other), events(log))
    for each, wanted in IMAGES[image].log(log).items():
        if case.limit and each in COUNTED:
            continue
        slack = 1e-7 * (1 + np.abs(wanted).max()) if wanted.dtype.kind == "f" else 0.0
        np.testing.assert_allclose(other[each], wanted, rtol=0, atol=slack, err_msg=each)


# --- Routes --------------------------------------------------------------------------------------


@by_events
def test_a_batch_has_the_numbers_of_each_of_its_runs(name):
    """To the last bit, for two durations."""
    case, parts = SCENES[name], 5
    durations = case.duration * np.array([1.0, 0.6])
    batch = quietly(pp.simulate_batch)(
        case.scene, case.pusher, duration=durations, twist=case.twist, gap=case.gap,
        on_ambiguity=case.policy, samples=parts,
    )  # fmt: skip
    for row, duration in enumerate(durations):
        log, found = (
            replace(case, duration=float(duration)).log(samples=parts),
            batch.isel(scene=row),
        )
        instants = np.linspace(0.0, duration, parts)
        there = log.isel(time=np.searchsorted(log.time.values, instants, side="right") - 1)
        shared = [x for x in found.data_vars if "part" in found[x].dims and x in log.variables]
        assert {"time", "position", "rod_angle", "force", "mode", "solutions"} <= {*shared}
        for each in shared:
            if each != "impulse":
                assert np.array_equal(found[each], there[each]), each
        if "impulse" in shared:  # since the instant before
            sums = [log.impulse[log.time <= end].sum("time") for end in there.time]
            assert found.impulse.cumsum("part").values == pytest.approx(np.array(sums), abs=1e-14)
        assert bool(found.stopped[-1]) == bool(log.attrs["stopped"])


@by_events
def test_a_run_until_an_event_is_the_beginning_of_the_whole_run(name):
    whole = log_of(name)
    for event in {*whole.event.values.tolist()} - {NO_EVENT}:
        row = int((whole.event.values == event).argmax())
        log = SCENES[name].log(until=pp.Event(event).name)
        assert log.attrs["stopped"] in (
            f"until: event {pp.Event(event).name}",
            SCENES[name].stopped,
        )
        assert log.attrs["stopped_time"] == whole.time[row]
        xr.testing.assert_equal(log, whole.isel(time=slice(row + 1)))


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", [name for name in OUTLINED if name != "flush side"])
def test_a_run_that_meets_nothing_is_that_without_an_outline(name, method):
    """To the last bit."""
    case, log = SCENES[name], log_of(name)
    end = log.time.values[-1]
    if "flush" in log and log.flush.any():
        end = log.time.values[log.flush.values.argmax()]
    passes = np.isin(log.event.values, (pp.Event.END_OF_SIDE, pp.Event.PENETRATES))
    if passes.any():
        end = log.time.values[passes.argmax()]
    short = replace(case, duration=float(0.9 * end))
    bare = replace(case.scene, slider=replace(case.scene.slider, outline=None))
    alone = replace(short, scene=bare).log(method)
    xr.testing.assert_equal(short.log(method)[[*alone.data_vars]], alone)


POSE = (3.0, -2.0, 2.3)


@by_both
def test_a_pose_in_the_world_turns_and_shifts_the_motion(name, method):
    """By complex numbers; everything else is the same to the last bit."""
    case, log = SCENES[name], log_of(name, method)
    placed = case.log(method, object_pose=POSE)
    xr.testing.assert_equal(placed[[*log.data_vars]], log)
    angle = POSE[2] - case.scene.slider.rod_angle
    start = log.position.values[0] @ (1, 1j)
    for there, here in (
        (placed.object_position, log.position.values @ (1, 1j)),
        (placed.pusher_position, log.pusher.values @ (1, 1j) - 1j * case.radius),
    ):  # fmt: skip
        wanted = POSE[0] + 1j * POSE[1] + np.exp(1j * angle) * (here - start)
        assert there.values @ (1, 1j) == pytest.approx(wanted, abs=1e-12 * (1 + np.abs(here).max()))
    assert placed.object_angle.values == pytest.approx(log.rod_angle + np.rad2deg(angle), abs=1e-9)


SLOW = [name for name, case in SCENES.items() if not case.scene.stores_energy]


def velocity_at(case, time):
    """The pusher's velocity just after a time."""
    if callable(case.velocity):
        return case.velocity(time)
    pieces = case.velocity if isinstance(case.velocity, list) else [(0.0, case.velocity)]
    return [velocity for start, velocity in pieces if start <= time][-1]


@pytest.mark.parametrize("name", SLOW)
def test_without_inertia_an_instant_is_a_push_from_rest(name):
    """Modes, force and twist are those of `solve`; of a finger, whose side turns, at the first instant."""
    case, log = SCENES[name], log_of(name)
    for at in range(log.sizes["time"] if case.shape == "fence" else 1):
        now, (x, y) = log.isel(time=at), velocity_at(case, float(log.time[at]))
        if now.event != NO_EVENT or now.gap > 0:  # at an event two modes meet
            continue
        if case.scene.slider.outline is not None and case.shape == "fence" and now.flush:
            continue  # not a push of one point
        slider = replace(
            case.scene.slider, rod_angle=np.deg2rad(float(now.rod_angle)), outline=None
        )
        found = pp.solve(replace(case.scene, slider=slider), np.arctan2(y, x), np.hypot(x, y))
        assert now.solutions == len(found)
        if not len(found):
            continue
        same = found.of(pp.ContactMode(now["mode"].item()))
        assert same or case.policy != "keep-contact"
        for solution in same:
            size = np.hypot(*solution.force)
            assert now.force.values == pytest.approx(solution.force, rel=1e-7, abs=1e-9 * size)
            assert now.twist.values == pytest.approx(solution.twist, rel=1e-6, abs=1e-8)


def layout(case):
    """What a file depends on: the variables of its log, and their dimensions."""
    return case.shape, len(case.scene.effects) > 1, bool(case.scene.loads)


LAYOUTS = {layout(case): name for name, case in SCENES.items()}


@pytest.mark.parametrize(("name", "method"), [*zip(LAYOUTS.values(), cycle(METHODS))])
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


def normal_turn(case, log):
    """Angle in radians by which the normal of the contact has turned; in an inner corner, the bisector."""
    if case.shape == "fence":
        return 0.0
    if "contact_piece" not in log:
        return turn(log)
    pieces = case.scene.slider.outline_in_body().pieces
    beta = pieces[:, [3, 4]].mean(axis=1)  # of a side, both are the same
    piece = log.contact_piece.values
    piece = np.where(piece < 0, piece[0], piece)
    return turn(log) + beta[piece] - beta[piece[0]]


def log_is_in_order(case, log, method):
    check(log, 1e-11)
    assert log.attrs["stopped"] == case.stopped
    assert set(log.pivot.values) <= {-1, *range(feet_of(case.scene))}
    assert (np.diff(log.evaluations.values, axis=0) >= 0).all()


def feet_of(scene):
    """The number of points that may be pivots."""
    supports = [each.support for each in scene.effects if isinstance(each, pp.SupportFriction)]
    points = [each for each in supports if isinstance(each, pp.Points)]
    return sum(len(each.positions) for each in points) + 9 * any(
        isinstance(each, pp.Composite) for each in supports
    )


def work_becomes_kinetic_energy_and_heat(case, log, method):
    assert imbalance(log).max() <= 1e-11 * largest_energy(log)


def slider_does_not_enter_the_pusher(case, log, method):
    """Its contact is in the air, or on the pusher to rounding, also between the few instants of the log."""
    often = case.log(method, samples=301) if method == EVENTS else log
    gap = often.gap.where(~often.parted, 0.0) if "parted" in often else often.gap
    assert gap.min() >= -1e-12


def nothing_gives_energy_back(case, log, method):
    for lost in (log.dissipated.values, log.contact_dissipated.values[:, None]):
        assert (np.diff(lost, axis=0) >= -1e-12 * (1 + np.abs(lost).max())).all()
    stores = [label.startswith(("inertia", "load")) for label in log.effect.values]
    assert not log.dissipated.values[:, stores].any()


def closed_contact_is_closed_and_an_open_one_exerts_no_force(case, log, method):
    closed = modes(log) > SEPARATE
    if not case.scene.stores_energy:
        assert not log.twist.values[~closed].any()
    # The last row before a step that closes the contact has the force of that step.
    slack = 1e-12 if method == EVENTS else 2 * case.duration / STEPS
    assert np.abs(log.gap.values[closed]).max(initial=0) < slack
    assert not log.force.values[~closed].any()


def contact_is_where_slider_and_pusher_are(case, log, method):
    """By the geometry of fence and disc, from the poses of both."""
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
    # Free of an outline, the gap is the distance from the whole of it.
    there = ~log.parted.values & ((log.gap.values == 0.0) | (case.scene.slider.outline is None))
    if "contact_piece" in log:  # along another side, elsewhere
        there &= log.contact_piece.values == log.contact_piece.values[0]
    wanted = center + (case.radius + log.gap.values)[:, None] * normal
    assert np.abs(contact - wanted)[there].max() < 1e-9
    if (modes(log) > SEPARATE).all() and there.all():
        rolled = -case.radius * turn(log)
        assert log.contact_position.values == pytest.approx(rolled - log.slip.values, abs=1e-9)


def parted_slider_rests_or_flies_on(case, log, method):
    """Without friction on the support it keeps its twist."""
    if case.shape == "fence" or not log.parted.any():
        return
    after = log.twist.values[log.parted.values]
    assert (modes(log)[log.parted.values] == SEPARATE).all()
    if not case.scene.stores_energy:
        assert not after.any()
    elif not case.scene.friction:
        assert after == pytest.approx(np.tile(after[0], (len(after), 1)))


def force_is_in_the_cone_and_on_its_edge_where_the_contact_slips(case, log, method):
    law, angle = case.scene.contact, normal_turn(case, log)
    c, s = np.cos(angle), np.sin(angle)
    f_x, f_y = log.force.values.T
    along, normal = c * f_x + s * f_y, c * f_y - s * f_x
    size = np.hypot(along, normal)
    free = (modes(log) <= SEPARATE) | (size == 0)
    if "contact_piece" in log and case.scene.slider.outline is not None and case.shape == "finger":
        # In an inner corner there are two forces.
        is_corner = case.scene.slider.outline_in_body().pieces[log.contact_piece.values, 2] == 0.0
        along = np.where(is_corner, 0.0, along)
        free |= is_corner
    if law == pp.PerfectlyRough():
        assert np.array_equal(log.adhesive.values, normal < -1e-12 * size)
        assert not np.isin(modes(log), (RIGHT, LEFT)).any()
        return
    mu = getattr(law, "friction_coefficient", np.inf)
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


def contact_slips_in_the_sense_of_its_mode(case, log, method):
    slipped = np.diff(log.slip.values)
    same = modes(log)[1:] == modes(log)[:-1]
    same &= ~(log.event.values[1:] >= 0)
    still = same & np.isin(modes(log)[1:], (SEPARATE, STICK))
    if method == EVENTS:
        assert np.abs(slipped[still]).max(initial=0) < 1e-12
    for mode, sense in ((RIGHT, 1), (LEFT, -1)):
        slips = same & (modes(log)[1:] == mode)
        assert (sense * slipped[slips] >= -1e-12).all()


def modes_change_at_events_and_where_pusher_or_policy_do(case, log, method):
    if method == TIME_STEPS:
        return
    times = [t for t, _ in case.velocity] if isinstance(case.velocity, list) else []
    times += [t for t, _ in case.policy] if isinstance(case.policy, list) else []
    times += case.breakpoints
    for row in np.flatnonzero(np.diff(modes(log))) + 1:
        at_break = np.isclose(log.time.values[row], times, atol=1e-12).any()
        assert at_break or log.event.values[row] >= 0 or log.event.values[row - 1] >= 0


LAWS = (
    log_is_in_order, work_becomes_kinetic_energy_and_heat, slider_does_not_enter_the_pusher,
    nothing_gives_energy_back,
    closed_contact_is_closed_and_an_open_one_exerts_no_force, contact_is_where_slider_and_pusher_are,
    parted_slider_rests_or_flies_on, force_is_in_the_cone_and_on_its_edge_where_the_contact_slips,
    contact_slips_in_the_sense_of_its_mode, modes_change_at_events_and_where_pusher_or_policy_do,
)  # fmt: skip


@by_both
def test_a_motion_obeys_the_laws(name, method):
    for law in LAWS:
        law(SCENES[name], log_of(name, method), method)
