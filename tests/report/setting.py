"""A folder from which the report can be set: its sources, and results that hold marked values."""

from __future__ import annotations

import json
import shutil
from dataclasses import dataclass
from pathlib import Path

from planar_pushing.figures.catalog import CAPTIONS, FIGURES, PROMISES, SECTIONS
from planar_pushing.report.numbers import NUMBERS
from planar_pushing.report.parts.evidence import VERDICTS

PAPER = Path(__file__).parents[2] / "paper"
PICTURE = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="40pt" height="20pt" viewBox="0 0 40 20">'
    '<circle cx="20" cy="10" r="8"/></svg>'
)
NOTHING = {
    "section": None,
    "equation": None,
    "figure": None,
    "value": None,
    "radius": None,
    "unit": None,
    "claimed": None,
    "margin": None,
    "points": None,
    "method": None,
    "reason": None,
}
CONES = "rod length," + ",".join(f"{side} {i}" for i in range(4) for side in "rl") + "\n"


@dataclass(frozen=True)
class Setting:
    """A folder with paper/ and results/."""

    root: Path

    @property
    def source(self) -> Path:
        return self.root / "paper" / "report.typ"

    @property
    def tables(self) -> Path:
        return self.root / "results" / "tables"

    def numbers(self) -> dict[str, dict[str, str]]:
        found: dict[str, dict[str, str]] = json.loads((self.tables / "numbers.json").read_text())
        return found

    def write_numbers(self, numbers: dict[str, dict[str, str]]) -> None:
        (self.tables / "numbers.json").write_text(json.dumps(numbers), encoding="utf-8")


def claim(name: str, **values: object) -> dict[str, object]:
    """A claim of the ledger as claims.json has it."""
    given = {"id": name, "origin": "paper", "statement": "A statement.", "verdict": "proved"}
    return NOTHING | given | values


def claims() -> list[dict[str, object]]:
    """One claim of each verdict, and one of ours."""
    marked = [
        claim(f"claim-{i}", verdict=verdict, statement=f"Statement number {i} on mu and f_x.")
        for i, verdict in enumerate(VERDICTS)
    ]
    shown = {"value": "-20.125", "unit": "degree", "margin": -1.5e-12, "section": "3.1"}
    refuted = {"reason": "The sign is the other one.", "equation": 13, "figure": 5, "points": 4321}
    marked[0] |= shown
    marked[-1] |= refuted
    return [*marked, claim("claim-ours", origin="ours", value="1.375", unit="1", margin=0.25)]


def set_up(root: Path) -> Setting:
    setting = Setting(root)
    shutil.copytree(PAPER, root / "paper")
    pictures = root / "results" / "figures"
    pictures.mkdir(parents=True)
    setting.tables.mkdir()
    for name in FIGURES:
        (pictures / f"{name}.svg").write_text(PICTURE, encoding="utf-8")
    figures = {
        name: {
            "caption": CAPTIONS[name],
            "promise": PROMISES[name],
            "section": SECTIONS[name],
            "margins": {"top": 1.0, "bottom": 2.0},
        }
        for name in FIGURES
    }
    setting.write_numbers(
        {
            key: {"text": "0", "unit": each.unit, "source": each.source}
            for key, each in NUMBERS.items()
        }
    )
    tables = {
        "figures.json": json.dumps(figures),
        "claims.json": json.dumps({"counts": {}, "claims": claims()}),
        "infinite_friction_cones.csv": CONES + "0.5" + ",-1.25,178.75" * 4 + "\n",
        "golden_summary.csv": "a,b,c,d,e\nmotion cones,7,65432,1.5e-15,2e-14\n",
        "provenance.csv": "what,version\nnumpy,9.8.7\n",
    }
    for name, text in tables.items():
        (setting.tables / name).write_text(text, encoding="utf-8")
    return setting
