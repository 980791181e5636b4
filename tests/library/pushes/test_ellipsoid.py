"""Pushes under an ellipsoid as limit surface, against viscous friction and a transcription."""

import numpy as np
import pytest
from pushes.written import SQUARE, touching, turn
from scipy.integrate import solve_ivp

import planar_pushing as pp
from planar_pushing.pushes.fit.ellipsoid import Ellipsoid

#: A friction coefficient that no push overcomes.
ROUGH = 1e9
#: Feet of a square of side 2 and its inverse matrix of viscous friction: 4 in translation, 8 in rotation.
CORNERS = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
ROUND = Ellipsoid(np.diag([1.0, 1.0, 0.5]))
#: Any positive definite matrix.
SKEW = Ellipsoid(np.array([[1.0, 0.3, -0.2], [0.3, 0.7, 0.25], [-0.2, 0.25, 0.9]]))


def from_below(place, path, radius=0.0):
    """A push of the lower side of the square, at (place, -1)."""
    return touching(SQUARE, (place, -1.0), (0.0, 1.0), path, radius)


@pytest.mark.filterwarnings("ignore:outline:planar_pushing.SceneWarning")
@pytest.mark.parametrize("radius", [0.0, 0.2])
@pytest.mark.parametrize(("place", "way", "mu"), [
    (0.0, (0.0, 0.5), 0.3), (0.0, (0.4, 0.2), 0.1), (0.3, (0.0, 0.5), 0.1), (0.3, (0.1, 0.5), 0.3),
    (-0.4, (-0.1, 0.4), 0.5), (0.3, (0.0, 0.5), np.inf), (0.2, (0.3, 0.3), np.inf),
])  # fmt: skip
def test_an_isotropic_ellipsoid_moves_like_viscous_friction(place, way, mu, radius):
    law = pp.InfiniteFriction() if np.isinf(mu) else pp.Coulomb(mu)
    scene = pp.scene_at(
        (place, -1.0), (0.0, 1.0), contact=law,
        effects=[pp.Viscous(support=pp.Points(CORNERS, [1] * 4), coefficient=4.0)],
    )  # fmt: skip
    pusher = pp.Pusher(velocity=way, shape="finger", radius=radius)
    log = pp.simulate_batch(scene, pusher, duration=1.0, rtol=1e-9)
    angle = np.deg2rad(log["rod_angle"].item()) - scene.slider.rod_angle
    center = np.array([place, -1.0]) + log["position"].values.ravel()
    (pose,) = ROUND.poses(from_below(place, way, radius), min(mu, ROUGH))
    assert pose == pytest.approx([*center, angle], abs=3e-5)


def transcribed(matrix, place, way, mu, radius):
    """Pose and place at the end: the twist from the three cases of Coulomb's law, one after another."""

    def rates(_, state):
        finger = turn(-state[2]) @ way
        x, y = place + state[3], -1.0
        jacobian = np.array([[1.0, 0.0, -y], [0.0, 1.0, x]])
        mobility = jacobian @ matrix @ jacobian.T
        force = np.linalg.solve(mobility, finger)
        slip = 0.0
        if abs(force[0]) > mu * force[1] or force[1] <= 0.0:
            # The finger passes along the side in the direction of its friction on the object.
            for sign in (1.0, -1.0):
                edge = np.array([sign * mu, 1.0])
                force = edge * finger[1] / (mobility @ edge)[1]
                slip = finger[0] - (mobility @ force)[0]
                if slip * sign > 0.0 and force[1] > 0.0:
                    break
        twist = matrix @ jacobian.T @ force
        return [*(turn(state[2]) @ twist[:2]), twist[2], slip - radius * twist[2]]

    return solve_ivp(rates, (0.0, 1.0), np.zeros(4), rtol=1e-9, atol=1e-11, max_step=0.01).y[:, -1]


@pytest.mark.parametrize("radius", [0.0, 0.3])
@pytest.mark.parametrize(("place", "way", "mu"), [
    (0.2, (0.05, 0.4), 0.6), (0.2, (0.3, 0.3), 0.1), (-0.3, (-0.4, 0.3), 0.1), (0.0, (0.0, 0.5), 0.0),
    (0.0, (0.1, 0.5), 0.25), (0.3, (0.0, 0.5), np.inf), (0.2, (0.3, 0.3), np.inf),
])  # fmt: skip
@pytest.mark.parametrize("ellipsoid", [SKEW, ROUND], ids=["skew", "round"])
def test_an_ellipsoid_against_a_transcription(ellipsoid, place, way, mu, radius):
    end = transcribed(ellipsoid.matrix, place, np.array(way), mu, radius)
    (pose,) = ellipsoid.poses(from_below(place, way, radius), min(mu, ROUGH))
    assert pose == pytest.approx(end[:3], abs=1e-4)


