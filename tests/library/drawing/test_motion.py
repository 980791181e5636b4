"""Pictures of motion over time: what they show of a log, and their marks."""

from itertools import pairwise

import matplotlib.pyplot as plt
import numpy as np
import pytest
from drawing.conftest import LOGS, OTHERS
from matplotlib.colors import same_color
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from numpy.testing import assert_allclose
from simulation.runs import heading, run

import planar_pushing as pp
from planar_pushing.drawing import over_time
from planar_pushing.drawing.animate import resample
from planar_pushing.drawing.body import body_in
from planar_pushing.drawing.canvas.colors import CENTER, DARK, FORCE, GUIDE, MODES, PUSHER
from planar_pushing.drawing.canvas.marks import Arrow, Dot, Label, Line, Picture
from planar_pushing.drawing.motion import (
    add_instant,
    add_paths,
    box,
    fence_ends,
    frame_picture,
    last_center,
    pose,
)
from planar_pushing.drawing.supports import Pose, extents
from planar_pushing.drawing.timeline import (
    contact,
    impacts,
    key_rows,
    path_data,
    pivots,
    pusher_action,
    rod_end,
    rows,
    runs,
)
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.terms.errors import InvalidFile

# -- what is shown of a log --------------------------------------------------------------------------


@pytest.mark.parametrize("name", LOGS)
def test_the_motion_center_stands_still_and_the_contact_is_above_the_fence(logs, name):
    log, data = logs[name], path_data(logs[name])
    v_x, v_y, omega = log.twist.values.T  # the radius is 1
    arm = data.path_center.values - log.position.values
    turning = omega != 0
    velocity = np.stack([v_x - omega * arm[:, 1], v_y + omega * arm[:, 0]])[:, turning]
    assert turning.any()
    assert_allclose(velocity, 0, atol=1e-12)
    height = contact(data)[:, 1] - data.path_pusher.sel(xy="y").values
    assert_allclose(height, data.path_gap, rtol=0, atol=1e-9)


def test_runs_cover_the_time_and_tell_a_choice(logs):
    found = list(runs(path_data(logs["pulling"])))
    turn, end = 16, 83
    assert [(run.start, run.stop, run.several) for run in found] == [
        (0, turn, False), (turn, end, True), (end, 102, False),
    ]  # fmt: skip
    assert float(logs["pulling"].time[turn]) == 0.4
    modes = [ContactMode(run.mode).name for run in runs(path_data(logs["pulling_with_inertia"]))]
    assert modes[-3:] == ["STICK", "SLIP_RIGHT", "SEPARATE"]


def test_rows_are_spread_over_the_time(logs):
    assert rows(path_data(logs["slipping"]), 5) == [0, 24, 48, 72, 96]


def test_key_rows_are_the_ends_and_the_first_impact_or_the_middle(logs):
    assert key_rows(path_data(logs["slipping"])) == [0, 48, 96]
    log = logs["impact"]
    (row,) = impacts(log)
    assert key_rows(path_data(log), [row]) == [0, row, log.sizes["time"] - 1]
    assert key_rows(path_data(logs["slipping"]), [0]) == [0, 48, 96]


@pytest.mark.parametrize(
    ("name", "time", "action"),
    [
        ("pulling", 0.0, "pushes"),
        ("pulling", 0.4, "retreats: the ring follows"),
        ("pulling", 2.0, "retreats: the ring follows"),
        ("pulling", 2.5, "retreats: the contact parts"),
        ("pulling_lost", 1.0, "retreats: the contact parts"),
        ("slipping", 3.0, "pushes"),
        ("impact", 0.0, "approaches"),
        ("impact", 3.0, "falls behind"),
        ("pulling_with_inertia", 0.3, "retreats: the ring follows"),
        ("pulling_with_inertia", 1.5, "stands still"),
        ("stool", 0.0, "pushes"),
        ("box", 6.0, "pushes"),
    ],
)
def test_what_the_pusher_does_is_said_in_words(logs, name, time, action):
    data = path_data(logs[name])
    row = int(np.argmin(np.abs(data.time.values - time)))
    assert pusher_action(data, row) == action


