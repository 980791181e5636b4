"""Golden values of what each figure plots, from plain values of the study and its scenes."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import Any

import xarray as xr

from planar_pushing.certified.balls import precise
from planar_pushing.certified.contact import modes
from planar_pushing.certified.setting import Effects
from planar_pushing.evidence.golden.build import cells, motions
from planar_pushing.evidence.golden.build.generate import coefficient
from planar_pushing.evidence.golden.build.packing import Values, certified
from planar_pushing.evidence.golden.build.plotted import (
    Study,
    center,
    cone,
    curves,
    friction_angle,
    mapping,
    mode_set,
    parameters,
    point,
    sectors,
)
from planar_pushing.evidence.golden.build.scenes import Scene, scene_values, slider_of

XY = ("x", "y")
SCENE_PLOTTED = (
    *("adhesive", "center", "contact_motion", "force", "friction_cone_left", "friction_cone_right"),
    *("mode", "motion_cone_left", "motion_cone_right", "outcome", "pusher_motion", "ring_center"),
    *("spin_ratio", "support_force"),
)
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
    length, mu = settings["rod_length"], settings["friction_coefficient"]
    edges = cone(study, Effects.FRICTION, length, mu)
    edge = edges["motion_cone_left"]
    return {
        "force_angle": ((), edges["friction_cone_left"]),
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
    special = [[point(study, Effects.FRICTION, each, phi) for phi in order] for each in lengths]
    ends = [point(study, Effects.FRICTION, lengths[-1], phi) for phi in (psi, (psi + 180) % 360)]
    values = curves(study, Effects.FRICTION, lengths)
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
    coords = {"rod_length": list(lengths), "force_angle": list(map(float, study["curve_angles"]))}
    return values, coords | {"parallel_angle": order}


def _figure_06(study: Study) -> Golden:
    settings = study["figures"]["figure_06"]
    length, mu = settings["rod_length"], settings["friction_coefficient"]
    curve = curves(study, Effects.FRICTION, [length])
    values: Values = {name: (("force_angle",), nested[0]) for name, (_, nested) in curve.items()}
    values |= mapping(study, Effects.FRICTION, length, mu)
    return values, {"force_angle": list(map(float, study["curve_angles"]))}


def _figure_07(study: Study) -> Golden:
    lengths = study["figures"]["figure_07"]["rod_length"]
    cones = [cone(study, Effects.FRICTION, each, math.inf) for each in lengths]
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
    values = curves(study, Effects.INERTIA, lengths)
    values |= mapping(study, Effects.INERTIA, mapped, settings["friction_coefficient"])
    return values, {
        "rod_length": list(lengths),
        "force_angle": list(map(float, study["curve_angles"])),
    }


def _figure_12(study: Study) -> Golden:
    length, psi = study["figures"]["figure_12"]["rod_length"], study["slider"]["rod_angle"]
    scene = study["scenes"]["figure_12"]
    shown = _shown(scene)
    friction = ("friction_cone_right", "friction_cone_left")
    plotted = ("ring_center", "pusher_angle", "pusher_motion", *friction)
    values: Values = {name: shown[name] for name in plotted}
    values |= {name: (("xy",), shown[name][1][0]) for name in ("contact_motion", "force")}
    angles = [float(phi) for phi in study["curve_angles"] if phi <= 180 and phi != psi]
    for name in XY:
        rows = [
            [center(study, length, phi, share)[f"center_{name}"] for share in (0.0, 1.0)]
            for phi in angles
        ]
        values[f"exact_center_{name}"] = (("force_angle", "inertia_share"), rows)
    bounds = cells.acceleration_cones(parameters(study), psi, length)
    values |= {name: ((), ball) for name, ball in bounds.items()}
    coords = {"force_angle": angles, "inertia_share": [0.0, 1.0], "xy": list(XY)}
    return values | sectors(scene), coords


def _figure_13(study: Study) -> Golden:
    settings, grid = study["figures"]["figure_13"], study["grid"]
    length, magnitude = settings["rod_length"], settings["pusher_magnitude"]
    laws = {label: law for label, (_, law) in study["contacts"].items()}
    angles = [phi for phi in grid["pusher_angle"] if phi % 15 == 0]
    cell = partial(cells.contact_mode, parameters(study), study["slider"]["rod_angle"], laws)
    sets = [
        [[mode_set(cell(kind, label, length, magnitude, phi)) for phi in angles] for label in laws]
        for kind in grid["effects"]
    ]
    stick = list(modes.Mode).index(modes.Mode.STICK)
    rough = [
        [
            cell(kind, "perfectly_rough", length, magnitude, phi)["force_angle"][stick]
            for phi in angles
        ]
        for kind in grid["effects"]
    ]
    mus = grid["friction_coefficient"]
    cones = [[cone(study, Effects(kind), length, mu) for mu in mus] for kind in grid["effects"]]
    values: Values = {"modes": (("effects", "contact", "pusher_angle"), sets)}
    values["force_angle"] = (("effects", "pusher_angle"), rough)
    for name in ("motion_cone_right", "motion_cone_left"):
        rows = [[each[name] for each in row] for row in cones]
        values[name] = (("effects", "friction_coefficient"), rows)
    steep = [friction_angle(coefficient(law)) for law in laws.values()]
    values["friction_angle"] = (("contact",), steep)
    values["cone_friction_angle"] = (("friction_coefficient",), [friction_angle(mu) for mu in mus])
    coords = {"effects": list(grid["effects"]), "contact": list(laws), "pusher_angle": angles}
    return values, coords


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
    "figure_14": motions.figure_14,
    "figure_15": motions.figure_15,
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
