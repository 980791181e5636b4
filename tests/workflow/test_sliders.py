"""The study of sliders in the workflow: beside the paper's, and alone."""

import pytest

from planar_pushing.study.catalog import DATASETS, SLIDERS
from planar_pushing.study.figures import FIGURES, GALLERY
from workflow.conftest import Copy, copy_project
from workflow.test_workflow import edited, jobs, outputs, targets

pytestmark = pytest.mark.slow

STUDY = "workflow/config/sliders_smoke.yaml"


@pytest.fixture(scope="module")
def sliders(tmp_path_factory):
    """A copy in which the smoke study of sliders is built."""
    copy = Copy(copy_project(tmp_path_factory.mktemp("sliders")).root, STUDY)
    copy.snakemake()
    return copy


def test_everything_is_built_into_a_folder_of_its_own(sliders):
    files = set(sliders.digests())
    assert {f"data/{name}.nc" for name in SLIDERS} | {"data/simulations/tripod.nc"} <= files
    assert {f"figures/data/{name}.nc" for name in GALLERY} <= files
    for kind in ("svg", "pdf", "png"):
        assert {f"figures/{name}.{kind}" for name in GALLERY} <= files
    assert not any(DATASETS.keys() & {path.stem for path in sliders.results.rglob("*.nc")})
    assert [path.name for path in (sliders.root / "results").iterdir()] == ["studies"]
    assert "Nothing to be done" in sliders.snakemake("--dry-run")


def test_every_output_is_a_target(sliders):
    assert outputs(sliders) == targets(sliders)


@pytest.mark.parametrize(
    ("module", "stale"),
    [
        ("figures/sliders/figure_17.py", {"sliders_figure": 1}),
        ("study/datasets/sliders/support_modes.py", {"sliders_dataset": 1}),
        ("study/datasets/sliders/supports.py", {"sliders_dataset": 1, "sliders_figure": 4}),
        ("simulation/pusher.py", {"sliders_simulation": 1, "sliders_figure": 1}),
    ],
)
def test_only_what_depends_on_a_module_reruns(sliders, module, stale):
    with edited(sliders.root / "src/planar_pushing" / module):
        assert jobs(sliders.snakemake("--dry-run")) == stale | {"all": 1}


def test_both_studies_are_built_and_nothing_twice(fresh):
    # Without the golden data, which the copy lacks, there is no verdict and no report.
    for name, golden in (("paper", "tests/golden"), ("sliders", "tests/golden/sliders")):
        file = fresh.root / f"workflow/config/{name}.yaml"
        text = file.read_text(encoding="utf-8").replace(f"golden: ../../{golden}\n", "")
        file.write_text(text, encoding="utf-8")
    alone = jobs(fresh.dry("--config", "study=workflow/config/sliders.yaml"))
    assert alone == {"sliders_dataset": 3, "sliders_simulation": 1, "sliders_figure": 5, "all": 1}
    both = jobs(fresh.dry())
    assert alone.items() <= both.items()
    assert both["dataset"] == len(DATASETS)
    assert both["figure"] == len(FIGURES)
    paper = jobs(fresh.dry("--config", "study=workflow/config/paper.yaml"))
    assert not any(name.startswith("sliders") for name in paper)
