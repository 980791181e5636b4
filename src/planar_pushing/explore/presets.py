"""Scenes to start from and the gallery of supports: read from the package, written from the studies.

`python -m planar_pushing.explore.presets` writes the package's copy anew, in a clone of the project.
"""

from __future__ import annotations

import json
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

from planar_pushing.explore.state import State, state_of
from planar_pushing.study.datasets.scenes import pusher_angle
from planar_pushing.study.files.scene_model import SceneFile
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.files.study_model import PushEntry
from planar_pushing.study.study_file import load_study

STORED = Path(__file__).with_name("presets.json")
#: The scene that the page shows where none is named.
FIRST = "figure_03"
#: Figures of curves, cones and maps: the scene that each is about, what differs, and the push.
DERIVED: dict[str, tuple[str, str, dict[str, Any], float]] = {
    "figure_01": (
        "figure_02", "The pushing problem (Fig. 1)",
        {"slider.rod_length": 3, "contact.friction_coefficient": 0.5}, 155.0,
    ),
    "figure_04": ("figure_02", "Coordinate systems (Fig. 4)", {}, 90.0),
    "figure_05": ("figure_02", "Limit curves (Fig. 5)", {"slider.rod_length": 2}, 90.0),
    "figure_06": ("figure_02", "Velocity cone (Fig. 6)", {"slider.rod_length": 2}, -15.0),
    "figure_07": (
        "figure_08", "Velocity cones, infinite friction (Fig. 7)", {"slider.rod_length": 2}, -25.0,
    ),
    "figure_10": (
        "figure_09a", "Limit curves of inertia (Fig. 10)",
        {"slider.rod_length": 1, "contact.friction_coefficient": 5}, 90.0,
    ),
    "figure_13": ("figure_11", "Contact modes (Fig. 13)", {"slider.rod_length": 2}, -10.0),
}  # fmt: skip
#: Figures of the study of sliders, by the support that each shows first, and the push.
GALLERY: dict[str, tuple[str, str, float, float]] = {
    "figure_16": ("rectangle_2_1", "Limit curves of supports (Fig. 16)", 1.5, 90.0),
    "figure_17": ("segment_across", "Friction that pulling takes (Fig. 17)", 2.0, -10.0),
    "figure_18": ("square", "Slip with infinite friction (Fig. 18)", float("inf"), 165.0),
    "figure_20": ("l_shape", "What an ellipsoid costs (Fig. 20)", 0.5, 120.0),
}
#: Example scenes, and those that are followed over time; the others push as their study says.
EXAMPLES = (
    "figure_14a", "figure_14b", "figure_15", "tripod", "box", "plate", "stool", "impact",
    "pulling_with_inertia",
)  # fmt: skip


@cache
def _stored() -> dict[str, Any]:
    """The package's copy."""
    text = (files("planar_pushing.explore") / STORED.name).read_text(encoding="utf-8")
    found: dict[str, Any] = json.loads(text)
    return found


def gallery() -> dict[str, Any]:
    """Supports by name, as scene files have them, of size 1."""
    found: dict[str, Any] = _stored()["supports"]
    return found


def presets() -> dict[str, str]:
    """Names of the presets, and their titles."""
    return {name: each["scene"]["title"] for name, each in _stored()["scenes"].items()}


def preset(name: str) -> State:
    """The state that a preset starts from."""
    given = _stored()["scenes"][name]
    return state_of(SceneFile.model_validate(given["scene"]), given.get("angle"))


def collected(workflow: Path) -> dict[str, Any]:
    """Presets and gallery, read from the studies in a folder."""
    study = load_study(workflow / "config/paper.yaml")
    found: dict[str, Any] = {}
    for name, push in study.scenes.items():
        file = load_scene_file(push.file)
        found[name] = {"scene": _content(file), "angle": round(_angle(file, push), 6)}
    for name, (source, title, changes, angle) in DERIVED.items():
        found[name] = {"scene": _altered(found[source]["scene"], title, changes), "angle": angle}
    supports = load_study(workflow / "config/sliders.yaml").supports
    shapes = {
        name: each.model_dump(mode="json", exclude_none=True) for name, each in supports.items()
    }
    for name, (support, title, friction, angle) in GALLERY.items():
        found[name] = {"scene": _of_gallery(shapes[support], title, friction), "angle": angle}
    for name in EXAMPLES:
        found[name] = {"scene": _content(load_scene_file(workflow / f"scenes/{name}.yaml"))}
    found["figure_19"] = found.pop("tripod")
    figures = sorted(name for name in found if name.startswith("figure"))
    return {"scenes": {n: found[n] for n in [*figures, *(set_ for set_ in found if set_ not in figures)]},
            "supports": shapes}  # fmt: skip


def _content(file: SceneFile) -> dict[str, Any]:
    return file.model_dump(mode="json", exclude_none=True)


def _angle(file: SceneFile, push: PushEntry) -> float:
    return pusher_angle(file.build(), push)


def _altered(scene: dict[str, Any], title: str, changes: dict[str, Any]) -> dict[str, Any]:
    """A scene under another title, with other values at dotted keys."""
    found: dict[str, Any] = json.loads(json.dumps(scene)) | {"title": title}
    for key, value in changes.items():
        part, name = key.split(".")
        found[part][name] = value
    return found


def _of_gallery(support: dict[str, Any], title: str, friction: float) -> dict[str, Any]:
    law: dict[str, Any] = {"law": "coulomb", "friction_coefficient": friction}
    return {
        "title": title,
        "slider": {"rod_length": 2.0, "rod_angle": 45.0},
        "contact": law if friction < float("inf") else {"law": "infinite_friction"},
        "effects": [{"type": "support_friction", "weight": 1.0, "support": support}],
    }


def text(workflow: Path = Path("workflow")) -> str:
    """What the package's copy holds."""
    return json.dumps(collected(workflow), indent=1) + "\n"


if __name__ == "__main__":
    STORED.write_text(text(), encoding="utf-8")
    print(f"wrote {STORED}")
