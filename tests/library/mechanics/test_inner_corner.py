"""A point at an inner corner touches two sides: every solution, against an enumeration of its own.

The reference sums over support points. A sticking contact has the rotation without a torque about the
contact; a contact that slips along a side has, besides, its force on an edge of that side's cone. All roots
are bracketed on a fine grid.
"""

import numpy as np
import pytest
from matplotlib.path import Path
from scipy.optimize import brentq

import planar_pushing as pp

#: The T of the PushT task, in millimeters.
T = [(-60, 0), (-60, 30), (60, 30), (60, 0), (15, 0), (15, -90), (-15, -90), (-15, 0)]
#: Outlines with an inner corner, its number, and the tangents of the sides before and after it.
SHAPES = {
    "right": ([(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)], 3),
    "wide": ([(0, 0), (3, 0), (3, 1), (1.2, 1.4), (0, 3)], 3),
    "narrow": ([(0, 0), (3, 0), (3, 2.5), (1.2, 0.8), (1, 3), (0, 3)], 3),
}
#: Speed of a foot below which the reference rounds its friction off.
BLUR = 1e-10
T_SCENE = {
    "effects": [pp.SupportFriction(support=pp.Polygon(T))],
    "contact": pp.Coulomb(0.2),
    "outline": T,
}


def push_of(scene, velocity):
    """The solutions of a push with a velocity in the object's frame."""
    x, y = scene.to_fence(np.array(velocity, dtype=float), "vector")
    return pp.solve(scene, float(np.arctan2(y, x)), float(np.hypot(x, y)))


class Feet:
    """Friction of support points, and their sums about a contact."""

    def __init__(self, rng, corners):
        tries = rng.uniform(0.0, 3.0, size=(200, 2))
        self.points = tries[Path(corners).contains_points(tries)][:5]
        self.weights = rng.dirichlet(np.ones(5))
        self.support = pp.Points(self.points.tolist(), self.weights.tolist())

    def wrench(self, contact, motion, spin):
        """Force on the feet and torque about the contact that resist a motion of the contact."""
        arms = self.points - contact
        velocity = motion + spin * np.stack([-arms[:, 1], arms[:, 0]], axis=-1)
        # A foot at the center of rotation has the force that balances the others; this makes it steep.
        speed = np.sqrt((velocity**2).sum(axis=1) + BLUR**2)
        force = self.weights[:, None] * velocity / speed[:, None]
        return force.sum(axis=0), float((arms[:, 0] * force[:, 1] - arms[:, 1] * force[:, 0]).sum())

    def spin_about(self, contact, motion):
        """The rotation without a torque about the contact."""
        torque = lambda spin: self.wrench(contact, motion, spin)[1]  # noqa: E731
        return brentq(torque, -1e4, 1e4, xtol=1e-13)


def expected_solutions(feet, contact, tangents, mu, velocity):
    """Modes with angular velocities and slips: those of a point that touches sides with given tangents."""
    phi = np.arctan(mu)
    normals = [np.array([-t[1], t[0]]) for t in tangents]
    found = []
    if all(n @ velocity <= 0.0 for n in normals):
        found.append((pp.ContactMode.SEPARATE, 0.0, 0.0))
    spin = feet.spin_about(contact, velocity)
    force, _ = feet.wrench(contact, velocity, spin)
    outer = [edge(normals[1], -phi), edge(normals[0], phi)]
    opening = np.arccos(np.clip(normals[0] @ normals[1], -1, 1)) + 2.0 * phi
    inside = cross(outer[0], force) >= 0.0 and cross(force, outer[1]) >= 0.0
    if opening > np.pi or inside:
        found.append((pp.ContactMode.STICK, spin, 0.0))
    for i, mode in ((0, pp.ContactMode.SLIP_RIGHT), (1, pp.ContactMode.SLIP_LEFT)):
        sense = 1.0 if i == 0 else -1.0
        line, direction = edge(normals[i], sense * phi), sense * tangents[i]

        def off(slip, line=line, direction=direction):
            motion = velocity + slip * direction
            return cross(line, feet.wrench(contact, motion, feet.spin_about(contact, motion))[0])

        # Uneven places, so that none is a root by symmetry.
        slips = np.geomspace(1e-7, 40.0, 160)
        values = [off(slip) for slip in slips]
        for low, high, one, two in zip(slips, slips[1:], values, values[1:], strict=False):
            if one * two < 0.0:
                slip = brentq(off, low, high, xtol=1e-13)
                motion = velocity + slip * direction
                spin = feet.spin_about(contact, motion)
                if line @ feet.wrench(contact, motion, spin)[0] > 0.0:
                    found.append((mode, spin, slip))
    return found