def test_a_pusher_along_the_side_neither_pushes_nor_retreats():
    slider = pp.Slider(rod_length=2.0, rod_angle=1.2)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=(pp.RingFriction(),))
    log = pp.simulate(scene, pusher=pp.Pusher(velocity=(1.0, 0.0)), duration=0.1)
    assert pusher_action(path_data(log), 0) == "moves along the fence"
    log = run(scene, pp.Pusher(velocity=heading(-90), shape="finger"), 0.1, samples=3,
              method="time-stepping")  # fmt: skip
    assert pusher_action(path_data(log), 0) == "retreats: the contact parts"


def test_a_log_without_a_scene_is_refused(logs):
    with pytest.raises(InvalidFile, match="the dataset lacks scene"):
        path_data(logs["slipping"].assign_attrs(scene="Scene(...)"))


@pytest.mark.parametrize("draw", [pp.plot_log, lambda log: pp.animate(log, frames=2)])
def test_a_log_that_is_not_finished_says_where_it_ends(logs, caplog, draw):
    log = logs["slipping"]
    draw(log)
    assert not caplog.messages
    draw(log.isel(time=slice(0, 49)).assign_attrs(finished=np.int8(0)))
    end, duration = float(log.time[48]), float(log.attrs["duration"])
    assert caplog.messages == [f"the log is not finished: it ends at {end:g} of {duration:g}"]
    assert 0 < end < duration
    plt.close("all")


@pytest.mark.parametrize("draw", [pp.plot_log, lambda log: pp.animate(log, frames=2)])
def test_a_log_that_stopped_says_when_and_why(logs, caplog, draw):
    draw(logs["slipping"].assign_attrs(stopped="no contact mode is consistent", stopped_time=0.5))
    assert caplog.messages == ["stopped at t = 0.5: no contact mode is consistent"]
    plt.close("all")


@pytest.mark.parametrize("name", [*LOGS, *OTHERS])
def test_what_is_shown_keeps_the_scene_and_the_pusher(logs, name):
    log, data = logs[name], path_data(logs[name])
    for key in ("scene", "pusher"):
        assert data.attrs[key] == log.attrs[key]
    assert body_in(data) == body_in(log)
    assert ("path_pivot" in data) == (name in OTHERS)


def test_a_pivot_is_a_support_point_that_stands_still(logs):
    data = path_data(logs["stool"])
    (span,) = pivots(data)
    pivoting = data.isel(time=slice(span.start, span.stop + 1))
    assert set(pivoting.path_pivot.values) == {2}
    foot = body_in(data).support.positions[2]
    places = [pose(pivoting, row).to_plane(foot) for row in range(pivoting.sizes["time"])]
    assert np.ptp(places, axis=0) == pytest.approx([0, 0], abs=1e-6)
    assert_allclose(pivoting.path_center, places, rtol=0, atol=1e-6)
    assert (data.path_pivot.values[: span.start] == -1).all()
    assert (data.path_pivot.values[span.stop + 1 :] == -1).all()


def test_an_area_has_no_pivots(logs):
    data = path_data(logs["box"])
    assert (data.path_pivot.values == -1).all()
    assert not any(pivots(data))


@pytest.mark.parametrize("name", ["pulling", "pulling_lost", "slipping", *OTHERS])
def test_a_momentum_that_does_not_jump_is_no_impact(logs, name):
    assert impacts(logs[name]) == []


def test_a_fence_strikes_what_it_meets_or_what_it_touches_when_it_jumps(logs):
    log = logs["impact"]
    (row,) = impacts(log)
    assert log.gap[row] == 0 < log.gap[row - 1]
    log = logs["pulling_with_inertia"]
    assert [float(log.time[row]) for row in impacts(log)] == [0.5]


# -- the side that a finger pushes -------------------------------------------------------------------


@pytest.fixture(params=[(-1.0, 0.25), (-np.inf, np.inf)], ids=["ends", "endless"])
def pushed_side(request):
    slider = pp.Slider(rod_length=2.0, rod_angle=1.2, side=request.param)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.1), effects=(pp.RingFriction(),))
    pusher = pp.Pusher(velocity=heading(68), shape="finger")
    return run(scene, pusher, 0.5, samples=9, method="time-stepping")


