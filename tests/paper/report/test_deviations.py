"""The values that deviations.md lists, and the report prints, are those of the study."""

import re
from pathlib import Path

import pytest

from planar_pushing.scenes.files import load_scene_file
from pulling_by_pushing.figures.paper.mappings import INSIDE
from pulling_by_pushing.study.study_file import load_study

STUDY = load_study("workflow/config/paper.yaml")
SCENES = {name: load_scene_file(push.file) for name, push in STUDY.scenes.items()}
PUSHES, FIGURES = STUDY.scenes, STUDY.figures


def both(read):
    """Value that Figs. 2 and 3 share."""
    second, third = read("figure_02"), read("figure_03")
    assert second == third
    return [second]


CHOSEN = {
    ("everywhere", "weight times support friction, W"): lambda: [STUDY.support_friction.weight],
    ("Fig. 1", "rod length, coefficient of friction"): lambda: [
        FIGURES["figure_01"].rod_length,
        FIGURES["figure_01"].friction_coefficient,
    ],
    ("Fig. 1", "pusher angle"): list,
    ("Figs. 2 and 3", "rod length"): lambda: both(lambda name: SCENES[name].slider.rod_length),
    ("Figs. 2 and 3", "coefficient of friction"): lambda: both(
        lambda name: SCENES[name].contact.friction_coefficient
    ),
    ("Fig. 2", "force angle"): lambda: [PUSHES["figure_02"].force_angle],
    ("Fig. 3", "force angle"): lambda: [PUSHES["figure_03"].force_angle],
    ("Fig. 5", "rod lengths"): lambda: list(FIGURES["figure_05"].rod_length),
    ("Fig. 7", "rod lengths"): lambda: list(FIGURES["figure_07"].rod_length),
    ("Fig. 8", "pusher angle"): lambda: [PUSHES["figure_08"].pusher_angle],
    ("Fig. 9", "pusher angle"): lambda: [
        PUSHES[f"figure_09{panel}"].pusher_angle for panel in "ab"
    ],
    ("Fig. 10", "rod lengths"): lambda: list(FIGURES["figure_10"].rod_length),
    ("Fig. 10", "coefficient of friction of the mapped cone"): lambda: [
        FIGURES["figure_10"].friction_coefficient
    ],
    ("Figs. 6 and 10", "force angles drawn inside the cone"): lambda: list(INSIDE),
    ("Fig. 11", "coefficient of friction, magnitudes"): lambda: [
        SCENES["figure_11"].contact.friction_coefficient,
        STUDY.inertia.mass,
    ],
    ("Fig. 12", "pusher angle"): lambda: [PUSHES["figure_12"].pusher_angle],
}


def rows():
    lines = Path("paper/deviations.md").read_text(encoding="utf-8").splitlines()
    cells = [
        [cell.strip() for cell in line.strip("|").split("|")] for line in lines if line[:1] == "|"
    ]
    return {(where, value): chosen for where, value, chosen, _ in cells[2:]}


def test_every_value_is_checked():
    assert set(rows()) == set(CHOSEN)


@pytest.mark.parametrize("key", CHOSEN, ids=" ".join)
def test_value_is_that_of_the_study(key):
    numbers = [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?", rows()[key])]
    assert numbers == pytest.approx(CHOSEN[key]())
