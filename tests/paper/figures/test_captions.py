"""Captions: every value that a picture depends on, as the data have it."""

import json
import re

import numpy as np
import pytest
import xarray as xr
from figures.conftest import FIGURES, NUMBERED

from pulling_by_pushing.figures.figure import drawing, full_caption
from pulling_by_pushing.figures.parts.data import number
from pulling_by_pushing.figures.studies import OURS

L, PSI, MU, R, W, M = "l = {}", "ψ = {}°", "μ = {}", "R = {}", "W = {}", "m = {}"
RHO, A = "ρ = {}", "|aₚ| = {}"
RING = {"rod_length": L, "rod_angle": PSI, "friction_coefficient": MU, "radius": R}
FRICTION, INERTIA = {"weight": W}, {"mass": M, "gyration_radius": RHO}
#: Of a log: what it starts from, and how the pusher moves.
LOG = {
    "rod_length": L,
    "friction_coefficient": MU,
    "weight": W,
    "path_rod_angle": "ψ = {}° at time 0",
    "pusher": "vₚ = {} at 0°",
}
SUPPORTS = {"cut_rod_length": "l = {}", "cut_rod_angle": "ψ = {}°", "ring_extent": "radius {}"}
#: Quantities of each figure, by the names that its data have, and how its caption tells them.
NAMED = {
    "figure_01": {**RING, "force_angle": "φ = {}°", "slider_angle": "θₛ = {}°", "pusher_angle": "θₚ = {}°"},
    "figure_02": {**RING, **FRICTION, "force": "f at {}°", "contact_motion": "vₛ at {}°"},
    "figure_03": {**RING, **FRICTION, "force": "f at {}°", "contact_motion": "vₛ at {}°"},
    "figure_04": {**RING, **FRICTION, "force": "f at {}°"},
    "figure_05": {"rod_length": L, "rod_angle": PSI, "radius": R, **FRICTION},
    "figure_06": {**RING, **FRICTION, "mapped_rod_length": L},
    "figure_07": RING,
    "figure_08": {**RING, **FRICTION, "pusher_angle": "θₚ = {}°", "motion_cone_left": "to {}°",
                  "motion_cone_right": "from {}° to"},
    "figure_09": {**RING, **INERTIA, "pusher_angle": "aₚ at {}°"},
    "figure_10": {**RING, **INERTIA, "mapped_rod_length": L, "rod_length": "rod lengths {}"},
    "figure_11": {**RING, **FRICTION, **INERTIA, "pusher_magnitude": A,
                  "force": "f at {}°", "contact_motion": "aₛ at {}°"},
    "figure_12": {**RING, **FRICTION, **INERTIA, "pusher_angle": "θₚ = {}°", "pusher_magnitude": A},
    "figure_13": {"rod_length": L, "rod_angle": PSI, "radius": R, **FRICTION, **INERTIA,
                  "pusher_magnitude": A},
    "figure_14": {**LOG, "radius": R},
    "figure_15": {**LOG, "radius": R},
    "figure_16": {"rod_length": L, "rod_angle": PSI, "ring_extent": "radius {}"},
    "figure_17": SUPPORTS,
    "figure_18": SUPPORTS,
    "figure_19": {**LOG, "support_point": "feet at {} from the center"},
}  # fmt: skip
del NAMED["figure_06"]["rod_length"]
CASES = [(name, key) for name, given in NAMED.items() for key in given]


def put(node, key, value):
    """An entry of JSON with another value of a key; a law gets a coefficient."""
    if isinstance(node, list):
        return [put(each, key, value) for each in node]
    if not isinstance(node, dict):
        return node
    if key == "friction_coefficient" and "law" in node:
        return {"law": "coulomb", key: value}
    return {k: value if k == key else put(each, key, value) for k, each in node.items()}


def changed(data, key, value):
    """Data with another value, or direction in degrees of a vector, everywhere."""
    found = data.copy(deep=True)
    if key == "pusher":
        return found.assign_attrs(pusher=json.dumps([[0.0, [value, 0.0]], [0.25, [0.0, 2.0]]]))
    for name in {"parameters", "scene"} & found.attrs.keys():
        found.attrs[name] = json.dumps(put(json.loads(found.attrs[name]), key, value))
    if key == "pusher_magnitude" and "pusher_motion" in found:
        motion = found["pusher_motion"]
        found["pusher_motion"] = motion * value / np.hypot(*motion.values)
    if key in ("force", "contact_motion"):
        x, y = np.cos(np.deg2rad(value)), np.sin(np.deg2rad(value))
        found[key] = found[key].copy(data=np.broadcast_to([x, y], found[key].shape))
    elif key == "support_point":
        found[key] = found[key].copy(data=np.broadcast_to([value, 0.0], found[key].shape))
    elif key in found.dims:
        coordinate = xr.Variable(key, np.full(found.sizes[key], value), found[key].attrs)
        found = found.drop_indexes(key).assign_coords({key: coordinate})
    elif key in found.variables:
        found[key] = (found[key].dims, np.full(found[key].shape, value))
    return found


