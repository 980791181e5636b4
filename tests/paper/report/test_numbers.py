"""Numbers and tables of the report, read from the datasets of a small study, against published values."""

import csv
import io
import json
import platform
import re
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from report.costs import write_costs
from report.pushes import measured_pushes
from report.setting import check, cited, claim, claims
from scipy import special

import planar_pushing as pp
from planar_pushing.terms.errors import InvalidFile, InvalidValue
from planar_pushing.terms.netcdf import write_dataset
from pulling_by_pushing.evidence.golden.compare import Check, Kind
from pulling_by_pushing.evidence.golden.verdict import verdict
from pulling_by_pushing.evidence.writing import json_text, write_text
from pulling_by_pushing.figures.figure import drawing
from pulling_by_pushing.figures.studies import NUMBERS as FIGURE_NUMBERS
from pulling_by_pushing.report.provenance import commit, provenance_text
from pulling_by_pushing.report.quantities import decimal_text, significant
from pulling_by_pushing.report.results import Results
from pulling_by_pushing.report.tables import (
    NUMBERS,
    cones_text,
    ellipsoids_text,
    failures_text,
    figures_text,
    numbers_text,
    verdict_text,
)
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.running.build import build_dataset
from pulling_by_pushing.study.slices import computes, study_slice
from pulling_by_pushing.study.study_file import load_study

STUDY = load_study("workflow/config/paper.yaml")
SLIDERS = load_study("workflow/config/sliders.yaml")
#: Axes cut down to what the numbers read.
GRID = {
    "rod_length": (1.0, 2.0, 5.0, 10.0),
    "rod_angle": (45.0,),
    "friction_coefficient": (1.25, 1.5, 2.0, 5.0, np.inf),
    "force_angle": tuple(np.arange(0.0, 361.0, 5.0)),
    "inertia_share": (0.0, 1.0),
    "pusher_magnitude": (0.1, 10.0),
    "contact_friction_coefficient": (1.4, 2.0),
}
SMALL = STUDY.model_copy(update={"grid": STUDY.grid.model_copy(update=GRID)})
#: One rod length, which is all that is read of the contact modes.
SHORT = STUDY.model_copy(update={"grid": SMALL.grid.model_copy(update={"rod_length": (2.0,)})})
#: Datasets that do not depend on the axes above: the stored ones, which are those of the paper's study.
STORED = ("curves", "mode_maps", "model_errors", "model_estimates", "simulations/pulling")
CHECKS = [
    Check(file="motion_cones", variable="left", count=100, error=4.6e-13, ulp=32.6, allowed=5e-13),
    Check(file="scenes/figure_02", variable="force", count=200, error=1e-16, ulp=1, allowed=1e-14),
    Check(file="scenes/figure_03", variable="force", count=40),
    Check(file="accuracy/cone", variable="cone_error", count=10, kind=Kind.PLAIN),
]


#: Number of entries that the report cites, all proved.
CITED = len(cited())
#: Values of checks, by claim.
VALUES = {
    "pulling-condition": {"threshold": "1.5", "threshold-short-rod": "3.0000000000000000000"},
    "speed-decides-pulling": {"threshold": "1.2698754263747700920"},
    "pulling-offset": {"long-rod": "0.16348563257178672762", "short-rod": "0.23612569068667347739"},
    "normal-motion-dips": {
        "least": "-0.040029606666", "force": "1.40897274354", "return-force": "2.2251848605567233649"
    },
    "cones-beyond-the-pure-ones": {"both": "-8.7465912257"},
    "shape-of-an-l": {
        "along-normal": "-4.3266944542353924701",
        "difference": "0.042364491403414912815",
    },
    "motion-of-the-ellipsoid": {"ellipsoid-turns-motion": "19.471220634490691369"},
    "pivots-of-a-tripod": {"span": "70.528779365509308631"},
    "corner-of-a-line": {"span": "306.86989764584402130"},
    "integration-constants": {
        "square": "0.54107508004674399000", "rectangle": "0.53060409794183500000",
        "strip": "0.51455358851011300000", "disc": "0.66666666666666666667",
        "ring": "1.0000000000000000000",
    },
}  # fmt: skip


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """Datasets of the small study, a verdict and a ledger."""
    folder = tmp_path_factory.mktemp("results")
    for name, entry in DATASETS.items():
        if entry.fine or name in STORED or not computes(SMALL, name):
            continue
        study = SHORT if name == "contact_modes" else SMALL
        write_dataset(build_dataset(name, study_slice(study, name)), folder / f"data/{name}.nc")
    for name in STORED:
        (folder / f"data/{name}.nc").parent.mkdir(exist_ok=True)
        shutil.copy(f"tests/golden/{name}.nc", folder / f"data/{name}.nc")
    sliders = folder / "studies/sliders"
    write_dataset(
        build_dataset("supports", study_slice(SLIDERS, "supports")), sliders / "data/supports.nc"
    )
    write_costs(folder)
    known = [
        claim(name, *(check(part, value=value) for part, value in values.items()))
        for name, values in VALUES.items()
    ]
    for place in (folder, sliders):
        write_text(json_text(verdict(CHECKS)), place / "tables/golden_verdict.json")
    ledger = {"counts": {}, "claims": claims() + known}
    write_text(json.dumps(ledger), folder / "tables/claims.json")
    write_text(json.dumps(measured_pushes()), folder / "measured_pushes.json")
    return Results(folder, Path("tests/golden"), folder / "measured_pushes.json")


