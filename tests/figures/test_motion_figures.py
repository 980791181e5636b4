"""Figures of motion over time: what they plot, what they draw, and frames between the rows of a log."""

import numpy as np
import pytest
import xarray as xr
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Rectangle
from numpy.testing import assert_allclose

from planar_pushing.figures import render
from planar_pushing.figures.motion import simulation
from planar_pushing.figures.motion.animation import resampled
from planar_pushing.figures.motion.timeline import contact, plotted, rows, runs
from planar_pushing.figures.motion.trajectory import box, faded, last_center
from planar_pushing.figures.style import paper_style
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.errors import InvalidFile
from planar_pushing.simulation.scene_file import simulate_file
from planar_pushing.study.files import load_scene_file
from planar_pushing.study.models import FigureEntry
from planar_pushing.study.store import write_dataset

NAMES = ("figure_14a", "figure_14b", "figure_15", "pulling_with_inertia", "impact")


@pytest.fixture(scope="module")
def logs():
    return {name: simulate_file(load_scene_file(f"workflow/scenes/{name}.yaml")) for name in NAMES}


@pytest.fixture(scope="module")
def results(logs, tmp_path_factory):
    folder = tmp_path_factory.mktemp("results")
    for name, log in logs.items():
        write_dataset(log, folder / f"data/simulations/{name}.nc")
    return folder


@pytest.fixture(scope="module")
def data(results):
    return {
        name: render.select(name, results, FigureEntry()) for name in ("figure_14", "figure_15")
    }


def test_plotted_numbers_have_units_and_names(data):
    for name, dataset in data.items():
        for key, variable in dataset.variables.items():
            assert variable.attrs["units"], (name, key)
            assert variable.attrs["long_name"], (name, key)
        assert "Lynch and Mason" in dataset.attrs["source"]
        assert dataset.attrs["title"]


def test_only_a_slider_at_rest_has_no_motion_centre(data):
    kept, lost = (data["figure_14"].isel(policy=number) for number in (0, 1))
    assert np.isfinite(kept.path_center).all()
    gone = lost.path_mode.values == ContactMode.SEPARATE
    assert (np.isnan(lost.path_center.values).all(axis=-1) == gone).all()


def test_the_contact_is_kept_and_lost(data):
    kept, lost = (data["figure_14"].isel(policy=number) for number in (0, 1))
    before = kept.time.values < 0.5
    assert (kept.path_mode == ContactMode.STICK).all()
    assert (kept.path_gap == 0).all()
    assert (lost.path_mode.values[~before] == ContactMode.SEPARATE).all()
    assert (np.diff(lost.path_gap.values[~before]) > 0).all()
    assert_allclose(kept.path_rod_angle[before], lost.path_rod_angle[before], rtol=0, atol=1e-12)
    assert (kept.path_solutions.values[~before] > 1).all()


def test_the_ring_centre_keeps_its_height_in_slip_with_infinite_friction(data):
    slip = data["figure_15"]
    height = slip.path_position.sel(xy="y")
    assert_allclose(height, 5 * np.sin(np.deg2rad(45)), rtol=0, atol=1e-11)
    sine = np.sin(np.deg2rad(slip.path_rod_angle))
    expected = np.sin(np.deg2rad(45)) - slip.time * np.sin(np.deg2rad(165)) / 5
    assert_allclose(sine, expected, rtol=0, atol=1e-12)


@pytest.mark.parametrize("name", NAMES)
def test_the_motion_centre_is_the_point_that_stands_still(logs, name):
    log = logs[name]
    found = plotted(log).path_center.values
    v_x, v_y, omega = log.twist.values.T  # the radius is 1
    arm = found - log.position.values
    turning = omega != 0
    velocity = np.stack([v_x - omega * arm[:, 1], v_y + omega * arm[:, 0]])[:, turning]
    assert turning.any()
    assert_allclose(velocity, 0, atol=1e-12)


@pytest.mark.parametrize("name", NAMES)
def test_the_contact_is_the_end_of_the_rod_above_the_fence(logs, name):
    motion = plotted(logs[name])
    height = contact(motion)[:, 1] - motion.path_fence.sel(xy="y").values
    assert_allclose(height, motion.path_gap, rtol=0, atol=1e-9)


def test_runs_cover_the_time_and_tell_a_choice(logs):
    found = list(runs(plotted(logs["figure_14a"])))
    assert [(run.start, run.stop, run.several) for run in found] == [(0, 32, False), (32, 96, True)]
    modes = [ContactMode(run.mode).name for run in runs(plotted(logs["pulling_with_inertia"]))]
    assert modes[-3:] == ["STICK", "SLIP_RIGHT", "SEPARATE"]


def test_rows_are_spread_over_the_time(logs):
    assert rows(plotted(logs["figure_15"]), 5) == [0, 24, 48, 72, 96]


@pytest.mark.parametrize("name", ["figure_14", "figure_15"])
def test_picture(data, name):
    with paper_style():
        figure = render.picture(name, data[name])
        figure.canvas.draw()
    sketches = [ax for ax in figure.axes if any(isinstance(p, Circle) for p in ax.patches)]
    assert len(sketches) == (2 if name == "figure_14" else 1)
    for ax in sketches:
        rings = [patch for patch in ax.patches if isinstance(patch, Circle)]
        assert len(rings) == (4 if name == "figure_14" else 5)
        assert len({ring.get_edgecolor() for ring in rings}) == len(rings)
        assert any(isinstance(each, LineCollection) for each in ax.collections)
        (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
        for ring in rings:
            x, y = ring.center
            assert left <= x - 1 < x + 1 <= right
            assert bottom <= y - 1 < y + 1 <= top
    strips = [p for p in figure.axes[-1].patches if isinstance(p, Rectangle)]
    assert [bool(strip.get_hatch()) for strip in strips] == (
        [False, True, False, True] if name == "figure_14" else [False]
    )


def test_a_simulation_shows_what_varies(logs):
    labels = {}
    with paper_style():
        for name in ("figure_14b", "figure_15"):
            figure = Figure(figsize=(7.0, 2.9))
            simulation.draw(figure, plotted(logs[name]))
            labels[name] = [ax.get_ylabel() for ax in figure.axes if ax.get_ylabel()]
    assert labels["figure_14b"][1:] == ["gap"]
    assert labels["figure_15"][1:] == ["slip"]


def test_a_far_centre_is_not_shown(logs):
    motion = plotted(logs["figure_15"])
    assert len(last_center(motion)) == 1
    motion["path_center"] += 100
    assert last_center(motion) == []
    assert box(motion)[3] < 10


def test_faded_colours():
    assert (faded("#336699", 1.0), faded("#336699", 0.0)) == ("#336699", "#ffffff")


def test_frames_lie_between_rows(logs):
    motion = plotted(logs["figure_15"])
    found = resampled(motion, 7)
    assert_allclose(found.time, np.linspace(0, 3, 7))
    assert_allclose(found.path_rod_angle[[0, -1]], motion.path_rod_angle[[0, -1]])
    exact = np.rad2deg(np.arcsin(np.sin(np.pi / 4) - found.time * np.sin(np.deg2rad(165)) / 5))
    assert_allclose(found.path_rod_angle, exact, rtol=0, atol=1e-4)


def test_a_dataset_that_is_no_log_is_refused(logs):
    with pytest.raises(InvalidFile, match=r"the dataset lacks position, .*a log of planar-pushing"):
        plotted(xr.Dataset())
    broken = logs["figure_15"].assign_attrs(scene="Scene(...)")
    with pytest.raises(InvalidFile, match="the dataset lacks scene"):
        plotted(broken)
