"""A disc in an inner corner over time, without inertia: it turns the object, and leaves along a side."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from simulation.runs import check, imbalance, largest_energy

import planar_pushing as pp

#: The T of the PushT task, in millimeters, and another T, each with its corner at the sides' meeting point.
T = [(-60, 0), (-60, 30), (60, 30), (60, 0), (15, 0), (15, -90), (-15, -90), (-15, 0)]
OTHER_T = [(-2, -1), (2, -1), (2, 0), (0.5, 0), (0.5, 3), (-0.5, 3), (-0.5, 0), (-2, 0)]
METHODS = pytest.mark.parametrize("method", ["event-driven", "time-stepping"])
BOTH_FLIPS = pytest.mark.parametrize("flip", [1, -1], ids=["", "mirror"])


def flipped(outline, flip):
    """An outline, or its mirror image, still counterclockwise."""
    return [(flip * x, y) for x, y in outline][::flip]


def scene_of(outline, point, mu, support=None, flip=1):
    outline = flipped(outline, flip)
    support = pp.Polygon(outline) if support is None else support
    return pp.scene_at(
        (flip * point[0], point[1]), outline=outline, contact=pp.Coulomb(mu),
        effects=[pp.SupportFriction(support=support)],
    )  # fmt: skip


def run(scene, velocity, radius, duration, flip=1, pose=(0.0, 0.0, 0.0), **options):
    """A run of a disc with a velocity in the world, whose axes are at first those of the object."""
    velocity = flip * velocity[0], velocity[1]
    finger = pp.Pusher(shape="finger", radius=radius, velocity=velocity, frame="world")
    return pp.simulate(scene, finger, duration=duration, object_pose=pose, **options)


def pose_of(log, at=-1):
    return np.array([*log.object_position.values[at], float(log.object_angle[at])])


# --- The check value, and the angle as the only state ----------------------------------------------------


@BOTH_FLIPS
@pytest.mark.parametrize(("method", "error"), [("event-driven", 2e-7), ("time-stepping", 2e-4)])
def test_the_disc_stays_in_the_corner_of_the_uniform_tee(method, error, flip):
    """Known from one root in the rotation at each instant."""
    scene = scene_of(T, (15.0, -5.0), 0.2, flip=flip)
    log = check(run(scene, (-10.0, 10.0), 5.0, 3.0, flip, method=method), 1e-6)
    wanted = np.array([-30.31859, 21.51359, 23.77265]) * [flip, 1, flip]
    assert pose_of(log) == pytest.approx(wanted, rel=error)
    corner = np.flatnonzero(pieces_of(scene)[:, 2] == 0.0)
    assert set(log.contact_piece.values[1:]) <= {*corner}
    assert not log.adhesive.any()


def pieces_of(scene):
    return scene.slider.outline_in_body().pieces


def rotated(angle, vector):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]])


class Corner:
    """Feet, a disc at two sides with normals into the object, and the balance of its center's torque."""

    def __init__(self, feet, loads, normals, center, mu, radius):
        self.away, self.loads = np.asarray(feet) - center, np.asarray(loads) / np.sum(loads)
        self.normals, self.mu, self.radius = np.asarray(normals, float), mu, radius

    def balance(self, omega, v, sense):
        """Normal forces of both sides, and the torque about the center that is left."""
        u = v + omega * np.stack([-self.away[:, 1], self.away[:, 0]], axis=-1)
        force = self.loads[:, None] * u / np.hypot(*u.T)[:, None]
        torque = (self.away[:, 0] * force[:, 1] - self.away[:, 1] * force[:, 0]).sum()
        tangents = np.stack([self.normals[:, 1], -self.normals[:, 0]], axis=-1)
        pushes = np.linalg.solve((self.normals + self.mu * sense * tangents).T, force.sum(axis=0))
        return pushes, torque + self.radius * self.mu * sense * pushes.sum()

    def rotation(self, v):
        """The rotation rate, and the normal forces."""
        for sense in (1.0, -1.0):
            near, far = sense * 1e-9 * np.hypot(*v), sense * 1e3 * np.hypot(*v)
            values = [self.balance(omega, v, sense)[1] for omega in (near, far)]
            if values[0] * values[1] < 0.0:
                omega = brentq(lambda x, s=sense: self.balance(x, v, s)[1], near, far, xtol=1e-15)
                return omega, self.balance(omega, v, sense)[0]
        raise AssertionError("the disc sticks at both sides")

    def angles(self, velocity, duration):
        """The angle over time until the end, or until a side's force is zero."""

        def least(_, angle):
            return self.rotation(rotated(-angle[0], velocity))[1].min()

        least.terminal = True
        return solve_ivp(
            lambda _, angle: [self.rotation(rotated(-angle[0], velocity))[0]], (0.0, duration), [0.0],
            method="DOP853", rtol=1e-11, atol=1e-12, events=least, dense_output=True,
        )  # fmt: skip