@pytest.fixture(scope="module")
def numbers(results):
    return json.loads(numbers_text(results))


@pytest.mark.parametrize(
    ("key", "text"),
    [
        ("velocity-cone-right", "-20.04"),
        ("velocity-cone-left", "140.16"),
        ("acceleration-cone-right", "-14.04"),
        ("infinite-acceleration-cone-left", "146.31"),
        ("infinite-cone-left", "138.84"),
        ("exact-cone-right", "-42.80"),
        ("conservative-cone-right", "-45.00"),
        ("excess-right", "2.20"),
        ("excess-left", "3.22"),
        ("ellipse-deviation", "6.3"),
        ("ellipse-deviation-long-rod", "9.7"),
        ("bound-reach", "1.41"),
        ("pull-end-time", "2.050"),
        ("pull-end-rod-angle", "57.90"),
        ("ellipse-minor-axis", "0.7071"),
        ("both-pulling-spin-ratio", "1.000"),
        ("slip-motion-angle", "138.8"),
        ("pulling-solutions", "3"),
        ("pushes", str(3 * 5 * 2 * 75)),
        ("first-without-solution", "148.6"),
        ("slow-pull", "-7.1"),
        ("fast-pull", "3.9"),
        ("golden-verdict", "passed"),
        ("golden-enclosed", "680"),
        ("golden-variables", "6"),
        ("golden-plain", "20"),
        ("golden-share", "97.1"),
        ("golden-precision", "160"),
        ("claims", str(CITED + 6 + len(VALUES))),
        ("claims-paper", str(CITED + 5 + len(VALUES))),
        ("claims-paper-proved", str(CITED + 1 + len(VALUES))),
        ("claims-paper-enclosed", "1"),
        ("claims-paper-open", "1"),
        ("claims-ours", "1"),
        ("claims-checks", str(5 + sum(map(len, VALUES.values())))),
        ("claims-proved", str(CITED + 2 + len(VALUES))),
        ("claims-enclosed", "1"),
        ("claims-sampled", "1"),
        ("claims-open", "1"),
        ("threshold-friction", "1.2699"),
        ("pulling-offset", "0.163"),
        ("beyond-both", "-8.75"),
        ("dip", "-0.0400"),
        ("l-cone-right", "-4.3"),
        ("pivot-span", "70.5"),
        ("constant-square", "0.5411"),
        ("pushes-feet-logs", "4"),
        ("pushes-face", "50"),
        ("pushes-objects", "2"),
        ("pushes-sides", "300"),
        ("pushes-objects-highest", "1.05"),
        ("pushes-fit-triangle", "25"),
        ("pushes-fit-polygon", "75"),
        ("time-processor", "Some Processor"),
        ("pushes-feet-motion-known-feet", "6.0"),
        ("pushes-face-motion-quartic-ratio", "0.85"),
        ("pushes-face-motion-quartic-ratio-high", "1.25"),
        ("pushes-face-motion-uniform", "22.5"),
        ("pushes-sides-pose-ratio-low", "0.63"),
        ("pushes-in-load-set", "75"),
    ],
)
def test_number(numbers, key, text):
    assert numbers[key]["text"] == text


def test_every_number_has_text_unit_and_source(numbers):
    assert list(numbers) == list(NUMBERS)
    for entry in numbers.values():
        assert entry["text"]
        assert entry["unit"]
        assert entry["source"]
        assert str(Path.cwd()) not in entry["source"]


def test_counts_of_pushes_add_up(numbers):
    parts = [
        int(numbers[f"{kind}-pushes"]["text"]) for kind in ("unique", "ambiguous", "inconsistent")
    ]
    assert sum(parts) == int(numbers["pushes"]["text"])
    assert min(parts) > 0


