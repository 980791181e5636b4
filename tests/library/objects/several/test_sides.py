"""A side of an object as two contacts: the answers are those of the solver of flat sides."""

from __future__ import annotations

import numpy as np
import pytest
from objects.several.scenes import modes_of

import planar_pushing as pp

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
BOX = pp.SupportFriction(support=pp.Polygon(SQUARE))


def random_side(seed):
    """A side of a random polygon on feet, on itself or on a disc, half of them with inertia, and a push."""
    rng = np.random.default_rng(seed)
    corners = rng.integers(3, 7)
    turn = np.sort(rng.uniform(0.0, 2.0 * np.pi, corners))
    while np.diff(np.r_[turn, turn[0] + 2.0 * np.pi]).max() > 2.8:
        turn = np.sort(rng.uniform(0.0, 2.0 * np.pi, corners))
    outline = np.column_stack([np.cos(turn), np.sin(turn)]) * (1.0, rng.uniform(0.4, 1.0))
    kind = seed % 3
    if kind == 0:
        feet = rng.dirichlet(np.ones(corners), 4) @ outline
        support = pp.Points(feet.tolist(), rng.uniform(0.2, 1.0, 4).tolist())
    else:
        support = pp.Polygon(outline.tolist()) if kind == 1 else pp.Disc(0.1)
    effects = [pp.SupportFriction(support=support)]
    if seed % 2:
        mass = float(rng.uniform(0.2, 3.0))
        effects.append(pp.Inertia(mass=mass, gyration_radius=0.15, center=(0.1, -0.05)))
    law = pp.Coulomb(float(rng.choice([0.0, 0.1, 0.3, 0.6, 1.0, 2.0])))
    if seed % 10 == 9:
        law = pp.InfiniteFriction(("free", "none")[seed // 10 % 2])
    angle = rng.uniform(0.02, np.pi - 0.02)
    if rng.random() < 0.15:
        angle = rng.uniform(-np.pi, 0.0)
    side = int(rng.integers(0, corners))
    return side, outline.tolist(), effects, law, angle, rng.uniform(0.3, 2.0)


def end_forces(scene, solution):
    """Bounds of the forces at both ends, in the frame of the fence, as of a flush solution."""
    ends = np.stack([solution.forces, solution.forces_end], axis=1)
    local = scene.to_fence(ends, "vector")
    return np.stack([local.min(axis=1), local.max(axis=1)], axis=1)


@pytest.mark.filterwarnings("ignore::planar_pushing.SceneWarning")
@pytest.mark.parametrize("part", range(5))
def test_flush_scenes(part):
    flush = 0
    for seed in range(40 * part, 40 * part + 40):
        side, outline, effects, law, angle, speed = random_side(seed)
        scene = pp.scene_at(side=side, effects=effects, contact=law, outline=outline)
        expected = pp.solve(scene, angle, speed)
        velocity = scene.to_object((speed * np.cos(angle), speed * np.sin(angle)), "vector")
        palm = pp.Contact(side=side, law=law, velocity=velocity)
        answer = pp.solve_contacts([palm], effects=effects, outline=outline)
        assert len(answer) == len(expected), seed
        twists = np.array([solution.twist for solution in answer]).reshape(-1, 3)
        for one in expected:
            twist = scene.to_object(one.twist, "twist")
            apart = np.abs(twists - twist).max(axis=1)
            other = answer[int(apart.argmin())]
            assert apart.min() <= 1e-13 * (1.0 + np.abs(twist).max()), seed
            flush += one.flush
            if np.isfinite(other.forces).all() and np.isfinite(one.end_forces).all():
                got = end_forces(scene, other)
                assert got == pytest.approx(one.end_forces, abs=1e-11 * (1.0 + np.abs(got).max()))
    assert flush >= 15


@pytest.mark.parametrize(
    ("mu", "height", "first"),
    [(mu, 0.0, 0.67668264) for mu in (0.25, 0.5, 1.0)]
    + [(0.25, -1.0, 3.99601), (0.3, -1.0, 3.32718), (0.5, -1.0, 1.98471), (1.0, -1.0, 1.33934)],
)
def test_a_palm_that_turns_holds_a_square_beyond_published_centers(mu, height, first):
    """Clockwise rotations about (x, height), as in Lynch and Mason (1996): stable from the first x on."""
    x = first + np.array([-1e-5, 1e-5, 1.0, 100.0])
    # The rotation by -1 about (x, height), as a twist about the origin.
    twist = (np.full_like(x, -height), x, np.full_like(x, -1.0))
    palm = pp.Contact(side=0, law=pp.Coulomb(mu), twist=twist)
    answer = pp.solve_contacts([palm], effects=[BOX], outline=SQUARE)
    sticks = [any(modes_of(one) == "KK" for one in answer[i]) for i in range(len(x))]
    assert sticks == [False, True, True, True]


def test_a_box_that_a_finger_pushes_along_a_wall_has_three_contacts():
    """Both corners slip on the wall; the finger sticks, and its friction is part of the balance."""
    wall = pp.Contact(side=0, law=pp.Coulomb(0.2))
    finger = pp.Contact((-1, 0.3), law=pp.Coulomb(0.3), velocity=(1, 0))
    answer = pp.solve_contacts([finger, wall], effects=[BOX], outline=SQUARE)
    (slide,) = answer
    assert modes_of(slide) == "KRR"
    assert slide.twist == pytest.approx([1.0, 0.0, 0.0], abs=1e-12)
    for forces in (slide.forces, slide.forces_end):
        assert forces.sum(axis=0) == pytest.approx([1.0, 0.0], abs=1e-12)
        (f_x, f_y), *feet = forces
        assert abs(f_y) <= 0.3 * f_x + 1e-12
        for along, across in feet:
            assert along == pytest.approx(-0.2 * across, abs=1e-12)
            assert across >= -1e-12
        torque = -1.0 * f_y - 0.3 * f_x
        torque += sum(
            x * across + 1.0 * along for x, (along, across) in zip((-1, 1), feet, strict=True)
        )
        assert torque == pytest.approx(0.0, abs=1e-12)


def test_a_force_through_an_end_under_friction_without_a_tangential_force_alone():
    """The other end is closed without a force, as its cone lacks its edges."""
    law = pp.InfiniteFriction("none")
    scene = pp.scene_at(side=0, effects=[BOX], contact=law, outline=SQUARE)
    (expected,) = pp.solve(scene, np.pi / 4, 1.0)
    velocity = scene.to_object((np.sqrt(0.5), np.sqrt(0.5)), "vector")
    palm = pp.Contact(side=0, law=law, velocity=velocity)
    (stick,) = pp.solve_contacts([palm], effects=[BOX], outline=SQUARE)
    assert modes_of(stick) == "KK"
    assert expected.flush
    assert end_forces(scene, stick) == pytest.approx(expected.end_forces, abs=1e-12)
    assert stick.forces == pytest.approx(np.array([[0.5**0.5, 0.5**0.5], [0, 0]]), abs=1e-12)


def test_an_inner_force_without_a_bound_in_a_side_that_is_held_at_rest():
    """The load along the side exceeds friction; infinite friction lets the ends pull against each other."""
    effects = [BOX, pp.Inertia(mass=1.0, gyration_radius=0.8), pp.Load(force=(1.2, -0.4))]
    scene = pp.scene_at(side=0, effects=effects, contact=pp.InfiniteFriction(), outline=SQUARE)
    (expected,) = pp.solve(scene, 0.0, 0.0)
    palm = pp.Contact(side=0, law=pp.InfiniteFriction())
    (rest,) = pp.solve_contacts([palm], effects=effects, outline=SQUARE)
    assert modes_of(rest) == "KK"
    assert expected.flush
    assert not rest.twist.any()
    assert rest.inner_force.tolist() == [-np.inf, np.inf]
    assert np.isinf(expected.end_forces[:, :, 0]).all()
    assert rest.directions[:, :, 1] == pytest.approx(np.zeros((2, 2)), abs=1e-15)
