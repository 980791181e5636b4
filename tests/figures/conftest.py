"""Logs of motion over time."""

import pytest

from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.simulations import simulate_file

LOGS = ("figure_14a", "figure_14b", "figure_15", "pulling_with_inertia", "impact")


#: Logs of sliders on other supports.
OTHERS = ("stool", "box")


def simulated(name):
    return simulate_file(load_scene_file(f"workflow/scenes/{name}.yaml"))


@pytest.fixture(scope="session")
def logs():
    return {name: simulated(name) for name in LOGS}


@pytest.fixture(scope="session")
def others():
    return {name: simulated(name) for name in OTHERS}
