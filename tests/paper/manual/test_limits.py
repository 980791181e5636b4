"""The page on limits has the errors of the measured pushes as they are stored."""

import json
from pathlib import Path

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