def test_the_side_is_fixed_to_the_slider_and_the_finger_is_on_it(pushed_side):
    data = path_data(pushed_side)
    one, other = np.moveaxis(data.path_side.values, 1, 0)
    along, arm = other - one, contact(data) - one
    height = (along[:, 0] * arm[:, 1] - along[:, 1] * arm[:, 0]) / np.hypot(*along.T)
    assert -height == pytest.approx(pushed_side.gap.values, abs=1e-12)
    for end in (one, other):
        for place in (rod_end(data), data.path_position.values, other):
            assert np.ptp(np.hypot(*(end - place).T)) == pytest.approx(0, abs=1e-12)
    beyond = 0.45 * 3.0
    reach = pushed_side.contact_position.values.max() + beyond
    ends = (-1.0, 0.25) if pushed_side.parted.any() else (-beyond, reach)
    assert data.path_side.values[0, :, 0] == pytest.approx(ends)


def test_frames_and_their_box_hold_the_side(pushed_side):
    data, picture = resample(path_data(pushed_side), 4), Picture()
    low, high = box(data)
    assert (data.path_side.values >= low).all()
    assert (data.path_side.values <= high).all()
    add_instant(picture, data, 3)
    side, finger = picture.marks[:2]
    assert np.array_equal(side.points, data.path_side.values[3])
    assert np.array_equal(finger.position, contact(data)[3])


@pytest.mark.filterwarnings("ignore:radius:planar_pushing.SceneWarning")
def test_a_disc_is_drawn_where_it_is_tangent_to_the_side():
    slider = pp.Slider(rod_length=2.0, rod_angle=1.2)
    scene = pp.Scene(slider=slider, contact=pp.PerfectlyRough(), effects=(pp.RingFriction(),))
    for radius in (0.4, 40.0):
        pusher = pp.Pusher(velocity=heading(90), shape="finger", radius=radius)
        log = run(scene, pusher, 0.5, samples=9, method="time-stepping")
        data, picture = resample(path_data(log), 4), Picture()
        add_instant(picture, data, 3)
        side, disc, rim = picture.marks[:3]
        middle = rim.points[:-1].mean(axis=0)
        assert middle == pytest.approx(log.pusher.values[-1] - (0, radius), abs=1e-9)
        along = np.diff(side.points, axis=0)[0] / np.hypot(*np.diff(side.points, axis=0)[0])
        heights = (rim.points - side.points[0]) @ (-along[1], along[0])
        assert heights.max() == pytest.approx(0.0, abs=1e-9)
        end = rod_end(data)[3] + float(log.contact_position[-1]) * along
        assert rim.points[heights.argmax()] == pytest.approx(end, abs=1e-9)
        assert np.array_equal(disc.rings[0], rim.points)
        low, high = box(data)
        if radius < 1:
            assert (rim.points >= low).all()
            assert (rim.points <= high).all()
        else:
            assert (high - low).max() < 10


# -- marks -------------------------------------------------------------------------------------------


def marks(picture, kind, color):
    return [mark for mark in picture.marks if isinstance(mark, kind) and mark.color == color]


def labels(picture):
    return {mark.text: mark.position for mark in picture.marks if isinstance(mark, Label)}


def test_a_far_center_is_not_shown(logs):
    motion = path_data(logs["slipping"])
    assert len(last_center(motion)) == 1
    motion["path_center"] += 100
    assert last_center(motion) == []
    assert box(motion)[1, 1] < 10


def test_the_path_of_the_center_stays_in_the_picture_and_says_where_it_leaves(logs):
    motion, picture = path_data(logs["pulling_with_inertia"]), Picture()
    low, high = frame = box(motion)
    add_paths(picture, motion, frame)
    path = np.concatenate([line.points for line in marks(picture, Line, CENTER)])
    assert ((path >= low) & (path <= high)).all()
    heads = marks(picture, Arrow, CENTER)
    assert heads
    assert not any(arrow.filled for arrow in heads)


def test_the_path_of_the_contact_has_the_ink_of_its_modes(logs):
    motion, picture = path_data(logs["pulling_with_inertia"]), Picture()
    add_paths(picture, motion, box(motion))
    drawn = [mark for mark in picture.marks if isinstance(mark, Line) and mark.color != CENTER]
    expected = [
        (MODES[each.mode].ink, contact(motion)[each.start])
        for each in runs(motion)
        if each.stop > each.start
    ]
    assert [line.color for line in drawn] == [ink for ink, _ in expected]
    for line, (_, start) in zip(drawn, expected, strict=True):
        assert np.array_equal(line.points[0], start)
    stopped = Picture()
    add_paths(stopped, motion, box(motion), last=10)
    assert np.array_equal(stopped.marks[-1].points[-1], contact(motion)[10])


