"""Pictures of a slider whose side lies on the fence: under a push, and over time."""

import io
from dataclasses import replace

import numpy as np
import pytest
from drawing.scenes import ASIDE, INERTIA, NO_ADHESION, RING, ROUGH, coulomb, scene, supported
from drawing.test_scene import arrows, drawn, names, points_of
from mechanics.supports.cases import TRIPOD
from PIL import Image

import planar_pushing as pp
from planar_pushing.drawing import over_time
from planar_pushing.drawing.animate import resample, status
from planar_pushing.drawing.body import body_in
from planar_pushing.drawing.canvas.colors import FORCE, MODES, MOTION, SLIDER, tint
from planar_pushing.drawing.canvas.marks import Area, Dot, Line, Picture
from planar_pushing.drawing.canvas.svg import to_svg
from planar_pushing.drawing.motion import add_instant, add_paths, box, fence_ends, pose
from planar_pushing.drawing.scene import scene_picture
from planar_pushing.drawing.sketch import Sketch, moves
from planar_pushing.drawing.timeline import contact, path_data, runs, side_on_fence
from planar_pushing.drawing.words import does, outcome, row
from planar_pushing.mechanics.contact import ContactMode

CORNERS = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
SQUARE = supported(pp.Polygon(CORNERS))
INFINITE = {"law": "infinite_friction"}


def flush(contact, effects=(SQUARE,), side=(-1.0, 1.0), **slider):
    slider = {"rod_length": 1.0, "rod_angle": 90.0, "side": list(side), "flush": True} | slider
    return scene(contact, effects, **slider)


#: Scenes whose side lies on the fence: symmetric ones first, then a center beyond an end, and aside.
SCENES = {
    "square": flush(coulomb(0.5)),
    "smooth": flush(coulomb(0)),
    "infinite": flush(INFINITE),
    "open cone": flush(NO_ADHESION),
    "rough": flush(ROUGH),
    "inertia": flush(coulomb(0.5), (INERTIA,)),
    "both": flush(coulomb(0.5), (SQUARE, ASIDE)),
    "tripod": flush(
        coulomb(0.8), (supported(TRIPOD),), (-0.7, 0.6), rod_length=1.2, rod_angle=70.0
    ),
    "beyond": flush(coulomb(0.5), (RING,), (-0.3, 0.4), rod_length=1.2, rod_angle=35.0),
    "short": flush(coulomb(0.5), (RING,), (-1e-3, 1e-3), rod_length=2.0),
}
ANGLES = (-170.0, -90.0, -30.0, 0.0, 30.0, 60.0, 90.0, 150.0, 180.0)
CASES = [(name, angle) for name in SCENES for angle in ANGLES]


def sketches(name, angle):
    """A sketch for every solution in full."""
    own = SCENES[name]
    found = pp.solve(own, np.deg2rad(angle))
    for index in range(len(found)):
        yield Sketch.of(own, np.deg2rad(angle), solutions=found, chosen=index)
    if not len(found):
        yield Sketch.of(own, np.deg2rad(angle), solutions=found)


@pytest.mark.parametrize(("name", "angle"), CASES)
def test_the_box_holds_all_that_is_drawn(name, angle):
    for found in sketches(name, angle):
        one = () if found.solution is None else (found.solution,)
        low, high = found.box
        slack = 1e-9 + 0.03 * found.half
        picture = scene_picture(replace(found, solutions=one, chosen=len(one) - 1))
        for mark in picture.marks:
            points = points_of(mark)
            assert np.isfinite(points).all()
            assert ((points >= low - slack) & (points <= high + slack)).all(), mark
        assert "nan" not in to_svg(picture, found.box, (300, 300))


@pytest.mark.parametrize(("name", "angle"), CASES)
def test_the_force_acts_along_its_line_and_the_motion_at_the_contact(name, angle):
    for found in sketches(name, angle):
        one = found.solution
        if one is None or not moves(one):
            continue
        alone = replace(found, solutions=(one,), chosen=0)
        marks = drawn(alone, cones=False)
        (force,) = (each for each in arrows(marks, FORCE) if each.width == 1.6)
        tail, along = force.points[0], np.diff(force.points, axis=0)[0]
        assert along == pytest.approx(found.force_scale(one) * one.force)
        # The torque of the drawn force is that of the forces at both ends of the side.
        (a, b), normal = found.ends, one.end_forces[:, 0, 1]
        torque = tail[0] * one.force[1] - tail[1] * one.force[0]
        assert torque == pytest.approx(a * normal[0] + b * normal[1], abs=1e-9)
        if a <= one.force_position <= b:
            assert tail == pytest.approx((one.force_position, 0.0))
        # The motion of the contact is that of the twist there.
        (motion,) = arrows(marks, MOTION)
        arm = motion.points[0] - found.center
        v_x, v_y, spin = one.twist
        moved = np.array([v_x - spin * arm[1], v_y + spin * arm[0]])
        assert np.diff(motion.points, axis=0)[0] == pytest.approx(
            found.motion_scale * moved, abs=1e-8
        )
        assert motion.points[0, 0] in (0.0, a, b)
        assert one.flush == (motion.points[0, 0] == 0.0)


