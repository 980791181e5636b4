"""Push a box to a goal pose: plan with the exact model and with the ellipsoid, execute exactly.

A plan is three pushes with a finger in the middle of a side: a search over sides, force angles and lengths.
"""

import numpy as np
from scipy import interpolate, optimize

import planar_pushing as pp

HALF, FINGER = (2.0, 0.5), pp.Coulomb(0.5)  # half lengths of the box; contact law of the finger
GOAL, CLOSE = np.array([2.0, 2.0, np.pi / 2]), 0.01  # x, y and heading, from zero
FORCES = np.pi / 2 + 0.9 * np.arctan(0.5) * np.linspace(-1, 1, 81)  # with a margin against slip
COSTS, START = np.tile([0.0, 1.0], 3), np.tile([np.pi / 2, 1.0], 3)
BOUNDS = [(FORCES[0], FORCES[-1]), (1e-9, 10.0)] * 3  # force angle and length of each push


def box(side):
    """The box, pushed at side 0 to 3; the inner normal of side n is at 90 n degrees."""
    a, b = HALF[side % 2], HALF[1 - side % 2]
    friction = pp.SupportFriction(support=pp.Polygon([(-a, -b), (a, -b), (a, b), (-a, b)]))
    slider = pp.Slider(rod_length=a, rod_angle=np.pi / 2, side=(-b, b))
    return pp.Scene(slider=slider, contact=FINGER, effects=(friction,))


def exact(scene):
    """Twists (v_x, v_y, omega) under the forces, for unit speed of the finger."""
    solutions = pp.solve(scene, pp.motion_angle(scene, FORCES))
    return solutions.twist[solutions.mode == pp.ContactMode.STICK]


def ellipsoid(scene):
    """The same for the ellipsoid: the motion is along M w for the wrench w at the center."""
    arm, fit = scene.slider.rod_length, pp.fit_ellipsoid(scene.effects[0].support)
    twists = np.stack([np.cos(FORCES), np.sin(FORCES), arm * np.cos(FORCES)], axis=1) @ fit.matrix
    return twists / np.hypot(twists[:, 0] + arm * twists[:, 2], twists[:, 1])[:, None]


def predicted(side, twist, length):
    """Displacement in the frame of the side, and rotation, for a constant body twist."""
    x, y, turn = length * twist
    return (x + 1j * y) * np.exp(0.5j * turn) * np.sinc(turn / (2 * np.pi)), turn


def executed(side, twist, length):
    """The same in simulation: the finger follows the arc that a model predicts."""
    a, w = np.arctan2(twist[1], twist[0] + twist[2] * HALF[side % 2]), twist[2]
    arc = pp.Pusher(velocity=lambda t: (np.cos(a + w * t), np.sin(a + w * t)), shape="finger")
    log = pp.simulate(box(side), pusher=arc, duration=length, samples=2)
    x, y, turn = *log.position.values[-1], log.rod_angle.values[-1] - 90
    return x + 1j * (y - HALF[side % 2]), np.deg2rad(turn)


def after(plan, pose, sides, twists, push=predicted):
    """Pose after pushes with these force angles and lengths."""
    for side, (force, length) in zip(sides, np.reshape(plan, (3, 2)), strict=True):
        step, turn = push(side, twists[side % 2](force), length)
        step = step * np.exp(1j * (pose[2] + (side - 1) * np.pi / 2))
        pose = pose + np.array([step.real, step.imag, turn])
    return pose


def reach(model):
    """Length and error of each plan; the next plan starts from the pose that was reached."""
    twists, pose = [interpolate.CubicSpline(FORCES, model(box(i))) for i in (0, 1)], np.zeros(3)
    while np.any(np.abs(pose - GOAL) > CLOSE):
        plans = []
        for sides in np.ndindex(4, 4, 4):
            goal = {"type": "eq", "fun": lambda *a: after(*a) - GOAL, "args": (pose, sides, twists)}
            plan = optimize.minimize(COSTS.dot, START, bounds=BOUNDS, constraints=goal)
            plans += [(plan.fun, sides, plan.x)] if plan.success else []
        pose = after(min(plans)[2], pose, min(plans)[1], twists, executed)
        yield min(plans)[0], np.hypot(*(pose - GOAL)[:2]), np.rad2deg(abs(pose - GOAL)[2])


if __name__ == "__main__":
    for model in (exact, ellipsoid):
        for length, off, turn in reach(model):
            print(f"{model.__name__:9}  length {length:.3f}  off by {off:.4f}, {turn:.3f} degrees")
