"""The page on limits: its numbers of measured pushes are those stored, and its remedies are right."""

import json
import re
from pathlib import Path

import numpy as np
import pytest

from pulling_by_pushing.figures.measured import PUSHES_FILE

TEXT = Path("paper/manual/limits.md").read_text(encoding="utf-8")
MEASURED = json.loads(Path(PUSHES_FILE).read_text(encoding="utf-8"))
MODELS = ("known_feet", "identified", "uniform", "fitted_ellipsoid", "fitted_quartic")


@pytest.mark.parametrize(
    ("part", "error"), [("three_feet", "motion"), ("patch", "motion"), ("polygons", "pose")]
)
def test_errors_of_measured_pushes(part, error):
    measured = MEASURED[part]
    pushes = measured["pushes"] - measured.get("corner_pushes", 0)
    (row,) = (line for line in TEXT.splitlines() if line.startswith(f"| {pushes} of "))
    medians = measured["comparison"][error]
    numbers = [f"{medians[model]['median']:.1f}" if model in medians else "-" for model in MODELS]
    assert [cell.strip() for cell in row.strip("|").split("|")][1:] == numbers


@pytest.fixture(scope="module")
def names():
    """What the blocks of the page leave behind."""
    found = {}
    for block in re.findall(r"```python\n(.*?)```", TEXT, re.DOTALL):
        lines = [line[4:] for line in block.splitlines() if line.startswith((">>> ", "... "))]
        exec(compile("\n".join(lines), "limits.md", "exec"), found)
    return found


def test_on_a_table_that_moves_friction_opposes_the_motion_relative_to_it(names):
    """The torque of friction about the contact, summed over a grid of the base, vanishes in the world."""
    log, table, positions = (names[name] for name in ("log", "table", "positions"))
    turn = np.deg2rad(log.object_angle.values)
    x, y = np.meshgrid((np.arange(300) + 0.5) / 1000 - 0.15, (np.arange(200) + 0.5) / 1000 - 0.1)
    row = log.sizes["time"] // 2
    velocity = (positions[row + 1] - positions[row - 1]) / (
        log.time[row + 1] - log.time[row - 1]
    ).item()
    spin = (turn[row + 1] - turn[row - 1]) / (log.time[row + 1] - log.time[row - 1]).item()
    c, s = np.cos(turn[row]), np.sin(turn[row])
    arm = np.stack([c * x - s * y, s * x + c * y])
    over_table = velocity[:, None, None] - table[:, None, None] + spin * np.stack([-arm[1], arm[0]])
    force = -over_table / np.hypot(*over_table)
    # The finger is where the world has it, and its force goes through it.
    touch = names["finger"] * log.time[row].item() + [0.04, -0.1] - positions[row]
    torque = np.mean((arm[0] - touch[0]) * force[1] - (arm[1] - touch[1]) * force[0])
    assert torque == pytest.approx(0, abs=2e-4)  # of the weight times a meter
    # Relative to the floor at rest, it does not vanish.
    on_floor = over_table + table[:, None, None]
    force = -on_floor / np.hypot(*on_floor)
    assert abs(np.mean((arm[0] - touch[0]) * force[1] - (arm[1] - touch[1]) * force[0])) > 0.01


def test_the_larger_sliding_number_of_two_geoms_is_the_coefficient_of_their_contact():
    mujoco = pytest.importorskip("mujoco")
    text = """<mujoco><worldbody><geom type="plane" size="1 1 1" friction="0.3 0.005 0.0001"/>
    <body pos="0 0 0.09"><freejoint/><geom type="box" size="0.1 0.1 0.1" friction="0.8 0.01 0.0001"/>
    </body></worldbody></mujoco>"""
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    friction = data.contact.friction[0].tolist()
    assert friction[:2] == [0.8, 0.8]
    assert friction[2] == 0.01
    assert data.contact.dim[0] == 3  # without torsion


@pytest.mark.parametrize(
    ("part", "rival"),
    [
        ("three_feet", "fitted_ellipsoid"),
        ("three_feet", "fitted_quartic"),
        ("patch", "fitted_quartic"),
    ],
)
def test_ratios_of_medians(part, rival):
    row = MEASURED[part]["against"][rival]["motion"]
    low, high = row["ratio_interval"]
    assert f"{row['ratio']:.2f} (95 % interval {low:.2f} to {high:.2f})" in TEXT
    assert f"{MEASURED['splits']} random splits" in TEXT
