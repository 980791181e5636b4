"""The verdict: the worst first, the same in text and in data, and the data are JSON."""

import json
import math

from planar_pushing.evidence.golden.compare import Check
from planar_pushing.evidence.golden.rules import Rule
from planar_pushing.evidence.golden.verdict import NOTE, verdict, verdict_text
from planar_pushing.evidence.writing import json_text

AGREES = Check(file="cones", variable="left", count=100, error=4.6e-13, ulp=32.6, allowed=5e-13)
ZERO = Check(
    file="curves", variable="spin", count=7, error=1e-14, ulp=math.inf, allowed=2e-14, where="a=1"
)
WRONG = Check(file="cones", variable="size", count=6, failed=1, error=1.0, ulp=2e15, allowed=1e-9)
MISSING = Check(file="scenes.one", variable="force", problem="is missing from the result")
SOLVED = Check(file="modes", variable="spin_ratio", rule=Rule.RESIDUAL, count=3000)
UNREADABLE = Check(file="figure_01", problem="cannot be compared: no such file")


def test_agreement_is_counted():
    found = verdict([ZERO, AGREES])
    assert (found["passed"], found["values"], found["variables"]) == (True, 107, 2)
    assert verdict_text(found).splitlines() == [
        "passed: every value agrees",
        "  107 values of 2 variables enclosed by the golden data",
        "  0 values of 0 variables verified by residual in their equations",
        "  0 values of 0 variables compared exactly",
        "  0 values of 0 variables computed anew",
        "",
        NOTE,
        "",
        "ok   cones: left (enclosure): 100 agree; worst 4.6e-13 (32.6 ulp), allowed 5e-13",
        "ok   curves: spin (enclosure): 7 agree; worst 1e-14, allowed 2e-14 at a=1",
    ]


def test_rules_are_counted_apart():
    found = verdict([AGREES, SOLVED])
    assert (found["values"], found["variables"]) == (100, 1)
    assert found["rules"]["residual"] == {"values": 3000, "variables": 1}
    assert [each["file"] for each in found["verified"]] == ["modes"]
    assert "  3000 values of 1 variables verified by residual" in verdict_text(found)


def test_the_worst_stands_first():
    lines = verdict_text(verdict([AGREES, WRONG, MISSING, UNREADABLE])).splitlines()
    assert lines[0] == "FAILED: 3 of 4 checks"
    assert lines[8] == "FAIL figure_01 cannot be compared: no such file"
    assert lines[9] == "FAIL scenes.one: force is missing from the result"
    assert lines[10].startswith("FAIL cones: size (enclosure): 1 of 6 differ; worst 1 (")
    assert lines[11].startswith("ok   cones: left (enclosure): 100 agree")


def test_the_data_are_json_and_hold_every_check():
    found = json.loads(json_text(verdict([AGREES, ZERO])))
    assert [each["file"] for each in found["checks"]] == ["cones", "curves"]
    assert found["checks"][0]["error"] == 4.6e-13
    assert found["checks"][1]["ulp"] is None
    assert verdict_text(found) == verdict_text(verdict([AGREES, ZERO]))
