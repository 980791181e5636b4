"""The command `query`, with right and with wrong input."""

import json
import shutil

import pytest
import xarray as xr

from planar_pushing.commands import main
from planar_pushing.terms.netcdf import write_dataset
from pulling_by_pushing.study.catalog import DATASETS
from smoke import smoke_results


def test_query(run, results):
    words = [
        "--effects",
        "inertia",
        "--rod-length",
        "2",
        "--rod-angle",
        "45",
        "--friction-coefficient",
        "2",
    ]
    code, out, _ = run("query", "motion_cones", "--results", results, *words)
    assert code == 0
    assert "effects=inertia, rod_length=2.0" in out
    assert "motion_cone_right [degree]    -14.036243467" in out


def test_query_with_equals_signs(run, results):
    words = ["--effects=inertia", "--rod-length=2", "--rod-angle=45", "--friction-coefficient=inf"]
    code, out, _ = run("query", "motion_cones", "--results", results, *words)
    assert code == 0
    assert "motion_cone_right [degree]    -33.69006752597" in out


def test_query_of_several_axes_prints_a_table_each(run, results):
    code, out, _ = run("query", "motion_cones", "--results", results, "--rod-length", "2")
    assert code == 0
    assert out.startswith("rod_length=2.0, radius=1.0, ")
    assert out.count("motion_cone_right [degree]") == 1


CONTACT = [
    "--effects", "support_friction", "--contact", "coulomb_2", "--rod-length", "2",
    "--pusher-magnitude", "1",
]  # fmt: skip


def test_query_of_solutions_names_the_modes(run, results):
    asked = ["--results", results, *CONTACT, "--pusher-angle", "-15"]
    code, out, _ = run("query", "contact_modes", *asked)
    assert code == 0
    assert "outcome    AMBIGUOUS" in out
    assert " twist [motion, motion, radian motion/length]\n" in out
    table = out[out.index("mode  consistent") :].splitlines()[2:5]
    assert [line.split()[:2] for line in table] == [
        ["0", "SEPARATE"], ["1", "STICK"], ["2", "SLIP_LEFT"],
    ]  # fmt: skip


def test_places_behind_the_last_solution_are_not_printed(run, results):
    code, out, _ = run("query", "contact_modes", "--results", results, *CONTACT)
    assert code == 0
    assert "NaN" not in out
    assert " - " not in out


def test_query_json(run, results):
    words = ["--rod-length", "2", "--friction-coefficient", "inf", "--json"]
    code, out, _ = run("query", "motion_cones", "--results", results, *words)
    told = json.loads(out)
    assert code == 0
    assert told["dims"] == {"effects": 3, "rod_angle": 2}
    assert told["coords"]["friction_coefficient"]["data"] == "inf"


def test_query_lists_the_axes_and_their_values(run, results):
    code, out, _ = run("query", "motion_cones", "--results", results, "--axes")
    assert code == 0
    assert [line.partition(":")[0] for line in out.splitlines()] == [
        "--effects", "--friction-angle", "--friction-coefficient", "--rod-angle", "--rod-length",
    ]  # fmt: skip
    assert "--rod-length: 0, 1, 2, 5" in out
    _, out, _ = run("query", "motion_cones", "--results", results, "--axes", "--rod-length", "2")
    assert "--rod-length" not in out


def test_help_lists_the_axes_of_every_dataset(capsys):
    with pytest.raises(SystemExit):
        main(["query", "--help"])
    said = capsys.readouterr().out
    for name, entry in DATASETS.items():
        if entry.selectors:
            axes = " ".join("--" + axis.replace("_", "-") for axis in entry.selectors)
            assert f"{name}: {axes}\n" in said


def test_help_lists_the_axes_that_the_option_axes_lists(run, tmp_path_factory):
    """Of every dataset of the smoke studies, which have all but one."""
    folder = str(smoke_results(tmp_path_factory))
    listed = {}
    for study in ("paper", "sliders"):
        where = ["--results", folder, "--study", study]
        datasets = json.loads(run("query", *where, "--json")[1])["datasets"]
        for name in datasets.keys() & DATASETS.keys():
            listed[name] = list(json.loads(run("query", name, *where, "--axes", "--json")[1]))
    assert len(listed) > 8
    for name, axes in listed.items():
        assert axes == sorted("--" + axis.replace("_", "-") for axis in DATASETS[name].selectors)


