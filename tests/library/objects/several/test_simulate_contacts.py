"""Several pushers and walls over time: closed forms, steps against events, energy, and wrong input."""

import numpy as np
import pytest

import planar_pushing as pp

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
FEET = pp.SupportFriction(support=pp.Points([(1, 1), (-1, 1), (-1, -1), (1, -1)]))
OBJECT = {"effects": [FEET], "outline": SQUARE}


def touch(point, mu=0.5, **options):
    """A contact with Coulomb friction."""
    return pp.Contact(point, law=pp.Coulomb(mu), **options)


def finger(velocity, radius=0.1, **options):
    """A finger that moves in the world."""
    return pp.Pusher(
        velocity=velocity, shape="finger", radius=radius, **({"frame": "world"} | options)
    )


def energy_error(log):
    """Work of the pushers less the energies dissipated."""
    return float(log.work.sum("contact")[-1] - log.contact_dissipated[-1] - log.dissipated[-1])


def test_two_fingers_push_a_square_straight():
    contacts = [touch((-0.5, -1)), touch((0.5, -1))]
    log = pp.simulate_contacts(contacts, [finger((0, 1))] * 2, duration=2.0, **OBJECT)
    assert log.object_position.values[-1] == pytest.approx([0.0, 2.0], abs=1e-12)
    assert log.object_angle.values == pytest.approx(0.0, abs=1e-9)
    assert (log["mode"] == pp.ContactMode.STICK).all()
    assert log.force.sum("contact").values[-1] == pytest.approx([0.0, 1.0], abs=1e-9)
    assert log.work.values[-1].sum() == pytest.approx(2.0, abs=1e-9)


def test_one_pusher_is_that_of_simulate():
    scene = pp.scene_at((-0.3, -1), contact=pp.Coulomb(0.3), **OBJECT)
    pusher = finger((0.4, 1.0))
    one = pp.simulate(scene, pusher, duration=1.5, object_pose=(0.2, 0.1, 0.3))
    log = pp.simulate_contacts(
        [touch((-0.3, -1), 0.3)], [pusher], duration=1.5, object_pose=(0.2, 0.1, 0.3), **OBJECT
    )
    assert log.object_position.values[-1] == pytest.approx(one.object_position.values[-1], abs=1e-7)
    assert float(log.object_angle[-1]) == pytest.approx(float(one.object_angle[-1]), abs=1e-6)
    assert float(log.work[-1, 0]) == pytest.approx(float(one.work[-1]), abs=1e-7)
    assert float(log.slip[-1, 0]) == pytest.approx(float(one.slip[-1]), abs=1e-7)


def test_the_frame_of_a_contact_is_along_its_tangent_and_normal():
    pose = (0.0, 0.0, 0.7)
    c, s = np.cos(0.7), np.sin(0.7)
    x, y = 0.3, 1.0  # along the tangent and the normal of the lower side
    world = (c * x - s * y, s * x + c * y)
    logs = [
        pp.simulate_contacts([touch((0.2, -1))], [pusher], duration=1.0, object_pose=pose, **OBJECT)
        for pusher in (finger((x, y), frame="fence"), finger(world))
    ]
    ends = [log.object_position.values[-1] for log in logs]
    assert ends[0] == pytest.approx(ends[1], abs=1e-12)


@pytest.mark.parametrize(
    ("contacts", "pushers"),
    [
        ([touch((-0.5, -1)), touch((0.5, -1))], [finger((0, 1)), finger((0, 0.8))]),
        ([touch((-1, 0.3), 0.2), touch((1, -0.4), 0.1)], [finger((1, 0.2)), finger((1, 0.1))]),
        ([touch((-0.5, -1), 0.2), touch((1, 0.2), 0.2)], [finger((0.2, 1)), finger((0.3, 0.2))]),
        ([touch((-1, 0.2), 0.3), touch((0.3, -1), 0.0)], [finger((1, 0.3)), finger((0.8, 0.3))]),
    ],
)
def test_steps_approach_events(contacts, pushers):
    given = {"duration": 0.8, "samples": 11, **OBJECT}
    exact = pp.simulate_contacts(contacts, pushers, **given)
    assert energy_error(exact) == pytest.approx(0.0, abs=1e-8)
    errors = []
    for step in (0.02, 0.005):
        log = pp.simulate_contacts(contacts, pushers, step=step, **given)
        away = log.object_position.values[-1] - exact.object_position.values[-1]
        turned = np.deg2rad(float(log.object_angle[-1] - exact.object_angle[-1]))
        errors.append(float(np.hypot(*away) + abs(turned)))
    assert errors[1] < 0.4 * errors[0] + 1e-9
    assert errors[0] < 0.02