@pytest.mark.parametrize("name", OTHERS)
def test_the_picture_holds_the_whole_support(logs, name):
    motion = path_data(logs[name])
    low, high = box(motion)
    for row in range(motion.sizes["time"]):
        first, last = extents(body_in(motion).support, pose(motion, row))
        assert (low <= first).all()
        assert (last <= high).all()


def arrow_along(picture, color):
    """Direction of the only arrow of a color, as a unit vector."""
    (arrow,) = marks(picture, Arrow, color)
    along = np.diff(arrow.points, axis=0)[0]
    return along / np.hypot(*along)


def test_a_frame_shows_the_velocity_of_the_pusher_and_its_first_position(logs):
    motion = path_data(logs["pulling"])
    for row, angle in ((0, 60.0), (20, -20.0)):
        picture = frame_picture(motion, row, box(motion))
        assert_allclose(arrow_along(picture, PUSHER), heading(angle), rtol=0, atol=1e-9)
        first = [line for line in marks(picture, Line, GUIDE) if line.dash]
        assert len(first) == (row > 0)
        for line in first:
            assert (line.points[:, 1] == 0).all()
    picture = frame_picture(motion, 102, box(motion))
    assert labels(picture)["$t = 0$"][1] == 0
    names = {"$\\mathbf{f}$", "$\\mathbf{v}_p$"}
    assert names & labels(picture).keys() == {"$\\mathbf{v}_p$"}  # there is no force any more
    assert names <= labels(frame_picture(motion, 20, box(motion))).keys()


def test_a_pusher_at_rest_has_no_arrow(logs):
    motion = path_data(logs["pulling_with_inertia"])
    row = motion.sizes["time"] - 1
    assert not marks(frame_picture(motion, row, box(motion)), Arrow, PUSHER)


def test_a_frame_of_a_finger_has_its_first_position(pushed_side):
    motion = path_data(pushed_side)
    picture = frame_picture(motion, 8, box(motion))
    assert_allclose(arrow_along(picture, PUSHER), heading(68), rtol=0, atol=1e-9)
    rings = [mark for mark in picture.marks if isinstance(mark, Dot) and mark.edge == GUIDE]
    assert [mark.position.tolist() for mark in rings] == [[0.0, 0.0]]


def test_a_force_along_the_fence_is_drawn_beside_it(logs):
    motion = path_data(logs["slipping"])
    (force,) = marks(frame_picture(motion, 48, box(motion)), Arrow, FORCE)
    assert_allclose(force.points[1] - force.points[0], [-0.4 * 6, 0], rtol=0, atol=1e-9)
    assert force.points[0][1] > contact(motion)[48, 1] + 0.2
    (force,) = marks(frame_picture(path_data(logs["pulling"]), 0, box(motion)), Arrow, FORCE)
    assert np.array_equal(force.points[0], [0, 0])


@pytest.mark.parametrize("name", ["pulling", "slipping", "pulling_with_inertia", "stool"])
def test_the_fence_reaches_the_contact_wherever_it_slips(logs, name):
    motion = path_data(logs[name])
    start, end = fence_ends(motion)
    along = (contact(motion) - motion.path_pusher.values)[motion.path_mode.values > 0, 0]
    assert start < along.min()
    assert along.max() < end


def test_the_box_holds_every_arrow(logs):
    motion = path_data(logs["stool"])
    low, high = frame = box(motion)
    for row in (0, 30, motion.sizes["time"] - 1):
        for mark in frame_picture(motion, row, frame).marks:
            if isinstance(mark, Arrow):
                assert (low <= mark.points).all()
                assert (mark.points <= high).all()


def test_a_frame_shows_the_past_path_alone(logs):
    motion = path_data(logs["pulling_with_inertia"])
    picture = frame_picture(motion, 10, box(motion))
    paths = [mark for mark in picture.marks if isinstance(mark, Line) and mark.width == 2.4]
    assert np.array_equal(paths[-1].points[-1], contact(motion)[10])


def test_the_motion_center_is_named_where_it_is(logs):
    motion = path_data(logs["impact"])
    picture = frame_picture(motion, 0, box(motion))
    assert np.array_equal(labels(picture)["motion\ncenter"], motion.path_center.values[0])
    without = frame_picture(motion, 0, box(motion), center=False)
    assert "motion\ncenter" not in labels(without)
    assert not [mark for mark in without.marks if isinstance(mark, Dot) and mark.edge == CENTER]


