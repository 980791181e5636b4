"""Two opposite fingers of which one is driven by force, against a minimum of a potential for each force.

With a given normal force of the finger that moves as given, friction of feet and of both fingers has a
convex potential, whose minimum is the only motion. The force that the support then needs along the normal
is compared with the one assumed: every change of sign over a fine grid of forces is a solution. The route
knows no modes and shares no code with the package.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq, minimize

import planar_pushing as pp

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
FEET = [(-0.8, -0.7), (0.9, -0.6), (0.2, 0.9), (-0.5, 0.4)]
SMOOTH = 1e-7


class Gripper:
    """A square on four feet, its left finger at (-1, y) and the one that presses at (1, y)."""

    def __init__(self, shares, height, held, pressed, frictions, force):
        self.shares, self.height = np.asarray(shares, dtype=float), height
        self.held, self.pressed = np.asarray(held), pressed
        self.frictions, self.force, self.last = frictions, force, np.zeros(2)

    def answer(self):
        support = pp.Points(FEET, self.shares / self.shares.sum())
        effects = [pp.SupportFriction(weight=float(self.shares.sum()), support=support)]
        one = pp.Contact((-1, self.height), law=pp.Coulomb(self.frictions[0]), velocity=self.held)
        other = pp.Contact(
            (1, self.height), law=pp.Coulomb(self.frictions[1]), velocity=(0.0, self.pressed),
            grip_force=self.force,
        )  # fmt: skip
        return pp.solve_contacts([one, other], effects=effects, outline=SQUARE)

    def support(self, twist):
        """Power of the friction of the feet, and its derivatives."""
        feet = np.array(FEET)
        v = np.array([twist[0] - twist[2] * feet[:, 1], twist[1] + twist[2] * feet[:, 0]])
        speed = np.sqrt((v**2).sum(axis=0) + SMOOTH**2)
        f = self.shares * v / speed
        wrench = np.array([f[0].sum(), f[1].sum(), (feet[:, 0] * f[1] - feet[:, 1] * f[0]).sum()])
        return (self.shares * speed).sum(), wrench

    def fingers(self, twist, force):
        """Power of the friction of both fingers, and its derivatives."""
        power, wrench = 0.0, np.zeros(3)
        speeds, forces = (self.held[1], self.pressed), (force, self.force)
        for x, w, mu, normal in zip((-1.0, 1.0), speeds, self.frictions, forces, strict=True):
            slip = twist[1] + twist[2] * x - w
            size = math.hypot(slip, SMOOTH)
            power += mu * normal * size
            wrench += mu * normal * slip / size * np.array([0.0, 1.0, x])
        return power, wrench

    def motion(self, force):
        """Twist at the minimum of the potential if the left finger presses with a force."""

        def twist_of(z):
            return np.array([self.held[0] + self.height * z[1], z[0], z[1]])

        def potential(z):
            (p, w), (q, u) = self.support(twist_of(z)), self.fingers(twist_of(z), force)
            slope = w + u
            return p + q, np.array([slope[1], slope[2] + self.height * slope[0]])

        start = self.last
        for _ in range(2):  # again from its end, where it stops at a kink
            found = minimize(potential, start, jac=True, method="BFGS", options={"gtol": 1e-9})
            start = found.x
        self.last = found.x
        return twist_of(found.x)

    def excess(self, force):
        """Force along the normal that the support needs, less that of the fingers."""
        return self.support(self.motion(force))[1][0] - (force - self.force)

    def twists(self):
        """Motions with both fingers at the object, by a grid of the force of the left one."""
        total = self.shares.sum()
        forces = np.linspace(max(self.force - 1.05 * total, 0.0), self.force + 1.05 * total, 81)
        values = [self.excess(force) for force in forces]
        found = []
        for k in range(len(forces) - 1):
            if values[k] * values[k + 1] < 0.0:
                found.append(self.motion(brentq(self.excess, forces[k], forces[k + 1], xtol=1e-9)))
        return found

    def reserve(self, forces):
        """Smallest power of the feet in a unit motion, less that of forces at both fingers.

        It is negative if friction cannot hold the slider at rest under the forces.
        """
        (f, g), y = forces, self.height
        wrench = np.array([f[0] + g[0], f[1] + g[1], g[1] - f[1] - y * (f[0] + g[0])])

        def excess(angles):
            polar, around = angles
            twist = np.array(
                [np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.cos(polar)]
            )
            return self.support(twist)[0] - wrench @ twist

        starts = [(polar, around) for polar in (0.6, 1.6, 2.5) for around in range(6)]
        first = min(starts, key=excess)
        return minimize(excess, first, method="Nelder-Mead").fun


def gripper(seed):
    """A random gripper; some press less than the support resists, some far more."""
    rng = np.random.default_rng(seed)
    return Gripper(
        shares=rng.uniform(0.3, 1.5, 4),
        height=float(rng.choice([0.0, rng.uniform(-0.8, 0.8)])),
        held=(float(rng.choice([-1.0, 1.0])), rng.uniform(-1.0, 1.0)),
        pressed=rng.uniform(-1.0, 1.0),
        frictions=rng.uniform(0.02, 0.5, 2),
        force=float(rng.choice([0.5, 2.0, 6.0, 40.0])),
    )


@pytest.mark.parametrize(
    "seed", [*range(4), *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(4, 8))]
)
def test_every_motion_is_that_of_a_minimum(seed):
    scene = gripper(seed)
    expected = scene.twists()
    closed = [one for one in scene.answer() if one.modes[0] != pp.ContactMode.SEPARATE]
    assert len(closed) == len(expected)
    for twist in expected:
        assert min(np.abs(one.twist - twist).max() for one in closed) < 2e-4


def check(scene, one):
    """Balance and laws of a solution with exact friction of moving feet."""
    mu, (f, g) = scene.frictions, one.forces
    normal, tangent = f[0], f[1]
    assert g[0] == pytest.approx(-scene.force)
    assert abs(g[1]) <= mu[1] * scene.force * (1 + 1e-9)
    assert normal >= -1e-12
    assert abs(tangent) <= mu[0] * normal * (1 + 1e-9) + 1e-12
    for x, w, force, limit, mode in zip(
        (-1.0, 1.0), (scene.held[1], scene.pressed), (tangent, g[1]),
        (mu[0] * normal, mu[1] * scene.force), one.modes, strict=True,
    ):  # fmt: skip
        slip = one.twist[1] + one.twist[2] * x - w
        if mode == pp.ContactMode.STICK:
            assert abs(slip) < 1e-9
        elif mode != pp.ContactMode.SEPARATE:
            assert force == pytest.approx(-math.copysign(limit, slip), rel=1e-9)
    if np.abs(one.twist).max() == 0.0:
        return
    feet = np.array(FEET)
    v = np.array(
        [one.twist[0] - one.twist[2] * feet[:, 1], one.twist[1] + one.twist[2] * feet[:, 0]]
    )
    p = scene.shares * v / np.hypot(*v)
    total = f + g
    torque = -f[1] - scene.height * f[0] + g[1] - scene.height * g[0]
    np.testing.assert_allclose(total, p.sum(axis=1), atol=1e-8 * scene.force + 1e-9)
    own = (feet[:, 0] * p[1] - feet[:, 1] * p[0]).sum()
    assert torque == pytest.approx(own, abs=1e-8 * scene.force + 1e-9)


@pytest.mark.parametrize(
    "block", [*range(2), *(pytest.param(block, marks=pytest.mark.slow) for block in range(2, 4))]
)
def test_a_thousand_grippers_balance(block):
    solved = 0
    for seed in range(250 * block, 250 * block + 250):
        scene = gripper(1000 + seed)
        answer = scene.answer()
        assert answer.status != pp.Status.UNSOLVED
        assert len(answer) > 0
        for one in answer:
            if one.pivot < 0:
                check(scene, one)
                solved += 1
    assert solved > 240


@pytest.mark.parametrize("velocities", [
    [(1.0, 0.4), (0.0, 0.0)], pytest.param([(-1.0, 0.0), (0.0, 1.0)], marks=pytest.mark.slow),
])  # fmt: skip
@pytest.mark.parametrize(
    "law", [pp.Coulomb(0.3), pp.InfiniteFriction(), pp.InfiniteFriction("none")]
)
def test_the_same_bits_compiled_and_plain(both, law, velocities):
    """With friction on feet, on an area and on a ring, and a grip that is weak or firm."""
    supports = [
        pp.SupportFriction(support=pp.Points(FEET)), pp.SupportFriction(support=pp.Polygon(SQUARE)),
        pp.SupportFriction(support=pp.Ring(radius=0.8)),
    ]  # fmt: skip
    force = np.array([0.1, 1.1, 20.0])
    for effect in supports:
        for velocity in velocities:
            one = pp.Contact((-1, 0.2), law=pp.Coulomb(0.2), velocity=velocity)
            other = pp.Contact((1, 0.2), law=law, velocity=(0, 0.5), grip_force=force)
            answer = pp.solve_contacts([one, other], effects=[effect], outline=SQUARE)
            assert not np.any(answer.status == pp.Status.UNSOLVED)
            assert np.all(answer.solutions > 0)
    assert "solve_gripped" in both.results


def test_a_firm_grip_moves_the_object_with_the_fingers():
    scene = Gripper([1, 1, 1, 1], 0.3, (0.2, 0.5), 0.5, (0.4, 0.4), 50.0)
    (only,) = scene.answer()
    assert only.modes == (pp.ContactMode.STICK,) * 2
    np.testing.assert_allclose(only.twist, [0.2, 0.5, 0.0], atol=1e-12)
    assert only.inner_force[0] == pytest.approx(50.0 + (only.forces[0, 0] - 50.0) / 2.0)


@pytest.mark.parametrize("angle", [0.3, 1.1, -2.0])
def test_the_inner_force_is_along_the_line_through_both_fingers(angle):
    c, s = math.cos(angle), math.sin(angle)

    def turned(points):
        return np.array(points) @ np.array([[c, s], [-s, c]])

    effects = [pp.SupportFriction(support=pp.Points(turned(FEET)))]
    places, count = turned([(-1, 0.3), (1, 0.3)]), 0
    line = (places[1] - places[0]) / 2.0
    for velocity in ((0.2, 0.5), (0.3, -0.4), (0.0, 1.0)):
        one = pp.Contact(places[0], law=pp.Coulomb(0.3), velocity=tuple(turned(velocity)))
        other = pp.Contact(
            places[1], law=pp.Coulomb(0.4), velocity=tuple(turned((0.0, -0.2))), grip_force=2.0
        )
        for each in pp.solve_contacts([one, other], effects=effects, outline=turned(SQUARE)):
            if pp.ContactMode.SEPARATE not in each.modes:
                for forces, inner in zip(
                    (each.forces, each.forces_end), each.inner_force, strict=True
                ):
                    assert inner == pytest.approx((forces[0] - forces[1]) @ line / 2.0)
                    count += 1
    assert count >= 6


def test_both_fingers_take_what_they_can_of_a_load_at_rest():
    """The held one all of its normal part, and friction of the other one as much as the grip allows.

    The load's line is such that the torque about the center vanishes with it.
    """
    effects = [
        pp.SupportFriction(support=pp.Points.rectangle(1.6, 1.6), weight=2.3),
        pp.Load(force=(-1.0, 2.0), center=(0.25, 0.0)),
    ]
    held = pp.Contact((-1, 0), law=pp.Coulomb(0.0), velocity=(0, 0))
    presses = pp.Contact((1, 0), law=pp.Coulomb(1.0), velocity=(0, 0), grip_force=0.5)
    (only,) = pp.solve_contacts([held, presses], effects=effects, outline=SQUARE)
    assert not only.twist.any()
    np.testing.assert_allclose(only.forces, [[1.5, 0.0], [-0.5, -0.5]], atol=1e-9)
    assert only.inner_force.tolist() == pytest.approx([1.0, 1.0])


def test_fingers_that_slide_along_leave_it_at_rest():
    scene = Gripper([1, 1, 1, 1], 0.0, (0.0, 1.0), 1.0, (0.3, 0.3), 2.0)
    (only,) = scene.answer()
    assert not only.twist.any()
    assert pp.ContactMode.STICK not in only.modes


def test_a_finger_that_leaves_is_followed_only_by_a_grip_that_beats_friction():
    weak = Gripper([1, 1, 1, 1], 0.0, (-1.0, 0.0), 0.0, (0.3, 0.3), 1.0).answer()
    firm = Gripper([1, 1, 1, 1], 0.0, (-1.0, 0.0), 0.0, (0.3, 0.3), 9.0).answer()
    assert weak[0].modes[0] == pp.ContactMode.SEPARATE
    assert not weak[0].twist.any()
    np.testing.assert_allclose(firm[0].twist, [-1.0, 0.0, 0.0], atol=1e-9)


def test_friction_can_bear_the_forces_at_rest():
    """Rest is a solution wherever the slider does not have to move, and friction bears its forces."""
    resting = 0
    for seed in range(60):
        scene = gripper(5000 + seed)
        scene.held = np.array([np.random.default_rng(seed).choice([-1.0, 0.0]), scene.held[1]])
        for one in scene.answer():
            if not one.twist.any():
                check(scene, one)
                assert scene.reserve(one.forces) > -1e-4
                resting += 1
    assert resting > 20


def test_its_mirror_image_has_the_mirrored_solutions():
    for seed in range(40):
        scene = gripper(3000 + seed)
        scene.shares = np.ones(4)
        mirrored = [(x, -y) for x, y in FEET]
        answer = scene.answer()
        support = pp.Points(mirrored)
        effects = [pp.SupportFriction(weight=4.0, support=support)]
        one = pp.Contact(
            (-1, -scene.height), law=pp.Coulomb(scene.frictions[0]),
            velocity=(scene.held[0], -scene.held[1]),
        )  # fmt: skip
        other = pp.Contact(
            (1, -scene.height), law=pp.Coulomb(scene.frictions[1]), velocity=(0, -scene.pressed),
            grip_force=scene.force,
        )  # fmt: skip
        image = pp.solve_contacts([one, other], effects=effects, outline=SQUARE)
        assert len(image) == len(answer)
        for twist in (solution.twist * [1, -1, -1] for solution in answer):
            assert min(np.abs(twist - other.twist).max() for other in image) < 1e-8


def test_arrays_of_forces_equal_single_calls():
    one = pp.Contact((-1, 0.2), law=pp.Coulomb(0.4), velocity=(1, 0.3))
    forces = np.array([0.2, 1.0, 5.0, 30.0])
    effects = [
        pp.SupportFriction(weight=2.0, support=pp.Polygon(SQUARE)), pp.Load(force=(0.1, -0.2)),
    ]  # fmt: skip

    def solve(force):
        other = pp.Contact((1, 0.2), law=pp.Coulomb(0.3), velocity=(0, 0.5), grip_force=force)
        return pp.solve_contacts([one, other], effects=effects, outline=SQUARE)

    many = solve(forces)
    assert many.shape == (4,)
    for k, force in enumerate(forces):
        assert many[k] == solve(float(force))


@pytest.mark.parametrize("force", [2.0, 5.0, 50.0])
def test_fingers_hold_a_load_that_friction_cannot(force):
    """At rest and in motion; with too weak a grip the object slips through the fingers."""
    effects = [pp.SupportFriction(support=pp.Polygon(SQUARE)), pp.Load(force=(0.0, -1.2))]
    for speed in (0.0, 0.3):
        one = pp.Contact((-1, 0.0), law=pp.Coulomb(0.4), velocity=(speed, 0))
        other = pp.Contact((1, 0.0), law=pp.Coulomb(0.4), grip_force=force)
        (only,) = pp.solve_contacts([one, other], effects=effects, outline=SQUARE)
        assert only.modes == (pp.ContactMode.STICK,) * 2
        np.testing.assert_allclose(only.forces.sum(axis=0), [speed > 0.0, 1.2], atol=1e-9)


def test_a_load_pulls_the_object_against_the_finger():
    """A load along the normal adds to the force of the finger that moves as given."""
    law = pp.Coulomb(0.0)
    support = pp.SupportFriction(weight=2.0, support=pp.Polygon(SQUARE))
    for load in (-0.5, 0.7):
        one = pp.Contact((-1, 0.0), law=law, velocity=(1, 0))
        other = pp.Contact((1, 0.0), law=law, grip_force=3.0)
        effects = [support, pp.Load(force=(load, 0.0))]
        (only,) = pp.solve_contacts([one, other], effects=effects, outline=SQUARE)
        assert only.forces[0, 0] == pytest.approx(2.0 + 3.0 - load)


@pytest.mark.parametrize("law", [pp.InfiniteFriction("none"), pp.PerfectlyRough()])
def test_a_finger_that_cannot_slip_leaves_an_object_at_rest(law):
    """It moves along its tangent; a slip, or a finger that pulls, would not be of its law."""
    effects = [pp.SupportFriction(support=pp.Polygon(SQUARE)), pp.Load(force=(0.95, 0.0))]
    one = pp.Contact((-1, 0.2), law=law, velocity=(0, 1))
    other = pp.Contact((1, 0.2), law=pp.Coulomb(0.3), grip_force=0.1)
    answer = pp.solve_contacts([one, other], effects=effects, outline=SQUARE)
    (rest,) = (solution for solution in answer if not solution.twist.any())
    assert rest.modes[0] == pp.ContactMode.SEPARATE
    assert not rest.forces[0].any()


def test_fingers_without_friction_stick_where_they_do_not_slip():
    law, support = pp.Coulomb(0.0), pp.SupportFriction(support=pp.Polygon(SQUARE))
    one = pp.Contact((-1, 0), law=law, velocity=(1, 0))
    other = pp.Contact((1, 0), law=law, grip_force=3.0)
    (only,) = pp.solve_contacts([one, other], effects=[support], outline=SQUARE)
    assert only.modes == (pp.ContactMode.STICK,) * 2


def grip(effects, point=(1, 0.2), force=1.0):
    one = pp.Contact((-1, 0.2), law=pp.Coulomb(0.4), velocity=(1, 0))
    other = pp.Contact(point, law=pp.Coulomb(0.3), grip_force=force)
    return pp.solve_contacts([one, other], effects=effects, outline=SQUARE)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"force": -1.0}, "grip_force: -1.0 given; allowed: a finite number > 0"),
        ({"force": np.array([1.0, np.nan])}, "grip_force: nan given; allowed: a finite number > 0"),
        ({"point": (1, 0.5)}, "grip_force: .*contacts at .* opposite normals"),
    ],
)
def test_grips_that_are_refused(change, message):
    with pytest.raises(pp.InvalidValue, match=message):
        grip([pp.SupportFriction(support=pp.Polygon(SQUARE))], **change)


@pytest.mark.parametrize(
    ("effects", "message"),
    [
        (
            [
                pp.SupportFriction(support=pp.Polygon(SQUARE)),
                pp.Inertia(mass=1.0, gyration_radius=0.8),
            ],
            "grip_force: Inertia.* friction and loads",
        ),
        (
            [pp.SupportFriction(support=pp.Points([(-1, 0), (1, 0)]))],
            "grip_force: 'a support on one",
        ),
    ],
)
def test_effects_that_a_grip_does_not_take(effects, message):
    with pytest.raises(pp.InvalidValue, match=message):
        grip(effects)


def test_a_grip_in_a_file(tmp_path):
    """A file keeps the force, and a motion over time refuses it."""
    effects = [pp.SupportFriction(support=pp.Polygon(SQUARE))]
    contacts = [
        pp.Contact((-1, 0.2), law=pp.Coulomb(0.4), velocity=(1, 0)),
        pp.Contact((1, 0.2), law=pp.Coulomb(0.3), grip_force=2.5),
    ]
    path = tmp_path / "grip.yaml"
    pp.save_contacts(contacts, path, effects=effects, outline=SQUARE)
    again = pp.load_contacts(path)
    assert again["contacts"][1].grip_force == 2.5
    assert pp.solve_contacts(**again) == grip(effects, force=2.5)
    still = [pp.Contact((-1, 0.2), law=pp.Coulomb(0.4)), contacts[1]]
    pushers = [pp.Pusher(velocity=(1, 0))] * 2
    with pytest.raises(pp.InvalidValue, match=r"grip_force: 2.5 given; allowed: none over time"):
        pp.simulate_contacts(
            still, pushers, effects=effects, outline=SQUARE, duration=1.0, step=0.1,
            object_pose=(0, 0, 0),
        )  # fmt: skip
