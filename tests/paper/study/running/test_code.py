"""Digests of the code that a job runs, against the imports that another tool finds, and after edits."""

import json
import re
import shutil
from pathlib import Path
from pkgutil import resolve_name

import grimp
import pytest

from pulling_by_pushing.figures.figure import figure_names, module_name
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.running import code

RULES = [Path("Snakefile"), *sorted(Path("workflow/rules").glob("*.smk"))]
#: Functions that the rules call.
CALLS = sorted({call for file in RULES for call in re.findall(r'"([\w.]+:\w+)"', file.read_text())})
#: Modules that jobs name: those of the calls, and the members of families that these import by name.
NAMED = [
    *{call.partition(":")[0] for call in CALLS},
    *(f"study.datasets.{entry.module}" for entry in DATASETS.values()),
    *(f"figures.{module_name(name)}" for name in figure_names()),
]


@pytest.fixture(autouse=True, scope="module")
def kept(tmp_path_factory):
    """A store for all tests, so that files are read once."""
    before, code.CACHE = code.CACHE, tmp_path_factory.mktemp("kept") / "code.json"
    yield code.CACHE
    code.CACHE = before
    code.forget_facts()


@pytest.fixture
def cache(kept, tmp_path, monkeypatch):
    """A store of one test, filled like the other."""
    digests()
    monkeypatch.setattr(code, "CACHE", Path(shutil.copy(kept, tmp_path / "code.json")))
    return code.CACHE


@pytest.mark.parametrize("call", CALLS)
def test_a_rule_calls_a_function_of_its_module(call):
    function = resolve_name(f"pulling_by_pushing.{call}")
    assert function.__module__ == f"pulling_by_pushing.{call.partition(':')[0]}"


def test_the_digest_covers_all_imports():
    graph = grimp.build_graph(*code.ROOTS, cache_dir=None, exclude_type_checking_imports=True)
    for module in {f"pulling_by_pushing.{name}" for name in NAMED}:
        reached = code.closure([module])
        assert graph.find_upstream_modules(module) <= reached
        assert not any(".commands" in name for name in reached)


@pytest.fixture(scope="module")
def copy(tmp_path_factory):
    """Folder with copies of both packages, which replace the originals."""
    folder, before = tmp_path_factory.mktemp("copy"), code.ROOTS
    code.ROOTS = {name: folder / name for name in before}
    for name, root in before.items():
        hidden = shutil.ignore_patterns("__pycache__", "*.so")
        shutil.copytree(root, code.ROOTS[name], ignore=hidden)
    yield folder
    code.ROOTS = before


#: Jobs by the modules that they name.
JOBS = {
    "cones": ("study.running.build", "study.datasets.motion_cones"),
    "modes": ("study.running.build", "study.datasets.contact_modes"),
    "simulations": ("study.running.simulations",),
    "figure 5": ("figures.render", "figures.paper.figure_05"),
    "figure 12": ("figures.render", "figures.paper.figure_12"),
    "claims": ("evidence.claims.table",),
    "passed": ("report.closing",),
}
COMPUTED, DRAWN = {"cones", "modes", "simulations"}, {"figure 5", "figure 12"}


#: A job with few modules, which are read in no time.
SMALL = ("passed",)


def digests(names=JOBS):
    code.forget_facts()
    found = {name: code.code_of(*JOBS[name]) for name in names}
    code.keep_facts()
    return found


@pytest.mark.parametrize(
    ("file", "text", "stale"),
    [
        ("pulling_by_pushing/study/datasets/motion_cones.py", "# a comment\n", set()),
        ("pulling_by_pushing/study/datasets/motion_cones.py", "VALUE = 1\n", {"cones"}),
        ("pulling_by_pushing/figures/paper/figure_05.py", "VALUE = 1\n", {"figure 5"}),
        ("pulling_by_pushing/figures/render.py", "VALUE = 1\n", DRAWN),
        ("pulling_by_pushing/study/running/build.py", "VALUE = 1\n", COMPUTED),
        ("pulling_by_pushing/commands/query.py", "VALUE = 1\n", set()),
        ("planar_pushing/drawing/canvas/paper.mplstyle", "font.size: 20\n", DRAWN),
        ("planar_pushing/simulation/pusher.py", "VALUE = 1\n", {"simulations"}),
        ("planar_pushing/terms/errors.py", "VALUE = 1\n", set(JOBS)),
        ("planar_pushing/terms/errors.py", '"""A docstring behind the code."""\n', set()),
    ],
)
def test_a_job_depends_on_what_it_imports(copy, file, text, stale):
    path, before = copy / file, digests()
    original = path.read_text(encoding="utf-8")
    path.write_text(original + text, encoding="utf-8")
    after = digests()
    path.write_text(original, encoding="utf-8")
    assert {name for name in JOBS if before[name] != after[name]} == stale
    assert digests() == before


def test_docstrings_layout_and_imports_for_types_do_not_count(tmp_path):
    one, other = tmp_path / "one.py", tmp_path / "other.py"
    one.write_text('"""A module."""\n\n\ndef f(x):\n    """Return x."""\n    return (x, 1)\n')
    other.write_text(
        "from typing import TYPE_CHECKING\n\nif TYPE_CHECKING:\n    import planar_pushing.commands\n"
        "def f(x):\n    return (\n        x,\n        1,\n    )  # a pair\n"
    )
    with one.open("a") as stream:
        stream.write("\n\nclass A:\n    '''Nothing.'''\n\n    value = 1\n")
    with other.open("a") as stream:
        stream.write("class A:\n    value = 1\n")
    text = one.read_text()
    one.write_text(f"from typing import TYPE_CHECKING\n{text}")
    facts = [code._facts(file) for file in (one, other)]
    assert facts[0]["digest"] == facts[1]["digest"]
    assert facts[1]["imports"] == []


def test_digests_are_kept_and_files_are_read_once(cache, monkeypatch):
    first = digests()
    assert cache.is_file()
    monkeypatch.setattr(code, "_read", lambda file: pytest.fail(f"{file} is read again"))
    assert digests() == first


DAMAGED = ["", "[]", "null", '{"files": 3}', '{"format": [0, 3, 9], "files": {}, "values": {}}']


@pytest.mark.parametrize("text", DAMAGED)
def test_a_store_that_cannot_be_read_is_replaced(cache, text):
    first = digests(SMALL)
    cache.write_text(text)
    assert digests(SMALL) == first
    assert json.loads(cache.read_text())["format"] == code.FORMAT


def test_a_folder_that_cannot_be_written_costs_only_time(cache, tmp_path, monkeypatch):
    first = digests(SMALL)
    monkeypatch.setattr(code, "CACHE", tmp_path / "absent/code.json")
    assert digests(SMALL) == first
    assert not (tmp_path / "absent").exists()


def test_a_value_is_computed_anew_for_other_code(cache):
    values = iter([{"a": [1]}, {"a": [2]}])

    def value(digest):
        kept = code.value_of_code("name", digest, lambda: next(values))
        code.keep_facts()
        code.forget_facts()
        return kept

    assert [value("x"), value("x"), value("y"), value("y")] == [
        {"a": [1]}, {"a": [1]}, {"a": [2]}, {"a": [2]},
    ]  # fmt: skip
