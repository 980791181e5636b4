"""What holds for all scenes with several contacts: units, frames, order, arrays, both forms of the core."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr
from objects.several.scenes import degenerate_scene, modes_of, random_scene, scene_of

import planar_pushing as pp
from planar_pushing.mechanics.kernels import calls as kernels

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
PLANE = pp.SupportFriction(support=pp.Polygon(SQUARE))
SUPPORTS = {
    "feet": pp.Points.rectangle(2.0, 2.0),
    "polygon": pp.Polygon(SQUARE),
    "ring": pp.Ring(0.8),
    "disc and feet": pp.Composite([(1.0, pp.Disc(0.5)), (2.0, pp.Points.rectangle(1.6, 1.2))]),
    "map": pp.PressureMap(
        np.linspace(-1, 1, 5), np.linspace(-1, 1, 4),
        np.array([[1.0, 2, 3, 1], [2, 1, 1, 2], [1, 1, 2, 2]]),
    ),
}  # fmt: skip


def entries_of(seed, count=2):
    """Feet, shares, contacts and mass of a random scene, as `scene_of` takes them."""
    problem = random_scene(seed, count).problem
    contacts = list(
        zip(problem.points, problem.normals, problem.velocities, problem.friction, strict=True)
    )
    return problem.feet, problem.shares, contacts, float(problem.mass[0, 0])


@pytest.mark.parametrize("scale", [1e-3, 1e3, 1e7])
def test_lengths_in_millimeters_and_kilometers(scale):
    """Lengths and speeds grow alike; rotations and, without inertia, forces stay."""
    for seed in range(30):
        feet, shares, contacts, _ = entries_of(seed)
        small = scene_of(feet, shares, contacts).solve()
        scaled = [(scale * p, n, scale * w, mu) for p, n, w, mu in contacts]
        large = scene_of(scale * feet, shares, scaled).solve()
        assert [modes_of(one) for one in large] == [modes_of(one) for one in small]
        for one, other in zip(small, large, strict=True):
            size = np.abs(one.twist).max()
            twist = other.twist / np.array([scale, scale, 1.0])
            assert twist == pytest.approx(one.twist, abs=1e-11 * size, rel=0)
            spread = np.abs(one.forces).max()
            assert other.forces == pytest.approx(one.forces, abs=1e-9 * spread, rel=0)


def test_another_frame_and_another_order():
    """The frame is turned by a right angle and moved, and the contacts are listed in reverse."""
    x, y = 0.75, -0.5
    shift = np.array([x, y])
    for seed in range(30):
        feet, shares, contacts, _ = entries_of(seed, 3)
        first = scene_of(feet, shares, contacts).solve()

        def turn(v):
            return np.stack([-v[..., 1], v[..., 0]], axis=-1)

        moved = [(turn(p) + shift, turn(n), turn(w), mu) for p, n, w, mu in contacts[::-1]]
        second = scene_of(turn(feet) + shift, shares, moved).solve()
        assert {modes_of(one) for one in first} == {modes_of(one)[::-1] for one in second}
        for one in first:
            (other,) = (each for each in second if modes_of(each)[::-1] == modes_of(one))
            v_x, v_y, omega = one.twist
            expected = [-v_y + omega * y, v_x - omega * x, omega]
            size = 1.0 + np.abs(expected).max()
            assert other.twist == pytest.approx(np.array(expected), abs=1e-10 * size, rel=0)


@pytest.mark.parametrize("name", SUPPORTS)
@pytest.mark.parametrize("mass", [0.0, 1.0])
def test_arrays_of_velocities_and_friction(name, mass):
    effects = [pp.SupportFriction(support=SUPPORTS[name])]
    if mass:
        effects.append(pp.Inertia(mass=mass, gyration_radius=0.8, center=(0.1, 0.0)))
    angle, mu = np.linspace(-1.4, 1.4, 7)[:, None], np.array([0.0, 0.3, 2.0])

    def contacts(angle, mu):
        finger = pp.Contact(
            (-1, 0.3), (1, 0), law=pp.Coulomb(mu), velocity=(np.cos(angle), np.sin(angle))
        )
        return [finger, pp.Contact((0.2, -1), (0, 1), law=pp.Coulomb(0.2))]

    many = pp.solve_contacts(contacts(angle, mu), effects=effects)
    assert many.shape == (7, 3)
    for i in range(7):
        for j in range(3):
            one = pp.solve_contacts(contacts(angle[i, 0].item(), mu[j].item()), effects=effects)
            assert many[i, j] == one
    assert many[2] == many[2:3][0]
    labeled = pp.solve_contacts(
        contacts(xr.DataArray(angle[:, 0], dims="angle"), xr.DataArray(mu, dims="mu")),
        effects=effects,
    )
    assert labeled["twist"].dims == ("angle", "mu", "solution", "twist_component")
    assert np.array_equal(labeled["twist"], many.twist, equal_nan=True)
    assert np.array_equal(labeled["outcome"], many.outcome)


@pytest.mark.parametrize("name", SUPPORTS)
def test_forces_balance_the_load_of_the_twist(name):
    """The load comes from `pp.wrench`, and each force is within its cone."""
    support = pp.SupportFriction(support=SUPPORTS[name])
    for seed in range(40):
        contacts = random_scene(seed, 2 + seed % 3).contacts
        for solution in pp.solve_contacts(contacts, effects=[support]):
            if solution.pivot >= 0 or not solution.twist.any():
                continue
            load = pp.wrench(support, solution.twist)
            for forces in (solution.forces, solution.forces_end):
                if not np.isfinite(forces).all():
                    continue
                size = 1.0 + np.abs(forces).max()
                assert forces.sum(axis=0) == pytest.approx(load[:2], abs=1e-9 * size)
                torque = sum(
                    one.point[0] * f[1] - one.point[1] * f[0]
                    for one, f in zip(contacts, forces, strict=True)
                )
                assert torque == pytest.approx(load[2], abs=1e-9 * size)
                for one, f in zip(contacts, forces, strict=True):
                    across = one.normal @ f
                    along = one.normal[1] * f[0] - one.normal[0] * f[1]
                    assert abs(along) <= one.law.friction_coefficient * across + 1e-9 * size


def test_the_same_bits_compiled_and_plain(both):
    """Random, degenerate and flush scenes, with the supports above, with inertia and loads."""
    for seed in range(12):
        random_scene(seed, 2 + seed % 3).solve()
    for seed in range(12):
        scene = degenerate_scene(seed)
        pp.solve_contacts(scene.contacts, effects=scene.effects)
    inertia = pp.Inertia(mass=1.0, gyration_radius=0.8, center=(0.1, 0.0))
    pull = pp.Load(force=(0.1, -1.5))
    for name, support in SUPPORTS.items():
        friction = pp.SupportFriction(support=support)
        for effects in (
            [friction],
            [friction, inertia],
            [friction, inertia, pull],
            [inertia, pull],
        ):
            finger = pp.Contact((-1, 0.3), (1, 0), law=pp.Coulomb(0.5), velocity=(1, -0.4))
            floor = pp.Contact((0.2, -1), (0, 1), law=pp.Coulomb(0.2))
            other = pp.Contact((-0.6, -1), (0, 1), law=pp.InfiniteFriction("none"))
            assert pp.solve_contacts([finger, floor], effects=effects) is not None, name
            assert pp.solve_contacts([floor, other], effects=effects) is not None, name
    assert len(both.results["solve_contacts"]) >= 60
    assert kernels.COMPILED is both


def test_contacts_that_hold_a_load_at_rest():
    """A shelf and a wedge against a weight, with closed forms; friction of the support helps nobody."""
    inertia = pp.Inertia(mass=1.0, gyration_radius=0.8, center=(0.0, 0.0))
    weight = pp.Load(force=(0.0, -1.0))
    rub = pp.SupportFriction(support=pp.Points.rectangle(2.0, 2.0), weight=0.5)
    for effects in ([inertia, weight], [rub, inertia, weight]):
        shelf = [pp.Contact((x, -1), (0, 1), law=pp.Coulomb(0.0)) for x in (-0.8, 0.5)]
        (rest,) = pp.solve_contacts(shelf, effects=effects)
        assert modes_of(rest) == "KK"
        assert rest.twist.tolist() == [0.0, 0.0, 0.0]
        expected = np.array([(0.0, 0.5 / 1.3), (0.0, 0.8 / 1.3)])
        assert rest.forces == pytest.approx(expected, abs=1e-12)
        wedge = [pp.Contact((s * 0.8, -1), (-s, 1), law=pp.Coulomb(0.0)) for s in (-1, 1)]
        (rest,) = pp.solve_contacts(wedge, effects=effects)
        assert rest.forces == pytest.approx(np.array([(0.5, 0.5), (-0.5, 0.5)]), abs=1e-12)
    light = pp.solve_contacts(shelf, effects=[rub, inertia, pp.Load(force=(0.0, -0.4))])
    assert [modes_of(one) for one in light] == ["SS"]


def test_a_continuum_is_reported_by_its_ends():
    """A wall whose normal passes through a finger that sticks leaves the rotation free in an interval."""
    finger = pp.Contact((0.5, -1), (0, 1), law=pp.Coulomb(0.5), velocity=(0, 1))
    wall = pp.Contact((1, -1), (-1, 0), law=pp.Coulomb(1.0))
    feet = pp.SupportFriction(support=pp.Points([(-1, -1), (1, -1), (0, 1)], [1, 1, 1]))
    answer = pp.solve_contacts([finger, wall], effects=[feet])
    assert answer.outcome is pp.Outcome.AMBIGUOUS
    assert [modes_of(one) for one in answer] == ["KR", "KR"]
    assert all(one.continuum for one in answer)
    for one in answer:
        v_x, v_y, omega = one.twist
        assert [v_x + omega, v_y + 0.5 * omega] == pytest.approx([0.0, 1.0], abs=1e-12)


def test_a_point_finger_in_an_inner_corner():
    """Two contacts at one point: the rotation needs the least power, as that of the same single contact."""
    tee = [(-60, 0), (-60, 30), (60, 30), (60, 0), (15, 0), (15, -90), (-15, -90), (-15, 0)][::-1]
    effects = [pp.SupportFriction(support=pp.Polygon(tee))]
    law = pp.Coulomb(0.2)
    corner = [
        pp.Contact((15, 0), normal, law=law, velocity=(-1, 1)) for normal in ((-1, 0), (0, 1))
    ]
    answer = pp.solve_contacts(corner, effects=effects, outline=tee)
    (stick,) = (one for one in answer if modes_of(one) == "KK")
    assert stick.forces.sum(axis=0) == pytest.approx([-0.6159, 0.6444], abs=1e-4)
    rough = pp.scene_at((15, 0), (-1, 1), effects=effects, contact=pp.PerfectlyRough())
    (alone,) = (one for one in pp.solve(rough, np.pi / 2, np.sqrt(2.0)) if str(one.mode) == "STICK")
    assert stick.twist == pytest.approx(rough.to_object(alone.twist, "twist"), abs=1e-9)


@pytest.mark.parametrize("turns", range(4))
def test_a_load_along_an_axis_of_the_object_pulls_it_down_a_slope(turns):
    """Two fingers at rest only brake it: no contact does work, and the load alone is along x or y."""
    turn = np.linalg.matrix_power([[0, -1], [1, 0]], turns).T
    wedge = np.array([(-1, 0), (1, -1), (1, 1)]) @ turn
    feet = np.array([(-0.6, 0), (0.3, -0.45), (0.3, 0.45)]) @ turn
    effects = [
        pp.SupportFriction(support=pp.Points(feet)),
        pp.Inertia(gyration_radius=0.6),
        pp.Load(force=tuple(np.array([0, -3]) @ turn), center=(0, 0)),
    ]
    contacts = [
        pp.Contact(tuple(wedge[0] + part * (wedge[1] - wedge[0])), law=pp.Coulomb(0.1), velocity=(0, 0))
        for part in (0.3, 0.7)
    ]  # fmt: skip
    (only,) = pp.solve_contacts(contacts, effects=effects, outline=wedge)
    assert only.modes == (pp.ContactMode.SLIP_RIGHT,) * 2
    # Of the load, 3 sin(a) is along the slope, tan(a) = 1/2; friction is 0.1 times 3 cos(a), and 1.
    along = (3.0 - 0.6) / np.sqrt(5.0) - 1.0
    assert only.twist @ [*(np.array([2, -1]) / np.sqrt(5.0) @ turn), 0.0] == pytest.approx(along)
