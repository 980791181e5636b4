"""Feet with inertia over time: a thousand drawn runs, scenes with known angles, pushers that return."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq
from simulation.feet_runs import LAYOUTS, MOTIONS, feet_run, flush_feet_run
from simulation.runs import final, imbalance, largest_energy
from simulation.scenes import STOPS

import planar_pushing as pp

pytestmark = [
    pytest.mark.filterwarnings("ignore::planar_pushing.EarlyEndWarning"),
    pytest.mark.filterwarnings("ignore:(radius|gyration_radius):planar_pushing.SceneWarning"),
]

#: A run takes at most so many evaluations; a foot that begins to move slowly makes some motions stiff.
EVALUATIONS = 10_000_000
#: Known defects by layout, motion and seed: steps part from the finger, which slips on without end.
DEFECTS = {("collinear", "constant", 20): ["differs from the time-stepping method"]}
#: Steps of the time-stepping method, whose results are extrapolated, and how many times more where these
#: differ from the motion between events.
STEPS, FINER = (2000, 4000), 8
#: Degrees.
AGREE = 0.001


def drawn(layout, motion, seed):
    return flush_feet_run(motion, seed) if layout == "flush" else feet_run(layout, motion, seed)


def jams(run, log):
    """Whether a force on an edge of the friction cone would push the contact into the pusher at the end.

    Then no force may keep the contact closed while it slips (Painleve).
    """
    (inertia,) = (each for each in run.scene.effects if isinstance(each, pp.Inertia))
    mu = getattr(run.scene.contact, "friction_coefficient", math.inf)
    psi = math.radians(float(log.rod_angle[-1]))
    turn = psi - run.scene.slider.rod_angle if "parted" in log else 0.0
    along = float(log.contact_position[-1]) if "parted" in log else 0.0
    tangent = np.array([math.cos(turn), math.sin(turn)])
    normal = np.array([-tangent[1], tangent[0]])
    turned = np.array([[math.cos(psi), -math.sin(psi)], [math.sin(psi), math.cos(psi)]])
    x, y = inertia.center
    center = turned @ (x + run.scene.slider.rod_length, y) - along * tangent
    lever = np.array([center[1], -center[0]]) / inertia.gyration_radius  # of a force at the contact
    edges = (
        (tangent, -tangent) if mu == math.inf else (normal + mu * tangent, normal - mu * tangent)
    )
    return any(edge @ normal + (edge @ lever) * (normal @ lever) <= 1e-9 for edge in edges)


def defects(run):
    """What is wrong with a run: its end, its number of evaluations, its energy, its gap."""
    log = run.log()
    stopped = log.attrs["stopped"]
    painleve = stopped == "no contact mode is consistent" and jams(run, log)
    floor = 1e-4 * run.weight * run.size  # a slider at rest has rounding errors only
    off = imbalance(log).max() / max(largest_energy(log), floor)
    gap = log.gap.where(~log.parted, 0.0) if "parted" in log else log.gap
    reports = {
        stopped: stopped in ("", STOPS) or painleve,
        f"{log.evaluations.values.max()} evaluations": log.evaluations.values.max() <= EVALUATIONS,
        f"energy is off by {off:.1e}": off <= 1e-9,
        f"gap of {gap.values.min():.1e}": gap.values.min() >= -1e-9 * run.size,
    }
    return log, [what for what, holds in reports.items() if not holds]


def unique_part(run, log):
    """The run as far as the motion is unique, and its last rod angle."""
    end = float(log.time[-1]) if not log.attrs["stopped"] else 0.999 * float(log.time[-1])
    chosen = log.time.values[log.outcome.values == pp.Outcome.AMBIGUOUS]
    end = min([end, *(0.999 * chosen)])
    if end == run.duration:
        return end, float(log.rod_angle[-1])
    if end <= 0:
        return end, None
    again = run.log(duration=end)
    if again.attrs["stopped"] and jams(run, again):
        # Rounding decides whether a motion goes on beyond a jam, at which force and acceleration vanish.
        return unique_part(run, again)
    return end, float(again.rod_angle[-1])


def angles_by_steps(run, end, finer=1):
    """Rod angles of the time-stepping method at the end, by steps of two lengths."""
    return [
        float(run.log(duration=end, samples=2, method="time-stepping", step=end / n / finer).rod_angle[-1])
        for n in STEPS
    ]  # fmt: skip


def agrees(run, log):
    """Whether both methods have the same rod angle at the end, within the error of the steps.

    The angles by steps are extrapolated. After an impact, for which a step is late by any part of its
    length, their error does not fall evenly, and the scatter of four of them stands for it.
    """
    end, angle = unique_part(run, log)
    if angle is None:
        return True
    rough, fine = stepped = angles_by_steps(run, end)
    if abs(angle - 2 * fine + rough) <= max(AGREE, 2 * abs(fine - rough)):
        return True
    finer = angles_by_steps(run, end, FINER)
    return abs(angle - finer[-1]) <= max(AGREE, np.ptp([*stepped, *finer]))


def check_runs(layouts, motion, seeds, stepped=lambda seed: True):
    """Every run is sound, and those with a seed that is `stepped` agree with the time-stepping method."""
    failures = {}
    for layout in layouts:
        for seed in seeds:
            run = drawn(layout, motion, seed)
            log, wrong = defects(run)
            if not wrong and stepped(seed) and not agrees(run, log):
                wrong = ["differs from the time-stepping method"]
            if wrong:
                failures[layout, motion, seed] = wrong
    drawn_runs = {(layout, motion, seed) for layout in layouts for seed in seeds}
    assert failures == {name: wrong for name, wrong in DEFECTS.items() if name in drawn_runs}


KINDS = (*LAYOUTS, "flush")


@pytest.mark.parametrize("motion", MOTIONS)
def test_a_hundred_runs(motion):
    check_runs(KINDS, motion, range(2), stepped=lambda seed: seed == 0)


@pytest.mark.slow
@pytest.mark.parametrize("layout", KINDS)
@pytest.mark.parametrize("motion", MOTIONS)
def test_a_thousand_runs(motion, layout):
    check_runs([layout], motion, range(2, 21))


def test_a_foot_leaves_although_friction_could_hold_it():
    # Held, the foot would end the motion: the contact neither keeps its force nor opens.
    check_runs(["collinear"], "sines", [7_700_000], stepped=lambda _: True)


def test_a_contact_closes_where_a_foot_stops_and_the_slip_does_too():
    check_runs(["collinear"], "thrown", [1_100_006], stepped=lambda _: True)


# --- Known angles --------------------------------------------------------------------------------

TRIANGLE = [(1.0, 0.0), (-0.5, 0.8), (-0.5, -0.8)]
TABLE = [(1, 1), (-1, 1), (-1, -1), (1, -1)]


def on_feet(feet, length, psi, mu, *, weights=None, weight=1.0, **inertia):
    """A slider on feet, equal ones by default."""
    support = pp.Points(feet, np.ones(len(feet)) if weights is None else weights)
    effects = pp.SupportFriction(support=support, weight=weight), pp.Inertia(**inertia)
    slider = pp.Slider(rod_length=length, rod_angle=psi)
    return pp.Scene(slider=slider, contact=pp.Coulomb(mu), effects=effects)


def pushed(scene, velocity, duration, **options):
    return pp.simulate(scene, pp.Pusher(velocity=velocity), duration=duration, samples=5, **options)


def passes_a_foot():
    scene = on_feet(TRIANGLE, 0.9, 0.9, 0.7, mass=1.0, gyration_radius=0.7)
    return pushed(scene, (-0.2, 0.8), 2.0)


def table_passes_a_foot():
    scene = on_feet(TABLE, 1.3, 2.0, 0.5, mass=1.0, gyration_radius=0.7)
    return pushed(scene, (0.3, 0.5), 3.0)


def pivots_about_a_foot():
    scene = on_feet(TRIANGLE, 1.3, 0.9, 0.6, mass=1.0, gyration_radius=0.7)
    return pushed(scene, (-0.2, 0.5), 3.0)


def free_table():
    scene = on_feet(TABLE, 1.0, 1.2, 0.5, mass=0.5, gyration_radius=1.0)
    return pushed(scene, (0.0, 0.0), 10.0, twist=(0.0, 0.3, 0.7), gap=50.0)


def at_origin(point, feet, weights, weight, velocity, duration, gyration_radius, center, *loads):
    """The log of an object of mass 1, at the origin of the world at first."""
    effects = (
        pp.SupportFriction(support=pp.Points(feet, weights), weight=weight),
        pp.Inertia(mass=1.0, gyration_radius=gyration_radius, center=center), *loads,
    )  # fmt: skip
    scene = pp.scene_at(point, (0, 1), effects=effects, contact=pp.Coulomb(0.5))
    return pushed(scene, velocity, duration, object_pose=(0, 0, 0))


def pulled_about_a_foot():
    feet = [(1.53, 1.44), (1.81, 1.34), (1.54, 1.04), (0.93, 0.64)]
    load, center = pp.Load(force=(0.408, -1.2)), (0.942, 0.625)
    return at_origin((0, 0), feet, [0.85, 1.79, 1.0, 1.47], 1.51, (0, -5), 1.0, 0.48, center, load)


def rubbed_from_rest():
    feet = [(1.4, 0.8), (0.6, 0.4), (1.0, -1.3)]
    return at_origin((1.2, -1.8), feet, [1, 1, 0.6], 1.0, lambda t: (0.2, t), 0.5, 0.7, (1.0, 0.16))


def ends_in_ever_shorter_bounces():
    """A slip opens and closes in a geometric series until a foot is at rest."""
    feet = [(-0.3810629363, -0.5763179572), (0.7105402424, 0.0992652645), (0.04281973, 0.3088346047),
            (-0.0148618602, 0.9428272926), (-0.6598382643, -0.2469205952)]  # fmt: skip
    scene = on_feet(
        feet, 1.602838026220501, 1.3173934520419301, 0.4467810625986093,
        weights=[1.3896041012, 1.7563594076, 1.1085649908, 1.5109456676, 0.4113433378],
        mass=0.28653860198731906, gyration_radius=0.3957054191896016,
        center=(0.32784895115392476, -0.38960716382424),
    )  # fmt: skip
    rate = 1.8919377242174358

    def velocity(t):
        return (
            0.1923236124764983 * math.sin(rate * t + 4.579770110117135),
            0.17772722126056226
            * (0.5485793030165401 + math.sin(rate * 1.1446462416688241 * t + 1)),
        )

    return pushed(scene, velocity, 3.0)


def small_tripod():
    feet = [(-0.04022511887814856, 0.06966990589695331), (-0.04022511887814856, -0.06966990589695331),
            (0.08045023775629712, 0.0)]  # fmt: skip
    scene = on_feet(
        feet, 0.10373194899466921, 2.1188423954496454, 0.7238360434445323, weight=9.305980582326818,
        mass=2.578827194216048, gyration_radius=0.04429447918461846,
    )  # fmt: skip
    return pushed(scene, (0.11031564392395526, 0.22954136392490956), 0.47384271334032535)


#: Angle in degrees of the rod, or of the object, at the end by Radau's method with the friction of feet
#: smoothed at two speeds, the second a tenth of the first; or by extrapolated time-stepping, as "stepped".
#: Each has an error of half a digit, and of a quarter of the difference of the two.
KNOWN = {
    "passes a foot": (passes_a_foot, "rod_angle", (3.17989, 3.17991), 5e-6),
    "table passes a foot": (table_passes_a_foot, "rod_angle", (151.63324, 151.63330), 5e-6),
    "pivots about a foot": (pivots_about_a_foot, "rod_angle", (10.18042, 10.18055), 5e-6),
    "free table": (free_table, "rod_angle", (74.198230, 74.198230), 5e-7),
    "pulled about a foot": (pulled_about_a_foot, "object_angle", (12.1122595, 12.1113918), 5e-8),
    "rubbed from rest, stepped": (rubbed_from_rest, "object_angle", (2.7305, 2.7305), 5e-5),
    "ever shorter bounces": (ends_in_ever_shorter_bounces, "rod_angle", (69.36294, 69.36471), 5e-6),
    "small tripod": (small_tripod, "rod_angle", (160.10450, 160.10425), 5e-6),
    "small tripod, stepped": (small_tripod, "rod_angle", (160.1042197, 160.1042197), 5e-7),
}


@pytest.mark.parametrize("name", KNOWN)
def test_a_known_angle(name):
    simulate, variable, (rough, fine), digits = KNOWN[name]
    log = simulate()
    assert log.attrs["stopped"] == ""
    assert float(log[variable][-1]) == pytest.approx(
        fine, rel=0, abs=digits + abs(fine - rough) / 4
    )


def test_a_free_table_stops_when_it_is_known_to():
    """By 0.3281, by Radau's method."""
    log = free_table()
    stops = log.time.values[log.event.values == pp.Event.SLIDER_STOPS]
    assert stops == pytest.approx([0.3281], abs=5e-5)
    assert not final(log, "twist").any()