def test_every_figure_of_a_study_is_here():
    assert list(NAMED) == NUMBERED


@pytest.mark.parametrize(("name", "key"), CASES)
def test_a_caption_tells_the_values_of_its_data(plotted, name, key):
    caption, told = drawing(name).caption, NAMED[name][key]
    for value in (12.5, 7.5) if "°" in told else (0.125, 7.25):
        assert told.format(number(value)) in caption(changed(plotted[name], key, value))
        assert told.format(number(value)) not in caption(plotted[name])


@pytest.mark.parametrize(
    ("name", "values"),
    [
        ("figure_01", "φ = 146.3°, θₛ = 138.1°, θₚ = 159.1°; l = 2, ψ = 45°, μ = 1.5, R = 1"),
        ("figure_02", "f at 54.0°, vₛ at 112.2°; l = 3, ψ = 45°, μ = 2, R = 1, W = 1"),
        ("figure_03", "f at 36.0°, vₛ at −22.2°; l = 3, ψ = 45°, μ = 2, R = 1, W = 1"),
        ("figure_05", "l = 0, 1, 2 and 5, ψ = 45°, R = 1, W = 1"),
        ("figure_07", "l = 1, 2 and 5, ψ = 45°, μ = ∞, R = 1"),
        ("figure_08", "from −41.2° to 138.8°"),
        ("figure_09", "(a) μ = 2, aₚ at −8°, (b) μ = ∞, aₚ at 165°; l = 2, ψ = 45°, R = 1, m = 1, ρ = 1"),
        ("figure_11", "f at 33.5°, aₛ at −34.3°; l = 5, ψ = 45°, μ = 2, R = 1, W = 1, m = 1, ρ = 1"),
        ("figure_14", "ψ = 30° at time 0; vₚ = 1 at 10°, then 1 at −10° from time 0.5"),
        ("figure_15", "l = 5, μ = ∞, R = 1, W = 1, ψ = 45° at time 0; vₚ = 1 at 165°"),
        ("figure_19", "μ = 0.25, W = 1, l = 2, ψ = 45° at time 0, feet at 1 from the center; vₚ = 1"),
    ],
)  # fmt: skip
def test_the_values_of_the_small_studies(plotted, name, values):
    assert values in drawing(name).caption(plotted[name])


@pytest.mark.parametrize("name", ["figure_02", "figure_03", "figure_04", "figure_11"])
def test_angles_are_those_of_the_vectors(plotted, name):
    data = plotted[name]
    told = dict(re.findall(r"(f|vₛ|aₛ) at (−?[\d.]+)°", drawing(name).caption(data)))
    for letter, angle in told.items():
        x, y = data["force" if letter == "f" else "contact_motion"].values[0]
        assert float(angle.replace("−", "-")) == pytest.approx(
            np.rad2deg(np.arctan2(y, x)), abs=0.05
        )
    assert "f" in told


@pytest.mark.parametrize(
    ("name", "axis"), [("figure_07", "rod_length"), ("figure_10", "mapped_rod_length")]
)
def test_a_fence_passes_above_the_ring_of_a_short_rod_alone(plotted, name, axis):
    caption, said = drawing(name).caption, "fence passes above the ring"
    assert said in caption(changed(plotted[name], axis, 1.0))
    assert said not in caption(changed(plotted[name], axis, 3.0))


@pytest.mark.parametrize("name", FIGURES)
def test_captions_of_reconstructions_name_the_figure_of_the_paper(plotted, name):
    own, printed = drawing(name).caption(plotted[name]), full_caption(name, plotted[name])
    number = int(name.removeprefix("figure_")) if name in NUMBERED else 0
    source = f" After Fig. {number} of Lynch and Mason." if 1 <= number <= 12 else ""
    assert printed == own + source


@pytest.mark.parametrize("name", ["figure_16", "figure_17", "figure_18"])
def test_a_caption_speaks_of_supports_of_the_study_alone(plotted, name):
    named = re.findall("tripod|quadruped|disc|square|plate", drawing(name).caption(plotted[name]))
    assert set(named) <= set(plotted[name].support.values)


def test_the_hard_cases_are_counted(plotted):
    data, caption = plotted["hard_cases"], drawing("hard_cases").caption
    assert "the 13 hard cases" in caption(data)
    assert "the 1 ill-conditioned" in caption(data)
    assert "the 5 hard cases" in caption(data.isel(case=slice(5)))
    assert "the 0 ill-conditioned" in caption(data.isel(case=slice(5)))


@pytest.mark.parametrize("name", FIGURES)
def test_captions_are_sentences_with_true_minus_signs(plotted, name):
    found = drawing(name).caption(plotted[name])
    assert found.endswith(".")
    assert name in (*NUMBERED, *OURS)
    assert not re.search(r"centre|colour|grey|nan|inf\b|(?<!\w)-\d|  ", found)