@pytest.mark.parametrize("mu", [0.1, 0.6])
def test_another_frame_makes_no_difference(mu):
    """The object turned by an angle, its matrix and its pushes too."""
    angle = 0.7
    matrix = turn(angle).T
    other = touching(
        np.array(SQUARE) @ matrix, [0.2, -1.0] @ matrix, [0.0, 1.0] @ matrix, [0.2, 0.4] @ matrix
    )
    one = SKEW.poses(from_below(0.2, (0.2, 0.4)), mu)[0]
    rotation = np.eye(3)
    rotation[:2, :2] = turn(angle)
    pose = Ellipsoid(rotation @ SKEW.matrix @ rotation.T).poses(other, mu)[0]
    assert pose == pytest.approx(rotation @ one, abs=1e-12)


def test_mirrored_pushes_have_mirrored_ends():
    """Without friction the force is along the normal; one push straight through the center."""
    right = ROUND.poses(from_below(0.3, (0.2, 0.4)), 0.2)[0]
    left = ROUND.poses(from_below(-0.3, (-0.2, 0.4)), 0.2)[0]
    assert left == pytest.approx(right * [-1, 1, -1], abs=1e-14)
    straight = ROUND.poses(from_below(0.0, (0.0, 0.4)), 0.2)[0]
    assert straight == pytest.approx([0.0, 0.4, 0.0], abs=1e-14)


def test_a_path_in_parts():
    """Equal parts are the whole; different ones follow one another."""
    whole = SKEW.poses(from_below(0.1, (0.2, 0.4)), 0.4)
    parts = SKEW.poses(from_below(0.1, [(0.05, 0.1)] * 4), 0.4)
    assert parts == pytest.approx(whole, abs=1e-12)
    pose = ROUND.poses(from_below(0.0, [(0.0, 0.3), (0.3, 0.3)]), ROUGH)[0]
    first = ROUND.poses(from_below(0.0, (0.0, 0.3)), ROUGH)[0]
    assert first == pytest.approx([0.0, 0.3, 0.0], abs=1e-12)
    second = ROUND.poses(from_below(0.0, (0.3, 0.3)), ROUGH)[0]
    assert pose == pytest.approx(first + second, abs=1e-5)


def test_a_finger_that_leaves_its_side():
    """Without friction or rotation, the finger passes the corner after 0.2 of a way of 1 along the side."""
    heavy = Ellipsoid(np.diag([1.0, 1.0, 1e-9]))
    found = heavy.poses(from_below(0.8, (1.0, 0.5)), 0.0)[0]
    assert found == pytest.approx([0.0, 0.1, 0.0], abs=0.5 / 60 + 1e-6)
    stays = heavy.poses(from_below(0.8, (-1.0, 0.5)), 0.0)[0]
    assert stays == pytest.approx([0.0, 0.5, 0.0], abs=1e-6)
    sticking = heavy.poses(from_below(0.8, (1.0, 0.5)), ROUGH)[0]
    assert sticking == pytest.approx([1.0, 0.5, 0.0], abs=1e-6)


def test_a_finger_that_parts_leaves_the_object():
    found = ROUND.poses(from_below(0.0, [(0.0, 0.2), (0.0, -0.5)]), 0.3)[0]
    assert found == pytest.approx([0.0, 0.2, 0.0], abs=1e-12)


def test_twists_and_wrenches_of_an_ellipsoid_about_a_center():
    """About the center translations need no torque; wrench and motion are inverse of each other."""
    center = np.array([0.4, -0.7])
    model = Ellipsoid.about(center, np.diag([1.0, 1.0, 2.0]))
    wrenches = np.random.default_rng(0).normal(size=(6, 3))
    assert model.wrenches(model.motions(wrenches)) == pytest.approx(wrenches)
    force = np.array([[0.3, 0.5, 0.4 * 0.5 + 0.7 * 0.3]])
    assert model.motions(force)[0] == pytest.approx([0.3, 0.5, 0.0])
    # A torque alone turns the object about the center.
    v_x, v_y, omega = model.motions(np.array([[0.0, 0.0, 1.0]]))[0]
    assert omega == pytest.approx(2.0)
    assert [-v_y / omega, v_x / omega] == pytest.approx(center)


def test_the_ellipsoid_of_a_support_is_that_of_fit_ellipsoid():
    """It holds the support's friction in translation, and its torque of spinning."""
    places, shares = np.array([(1, 0), (3, 0), (2, 2)]), np.array([0.25, 0.25, 0.5])
    fit = pp.fit_ellipsoid(pp.Points(places, shares))
    model = Ellipsoid.about(np.array(fit.center), fit.matrix)
    x, y = shares @ places
    torque = shares @ np.hypot(*(places - [x, y]).T)
    for f_x, f_y, spin in ((1.0, 0.0, 0.0), (0.6, -0.8, 0.0), (0.0, 0.0, torque)):
        load = np.array([f_x, f_y, spin + x * f_y - y * f_x])
        assert load @ model.matrix @ load == pytest.approx(1.0)