def edge(normal, angle):
    """A normal rotated by an angle."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([c * normal[0] - s * normal[1], s * normal[0] + c * normal[1]])


def cross(one, two):
    """Cross product of two vectors of the plane."""
    return one[0] * two[1] - one[1] * two[0]


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize(
    "seed", [*range(6), *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(6, 12))]
)
def test_every_solution_is_found(name, seed):
    corners, number = SHAPES[name]
    rng = np.random.default_rng([seed, len(name)])
    points = np.array(corners, dtype=float)
    contact = points[number]
    tangents = [contact - points[number - 1], points[(number + 1) % len(points)] - contact]
    tangents = [t / np.hypot(*t) for t in tangents]
    feet = Feet(rng, corners)
    mu = float(rng.choice([0.0, 0.1, 0.4, 1.5]))
    velocity = edge(np.array([1.0, 0.0]), rng.uniform(-np.pi, np.pi))
    scene = pp.scene_at(
        tuple(contact), outline=corners, contact=pp.Coulomb(mu),
        effects=[pp.SupportFriction(support=feet.support)],
    )  # fmt: skip
    solved = push_of(scene, velocity)
    expected = expected_solutions(feet, contact, tangents, mu, velocity)
    assert [solution.mode for solution in solved] == [mode for mode, *_ in expected]
    for solution, (_, spin, slip) in zip(solved, expected, strict=True):
        assert solution.twist[2] == pytest.approx(spin, rel=1e-6, abs=1e-9)
        if solution.mode == pp.ContactMode.SEPARATE:
            continue
        motion = scene.to_object(solution.contact_motion, "vector") - velocity
        assert np.hypot(*motion) == pytest.approx(slip, rel=1e-6, abs=1e-9)


def test_a_point_sticks_in_the_corner_of_a_t_or_leaves_along_its_stem():
    scene = pp.scene_at((15.0, 0.0), **T_SCENE)
    (stick,) = push_of(scene, (-1.0, 1.0))
    assert stick.mode == pp.ContactMode.STICK
    assert scene.to_object(stick.force, "vector") == pytest.approx([-0.6159, 0.6444], abs=5e-5)
    assert stick.twist[2] == pytest.approx(0.0144250512, abs=1e-9)
    (slip,) = push_of(scene, (-1.0, -0.1))
    assert slip.mode == pp.ContactMode.SLIP_RIGHT
    moved = scene.to_object(slip.contact_motion, "vector") - (-1.0, -0.1)
    assert moved == pytest.approx([0.0, 0.10723673], abs=1e-8)


def test_a_mirrored_corner_has_mirrored_solutions():
    scene, mirrored = (pp.scene_at((x, 0.0), **T_SCENE) for x in (15.0, -15.0))
    swapped = {pp.ContactMode.SLIP_LEFT: pp.ContactMode.SLIP_RIGHT}
    swapped |= {right: left for left, right in swapped.items()}
    for angle in np.linspace(0.0, 2.0 * np.pi, 41):
        velocity = np.array([np.cos(angle), np.sin(angle)])
        ones, twos = push_of(scene, velocity), push_of(mirrored, velocity * [-1, 1])
        # A push along a wall can move nothing: rounding decides between a slip and separation.
        is_along = np.abs(velocity).min() < 1e-12
        if not is_along or any(np.abs(one.twist).max() > 1e-12 for one in ones):
            assert sorted(one.mode for one in ones) == sorted(
                swapped.get(two.mode, two.mode) for two in twos
            )
        assert sorted(one.twist[2] for one in ones) == pytest.approx(
            sorted(-two.twist[2] for two in twos), abs=1e-12
        )


@pytest.mark.parametrize("law", [pp.InfiniteFriction(), pp.PerfectlyRough(), pp.Coulomb(1.0)])
def test_cones_that_sum_to_every_force_stick_under_every_push(law):
    corners, number = SHAPES["narrow"]
    effects = [pp.SupportFriction(support=pp.Polygon(corners))]
    scene = pp.scene_at(corners[number], outline=corners, contact=law, effects=effects)
    for angle in np.linspace(-np.pi, np.pi, 30):
        modes = [solution.mode for solution in pp.solve(scene, float(angle))]
        assert pp.ContactMode.STICK in modes
    cone = pp.friction_cone(scene)
    assert cone.left - cone.right == pytest.approx(2.0 * np.pi)


def test_an_array_of_contacts_holds_corners_and_sides():
    points = np.array([(15.0, 0.0), (15.0, -40.0), (-15.0, 0.0), (40.0, 0.0)])
    scenes = pp.scene_at(points, **T_SCENE)
    together = pp.solve(scenes, np.deg2rad(70.0))
    for i, point in enumerate(points):
        alone = pp.solve(pp.scene_at(tuple(point), **T_SCENE), np.deg2rad(70.0))
        assert together.solutions[i] == len(alone)
        for k, solution in enumerate(alone):
            assert together.mode[i, k] == solution.mode
            assert together.twist[i, k] == pytest.approx(solution.twist, rel=1e-12, abs=1e-15)


def test_inertia_from_rest_and_loads_are_in_the_balance():
    effects = [
        pp.SupportFriction(support=pp.Polygon(T)),
        pp.Inertia(),
        pp.Load(force=(0.1, -0.1), center=(10, -20)),
    ]
    scene = pp.scene_at((15.0, 0.0), **(T_SCENE | {"effects": effects}))
    (stick,) = push_of(scene, (-1.0, 1.0))
    rough = pp.scene_at(
        (15.0, 0.0), **(T_SCENE | {"effects": effects, "contact": pp.PerfectlyRough()})
    )
    assert stick.twist == pytest.approx(push_of(rough, (-1.0, 1.0))[0].twist, rel=1e-12)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"normal": (1.0, 0.0)}, "allowed: the bisector of the normals of both sides"),
        ({"normal": (0.0, 1.0)}, "(-0.707107, 0.707107)"),
    ],
)
def test_another_normal_than_the_bisector_is_refused(given, said):
    with pytest.raises(pp.InvalidValue) as caught:
        pp.scene_at((15.0, 0.0), **given, **T_SCENE)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def test_derivatives_are_refused():
    scene = pp.scene_at((15.0, 0.0), **T_SCENE)
    with pytest.raises(pp.InvalidValue, match="inner corner"):
        pp.solve(scene, 1.0, derivatives=True)


def test_the_motion_cone_is_that_of_sticking_pushes():
    scene = pp.scene_at((15.0, 0.0), **T_SCENE)
    cone = pp.motion_cone(scene)
    for angle, sticks in (
        (cone.right + 1e-6, True), (cone.right - 1e-6, False),
        (cone.left - 1e-6, True), (cone.left + 1e-6, False),
    ):  # fmt: skip
        modes = [solution.mode for solution in pp.solve(scene, float(angle))]
        assert (pp.ContactMode.STICK in modes) == sticks
