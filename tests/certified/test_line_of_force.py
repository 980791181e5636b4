"""Spin ratio, motion and limit curve: published values, the second route, and exact ties."""

import math

import pytest
from flint import arb, ctx, fmpq

from planar_pushing.certified import cones, line_of_force, ring
from planar_pushing.certified.balls import PRECISION
from planar_pushing.certified.cones import motion_cone, pulls, slips_while_pushing
from planar_pushing.certified.integrals import printed
from planar_pushing.certified.setting import FRICTION, INERTIA, Effects, Slider, edge, heading

HALF = fmpq(1, 2)


@pytest.fixture(autouse=True)
def _precision():
    with ctx.workprec(PRECISION):
        yield


def agrees(ball, digits):
    """The published digits of a number: all are right, the last one is rounded."""
    text = digits.lstrip("-")
    places = len(text.split(".")[1]) if "." in text else 0
    return abs(ball - arb(digits)) <= arb(10) ** -places and ball.rad() < 1e-30


CONES = [
    (2, 2.0, ("-20.038457551638", "140.16416973393"), ("-14.036243467926", "138.81407483429")),
    (
        0.5,
        math.inf,
        ("-9.9905001844019", "170.0094998156"),
        ("-6.3401917459099", "173.65980825409"),
    ),
    (1, math.inf, ("-21.298139595247", "158.70186040475"), ("-18.434948822922", "161.56505117708")),
    (2, math.inf, ("-31.389608677922", "148.61039132208"), ("-33.69006752598", "146.30993247402")),
    (5, math.inf, ("-41.160027835239", "138.83997216476"), ("-42.797401838234", "137.20259816177")),
]


@pytest.mark.parametrize(("length", "mu", "friction", "inertia"), CONES)
def test_published_cones(length, mu, friction, inertia):
    slider = Slider.of(length)
    for effects, edges in ((Effects.FRICTION, friction), (Effects.INERTIA, inertia)):
        cone = motion_cone(slider, effects, mu)
        assert agrees(cone.right, edges[0])
        assert agrees(cone.left, edges[1])
    both = motion_cone(slider, Effects.BOTH, mu)
    alone = [motion_cone(slider, each, mu) for each in (Effects.FRICTION, Effects.INERTIA)]
    assert both.right.overlaps(arb.min(*(each.right for each in alone)))
    assert both.left.overlaps(arb.max(*(each.left for each in alone)))


def test_the_conservative_cone_of_figure_12():
    cone = cones.conservative_cone(Slider.of(5))
    assert cone.right == -45
    assert agrees(cone.left, "142.06291516547347")
    exact = motion_cone(Slider.of(5), Effects.BOTH, math.inf)
    assert agrees(exact.right, "-42.797401838234")
    assert agrees(exact.left, "138.83997216476")


@pytest.mark.parametrize("length", [0, 0.25, 0.5, 1, 2, 3, 5, 10])
@pytest.mark.parametrize("mu", [1.0, 2.0, math.inf])
def test_the_conservative_cone_contains_every_motion(length, mu):
    slider = Slider.of(length)
    bound, exact = cones.conservative_cone(slider, mu), motion_cone(slider, Effects.BOTH, mu)
    assert not bound.right > exact.right
    assert not bound.left < exact.left


THRESHOLDS = [("inertia", 1.5, 1.5 + 2**-50), ("support_friction", 1.269875426, 1.269875427)]


@pytest.mark.parametrize(("effects", "below", "above"), THRESHOLDS)
def test_pulling_threshold(effects, below, above):
    slider = Slider.of(2)
    assert not pulls(slider, Effects(effects), below)
    assert pulls(slider, Effects(effects), above)


def test_an_edge_along_the_fence_is_exactly_zero():
    assert motion_cone(Slider.of(2), Effects.INERTIA, 1.5).right.is_zero()
    assert motion_cone(Slider.of(2, 135), Effects.INERTIA, 1.5).left.overlaps(arb(180))
    assert not pulls(Slider.of(2, 135), Effects.INERTIA, 1.5)


@pytest.mark.parametrize("effects", list(Effects))
@pytest.mark.parametrize(("length", "angle"), [(0, 45), (2, 90), (0, 90)])
def test_aligned_cones_neither_pull_nor_slip(effects, length, angle):
    slider = Slider.of(length, angle)
    assert not pulls(slider, effects, math.inf)
    assert not slips_while_pushing(slider, effects, math.inf)