def test_a_pivot_is_marked_where_it_is(logs):
    motion = path_data(logs["stool"])
    (span,) = pivots(motion)
    for row, name in ((span.start, "pivot"), (span.start - 1, "motion\ncenter")):
        found = labels(frame_picture(motion, row, box(motion)))
        assert found[name] == pytest.approx(motion.path_center.values[row])
        assert len({"pivot", "motion\ncenter"} & found.keys()) == 1


def test_an_impact_is_joined_to_the_contact(logs):
    motion = path_data(logs["impact"])
    (row,) = impacts(logs["impact"])
    picture = frame_picture(motion, row, box(motion), impact=True)
    (burst,) = (mark for mark in picture.marks if isinstance(mark, Dot) and mark.shape == "burst")
    assert np.array_equal(labels(picture)["impact"], burst.position)
    lines = [mark.points for mark in picture.marks if isinstance(mark, Line)]
    assert any(np.array_equal(line, [contact(motion)[row], burst.position]) for line in lines)


def test_centers_of_another_support_are_marked_at_every_instant():
    base = pp.SupportFriction(support=pp.Polygon.rectangle(2, 2))
    effects = base, pp.Inertia(gyration_radius=0.8, center=(0.4, 0.3))
    slider = pp.Slider(rod_length=1, rod_angle=np.pi / 2)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.5), effects=effects)
    motion = path_data(pp.simulate(scene, pusher=pp.Pusher(velocity=(0.9, 0.3)), duration=0.5))
    picture = frame_picture(motion, motion.sizes["time"] - 1, box(motion))
    shapes = [mark.shape for mark in picture.marks if isinstance(mark, Dot)]
    assert (shapes.count("mass"), shapes.count("pressure")) == (1, 1)
    at = Pose(motion.path_position.values[-1], np.deg2rad(float(motion.path_rod_angle[-1])))
    (mass,) = [
        mark.position for mark in picture.marks if isinstance(mark, Dot) and mark.shape == "mass"
    ][-1:]
    assert mass == pytest.approx(at.to_plane((0.4, 0.3)))


# -- over time ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name", ["pulling", "pulling_lost", "slipping", "pulling_with_inertia", "stool"]
)
def test_a_strip_has_the_look_of_each_mode_and_bars_for_choices(logs, name):
    motion, ax = path_data(logs[name]), Figure().add_subplot()
    over_time.strip(ax, motion)
    time, spans = motion.time.values, list(runs(motion))
    areas = [
        patch for patch in ax.patches if isinstance(patch, Rectangle) and patch.get_height() == 0.9
    ]
    starts = [
        span for before, span in pairwise([None, *spans]) if not before or before.mode != span.mode
    ]
    stops = [time[span.start] for span in starts[1:]] + [time[-1]]
    assert len(areas) == len(starts)
    for area, span, stop in zip(areas, starts, stops, strict=True):
        look = MODES[span.mode]
        assert area.get_x() == time[span.start]
        assert area.get_x() + area.get_width() == pytest.approx(stop, abs=1e-12)
        assert same_color(area.get_facecolor(), look.fill)
        assert (area.get_hatch() or "") == look.hatch
    bars = [patch for patch in ax.patches if patch.get_height() == over_time.CHOICE]
    assert all(same_color(bar.get_facecolor(), DARK) for bar in bars)
    longer = [span for span in spans if span.several and span.stop > span.start + 1]
    assert [bar.get_x() for bar in bars] == [time[span.start] for span in longer]
    names = {text.get_text() for text in ax.texts}
    assert names <= {MODES[span.mode].name for span in spans}
    assert ax.get_xlim() == (time[0], time[-1])


def test_a_choice_at_an_instant_has_no_bar(logs):
    motion, ax = path_data(logs["pulling_lost"]), Figure().add_subplot()
    over_time.strip(ax, motion)
    assert [span.several for span in runs(motion)] == [False, True, False]
    assert len(ax.patches) == 2


def test_a_mode_is_named_along_its_area_or_upright_if_there_is_room(logs):
    motion = path_data(logs["pulling"])
    angles = []
    for width in (7.0, 1.5, 0.3):
        ax = Figure(figsize=(width, 2.0)).add_subplot()
        over_time.strip(ax, motion)
        angles.append({text.get_text(): text.get_rotation() for text in ax.texts})
    assert angles == [{"stick": 0, "separate": 0}, {"stick": 0, "separate": 90}, {"stick": 90}]
