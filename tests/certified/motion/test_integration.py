"""The integrators of the certified route against closed forms, their order, and their error estimates."""

from itertools import islice

import pytest
from flint import arb, ctx, fmpq

from planar_pushing.certified import ring
from planar_pushing.certified.balls import PRECISION, Undecided
from planar_pushing.certified.contact.modes import Mode
from planar_pushing.certified.motion.chebyshev import integrals
from planar_pushing.certified.motion.extrapolation import (
    COARSE,
    FINE,
    Scheme,
    advance,
    extrapolated,
)
from planar_pushing.certified.motion.impulses import Body, consistent, force, impact, response
from planar_pushing.certified.motion.inertial import Now, Phase
from planar_pushing.certified.motion.instants import ZERO, rod_of


@pytest.fixture(autouse=True)
def digits():
    with ctx.workprec(PRECISION):
        yield


def circle(state):
    x, y = state
    return -y, x


def error(found, time):
    sine, cosine = time.sin_cos()
    return max(abs(found[0] - cosine), abs(found[1] - sine), key=float)


@pytest.mark.parametrize("row", [1, 2, 3, 5, 8])
def test_the_order_is_twice_the_number_of_the_row(row):
    start, errors = (arb(1), arb(0)), []
    for step in (arb(1) / 4, arb(1) / 8):
        found = next(islice(extrapolated(circle, start, step), row - 1, None))
        errors.append(error(found, step))
    # In one step an error of order p falls like the power p + 1 of its size.
    falls = float((errors[0] / errors[1]).log() / arb(2).log())
    assert falls == pytest.approx(2 * row + 1, abs=0.2)


@pytest.mark.parametrize("scheme", [FINE, COARSE])
def test_ten_digits_beyond_thirty(scheme):
    state, time = (arb(1), arb(0)), arb(0)
    for _ in range(10):
        state, time = advance(circle, state, arb(3) / 4, scheme), time + arb(3) / 4
    assert error(state, time) < 1e-33


def test_the_difference_of_two_schemes_tells_the_error():
    coarse = Scheme(5, arb(2) ** -40, steps=2)
    fine = Scheme(6, arb(2) ** -46)
    a, b = (advance(circle, (arb(1), arb(0)), arb(3), each) for each in (fine, coarse))
    apart = max((abs(x - y) for x, y in zip(a, b, strict=True)), key=float)
    assert error(a, arb(3)) < 2 * apart


def test_a_motion_that_is_not_smooth_is_refused():
    with pytest.raises(Undecided, match="does not converge"):
        advance(lambda state: (abs(state[0]).sqrt(),), (-arb(1) / 7,), arb(2), COARSE)


def test_series_integrate_analytic_functions():
    sine, angle = integrals(lambda x: (x.cos(), 1 / (1 + x * x)), arb(1), arb(0), 60)
    place = arb(1) / 3
    assert abs(sine.at(place) - (place.sin() - arb(1).sin())) < 1e-50
    assert abs(angle.at(place) - (place.atan() - arb(1).atan())) < 1e-40


def test_more_nodes_lessen_the_error_geometrically():
    errors = [
        abs(
            integrals(lambda x: (1 / (1 + x * x),), arb(-1), arb(1), n)[0].at(arb(1)) - arb.pi() / 2
        )
        for n in (30, 40, 50)
    ]
    first, second = float((errors[0] / errors[1]).log()), float((errors[1] / errors[2]).log())
    # The poles at i are on the ellipse whose half axes add up to 1 + sqrt 2.
    assert first == pytest.approx(10 * 0.8814, rel=0.1) == pytest.approx(second, rel=0.1)


MU = arb(2)
RIGHT, LEFT = ((s * MU / (1 + MU * MU).sqrt(), 1 / (1 + MU * MU).sqrt()) for s in (1, -1))
BODY = Body(fmpq(2), fmpq(3), fmpq(1, 2), RIGHT, LEFT)
WEIGHT = fmpq(3, 4)


def phase(mode):
    return Phase(BODY, WEIGHT, ZERO, mode)


def state(**values):
    return Now(*[arb(0)] * 8)._replace(angle=arb(1), **values)


def test_a_ring_that_translates_slides_evenly_to_rest():
    time, speed = arb(1) / 2, arb(1)
    now = Now(*advance(phase(Mode.SEPARATE).by_time, state(rate=speed), time, FINE))
    slowing = arb(WEIGHT) / BODY.mass
    slip = speed * time - slowing * time**2 / 2
    assert (now.spin, now.angle) == (0, 1)
    assert abs(now.rate - (speed - slowing * time)) < 1e-40
    assert abs(now.slip - slip) < 1e-40
    assert abs(now.rubbed - WEIGHT * slip) < 1e-40


def test_a_slider_that_turns_about_its_contact_stops_evenly():
    spin, f_and_t = arb(1) / 3, ring.profile(arb(1) / 2)
    # Spin ratio R / l, friction W (t + l f) about the contact, moment m rho^2 + m l^2.
    slowing = WEIGHT * (f_and_t[1] + 2 * f_and_t[0]) / (BODY.moment + BODY.mass * 4)
    rest = phase(Mode.STICK).rest(state(spin=spin), FINE)
    assert abs(rest.time - spin / slowing) < 1e-34
    assert abs(rest.angle - 1 - spin**2 / slowing / 2) < 1e-34
    kinetic = (BODY.moment + BODY.mass * 4) * spin**2 / 2
    assert abs(rest.rubbed - kinetic) < 1e-34
    assert (rest.work, rest.slip, rest.lost) == (0, 0, 0)


def test_a_mode_that_ends_is_refused():
    with pytest.raises(Undecided, match="the mode SLIP_LEFT ends"):
        phase(Mode.SLIP_LEFT).modes(state(rate=arb(1), spin=arb(1)))


def test_a_stick_takes_the_motion_of_the_contact_away():
    rod, motion = rod_of(BODY.length, arb(1)), (arb(2), arb(-1))
    change = response(BODY, rod, force(BODY, rod, Mode.STICK, motion))
    assert max(abs(change[0] + 2), abs(change[1] - 1), key=float) < 1e-50


def test_an_impact_takes_the_modes_of_a_fence_that_meets_the_contact():
    rod = rod_of(BODY.length, arb.pi() / 2)
    # Along the rod the mass alone counts; across it the rod makes the slider lighter.
    assert consistent(BODY, rod, arb(0), (arb(0), arb(-1))) == [Mode.STICK]
    assert consistent(BODY, rod, arb(0), (arb(0), arb(1))) == [Mode.SEPARATE]
    hit = impact(BODY, rod, (arb(0), arb(-1)), "keep-contact")
    assert hit.mode is Mode.STICK
    assert abs(hit.lost - arb(3) / 2) < 1e-50
    skids = impact(BODY, rod, (arb(100), arb(-1)), "keep-contact")
    assert skids.mode is Mode.SLIP_RIGHT
    assert skids.slip > 0
