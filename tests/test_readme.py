"""README shows what the program prints and draws, and its numbers are those of the results."""

import doctest
import json
import re
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import planar_pushing as pp
from planar_pushing.commands import main
from planar_pushing.drawing.words import NUMBERS as NUMBER_WORDS
from planar_pushing.terms.netcdf import write_dataset
from pulling_by_pushing.evidence.claims.ledger import load_ledger
from pulling_by_pushing.figures.figure import entry
from pulling_by_pushing.figures.front_box import DIRECTION, DURATION, box_motions, box_scene
from pulling_by_pushing.figures.measured import PUSHES_FILE
from pulling_by_pushing.figures.studies import NUMBERS
from pulling_by_pushing.study.running.build import build_dataset
from pulling_by_pushing.study.slices import study_slice
from pulling_by_pushing.study.study_file import load_study
from shown import Checker

PATH = Path("README.md").resolve()
README = PATH.read_text(encoding="utf-8")
#: Commands, which may have several lines.
COMMANDS = [
    command.split()
    for command in re.findall(
        r"^planar-pushing (.*)$", re.sub(r" \\\n *", " ", README), re.MULTILINE
    )
]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Folder with the dataset that README queries and the scenes of the project."""
    root = tmp_path_factory.mktemp("readme")
    study = load_study("workflow/config/paper.yaml")
    cones = build_dataset("motion_cones", study_slice(study, "motion_cones"))
    write_dataset(cones, root / "results/data/motion_cones.nc")
    (root / "workflow").symlink_to(PATH.parent / "workflow")
    return root


def test_python(folder, monkeypatch):
    monkeypatch.chdir(folder)
    blocks = re.findall(r"```python\n(>>> .*?)```", README, re.DOTALL)
    assert len(blocks) == README.count("```python") == 3
    test = doctest.DocTestParser().get_doctest("\n".join(blocks), {}, "README", "README.md", 0)
    runner = doctest.DocTestRunner(Checker(), optionflags=doctest.NORMALIZE_WHITESPACE)
    runner.run(test, clear_globs=False)
    assert (runner.tries, runner.failures) == (14, 0)
    (call,) = re.findall(r"`pp\.(draw\(.*?\))` draws", README)
    assert eval(f"pp.{call}", test.globs) is not None
    # The picture is of this box, these motions and this duration.
    assert test.globs["push"] == box_scene()
    shown = box_motions()
    assert [mode.name for mode in pp.solve(box_scene(), np.deg2rad(DIRECTION)).modes] == [
        mode.name for mode in shown
    ]
    log = test.globs["log"]
    assert log.time[-1].item() == pytest.approx(DURATION, rel=1e-12, abs=0)
    assert shown[pp.ContactMode.SLIP_LEFT].path_slip[-1].item() == log.slip[-1].item()


def test_every_call_for_a_question_exists():
    rows = re.findall(r"^\| .*\? \| (.*) \|$", README, re.MULTILINE)
    assert len(rows) == 8
    calls = re.findall(r"`pp\.(\w+)`", " ".join(rows))
    assert len(calls) >= len(rows)
    assert set(calls) <= set(pp.__all__)


def test_commands_animate_a_retreat(folder, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    commands = [words for words in COMMANDS if words[0] in ("simulate", "animate")]
    assert [main(command) for command in commands] == [0, 0]
    capsys.readouterr()
    with Image.open("pulling.gif") as image:
        assert image.n_frames == 40


def test_verdict_of_the_replication():
    verdicts = Counter(
        c.expect for c in load_ledger("paper/claims.yaml").claims if c.origin == "paper"
    )
    pattern = (
        r"Of the (\d+) statements that we extracted, (\d+) are proved, and (\d+), .*? (\w+) has a "
        r"wrong sign .*? (\w+) are open"
    )
    words = re.search(pattern, " ".join(README.split())).groups()
    numbers = [int(word) if word.isdigit() else NUMBER_WORDS.index(word.lower()) for word in words]
    kinds = ("proved", "enclosed", "refuted", "open")
    assert numbers == [verdicts.total(), *(verdicts[kind] for kind in kinds)]


@pytest.mark.slow  # .ci/run runs the slow tests after make, which writes the results
def test_numbers_of_the_golden_check_are_those_of_the_results():
    table = Path("results/tables/numbers.json")
    if not table.exists():
        pytest.skip("there are no results; make builds them")
    number = int(json.loads(table.read_text(encoding="utf-8"))["golden-enclosed"]["text"])
    assert f"{number / 1e6:.1f} million numbers" in README


def test_thresholds_of_pulling():
    slow, inertia = re.search(
        r"friction that pulling requires .*? it is ([\d.]+) for small accelerations and ([\d.]+), ",
        " ".join(README.split()),
    ).groups()
    slider = pp.Slider(rod_length=2, rod_angle=np.pi / 4)
    for threshold, effect in ((slow, pp.RingFriction()), (inertia, pp.Inertia())):
        for shift, pulls in ((-0.005, False), (0.005, True)):
            scene = pp.Scene(
                slider=slider, contact=pp.Coulomb(float(threshold) + shift), effects=(effect,)
            )
            assert bool(pp.can_pull(scene)) is pulls


def test_numbers_of_measured_pushes():
    measured = json.loads(Path(PUSHES_FILE).read_text(encoding="utf-8"))
    feet, face = measured["three_feet"], measured["patch"]
    motion = feet["comparison"]["motion"]
    models = ("identified", "fitted_ellipsoid", "fitted_quartic")
    numbers = [f"{motion[model]['median']:.1f}" for model in models]
    assert re.findall(r"(\d+\.\d)\s+degrees", README) == numbers
    assert f"means over {measured['splits']} splits" in README
    # The sentences of README, limits and report: a gain over both rivals, in the middle of the
    # distribution, none over the true feet, and no difference from the quartic on the face.
    for rival in ("fitted_ellipsoid", "fitted_quartic"):
        gain = feet["against"][rival]["motion"]
        assert gain["ratio_interval"][1] < 1.0
        low, high = gain["ratio_90_interval"]
        assert low < 1.0 < high
        assert gain["ratio"] < gain["ratio_90"]
    for row in (feet["against"]["known_feet"], face["against"]["fitted_quartic"]):
        low, high = row["motion"]["ratio_interval"]
        assert low < 1.0 < high


@pytest.mark.parametrize("name", [f"figure_{number:02}" for number in range(1, 14)])
def test_table_of_figures(name):
    figure = entry(name)
    sources = ", ".join(f"`{source}`" for source in figure.reads)
    picture = f"[{NUMBERS[name]}](tests/golden/images/{name}.png)"
    assert f"| {picture} | {figure.title} | {sources} |\n" in README


def test_query_in_the_shell(folder, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    (command,) = (words for words in COMMANDS if words[0] == "query")
    assert main(command) == 0
    assert "-20.03845755163776" in capsys.readouterr().out


def test_the_citation_names_the_newest_version_and_the_date_of_its_tag():
    changes = (PATH.parent / "CHANGELOG.md").read_text(encoding="utf-8")
    pattern = r"^## (\d\S*) \((?:(\d{4}-\d\d-\d\d)|not tagged yet)\)$"
    version, date = re.search(pattern, changes, re.MULTILINE).groups()
    citation = (PATH.parent / "CITATION.cff").read_text(encoding="utf-8")
    assert re.findall(r"^version: (.*)$", citation, re.MULTILINE) == [version]
    dates = re.findall(r"^date-released: (.*)$", citation, re.MULTILINE)
    assert dates == ([date] if date else [])
    assert version == pp.__version__
