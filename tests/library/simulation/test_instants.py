"""Every instant of a motion with inertia is a push from rest, whose modes `solve` lists.

Friction at points that move is known, and so is a load. A point at the center of rotation stays a point of
support. Accelerations take the place of velocities, relative to the rotation of the slider.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pytest

import planar_pushing as pp

pytestmark = pytest.mark.filterwarnings("ignore::planar_pushing.EarlyEndWarning")

#: Share of a second point, which a support needs.
SLIGHT = 1e-13
#: Acceleration of a fence that already slips along the contact.
FAST = 3e3


def spun(vector, omega):
    return omega * np.array([-vector[1], vector[0]])


@dataclass(frozen=True)
class Body:
    """A slider on feet at its center's origin, in the fence frame."""

    slider: pp.Slider
    contact: pp.ContactLaw
    places: np.ndarray
    limits: np.ndarray
    mass: float
    gyration: float
    center: np.ndarray
    load: np.ndarray

    @property
    def scene(self):
        return pp.Scene(
            slider=self.slider,
            contact=self.contact,
            effects=(
                pp.SupportFriction(
                    support=pp.Points(self.places, self.limits / self.limits.sum()),
                    weight=self.limits.sum(),
                ),
                self.inertia,
                pp.Load(force=self.load),
            ),
        )

    @property
    def inertia(self):
        return pp.Inertia(mass=self.mass, gyration_radius=self.gyration, center=self.center)


def draw_body(random):
    count = int(random.integers(2, 5))
    laws = [pp.Coulomb(0.3), pp.Coulomb(0.8), pp.Coulomb(1.5), pp.InfiniteFriction()]
    return Body(
        slider=pp.Slider(
            rod_length=random.uniform(0.3, 1.8), rod_angle=random.uniform(0.3, math.pi - 0.3)
        ),
        contact=laws[random.integers(4)],
        places=random.normal(size=(count, 2)),
        limits=random.uniform(0.1, 1.0, count),
        mass=random.uniform(0.2, 1.5),
        gyration=random.uniform(0.2, 1.0),
        center=0.6 * random.normal(size=2),
        load=0.5 * random.normal(size=2),
    )


def list_modes(body, psi, twist, foot, acceleration, slip):
    """Modes and forces of the push from rest at an instant, with a foot at rest or without one (-1)."""
    x, y = math.cos(psi), math.sin(psi)
    turned = np.array([[x, -y], [y, x]])
    velocity, omega = np.array(twist[:2]), twist[2]
    contact, center = -float(body.slider.rod_length) * np.array([x, y]), turned @ body.center
    places = [turned @ place for place in body.places]
    # The body's own acceleration is that of the rotation about the foot, or of the center of mass.
    pole = places[foot] if foot >= 0 else center
    force, torque = body.load + body.mass * omega**2 * (center - pole), 0.0
    for number, (place, limit) in enumerate(zip(places, body.limits, strict=True)):
        if number != foot:
            motion = velocity + spun(place, omega)
            friction = -limit * motion / np.hypot(*motion)
            force = force + friction
            torque += np.dot(spun(place - center, 1.0), friction)
    effects = [body.inertia]
    if foot >= 0:
        other = body.places[(foot + 1) % len(body.places)]
        support = pp.Points([body.places[foot], other], [1.0, SLIGHT])
        effects.append(pp.SupportFriction(support=support, weight=body.limits[foot]))
    lever = torque / (force @ force) * np.array([force[1], -force[0]])
    effects.append(pp.Load(force=force, center=turned.T @ (center + lever)))
    push = acceleration + omega**2 * (contact - pole)
    if slip:
        push = np.array([-math.copysign(FAST, slip), push[1]])
    slider = pp.Slider(rod_length=body.slider.rod_length, rod_angle=psi)
    scene = pp.Scene(slider=slider, contact=body.contact, effects=tuple(effects))
    solutions = pp.solve(scene, math.atan2(push[1], push[0]), np.hypot(*push))
    kept = {pp.ContactMode.SEPARATE, *pp.ContactMode}
    if slip:
        right, left = pp.ContactMode.SLIP_RIGHT, pp.ContactMode.SLIP_LEFT
        kept = {pp.ContactMode.SEPARATE, right if slip > 0.0 else left}
    return [(each.mode, np.array(each.force)) for each in solutions if each.mode in kept]


def check_row(log, row, listed, closeness):
    """The number of modes, and the force of the one that was chosen."""
    mode = pp.ContactMode(int(log.mode[row]))
    assert int(log.solutions[row]) == len(listed)
    errors = [
        np.abs(log.force.values[row] - force).max() for other, force in listed if other == mode
    ]
    assert min(errors) < closeness * max(1.0, np.abs(log.force.values[row]).max())


@pytest.mark.parametrize("count", [150, pytest.param(300, marks=pytest.mark.slow)])
@pytest.mark.parametrize("slip", [0.0, 0.4, -0.4])
def test_a_foot_at_the_center_of_rotation_holds_or_leaves(slip, count):
    random = np.random.default_rng(12)
    several = jams = 0
    for _ in range(count):
        body = draw_body(random)
        psi, omega = float(body.slider.rod_angle), 0.6 * random.normal()
        acceleration = 1.5 * random.normal(size=2)
        x, y = math.cos(psi), math.sin(psi)
        foot = np.array([[x, -y], [y, x]]) @ body.places[0]
        contact = -float(body.slider.rod_length) * np.array([x, y])
        twist = (*spun(-foot, omega), omega)
        fence = spun(contact - foot, omega) - [slip, 0.0]
        listed = list_modes(body, psi, twist, 0, acceleration, slip)
        log = pp.simulate(
            body.scene,
            pusher=pp.Pusher(velocity=lambda t, w=fence, b=acceleration: tuple(w + b * t)),
            duration=0.01,
            samples=2,
            twist=twist,
            on_ambiguity="separate",  # a rubbing contact does not catch
        )
        if listed:
            check_row(log, 0, listed, 1e-6 if slip else 1e-9)
        else:
            assert log.attrs["stopped"] == "no contact mode is consistent"
        several += len(listed) > 1
        jams += not listed
    assert several > count / 150
    assert (jams > count / 30) == (slip != 0.0)


def test_rows_of_a_log_count_the_modes_of_their_instants():
    random, checked = np.random.default_rng(3), 0
    for _ in range(60):
        body = draw_body(random)
        velocity = np.array([random.uniform(-0.5, 0.5), random.uniform(0.2, 1.0)])
        log = pp.simulate(body.scene, pusher=pp.Pusher(velocity=velocity), duration=2.0, samples=9)
        between = np.isin(log.time.values, np.linspace(0.0, 2.0, 9)) & (log.event.values < 0)
        for row in np.flatnonzero(between)[1:]:
            psi, twist = math.radians(float(log.rod_angle[row])), log.twist.values[row]
            if (
                log.gap.values[row] > 0.0
                or np.abs(twist).max() < 1e-6
                or log.pivot.values[row] >= 0
            ):
                continue
            arm = -float(body.slider.rod_length) * np.array([math.cos(psi), math.sin(psi)])
            slip = (twist[:2] + spun(arm, twist[2]) - velocity)[0]
            slip = slip if abs(slip) > 1e-9 else 0.0
            listed = list_modes(body, psi, twist, -1, np.zeros(2), slip)
            check_row(log, row, listed, 1e-5 if slip else 1e-8)
            checked += 1
    assert checked > 100
