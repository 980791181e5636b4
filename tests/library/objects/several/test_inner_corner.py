"""A point in an inner corner: two contacts at one point are the same as `solve` with its sum of cones."""

import numpy as np
import pytest

import planar_pushing as pp

SHAPES = {
    "right": ([(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)], (1, 1)),
    "wide": ([(0, 0), (3, 0), (3, 1), (1.2, 1.4), (0, 3)], (1.2, 1.4)),
    "narrow": ([(0, 0), (3, 0), (3, 2.5), (1.2, 0.8), (1, 3), (0, 3)], (1.2, 0.8)),
}


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize("mu", [0.0, 0.2, 0.7])
def test_both_enumerations_agree(name, mu):
    corners, point = SHAPES[name]
    effects = [pp.SupportFriction(support=pp.Polygon(corners))]
    law = pp.Coulomb(mu)
    scene = pp.scene_at(point, outline=corners, contact=law, effects=effects)
    for angle in np.linspace(-3.1, 3.1, 41):
        velocity = scene.to_object((np.cos(angle), np.sin(angle)), "vector")
        one = pp.solve(scene, float(angle))
        both = pp.solve_contacts(
            [pp.Contact(point, law=law, velocity=velocity)], effects=effects, outline=corners
        )
        twists = [scene.to_object(solution.twist, "twist") for solution in one]
        assert len(twists) == len(both)
        for twist in twists:
            away = [np.abs(solution.twist - twist).max() for solution in both]
            nearest = both[int(np.argmin(away))]
            assert min(away) < 1e-9
            sticks = nearest.modes == (pp.ContactMode.STICK, pp.ContactMode.STICK)
            # Forces that cancel without bound have no sum.
            if sticks and np.isfinite(nearest.forces).all():
                total = nearest.forces.sum(axis=0)
                stick = next(s for s in one if s.mode == pp.ContactMode.STICK)
                assert scene.to_object(stick.force, "vector") == pytest.approx(total, abs=1e-9)


def test_a_normal_of_one_side_is_a_contact_with_that_side_alone():
    corners, point = SHAPES["right"]
    effects = [pp.SupportFriction(support=pp.Polygon(corners))]
    answer = pp.solve_contacts(
        [pp.Contact(point, (-1, 0), law=pp.Coulomb(0.2), velocity=(-1, 0.2))],
        effects=effects, outline=corners,
    )  # fmt: skip
    assert all(len(solution.modes) == 1 for solution in answer)


@pytest.mark.parametrize("radius", [0.0, 0.2])
def test_a_finger_in_a_corner_over_time(radius):
    corners, point = SHAPES["right"]
    effects = [pp.SupportFriction(support=pp.Polygon(corners))]
    finger = pp.Pusher(velocity=(-1, -0.6), shape="finger", radius=radius, frame="world")
    log = pp.simulate_contacts(
        [pp.Contact(point, law=pp.Coulomb(0.2))], [finger],
        effects=effects, outline=corners, duration=0.5,
    )  # fmt: skip
    assert log.attrs["stopped"] == ""
    if radius == 0.0:  # a point is drawn as a disc of a ten-millionth of the object
        scene = pp.scene_at(point, outline=corners, contact=pp.Coulomb(0.2), effects=effects)
        one = pp.simulate(scene, finger, duration=0.5, object_pose=(0, 0, 0))
        assert float(log.object_angle[-1]) == pytest.approx(float(one.object_angle[-1]), abs=5e-5)


def test_a_disc_in_the_corner_of_a_t_turns_it_about_its_center():
    tee = [(-60, 0), (-60, 30), (60, 30), (60, 0), (15, 0), (15, -90), (-15, -90), (-15, 0)]
    law = pp.Coulomb(0.2)
    touches = [pp.Contact(p, law=law, velocity=(-1, 1)) for p in ((15, -5), (20, 0))]
    effects = [pp.SupportFriction(support=pp.Polygon(tee))]
    (turn,) = pp.solve_contacts(touches, effects=effects, outline=tee)
    assert turn.modes == (pp.ContactMode.SLIP_LEFT,) * 2
    assert turn.twist[2] == pytest.approx(0.0138859926, abs=5e-11)
    normal = -turn.forces[0, 0], turn.forces[1, 1]
    assert normal == pytest.approx((0.76556235, 0.45051739), abs=5e-9)
