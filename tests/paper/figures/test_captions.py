"""Captions: every value that a picture depends on, as the data have it."""

import re

import numpy as np
import pytest
import xarray as xr
from figures.conftest import FIGURES, NUMBERED

from pulling_by_pushing.figures.captions import number
from pulling_by_pushing.figures.figure import drawing, full_caption
from pulling_by_pushing.figures.studies import OURS

L, PSI, MU, R, W, M = "l = {}", "ψ = {}°", "μ = {}", "R = {}", "W = {}", "m = {}"
RHO, A = "ρ = {}", "|aₚ| = {}\N{NO-BREAK SPACE}μₛg"
RING = {"rod_length": L, "rod_angle": PSI, "friction_coefficient": MU, "radius": R}
FRICTION, INERTIA = {"weight": W}, {"mass": M, "gyration_radius": RHO}
SOLUTION = {"force": "f at {}°", "contact_motion": "vₛ at {}°"}
#: Of a log: what it starts from, and how the pusher moves.
LOG = {
    "rod_length": L,
    "friction_coefficient": MU,
    "weight": W,
    "rod_angle": "ψ = {}° at time 0",
    "pusher": "vₚ = {} at 0°",
}
RODS = {"rod_length": L, "rod_angle": PSI, "radius": "radius {}"}
#: Variables and coordinates of the datasets of each figure, and how its caption tells them.
NAMED = {
    "figure_01": {**RING, "friction_cone_left": "φ = {}°", "motion_cone_left": "θₛ = {}°"},
    "figure_02": {**RING, **FRICTION, **SOLUTION},
    "figure_03": {**RING, **FRICTION, **SOLUTION},
    "figure_04": {**RING, **FRICTION, "force": "f at {}°"},
    "figure_05": {"rod_length": L, "rod_angle": PSI, "radius": R, **FRICTION},
    "figure_06": {**RING, **FRICTION},
    "figure_07": RING,
    "figure_08": {**RING, **FRICTION, "pusher_angle": "θₚ = {}°", "motion_cone_left": "to {}°",
                  "motion_cone_right": "from {}° to"},
    "figure_09": {**RING, **INERTIA, "pusher_angle": "aₚ at {}°"},
    "figure_10": {**RING, **INERTIA},
    "figure_11": {**RING, **FRICTION, **INERTIA, **SOLUTION, "pusher_magnitude": A,
                  "contact_motion": "aₛ at {}°"},
    "figure_12": {**RING, **FRICTION, **INERTIA, "pusher_angle": "θₚ = {}°", "pusher_magnitude": A},
    "figure_13": {"rod_length": L, "rod_angle": PSI, "radius": R, **FRICTION, **INERTIA,
                  "pusher_magnitude": A},
    "model_errors": {"length": "a box of {} m", "width": "× {} m,", "distance": "over {} m,",
                     "support_friction_coefficient": "μₛ = {},", "friction_coefficient": "μ = {}. ",
                     "place": "pushed {} m from", "pusher_angle": "the middle at {}°"},
    "pulling_over_time": {**LOG, "radius": R},
    "slip_over_time": {**LOG, "radius": R},
    "support_limit_curves": RODS,
    "friction_for_pulling": RODS,
    "slip_of_supports": RODS,
    "pivoting_tripod": LOG,
}  # fmt: skip
CASES = [(name, key) for name, given in NAMED.items() for key in given]


def changed(data, key, value):
    """Datasets with another value of a variable, or another direction of a vector, everywhere."""
    return {source: _changed(each, key, value) for source, each in data.items()}


def _changed(dataset, key, value):
    if key not in dataset.variables:
        return dataset
    variable = dataset[key].variable
    if key == "pusher":
        values = value * dataset.time.values[:, None] * [1.0, 0.0]
    elif "xy" in variable.dims:
        turn = np.deg2rad(value)
        values = np.broadcast_to([np.cos(turn), np.sin(turn)], variable.shape)
    else:
        values = np.full(variable.shape, value)
    new = xr.Variable(variable.dims, values)
    return dataset.drop_vars(key).assign({key: new} if key in dataset.data_vars else {}).assign_coords(
        {} if key in dataset.data_vars else {key: new}
    )  # fmt: skip


def test_every_figure_of_a_study_is_here():
    assert set(NAMED) == set(NUMBERED)


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
        ("pulling_over_time", "ψ = 35° at time 0; vₚ = 1 at 60°, then 1 at −20° from time 0.4"),
        ("slip_over_time", "l = 5, μ = ∞, R = 1, W = 1, ψ = 45° at time 0; vₚ = 1 at 165°"),
        ("pivoting_tripod", "μ = 0.25, W = 1, l = 2, ψ = 45° at time 0, feet at 1 from the center; vₚ = 1"),
    ],
)  # fmt: skip
def test_the_values_of_the_small_studies(plotted, name, values):
    assert values in drawing(name).caption(plotted[name])


@pytest.mark.parametrize("name", ["figure_07", "figure_10"])
def test_a_fence_passes_above_the_ring_of_a_short_rod_alone(plotted, name):
    caption, said = drawing(name).caption, "fence passes above the ring"
    assert said in caption(changed(plotted[name], "rod_length", 1.0))
    assert said not in caption(changed(plotted[name], "rod_length", 3.0))


@pytest.mark.parametrize("name", FIGURES)
def test_captions_of_reconstructions_name_the_figure_of_the_paper(plotted, name):
    own, printed = drawing(name).caption(plotted[name]), full_caption(name, plotted[name])
    number = name.removeprefix("figure_").lstrip("0")
    source = (
        f" After Fig. {number} of Lynch and Mason."
        if number.isdigit() and int(number) <= 12
        else ""
    )
    assert printed == own + source


@pytest.mark.parametrize(
    "name", ["support_limit_curves", "friction_for_pulling", "slip_of_supports"]
)
def test_a_caption_speaks_of_supports_of_the_study_alone(plotted, name):
    named = re.findall("tripod|quadruped|disc|square|plate", drawing(name).caption(plotted[name]))
    assert set(named) <= set(plotted[name]["supports"].support.values)


def test_pushes_of_the_model_errors_are_counted_and_the_first_is_named(plotted):
    data, caption = plotted["model_errors"], drawing("model_errors").caption
    errors, estimates = data["model_errors"], data["model_estimates"]
    said = caption(data)
    assert "median of 3 pushes" in said
    assert "for 12 random pushes" in said
    assert "0.76 mm at 0.05 m/s and 9.6 mm at 0.2 m/s without inertia" in said
    fewer = {"model_errors": errors.isel(push=[1, 2]), "model_estimates": estimates.isel(push=[0])}
    assert "median of 2 pushes" in caption(fewer)
    assert "for 1 random pushes" in caption(fewer)
    assert "0.76 mm" not in caption(fewer)


def test_the_hard_cases_are_counted(plotted):
    every, caption = plotted["hard_cases"]["hard_cases"], drawing("hard_cases").caption
    for cases, count, ill in ((every, 14, 1), (every.isel(case=slice(5)), 5, 0)):
        said = caption({"hard_cases": cases})
        assert f"the {count} hard cases" in said
        assert f"the {ill} ill-conditioned" in said


@pytest.mark.parametrize("name", FIGURES)
def test_captions_are_sentences_with_true_minus_signs(plotted, name):
    found = drawing(name).caption(plotted[name])
    assert found.endswith(".")
    assert name in (*NUMBERED, *OURS)
    assert not re.search(r"centre|colour|grey|nan|inf\b|(?<!\w)-\d|  ", found)