@pytest.mark.parametrize("name", SCENES)
def test_a_side_takes_the_place_of_the_rod_and_has_a_friction_cone_at_each_end(name):
    found = Sketch.of(SCENES[name])
    marks, ends = drawn(found), np.array([(end, 0.0) for end in found.ends])
    lines = [line.points for line in marks[Line] if line.color == SLIDER]
    assert any(np.array_equal(points, ends) for points in lines)
    assert not any(np.array_equal(points, [(0.0, 0.0), found.center]) for points in lines)
    dots = [dot.position.tolist() for dot in marks[Dot] if dot.face == SLIDER]
    assert all(end in dots for end in ends.tolist())
    assert [0.0, 0.0] not in dots
    assert not [area for area in marks[Area] if area.ink == MOTION]
    cones = [area.rings[0] for area in marks[Area] if area.ink == FORCE]
    assert len(cones) == 2
    edges = pp.friction_cone(
        replace(SCENES[name], slider=replace(SCENES[name].slider, flush=False))
    )
    for cone, end in zip(cones, ends, strict=True):
        rim = cone[1:] - end if name != "rough" else cone - end
        assert np.hypot(*rim.T).max() < 0.5 * np.ptp(found.ends)
        turns = np.unwrap(np.arctan2(*rim.T[::-1]))
        assert np.ptp(turns) == pytest.approx(float(edges.span), abs=1e-9)
    assert not [area for area in drawn(found, cones=False)[Area] if area.ink == FORCE]


def test_the_forces_at_the_ends_are_drawn_where_they_are_determined():
    slips, sticks = (next(sketches("square", angle)) for angle in (30.0, 75.0))
    thin = tint(FORCE, 0.75)
    (left, right), one = arrows(drawn(slips), thin), slips.solution
    assert one.mode == ContactMode.SLIP_LEFT
    whole = sum(np.diff(each.points, axis=0)[0] for each in (left, right))
    assert whole == pytest.approx(slips.force_scale(one) * one.force)
    assert [left.points[0].tolist(), right.points[0].tolist()] == [[-1.0, 0.0], [1.0, 0.0]]
    assert sticks.solution.mode == ContactMode.STICK
    assert not arrows(drawn(sticks), thin)
    assert "$x^{*}$" in names(sticks)


def test_adhesion_beyond_the_side_pulls_along_its_line_of_action():
    (found,) = (
        each
        for each in sketches("rough", 0.0)
        if each.solution and each.solution.flush and moves(each.solution)
    )
    (force,) = (each for each in arrows(drawn(found), FORCE) if each.width == 1.6)
    assert force.points[0] == pytest.approx(found.center)  # the push is along the fence
    assert "$x^{*}$" not in names(found)
    assert r"$\mathbf{f}$ (adhesive)" in names(found)


HELD = "sticks, held by adhesion"


@pytest.mark.parametrize(
    ("name", "angle", "said"),
    [
        ("square", 90, "The side stays flush and sticks."),
        ("square", 150, "The side slips to the right, flush."),
        ("square", 30, "The side slips to the left, flush."),
        ("square", -90, "The contact breaks."),
        ("beyond", 90, "The side lifts off, turns about its right end and sticks."),
        ("beyond", 150, "The side lifts off, turns about its right end and slips to the right."),
        ("rough", -90, f"The side stays flush and {HELD}; three other solutions: the contact breaks, the "
         f"side lifts off, turns about its left end and {HELD}, or the side lifts off, turns about its "
         f"right end and {HELD}."),
        ("rough", -37, f"The side stays flush and {HELD}; two other solutions: the contact breaks, or the "
         f"side lifts off, turns about its left end and {HELD}."),
    ],
)  # fmt: skip
def test_a_push_is_told_in_words(name, angle, said):
    ax = pp.draw(SCENES[name], np.deg2rad(angle))
    assert ax.get_title().replace("\n", " ") == said
    ax.figure.savefig(io.BytesIO(), format="png")
    frame = ax.figure.bbox
    for extent in (text.get_window_extent() for text in (ax.title, *ax.texts)):
        assert frame.x0 <= extent.x0 < extent.x1 <= frame.x1
        assert frame.y0 <= extent.y0 < extent.y1 <= frame.y1


