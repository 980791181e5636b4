"""Golden values of what each figure plots, from plain values of the study and its scenes."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

import xarray as xr
from flint import arb

from planar_pushing.golden import cells
from planar_pushing.golden.balls import in_degrees, precise, rational, sign
from planar_pushing.golden.certified import Values, certified
from planar_pushing.golden.scenes import Scene, scene_values, slider_of
from planar_pushing.golden.setting import heading, lean

#: Force angles compared along the limit curves, degrees.
ANGLES = tuple(range(0, 361, 15))
XY = ("x", "y")
SCENE_PLOTTED = (
    *("adhesive", "center", "contact_motion", "force", "friction_cone_left", "friction_cone_right"),
    *("mode", "motion_cone_left", "motion_cone_right", "outcome", "pusher_motion", "ring_center"),
    *("spin_ratio", "support_force"),
)
Study = Mapping[str, Any]
Golden = tuple[Values, dict[str, Any]]


def _shown(scene: Scene) -> Values:
    """Values of the solution that a figure shows: the sticking one, else the first that moves."""
    values = scene_values(*scene)
    found = values["mode"][1]
    best = found.index(1) if 1 in found else next(i for i, mode in enumerate(found) if mode)
    return {
        name: (dims, [nested[best]] if dims[:1] == ("solution",) else nested)
        for name, (dims, nested) in values.items()
    }


def _scene_figure(scene: str, study: Study) -> Golden:
    values = _shown(study["scenes"][scene])
    return {name: values[name] for name in SCENE_PLOTTED}, {"xy": list(XY)}


def _figure_01(study: Study) -> Golden:
    settings = study["figures"]["figure_01"]
    cone = _cone(
        study, "support_friction", settings["rod_length"], settings["friction_coefficient"]
    )
    edge = cone["motion_cone_left"]
    return {
        "force_angle": ((), cone["friction_cone_left"]),
        "slider_angle": ((), edge),
        "pusher_angle": ((), (edge + 180) / 2),
    }, {}


def _figure_04(study: Study) -> Golden:
    values = _shown(study["scenes"]["figure_02"])
    one: Values = {name: (("xy",), values[name][1][0]) for name in ("force", "center")}
    return one | {"ring_center": values["ring_center"]}, {"xy": list(XY)}


def _figure_05(study: Study) -> Golden:
    lengths, psi = study["figures"]["figure_05"]["rod_length"], study["slider"]["rod_angle"]
    order = [(psi + turn) % 360 for turn in (0, 90, 180, 270)]
    special = [[_point(study, "support_friction", each, phi) for phi in order] for each in lengths]
    ends = [_point(study, "support_friction", lengths[-1], phi) for phi in (psi, (psi + 180) % 360)]
    values = _curves(study, "support_friction", lengths)
    dims = ("rod_length", "parallel_angle")
    values |= {
        "parallel_force": (dims, [[each["force"] for each in row] for row in special]),
        "parallel_motion_angle": (
            dims,
            [[each["motion_angle"] for each in row] for row in special],
        ),
        "infinite_rod_x": (("end",), [each["force_x"] for each in ends]),
        "infinite_rod_y": (("end",), [each["force_y"] for each in ends]),
    }
    coords = {"rod_length": list(lengths), "force_angle": list(map(float, ANGLES))}
    return values, coords | {"parallel_angle": order}


def _figure_06(study: Study) -> Golden:
    settings = study["figures"]["figure_06"]
    length, mu = settings["rod_length"], settings["friction_coefficient"]
    curve = _curves(study, "support_friction", [length])
    values: Values = {name: (("force_angle",), nested[0]) for name, (_, nested) in curve.items()}
    values |= _mapping(study, "support_friction", length, mu)
    return values, {"force_angle": list(map(float, ANGLES))}


def _figure_07(study: Study) -> Golden:
    lengths = study["figures"]["figure_07"]["rod_length"]
    cones = [_cone(study, "support_friction", each, math.inf) for each in lengths]
    names = ("motion_cone_right", "motion_cone_left")
    values: Values = {name: (("rod_length",), [each[name] for each in cones]) for name in names}
    return values, {"rod_length": list(lengths)}


def _figure_09(study: Study) -> Golden:
    panels = [scene_values(*study["scenes"][f"figure_09{panel}"]) for panel in "ab"]
    names = [f"{kind}_cone_{side}" for kind in ("friction", "motion") for side in ("right", "left")]
    values: Values = {name: (("panel",), [each[name][1] for each in panels]) for name in names}
    values["ring_center"] = (("panel", "xy"), [each["ring_center"][1] for each in panels])
    for side, sample in (("right", 0), ("left", -1)):
        centers = [each["cone_center"][1][0][sample] for each in panels]
        values[f"center_{side}"] = (("panel", "xy"), centers)
    return values, {"panel": ["a", "b"], "xy": list(XY)}


def _figure_10(study: Study) -> Golden:
    settings = study["figures"]["figure_10"]
    lengths, mapped = settings["rod_length"], settings["mapped_rod_length"]
    values = _curves(study, "inertia", lengths)
    values |= _mapping(study, "inertia", mapped, settings["friction_coefficient"])
    return values, {"rod_length": list(lengths), "force_angle": list(map(float, ANGLES))}


def _figure_12(study: Study) -> Golden:
    length, psi = study["figures"]["figure_12"]["rod_length"], study["slider"]["rod_angle"]
    scene = study["scenes"]["figure_12"]
    shown = _shown(scene)
    cone = ("friction_cone_right", "friction_cone_left")
    plotted = ("ring_center", "pusher_angle", "pusher_motion", *cone)
    values: Values = {name: shown[name] for name in plotted}
    values |= {name: (("xy",), shown[name][1][0]) for name in ("contact_motion", "force")}
    angles = [float(phi) for phi in ANGLES if phi <= 180 and phi != psi]
    ring = shown["ring_center"][1]
    for i, name in enumerate(XY):
        rows = [
            [_center(study, length, phi, share)[f"center_{name}"] + ring[i] for share in (0.0, 1.0)]
            for phi in angles
        ]
        values[f"exact_center_{name}"] = (("force_angle", "inertia_share"), rows)
    bounds = cells.acceleration_cones(parameters(study), psi, length)
    values |= {name: ((), ball) for name, ball in bounds.items()}
    coords = {"force_angle": angles, "inertia_share": [0.0, 1.0], "xy": list(XY)}
    return values | _sectors(scene), coords


def _sectors(scene: Scene) -> Values:
    """Sectors about the ring centre that the seven cases allow, from the cuts between the cases."""
    slider, _ = slider_of(scene[0])
    psi, cuts = arb(slider.rod_angle), [arb(0), arb(slider.rod_angle), arb(180)]
    if slider.rod_length > 1:
        half = in_degrees((1 / arb(slider.rod_length)).asin())
        found = [psi + half, psi - half, psi + 180 - half, psi - 180 + half]
        cuts += [each for each in found if each > 0 and each < 180]
    cuts.sort(key=lambda each: float(each.mid()))
    starts, stops, outside = [], [], []
    for first, last in itertools.pairwise(cuts):
        middle = heading(float(((first + last) / 2).mid()))
        arm = slider.rod_length * lean(slider, middle)[1]
        turn = 90 * sign(arm)
        starts.append(first + turn)
        stops.append(last + turn)
        outside.append(int(sign(abs(arm) - 1) < 0))
    return {
        "sector_start": (("sector",), starts),
        "sector_stop": (("sector",), stops),
        "sector_outside": (("sector",), outside),
    }


def _figure_13(study: Study) -> Golden:
    settings, grid = study["figures"]["figure_13"], study["grid"]
    length, magnitude = settings["rod_length"], settings["pusher_magnitude"]
    laws = {label: law for label, (_, law) in study["contacts"].items()}
    angles = [phi for phi in grid["pusher_angle"] if phi % 15 == 0]
    cell = partial(cells.contact_mode, parameters(study), study["slider"]["rod_angle"], laws)
    sets = [
        [[_set(cell(kind, label, length, magnitude, phi)) for phi in angles] for label in laws]
        for kind in grid["effects"]
    ]
    mus = grid["friction_coefficient"]
    cones = [[_cone(study, kind, length, mu) for mu in mus] for kind in grid["effects"]]
    values: Values = {"modes": (("effects", "contact", "pusher_angle"), sets)}
    for name in ("motion_cone_right", "motion_cone_left"):
        rows = [[each[name] for each in row] for row in cones]
        values[name] = (("effects", "friction_coefficient"), rows)
    steep = [_friction_angle(law.friction_coefficient) for law in laws.values()]
    values["friction_angle"] = (("contact",), steep)
    values["cone_friction_angle"] = (("friction_coefficient",), [_friction_angle(mu) for mu in mus])
    coords = {"effects": list(grid["effects"]), "contact": list(laws), "pusher_angle": angles}
    return values, coords


def _set(record: cells.Record) -> int:
    counts: Any = record["consistent"]
    return sum(1 << mode for mode, count in enumerate(counts) if count)


def _friction_angle(mu: float) -> arb:
    return arb(90) if math.isinf(mu) else in_degrees(arb(rational(mu)).atan())


def parameters(study: Study) -> dict[str, float]:
    """Parameters of the study's slider and effects."""
    inertia = study["inertia"]
    return {
        "weight": study["support_friction"]["weight"],
        "mass": inertia["mass"],
        "gyration_radius": inertia["gyration_radius"],
        "radius": study["slider"]["radius"],
    }


