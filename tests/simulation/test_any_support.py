"""Motion over time of any support and any center of mass: against the ring, and by its energy."""

import sys

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import planar_pushing as pp
from simulation.runs import check, final, run, run_slow_uncompiled

#: A ring that takes the general route.
RING = pp.Composite([(1.0, pp.Ring(1.0))])
SQUARE = pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)])
TRIPOD = pp.Points([(1, 0), (-0.5, np.sqrt(0.75)), (-0.5, -np.sqrt(0.75))], [1 / 3] * 3)
HEAVY, ASIDE = (pp.Inertia(mass=0.7, gyration_radius=0.9, center=c) for c in ((0, 0), (0.2, 0.1)))
METHODS = {
    "event-driven": {"method": "event-driven"},
    "time-stepping": {"method": "time-stepping", "step": 0.02},
}

MASSES = {"friction": (), "both": (HEAVY,), "offset": (ASIDE,)}


def runs(*names):
    """Masses and a method."""
    return pytest.mark.parametrize(
        ("masses", "options"),
        [
            pytest.param(MASSES[name], options, id=f"{name}-{method}", marks=speed(name, method))
            for name in names for method, options in METHODS.items()
        ],
    )  # fmt: skip


def speed(name, method="time-stepping"):
    """Sets with inertia take long to compile, and so do steps."""
    return () if (name, method) == ("friction", "event-driven") else pytest.mark.slow


def test_inertia_and_steps_without_the_compiler():
    said = run_slow_uncompiled(__file__)
    ran = [f"{name}-{method}" for name in MASSES for method in METHODS if speed(name, method)]
    assert all(f"{each}] PASSED" in said for each in ran)


def simulated(friction, masses, **options):
    """A push that sticks first and slips then."""
    scene = pp.Scene(
        slider=pp.Slider(rod_length=2.0, rod_angle=1.2, radius=1.0), contact=pp.Coulomb(0.4),
        effects=(friction, *masses),
    )  # fmt: skip
    return run(scene, (0.3, 1.0), 0.8, samples=5, **options)


@runs("friction", "both")
def test_a_ring_moves_as_the_ring(masses, options):
    ring = simulated(pp.RingFriction(), masses, **options)
    other = simulated(pp.SupportFriction(support=RING), masses, **options)
    assert {int(mode) for mode in ring.mode} >= {pp.ContactMode.STICK, pp.ContactMode.SLIP_LEFT}
    assert np.array_equal(other.mode, ring.mode)
    for name in ("time", "rod_angle", "position", "slip", "twist", "force", "work"):
        # The last entry before an event lies as near to it as the tolerance says.
        assert np.allclose(other[name], ring[name], rtol=1e-8, atol=1e-8), name


@runs("friction", "both", "offset")
@pytest.mark.parametrize("support", [SQUARE, TRIPOD], ids=["square", "tripod"])
def test_the_work_of_the_fence_is_stored_or_dissipated(support, masses, options):
    log = check(simulated(pp.SupportFriction(support=support), masses, **options))
    assert log.attrs["stopped"] == ""
    assert final(log, "work") > 0.1


@pytest.mark.parametrize("name", [pytest.param(n, marks=speed(n)) for n in ("friction", "offset")])
def test_steps_converge_to_the_event_driven_motion(name):
    friction, masses = pp.SupportFriction(support=SQUARE), MASSES[name]
    exact = final(simulated(friction, masses), "rod_angle")
    errors = [
        abs(final(simulated(friction, masses, method="time-stepping", step=step), "rod_angle") - exact)
        for step in (0.02, 0.01, 0.005)
    ]  # fmt: skip
    assert errors[0] / errors[2] == pytest.approx(4.0, rel=0.25)


def pushed(psi, mu):
    """A tripod that slips."""
    slider = pp.Slider(rod_length=2.0, rod_angle=psi, radius=1.0)
    effects = (pp.SupportFriction(support=TRIPOD),)
    return pp.Scene(slider=slider, contact=pp.Coulomb(mu), effects=effects)


@pytest.mark.parametrize(
    ("psi", "mu", "velocity", "duration"),
    [(2.0, 0.2, (-0.2, 1.0), 2.0), (1.2, 0.3, (0.3, 1.0), 2.5)],
    ids=["right", "left"],
)
def test_a_pivot_starts_at_an_event(psi, mu, velocity, duration):
    log = check(run(pushed(psi, mu), velocity, duration, samples=2))
    assert log.sizes["time"] == 3
    event, angle = float(log.time[1]), np.deg2rad(float(log.rod_angle[1]))
    heading = np.arctan2(*velocity[::-1])
    for side in (-1, 1):
        turned = np.sign(log.rod_angle[-1] - log.rod_angle[0]).item() * side
        (slip,) = pp.solve(pushed(angle + 1e-9 * turned, mu), heading)
        assert (slip.pivot >= 0) == (side > 0)

    def turns(_, state):
        (slip,) = pp.solve(pushed(state[0], mu), heading, np.hypot(*velocity))
        return [slip.twist[2]]

    state, rtol = [psi], {"method": "DOP853", "rtol": 1e-12, "atol": 1e-12}
    for span in ((0.0, event), (event, duration)):
        state = solve_ivp(turns, span, state, **rtol).y[:, -1]
    assert final(log, "rod_angle") == pytest.approx(np.rad2deg(state[0]), abs=1e-8)


@runs("friction", "offset")
def test_runs_neither_keep_nor_drop_references_to_the_arrays_of_a_support(masses, options):
    friction = pp.SupportFriction(support=TRIPOD)
    simulated(friction, masses, **options)
    before = [sys.getrefcount(array) for array in arrays_of(friction)]
    for _ in range(3):
        simulated(friction, masses, **options)
    assert [sys.getrefcount(array) for array in arrays_of(friction)] == before
    assert len(before) > 1


def arrays_of(friction):
    """The arrays that the core has of a support, which are the same ones in every scene."""
    slider = pp.Slider(rod_length=1.0, rod_angle=1.0, radius=1.0)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=(friction,))
    (entry,) = scene.rows.entries
    return [entry.table.data, entry.table.memory]
