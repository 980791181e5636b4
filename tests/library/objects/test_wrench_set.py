"""The loads of a twist, and distances from them, against the potential and scipy."""

import numpy as np
import pytest
from objects.brute import loads
from objects.pushed import SQUARE, star, support
from scipy.optimize import minimize_scalar

import planar_pushing as pp

FEET = (pp.SupportFriction(support=pp.Points(SQUARE, [1, 2, 3, 4]), weight=5.0),)
#: A rotation about the third foot, (1, 1), of force 1.5 at most.
ABOUT = np.array([2.0, -2.0, 2.0])


def about(place, omega=1.0):
    """The twist of a rotation about a place."""
    return omega * np.array([place[1], -place[0], 1.0])


def smallest(wrenches, wrench, length):
    """Distance by least squares inside the disc, and by a search around its rim."""
    scale = np.array([1.0, 1.0, 1.0 / length])
    x, y = wrenches.foot
    lever = np.array([[1.0, 0.0], [0.0, 1.0], [-y, x]]) * scale[:, None]
    away = (wrench - wrenches.offset) * scale
    inside = np.linalg.lstsq(lever, away, rcond=None)[0]
    if np.linalg.norm(inside) <= wrenches.radius:
        return np.linalg.norm(away - lever @ inside)

    def at(angle):
        rim = wrenches.radius * np.array([np.cos(angle), np.sin(angle)])
        return np.sum((away - (lever @ rim).T) ** 2, axis=-1)

    # With a short length the function has two narrow valleys.
    grid = np.linspace(0, 2 * np.pi, 720, endpoint=False)
    values = at(grid)
    lowest = (values <= np.roll(values, 1)) & (values <= np.roll(values, -1))
    options = {"xatol": 1e-13}
    found = [
        minimize_scalar(at, bounds=(each - 0.01, each + 0.01), options=options).fun
        for each in grid[lowest]
    ]
    return np.sqrt(min(found))


def test_without_a_foot_on_the_center_it_is_the_wrench():
    twist = (1.5, -0.5, 1.0)
    effects = (pp.SupportFriction(support=pp.Polygon(SQUARE)),)
    found = pp.wrench_set(effects, twist)
    assert found.offset == pytest.approx((0.88059012, -0.28398883, 0.22779024), abs=1e-8)
    assert (found.foot, found.radius) == (None, 0.0)
    assert found.length == pytest.approx(np.sqrt(2))
    assert found.distance(found.offset) == 0.0
    assert found.distance([*found.offset[:2], 0.0]) == pytest.approx(0.22779024 / np.sqrt(2))
    assert found.distance([*found.offset[:2], 0.0], length=0.1) == pytest.approx(2.2779024)


def test_the_foot_about_which_it_turns():
    found = pp.wrench_set(FEET, ABOUT)
    assert found.foot.tolist() == [1.0, 1.0]
    assert found.radius == pytest.approx(1.5)
    slant = np.sqrt(0.5)
    force = 0.5 * slant * np.array([1, -1]) + [0, -2.0] + [1.0, 0]
    assert found.offset[:2] == pytest.approx(force)
    # The torque about the foot, and from there about the origin.
    assert found.offset[2] == pytest.approx(0.5 * 2 * np.sqrt(2) + 4.0 + 2.0 + force[1] - force[0])


@pytest.mark.parametrize("kind", ["points", "polygon", "disc", "composite"])
def test_each_load_is_a_subgradient_of_the_potential(kind):
    rng = np.random.default_rng(3)
    pressed = support(rng, kind)
    effects = (pp.SupportFriction(support=pressed, weight=3.0),)
    feet = pressed.pieces().atoms
    twist = about(feet[2] if len(feet) else (0.3, 0.2), -1.7)
    found = pp.wrench_set(effects, twist)
    assert (found.foot is not None) == bool(len(feet))
    each = loads(rng, found, 50)
    power = pp.potential(effects[0], twist)
    assert each @ twist == pytest.approx(np.full(50, power))
    other = rng.normal(size=(300, 3))
    assert (each @ other.T <= pp.potential(effects[0], other) + 1e-12).all()


def test_the_rim_is_the_load_of_centers_beside_the_foot():
    found = pp.wrench_set(FEET, ABOUT)
    for angle in np.linspace(0, 6, 7):
        beside = about(found.foot + 1e-7 * np.array([np.cos(angle), np.sin(angle)]), 2.0)
        load = pp.wrench(FEET[0], beside)
        assert found.distance(load) < 1e-6
        assert np.hypot(*(load - found.offset)[:2]) == pytest.approx(found.radius, abs=1e-6)