def test_every_coulomb_pull_can_slip(numbers, results):
    """The report says of each of these pushes that it has a slipping solution."""
    modes = results.dataset("contact_modes")
    coulomb = modes["mode"].isel(contact=modes.law.values == "coulomb")
    angle = modes.pusher_angle
    away = coulomb.sel(pusher_angle=angle[(angle > -180) & (angle < 0)])
    sticks = (away == pp.ContactMode.STICK).any("solution")
    slips = away.isin([pp.ContactMode.SLIP_RIGHT, pp.ContactMode.SLIP_LEFT]).any("solution")
    assert int(numbers["sticking-pulls"]["text"]) == int(sticks.sum()) > 0
    assert bool(slips.values[sticks.values].all())


def test_every_push_without_solution_is_under_the_second_definition(numbers, results):
    """As the report says of them."""
    modes = results.dataset("contact_modes")
    none = modes.outcome == int(pp.Outcome.INCONSISTENT)
    assert int(none.sum()) == int(none.sel(contact="infinite_friction_none").sum()) > 0


def test_under_the_second_definition_there_is_no_solution_left_of_the_cone(numbers, results):
    edge = float(results.dataset("motion_cones").motion_cone_left.sel(
        effects="support_friction", rod_length=2.0, rod_angle=45.0, friction_coefficient=np.inf
    ))  # fmt: skip
    assert numbers["first-without-solution"]["text"] == f"{edge:.1f}"
    slider = pp.Slider(rod_length=2.0, rod_angle=np.pi / 4)
    law = pp.InfiniteFriction("none")
    scene = pp.Scene(slider=slider, contact=law, effects=(pp.RingFriction(),))
    for angle, count in ((edge - 1e-6, 1), (edge + 1e-6, 0), (180 - 1e-6, 0), (180, 1)):
        assert len(pp.solve(scene, np.deg2rad(angle))) == count, angle


def test_ellipse_deviation_is_that_of_the_curve(numbers):
    k = np.linspace(0, 1, 2001)[1:-1]
    m = k**2
    force, torque = special.ellipe(m), (special.ellipe(m) - (1 - m) * special.ellipk(m)) / k
    force, torque = (
        np.concatenate(each) * 2 / np.pi for each in ((force, torque[::-1]), (torque, force[::-1]))
    )
    inside = torque < 2 * force
    short = force[inside][-1]
    sine = torque[inside] / force[inside] / 2
    ellipse = short / np.hypot(short * np.sqrt(1 - sine**2), sine)
    deviation = 100 * np.abs(force[inside] / ellipse - 1).max()
    assert float(numbers["ellipse-deviation"]["text"]) == pytest.approx(deviation, abs=0.1)


def test_cones_of_infinite_friction(results):
    rows = list(csv.DictReader(io.StringIO(cones_text(results))))
    assert [row["rod length"] for row in rows] == ["1", "2", "5", "10"]
    assert (rows[1]["friction, right"], rows[1]["inertia, left"]) == ("-31.39", "146.31")
    assert (rows[2]["both, exact, left"], rows[2]["both, bound of the paper, right"]) == (
        "138.84",
        "-45.00",
    )


def test_verdict_by_dataset(results):
    rows = {row["compared"]: row for row in csv.DictReader(io.StringIO(verdict_text(results)))}
    assert rows["motion cones"]["worst difference"] == "4.6e-13"
    assert rows["scenes"] == {
        "compared": "scenes",
        "variables": "4",
        "values": "480",
        "worst difference": "1.0e-16",
        "allowed there": "1.0e-14",
    }


def test_provenance_names_versions_and_no_folder(results):
    text = provenance_text(results, "workflow/config/paper.yaml", "abc of 2026-01-02")
    rows = dict(csv.reader(io.StringIO(text)))
    assert f"numpy {np.__version__}" in rows["packages"].split(", ")
    assert rows["Python"] == platform.python_version()
    assert rows["commit"] == "abc of 2026-01-02"
    assert rows["license"] == "MIT"
    assert "FLINT" in rows["golden data"]
    assert rows["study"] == "workflow/config/paper.yaml"
    assert str(Path.cwd()) not in text


def test_the_commit_says_whether_the_tree_was_clean(tmp_path):
    def git(*arguments):
        identity = ["-c", "user.name=n", "-c", "user.email=e@example.org"]
        subprocess.run(["git", "-C", tmp_path, *identity, *arguments], check=True)

    assert commit(tmp_path / "none").startswith("unknown")
    git("init", "--quiet")
    (tmp_path / "file").write_text("a")
    git("add", "file")
    git("commit", "--quiet", "--message=one", "--date=2026-01-02T03:04:05")
    assert re.fullmatch(r"[0-9a-f]{12} of \d{4}-\d\d-\d\d", commit(tmp_path))
    (tmp_path / "other").write_text("untracked")
    assert "changes" not in commit(tmp_path)
    (tmp_path / "file").write_text("b")
    assert commit(tmp_path).endswith(", with changes")


