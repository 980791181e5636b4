"""The study of sliders in the workflow: beside the paper's, and alone."""

import pytest
from workflow.conftest import Copy, copy_project
from workflow.test_workflow import CODE, edited, jobs, outputs, targets

from pulling_by_pushing.figures.studies import OURS, SECTIONS
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.study_file import load_study

pytestmark = pytest.mark.slow

STUDY = "workflow/config/sliders_smoke.yaml"
FIGURES = "figures_any_slider_sliders_smoke"
GALLERY = load_study(STUDY).figures
OF_SUPPORTS = [name for name, entry in DATASETS.items() if "support" in entry.dims]


@pytest.fixture(scope="module")
def sliders(tmp_path_factory):
    """A copy in which the smoke study of sliders is built."""
    copy = Copy(copy_project(tmp_path_factory.mktemp("sliders")).root, STUDY)
    copy.snakemake()
    return copy


def test_everything_is_built_into_a_folder_of_its_own(sliders):
    files = set(sliders.digests())
    assert {f"data/{name}.nc" for name in OF_SUPPORTS} | {"data/simulations/tripod.nc"} <= files
    for kind in ("svg", "pdf", "png"):
        assert {f"figures/{name}.{kind}" for name in GALLERY} <= files
    others = DATASETS.keys() - set(OF_SUPPORTS)
    assert not others & {path.stem for path in sliders.results.rglob("*.nc")}
    assert [path.name for path in (sliders.root / "results").iterdir()] == ["studies"]
    assert "Nothing to be done" in sliders.snakemake("--dry-run")


def test_every_output_is_a_target(sliders):
    assert outputs(sliders) == targets(sliders)


@pytest.mark.parametrize(
    ("module", "stale"),
    [
        ("pulling_by_pushing/figures/sliders/friction_for_pulling.py", {FIGURES: 1}),
        ("pulling_by_pushing/study/datasets/supports.py", {"supports": 1, FIGURES: 1}),
        ("planar_pushing/simulation/pusher.py", {"simulations_sliders_smoke": 1, FIGURES: 1}),
    ],
)
def test_only_what_depends_on_a_module_reruns(sliders, module, stale):
    with edited(sliders.root / "src" / module, *CODE):
        assert jobs(sliders.snakemake("--dry-run")) == stale | {"all": 1}


def test_both_studies_are_built_and_nothing_twice(fresh):
    # Without the golden data, which the copy lacks, there is no verdict and no report.
    for name, golden in (("paper", "tests/golden"), ("sliders", "tests/golden/sliders")):
        file = fresh.root / f"workflow/config/{name}.yaml"
        text = file.read_text(encoding="utf-8").replace(f"golden: ../../{golden}\n", "")
        file.write_text(text, encoding="utf-8")
    alone = jobs(fresh.dry("--config", "study=workflow/config/sliders.yaml"))
    others = {"simulations_sliders": 1, "figures_any_slider_sliders": 1, "all": 1}
    assert alone == dict.fromkeys(OF_SUPPORTS, 1) | others
    both = jobs(fresh.dry())
    assert DATASETS.keys() <= both.keys()
    for section, names in SECTIONS.items():
        study = "sliders" if section == "any_slider" else "paper"
        drawn = both.get(f"figures_{section}_{study}", 0)
        assert drawn == (not set(names) <= set(OURS)), section
    assert jobs(fresh.dry("--config", "study=workflow/config/paper.yaml")) == both
