"""The pull of Fig. 3 in MuJoCo: the fence retreats, and the slider follows or stays at rest."""

import mujoco
import numpy as np

import planar_pushing as pp

LENGTH, SPEED, ANGLES = 3.0, 0.03, (-5, -10, -15, -20, -25)
#: Times at which the fence direction leaves 45 degrees, reaches its final angle, and of the end.
BEGIN, TURNED, END = 0.1 / SPEED, 0.3 / SPEED, 0.8 / SPEED


def slider(rod_angle):
    """The ring with its rod; the tip of the rod is the contact."""
    turn = np.deg2rad(np.arange(-160, 161, 20))
    ring = np.column_stack([np.cos(turn), np.sin(turn)])
    return pp.Slider(rod_length=LENGTH, rod_angle=rod_angle, outline=[(-LENGTH, 0.0), *ring])


def scene(rod_angle, *effects):
    """The slider at a rod angle under effects, with a coefficient of friction of 2 at the fence."""
    return pp.Scene(slider=slider(rod_angle), contact=pp.Coulomb(2.0), effects=effects)


def fence(time, first, last):
    """Velocity of the fence: its speed increases for four units of time, then its angle changes."""
    angle = np.deg2rad(np.interp(time, [BEGIN, TURNED], [first, last]))
    return SPEED * min(1.0, time / 4.0) * np.array([np.cos(angle), np.sin(angle)])


def run(first, last, **options):
    """Displacement of the slider and its final twist in MuJoCo."""
    text = pp.to_mjcf(scene(np.pi / 4, pp.RingFriction(), pp.Inertia()), **options)
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    while data.time < END:
        data.ctrl[:] = fence(data.time, first, last)
        mujoco.mj_step(model, data)
    return data.qpos[:3], data.qvel[:3] / SPEED


def consistent(rod_angle, angle):
    """Twists of all consistent modes by name, for unit speed of the fence."""
    solutions = pp.solve(scene(rod_angle, pp.RingFriction()), np.deg2rad(angle))
    return {solution.mode.name.lower(): solution.twist for solution in solutions}


def shown(twist):
    """A twist as three numbers."""
    return " ".join(f"{component:7.4f}" for component in np.round(twist, 4) + 0.0)


if __name__ == "__main__":
    for angle in ANGLES:
        for start, first in (("at rest", angle), ("pushed", 45.0)):
            moved, twist = run(first, angle)
            answer = "is pulled" if np.linalg.norm(twist) > 0.01 else "stays"
            print(f"{angle:4} {start:8} {answer:10} {shown(twist)}")
            for mode, expected in consistent(np.pi / 4 + moved[2], angle).items():
                print(f"{'':14}{mode:10} {shown(expected)}")