@pytest.mark.parametrize(
    ("folder", "said"),
    [
        (
            "nowhere",
            "nowhere: no such folder; name the folder of the results, or build them with make, or with "
            "planar-pushing run STUDY.yaml",
        ),
        (
            "src",
            "src: holds no folder data; name the folder of the results, or build them with make, or with "
            "planar-pushing run STUDY.yaml",
        ),
    ],
)
def test_a_wrong_folder_is_named(refused, folder, said):
    refused(["query", "motion_cones", "--results", folder], said)


def test_a_dataset_that_is_not_built(refused, results):
    refused(
        ["query", "limit_curves", "--results", results],
        f"{results}/data/limit_curves.nc: no such dataset; build it with planar-pushing run, from a study "
        "that gives effects, rod_length, rod_angle, force_angle; make builds it for the study paper",
    )


@pytest.fixture
def studies(results, tmp_path):
    """Results of the paper's study without contact modes, and of two other studies, one with them."""
    folder = tmp_path / "results"
    shutil.copytree(results, folder)
    shutil.copytree(results, folder / "studies/mine")
    (folder / "studies/mine/data/simulations").mkdir()
    shutil.copy(folder / "data/motion_cones.nc", folder / "studies/mine/data/simulations/push.nc")
    (folder / "data/contact_modes.nc").unlink()
    (folder / "studies/empty/data").mkdir(parents=True)
    return folder


@pytest.mark.parametrize(("arguments", "file", "study"), [
    (["contact_modes", "--contact", "coulomb_2"], "data/contact_modes.nc", "mine"),
    (["simulations/push"], "data/simulations/push.nc", "mine"),
    (["contact_modes", "--study", "empty"], "studies/empty/data/contact_modes.nc", "mine"),
    (["motion_cones", "--study", "empty"], "studies/empty/data/motion_cones.nc", "paper, mine"),
])  # fmt: skip
def test_a_dataset_of_another_study_is_built(refused, studies, arguments, file, study):
    noun, first = ("studies", "paper") if "," in study else ("study", study)
    refused(
        ["query", *arguments, "--results", str(studies)],
        f"{studies}/{file}: no such dataset; built for the {noun} {study}: give --study {first}, or "
        f"study='{first}' in Python\n",
    )


def test_a_dataset_is_built_though_the_papers_study_is_not(refused, studies):
    shutil.rmtree(studies / "data")
    refused(
        ["query", "motion_cones", "--results", str(studies)],
        f"{studies}/data/motion_cones.nc: no such dataset; built for the study mine: give --study mine",
    )


def test_datasets_of_another_study_are_listed_with_it(run, studies):
    _, out, _ = run("query", "--results", str(studies))
    remedy = "built for the study mine: give --study mine, or study='mine' in Python"
    assert f"  contact_modes, simulations/NAME: {remedy}\n" in out
    assert "  limit_curves: build it with planar-pushing run, from a study that " in out


def test_without_a_name_the_datasets_are_listed(run, results):
    code, out, _ = run("query", "--results", results)
    lines = out.splitlines()
    assert code == 0
    assert lines[:3] == [
        "motion_cones   friction cones, and the motion cones to which they map",
        "contact_modes  consistent solutions for each motion of the pusher: none, one or several",
        "not built here:",
    ]
    assert lines[-1].startswith(
        "  simulations/NAME: build it with planar-pushing run, from a study that "
    )
    assert any(
        "effects, hard_cases: build it with make, in the project's folder" in each for each in lines
    )
    code, out, _ = run("query", "--results", results, "--json")
    listed = json.loads(out)
    assert list(listed["datasets"]) == ["motion_cones", "contact_modes"]
    assert "limit_curves" in listed["not_built"]
    assert listed["studies"] == []