@pytest.fixture(scope="module")
def figures(tmp_path_factory):
    """Table of the figures, from golden data in place of results."""
    folder = tmp_path_factory.mktemp("whole")
    golden = Path("tests/golden")
    for file in golden.rglob("*.nc"):
        place = file.relative_to(golden)
        own = folder / ("studies/sliders" if place.parts[0] == "sliders" else "")
        target = own / "data" / (place.relative_to("sliders") if own != folder else place)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(file, target)
    write_costs(folder)
    write_text(json.dumps(measured_pushes()), folder / "measured_pushes.json")
    return json.loads(figures_text(Results(folder, golden, folder / "measured_pushes.json")))


def test_figures_table(figures):
    assert {name: values["number"] for name, values in figures.items()} == FIGURE_NUMBERS
    assert list(figures) == list(FIGURE_NUMBERS)
    assert figures["figure_06"]["file"] == "figures/figure_06"
    assert figures["support_limit_curves"]["file"] == "studies/sliders/figures/support_limit_curves"
    assert figures["figure_06"]["section"].startswith("Sec. 3.1")


def test_a_caption_names_the_machine_where_times_are_shown(figures):
    machine = "Machine: Some Processor, number of cores: 6, Python 3.98, NumPy 9.9."
    named = [name for name, entry in figures.items() if "Machine:" in entry["caption"]]
    assert named == ["accuracy"]
    for name in named:
        assert figures[name]["caption"] == f"{drawing(name).caption(None)} {machine}"


def test_ellipsoids_by_support(results):
    rows = {row["support"]: row for row in csv.DictReader(io.StringIO(ellipsoids_text(results)))}
    assert rows["ring"]["constant"] == "1.0000"
    assert rows["square"]["constant"] == "0.5411"
    errors = [float(text) for row in rows.values() for text in list(row.values())[2:]]
    assert 0 < min(errors) < max(errors) < 90
    assert all(float(row["force, mean"]) < float(row["force, worst"]) for row in rows.values())


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [(-1e-9, 2, "0.00"), (-20.0384, 2, "-20.04"), (2.5, 0, "2"), (1e6, 0, "1000000")],
)
def test_rounded(value, digits, text):
    assert decimal_text(value, digits) == text


def test_an_infinite_number_is_refused():
    with pytest.raises(InvalidValue, match="value: inf given; allowed: a finite number"):
        decimal_text(np.inf, 1)


def test_missing_tables_and_claims_are_named(results, tmp_path):
    empty = Results(tmp_path, tmp_path)
    with pytest.raises(InvalidFile, match="holds no golden data"):
        empty.golden_marks()
    with pytest.raises(InvalidFile, match=r"golden_verdict\.json: no such table; build it"):
        _ = empty.verdicts
    with pytest.raises(InvalidFile, match=r"claims\.json: no claim 'none'; allowed: claim-0"):
        results.check("none", "threshold")
    with pytest.raises(
        InvalidFile, match=r"no claim-0: check 'none'; allowed: some-edge, other-edge"
    ):
        results.check("claim-0", "none")
    write_text("{", tmp_path / "tables/claims.json")
    with pytest.raises(InvalidFile, match=r"claims\.json: is not JSON"):
        _ = empty.claims
    for path in verdict_files(tmp_path):
        write_text(json_text(verdict([])), path)
    with pytest.raises(InvalidFile, match="compares nothing"):
        verdict_text(empty)


def verdict_files(folder):
    return [folder / each / "tables/golden_verdict.json" for each in (".", "studies/sliders")]


def test_a_failed_check_is_in_the_numbers_and_has_a_table(results, tmp_path):
    assert failures_text(results) == "compared,differ,worst difference,allowed there\n"
    paper, sliders = verdict_files(tmp_path)
    wrong = [replace(CHECKS[0], failed=3, error=np.inf), Check(file="scenes", problem="is gone")]
    write_text(json_text(verdict([*CHECKS[1:], *wrong])), paper)
    write_text(json_text(verdict(CHECKS)), sliders)
    failed = Results(tmp_path, tmp_path)
    assert NUMBERS["golden-verdict"].entry(failed)["text"] == "failed"
    assert failures_text(failed).splitlines()[1:] == [
        "motion_cones: left,3 of 100,infinite,5.0e-13", "scenes is gone,,,",
    ]  # fmt: skip
    rows = {row["compared"]: row for row in csv.DictReader(io.StringIO(verdict_text(failed)))}
    assert rows["motion cones"]["worst difference"] == "infinite"


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0.0"),
        (9.6, "9.6"),
        (0.31, "0.31"),
        (0.0999, "0.10"),
        (0.004, "4.0e-03"),
        (-12345.0, "-12345"),
        (1e5, "1.0e+05"),
    ],
)
def test_a_power_of_ten_only_where_it_is_needed(value, text):
    assert significant(value) == text
