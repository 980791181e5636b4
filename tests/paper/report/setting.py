"""A folder from which the report can be set: its sources, and results that hold marked values."""

from __future__ import annotations

import json
import re
import shutil
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from report.pushes import measured_pushes

from pulling_by_pushing.evidence.claims.ledger import load_ledger
from pulling_by_pushing.evidence.claims.table import COLUMNS
from pulling_by_pushing.figures.figure import entry, full_caption, view
from pulling_by_pushing.figures.studies import NUMBERS as FIGURE_NUMBERS
from pulling_by_pushing.figures.studies import OURS, PUSHES, cuts
from pulling_by_pushing.report.parts.evidence import VERDICTS
from pulling_by_pushing.report.quantities import Numbers
from pulling_by_pushing.report.tables import NUMBERS
from pulling_by_pushing.study.model import StudyFile
from pulling_by_pushing.study.store import read_dataset
from pulling_by_pushing.study.studies import PAPER_FILE, SLIDERS_FILE
from pulling_by_pushing.study.study_file import load_study

Entries = dict[str, dict[str, str]]
#: Table of the numbers of the report.
REPORT = "numbers.json"
PAPER = Path(__file__).parents[3] / "paper"
PICTURE = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="40pt" height="20pt" viewBox="0 0 40 20">'
    '<circle cx="20" cy="10" r="8"/></svg>'
)
#: Studies of the figures.
STUDIES = (PAPER_FILE, SLIDERS_FILE)
NOTHING = dict.fromkeys(COLUMNS)
PROVENANCE = 'what,value\nplanar-pushing,9.8.7\ncommit,"0a1b2c of 2026-01-02"\nlicense,MIT\n'
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

    def numbers(self, file: str = REPORT) -> Entries:
        found: Entries = json.loads((self.tables / file).read_text())
        return found

    def write_ledger(self) -> None:
        """Write the ledger of the paper, each entry with the verdict that it expects."""
        ledger = load_ledger(PAPER / "claims.yaml")
        rows = [
            entry.model_dump(exclude={"expect", "checks"})
            | {"verdict": entry.expect}
            | {
                "checks": [
                    check(each.title, statement=each.statement, how=ledger.arguments[each.argument])
                    for each in entry.checks
                ]
            }
            for entry in ledger.claims
        ]
        content = json.dumps({"counts": {}, "claims": rows})
        (self.tables / "claims.json").write_text(content, encoding="utf-8")

    def write_numbers(self, numbers: Entries, file: str = REPORT) -> None:
        (self.tables / file).write_text(json.dumps(numbers), encoding="utf-8")


#: Golden numbers of the figures.
GOLDEN = Path("tests/golden")


def zeros(numbers: Numbers) -> Entries:
    """Entries of numbers that are all zero."""
    return {
        key: {"text": "0", "unit": each.unit, "source": each.source}
        for key, each in numbers.items()
    }


def claim(name: str, *checks: dict[str, object], **values: object) -> dict[str, object]:
    """A claim of the ledger as claims.json has it."""
    place = {"section": "3", "equations": [], "figures": []}
    text = {"short": f"Short for {name}", "statement": "A statement."}
    given = {"id": name, "origin": "paper", "verdict": "proved"}
    return place | text | given | {"reason": None, "checks": list(checks)} | values


def check(name: str, **values: object) -> dict[str, object]:
    """A check of a claim."""
    known = {"verdict": "proved", "how": "An argument with $psi$.", "means": "identities"}
    return NOTHING | {"name": name} | known | values


def cited() -> list[str]:
    """Entries of the ledger to which the sections refer."""
    text = "".join(path.read_text(encoding="utf-8") for path in PAPER.glob("sections/*.typ"))
    return sorted(set(re.findall(r"\b(?:claim|theorem|verdict-row)\(\"([\w-]+)\"", text)))


def claims() -> list[dict[str, object]]:
    """One claim of each verdict, one of ours, and those that the report cites."""
    marked = [
        claim(f"claim-{i}", verdict=verdict, short=f"Number {i} on $mu$ and $f_x$")
        for i, verdict in enumerate(VERDICTS)
    ]
    edge = {"verdict": "enclosed", "how": "A change of sign."}
    shown = check("some-edge", value="-20.125", unit="degree", **edge)
    sampled = check("some-sample", verdict="sampled", points=4321, statement="A part of it.")
    alike = check("other-edge", value="1.5", unit="W", **edge)
    unsaid = check("own-margin", value="0.875", unit="1", how="A proof.")
    marked[0] |= {"section": "3.1", "checks": [shown, alike, sampled, unsaid]}
    marked[-1] |= {"reason": "The sign is the other one.", "equations": [12, 13], "figures": [5]}
    ours = check("own", value="1.375", unit="1", claimed=1.375, how="Another argument.")
    return [*marked, claim("claim-ours", ours, origin="ours"), *map(claim, cited())]


def captioned(name: str, root: Path) -> str:
    """Caption of a figure from golden data; those of ours show hard cases, or read none."""
    if name in PUSHES:
        return full_caption(name, measured_pushes())
    if name in OURS:
        return full_caption(name, {"hard_cases": read_dataset(GOLDEN / "hard_cases.nc")})
    study, golden = next(pair for pair in map(load_golden, STUDIES) if name in pair[0].figures)
    data = root / "golden" / golden.name / "data"
    if not data.exists():
        data.parent.mkdir(parents=True)
        data.symlink_to(golden.resolve())
    return full_caption(name, view(name, data.parent, cuts(study, name)))


@cache
def load_golden(file: str) -> tuple[StudyFile, Path]:
    """A study and the folder of its golden data."""
    study = load_study(file)
    return study, Path(study.golden)


def set_up(root: Path) -> Setting:
    setting = Setting(root)
    shutil.copytree(PAPER, root / "paper")
    shutil.copy(PAPER.parent / "CITATION.cff", root)
    pictures = root / "results" / "figures"
    pictures.mkdir(parents=True)
    setting.tables.mkdir()
    for name in FIGURE_NUMBERS:
        (pictures / f"{name}.svg").write_text(PICTURE, encoding="utf-8")
    figures = {
        name: {
            "number": number,
            "caption": captioned(name, root),
            "promise": entry(name).promise,
            "section": entry(name).section,
            "file": f"figures/{name}",
        }
        for name, number in FIGURE_NUMBERS.items()
    }
    setting.write_numbers(zeros(NUMBERS))
    tables = {
        "figures.json": json.dumps(figures),
        "claims.json": json.dumps({"counts": {}, "claims": claims()}),
        "infinite_friction_cones.csv": CONES + "0.5" + ",-1.25,178.75" * 4 + "\n",
        "golden_failures.csv": "compared,differ,worst difference,allowed there\n",
        "provenance.csv": PROVENANCE,
        # The other tables are those of the manual.
        "golden_summary.csv": "a,b,c,d,e\nmotion cones,7,65432,1.5e-15,2e-14\n",
        "ellipsoids.csv": "a,b,c,d,e,f\nsome support,0.4725,1.1,2.2,3.3,4.4\n",
        "accuracy.csv": "of,method,setting,calls,error,time\nwrench,some rule,64,4711,3.5e-09,0.25 ns\n",
        "hard_places.csv": "place,cases,ill,over,largest\nsome place,41,2,3,4713\n",
        "hard_ill.csv": "case,condition,digits,error\nsome case at phi = 4.5,3.7e+08,7,3.8e+06\n",
        "effects.csv": "a,b,c,d\none push,4714,0,4715\n",
    }
    for name, text in tables.items():
        (setting.tables / name).write_text(text, encoding="utf-8")
    return setting
