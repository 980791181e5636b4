"""Motion over time to thirty digits: two orders, energies, the library, and what is refused."""

from functools import cache

import numpy as np
import pytest
from flint import arb, ctx

from planar_pushing.scenes.files import load_scene_file
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.scenes.simulate import simulate_file
from pulling_by_pushing.oracle.balls import PRECISION, Undecided
from pulling_by_pushing.oracle.logs import log as oracle_log
from pulling_by_pushing.oracle.logs.course import Scheme
from pulling_by_pushing.oracle.logs.log import log_values

#: Differences of the library, whose runs have a relative tolerance of 1e-10. The time of a pivot is late,
#: because its foot is taken to hold only where it has a relative 1e-9 of its share to spare.
ALLOWED = {"rod_angle": 2e-9, "force": 1e-9, "spin_ratio": 1e-9, "time": 5e-9}
OTHERS = 2e-10


@cache
def scene_file(name):
    return load_scene_file(f"workflow/scenes/{name}.yaml")


def changed(name, samples=17, **parts):
    """A shipped scene with other values in some of its parts, and few stored instants.

    By default they are at the ends of the longest steps of the oracle, so that they cut none of these.
    """
    content = scene_file(name).model_dump()
    for part, values in parts.items():
        content[part] = {**content[part], **values} if isinstance(values, dict) else values
    if content["simulate"] is not None:
        content["simulate"] = {**content["simulate"], "samples": samples}
    return SceneFile.model_validate(content)


def fence(*pieces):
    pusher = [{"time": time, "angle": angle, "speed": speed} for time, angle, speed in pieces]
    return {"pusher": pusher, "pusher_angle": None, "pusher_speed": None}


QUADRUPED = {
    "shape": "points",
    "positions": [[-0.8, -0.6], [0.8, -0.6], [0.8, 0.6], [-0.8, 0.6]],
    "weights": [1, 2, 1, 1],
}
DISC = {"shape": "disc", "radius": 0.9}
SQUARE = {"shape": "polygon", "vertices": [[-1, -1], [1, -1], [1, 1], [-1, 1]]}
RING = {"type": "ring_friction", "weight": 3.0}


def mass_aside(duration):
    mass = {"type": "inertia", "mass": 2.0, "gyration_radius": 0.6, "center": (0.1, 0.05)}
    return changed(
        "pulling_with_inertia", slider={"radius": 0.9}, effects=[RING | {"weight": 1.5}, mass],
        simulate={"duration": duration, **fence((0.0, -10.0, 1.2), (0.4, -10.0, 0.0))},
    )  # fmt: skip


#: Radius, weight, speed and mass are not 1. The fence leaves the slider and meets it again; the slider
#: pivots about a foot, while the slip reverses; it lands with support friction, sticks and slips; it comes
#: to rest.
SCENES = {
    "pulling": changed("pulling", samples=7, simulate={"duration": 0.75}),  # as "other units"
    "pulling_lost": changed("pulling_lost"),
    "slipping": changed("slipping", simulate={"duration": 1.0}),
    "impact": changed("impact"),
    "pulling_with_inertia": changed("pulling_with_inertia"),
    "rest": changed("pulling_with_inertia", samples=2),
    "tripod": changed("tripod", simulate={"duration": 1.2}),
    "other units": changed(
        "pulling",
        slider={"rod_length": 1.4, "rod_angle": 40.0, "radius": 0.7},
        contact={"friction_coefficient": 1.5},
        effects=[RING],
        simulate={"duration": 1.2, **fence((0.0, 20.0, 1.7), (0.5, -15.0, 0.6))},
    ),
    "met again": changed(
        "pulling_lost",
        slider={"rod_length": 1.4, "rod_angle": 40.0, "radius": 0.7},
        contact={"friction_coefficient": 1.5},
        effects=[RING],
        simulate={
            "duration": 0.9,
            **fence((0.0, 60.0, 1.7), (0.4, -80.0, 0.6), (0.7, 90.0, 1.3)),
        },
    ),
    "square": changed(
        "tripod",
        contact={"friction_coefficient": 0.2},
        effects=[{"type": "support_friction", "weight": 2.5, "support": SQUARE}],
        simulate={"duration": 0.2, **fence((0.0, 80.0, 1.3))},
    ),
    "quadruped": changed(
        "tripod",
        slider={"rod_length": 1.9, "rod_angle": 65.0, "radius": None},
        contact={"friction_coefficient": 0.2},
        effects=[{"type": "support_friction", "weight": 2.5, "support": QUADRUPED}],
        simulate={"duration": 1.2, **fence((0.0, 120.0, 0.8))},
    ),
    "landing": changed(
        "impact",
        effects=[
            {"type": "ring_friction", "weight": 0.4},
            {"type": "inertia", "mass": 1.5, "gyration_radius": 0.7},
        ],
        simulate={"duration": 1.0, "initial_gap": 0.2},
    ),
    "mass aside": mass_aside(0.5),
    "mass aside that comes to rest": mass_aside(1.2),
}  # fmt: skip


#: Others pull, pivot and move with inertia, or in such units, too.
LONG = (
    "mass aside that comes to rest", "other units", "pulling", "pulling_with_inertia", "rest", "tripod"
)  # fmt: skip


