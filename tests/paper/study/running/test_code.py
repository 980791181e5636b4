"""The code that a job depends on, against the imports of what it calls."""

import shutil

import grimp
import pytest

from pulling_by_pushing.figures.figure import figure_names
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.running import code

GRAPH = grimp.build_graph("planar_pushing", cache_dir=None)
#: What each kind of job calls, and the members of families among it.
CALLS = {
    **{f"dataset {name}": ("dataset", "study.build", code.builder(name)) for name in DATASETS},
    **{
        f"figure {name}": ("figure", "figures.render", f"figures.{name}") for name in figure_names()
    },
    "simulation": ("simulation", "study.build", "study.simulations"),
    "claims": ("claims", "evidence.claims.table"),
    "hard_cases": ("hard_cases", "evidence.hard_cases.dataset"),
    "accuracy": ("costs", "evidence.costs.measure"),
    "effects": ("costs", "evidence.costs.effects"),
    "golden": ("golden", "evidence.golden.check"),
    "report": ("report", "report.jobs"),
    "manual": ("manual", "report.manual"),
}  # fmt: skip
#: Modules that call by name what a job does not run: each is followed from the job's own member.
TABLES = {
    "planar_pushing.scenes.simulate",
}


def reached(names):
    """These modules and all that they import, without what the tables of builders import."""
    found, ahead = set(), {f"planar_pushing.{name}" for name in names}
    while ahead:
        found |= ahead
        ahead = {
            each
            for name in ahead
            if name not in TABLES or name.removeprefix("planar_pushing.") in names
            for each in GRAPH.find_modules_directly_imported_by(name)
        } - found
    return found


@pytest.mark.parametrize("call", CALLS)
def test_the_digest_holds_all_that_a_job_imports(call):
    job, *names = CALLS[call]
    members = [name for name in names if name in code.MEMBERS]
    held = {
        file.relative_to(code.ROOT).with_suffix("")
        for part in (*code.PACKAGES[job], *members)
        for file in code.files(part)
    }
    for module in reached(set(names)):
        place = code.ROOT.joinpath(*module.split(".")[1:])
        file = (place / "__init__" if place.is_dir() else place).relative_to(code.ROOT)
        assert str(file) == "__init__" or file in held, module


def test_a_member_of_a_family_counts_where_it_is_named_alone(tmp_path, monkeypatch):
    shutil.copytree(code.ROOT, tmp_path / "copy", ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setattr(code, "ROOT", tmp_path / "copy")

    def digests():
        code.code_of.cache_clear()
        return {
            "cones": code.code_of("dataset", "study.datasets.motion_cones"),
            "modes": code.code_of("dataset", "study.datasets.contact_modes"),
            "figure 5": code.code_of("figure", "figures.figure_05"),
            "figure 6": code.code_of("figure", "figures.figure_06"),
            "claims": code.code_of("claims"),
        }

    def changed(file):
        before = digests()
        path = code.ROOT / file
        path.write_text(path.read_text(encoding="utf-8") + "\n# an edit\n", encoding="utf-8")
        after = digests()
        return {name for name in before if before[name] != after[name]}

    try:
        every = set(digests())
        assert changed("figures/figure_05.py") == {"figure 5"}
        assert changed("study/datasets/motion_cones.py") == {"cones"}
        assert changed("study/datasets/base.py") == every
        assert changed("mechanics/cones.py") == every
        assert changed("figures/paper.mplstyle") == {"figure 5", "figure 6"}
        assert changed("figures/marks.py") == {"figure 5", "figure 6"}
        assert changed("commands/query.py") == set()
    finally:
        code.code_of.cache_clear()