def test_subjects_change_in_a_list_of_alternatives():
    pusher = np.array([0.0, 1.0])
    stick, slip = (next(sketches("square", angle)).solution for angle in (90.0, 150.0))
    separate = next(sketches("square", -90.0)).solution
    assert outcome((stick, separate, slip), pusher, 0) == (
        "The side stays flush and sticks; two other solutions: the contact breaks, or the side slips "
        "to the right, flush."
    )  # fmt: skip
    assert does(slip, pusher) == "slips to the right, flush"


def test_the_table_has_the_contact_and_the_place_of_the_force():
    pusher = np.array([0.0, 1.0])
    rows = {name: row(next(sketches(name, 90.0)).solution, pusher) for name in ("square", "beyond")}
    assert (rows["square"]["contact"], rows["square"]["at x*"]) == ("flush", "0")
    assert (rows["beyond"]["contact"], rows["beyond"]["at x*"]) == ("right end", "0.4")
    separate = row(next(sketches("square", -90.0)).solution, pusher)
    assert (separate["contact"], separate["at x*"]) == ("–", "–")
    assert "contact" not in row(pp.solve(scene(coulomb(2)), 1.0)[0], pusher)


@pytest.mark.parametrize("angle", [None, 1.0])
def test_a_side_has_no_limit_curve(angle):
    with pytest.raises(
        pp.InvalidValue, match=r"^limit_curve: .*side that lies on the fence"
    ) as caught:
        pp.draw(SCENES["square"], angle, limit_curve=True)
    assert "\n" not in str(caught.value)


def test_a_side_has_pictures_in_a_notebook():
    own = SCENES["square"]
    for found in (own._repr_svg_(), pp.solve(own, 1.0)._repr_html_()):
        assert found.count("<svg") == found.count("</svg>") == 1
        assert "nan" not in found.partition("</svg>")[0]


# -- over time ---------------------------------------------------------------------------------------


def on_feet(*weights):
    """Square of side 2 on feet at its corners, its lower side on the fence."""
    center = np.average(CORNERS, axis=0, weights=weights)
    rod = center - (0.0, -1.0)
    turn = -np.arctan2(rod[1], rod[0])
    away = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    body = [tuple(map(float, each)) for each in (np.array(CORNERS) - center) @ away]
    slider = {
        "rod_length": float(np.hypot(*rod)),
        "rod_angle": float(np.rad2deg(-turn)),
        "outline": body,
    }
    return flush(coulomb(0.5), (supported(pp.Points(body, weights)),), **slider)


def at_corner(effects=()):
    """Square of side 2 that touches the fence with its corner (-1, -1), turned by 20 degrees."""
    turn = np.deg2rad(20.0)
    plate = pp.SupportFriction(support=pp.Polygon(CORNERS))
    normal = np.sin(turn), np.cos(turn)
    return pp.scene_at(
        (-1, -1), normal, effects=(plate, *effects), contact=pp.Coulomb(0.5), outline=CORNERS
    )


PATH = [(0, (0, 0)), (1, (0, 0.6)), (2, (0.7, 1.2)), (3.5, (-0.2, 2.1))]
#: Logs: a side stays on the fence, leaves it, arrives there, stays with inertia, strikes it.
RUNS = {
    "stays": (flush(coulomb(0.5)), {"velocity": (0.2, 1.0)}, 2.0),
    "leaves": (on_feet(1, 12, 12, 1), {"waypoints": PATH}, 3.5),
    "arrives": (at_corner(), {"velocity": (0.4, 1.0)}, 4.0),
    "inertia": (flush(coulomb(0.5), (SQUARE, INERTIA)), {"velocity": (0.2, 1.0)}, 2.0),
    "strikes": (at_corner((pp.Inertia(),)), {"velocity": (0.3, 1.0)}, 4.0),
}


@pytest.fixture(scope="module")
def data():
    """Plotted data of the runs."""
    return {
        name: path_data(pp.simulate(own, pusher=pp.Pusher(**path), duration=duration))
        for name, (own, path, duration) in RUNS.items()
    }


def marks_at(motion, at):
    picture = Picture()
    add_instant(picture, motion, at)
    return picture.marks


