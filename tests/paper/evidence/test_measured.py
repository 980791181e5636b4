"""The numbers on measured pushes: the rule's function on a small folder, and the project's file."""

import json
import math
import os
from pathlib import Path

import numpy as np
import pytest
from pushes.written import SQUARE, TRIANGLE, feet, write_log, write_mat

import planar_pushing as pp
from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.evidence import measured, published
from pulling_by_pushing.evidence.writing import json_text
from pulling_by_pushing.figures.measured import PUSHES_FILE

#: The environment variable that names the folder of the published logs.
FOLDER = "PLANAR_PUSHING_PUSHES"


@pytest.fixture
def folder(tmp_path):
    """A few simulated pushes in the published formats."""
    random = np.random.default_rng(3)
    for name in ("three_feet", "polygons"):
        (tmp_path / "data" / name).mkdir(parents=True)
    pushes = pp.simulate_pushes(feet(), TRIANGLE, 3, noise=None, seed=1)
    write_log(tmp_path / "data/three_feet/10_130_10_10_10_130.txt", pushes, random)
    square = 45.0 * np.array(SQUARE)
    uniform = (pp.SupportFriction(support=pp.Polygon(square), weight=5.0),)
    sides = pp.simulate_pushes(uniform, square, 3, noise=None, finger_radius=4.75, seed=2)
    write_mat(tmp_path / "data/polygons/abs_rect1.mat", sides, random)
    return tmp_path / "data"


def fake(folder, **_):
    """What a measurement of the folder tells, as a stand-in: the pushes that were read."""
    logs = pp.read_three_feet(*sorted(Path(folder, "three_feet").glob("*.txt")))
    polygons = pp.read_mit(*sorted(Path(folder, "polygons").glob("*.mat")))
    return {
        "three_feet": {"pushes": logs.sizes["push"], "length": 50.123456, "angle": math.nan},
        "polygons": {"pushes": polygons.sizes["push"], "ends": (1.00004, math.inf), "name": "b"},
    }


def test_the_file_is_sorted_and_rounded(folder, tmp_path, monkeypatch):
    monkeypatch.setattr(published, "measure", fake)
    target, digests = tmp_path / "pushes.json", tmp_path / "digests.txt"
    measured.measure(target, digests, folder=str(folder))
    text = target.read_text(encoding="utf-8")
    assert json.loads(text) == {
        "three_feet": {"pushes": 3, "length": 50.12, "angle": None},
        "polygons": {"pushes": 3, "ends": [1.0, None], "name": "b"},
    }
    assert [line.split('"')[1] for line in text.splitlines() if '"' in line] == [
        "polygons", "ends", "name", "pushes", "three_feet", "angle", "length", "pushes"
    ]  # fmt: skip
    measured.measure(target, digests, folder=folder)
    assert target.read_text(encoding="utf-8") == text
    named = [line.split("  ")[1] for line in digests.read_text().splitlines()]
    assert named == ["three_feet/10_130_10_10_10_130.txt", "polygons/abs_rect1.mat"]


def test_the_digests_are_those_of_the_logs(folder):
    before = measured.fingerprints(folder)
    log = next((folder / "three_feet").glob("*.txt"))
    log.write_text(log.read_text() + "\n")
    after = measured.fingerprints(folder)
    assert [a == b for a, b in zip(before.splitlines(), after.splitlines(), strict=True)] == [
        False,
        True,
    ]


def test_a_log_that_cannot_be_read_leaves_the_file(folder, tmp_path, monkeypatch):
    monkeypatch.setattr(published, "measure", fake)
    target = tmp_path / "pushes.json"
    target.write_text("before")
    log = next((folder / "three_feet").glob("*.txt"))
    log.write_text("\n".join(log.read_text().splitlines()[:40]))
    with pytest.raises(InvalidFile, match=r"10_130_10_10_10_130\.txt"):
        measured.measure(target, tmp_path / "digests.txt", folder=folder)
    assert target.read_text() == "before"
    assert not (tmp_path / "digests.txt").exists()


ALLOWED = "allowed: a folder with three_feet/*.txt and polygons/*.mat"


@pytest.mark.parametrize(
    ("made", "said"),
    [
        ([], f"no such folder; {ALLOWED}; give another path"),
        (["notes.txt"], f"contains no three_feet/*.txt; {ALLOWED}; add the logs"),
        (["three_feet/patch.txt"], f"contains no polygons/*.mat; {ALLOWED}; add the logs"),
        (["polygons/abs_hex.mat"], f"contains no three_feet/*.txt; {ALLOWED}; add the logs"),
    ],
)
def test_a_folder_without_logs_is_one_line(tmp_path, made, said):
    folder = tmp_path / "logs"
    for name in made:
        (folder / name).parent.mkdir(parents=True)
        (folder / name).touch()
    with pytest.raises(InvalidFile) as caught:
        measured.logs(folder)
    assert str(caught.value) == f"{folder}: {said}"


def paths(node, path=()):
    """Every leaf by its path."""
    children = node.items() if isinstance(node, dict) else enumerate(node)
    for key, each in children:
        if isinstance(each, (dict, list)):
            yield from paths(each, (*path, key))
        else:
            yield (*path, key), each


@pytest.mark.slow
@pytest.mark.skipif(FOLDER not in os.environ, reason=f"{FOLDER} names no folder of published logs")
def test_the_file_of_the_project_is_a_fresh_measurement():
    fresh = json.loads(json_text(measured.round_numbers(published.measure(os.environ[FOLDER]))))
    found, kept = dict(paths(fresh)), dict(paths(json.loads(Path(PUSHES_FILE).read_text("utf-8"))))
    assert found.keys() == kept.keys()
    for path, value in found.items():
        if isinstance(value, float):
            assert value == pytest.approx(kept[path], rel=2e-3, abs=1e-9), path
        else:
            assert value == kept[path], path
