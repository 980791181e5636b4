"""A copy of the project whose core has switches: a number, given as it runs, chooses the change.

An expression with a change becomes ``(changed if is_mutant(7) else original)``, in the plain source and in
the compiled library alike. The library is compiled once.
"""

from __future__ import annotations

import ast
import copy
import json
import runpy
import shutil
import sys
import tempfile
from pathlib import Path
from typing import Any

from .changes import Change, changes_of, select_changes

PROJECT = Path(__file__).resolve().parents[2]
COPIED = ("src", "tests", "joiner", "workflow", "pyproject.toml", "Snakefile")
LIST, SWITCHED = "changes.json", "numbers.py"

#: What the joiner translates, and what takes its place in C and in plain Python.
TRANSLATED = '''

def is_mutant(number: int) -> bool:
    """Whether a change is chosen."""
    return number < 0
'''
PLAIN = '''

MUTANT, REACHED = [0], set()


def is_mutant(number: int) -> bool:
    """Whether a change is chosen."""
    REACHED.add(number)
    return number == MUTANT[0]
'''
COMPILED = """
cdef long mutant_ = 0
cdef char reached_[{size}]
memset(reached_, 0, {size})

cdef bint is_mutant(long number) noexcept nogil:
    reached_[number] = 1
    return number == mutant_
"""
CHOICE = """
def choose(long number):
    global mutant_
    mutant_ = number

def take_reached():
    numbers = [k for k in range({size}) if reached_[k]]
    memset(reached_, 0, {size})
    return numbers
"""


def build_mutants(folder: Path, seed: int, count: int) -> list[dict[str, Any]]:
    """Copy the project into a folder with switches for the changes of its core, and compile it.

    Returns
    -------
    list of dict
        The changes, as the file ``changes.json`` of the folder has them.
    """
    (folder / LIST).write_text("[]", encoding="utf-8")  # marks the folder as one of such copies
    _copy(folder, COPIED)
    (folder / "baseline.jsonl").unlink(missing_ok=True)  # the record of tests without a change
    core = folder / "src/planar_pushing/core"
    trees = {
        path.relative_to(core): ast.parse(path.read_text(encoding="utf-8"))
        for path in sorted(core.rglob("[!_]*.py"))
    }
    changes = select_changes(changes_of(trees), seed, count)
    for path in {change.path for change in changes}:
        tree = _Switches([each for each in changes if each.path == path]).visit(trees[path])
        if path.name != SWITCHED:
            tree.body.insert(_first_import(tree), _import_of_switch())
        (core / path).write_text(ast.unparse(ast.fix_missing_locations(tree)), encoding="utf-8")
    _compile(core, len(changes) + 1)
    known = [
        {part: str(getattr(each, part)) for part in ("path", "function", "kind", "old", "new")}
        | {"number": each.number, "line": each.line}
        for each in changes
    ]
    (folder / LIST).write_text(json.dumps(known, indent=1), encoding="utf-8")
    return known


def is_free(folder: Path) -> bool:
    """Whether nothing but a copy of the project is lost if one is made in a folder."""
    return not folder.exists() or (folder / LIST).is_file() or not any(folder.iterdir())


def copy_tests(folder: Path) -> None:
    """Copy the tests into a folder whose library is kept."""
    _copy(folder, ("tests",))


def _copy(folder: Path, names: tuple[str, ...]) -> None:
    """Copy parts of the project into a folder."""
    ignored = shutil.ignore_patterns("__pycache__", "_compiled.*", "._compiled.*")
    for name in names:
        source, target = PROJECT / name, folder / name
        if target.is_dir():
            shutil.rmtree(target)
        if source.is_dir():
            shutil.copytree(source, target, ignore=ignored)
        else:
            shutil.copy(source, target)


class _Switches(ast.NodeTransformer):
    """Put the switches of the changes into the tree of a module."""

    def __init__(self, changes: list[Change]) -> None:
        self.changes: dict[int, list[Change]] = {}
        for change in changes:
            self.changes.setdefault(id(change.node), []).append(change)

    def visit(self, node: ast.AST) -> Any:
        """A node whose parts have their switches, behind its own switches."""
        chosen = self.changes.get(id(node), [])
        new = self.generic_visit(node)
        for change in chosen:
            number = ast.Constant(change.number)
            test = ast.Call(ast.Name("is_mutant", ast.Load()), [number], [])
            new = ast.IfExp(test, copy.deepcopy(change.changed), new)
        return new


def _first_import(tree: ast.Module) -> int:
    """Where the imports of the project begin, after that of annotations."""
    return 1 + max(
        k for k, node in enumerate(tree.body)
        if isinstance(node, ast.ImportFrom) and node.module == "__future__"
    )  # fmt: skip


def _import_of_switch() -> ast.stmt:
    return ast.ImportFrom("planar_pushing.core.numbers", [ast.alias("is_mutant")], 0)


def _compile(core: Path, size: int) -> None:
    """Compile a core with switches, beside its modules."""
    sys.path.insert(0, str(PROJECT))
    from joiner import compiler, hook, join, module

    numbers = core / SWITCHED
    text = numbers.read_text(encoding="utf-8")
    numbers.write_text(text + TRANSLATED, encoding="utf-8")
    joined = join(core)
    head, body = joined.source.split("cdef bint is_mutant(long number) noexcept nogil:\n", 1)
    _, rest = body.split("\n", 1)
    source = COMPILED.format(size=size) + head + rest + CHOICE.format(size=size)
    numbers.write_text(text + PLAIN, encoding="utf-8")
    digest = runpy.run_path(str(core / "__init__.py"))["digest"](sorted(core.rglob("[!_]*.py")))
    marks = module.MARKS.format(f"sources {digest}", "recipe mutants")
    with tempfile.TemporaryDirectory() as name:
        text = module.text_of(joined._replace(source=source)) + marks
        library = compiler.compile_library(text, Path(name), core / "__init__.py")
        shutil.copy(library, core / hook.TARGET)