@pytest.mark.parametrize("name", RUNS)
def test_the_force_acts_on_the_fence_and_within_its_side(data, name):
    motion = data[name]
    assert motion.path_flush.values.any()
    touch, fence = contact(motion), motion.path_pusher.values[:, 1]
    pushed = np.isfinite(motion.path_contact_position.values)
    assert touch[pushed, 1] == pytest.approx(fence[pushed], abs=1e-8)
    for at in range(motion.sizes["time"]):
        side = side_on_fence(motion, at)
        assert (side is not None) == motion.path_flush.values[at]
        if side is not None:
            assert side[:, 1] == pytest.approx(np.full(2, fence[at]), abs=1e-6)
            assert np.ptp(side[:, 0]) == pytest.approx(2.0)
            assert side[0, 0] - 1e-9 <= touch[at, 0] <= side[1, 0] + 1e-9
            assert fence_ends(motion)[0] < side[0, 0] - motion.path_pusher.values[at, 0]
            assert fence_ends(motion)[1] > side[1, 0] - motion.path_pusher.values[at, 0]


@pytest.mark.parametrize("name", RUNS)
def test_an_instant_has_a_side_or_a_rod(data, name):
    motion = data[name]
    low, high = box(motion)
    slack, touch = 0.08 * np.ptp((low, high), axis=0).max(), contact(motion)
    for at in range(0, motion.sizes["time"], 7):
        marks, origin = marks_at(motion, at), pose(motion, at).origin
        dots = [mark.position for mark in marks if isinstance(mark, Dot) and mark.face == SLIDER]
        side = side_on_fence(motion, at)
        lines = [mark.points for mark in marks if isinstance(mark, Line)]
        rods = [line for line in lines if len(line) == 2 and np.array_equal(line[1], origin)]
        if side is None:
            (rod,) = rods
            assert rod[0] == pytest.approx(touch[at])
            assert any(np.array_equal(rod[0], dot) for dot in dots)
        else:
            assert not rods
            assert all(any(np.array_equal(end, dot) for dot in dots) for end in side)
        for mark in marks:
            points = points_of(mark)
            assert ((points >= low - slack) & (points <= high + slack)).all(), mark


@pytest.mark.parametrize("name", RUNS)
def test_the_path_of_the_contact_has_no_jumps(data, name):
    picture, motion = Picture(), data[name]
    add_paths(picture, motion, box(motion))
    inks = {look.ink for look in MODES.values()}
    paths = [mark.points for mark in picture.marks if isinstance(mark, Line) and mark.color in inks]
    fastest = np.hypot(*np.diff(motion.path_pusher.values, axis=0).T).max()
    for points in paths:
        assert np.hypot(*np.diff(points, axis=0).T).max(initial=0) < 4 * fastest


@pytest.mark.parametrize("name", RUNS)
def test_bars_mark_a_flush_side_on_the_strip_and_in_the_legend(data, name):
    motion = data[name]
    own, path, duration = RUNS[name]
    figure = pp.plot_log(pp.simulate(own, pusher=pp.Pusher(**path), duration=duration))
    axes = figure.axes[-1]
    bars = [patch for patch in axes.patches if patch.get_hatch() == over_time.BARRED["hatch"]]
    time, marked = motion.time.values, [run for run in runs(motion) if run.flush]
    shares = sum(bar.get_width() for bar in bars)
    assert shares == pytest.approx(sum(time[run.stop] - time[run.start] for run in marked))
    assert {bar.get_x() for bar in bars} <= {time[run.start] for run in marked}
    assert "a side flush on the fence" in [
        text.get_text() for legend in figure.legends for text in legend.get_texts()
    ]


def test_frames_say_flush_and_keep_the_force_on_the_side(data):
    motion = resample(data["leaves"], 50)
    said = [status(motion, at) for at in range(50)]
    assert said[0] == "stick, flush"
    assert "slip left, flush" in said
    assert said[-1] in ("stick", "slip right")
    for at in range(50):
        side, touch = side_on_fence(motion, at), contact(motion)[at]
        if side is not None:
            assert side[0, 0] - 1e-9 <= touch[0] <= side[1, 0] + 1e-9


def test_a_log_of_a_side_is_animated(tmp_path):
    own, path, duration = RUNS["leaves"]
    log = pp.simulate(own, pusher=pp.Pusher(**path), duration=duration)
    pp.animate(log, tmp_path / "a.gif", frames=4)
    with Image.open(tmp_path / "a.gif") as image:
        assert image.n_frames == 4


def test_a_log_with_an_outline_and_no_flush_side_has_its_contact_at_a_corner():
    log = pp.simulate(at_corner(), pusher=pp.Pusher(velocity=(0.4, 1.0)), duration=0.5)
    motion = path_data(log)
    assert not motion.path_flush.values.any()
    body = body_in(motion)
    places = [
        pose(motion, at).to_plane(body.support.vertices) for at in range(motion.sizes["time"])
    ]
    lowest = [each[np.argmin(each[:, 1])] for each in places]
    assert contact(motion) == pytest.approx(np.array(lowest), abs=1e-8)
    assert not side_on_fence(motion, 0)
