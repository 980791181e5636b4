"""Lines of twists in the plain source of the core: power, its ranges, how far the modes hold, and spans."""

from __future__ import annotations

import numpy as np
import pytest
from core.test_psi import effects_of

import planar_pushing as pp
from planar_pushing.core.contacts import several_lines as lines
from planar_pushing.core.contacts import twist_line as twists
from planar_pushing.core.contacts.several_frames import (
    CONTACT_FRAME,
    CONTACT_ROW,
    ContactFrame,
    MotionSet,
    SeveralRow,
    several_at,
    write_frame,
)
from planar_pushing.core.contacts.several_solutions import Sharing
from planar_pushing.core.contacts.unit_forces import UNIT_FORCE, UnitForce
from planar_pushing.core.instant.solution import SEPARATE, SLIP_LEFT, SLIP_RIGHT
from planar_pushing.core.supports.rows import Vector

SLIDER = pp.Slider(rod_length=1.4, rod_angle=np.pi / 2, radius=1.0)
FEET = pp.SupportFriction(
    support=pp.Points([(0.5, 0.2), (-0.4, 0.6), (0.1, -0.7)], [2.0, 1.0, 1.0])
)
SUPPORTS = {
    "ring": pp.RingFriction(),
    "square": pp.SupportFriction(support=pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)])),
    "feet": FEET,
}
OTHERS = {
    "alone": (),
    "inertia": (pp.Inertia(mass=0.7, gyration_radius=0.6, center=(0.1, -0.2)),),
    "load": (pp.Load(force=(0.1, 0.2), center=(0.3, 0.1)),),
    "inertia and load": (
        pp.Inertia(mass=0.7, gyration_radius=0.6, center=(0.1, -0.2)),
        pp.Load(force=(0.1, 0.2), center=(0.3, 0.1)),
    ),
}


def random_line(effects, rng):
    """A line of twists, with its start, its step and its probe, of which the latter are unit vectors."""
    start, step, probe = rng.normal(size=(3, 3))
    line = twists.line_through(
        effects_of(*effects), *(Vector(*row) for row in (start, step, probe))
    )
    step, probe = step / np.linalg.norm(step), probe / np.linalg.norm(probe)
    return line, start, step, probe


def power_along(effects, twist, probe):
    """What sustains a twist, times a probe; the scene's loads pull the slider themselves."""
    return sum(float(np.dot(pp.wrench(each, twist, SLIDER), probe)) for each in effects)


@pytest.mark.parametrize("others", OTHERS)
@pytest.mark.parametrize("support", SUPPORTS)
def test_power_is_that_of_the_wrench_and_its_slope_that_of_differences(support, others):
    rng, effects = np.random.default_rng(1), (SUPPORTS[support], *OTHERS[others])
    for _ in range(20):
        line, start, step, probe = random_line(effects, rng)
        for angle in rng.uniform(-1.4, 1.4, 5).tolist():
            twist = start + np.linalg.norm(start) * np.tan(angle) * step
            np.testing.assert_allclose(
                twists.twist_on_line(line, angle), twist, rtol=1e-13, atol=1e-13
            )
            shrunk = not line.on_feet and line.effects.massive
            expected = power_along(effects, twist, probe) * (np.cos(angle) if shrunk else 1.0)
            power = twists.power_on_line(line, angle, angle)
            assert power.value == pytest.approx(expected, rel=1e-12, abs=1e-12)
            after, before = (
                twists.power_on_line(line, angle + h, angle).value for h in (1e-6, -1e-6)
            )
            scale = 1.0 + abs(power.value)
            assert power.slope == pytest.approx((after - before) / 2e-6, rel=1e-3, abs=1e-6 * scale)


@pytest.mark.parametrize("others", OTHERS)
def test_ranges_of_feet_enclose_all_between_two_angles_and_are_those_of_a_short_interval(others):
    rng = np.random.default_rng(2)
    for _ in range(40):
        line, *_ = random_line((FEET, *OTHERS[others]), rng)
        low = float(rng.uniform(-1.5, 1.3))
        high = float(rng.uniform(low, min(low + np.pi / 2, 1.5)))
        ranges = twists.feet_ranges(line, low, high, low)
        angles = np.linspace(low, high, 100).tolist()
        powers = [twists.power_on_line(line, angle, angle) for angle in angles]
        values, slopes = np.array(powers).T
        value, slope = 1e-9 * (1.0 + np.abs(values).max()), 1e-9 * (1.0 + np.abs(slopes).max())
        assert ranges.low - value <= values.min() <= values.max() <= ranges.high + value
        assert ranges.least_slope - slope <= slopes.min()
        assert slopes.max() <= ranges.most_slope + slope
        short = twists.feet_ranges(line, low, low + 1e-9, low)
        expected = [values[0], values[0], slopes[0], slopes[0]]
        np.testing.assert_allclose(short, expected, rtol=1e-5, atol=1e-5)


