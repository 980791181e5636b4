"""Logs of motion over time."""

import pytest

from planar_pushing.simulation.simulate import simulate
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.simulations import arguments

LOGS = ("figure_14a", "figure_14b", "figure_15", "pulling_with_inertia", "impact")
#: Logs of sliders on other supports, and options: steps with inertia compile sooner than events.
OTHERS = {"stool": {}, "box": {"method": "time-stepping"}}


def simulated(name, **options):
    file = load_scene_file(f"workflow/scenes/{name}.yaml")
    return simulate(file.build(), **arguments(file.simulate) | options)


@pytest.fixture(scope="session")
def logs():
    return {name: simulated(name) for name in LOGS}


@pytest.fixture(scope="session")
def others():
    return {name: simulated(name, **options) for name, options in OTHERS.items()}