# --- Pushers that return -------------------------------------------------------------------------


@pytest.mark.parametrize(
    "inertia", [(), (pp.Inertia(mass=0.3, gyration_radius=0.7),)], ids=["slow", "heavy"]
)
@pytest.mark.parametrize(
    "support", [pp.Ring(), pp.Polygon(TABLE), pp.Points(TABLE)], ids=["ring", "square", "feet"]
)
def test_a_pusher_meets_a_slider_at_rest_where_it_left_it(support, inertia):
    """It is highest where its velocity is zero, and returns there after the slider has stopped."""
    slider = pp.Slider(rod_length=1.0, rod_angle=1.3)
    effects = (pp.SupportFriction(support=support), *inertia)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.4), effects=effects)

    def height(t):
        return 0.1 * t + math.sin(3 * t) / 6

    push = (scene, lambda t: (0.3 * math.sin(2 * t), 0.1 + 0.5 * math.cos(3 * t)), 3.0)
    log = pushed(*push)
    before = log.isel(time=(log.gap.values > 0) & (log.time.values < 2.0)).isel(time=-1)
    assert not before.twist.any()
    met = float(before.gap) + height(float(before.time))
    touches = log.time.values[log.event.values == pp.Event.TOUCHES]
    (touch,) = touches[touches > 2.0]
    assert touch == pytest.approx(brentq(lambda t: height(t) - met, 2.0, 2.5), abs=1e-9)
    if not inertia:
        assert met == pytest.approx(height(math.acos(-0.2) / 3), abs=1e-9)
    stepped = [
        float(pushed(*push, method="time-stepping", step=3 / n).rod_angle[-1]) for n in STEPS
    ]
    error = 5 * abs(
        stepped[1] - stepped[0]
    )  # a step is late for the impact by any part of its length
    assert final(log, "rod_angle") == pytest.approx(stepped[1], rel=0, abs=error)