def several_of(rng, number):
    """Contacts at random places, whose frames are complete; a load keeps power out of the bounds."""
    frames = np.zeros(number * CONTACT_FRAME)
    for i in range(number):
        row = SeveralRow(memoryview(np.zeros(CONTACT_ROW)))
        row.point.x, row.point.y = rng.uniform(-1, 1, 2).tolist()
        turn = rng.uniform(0, 2 * np.pi)
        row.normal.x, row.normal.y = float(np.cos(turn)), float(np.sin(turn))
        row.velocity.x, row.velocity.y = rng.uniform(-0.3, 0.3, 2).tolist()
        row.right, row.left = 1.1, 2.0
        write_frame(row, ContactFrame(memoryview(frames[CONTACT_FRAME * i :])))
    return several_at(effects_of(FEET, *OTHERS["load"]), number, memoryview(frames)), frames


def sharing_of(modes=(0.0,), units=(0.0,), number=0):
    """Contacts in modes with unit forces; without room for the ends of an inner force."""
    modes, units = (memoryview(np.asarray(each, float)) for each in (modes, units))
    return Sharing(modes, units, number, low=units, high=units)


def motions_at(frames, twist):
    """Velocities relative to each pusher along its normal and its tangent, from the rows."""
    rates = []
    for i in range(len(frames) // CONTACT_FRAME):
        contact = ContactFrame(memoryview(frames[CONTACT_FRAME * i :])).inputs
        point, normal = (contact.point.x, contact.point.y), (contact.normal.x, contact.normal.y)
        v_x = twist[0] - twist[2] * point[1] - contact.velocity.x
        v_y = twist[1] + twist[2] * point[0] - contact.velocity.y
        rates.append((v_x * normal[0] + v_y * normal[1], v_x * normal[1] - v_y * normal[0]))
    return np.array(rates)


def test_a_line_of_twists_ends_where_a_contact_leaves_its_mode():
    rng, bounded = np.random.default_rng(3), {"low": 0, "high": 0, "none": 0}
    modes_of = {SEPARATE: (0, 1.0), SLIP_RIGHT: (1, 1.0), SLIP_LEFT: (1, -1.0)}
    for _ in range(400):
        number = int(rng.integers(1, 4))
        several, frames = several_of(rng, number)
        modes = rng.choice([SEPARATE, SLIP_RIGHT, SLIP_LEFT], number).astype(float)
        sharing = sharing_of(modes=modes)
        twist, direction = rng.normal(size=(2, 3))
        bounds = lines.Bounds(memoryview(np.zeros(lines.BOUNDS)))
        motions = MotionSet(Vector(*twist.tolist()), 1, Vector(*direction.tolist()))
        left = lines.write_bounds(several, sharing, motions, bounds)
        at_twist, beyond = motions_at(frames, twist), motions_at(frames, twist + direction)
        low, high = -np.inf, np.inf
        for i, mode in enumerate(modes):
            column, sign = modes_of[int(mode)]
            value = sign * at_twist[i, column]
            slope = sign * (beyond[i, column] - at_twist[i, column])
            low = max(low, -value / slope) if slope > 0 else low
            high = min(high, -value / slope) if slope < 0 else high
        assert left == (low <= high)
        if left:
            assert [bounds.low, bounds.high] == pytest.approx([low, high], rel=1e-9, abs=1e-9)
            bounded["low"] += bool(np.isfinite(low))
            bounded["high"] += bool(np.isfinite(high))
        else:
            bounded["none"] += 1
    assert min(bounded.values()) > 50, bounded


@pytest.mark.parametrize("dimension", [1, 2, 3])
def test_probes_have_no_power_with_any_unit_force(dimension):
    rng = np.random.default_rng(4)
    for _ in range(50):
        wrenches = rng.normal(size=(int(rng.integers(dimension, 6)), dimension)) @ rng.normal(
            size=(dimension, 3)
        )
        units = np.zeros(len(wrenches) * UNIT_FORCE)
        for k, wrench in enumerate(wrenches.tolist()):
            force = UnitForce(memoryview(units[UNIT_FORCE * k :]))
            force.x, force.y, force.torque = wrench
        probes = np.zeros(2 * lines.TWIST)
        sharing = sharing_of(units=units, number=len(wrenches))
        assert lines.span_of_forces(sharing, memoryview(probes)) == dimension
        rows = probes.reshape(2, 3)[: 3 - dimension]
        assert np.linalg.matrix_rank(rows, tol=1e-9) == 3 - dimension
        assert np.abs(rows @ wrenches.T).max(initial=0.0) < 1e-12
