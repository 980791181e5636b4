"""From five measured pushes to a scene and a plan, for a box on three feet with unknown loads.

A camera measures the poses of box and finger before and after each push, and a sensor the mean force.
`python own_pushes.py box.yaml` also writes the scene to this file.
"""

import sys
from pathlib import Path

import numpy as np
import pandas as pd

import planar_pushing as pp

MEASURED = Path(__file__).with_name("own_pushes.csv")  # mm, degrees, N
BOX, FEET = pp.Polygon.rectangle(120, 80), [(-50, -30), (50, -30), (0, 30)]
FINGER, NOISE = 5.0, (0.3, 0.2, 0.03)  # radius; standard deviations in mm, degrees, N
GOAL = np.array(
    [-10.0, 60.0, 20.0]
)  # displacement of the box in its frame, and rotation in degrees
# The measurements are simulated with this box. The plans do not use it.
TRUE = (pp.SupportFriction(support=pp.Points(FEET, [1, 2, 3]), weight=4.0),)


def measured():
    """The pushes in the table, as a dataset."""
    table = pd.read_csv(MEASURED, comment="#")
    before, after, start, end, force = (
        table.filter(regex=f"_{name}$").to_numpy()
        for name in ("before", "after", "start", "end", "force")
    )
    scale = [1.0, 1.0, np.pi / 180]
    return pp.pushes_from_poses(
        outline=BOX, poses_before=before * scale, poses_after=after * scale, finger_start=start,
        finger_end=end, finger_radius=FINGER, force=force, units=("mm", "N"), noise=NOISE,
    )  # fmt: skip


def twist_to(x, y, degrees):
    """The constant twist that moves and rotates the box by these amounts in one second."""
    half = np.deg2rad(degrees) / 2
    factor = half / np.tan(half)
    return np.array([factor * x + half * y, factor * y - half * x, 2 * half])


def scene_of(push, friction, law):
    """The scene of a push on the box."""
    units = pp.Units(length="mm")
    return pp.scene_at(push.point, effects=friction, contact=law, outline=BOX, units=units)


def executed(push, law):
    """Pose of the box after the finger has followed the planned arc."""
    start, turn = complex(*push.velocity), np.deg2rad(GOAL[2])

    def velocity(t):
        turned = start * np.exp(1j * turn * t)
        return turned.real, turned.imag

    finger = pp.Pusher(velocity=velocity, shape="finger", frame="world")
    scene = scene_of(push, TRUE, law)
    log = pp.simulate(scene, pusher=finger, duration=1.0, samples=2, object_pose=(0, 0, 0))
    return np.append(log.object_position[-1], log.object_angle[-1])


def print_support(estimate):
    """Print the estimates with their 90 percent intervals."""
    numbers = {name: estimate.intervals[name] for name in ("weight", "contact_friction")}
    for name, (low, high) in numbers.items():
        print(f"{name:16}  {getattr(estimate, name):5.3f}  {low:5.3f} to {high:5.3f}")
    feet = zip(FEET, estimate.support.weights, estimate.weight_intervals, strict=True)
    for (x, y), load, (low, high) in feet:
        print(f"load at {x:3}, {y:3}  {load:5.3f}  {low:5.3f} to {high:5.3f}")


if __name__ == "__main__":
    estimate = pp.identify(measured(), known=FEET)
    print_support(estimate)
    law = pp.Coulomb(estimate.contact_friction)
    for name, support in {"three feet": estimate.support, "even base": BOX}.items():
        friction = (pp.SupportFriction(support=support, weight=estimate.weight),)
        push, *_ = pp.pushes_for(friction, twist_to(*GOAL), BOX)  # smallest friction first
        x, y, turn = executed(push, law) - GOAL
        told = f"push at {push.point[0]:4.1f}, needs friction {push.friction_coefficient:5.3f}"
        print(f"{name:10}  {told}, misses by {np.hypot(x, y):4.1f} mm, {abs(turn):4.1f} degrees")
        if support is estimate.support and len(sys.argv) > 1:
            pp.save_scene(scene_of(push, friction, law), sys.argv[1])