def test_a_center_near_a_foot_counts_within_a_distance():
    twist = about((1.003, 1.0), 2.0)
    assert pp.wrench_set(FEET, twist).foot is None
    assert pp.wrench_set(FEET, twist, tolerance=0.0029).foot is None
    found = pp.wrench_set(FEET, twist, tolerance=0.0031)
    assert found.foot.tolist() == [1.0, 1.0]
    assert found.distance(pp.wrench(FEET[0], twist)) < 1e-14
    assert pp.wrench_set(FEET, about((0.9, 0.0)), tolerance=5.0).foot.tolist() in ([1, 1], [1, -1])


def test_feet_of_several_effects_at_one_place_add():
    two = pp.Composite([(1, pp.Disc(0.5)), (3, pp.Points([(1, 1), (0, 0), (1, 1)], [1, 1, 1]))])
    effects = (
        *FEET,
        pp.SupportFriction(support=two, weight=8.0),
        pp.Inertia(mass=2.0, center=(0, 0)),
    )
    found = pp.wrench_set(effects, ABOUT)
    assert found.radius == pytest.approx(1.5 + 8.0 * 0.75 * 2 / 3)
    # The foot at the center, the disc, and the mass.
    speed = 2.0 * np.array([1.0, -1.0])
    disc = pp.wrench(pp.SupportFriction(support=pp.Disc(0.5), weight=2.0), ABOUT)
    own = pp.wrench_set(FEET, ABOUT).offset
    force = 2.0 * speed / np.hypot(*speed)
    rest = own + disc + [*force, 0.0] + [*(2.0 * speed), 2.0 * 2.0]
    assert found.offset == pytest.approx(rest)


def test_a_translation_has_no_foot_at_rest():
    found = pp.wrench_set(FEET, (0.0, -3.0, 0.0))
    assert found.foot is None
    assert found.offset == pytest.approx((0.0, -5.0, 0.0 - 5.0 * (1 - 2 - 3 + 4) / 10 + 0.0))


def test_viscous_friction_is_absent_where_there_is_inertia():
    viscous, mass = pp.Viscous(support=pp.Disc(1.0), coefficient=0.5), pp.Inertia(mass=2.0)
    twist = np.array([1.0, 0.5, -2.0])
    assert pp.wrench_set((viscous,), twist).offset == pytest.approx(pp.wrench(viscous, twist))
    assert pp.wrench_set((viscous, mass), twist).offset == pytest.approx(pp.wrench(mass, twist))


def test_a_load_acts_at_its_point_and_by_default_at_the_center():
    bare = pp.wrench_set(FEET, ABOUT).offset
    pulled = (*FEET, pp.Load(force=(0.3, 0.7), center=(2.0, -1.0)))
    assert pp.wrench_set(pulled, ABOUT).offset == pytest.approx(bare - [0.3, 0.7, 1.4 + 0.3])
    x, y = FEET[0].support.center_of_pressure
    middle = (*FEET, pp.Load(force=(0.3, 0.7)))
    assert pp.wrench_set(middle, ABOUT).offset == pytest.approx(
        bare - [0.3, 0.7, x * 0.7 - y * 0.3]
    )
    mass = pp.Inertia(mass=2.0, center=(0.5, 0.25))
    heavy = pp.wrench_set((mass, pp.Load(force=(0.3, 0.7))), ABOUT).offset
    assert heavy == pytest.approx(pp.wrench(mass, ABOUT) - [0.3, 0.7, 0.5 * 0.7 - 0.25 * 0.3])


@pytest.mark.parametrize("foot", [(0.0, 0.0), (1.0, 0.0), (-0.3, 0.8), (1e-9, 0.0), (300.0, -40.0)])
@pytest.mark.parametrize("length", [1.0, 1e-3, 1e3])
def test_the_nearest_wrench(foot, length):
    rng, scale = np.random.default_rng(4), np.array([1.0, 1.0, length])
    rest = rng.normal(size=3) * scale
    found = pp.WrenchSet(offset=rest, foot=np.array(foot), radius=0.7, length=length)
    away = 10.0 ** rng.uniform(-3, 3, 60)[:, None] * rng.normal(size=(60, 3))
    wrench = rest + away * scale
    near, distances = found.nearest(wrench), found.distance(wrench)
    force = (near - rest)[:, :2]
    assert (np.hypot(*force.T) <= 0.7 * (1 + 1e-9)).all()
    torque = foot[0] * force[:, 1] - foot[1] * force[:, 0]
    rounding = 1e-14 * (np.hypot(*foot) + length)
    assert (near - rest)[:, 2] == pytest.approx(torque, rel=1e-9, abs=rounding)
    right = np.array([smallest(found, each, length) for each in wrench])
    # Distances of some units in the last place of the torque are rounding.
    slack = 1e-9 * right + 1e-13 * (1 + np.hypot(*foot) / length + np.abs(away).max(axis=1))
    assert (distances <= right + slack).all()
    assert (right <= distances + 1e-6 * right + slack).all()


