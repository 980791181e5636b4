"""Logs of scene files, each when it is first asked for."""

import pytest

from planar_pushing.scenes.files import load_scene_file
from planar_pushing.scenes.simulate import arguments
from planar_pushing.simulation.simulate import simulate

LOGS = ("pulling", "pulling_lost", "slipping", "pulling_with_inertia", "impact")
#: Logs of sliders on other supports.
OTHERS = ("stool", "box")


class Made(dict):
    """Values that are made when they are first asked for."""

    def __init__(self, make):
        self.make = make

    def __missing__(self, key):
        self[key] = self.make(key)
        return self[key]


@pytest.fixture(scope="session")
def logs():
    """Logs of scene files."""

    def run(name):
        file = load_scene_file(f"workflow/scenes/{name}.yaml")
        return simulate(file.build(), **arguments(file.simulate))

    return Made(run)
