"""The stored errors, with times made up for the test, and the pictures of them."""

from pathlib import Path

import numpy as np
import pytest

from planar_pushing.evidence.costs import tables
from planar_pushing.figures import render
from planar_pushing.figures.style import paper_style
from planar_pushing.study.figures import OURS, SUPPLEMENT
from planar_pushing.study.store import read_dataset, write_dataset

GOLDEN = Path(__file__).parents[2] / "evidence/costs/golden_accuracy.nc"


GROUPS = {
    name: figure.datasets[0].partition("/")[2] or "wrench"
    for name, figure in (OURS | SUPPLEMENT).items()
    if name.startswith("accuracy_")
}


def made_up_times(*shape):
    return 10 ** np.random.default_rng(2).uniform(-7, -3, shape)


@pytest.fixture(scope="session")
def data(tmp_path_factory):
    wrench, cone = (read_dataset(GOLDEN, name) for name in ("wrench", "cone"))
    points = wrench.sizes["point"], wrench.sizes["spin_ratio"]
    wrench["wrench_seconds"] = ("point", "spin_ratio", "repeat"), made_up_times(*points, 3)
    cone["cone_seconds"] = ("point", "repeat"), made_up_times(cone.sizes["point"], 3)
    path = tmp_path_factory.mktemp("data") / "accuracy.nc"
    runs = read_dataset(GOLDEN, "motion")
    points = runs.sizes["point"], runs.sizes["scene"]
    runs["motion_seconds"] = ("point", "scene", "repeat"), 1e3 * made_up_times(*points, 3)
    groups = {"wrench": wrench, "cone": cone, "motion": runs}
    write_dataset({name: tables.described(each) for name, each in groups.items()}, path)
    return path


@pytest.fixture(scope="session")
def pictures(data):
    found = {}
    with paper_style():
        for name in GROUPS:
            found[name] = render.picture(name, read_dataset(data, GROUPS[name]))
    return found


def markers(ax):
    """Coordinates of every drawn marker."""
    lines = [np.column_stack(line.get_data()) for line in ax.lines if line.get_marker() != "None"]
    return np.concatenate(lines)
