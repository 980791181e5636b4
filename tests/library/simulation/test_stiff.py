"""Slow pushes with friction and inertia are stiff: against Radau's method in scipy; what they cost."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from simulation.runs import check, final

import planar_pushing as pp

WIDTH, HEIGHT, MASS, SLIDES, GRAVITY = 0.3, 0.2, 1.2, 0.3, 9.80665
GYRATION = np.hypot(WIDTH, HEIGHT) / np.sqrt(12)
FEET = np.array([(-0.12, -0.08), (0.13, -0.07), (0.1, 0.09), (-0.11, 0.06)])
BOX = pp.Polygon.rectangle(WIDTH, HEIGHT)
SUPPORTS = {
    "base": BOX, "feet": pp.Points(FEET), "ring": pp.Ring(0.08), "disc": pp.Disc(0.03)
}  # fmt: skip
WAY = 0.08


def push(support, place, angle, speed, friction, **options):
    """The log of a finger that moves by `WAY` with a constant velocity."""
    effects = (
        pp.SupportFriction(support=support, weight=pp.weight(MASS, SLIDES, gravity=GRAVITY)),
        pp.Inertia(mass=MASS, gyration_radius=GYRATION),
    )
    scene = pp.scene_at(
        (place, -HEIGHT / 2), contact=pp.Coulomb(friction), outline=BOX, effects=effects
    )
    pusher = pp.Pusher(velocity=speed * heading(angle), shape="finger")
    return pp.simulate(
        scene, pusher, duration=WAY / speed, samples=2, object_pose=(0.0, 0.0, 0.0), **options
    )


def heading(angle):
    return np.array([np.cos(np.deg2rad(angle)), np.sin(np.deg2rad(angle))])


def pose_by_radau(place, angle, speed, friction, slips):
    """Pose of the box on feet at the end, as its constraint and the friction cone's edge determine it.

    The coordinates are the place of the finger on the bottom side and the angle of the box. The finger
    sticks for `slips` 0, or the box slips so that the force is on the right or left edge.
    """
    velocity, edge = speed * heading(angle), np.array([-slips * friction, 1.0])
    moment, share = MASS * GYRATION**2, SLIDES * MASS * GRAVITY / len(FEET)

    def rates(time, state):
        along, turned, slip, spin = state
        turn = np.array([[np.cos(turned), -np.sin(turned)], [np.sin(turned), np.cos(turned)]])
        arm = np.array([along, -HEIGHT / 2])
        # Velocity of the box's center and the friction of its feet, in the frame of the box.
        center = turn.T @ velocity - [slip, 0.0] - spin * np.array([-arm[1], arm[0]])
        moves = center + spin * np.column_stack((-FEET[:, 1], FEET[:, 0]))
        drags = -share * moves / np.hypot(*moves.T)[:, None]
        drag, torque = drags.sum(0), np.sum(FEET[:, 0] * drags[:, 1] - FEET[:, 1] * drags[:, 0])
        # The center accelerates by -(slip', 0) - spin' x arm - 2 spin x (slip, 0) + spin^2 arm.
        known = spin**2 * arm - 2 * spin * slip * np.array([0.0, 1.0])
        matrix, right = np.zeros((3, 3)), np.zeros(3)
        if slips:
            matrix[:2] = np.column_stack(([-MASS, 0.0], MASS * np.array([arm[1], -arm[0]]), -edge))
            matrix[2] = 0.0, moment, -(arm[0] * edge[1] - arm[1] * edge[0])
            right[:] = *(drag - MASS * known), torque
            slip_rate, spin_rate, _ = np.linalg.solve(matrix, right)
        else:
            force = MASS * known - drag
            total = moment + MASS * arm @ arm
            spin_rate, slip_rate = (torque + arm[0] * force[1] - arm[1] * force[0]) / total, 0.0
        return [slip, spin, slip_rate, spin_rate]

    arm = np.array([place, -HEIGHT / 2])
    start = [place, 0.0, 0.0, 0.0]
    if slips:
        # An impact with a force on the edge gives the box its first velocity.
        lever = arm[0] * edge[1] - arm[1] * edge[0]
        push_up = edge[1] / MASS + arm[0] * lever / (MASS * GYRATION**2)
        impulse = velocity[1] / push_up
        spin = impulse * lever / (MASS * GYRATION**2)
        start = [place, 0.0, velocity[0] - impulse * edge[0] / MASS + spin * arm[1], spin]
    else:
        # A velocity of the center at right angles to the arm's rotation: angular momentum about the finger.
        spin = (arm[0] * velocity[1] - arm[1] * velocity[0]) / (GYRATION**2 + arm @ arm)
        start[3] = spin
    scale = speed * 1e-3
    state = solve_ivp(
        rates, (0.0, WAY / speed), start, method="Radau", rtol=1e-9,
        atol=np.array([1.0, 1.0, scale, scale]) * 1e-9,
    ).y[:, -1]  # fmt: skip
    turn = np.array([
        [np.cos(state[1]), -np.sin(state[1])], [np.sin(state[1]), np.cos(state[1])]
    ])  # fmt: skip
    return [*(arm + WAY * heading(angle) - turn @ [state[0], arm[1]]), np.rad2deg(state[1])]


@pytest.mark.parametrize("speed", [0.3, 0.03, 0.003, 0.0003])
@pytest.mark.parametrize(
    ("place", "angle", "friction", "slips"),
    [(0.04, 80.0, 1.5, 0), (-0.02, 110.0, 2.0, 0), (0.03, 45.0, 0.2, -1), (0.02, 130.0, 0.1, 1)],
)
def test_a_push_of_a_box_on_feet(place, angle, friction, slips, speed):
    log = check(push(SUPPORTS["feet"], place, angle, speed, friction))
    modes = {pp.ContactMode(int(mode)).name for mode in log["mode"].values}
    assert modes == {{0: "STICK", 1: "SLIP_RIGHT", -1: "SLIP_LEFT"}[slips]}
    wanted = pose_by_radau(place, angle, speed, friction, slips)
    assert [*final(log, "object_position"), final(log, "object_angle")] == pytest.approx(
        wanted, abs=1e-7
    )


@pytest.mark.parametrize("rtol", [1e-4, 1e-6, 1e-8, 1e-10, 1e-12])
@pytest.mark.parametrize("support", SUPPORTS)
def test_slow_pushes_cost_little_more_than_fast_ones(support, rtol):
    """An explicit method needs a million evaluations at the lowest speed."""
    for place, angle in ((0.04, 90.0), (0.062, 120.0)):
        costs = [
            int(push(SUPPORTS[support], place, angle, speed, 0.5, rtol=rtol).evaluations.max())
            for speed in (0.1, 0.01, 0.001, 0.0001)[: 3 if rtol > 1e-6 else 4]
        ]
        assert max(costs[1:]) <= 6 * costs[0] + 1000


@pytest.mark.parametrize("speed", [0.1, 1e-3, 1e-4])
@pytest.mark.parametrize("support", SUPPORTS)
def test_a_slow_box_stops(support, speed):
    """Behind a finger that pushes through the center and stops, as far as ``v^2 / (2 mu_s g)``."""
    effects = (
        pp.SupportFriction(support=SUPPORTS[support], weight=pp.weight(MASS, SLIDES)),
        pp.Inertia(mass=MASS, gyration_radius=GYRATION),
    )
    center = FEET.mean(0)[0] if support == "feet" else 0.0
    if support == "feet":
        effects = (
            pp.SupportFriction(
                support=pp.Points(FEET - FEET.mean(0)), weight=pp.weight(MASS, SLIDES)
            ),
            effects[1],
        )
        center = 0.0
    scene = pp.scene_at(
        (center, -HEIGHT / 2), contact=pp.Coulomb(0.5), outline=BOX, effects=effects
    )
    stop = WAY / speed
    pusher = pp.Pusher(velocity=[(0.0, (0.0, speed)), (stop, (0.0, 0.0))], shape="finger")
    coasts = speed**2 / (2 * SLIDES * GRAVITY)
    log = pp.simulate(
        scene, pusher, duration=2 * stop, samples=2, object_pose=(0.0, 0.0, 0.0), rtol=1e-12
    )
    assert final(log, "object_position") == pytest.approx([0.0, WAY + coasts], abs=1e-9 * WAY)
    assert final(log, "kinetic_energy") == 0.0