def pose_about(center, velocity, time, angle):
    """The object's pose after its corner's disc has moved, and it has turned about the disc's center."""
    position = np.asarray(center) + time * np.asarray(velocity) - rotated(angle, center)
    return np.array([*position, np.rad2deg(angle)])


FEET = [(-55, 25), (50, 20), (10, -80), (-12, -60), (3, 7)]
LOADS = [1.0, 0.7, 1.3, 0.5, 0.9]


@BOTH_FLIPS
def test_the_angle_is_the_only_state(flip):
    support = pp.Points([(flip * x, y) for x, y in FEET], LOADS)
    scene, velocity = scene_of(T, (15.0, -5.0), 0.2, support, flip), (-10.0, 10.0)
    center = np.array([20.0, -5.0])
    corner = Corner(FEET, LOADS, [(-1, 0), (0, 1)], center, 0.2, 5.0)
    own = corner.angles(np.array(velocity), 2.0)
    assert own.success
    log = check(run(scene, velocity, 5.0, float(own.t[-1]), flip), 1e-9)
    for at in (len(log.time) // 2, -2):
        time = float(log.time[at])
        angle = float(own.sol(time)[0])
        wanted = pose_about(center, velocity, time, angle) * [flip, 1, flip]
        assert pose_of(log, at) == pytest.approx(wanted, abs=2e-6)
    assert imbalance(log).max() < 1e-11 * largest_energy(log)


@BOTH_FLIPS
def test_it_leaves_along_a_side_where_the_force_of_the_other_ends(flip):
    """Afterwards it is a finger on one side, begun there anew."""
    feet, loads, velocity = (
        [(-1.8, -0.9), (1.7, -0.3), (0.4, 2.8), (-0.3, 1.5)],
        [1.0, 1.1, 0.9, 0.6],
        (-0.6, -0.8),
    )
    support = pp.Points([(flip * x, y) for x, y in feet], loads)
    scene = scene_of(OTHER_T, (0.5, 0.1), 0.3, support, flip)
    center = np.array([0.6, 0.1])
    own = Corner(feet, loads, [(-1, 0), (0, -1)], center, 0.3, 0.1).angles(np.array(velocity), 9.0)
    assert len(own.t_events[0]) == 1
    leaves = float(own.t_events[0][0])
    log = check(run(scene, velocity, 0.1, 1.5 * leaves, flip), 1e-9)
    (event, *_) = np.flatnonzero(log.event.values == pp.Event.FORCE_ENDS)
    assert float(log.time[event]) == pytest.approx(leaves, abs=1e-7)
    wanted = pose_about(center, velocity, leaves, float(own.y_events[0][0, 0]))
    assert pose_of(log, event) == pytest.approx(wanted * [flip, 1, flip], abs=1e-6)
    # The bar is horizontal in the object, and the stem upright.
    piece = pieces_of(scene)[log.contact_piece.values[-1]]
    assert piece[2] == np.inf
    goes_along_bar = abs(np.sin(piece[3] + np.deg2rad(scene_angle(scene)))) < 1e-6
    contact = (0.6, 0.0) if goes_along_bar else (0.5, 0.1)
    position, angle = log.object_position.values[event], np.deg2rad(float(log.object_angle[event]))
    pose = (float(position[0]), float(position[1]), float(angle))
    rest = log.attrs["duration"] - float(log.time[event])
    # A hair's breadth from the corner, the finger touches one side only.
    again = run(scene_of(OTHER_T, contact, 0.3, support, flip), velocity, 0.1, rest, flip, pose)
    assert pose_of(again) == pytest.approx(pose_of(log), abs=1e-6)


def scene_angle(scene):
    """Angle of the body frame in the object's frame, in degrees."""
    c, s = scene.slider.outline_frame.axis
    return float(np.rad2deg(np.arctan2(s, c)))


# --- The log ------------------------------------------------------------------------------------------


@METHODS
@BOTH_FLIPS
def test_the_place_of_the_contact_follows_the_chain(method, flip):
    """From the stem to the corner, and along the bar: the places of the sides are where the disc is."""
    scene = scene_of(T, (15.0, -20.0), 0.1, flip=flip)
    log = check(run(scene, (-10.0, 25.0), 5.0, 4.0, flip, method=method, samples=201), 1e-6)
    pieces = log.contact_piece.values
    order = pieces[np.append(True, np.diff(pieces) != 0)]
    chain = pieces_of(scene)
    # The disc is in the corner for an instant only; time steps may miss it.
    assert [np.inf, *[0.0] * (len(order) - 2), np.inf] == chain[order, 2].tolist()
    assert len(order) in (2, 3)
    assert set(np.abs(np.diff(order))) <= {1, 2}
    # The finger's center in the object's frame.
    away = log.pusher_position.values - log.object_position.values
    angle = np.deg2rad(log.object_angle.values)
    x, y = rotated(-angle, away.T)
    on_stem, on_bar = pieces == order[0], pieces == order[-1]
    exact = method == "event-driven"
    assert flip * x[on_stem] == pytest.approx(20.0, abs=1e-6 if exact else 0.02)
    assert y[on_bar] == pytest.approx(-5.0, abs=1e-6 if exact else 0.02)
    # From the contact at time 0, 20 below the corner.
    place = flip * log.contact_position.values
    sense = np.sign(place[on_bar][-1])
    assert sense * place[on_stem] == pytest.approx(20.0 + y[on_stem], abs=1e-6 if exact else 0.05)
    assert sense * place[on_bar] == pytest.approx(
        20.0 + flip * x[on_bar] - 15.0, abs=1e-6 if exact else 0.05
    )
    # The normal is that of the piece in the world: of the stem -x, of the bar +y.
    normal = np.deg2rad(log.contact_normal.values)
    along = np.stack([np.cos(normal - angle), np.sin(normal - angle)], axis=-1)
    assert along[on_stem] == pytest.approx(np.tile([-flip, 0.0], (on_stem.sum(), 1)), abs=1e-6)
    assert along[on_bar] == pytest.approx(np.tile([0.0, 1.0], (on_bar.sum(), 1)), abs=1e-6)


def test_steps_are_at_least_of_first_order():
    scene, end = scene_of(T, (15.0, -5.0), 0.2), {"samples": 2}
    exact = pose_of(run(scene, (-10.0, 10.0), 5.0, 3.0, **end))
    coarse, fine = (
        pose_of(run(scene, (-10.0, 10.0), 5.0, 3.0, method="time-stepping", step=step, **end))
        - exact
        for step in (0.1, 0.05)
    )
    assert np.abs(coarse).max() / np.abs(fine).max() > 1.9


@pytest.mark.parametrize("labeled", [False, True])
def test_a_batch_stands_for_its_runs(labeled):
    """To the last bit, where the laws, the velocities and the radii differ."""
    mu, radius, speed = (
        np.array([0.05, 0.3, 0.1]),
        np.array([5.0, 5.0, 2.0]),
        np.array([20.0, -25.0, 22.0]),
    )

    def array(values):
        return xr.DataArray(values, dims="run") if labeled else values

    def law(values):
        return array(np.array([pp.Coulomb(value) for value in values.tolist()], dtype=object))

    def scene(contact):
        effects = [pp.SupportFriction(support=pp.Polygon(T))]
        return pp.scene_at((15.0, -20.0), outline=T, contact=contact, effects=effects)

    finger = pp.Pusher(
        shape="finger", radius=array(radius), velocity=(array(speed), array(0 * mu + 10.0))
    )
    batch = pp.simulate_batch(scene(law(mu)), finger, duration=2.0, samples=5)
    assert (batch.stopped == "").all()
    for i in range(3):
        one = pp.Pusher(shape="finger", radius=float(radius[i]), velocity=(float(speed[i]), 10.0))
        log = pp.simulate(scene(pp.Coulomb(float(mu[i]))), one, duration=2.0, samples=5)
        rows = np.searchsorted(log.time.values, batch.time.values[i], side="right") - 1
        for name in (
            "position",
            "rod_angle",
            "force",
            "mode",
            "slip",
            "contact_position",
            "contact_piece",
        ):
            assert np.array_equal(batch[name].values[i], log[name].values[rows]), name
        modes = log["mode"].values
        assert int(batch.mode_changes[i]) == np.count_nonzero(np.diff(modes))


@METHODS
def test_a_run_goes_on_until_a_rotation(method):
    scene, rotation = scene_of(T, (15.0, -5.0), 0.2), np.deg2rad(15.0)
    log = run(
        scene, (-10.0, 10.0), 5.0, 3.0, method=method, until=pp.Until(rotation=rotation), samples=11
    )
    assert log.attrs["stopped"].startswith("until: ")
    slack = 1e-7 if method == "event-driven" else 0.1
    assert float(log.object_angle[-1]) == pytest.approx(15.0, abs=slack)


@METHODS
def test_with_inertia_two_places_are_a_stop(method):
    scene = pp.scene_at(
        (15.0, -5.0), outline=T, contact=pp.Coulomb(0.2),
        effects=[pp.SupportFriction(support=pp.Polygon(T)), pp.Inertia()],
    )  # fmt: skip
    with pytest.warns(pp.EarlyEndWarning, match="touches the object at two places"):
        run(scene, (-10.0, 10.0), 5.0, 1.0, method=method)