def test_groups_files_and_studies_are_listed(run, results, tmp_path):
    data = tmp_path / "results/studies/mine/data"
    shutil.copytree(results, data.parent)
    grouped = {"figure_02": xr.Dataset(), "figure_03": xr.Dataset()}
    write_dataset({"/": xr.Dataset(attrs={"title": "Scenes"}), **grouped}, data / "scenes.nc")
    (data / "simulations").mkdir()
    (data / "simulations/push.nc").write_bytes(b"no data")
    _, out, _ = run("query", "--results", str(tmp_path / "results"))
    assert out.splitlines()[0].endswith("results: holds no datasets of the paper's study")
    assert out.splitlines()[-1] == "other studies, for --study: mine"
    _, out, _ = run("query", "--results", str(tmp_path / "results"), "--study", "mine")
    listed = dict(line.split(maxsplit=1) for line in out.splitlines()[:5])
    assert listed["scenes/figure_02"] == listed["scenes/figure_03"] == "scenes"
    assert listed["simulations/push"].endswith(
        "is not a netCDF4 file; give a dataset, or rebuild a damaged one"
    )
    assert "scenes/NAME" not in out


def test_query_of_another_study(run, results, tmp_path):
    folder = tmp_path / "results/studies/mine"
    shutil.copytree(results, folder)
    asked = ["--rod-length", "2", "--json"]
    ours = run("query", "motion_cones", "--results", results, *asked)
    theirs = ["--results", str(tmp_path / "results"), "--study", "mine"]
    assert run("query", "motion_cones", *theirs, *asked) == ours


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["query", "motion_cones", "--rod-length=2", "--rod-length", "3"],
         "query: '--rod-length=2 --rod-length 3' given; allowed: pairs"),
        (["query", "cones"],
         "name: 'cones' given; allowed: limit_curves"),
        (["query", "motion_cone"],
         "name: 'motion_cone' given; allowed: limit_curves, curves, motion_cones"),
        (["query", "motion_cones", "--rod-lenght", "2"],
         "option: '--rod-lenght' given; allowed: --effects, --friction-angle, --friction-coefficient, "
         "--rod-angle, --rod-length, --help, --json, --axes, --results, --study; did you mean "
         "--rod-length?"),
        (["query", "motion_cones", "--friction", "2"],
         "option: '--friction' given; allowed: --effects, --friction-angle, --friction-coefficient, "
         "--rod-angle, --rod-length, --help, --json, --axes, --results, --study; did you mean "
         "--friction-angle or --friction-coefficient?"),
        (["query", "motion_cones", "--axess"], "option: '--axess' given; "),
        (["query", "motion_cones", "--rod-length", "7"],
         "rod_length: '7' given; allowed: 0, 1, 2, 5; choose a value"),
        (["query", "motion_cones", "--rod-length", "long"],
         "rod_length: 'long' given; allowed: a number, or inf"),
        (["query", "motion_cones", "--rod-length"],
         "query: '--rod-length' given; allowed: pairs"),
    ],
)  # fmt: skip
def test_wrong_input(refused, results, arguments, said):
    refused([*arguments[:2], "--results", results, *arguments[2:]], said)


@pytest.mark.parametrize(("words", "said"), [
    (["--bound-end", "nearer"],
     "center_regions; type for example planar-pushing query center_regions --bound-end nearer"),
    (["--rod-length", "2"],
     "limit_curves, curves, motion_cones, contact_modes, mode_maps, acceleration_centers, center_regions, "
     "support_cones, support_modes, support_rods; type for example planar-pushing query limit_curves "
     "--rod-length 2"),
    (["--rod-length=2", "--friction-angle", "45"],
     "motion_cones, contact_modes, mode_maps, support_cones, support_modes; type for example "
     "planar-pushing query motion_cones --rod-length=2 --friction-angle 45"),
    (["--rod-length"], "limit_curves, curves, motion_cones, "),
    (["--north", "-2"], "limit_curves, "),
], ids=str)  # fmt: skip
def test_axes_without_a_dataset(refused, results, words, said):
    refused(["query", *words, "--results", results], f"dataset: missing; allowed: {said}")


def test_the_dataset_may_follow_its_axes(run, results):
    axes = ["--rod-length", "2", "--friction-coefficient=2"]
    said = run("query", "motion_cones", *axes, "--results", results)
    assert said[0] == 0
    assert run("query", *axes, "motion_cones", "--results", results) == said