def test_an_object_between_a_finger_and_a_wall_stops_where_it_is_wedged():
    wall = pp.Wall((1, 0), (-1, 0), pp.Coulomb(1.0))
    with pytest.warns(pp.EarlyEndWarning, match="wedged|jammed"):
        log = pp.simulate_contacts(
            [touch((-1, 0.3), 1.0)], [finger((1, 0))], duration=1.0, walls=[wall], **OBJECT
        )
    assert float(log.time[-1]) == 0.0


def test_a_fence_turns_a_corner_down_onto_its_side():
    """A square on one corner, pushed by a fence, comes to lie flat, as `simulate` has it."""
    angle = np.deg2rad(20.0)
    corner = (1.0, -1.0) if np.sin(angle) < 0 else (-1.0, -1.0)
    lowest = min(SQUARE, key=lambda p: p[0] * np.sin(angle) + p[1] * np.cos(angle))
    assert lowest == corner
    normal = (np.sin(angle), np.cos(angle))
    pusher = pp.Pusher(velocity=(0.0, 1.0), frame="world")
    scene = pp.scene_at(corner, normal, contact=pp.Coulomb(0.5), **OBJECT)
    one = pp.simulate(scene, pusher, duration=4.0, object_pose=(0, 0, angle))
    log = pp.simulate_contacts(
        [pp.Contact(corner, normal, law=pp.Coulomb(0.5))], [pusher],
        duration=4.0, object_pose=(0, 0, angle), **OBJECT,
    )  # fmt: skip
    assert float(log.object_angle[-1]) == pytest.approx(float(one.object_angle[-1]), abs=1e-6)
    assert log.object_position.values[-1] == pytest.approx(one.object_position.values[-1], abs=1e-6)


def test_loads_do_not_turn_with_the_object():
    load = pp.Load(force=(0.1, 0.0), center=(0.0, 0.5))
    given = {"outline": SQUARE, "effects": [FEET, load]}
    scene = pp.scene_at((-0.3, -1), contact=pp.Coulomb(0.3), **given)
    pusher = finger((0.4, 1.0))
    one = pp.simulate(scene, pusher, duration=1.5, object_pose=(0, 0, 0))
    log = pp.simulate_contacts([touch((-0.3, -1), 0.3)], [pusher], duration=1.5, **given)
    assert float(log.object_angle[-1]) == pytest.approx(float(one.object_angle[-1]), abs=1e-5)
    assert float(log.load_work[-1]) == pytest.approx(float(one.load_work[-1]), abs=1e-6)


@pytest.mark.parametrize(
    ("contacts", "pushers", "options", "said"),
    [
        ([], [], {}, "a list of Pusher"),
        ([touch((0, -1))], [], {}, "a list of Pusher"),
        ([touch((0, -1))], [finger((0, 1))] * 2, {}, "one for each of 1 contacts"),
        ([touch((0, -1), velocity=(0, 1))], [finger((0, 1))], {}, "without velocities"),
        ([touch((0, -0.9))], [finger((0, 1))], {}, "a point on the outline"),
        ([touch((0, -1))], [finger((0, 1))], {"duration": -1.0}, "duration"),
        ([touch((0, -1))], [finger((0, 1))], {"step": 0.0}, "step"),
        ([touch((0, -1))], [finger((0, 1))], {"walls": [1]}, "a sequence of Wall"),
        (
            [touch((0, -1))], [finger((0, 1))],
            {"walls": [pp.Wall((0, 0), (0, 1), pp.Coulomb(0.1))]}, "of wall 0 with the object",
        ),
        ([touch((0, -1))], [finger((0, 1))], {"effects": [FEET, pp.Inertia()]}, "inertia"),
        ([touch((0, -1))], [finger((0, 1))], {"on_ambiguity": "never"}, "on_ambiguity"),
        (
            [pp.Contact(side=0, law=pp.Coulomb(0.1))], [finger((0, 1))], {}, "a fence",
        ),
    ],
)  # fmt: skip
def test_wrong_input_is_one_line(contacts, pushers, options, said):
    with pytest.raises(pp.InvalidValue) as caught:
        pp.simulate_contacts(contacts, pushers, **(OBJECT | {"duration": 1.0} | options))
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)
