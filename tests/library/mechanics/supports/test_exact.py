"""The transcription that supports are tested against, against the defining integrals."""

from __future__ import annotations

import pytest
from mechanics.supports.cases import SUPPORTS
from mechanics.supports.exact import about, exact_moments
from mpmath import mp, mpf

CENTERS = [(0.31, 0.17), (2.3, -1.1)]


def quadrature(chart, limits, c):
    """Mean over a chart of rho and r' / rho; a chart gives position and density."""

    def means(*at):
        x, y, density = chart(*at)
        rho = mp.sqrt((x - c[0]) ** 2 + (y - c[1]) ** 2)
        return [density * each for each in (1, rho, (x - c[0]) / rho, (y - c[1]) / rho)]

    whole, *rest = (
        mp.quad(lambda *at, part=part: means(*at)[part], *limits, maxdegree=8) for part in range(4)
    )
    return [each / whole for each in rest]


def triangle(corners):
    (a, b), (c, d), (e, f) = corners
    return lambda s, t: (
        a + s * (c - a) + s * t * (e - c),
        b + s * (d - b) + s * t * (f - d),
        s,
    )


def on_circle(radius, center):
    return lambda w: (center[0] + radius * mp.cos(w), center[1] + radius * mp.sin(w), 1)


def on_disc(center):
    return lambda s, w: (center[0] + s * mp.cos(w), center[1] + s * mp.sin(w), s)


TURN = [0, mp.pi, 2 * mp.pi]


def charts():
    segment, ring, disc, annulus, corners = (
        SUPPORTS[name][0] for name in ("segment", "ring", "disc", "annulus", "triangle")
    )
    (a, b), (c, d) = segment.start, segment.end
    return {
        "segment": (lambda t: (a + t * (c - a), b + t * (d - b), 1), [[0, 1]]),
        "ring": (on_circle(ring.radius, (0, 0)), [TURN]),
        "disc": (on_disc(disc.center), [[0, disc.radius], TURN]),
        "annulus": (on_disc(annulus.center), [[annulus.inner, annulus.outer], TURN]),
        "triangle": (triangle(corners.vertices), [[0, 1], [0, 1]]),
    }


@pytest.mark.parametrize("name", charts())
def test_closed_forms_are_the_integrals(name):
    c = CENTERS[1]
    chart, limits = charts()[name]
    with mp.workdps(16):
        found = quadrature(chart, limits, tuple(map(mpf, c)))
        exact = about(SUPPORTS[name][0], *map(mpf, c))
        assert max(abs(a - b) for a, b in zip(found, exact, strict=True)) < 1e-12


def test_the_torque_is_that_of_unit_forces_about_the_center_of_pressure():
    support, _ = SUPPORTS["points"]
    for c in CENTERS:
        whole, torque, moment = mpf(0), mpf(0), [mpf(0), mpf(0)]
        pairs = list(zip(support.positions, support.weights, strict=True))
        whole = sum(weight for _, weight in pairs)
        moment = [sum(weight * place[i] for place, weight in pairs) / whole for i in (0, 1)]
        for place, weight in pairs:
            away = [place[i] - mpf(c[i]) for i in (0, 1)]
            rho = mp.hypot(*away)
            lever = [place[i] - moment[i] for i in (0, 1)]
            torque += weight / whole * (lever[0] * away[0] + lever[1] * away[1]) / rho
        assert abs(exact_moments(support, c)[3] - torque) < 1e-14