def test_wrenches_of_the_set_and_of_its_rim_are_at_no_distance():
    rng = np.random.default_rng(5)
    found = pp.wrench_set(FEET, ABOUT)
    assert found.distance(loads(rng, found, 200)) == pytest.approx(np.zeros(200), abs=1e-14)
    assert found.nearest(found.offset) == pytest.approx(found.offset)
    # Straight out from the rim where the torque about the foot stays: the foot's force is then too large.
    out = found.offset + 2.0 * found.radius * np.array([1.0, 1.0, 0.0]) / np.sqrt(2)
    assert found.distance(out, length=1e9) == pytest.approx(found.radius)


def test_shapes():
    found = pp.wrench_set(FEET, ABOUT)
    wrench = np.ones((4, 5, 3))
    assert found.nearest(wrench).shape == (4, 5, 3)
    assert found.distance(wrench).shape == (4, 5)
    assert found.distance(np.empty((0, 3))).shape == (0,)
    assert found == pp.wrench_set(FEET, ABOUT)
    assert found != pp.wrench_set(FEET, ABOUT + 1e-3)


@pytest.mark.parametrize("twist", [(0, 0, 0), (1, 2, np.nan), "abc"])
def test_a_twist_is_three_finite_numbers(twist):
    with pytest.raises(pp.InvalidValue, match="three finite numbers, not all zero") as caught:
        pp.wrench_set(FEET, twist)
    assert caught.value.name == "twist"


@pytest.mark.parametrize(
    "effects",
    [(), FEET[0], (pp.RingFriction(),), (*FEET, pp.RingFriction()), (pp.Load(force=(1, 0)),), None],
)
def test_effects_that_have_no_place(effects):
    with pytest.raises(pp.InvalidValue, match="not of loads alone; list what resists") as caught:
        pp.wrench_set(effects, ABOUT)
    assert caught.value.name == "effects"


@pytest.mark.parametrize(
    ("effect", "name"),
    [
        (pp.SupportFriction(), "support"),
        (pp.SupportFriction(support=pp.Points([(1, 2), (1, 2)], [1, 1])), "support"),
        (pp.SupportFriction(support=[pp.Disc(1.0), pp.Disc(2.0)]), "support"),
        (pp.SupportFriction(support=pp.Disc(1.0), weight=np.ones(2)), "weight"),
        (pp.Inertia(center=(0.0, np.zeros(2))), "center"),
    ],
)
def test_parameters_that_have_no_place(effect, name):
    with pytest.raises(pp.InvalidValue) as caught:
        pp.wrench_set((effect,), ABOUT)
    assert caught.value.name == name


def test_wrong_wrenches_and_lengths():
    found = pp.wrench_set(FEET, ABOUT)
    for wrench in ([1.0, 2.0], "abc", [[1.0, 2.0, np.nan]], (True, 1.0, 0.5), ["1", 0.0, 0.0]):
        with pytest.raises(pp.InvalidValue, match=r"give \(f_x, f_y, tau\)"):
            found.distance(wrench)
    with pytest.raises(pp.InvalidValue, match="a finite number > 0"):
        found.distance([1.0, 2.0, 3.0], length=0.0)
    with pytest.raises(pp.InvalidValue, match="tolerance: -1"):
        pp.wrench_set(FEET, ABOUT, tolerance=-1.0)


def test_a_small_object_far_from_its_origin():
    corners = 1e-3 * star(np.random.default_rng(6)) + [40.0, -30.0]
    effects = (pp.SupportFriction(support=pp.Points(corners, np.ones(7))),)
    found = pp.wrench_set(effects, about(corners[3], 0.1))
    assert found.foot == pytest.approx(corners[3])
    assert found.radius == pytest.approx(1 / 7)
