"""Presets to start from, which are scene files, and the gallery of supports."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

from planar_pushing.explorer.several import open_state
from planar_pushing.explorer.state import State, state_of
from planar_pushing.scenes.contacts_files import load_any_file
from planar_pushing.scenes.contacts_model import ContactsFile
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.scenes.yaml_text import read_yaml

HERE = Path(__file__).parent
#: Preset that the page shows first.
FIRST = "figure_03"
#: Presets in the order of the page, with the direction of the push where the scene file has no motion.
PUSHES: dict[str, float | None] = {
    "figure_01": 155.0,
    "figure_02": 112.240349,
    "figure_03": -22.240349,
    "figure_04": 90.0,
    "figure_05": 90.0,
    "figure_06": -15.0,
    "figure_07": -25.0,
    "figure_08": 165.0,
    "figure_09a": -8.0,
    "figure_09b": 165.0,
    "figure_10": 90.0,
    "figure_11": -34.329305,
    "figure_12": 170.0,
    "figure_13": -10.0,
    "pulling": None,
    "pulling_lost": None,
    "slipping": None,
    "support_limit_curves": 90.0,
    "friction_for_pulling": -10.0,
    "slip_of_supports": 165.0,
    "tripod": None,
    "ellipsoid": 120.0,
    "box": None,
    "box_side": None,
    "mug": None,
    "rounded_box": None,
    "plate": None,
    "stool": None,
    "impact": None,
    "pulling_with_inertia": None,
    "box_along_a_wall": None,
}
#: Presets with several contacts, after the others.
SEVERAL = ("two_fingers", "finger_in_a_corner")


@cache
def gallery() -> dict[str, Any]:
    """Supports of size 1 in the format of scene files, by name."""
    supports: dict[str, Any] = read_yaml(HERE / "gallery.yaml")
    return supports


@cache
def preset_file(name: str) -> SceneFile | ContactsFile:
    """Scene file of a preset."""
    return load_any_file(HERE / f"scenes/{name}.yaml")


def titles() -> dict[str, str]:
    """Titles of the presets by name."""
    return {name: preset_file(name).title for name in (*PUSHES, *SEVERAL)}


def preset(name: str) -> State:
    """Initial state of a preset."""
    file = preset_file(name)
    return state_of(file, PUSHES[name]) if isinstance(file, SceneFile) else open_state(file)
