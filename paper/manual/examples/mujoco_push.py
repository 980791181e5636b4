"""A finger pushes a box, in MuJoCo and with `simulate`."""

import mujoco
import numpy as np

import planar_pushing as pp

BOX = pp.Polygon.rectangle(0.3, 0.2)
FEET = pp.Points([(0.12, 0.0), (-0.1, 0.08), (-0.1, -0.08)], [0.4, 0.3, 0.3])
#: Velocity of the finger in m/s, time in which it reaches this velocity, and end of the push, in s.
VELOCITY, START, END = np.array([0.002, 0.01]), 0.4, 4.0


def box(support):
    """A box of 1.2 kg, friction 0.3 with the table, 0.5 with the finger at a long side; SI units."""
    friction = pp.SupportFriction(support=support, weight=pp.weight(1.2, 0.3))
    inertia = pp.Inertia(mass=1.2, gyration_radius=0.104)
    return pp.scene_at(
        (-0.05, -0.1), effects=(friction, inertia), contact=pp.Coulomb(0.5), outline=BOX
    )


def in_mujoco(scene):
    """Displacement of the slider's center, and its rotation."""
    model = mujoco.MjModel.from_xml_string(pp.to_mjcf(scene, pusher="finger"))
    data = mujoco.MjData(model)
    while data.time < END:
        data.ctrl[:] = VELOCITY * min(1.0, data.time / START)
        mujoco.mj_step(model, data)
    return data.qpos[:3]


def by_simulate(scene):
    """The same in `simulate`: at full speed the finger covers the start-up distance in half the time."""
    finger = pp.Pusher(velocity=tuple(VELOCITY), shape="finger")
    log = pp.simulate(scene, pusher=finger, duration=END - START / 2, samples=2)
    first, last = log.isel(time=0), log.isel(time=-1)
    x, y = (last.position - first.position).values
    return x, y, np.deg2rad((last.rod_angle - first.rod_angle).item())


if __name__ == "__main__":
    for name, support in (("three feet", FEET), ("even base", BOX)):
        for run in (in_mujoco, by_simulate):
            x, y, turn = run(box(support))
            print(f"{name:10} {run.__name__:11} {x:.5f} m {y:.5f} m {turn:.5f} rad")