@pytest.fixture(
    scope="module",
    params=[pytest.param(x, marks=pytest.mark.slow if x in LONG else ()) for x in SCENES],
)
def name(request):
    """Tests of one scene are run in a row."""
    return request.param


@cache
def log(name):
    return simulate_file(SCENES[name])


@cache
def values(name):
    return log_values(SCENES[name].model_dump(), log(name).time.values)


def flat(rows):
    return [part for row in rows for part in flat(row)] if isinstance(rows, list) else [rows]


def test_every_value_of_the_log_is_that_of_the_library(name):
    assert set(values(name)) == {*log(name).data_vars, "time"} - {"evaluations", "impulse"}
    for variable, (dims, rows) in values(name).items():
        stored = log(name)[variable]
        assert dims == stored.dims
        if isinstance(flat(rows)[0], arb):
            numbers = np.array([float(number.mid()) for number in flat(rows)])
            assert numbers == pytest.approx(
                stored.values.ravel(), rel=0, abs=ALLOWED.get(variable, OTHERS)
            )
        else:
            assert flat(rows) == stored.values.ravel().tolist()


def test_two_orders_agree_to_thirty_digits(name):
    for _, rows in values(name).values():
        numbers = [number for number in flat(rows) if isinstance(number, arb)]
        size = max((abs(number) for number in numbers), default=arb(0))
        assert all(number.rad() <= 1e-28 * size for number in numbers)


def test_energies_balance(name):
    rows = {variable: rows for variable, (_, rows) in values(name).items()}
    thrown = SCENES[name].simulate.initial_twist is not None
    with ctx.workprec(PRECISION):
        energy = rows["kinetic_energy"][0] if thrown else arb(0)
        for i, work in enumerate(rows["work"]):
            lost = sum(rows["dissipated"][i], rows["contact_dissipated"][i])
            assert abs((energy + work - lost - rows["kinetic_energy"][i]).mid()) < 1e-29


@pytest.mark.parametrize("name", [
    "impact", "landing", "quadruped", "rest",
    pytest.param("tripod", marks=pytest.mark.slow),
])  # fmt: skip
def test_the_time_of_an_event_is_its_own(name):
    """Of a touch, of a slip that ends, of a pivot, and of the rest."""
    stored = log(name).time.values
    events = [code >= 0 for code in values(name)["event"][1]]
    assert any(events)
    for time, known, is_event in zip(values(name)["time"][1], stored, events, strict=True):
        assert (time != known) == is_event


def test_two_runs_that_differ_are_refused(monkeypatch):
    fine, coarse = oracle_log.SCHEMES
    monkeypatch.setattr(oracle_log, "SCHEMES", (fine, Scheme(coarse.rows, arb(2) ** -40)))
    with pytest.raises(Undecided, match="two runs differ by too much"):
        log_values(SCENES["mass aside"].model_dump(), [0.0, 0.25])


@pytest.mark.parametrize("radius", [0.7, 0.7 + 1e-8])
def test_another_radius_is_noticed(radius):
    other = SCENES["met again"].model_dump()
    other["slider"]["radius"] = radius
    time = log("met again").time.values[2]
    angle = log_values(other, [0.0, time])["rod_angle"][1][1]
    reference = values("met again")["rod_angle"][1][2]
    assert angle.overlaps(reference) == (radius == 0.7)


VISCOUS = {"type": "viscous", "coefficient": 1.0, "support": DISC}
#: The center of a tripod that pivots reaches the fence.
ENDS = 0.5209445330007864
POLICIES = [{"time": 0.0, "policy": "separate"}]


@pytest.mark.parametrize(
    ("scene", "times", "reason"),
    [
        (("pulling", {}), [0.0, 0.0], "instants must increase"),
        (("pulling", {}), [], "at least one"),
        (("pulling", {}), [0.0, 2.6], "within the duration"),
        (("pulling", {"simulate": None}), [0.0], "no section simulate"),
        (("pulling", {"effects": [RING, RING]}), [0.0], "at most one support friction"),
        (("pulling", {"effects": [RING, VISCOUS]}), [0.0], "at most one support friction"),
        (("pulling", {"contact": {"law": "perfectly_rough"}}), [0.0], "law that allows slip"),
        (("pulling", {"simulate": {"on_ambiguity": POLICIES}}), [0.0], "one policy of"),
        (("pulling", {"simulate": {"on_ambiguity": "stay-in-mode"}}), [0.0], "one policy of"),
        (("pulling", {"simulate": {"method": "time-stepping"}}), [0.0], "event-driven"),
        (("pulling", {"simulate": fence((0.0, 10.0, 0.0))}), [0.0], "a fence at rest"),
        (("slipping", {"simulate": {"pusher_shape": "finger"}}), [0.0], "and a fence"),
        (("tripod", {"slider": {"rod_angle": 10.0}}), [0.0, ENDS], "reaches the fence"),
        (("impact", {}), [0.0, 3.0], "0 stored instants"),
        (("impact", {}), [0.0, 0.39759106971, 0.39759106972, 3.0], "2 stored instants"),
    ],
)
def test_another_scene_is_refused(scene, times, reason):
    name, parts = scene
    content = scene_file(name).model_dump()
    for part, values in parts.items():
        whole = not isinstance(values, dict) or part == "contact"
        content[part] = values if whole else {**content[part], **values}
    with pytest.raises(Undecided, match=reason):
        log_values(SceneFile.model_validate(content).model_dump(), times)
