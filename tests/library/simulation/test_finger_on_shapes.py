"""Fingers that go round an outline: values found without pieces, and closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from numpy import cos, pi, sin, sqrt

import planar_pushing as pp

#: The ring about a dodecagon goes through its corners.
pytestmark = pytest.mark.filterwarnings("ignore:support:planar_pushing.SceneWarning")

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
SMALL = [(x / 10, y / 10) for x, y in SQUARE]
HALF = sqrt(3) / 2


def polygon(count):
    """A regular polygon of circumradius 1 with a side below."""
    angles = 2 * pi * (np.arange(count) - 0.5) / count - pi / 2
    return [(cos(angle), sin(angle)) for angle in angles]


HEXAGON, DODECAGON = polygon(6), polygon(12)
BOWL = pp.Outline([(2 * x, 2 * y) for x, y in SQUARE], holes=[pp.Disc(0.8)])


def on_circle(radius, degrees):
    return radius * cos(np.deg2rad(degrees)), radius * sin(np.deg2rad(degrees))


def push(outline, support, law, point, normal, velocity, radius, duration, *effects, **options):
    """A run with a finger whose velocity is along the axes of the world."""
    resisting = () if support is None else (pp.SupportFriction(support=support),)
    scene = pp.scene_at(
        point, normal, effects=(*resisting, *effects), contact=pp.Coulomb(law), outline=outline
    )
    finger = pp.Pusher(velocity=velocity, shape="finger", radius=radius, frame="world")
    return pp.simulate(scene, finger, duration=duration, object_pose=(0, 0, 0), **options)


def pose(log):
    """Displacement and rotation at the end, in radians."""
    return [*log.object_position.values[-1], np.deg2rad(log.object_angle.values[-1])]


def mug(law):
    """A mug of radius 40 mm, pushed in the frame of its contact at -75 degrees."""
    x, y = on_circle(1.0, -75)
    velocity = (-0.02 * y - 0.05 * x, 0.02 * x - 0.05 * y)
    return (
        pp.Disc(0.04), pp.Ring(0.04), law, on_circle(0.04, -75), None, velocity, 0.008, 2.0,
    )  # fmt: skip


#: Arguments of `push`, pose at the end, and the time at which the contact ends. The poses are those of an
#: integration of the pose alone, with the point of the outline nearest to the finger at each instant. The
#: motion of the mug is that of two equations with elliptic integrals; those of frictionless circles are
#: closed forms.
RUNS = {
    "mug": (
        mug(0.1), (-0.0247368076, 0.0473748111, np.deg2rad(15.552942592)), 1.6467231610, 1e-9,
    ),
    "rough mug": (
        mug(0.4), (-0.0222303647, 0.0680912296, np.deg2rad(49.388399592)), None, 1e-9,
    ),
    "frictionless disc": (
        (pp.Disc(1.0), pp.Disc(1.0), 0.0, on_circle(1.0, -100), None, (0, 1), 0.25, 1.5),
        (0.4526176399, 1.3244672441, 0), None, 1e-9,
    ),
    "end of a frictionless disc": (
        (pp.Disc(1.0), pp.Ring(1.0), 0.0, on_circle(1.0, -100), None, (0, 1), 0.25, 4.0),
        None, 3.0453075671, 1e-9,
    ),
    "frictionless bowl": (
        (BOWL, pp.Ring(1.0), 0.0, on_circle(0.8, 50), None, (0, 1), 0.3, 0.7),
        (0.2323571095, 0.5910136171, 0), None, 1e-9,
    ),
    "bowl": (
        (BOWL, pp.Ring(1.0), 0.3, on_circle(0.8, 50), None, (0, 1), 0.3, 0.7),
        (0.1598947015, 0.6098224333, 0.2171108231), None, 1e-9,
    ),
    "square": (
        (SQUARE, pp.Polygon(SQUARE), 0.2, (0.6, -1), None, (0.9, 1), 0.5, 2.0),
        (-0.0235642668, 0.4120213289, 0.5503997571), 1.2482514469, 1e-9,
    ),
    "hexagon": (
        (HEXAGON, pp.Polygon(HEXAGON), 0.1, (0.4, -HALF), None, (0.45, 1), 0.3, 2.0),
        (-0.21179966, 0.61002822, 0.78735561), 1.39601642, 2e-8,
    ),
    "hexagon and point": (
        (HEXAGON, pp.Polygon(HEXAGON), 0.1, (0.4, -HALF), None, (0.45, 1), 0.0, 2.0),
        (-0.10961034, 0.43511051, 0.57266291), 0.84421136, 2e-8,
    ),
    "corner and point": (
        (SMALL, pp.Polygon(SMALL), 0.1, (0.1, -0.1), (0, 1), (0.05, 0.1), 0.0, 0.8),
        (None, None, np.deg2rad(8.14054)), 0.2481737, 1e-7,
    ),
    "corner": (
        (SMALL, pp.Polygon(SMALL), 0.1, (0.1, -0.1), (0, 1), (0.05, 0.1), 0.01, 0.8),
        (None, None, np.deg2rad(18.81252193)), 0.6487640813, 1e-9,
    ),
    "dodecagon and point": (
        (DODECAGON, pp.Ring(1.0), 0.1, (0.1, -cos(pi / 12)), None, (0.5, 1), 0.0, 1.2),
        (-0.1047392052, 0.7806176454, 0.3317569126), None, 1e-9,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", RUNS)
def test_a_finger_goes_round_an_outline(name):
    arguments, wanted, ends, slack = RUNS[name]
    log = push(*arguments)
    assert log.attrs["stopped"] == ""
    for number, value in zip(pose(log), wanted or (), strict=False):
        assert value is None or number == pytest.approx(value, abs=slack)
    if ends is None:
        assert log.gap.values[-1] == 0.0
        return
    last = np.flatnonzero(log.event.values >= 0)
    assert log.time.values[last[-1]] == pytest.approx(ends, abs=slack)
    assert log.gap.values[-1] > 0.0


def test_a_point_passes_an_obtuse_corner():
    log = push(*RUNS["dodecagon and point"][0])
    (passes,) = np.flatnonzero(log.event.values == pp.Event.END_OF_SIDE)
    assert log.time.values[passes] == pytest.approx(0.838773401, abs=1e-9)
    assert (log.gap.values == 0.0).all()


@pytest.mark.parametrize("radius", [0.5, 2.0])
def test_a_frictionless_disc_leaves_a_cylinder_at_two_thirds(radius):
    """By the balance of energy, for any radii."""
    lean = on_circle(1.0, -90 - 0.05)
    falls = (pp.Inertia(mass=1.0, gyration_radius=sqrt(0.5), center=(0, 0)),
             pp.Load(force=(0, -1), center=(0, 0)))  # fmt: skip
    log = push(pp.Disc(1.0), None, 0.0, lean, None, (0, 0), radius, 40.0, *falls)
    (leaves,) = np.flatnonzero(log.event.values == pp.Event.FORCE_ENDS)
    center = log.object_position.values[leaves] - (1 + radius) * np.array(lean)
    assert center[1] / np.hypot(*center) == pytest.approx(-2 / 3 * lean[1], abs=1e-11)


def test_a_change_of_curvature_changes_the_force_at_once():
    """A rectangle slips from its side onto a rounded corner, over a finger at rest."""
    box = pp.rounded([(-1, -0.3), (1, -0.3), (1, 0.3), (-1, 0.3)], 0.15)
    center = (0.1, 0.05)
    falls = (pp.Inertia(mass=1.0, gyration_radius=sqrt(0.35), center=center),
             pp.Load(force=(0, -1), center=center))  # fmt: skip
    twist = (-0.25 + 0.5 * 0.35, 0.5 * 0.65, -0.5)  # the contact moves by -0.25 along x
    log = push(
        box, None, 0.0, (0.75, -0.3), None, (0, 0), 0.3, 0.5, *falls, twist=twist, samples=50001
    )
    (joins,) = np.flatnonzero(log.event.values == pp.Event.END_OF_SIDE)
    force = np.hypot(*log.force.values.T)
    assert log.time.values[joins] == pytest.approx(0.325742096, abs=1e-9)
    assert force[joins - 1] == pytest.approx(0.4025067, abs=1e-5)
    assert force[joins] == pytest.approx(0.3659691, abs=1e-7)


@pytest.mark.parametrize("massive", [False, True])
@pytest.mark.parametrize("shape", ["tee", "rounded", "disc", "ellipse"])
def test_an_array_of_contacts_goes_round_the_outline_as_each_alone(shape, massive):
    tee = [(-0.6, 0), (-0.6, 0.3), (0.6, 0.3), (0.6, 0), (0.15, 0), (0.15, -0.9), (-0.15, -0.9),
           (-0.15, 0)]  # fmt: skip
    outline = {
        "tee": pp.Outline(tee), "rounded": pp.rounded(SQUARE, 0.3), "disc": pp.Outline(pp.Disc(1.0)),
        "ellipse": pp.Outline.ellipse(1.0, 0.6, 16),
    }[shape]  # fmt: skip
    support = pp.Polygon(tee) if shape == "tee" else pp.Disc(0.6)
    effects = (pp.SupportFriction(support=support),)
    effects += (pp.Inertia(mass=1.0, gyration_radius=outline.gyration_radius),) * massive
    vertices = outline.vertices(1e-12 if shape == "tee" else None)
    places = vertices + 0.31 * (np.roll(vertices, -1, axis=0) - vertices)
    places = places if shape == "tee" else vertices
    law = pp.Coulomb(0.2)
    finger = pp.Pusher(velocity=(0.3, 1.0), shape="finger", radius=0.02)

    def scene(points):
        return pp.scene_at(points, effects=effects, contact=law, outline=outline)

    batch = pp.simulate_batch(scene(places), finger, duration=1.0)
    passed = 0
    for i, point in enumerate(places):
        log = pp.simulate(scene(tuple(point)), finger, duration=1.0)
        passed += (log.event.values == pp.Event.END_OF_SIDE).any()
        for name in ("position", "rod_angle", "slip", "gap"):
            # The radius of a polygon is rounded in another way for one contact.
            slack = 1e-8 if shape == "tee" else 0.0
            assert batch[name].values[i] == pytest.approx(log[name].values[-1], rel=0, abs=slack)
    assert passed or shape == "disc"


@pytest.mark.parametrize("method", ["event-driven", "time-stepping"])
@pytest.mark.parametrize("name", ["rounded", "T"])
def test_the_place_at_the_contact_is_an_arc_length_with_its_normal(name, method):
    """Against dense samples of the outline; the contact opens, and is made again elsewhere."""
    stem = [
        (-0.15, -1.2),
        (0.15, -1.2),
        (0.15, -0.3),
        (0.6, -0.3),
        (0.6, 0),
        (-0.6, 0),
        (-0.6, -0.3),
    ]
    outline = {"rounded": pp.rounded(SQUARE, 0.4), "T": pp.Outline([*stem, (-0.15, -0.3)])}[name]
    point, radius = {"rounded": (0.3, -1.0), "T": (0.0, -1.2)}[name], 0.07
    scene = pp.scene_at(
        point, effects=(pp.SupportFriction(support=pp.Disc(0.7)),), contact=pp.Coulomb(0.1),
        outline=outline,
    )  # fmt: skip
    away, back = (0.8, -0.1), (-0.9, 0.4)
    legs = [(0.0, (0.9, 0.5)), (0.8, away), (1.2, (0.0, 1.2)), (1.8, back)]
    finger = pp.Pusher(velocity=legs, shape="finger", radius=radius, frame="world")
    log = pp.simulate(
        scene, finger, duration=2.5, object_pose=(0, 0, 0), method=method,
        **({"step": 1e-3} if method == "time-stepping" else {}),
    )  # fmt: skip
    boundary = outline.vertices(1e-8)
    sides = np.roll(boundary, -1, axis=0) - boundary
    lengths = np.hypot(*sides.T)
    before = np.cumsum(lengths) - lengths

    def arc_length(place):
        part = np.clip(((place - boundary) * sides).sum(axis=1) / lengths**2, 0.0, 1.0)
        apart = np.hypot(*(place - boundary - part[:, None] * sides).T)
        nearest = apart.argmin()
        return before[nearest] + part[nearest] * lengths[nearest], apart[nearest]

    start, _ = arc_length(np.array(point))
    closed = log.gap.values <= 1e-9
    assert closed.sum() > 5
    for i in np.flatnonzero(closed):
        angle, normal = (
            np.deg2rad(log.object_angle.values[i]),
            np.deg2rad(log.contact_normal.values[i]),
        )
        place = log.pusher_position.values[i] + radius * np.array([cos(normal), sin(normal)])
        x, y = place - log.object_position.values[i]
        position, apart = arc_length(
            np.array([cos(angle) * x + sin(angle) * y, cos(angle) * y - sin(angle) * x])
        )
        assert apart < 1e-6
        turns = (log.contact_position.values[i] - (position - start)) / lengths.sum()
        assert turns == pytest.approx(round(turns), abs=1e-5)
    # Where the contact opens, the position goes on along the tangent.
    for i in np.flatnonzero(closed[:-1] & ~closed[1:]):
        elapsed = log.time.values[i + 1] - log.time.values[i]
        change = log.contact_position.values[i + 1] - log.contact_position.values[i]
        assert abs(change) <= 3.0 * elapsed + 1e-9


# -- no contact --------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", ["event-driven", "time-stepping"])
@pytest.mark.parametrize("massive", [False, True])
@pytest.mark.parametrize("radius", [0.0, 0.1])
def test_a_finger_in_flight_passes_ends_of_pieces_without_events(radius, massive, method):
    """It begins below a side, goes past its end, up, and back to the side beside it, which it meets."""
    friction = pp.SupportFriction(support=pp.Disc(0.7))
    effects = (friction, pp.Inertia(gyration_radius=0.6)) if massive else (friction,)
    scene = pp.scene_at((0.9, -1), effects=effects, contact=pp.Coulomb(0.3), outline=SQUARE)
    path = [(0, (0.9, 0)), (0.5, (0, 1.2)), (1.0, (-1.0, 0))]
    finger = pp.Pusher(velocity=path, shape="finger", radius=radius)
    step = {"step": 1e-3} if method == "time-stepping" else {}
    log = pp.simulate(scene, finger, duration=1.5, gap=0.1, method=method, samples=31, **step)
    meets = 1.35 - radius
    before = log.isel(time=log.time.values < meets - 0.01)
    assert (before["mode"] == pp.ContactMode.SEPARATE).all()
    assert (before.event == pp.Event.NONE).all()
    assert (before.contact_piece == -1).all()
    assert len(before.time) >= 20
    beside = log.isel(time=log.time.values > meets + 0.01)
    assert (beside.contact_piece == 2).all()
    assert len(beside.time) > 0
    if method == "event-driven":
        touches = log.time.values[log.event.values == pp.Event.TOUCHES]
        assert touches == pytest.approx([meets], abs=1e-9)


@pytest.mark.parametrize("massive", [False, True])
def test_a_finger_that_passes_beside_a_side_without_outline_touches_nothing(massive):
    """From then on it has parted, which is no event of the contact."""
    effects = (pp.SupportFriction(support=pp.Disc(0.7)),) + (pp.Inertia(),) * massive
    slider = pp.Slider(rod_length=1.0, rod_angle=np.pi / 2, side=(-1.0, 0.1))
    scene = pp.Scene(slider=slider, effects=effects, contact=pp.Coulomb(0.3))
    finger = pp.Pusher(velocity=(0.5, 0.3), shape="finger")
    log = pp.simulate(scene, finger, duration=1.0, gap=0.1)
    assert (log.event == pp.Event.NONE).all()
    assert (log["mode"] == pp.ContactMode.SEPARATE).all()
    assert (log.parted == (log.time > 1 / 3 - 1e-9)).all()
    assert log.parted[-1]
