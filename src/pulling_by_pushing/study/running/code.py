"""Digests of the code that a workflow job runs; a change of the code makes the job's results outdated.

Snakemake tracks a script but not its imports. The digest of a job covers the modules that it names and all
modules of this project that they import, directly or not, with the data files beside them. Comments,
docstrings and layout do not count.
"""

from __future__ import annotations

import ast
import hashlib
import json
from collections.abc import Iterable, Iterator
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from planar_pushing.terms.replacing import replacing

PAPER = "pulling_by_pushing"
#: The packages whose modules count, and their folders.
ROOTS = {
    name: Path(find_spec(name).submodule_search_locations[0])  # type: ignore[union-attr, index]
    for name in (PAPER, "planar_pushing")
}
#: Package that imports its modules by name.
CORE = "planar_pushing.core"
#: Digests and imports of unchanged files, kept from one run to the next.
KEPT = Path(".snakemake/code.json")


@cache
def code_of(*modules: str) -> str:
    """Digest of modules of `pulling_by_pushing`, such as "study.build", and of all that they import."""
    reached: set[str] = set()
    ahead = [f"{PAPER}.{name}" for name in modules]
    while ahead:
        name = ahead.pop()
        if name not in reached:
            reached.add(name)
            ahead += _facts()(name)["imports"]
    files = {_path(name) for name in reached} | {
        file for name in reached for file in _data_files(_path(name).parent)
    }
    whole = hashlib.sha256()
    for file in sorted(files):
        whole.update(f"{file.name}\0{_facts().digest(file)}\0".encode())
    _facts().keep()
    return whole.hexdigest()


def _path(name: str) -> Path:
    """File of a module or a package."""
    root, *parts = name.split(".")
    place = ROOTS[root].joinpath(*parts)
    return place / "__init__.py" if place.is_dir() else place.with_suffix(".py")


def _data_files(folder: Path) -> Iterator[Path]:
    for file in folder.iterdir():
        if file.is_file() and file.suffix in (".yaml", ".mplstyle", ".json", ".csv"):
            yield file


class Facts:
    """Digest and imports of each file, read again only if the file has changed."""

    def __init__(self) -> None:
        try:
            self.known: dict[str, Any] = json.loads(KEPT.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            self.known = {}
        self.changed = False

    def __call__(self, name: str) -> dict[str, Any]:
        return self._of(_path(name), name)

    def digest(self, file: Path) -> str:
        return str(self._of(file, "")["digest"])

    def _of(self, file: Path, name: str) -> dict[str, Any]:
        state = file.stat()
        stamp = [state.st_mtime_ns, state.st_size]
        entry = self.known.get(str(file))
        if entry is None or entry["stamp"] != stamp:
            entry = {"stamp": stamp} | _read(file, name)
            self.known[str(file)], self.changed = entry, True
        return dict(entry)

    def keep(self) -> None:
        """Store what was read; a folder that cannot be written costs only time."""
        if self.changed and KEPT.parent.is_dir():
            with replacing(KEPT) as temporary:
                temporary.write_text(json.dumps(self.known), encoding="utf-8")
            self.changed = False


@cache
def _facts() -> Facts:
    return Facts()


def _read(file: Path, name: str) -> dict[str, Any]:
    content = file.read_bytes()
    if file.suffix != ".py":
        return {"digest": hashlib.sha256(content).hexdigest(), "imports": []}
    tree = _Plain().visit(ast.parse(content))
    text = ast.dump(tree)
    return {
        "digest": hashlib.sha256(text.encode()).hexdigest(),
        "imports": sorted(set(_imports(tree)) - {name}),
    }


class _Plain(ast.NodeTransformer):
    """Removes docstrings, and imports that serve only the types."""

    def visit_Expr(self, node: ast.Expr) -> ast.Expr | None:
        return None if isinstance(node.value, ast.Constant) else node

    def visit_If(self, node: ast.If) -> Any:
        if isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING":
            return None
        return self.generic_visit(node)


def _imports(tree: ast.AST) -> Iterable[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from filter(_is_ours, (alias.name for alias in node.names))
        elif isinstance(node, ast.ImportFrom) and node.module and _is_ours(node.module):
            yield node.module
            if node.module == CORE:
                yield from (f"{CORE}.{path.stem}" for path in _path(CORE).parent.glob("[!_]*.py"))
            yield from filter(_is_ours, (f"{node.module}.{alias.name}" for alias in node.names))


def _is_ours(name: str) -> bool:
    """Whether a name is that of a module or a package of this project."""
    return name.split(".")[0] in ROOTS and _path(name).is_file()
