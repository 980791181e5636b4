"""The data dictionary covers every file that is written, and every one is opened by its name."""

from pathlib import Path

import pytest

import planar_pushing as pp
from planar_pushing.scenes.files import load_scene_file
from planar_pushing.terms.netcdf import write_dataset
from pulling_by_pushing.evidence.costs.effects import effects
from pulling_by_pushing.evidence.costs.measure import accuracy, accuracy_time
from pulling_by_pushing.evidence.hard_cases.dataset import build as hard_cases
from pulling_by_pushing.study.catalog import (
    DATASETS,
    EVIDENCE,
    SIMULATIONS,
    TABLES,
    number_label,
)
from pulling_by_pushing.study.dictionary import QUESTIONS, dictionary_text
from pulling_by_pushing.study.running.simulations import study_log
from pulling_by_pushing.study.store import read_dataset
from pulling_by_pushing.study.studies import PAPER_FILE, SLIDERS_FILE
from pulling_by_pushing.study.study_file import load_study

SMOKE = "workflow/config/smoke.yaml"


@pytest.fixture(scope="module")
def whole(results, sliders):
    """Results with a file of every kind."""
    study = load_study(SMOKE)
    log = study_log(load_scene_file(study.simulations["pulling"]))
    write_dataset(log, results / "data/simulations/pulling.nc")
    log = study_log(load_scene_file("workflow/scenes/tripod.yaml"))
    write_dataset(log, sliders / "studies/sliders/data/simulations/tripod.nc")
    write_dataset(accuracy(), results / "data/accuracy.nc")
    write_dataset(accuracy_time(), results / "data/accuracy_time.nc")
    write_dataset(effects(study), results / "data/effects.nc")
    write_dataset(hard_cases(), results / "data/hard_cases.nc")
    return results


@pytest.mark.slow
def test_data_dictionary_is_that_of_the_datasets(whole):
    stored = Path("results/README.md").read_text(encoding="utf-8")
    assert stored == dictionary_text(str(whole)), "run make dictionary"


@pytest.mark.slow
def test_every_file_is_opened_by_its_name(whole):
    own = "studies/sliders/"
    for path in whole.rglob("*.nc"):
        stem = path.relative_to(whole).with_suffix("").as_posix()
        study = "sliders" if stem.startswith(own) else None
        stem = stem.removeprefix(own)
        name = stem.removeprefix("data/")
        try:
            found = pp.open_dataset(name, whole, study=study)
        except pp.InvalidValue as error:
            parts = str(error).partition("allowed: ")[2].partition(";")[0].split(", ")
            found = pp.open_dataset(parts[0], whole, study=study)
        assert found.variables


def test_each_dataset_has_an_example_on_its_grid():
    assert set(QUESTIONS) == {*DATASETS, *EVIDENCE, SIMULATIONS}
    for name, (_, query) in QUESTIONS.items():
        asked, *words = query.split()
        assert asked.partition("/")[0] == name
        selected = dict(zip(words[::2], words[1::2], strict=True))
        study = load_study(SLIDERS_FILE if selected.pop("--study", "") == "sliders" else PAPER_FILE)
        for option, value in selected.items():
            axis = option.removeprefix("--").replace("-", "_")
            entry = DATASETS[name]
            assert axis in (entry.inner if entry.section else entry.dims)
            if entry.section:
                values = read_dataset(Path(study.golden) / f"{name}.nc")[axis].values.tolist()
            else:
                values = study.values(axis, name)
            assert value in set(map(typed, values)), query


def typed(value):
    """A value of an axis as it is typed."""
    return value if isinstance(value, str) else number_label(value)


def test_the_dictionary_names_every_file():
    stored = Path("results/README.md").read_text(encoding="utf-8")
    for name in {**DATASETS, **EVIDENCE}:
        assert f"data/{name}.nc" in stored
    assert all(f"tables/{name}`" in stored for name in TABLES)