def _point(study: Study, effects: str, length: float, phi: float) -> Any:
    psi = study["slider"]["rod_angle"]
    return cells.limit_point(parameters(study), effects, length, psi, phi)


def _cone(study: Study, effects: str, length: float, mu: float) -> Any:
    psi = study["slider"]["rod_angle"]
    return cells.motion_cone(parameters(study), effects, length, psi, mu)


def _center(study: Study, length: float, phi: float, share: float) -> Any:
    return cells.center(parameters(study), study["slider"]["rod_angle"], length, phi, share)


def _curves(study: Study, effects: str, lengths: Sequence[float]) -> Values:
    points = [[_point(study, effects, each, phi) for phi in ANGLES] for each in lengths]
    dims = ("rod_length", "force_angle")
    return {
        name: (dims, [[each[name] for each in row] for row in points])
        for name in ("force_x", "force_y")
    }


def _mapping(study: Study, effects: str, length: float, mu: float) -> Values:
    """Edges of the friction cone and the force angles 45 and 90 degrees, mapped to motions."""
    cone = _cone(study, effects, length, mu)
    inner = [_point(study, effects, length, phi) for phi in (45.0, 90.0)]
    forces = [cone["limit_force_right"], *(p["force"] for p in inner), cone["limit_force_left"]]
    angles = [cone["friction_cone_right"], arb(45), arb(90), cone["friction_cone_left"]]
    motions = [
        cone["motion_cone_right"],
        *(each["motion_angle"] for each in inner),
        cone["motion_cone_left"],
    ]
    turns = [angle / 180 for angle in angles]
    pairs = list(zip(forces, turns, strict=True))
    return {
        "mapped_force_x": (("map",), [size * turn.cos_pi() for size, turn in pairs]),
        "mapped_force_y": (("map",), [size * turn.sin_pi() for size, turn in pairs]),
        "mapped_force_angle": (("map",), angles),
        "mapped_motion_angle": (("map",), motions),
    }


FIGURES: dict[str, Callable[[Study], Golden]] = {
    "figure_01": _figure_01,
    "figure_04": _figure_04,
    "figure_05": _figure_05,
    "figure_06": _figure_06,
    "figure_07": _figure_07,
    "figure_09": _figure_09,
    "figure_10": _figure_10,
    "figure_12": _figure_12,
    "figure_13": _figure_13,
    **{name: partial(_scene_figure, name) for name in ("figure_02", "figure_03", "figure_08")},
    "figure_11": partial(_scene_figure, "figure_11"),
}


@precise
def figure(name: str, study: Study) -> xr.Dataset:
    """Certified values of what a figure plots."""
    values, coords = FIGURES[name](study)
    return certified(values, coords, f"Plotted values of {name}")


@precise
def scene(name: str, study: Study) -> xr.Dataset:
    """Certified values of a scene's dataset."""
    file, push = study["scenes"][name]
    kinds = slider_of(file)[1].value.split("+")
    coords = {"xy": list(XY), "effect": kinds}
    return certified(scene_values(file, push), coords, f"Scene {name}")
