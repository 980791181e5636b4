"""Logs of motion over time."""

import os
import subprocess
import sys

import pytest

from planar_pushing.simulation.simulate import simulate
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.simulations import arguments
from planar_pushing.study.store import read_dataset

LOGS = ("figure_14a", "figure_14b", "figure_15", "pulling_with_inertia", "impact")
#: Logs of sliders on other supports.
OTHERS = ("stool", "box")


def simulated(name):
    file = load_scene_file(f"workflow/scenes/{name}.yaml")
    return simulate(file.build(), **arguments(file.simulate))


def uncompiled(name, path):
    """A log of steps, whose kind would be compiled for these pictures alone."""
    options = ["--method", "time-stepping", "--step", "0.02", "-o", str(path)]
    command = [sys.executable, "-m", "planar_pushing.commands", "simulate"]
    subprocess.run(
        [*command, f"workflow/scenes/{name}.yaml", *options],
        env=os.environ | {"NUMBA_DISABLE_JIT": "1"}, check=True, capture_output=True,
    )  # fmt: skip
    return read_dataset(path)


@pytest.fixture(scope="session")
def logs():
    return {name: simulated(name) for name in LOGS}


@pytest.fixture(scope="session")
def others(tmp_path_factory):
    path = tmp_path_factory.mktemp("others") / "box.nc"
    return {"stool": simulated("stool"), "box": uncompiled("box", path)}