@pytest.mark.parametrize("mu", [0.0, 0.5, 5.0])
def test_finite_friction_slips_for_some_push(mu):
    assert slips_while_pushing(Slider.of(2, 90), Effects.BOTH, mu)


@pytest.mark.parametrize("length", [0.01, 0.25, 1, 2, 10])
@pytest.mark.parametrize("force_angle", [0, 44, 60, 133])
def test_friction_roots_are_certified_by_the_second_route(length, force_angle):
    slider, force = Slider.of(length), heading(force_angle)
    k = abs(line_of_force.spin_ratio(slider, force, FRICTION))
    arm = abs(slider.rod_length * arb.sin_pi_fmpq((slider.rod_angle - force_angle) / 180))
    with ctx.workprec(PRECISION):
        (f_low, t_low), (f_high, t_high) = printed(k.lower()), printed(k.upper())
    assert t_low - arm * f_low < 0  # Eq. (7)
    assert t_high - arm * f_high > 0
    assert k.rad() < arb(10) ** -36 * k


def test_a_tangent_line_of_force_turns_about_the_ring():
    for share in (FRICTION, HALF, INERTIA):
        assert line_of_force.spin_ratio(Slider.of(2), heading(15), share).overlaps(arb(1))
        assert line_of_force.spin_ratio(Slider.of(1), heading(-45), share) == 1


@pytest.mark.parametrize("effects", list(Effects))
@pytest.mark.parametrize("force_angle", [45, 225])
def test_forces_along_the_rod_translate(effects, force_angle):
    size, k = line_of_force.limit_point(
        Slider.of(3, weight=2, mass=5), effects, heading(force_angle)
    )
    assert k == 0
    assert size == {Effects.FRICTION: 2, Effects.INERTIA: 5, Effects.BOTH: 7}[effects]


@pytest.mark.parametrize("effects", list(Effects))
@pytest.mark.parametrize("force_angle", [135, 315])
def test_forces_across_the_rod_move_the_contact_along_themselves(effects, force_angle):
    force = heading(force_angle)
    for share in effects.shares:
        assert line_of_force.motion_angle(Slider.of(2), force, share) == force_angle


@pytest.mark.parametrize("length", [0.5, 2])
@pytest.mark.parametrize("force_angle", [0, 80, 200])
def test_limit_curves_balance_forces_and_energy(length, force_angle):
    slider = Slider.of(length, 30, weight=3, mass=2, gyration_radius=0.5)
    size, k = line_of_force.limit_point(slider, Effects.BOTH, heading(force_angle))
    speed = (1 + k * k / 4).rsqrt()
    force, torque = ring.profile(abs(k))
    arm = abs(slider.rod_length * arb.sin_pi_fmpq((slider.rod_angle - force_angle) / 180))
    assert size.overlaps(3 * force + 2 * speed)
    assert (arm * size).overlaps(3 * torque + 2 * speed * abs(k) / 4)


def test_the_ellipse_has_the_half_lengths_of_section_4():
    slider = Slider.of(2, mass=3)
    along, _ = line_of_force.limit_point(slider, Effects.INERTIA, heading(45))
    across, _ = line_of_force.limit_point(slider, Effects.INERTIA, heading(135))
    assert along == 3
    assert across.overlaps(3 / arb(5).sqrt())


def test_motion_centers():
    slider = Slider.of(2)
    x, y = line_of_force.motion_center(slider, heading(45), arb(0))
    assert (float(x), float(y)) == (-math.inf, math.inf)
    x, y = line_of_force.motion_center(slider, heading(0), arb(2))
    assert x == 0
    assert y == 0.5


@pytest.mark.parametrize("mu", [1e2, 1e4, 1e6])
def test_large_friction_converges_like_its_inverse(mu):
    for effects in Effects:
        gap = motion_cone(Slider.of(2), effects, mu).right
        gap -= motion_cone(Slider.of(2), effects, math.inf).right
        assert 0 < gap * mu < 180


def test_edges_of_the_friction_cone():
    assert edge(math.inf, 1).degrees == 0
    assert edge(math.inf, -1).degrees == 180
    assert edge(0.0, 1).degrees == edge(0.0, -1).degrees == 90
    assert edge(1.0, 1).degrees.overlaps(arb(45))
