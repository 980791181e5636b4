"""Certified motion over time against the equation of motion in mpmath, and its refusals."""

from functools import partial
from itertools import pairwise
from pathlib import Path

import mpmath as mp
import pytest
from flint import arb, ctx, fmpq

from planar_pushing.certified.balls import PRECISION, Undecided, in_degrees
from planar_pushing.certified.contact.modes import Mode
from planar_pushing.certified.motion import trajectories
from planar_pushing.certified.motion.quadrature import stick_angle
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.store import read_dataset

GOLDEN = Path("tests/golden")


def scene(name):
    return load_scene_file(f"workflow/scenes/{name}.yaml").model_dump()


def ring(k):
    """Force and torque of the ring at k > 0, Eqs. (2)-(3), by mpmath's elliptic integrals."""
    if k > 1:
        return ring(1 / k)[::-1]
    first, second = mp.ellipk(k * k), mp.ellipe(k * k)
    return 2 / mp.pi * second, 2 / mp.pi * (second - (1 - k * k) * first) / k


def sticking_rate(length, heading, psi):
    """Rotation of a slider whose contact moves with unit speed at an angle: no torque at the contact."""
    along, aside = mp.cos(psi - heading), mp.sin(psi - heading)

    def torque(omega):
        across = aside - length * omega
        speed = mp.hypot(along, across)
        force, moment = ring(omega / speed)
        return moment - length * force * across / speed

    return mp.findroot(torque, (0.3 * aside / length, 0.6 * aside / length))


def exact(ball):
    """Midpoint of a ball as a number of mpmath."""
    return mp.mpf(ball.mid().str(40, radius=False))


@pytest.mark.parametrize(("number", "heading", "start"), [(0, 10, 0), (1, -10, fmpq(1, 2))])
def test_the_time_of_a_sticking_motion_is_the_integral_over_the_rod_angle(number, heading, start):
    times = [fmpq(0), fmpq(3, 8)] if number == 0 else [start, fmpq(5, 4)]
    first, last = trajectories.pulled(scene("figure_14a"), times)
    with mp.workdps(25):
        rate = partial(sticking_rate, 2, mp.radians(heading))
        found = mp.quad(lambda psi: 1 / rate(psi), [exact(first.angle), exact(last.angle)])
        expected = mp.mpf(int((times[1] - times[0]).p)) / int((times[1] - times[0]).q)
        assert abs(found - expected) < 1e-18


def test_slip_agrees_with_the_published_reference():
    last = trajectories.slipping(scene("figure_15"), [fmpq(3)])[0]
    assert float(in_degrees(last.angle)) == pytest.approx(33.49164319965058, abs=1e-9)
    assert float(last.slip) == pytest.approx(2.1514157444528927, abs=1e-9)


def test_slip_is_the_integral_of_its_rate():
    with mp.workdps(25):
        s0, rise, run = mp.sqrt(0.5), mp.sin(mp.radians(165)), mp.cos(mp.radians(165))

        def rate(time):
            sine = s0 - rise * time / 5
            k = mp.findroot(lambda k: ring(k)[1] - 5 * sine * ring(k)[0], (1.5, 2.0))
            # The contact's velocity along the fence, less the fence's.
            return rise * (-1 / k - 5 * sine) / (5 * mp.sqrt(1 - sine**2)) - run

        (half,) = trajectories.slipping(scene("figure_15"), [fmpq(3, 2)])
        assert abs(exact(half.slip) - mp.quad(rate, [0, 1.5])) < 1e-18


def test_the_sticking_angle_rises_with_the_spin_ratio():
    with ctx.workprec(PRECISION):
        angles = [stick_angle(fmpq(2), arb(i) / 16) for i in range(1, 16)]
        assert all(b > a for a, b in pairwise(angles))


def test_the_first_instant_is_that_of_the_scene():
    stored = read_dataset(GOLDEN / "simulations/figure_14a.nc")
    assert stored.rod_angle.values[0] == 30.0
    (first,) = trajectories.pulled(scene("figure_14a"), [fmpq(0)])
    assert in_degrees(first.angle).contains(30)


def changed(file, part, **values):
    return file | {part: file[part] | values}


def test_a_force_that_leaves_the_cone_is_not_certified():
    pushed = scene("figure_14a")
    pushed = changed(pushed, "simulate", pusher=[{"time": 0.0, "angle": 90.0, "speed": 1.0}])
    leaning = changed(pushed, "slider", rod_angle=120.0)
    slippery = changed(leaning, "contact", friction_coefficient=0.5)
    assert trajectories.pulled(slippery, [fmpq(0)])[0].mode == Mode.STICK
    with pytest.raises(Undecided, match="the condition of the mode is undecided"):
        trajectories.pulled(slippery, [fmpq(1, 4)])


@pytest.mark.parametrize(
    ("build", "name", "change"),
    [
        (trajectories.pulled, "figure_14a", {"slider": {"radius": 2.0}}),
        (trajectories.slipping, "figure_15", {"simulate": {"pusher_speed": 2.0}}),
        (trajectories.slipping, "figure_15", {"contact": {"at_zero_normal": "none"}}),
    ],
)
def test_what_is_not_certified_is_refused(build, name, change):
    ((part, values),) = change.items()
    with pytest.raises(Undecided, match="certified"):
        build(changed(scene(name), part, **values), [fmpq(0)])
